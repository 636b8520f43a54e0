//! Parts, and which of them are the same: a shop cuts 40 brackets, not 40 parts.
//!
//! Two parts are the same when they have as many holes and agree, within a thousandth, in what does not change when a part is
//! turned or mirrored: area, length, principal second moments of the outer contour; area and distance from the middle of
//! each hole; the material between each hole and the edge, and the distances between holes. Mirrored parts count as
//! the same: a flat part can be turned over.

use super::confidence::Confidence;
use super::narrow::Chords;
use super::shape::{FINE, Moments, Shape};
use super::times::Times;
use crate::order::{real, sort_by};
use crate::plan::document::Contour;
use serde::Serialize;

/// Figures this near to each other, as a share, are the same: chords of one curve cut at other places differ by less.
const SAME: f64 = 1e-3;
/// And those of at most this many mm or mm2.
const SMALL: f64 = 0.01;
/// Largest number of holes of one part whose distances from each other are compared.
const MOST: usize = 32;

/// A group of equal parts.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PartGroup {
    /// Number of parts in the group.
    pub count: u32,
    /// Area of one part without its holes.
    pub net_area: f64,
    /// Length of the outlines of one part: outer contour and holes. A side shared with another part counts for both.
    pub cut_length: f64,
    /// Number of holes in one part.
    pub holes: usize,
    /// Outer contours of the parts, by id.
    pub contours: Vec<u32>,
    /// Each part of the group, in the order of `contours`.
    pub items: Vec<PartItem>,
}

/// One part of the sheet.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PartItem {
    /// The id of its outer contour, which identifies the part.
    pub id: u32,
    /// xmin, ymin, xmax, ymax of its outline.
    pub bounds: [f64; 4],
    /// Its own seconds, with its share of the air moves. Those of all parts and `loose_times` add up to the job's.
    pub times: Times,
    /// Number of its piercings.
    pub pierces: u32,
    /// How far its figures can be relied on: the findings that lie on it.
    pub confidence: Confidence,
}

/// An outer contour with its holes, by id.
pub(super) struct Part {
    pub(super) outer: usize,
    pub(super) holes: Vec<usize>,
    /// Whether it lies in a hole of another part.
    pub(super) in_hole: bool,
}

/// The parts of what is cut, by the outer contours.
pub(super) fn parts(contours: &[Contour]) -> Vec<Part> {
    let cut = |id: usize| contours.get(id).is_some_and(Contour::bounds_area);
    // The next contour around that is cut, and how many there are; a document's circle of contours ends the count.
    let around = |id: usize| {
        let up = |id: &usize| contours.get(*id)?.inside.map(|i| i as usize);
        std::iter::successors(up(&id), up).take(contours.len()).filter(|&i| cut(i))
    };
    let mut of: Vec<Option<usize>> = vec![None; contours.len()];
    let mut parts = Vec::new();
    for id in (0..contours.len()).filter(|&id| cut(id)) {
        let depth = around(id).count();
        if depth % 2 == 0 {
            of[id] = Some(parts.len());
            parts.push(Part { outer: id, holes: Vec::new(), in_hole: depth > 0 });
        }
    }
    for id in (0..contours.len()).filter(|&id| cut(id) && of[id].is_none()) {
        if let Some(part) = around(id).next().and_then(|outer| of[outer]) {
            parts[part].holes.push(id);
        }
    }
    parts
}

/// The part of each contour: its own, or for a mark or an open cut the innermost part around it.
pub(super) fn part_of(parts: &[Part], contours: &[Contour]) -> Vec<Option<usize>> {
    let mut of: Vec<Option<usize>> = vec![None; contours.len()];
    for (k, part) in parts.iter().enumerate() {
        for &id in std::iter::once(&part.outer).chain(&part.holes) {
            of[id] = Some(k);
        }
    }
    let known = of.clone();
    for (id, part) in of.iter_mut().enumerate().filter(|(_, part)| part.is_none()) {
        let up = |id: &usize| contours.get(*id)?.inside.map(|i| i as usize);
        let mut around = std::iter::successors(up(&id), up).take(contours.len());
        *part = around.find_map(|i| known.get(i).copied().flatten());
    }
    of
}

/// What does not change when a part is turned or mirrored.
struct Features {
    outer: Moments,
    length: f64,
    /// Area and distance from the middle, the smallest first.
    holes: Vec<[f64; 2]>,
    /// Distances between the middles of holes, by the areas of the two, then the shortest first.
    between: Vec<f64>,
    /// Material between each hole and the edge, the least first.
    edges: Vec<f64>,
}

