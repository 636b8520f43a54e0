//! Nesting: determines which closed cut contour lies directly around each contour.
//!
//! A contour lies inside another if the other is larger, its box contains the contour's box, and a witness, a point
//! well inside the contour, lies inside the other. A point on the contour would not do, because contours may touch. A
//! contour that crosses a larger one and lies in its box counts as inside, too: a hole that breaks through an edge is
//! cut before the edge.
//!
//! For each contour, the boxes around it are tested in order of area, smallest first ([`boxes`]), so the first that
//! contains its witness is its parent, at any depth of nesting. A contour of many elements is queried through slabs
//! ([`slabs`]), which give the elements at the height of the witness. In total this takes O(n log n) for contours whose
//! boxes do not interlock; [`MAX_FAILED_BOXES`] bounds the rest.
//!
//! Contours that cross each other do not form a tree: something may lie in both of two contours, neither of which lies
//! in the other. Everything around a contour must still be among its ancestors, or it would be cut too early. Crossing
//! contours around one contour are therefore chained by area, as an elimination tree is built (J. W. H. Liu, "The role
//! of elimination trees in sparse factorization", 1990): the smallest becomes the parent and passes the others on to be
//! its own ancestors.
//!
//! What is left of an outline that shares sides with others may lie inside a contour that is smaller than the outline. It
//! is cut before that contour all the same, so that the order is by area only where nothing else decides.

mod boxes;
mod slabs;

use super::model::Contour;
use crate::geometry::{Aabb, DVec2, Path, filled_area, interior_point, winding_number};
use crate::order::{real, sort_by};
use boxes::{Answer, BoxTree};
use slabs::Slabs;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Largest number of boxes around a contour that are tested without success before it counts as lying in none.
/// Interlocking parts overlap in a handful of boxes. A thousand C-shapes in each other are not a real sheet, but must
/// not take a thousand times the time.
const MAX_FAILED_BOXES: usize = 256;

/// A point of an open line that is nearer to an outline is on it, mm: far above the rounding of coordinates.
const ON_LINE: f64 = 1e-6;

/// Sets `inside` and `depth` of all contours. `crossing` lists pairs of contours that cross. Touching contours may
/// exceed each other's boxes by the distance that ends were moved, which is at most `slack` mm. An excluded contour
/// lies in nothing and contains nothing. Returns `false` when a search was given up.
pub(super) fn nest(contours: &mut [Contour], crossing: &[(u32, u32)], slack: f64) -> bool {
    let sizes: Vec<f64> = contours.iter().map(size).collect();
    let mut by_size: Vec<u32> = (0_u32..).take(contours.len()).collect();
    sort_by(&mut by_size, |&i| [contours[i as usize].bounds_area().into(), real(sizes[i as usize]), 0]);
    let place = places(&by_size);
    let mut around = crossed_by(contours, crossing, &place, slack);
    let mut search = Search::new(contours, &sizes, crossing, slack);
    let processed = (0_u32..).zip(&mut around).filter(|(i, _)| contours[*i as usize].is_processed());
    for (i, outer) in processed {
        search.add_around(i, outer);
    }
    let complete = search.complete;
    // What is left of an outline lies in these, so that they do not lie in the outline.
    for (rest, outer) in search.rests {
        around[outer as usize].retain(|&o| o != rest);
    }
    let order = inside_out(&mut around, &by_size, &place);
    let place = places(&order);
    for &i in &order {
        let mut outer = std::mem::take(&mut around[i as usize]);
        outer.retain(|&o| place[o as usize] > place[i as usize]);
        sort_by(&mut outer, |&o| [place[o as usize] as u64, 0, 0]);
        outer.dedup();
        if let Some((&parent, rest)) = outer.split_first() {
            contours[i as usize].inside = Some(parent);
            around[parent as usize].extend_from_slice(rest);
        } else {
            contours[i as usize].inside = None;
        }
    }
    for &i in order.iter().rev() {
        let inside = contours[i as usize].inside;
        contours[i as usize].depth = inside.map_or(0, |j| contours[j as usize].depth + 1);
    }
    complete
}

/// The place of each contour in an order.
fn places(order: &[u32]) -> Vec<usize> {
    let mut place = vec![0; order.len()];
    for (k, &i) in order.iter().enumerate() {
        place[i as usize] = k;
    }
    place
}

