//! Determines again from the geometry which contour lies inside which: by winding numbers, which are exact for arcs.

use super::tolerance::{SAME, rounding};
use crate::geometry::{Aabb, DVec2, Path, Segment, math};
use crate::order::{real, sort_by};
use crate::sheet::{Contour, Sheet};
use static_aabb2d_index::{StaticAABB2DIndex, StaticAABB2DIndexBuilder};
use std::f64::consts::TAU;

/// Number of points of a contour that are checked first: enough to find one outside of nearly every contour that does not
/// lie inside.
const SAMPLES: usize = 16;
/// Number of points that are checked of a contour of many elements when those lie inside: contours that cross each other in
/// small places only have few points outside.
const MANY_SAMPLES: usize = 512;

/// All pairs of a contour (first) and a cut contour that bounds an area around it (second), at any depth, sorted. What is left of an
/// outline whose other sides are cut with its neighbours stands for the whole outline, which counts once however many pieces are left.
///
/// A contour lies inside another if none of the sample points spread over it is outside, and at least one is inside and not
/// on the outline. So duplicates lie inside neither, and a contour that crosses an outline does not lie inside it.
/// Of two outlines that each lost sides, the larger one does not lie inside the smaller one, whatever is left of it. Sides that two
/// outlines shared were drawn beside each other, and ends of what is left were moved: what lies that near to an outline is on it.
/// Where each of two contours lies inside the other, as contours that cross themselves may, neither counts.
///
/// What lies inside a contour lies inside everything around that contour, so of thousands of rings around each other, each is
/// compared with the next one only.
pub(super) fn pairs(sheet: &Sheet) -> Vec<(u32, u32)> {
    let mut outers: Vec<Outer> = (0..)
        .zip(&sheet.contours)
        // Only the last pass cuts a contour free.
        .filter(|(_, c)| c.bounds_area() && c.next_pass.is_none())
        .filter_map(|(id, contour)| Some(Outer { id, contour, shape: Shape::new(contour.boundary()?) }))
        .collect();
    // The smallest one around a contour comes first, and tells of those around itself.
    sort_by(&mut outers, |o| [real(o.contour.area), o.id.into(), 0]);
    let Some(index) = index(&outers) else { return Vec::new() };
    let mut inners: Vec<(u32, &Contour)> =
        (0..).zip(&sheet.contours).filter(|(_, c)| c.is_processed()).collect();
    sort_by(&mut inners, |(id, c)| [!real(c.area), (*id).into(), 0]);
    // For each contour those around it, by their places in `outers`, and for each of these the last contour known to be inside.
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); sheet.contours.len()];
    let mut known_around: Vec<Option<u32>> = vec![None; outers.len()];
    for (id, contour) in inners {
        let inner = Shape::new(&contour.path);
        if inner.bounds.is_empty() {
            continue;
        }
        let may_contain = |outer: &Outer| {
            let same_shape = contour.rest_of.is_some() && contour.rest_of == outer.contour.rest_of;
            let is_larger = contour.outline.is_some()
                && outer.contour.outline.is_some()
                && contour.area > outer.contour.area;
            outer.id != id && !same_shape && !is_larger && outer.shape.has_room_for(&inner)
        };
        let Aabb { min, max } = inner.bounds;
        let mut near = index.query(min.x, min.y, max.x, max.y);
        near.retain(|k| outers.get(*k).is_some_and(may_contain));
        sort_by(&mut near, |&k| [k as u64, 0, 0]);
        near.retain(|&k| {
            let known = known_around[k] == Some(id);
            let outer = &outers[k];
            let is_rest = [contour, outer.contour].iter().any(|c| c.rest_of.is_some() && !c.path.closed);
            let same = if is_rest { sheet.joined_within.max(SAME) } else { SAME };
            if !known && lies_inside(&contour.path, outer.shape.path, same) {
                around[outer.id as usize].iter().for_each(|&o| known_around[o] = Some(id));
                return true;
            }
            known
        });
        around[id as usize] = near;
    }
    let mut pairs = Vec::with_capacity(around.iter().map(Vec::len).sum());
    for (inner, around) in (0..).zip(&mut around) {
        sort_by(around, |&k| [outers[k].id.into(), 0, 0]);
        pairs.extend(around.iter().map(|&k| (inner, outers[k].id)));
    }
    let is_odd =
        |c: u32| sheet.contours[c as usize].self_crossing || sheet.contours[c as usize].rest_of.is_some();
    let is_mutual = |&(a, b): &(u32, u32)| (is_odd(a) || is_odd(b)) && pairs.binary_search(&(b, a)).is_ok();
    let mutual: Vec<(u32, u32)> = pairs.iter().copied().filter(is_mutual).collect();
    pairs.retain(|pair| mutual.binary_search(pair).is_err());
    pairs
}

/// A path with what decides without its elements that it does not lie inside another one.
struct Shape<'a> {
    path: &'a Path,
    bounds: Aabb,
    /// Largest effect of rounding on a position on it, mm.
    rounding: f64,
}

impl<'a> Shape<'a> {
    fn new(path: &'a Path) -> Self {
        let rounding = path.segments.iter().map(rounding).fold(0.0, f64::max);
        Self { path, bounds: path.bounds(), rounding }
    }

    fn has_room_for(&self, inner: &Self) -> bool {
        self.bounds.grown(SAME + self.rounding.max(inner.rounding)).contains_box(&inner.bounds)
    }
}

/// A cut contour that bounds an area, with its outline.
struct Outer<'a> {
    id: u32,
    contour: &'a Contour,
    shape: Shape<'a>,
}