impl Features {
    fn of(part: &Part, shapes: &[Shape]) -> Self {
        let outline = &shapes[part.outer];
        let outer = outline.moments();
        let chords = Chords::of(outline);
        let edge = |&h: &usize| {
            chords.nearest(&Chords::of(&shapes[h]), f64::INFINITY).map_or(0.0, |(width, _)| width)
        };
        let mut edges: Vec<f64> = part.holes.iter().map(edge).collect();
        sort_by(&mut edges, |edge| [real(*edge), 0, 0]);
        let mut moments: Vec<Moments> = part.holes.iter().map(|&h| shapes[h].moments()).collect();
        sort_by(&mut moments, |m| [real(m.area), 0, 0]);
        // Holes of the same area are of one kind: areas that differ by rounding alone must not change the order of the distances.
        let mut kinds: Vec<Vec<Moments>> = Vec::new();
        for m in moments {
            match kinds.last_mut() {
                Some(kind) if kind.last().is_some_and(|l| near(l.area, m.area)) => kind.push(m),
                _ => kinds.push(vec![m]),
            }
        }
        let (mut holes, mut few) = (Vec::new(), Vec::new());
        for (kind, members) in kinds.iter().enumerate() {
            let mut of_kind: Vec<[f64; 2]> =
                members.iter().map(|m| [m.area, m.centroid.distance(outer.centroid)]).collect();
            sort_by(&mut of_kind, |[_, distance]| [real(*distance), 0, 0]);
            holes.extend(of_kind);
            // All of a kind or none, so that the choice does not depend on their order.
            if few.len() + members.len() <= MOST {
                few.extend(members.iter().map(|m| (kind as u64, m.centroid)));
            }
        }
        let mut pairs: Vec<([u64; 2], f64)> = Vec::new();
        for (k, (kind, at)) in few.iter().enumerate() {
            pairs.extend(few[..k].iter().map(|(other, from)| ([*other, *kind], from.distance(*at))));
        }
        sort_by(&mut pairs, |&([a, b], distance)| [a, b, real(distance)]);
        let between = pairs.into_iter().map(|(_, distance)| distance).collect();
        // Of the outline: a side that is cut with another part is no less of it.
        let length = outline.chords().map(|[a, b]| a.distance(b)).sum();
        Self { outer, length, holes, between, edges }
    }

    fn same(&self, other: &Self) -> bool {
        let all = |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(&a, &b)| near(a, b));
        let [a, b] =
            [self, other].map(|f| [f.outer.area, f.length, f.outer.principal[0], f.outer.principal[1]]);
        all(&a, &b)
            && all(self.holes.as_flattened(), other.holes.as_flattened())
            && all(&self.between, &other.between)
            // Between chords, of which each may be as far from its arc.
            && self.edges.iter().zip(&other.edges).all(|(a, b)| (a - b).abs() <= SMALL + 2.0 * FINE || near(*a, *b))
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= SMALL.max(SAME * a.abs().max(b.abs()))
}

/// The parts in groups of the same, those with most area first.
pub(super) fn groups(
    parts: &[Part],
    contours: &[Contour],
    shapes: &[Shape],
    items: Vec<PartItem>,
) -> Vec<PartGroup> {
    let mut known: Vec<(Features, PartGroup)> = Vec::new();
    // By length of the outline, so that only neighbours need be compared.
    let mut order: Vec<(Features, &Part, PartItem)> =
        parts.iter().zip(items).map(|(part, item)| (Features::of(part, shapes), part, item)).collect();
    sort_by(&mut order, |(features, part, _)| [real(features.length), part.outer as u64, 0]);
    for (features, part, item) in order {
        let cut = |c: &Contour| c.outline_length() * f64::from(c.passes);
        let holes = |what: fn(&Contour) -> f64| part.holes.iter().map(|&h| what(&contours[h])).sum::<f64>();
        let cut_length = cut(&contours[part.outer]) + holes(cut);
        let near = known
            .iter_mut()
            .rev()
            .take_while(|(f, _)| features.length - f.length <= SMALL.max(SAME * features.length));
        let mut near = near.filter(|(f, _)| f.same(&features));
        if let Some((_, group)) = near.next() {
            group.count += 1;
            group.cut_length += cut_length;
            group.items.push(item);
        } else {
            let group = PartGroup {
                count: 1,
                net_area: contours[part.outer].area - holes(|c| c.area),
                cut_length,
                holes: part.holes.len(),
                contours: Vec::new(),
                items: vec![item],
            };
            known.push((features, group));
        }
    }
    let mut groups: Vec<PartGroup> = known.into_iter().map(|(_, g)| g).collect();
    for g in &mut groups {
        // The mean: equal parts differ by rounding.
        g.cut_length /= g.count as f64;
        sort_by(&mut g.items, |item| [item.id.into(), 0, 0]);
        g.contours = g.items.iter().map(|item| item.id).collect();
    }
    sort_by(&mut groups, |g| [!real(g.net_area), g.contours[0].into(), 0]);
    groups
}