/// The contours in an order in which those around others come later, and otherwise by size. Where contours lie in each other
/// in a circle, the smallest comes first. `place`: the place of each contour by size.
fn inside_out(around: &mut [Vec<u32>], by_size: &[u32], place: &[usize]) -> Vec<u32> {
    // For each contour, how many inside it are still to come.
    let mut waits = vec![0_usize; by_size.len()];
    for outer in around.iter_mut() {
        sort_by(outer, |&o| [o.into(), 0, 0]);
        outer.dedup();
        outer.iter().for_each(|&o| waits[o as usize] += 1);
    }
    let free = by_size.iter().filter(|&&i| waits[i as usize] == 0);
    let mut next: BinaryHeap<Reverse<usize>> = free.map(|&i| Reverse(place[i as usize])).collect();
    let mut smallest = by_size.iter();
    let mut order = Vec::with_capacity(by_size.len());
    let mut is_taken = vec![false; by_size.len()];
    while order.len() < by_size.len() {
        // Without a free one, there is a circle.
        let free = next.pop().map(|Reverse(k)| by_size[k]);
        let Some(i) = free.or_else(|| smallest.find(|&&i| !is_taken[i as usize]).copied()) else { break };
        if std::mem::replace(&mut is_taken[i as usize], true) {
            continue;
        }
        order.push(i);
        for &o in &around[i as usize] {
            waits[o as usize] -= 1;
            if waits[o as usize] == 0 {
                next.push(Reverse(place[o as usize]));
            }
        }
    }
    order
}

/// The key by which contours are ordered so that those around others come later, mm2. It is the area; the lobes of contours
/// that cross themselves cancel (a bow tie has area 0), so that theirs is measured. The rest of a shape beside an equal but
/// slightly shifted shape may lie in that one, and never the other way round, so it counts as slightly smaller.
fn size(c: &Contour) -> f64 {
    match c.boundary() {
        Some(boundary) if c.self_crossing => filled_area(boundary),
        _ if c.outline.is_some() => c.area * (1.0 - 1e-9),
        _ => c.area,
    }
}

/// The box reduced by `slack` on every side, at most to its centre.
fn shrunk(b: Aabb, slack: f64) -> Aabb {
    let middle = b.center();
    Aabb { min: (b.min + slack).min(middle), max: (b.max - slack).max(middle) }
}

/// For each contour, the larger ones that it crosses and in whose box it lies.
fn crossed_by(contours: &[Contour], crossing: &[(u32, u32)], place: &[usize], slack: f64) -> Vec<Vec<u32>> {
    let mut out = vec![Vec::new(); contours.len()];
    for &(a, b) in crossing {
        let (inner, outer) = if place[a as usize] < place[b as usize] { (a, b) } else { (b, a) };
        let (i, o) = (&contours[inner as usize], &contours[outer as usize]);
        if o.bounds_area() && o.bounds.contains_box(&shrunk(i.bounds, slack)) {
            out[inner as usize].push(outer);
        }
    }
    out
}

/// Search for the contours around a contour.
struct Search<'c> {
    contours: &'c [Contour],
    sizes: &'c [f64],
    /// All contours that may contain others.
    all: BoxTree,
    /// Those of them that may cross or overlap another one.
    crossed: BoxTree,
    slabs: Vec<Option<Slabs>>,
    slack: f64,
    /// What is left of an outline, and a contour around it.
    rests: Vec<(u32, u32)>,
    complete: bool,
}

impl<'c> Search<'c> {
    fn new(contours: &'c [Contour], sizes: &'c [f64], crossing: &[(u32, u32)], slack: f64) -> Self {
        let mut crosses = vec![false; contours.len()];
        for &(a, b) in crossing {
            crosses[a as usize] = true;
            crosses[b as usize] = true;
        }
        let item = |(i, c): (u32, &Contour)| {
            let bounds = c.outline.as_ref().map_or(c.bounds, Path::bounds);
            c.bounds_area().then_some((bounds, sizes[i as usize], i))
        };
        let items: Vec<_> = (0_u32..).zip(contours).filter_map(item).collect();
        // Shapes that lost a side shared with another one may overlap it without crossing it.
        let shared = contours.iter().any(|c| c.outline.is_some());
        let crossed = items.iter().filter(|i| shared || crosses[i.2 as usize]).copied();
        Self {
            contours,
            sizes,
            crossed: BoxTree::new(crossed.collect()),
            all: BoxTree::new(items),
            slabs: contours.iter().map(|_| None).collect(),
            slack,
            rests: Vec::new(),
            complete: true,
        }
    }

