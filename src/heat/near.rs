//! Whether two lines come nearer to each other than a distance.

use crate::geometry::{Aabb, DVec2, Path, Segment, distance};

/// Places along each line: more settle more pairs without measuring elements, and take longer for each.
const PLACES: u32 = 16;

/// A line with places along it.
pub(super) struct Places<'p> {
    path: &'p Path,
    bounds: Aabb,
    first: DVec2,
    /// At equal steps along the line.
    places: Vec<DVec2>,
    /// No point of the line is farther from a place, mm.
    reach: f64,
}

impl<'p> Places<'p> {
    /// `None` for an empty line.
    pub(super) fn new(path: &'p Path) -> Option<Self> {
        let first = path.start()?;
        let step = path.length() / f64::from(PLACES);
        let places = (0..=PLACES).filter_map(|k| path.at((f64::from(k) * step).min(path.length()))).collect();
        Some(Self { path, bounds: path.bounds(), first, places, reach: 0.5 * step })
    }

    pub(super) fn bounds(&self) -> Aabb {
        self.bounds
    }

    pub(super) fn first(&self) -> DVec2 {
        self.first
    }

    /// Whether the lines come nearer to each other than `limit` mm.
    pub(super) fn are_near(&self, other: &Self, limit: f64) -> bool {
        let between =
            |p: &DVec2| other.places.iter().map(|q| q.distance_squared(*p)).fold(f64::INFINITY, f64::min);
        let least = self.places.iter().map(between).fold(f64::INFINITY, f64::min).sqrt();
        if least < limit {
            return true;
        }
        if least - self.reach - other.reach >= limit {
            return false;
        }
        let close = |s: &&Segment, o: &Self| s.bounds().grown(limit).overlaps(&o.bounds);
        self.path.segments.iter().filter(|s| close(s, other)).any(|s| {
            let area = s.bounds().grown(limit);
            let near = other.path.segments.iter().filter(|o| o.bounds().overlaps(&area));
            near.into_iter().any(|o| distance(s, o).0 < limit)
        })
    }
}