fn index(outers: &[Outer]) -> Option<StaticAABB2DIndex<f64>> {
    let mut builder = StaticAABB2DIndexBuilder::new(outers.len());
    for outer in outers {
        let b = outer.shape.bounds;
        builder.add(b.min.x, b.min.y, b.max.x, b.max.y);
    }
    builder.build().ok()
}

/// Whether sample points of a path show that it lies inside an outline. Points within `same` mm of the outline are on it.
fn lies_inside(path: &Path, outer: &Path, same: f64) -> bool {
    // Where no element of the outline comes near the path, all of the path is on one side of it.
    let bounds = path.bounds();
    if !outer.segments.iter().any(|s| s.bounds().grown(same + rounding(s)).overlaps(&bounds)) {
        return path.start().is_some_and(|start| winding(outer, start) != 0.0);
    }
    samples_inside(path, SAMPLES, outer, same)
        && (path.segments.len() <= SAMPLES / 2 || samples_inside(path, MANY_SAMPLES, outer, same))
}

/// Whether, of about `samples` points on a path, none lies outside an outline and at least one lies inside.
fn samples_inside(path: &Path, samples: usize, outer: &Path, same: f64) -> bool {
    let segments = &path.segments;
    let stride = segments.len().div_ceil(samples / 2).max(1);
    // Contours of few elements, such as circles, are checked at more points on each.
    let each = u32::try_from(SAMPLES.div_ceil(segments.len().max(1))).unwrap_or(1).max(2);
    let mut some_inside = false;
    for segment in segments.iter().step_by(stride) {
        for point in (0..each).map(|k| segment.at(f64::from(k) / f64::from(each))) {
            if on(outer, point, same) {
                continue;
            }
            if winding(outer, point) == 0.0 {
                return false;
            }
            some_inside = true;
        }
    }
    some_inside
}

fn on(path: &Path, point: DVec2, same: f64) -> bool {
    path.segments.iter().any(|s| {
        let same = same + rounding(s);
        s.bounds().grown(same).contains(point) && s.nearest(point).1 <= same * same
    })
}

/// The winding number of a closed path around a point that is not on it.
pub(super) fn winding(path: &Path, point: DVec2) -> f64 {
    (path.segments.iter().map(|s| angle_seen(s, point)).sum::<f64>() / TAU).round()
}

/// The signed angle that an element covers as seen from a point: that of its chord, plus a full turn if the point lies
/// between chord and arc.
fn angle_seen(segment: &Segment, point: DVec2) -> f64 {
    let (from, to) = (segment.start() - point, segment.end() - point);
    let chord = math::turn(from, to);
    let Segment::Arc(arc) = segment else { return chord };
    let whole = if arc.ccw() { TAU } else { -TAU };
    let in_disc = point.distance(arc.center) < arc.radius();
    if arc.is_circle() {
        return if in_disc { whole } else { 0.0 };
    }
    // A counter-clockwise arc lies to the right of its chord.
    let right = -(arc.end - arc.start).perp_dot(point - arc.start);
    let side = if arc.ccw() { right } else { -right };
    if side == 0.0 && in_disc {
        // On the chord the angle is half a turn in the direction of the arc.
        chord.abs().copysign(whole)
    } else if side > 0.0 && in_disc {
        chord + whole
    } else {
        chord
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;
    use std::f64::consts::PI;

    /// A disc with a notch: three quarters of a circle of radius 2 around the origin, closed by two perpendicular lines
    /// through the point (0.5, 0.5).
    fn bitten(ccw: bool) -> Path {
        let arc = Arc::from_angles(DVec2::ZERO, 2.0, PI / 2.0, 1.5 * PI);
        let notch = DVec2::new(0.5, 0.5);
        let path = Path::new(
            vec![Segment::Arc(arc), Segment::line(arc.end, notch), Segment::line(notch, arc.start)],
            true,
        );
        if ccw { path } else { path.reversed() }
    }

    #[test]
    fn winding_is_exact_for_arcs() {
        for (path, turns) in [(bitten(true), 1.0), (bitten(false), -1.0)] {
            for k in 0..4000_i32 {
                let p = DVec2::new(f64::from(k % 63) / 12.0 - 2.6, f64::from(k / 63) / 12.0 - 2.6);
                if on(&path, p, SAME) {
                    continue;
                }
                // Outside the three-quarter disc, or in the fourth quarter beyond both lines.
                let quarter = p.x > 0.0 && p.y > 0.0;
                let under = (p.x - 0.5) * 1.5 + (p.y - 0.5) * 0.5 < 0.0
                    || (p.y - 0.5) * 1.5 + (p.x - 0.5) * 0.5 < 0.0;
                let inside = if quarter { under && p.x + p.y < 2.0 } else { p.length() < 2.0 };
                assert_eq!(winding(&path, p) != 0.0, inside, "{p}");
                assert!(!inside || (winding(&path, p) - turns).abs() < 0.5);
            }
        }
        let circle = Path::new(vec![Segment::Arc(Arc::circle(DVec2::ONE, 1.0))], true);
        assert!((winding(&circle, DVec2::new(1.9, 1.0)) - 1.0).abs() < 0.5);
        assert!(winding(&circle, DVec2::new(1.9, 1.9)).abs() < 0.5);
    }

    #[test]
    fn points_on_the_chord_of_an_arc() {
        let half = Path::new(
            vec![
                Segment::Arc(Arc::from_angles(DVec2::ZERO, 1.0, PI, PI)),
                Segment::Arc(Arc::from_angles(DVec2::ZERO, 1.0, 0.0, PI)),
            ],
            true,
        );
        for p in [DVec2::ZERO, DVec2::new(0.5, 0.0), DVec2::new(-0.5, 0.0)] {
            assert!((winding(&half, p) - 1.0).abs() < 0.5);
            assert!((winding(&half.reversed(), p) + 1.0).abs() < 0.5);
        }
    }
}