    /// Adds the smallest contour around contour `i`, and all those around it that cross others.
    fn add_around(&mut self, i: u32, outer: &mut Vec<u32>) {
        let contours = self.contours;
        let c = &contours[i as usize];
        self.add_around_course(i, (c.boundary().unwrap_or(&c.path), self.sizes[i as usize]), outer);
        // The rest of a shape may lie inside something that the shape itself crosses, or that is smaller than the shape.
        if c.outline.is_some() {
            let before = outer.len();
            self.add_around_course(i, (&c.path, 0.0), outer);
            self.rests.extend(outer[before..].iter().map(|&o| (i, o)));
        }
    }

    /// `own`: the line of contour `i` or of its outline, and the size that contours around it exceed.
    fn add_around_course(&mut self, i: u32, (own, least): (&Path, f64), outer: &mut Vec<u32>) {
        let Self { contours, sizes, all, crossed, slabs, slack, complete, .. } = self;
        let c = &contours[i as usize];
        let (inner, witnesses) = (shrunk(own.bounds(), *slack), witnesses(own));
        let mut holds = |j: u32| {
            let other = &contours[j as usize];
            let Some(around) = other.boundary() else { return false };
            // The rest of a shape runs along the shape's outline, not inside it.
            let same_shape =
                other.outline.is_some() && other.rest_of == c.rest_of && other.operation == c.operation;
            let slabs = slabs[j as usize].get_or_insert_with(|| Slabs::new(around));
            // An open line may run along an outline, which is neither inside nor outside. The rest of a shape and the outline of
            // its neighbour were drawn beside each other.
            let is_rest = [c, other].iter().any(|c| c.rest_of.is_some() && !c.path.closed);
            let beside = if is_rest { *slack } else { ON_LINE };
            let near = |p: DVec2| slabs.between(around, [p.y - beside, p.y + beside]);
            let on_line = |p: DVec2| near(p).any(|s| s.nearest(p).1 <= beside * beside);
            let inside = |p: DVec2| winding_number(slabs.at(around, p.y), p) != 0;
            let says = |p: &DVec2| (own.closed || !on_line(*p)).then(|| if inside(*p) { 1 } else { -1 });
            let sum = |points: &[DVec2]| points.iter().filter_map(says).reduce(|a: i32, b| a + b);
            let held = || sum(&witnesses).or_else(|| sum(&more_witnesses(own))).is_some_and(|sum| sum > 0);
            // Of two outlines that lost sides, the larger one does not lie inside the smaller one, whatever is left of it.
            let is_smaller =
                c.outline.is_some() && other.outline.is_some() && sizes[j as usize] < sizes[i as usize];
            j != i && !same_shape && !is_smaller && held()
        };
        let mut left = MAX_FAILED_BOXES;
        let smallest = all.smallest_around(&inner, least, |j| {
            left -= 1;
            match (holds(j), left) {
                (true, _) => Answer::Found,
                (false, 0) => Answer::Stop,
                (false, _) => Answer::Next,
            }
        });
        *complete &= left > 0 || smallest.is_some();
        outer.extend(smallest);
        let mut left = MAX_FAILED_BOXES;
        crossed.smallest_around(&inner, least, |j| {
            left -= 1;
            if holds(j) {
                outer.push(j);
            }
            if left == 0 { Answer::Stop } else { Answer::Next }
        });
        *complete &= left > 0;
    }
}

/// Points that represent the contour: one well inside a closed contour, three on each of up to 32 elements of an open one, away
/// from ends and middles, where open contours often touch others.
fn witnesses(path: &Path) -> Vec<DVec2> {
    if path.closed
        && let Some(p) = interior_point(path)
    {
        return vec![p];
    }
    points(path, &[0.171, 0.413, 0.829])
}

/// Sixteen points of an open line or more, which decide where its witnesses are all on an outline: the line may run along that, and
/// only its beginning or a short stretch of it may lie inside.
fn more_witnesses(path: &Path) -> Vec<DVec2> {
    let each = u32::try_from(16_usize.div_ceil(path.segments.len().max(1))).map_or(2, |each| each.max(2));
    let fractions: Vec<f64> = (0..each).map(|k| f64::from(k) / f64::from(each)).collect();
    points(path, &fractions)
}

/// Points at these fractions of up to 32 elements.
fn points(path: &Path, fractions: &[f64]) -> Vec<DVec2> {
    let stride = path.segments.len().div_ceil(32).max(1);
    path.segments.iter().step_by(stride).flat_map(|s| fractions.iter().map(|&f| s.at(f))).collect()
}
