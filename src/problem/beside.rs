//! What lies beside a pierce group: contours for which the group may be left, so that they bridge two of its nodes (Dewil et
//! al., 2014, figure 8).

use crate::geometry::{Aabb, BoxIndex, DVec2};
use crate::machine::Profile;
use crate::order::{real, sort_by};
use crate::sheet::{PierceGroup, Sheet};

/// Most contours beside a group: the nearest.
const MOST: usize = 12;
/// Most places where a closed one is entered: those nearest to the nodes of the group.
const PLACES: usize = 6;
/// Most nodes of a group for which anything is looked for: more take longer than they gain.
const MOST_NODES: usize = 256;
/// How far away a contour may lie, in sizes of the group: what lies farther away is no shorter way between its nodes.
const REACH: f64 = 0.5;
/// Most elements in all groups of a sheet beside which anything is looked for: some tenths of a second.
const ELEMENTS: usize = 2000;

/// A contour beside a group: the ways to cut it, each as where the head arrives and where it leaves.
pub type Beside = Vec<[DVec2; 2]>;

/// The contours beside each group of a sheet, the nearest first; none where groups are cut in one go.
pub(super) fn beside(sheet: &Sheet, machine: &Profile, groups: &[PierceGroup]) -> Vec<Vec<Beside>> {
    if groups.is_empty() || in_one_go(sheet, machine) {
        return vec![Vec::new(); groups.len()];
    }
    let neighbourhood = Neighbourhood::new(sheet, groups);
    let mut elements = 0;
    let of = |group: &PierceGroup| {
        elements += group.elements.len();
        if elements <= ELEMENTS { neighbourhood.of(group) } else { Vec::new() }
    };
    groups.iter().map(of).collect()
}

/// Whether groups are never left for other items.
pub(super) fn in_one_go(sheet: &Sheet, machine: &Profile) -> bool {
    sheet.keeps_together() || sheet.asks_for_leads(machine)
}

struct Neighbourhood<'s> {
    sheet: &'s Sheet,
    boxes: BoxIndex,
    /// By contour: it is cut with a group.
    grouped: Vec<bool>,
}

impl<'s> Neighbourhood<'s> {
    fn new(sheet: &'s Sheet, groups: &[PierceGroup]) -> Self {
        let mut grouped = vec![false; sheet.contours.len()];
        groups.iter().flat_map(|g| &g.contours).for_each(|&c| grouped[c as usize] = true);
        Self { sheet, boxes: BoxIndex::new(sheet.contours.iter().map(|c| c.path.bounds())), grouped }
    }

    /// The contours beside a group that are cut by themselves.
    fn of(&self, group: &PierceGroup) -> Vec<Beside> {
        if group.nodes.len() > MOST_NODES {
            return Vec::new();
        }
        let bounds = group.nodes.iter().fold(Aabb::EMPTY, |b, &n| b.with(n));
        let around = self.boxes.query(bounds.grown(REACH * bounds.size().max_element()));
        let mut found: Vec<(f64, u32, Beside)> = Vec::new();
        for (c, id) in around.into_iter().filter_map(|c| Some((c, u32::try_from(c).ok()?))) {
            let contour = &self.sheet.contours[c];
            if self.grouped[c] || !contour.is_processed() || self.encloses(id, group) {
                continue;
            }
            let nearest = |&n: &DVec2| contour.path.nearest(n).map(|(_, p)| (p.distance(n), p));
            let mut places: Vec<(f64, DVec2)> = group.nodes.iter().filter_map(nearest).collect();
            sort_by(&mut places, |p| [real(p.0), 0, 0]);
            let Some(&(distance, _)) = places.first() else { continue };
            let ways = match (contour.path.closed, contour.path.start(), contour.path.end()) {
                (false, Some(start), Some(end)) => vec![[start, end], [end, start]],
                _ => places.iter().take(PLACES).map(|p| [p.1; 2]).collect(),
            };
            found.push((distance, id, ways));
        }
        sort_by(&mut found, |f| [real(f.0), f.1.into(), 0]);
        found.into_iter().take(MOST).map(|f| f.2).collect()
    }

    /// Whether a contour lies around a group, so that it is cut after it.
    fn encloses(&self, contour: u32, group: &PierceGroup) -> bool {
        let up = |c: &u32| self.sheet.contours.get(*c as usize).and_then(|c| c.inside);
        let around = std::iter::successors(group.contours.first().and_then(up), up);
        around.take(self.sheet.contours.len()).any(|c| c == contour)
    }
}
