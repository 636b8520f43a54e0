//! The narrowest web: the place where two cuts of a part are closest to each other and the material between them is
//! thinnest.

use super::shape::Shape;
use crate::geometry::{Aabb, BoxIndex, DVec2};
use std::collections::BTreeMap;

/// Two contours and the distance between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Web {
    pub(super) contours: [usize; 2],
    pub(super) width: f64,
    pub(super) at: DVec2,
}

/// The narrowest web between any two of these contours; its width is 0 where they cross.
pub(super) fn between(shapes: &[Shape], contours: &[usize]) -> Option<Web> {
    let chords: Vec<(usize, [DVec2; 2])> = contours
        .iter()
        .flat_map(|&id| shapes.get(id).into_iter().flat_map(Shape::chords).map(move |c| (id, c)))
        .collect();
    let index = BoxIndex::new(chords.iter().map(|(_, [a, b])| Aabb::of(*a).with(*b)));
    let mut best: Option<Web> = None;
    // Something near first, so that little is looked through: each chord with the one before it in the row.
    let mut reach = nearest_ends(shapes, contours);
    for (k, &(id, chord)) in chords.iter().enumerate() {
        let area = Aabb::of(chord[0]).with(chord[1]).grown(reach);
        index.visit(area, |other| {
            let (other_id, other_chord) = chords[other];
            if other > k && other_id != id {
                let (width, at) = apart(chord, other_chord);
                if width < reach || best.is_none() {
                    reach = width.min(reach);
                    best = Some(Web { contours: [id, other_id], width, at });
                }
            }
            true
        });
    }
    best
}

/// Each pair of these contours that is closer than `limit` somewhere, at its narrowest place; in the order of their ids.
pub(super) fn closer_than(shapes: &[Shape], contours: &[usize], limit: f64) -> Vec<Web> {
    let chords: Vec<(usize, [DVec2; 2])> = contours
        .iter()
        .flat_map(|&id| shapes.get(id).into_iter().flat_map(Shape::chords).map(move |c| (id, c)))
        .collect();
    let index = BoxIndex::new(chords.iter().map(|(_, [a, b])| Aabb::of(*a).with(*b)));
    let mut webs: BTreeMap<[usize; 2], Web> = BTreeMap::new();
    for (k, &(id, chord)) in chords.iter().enumerate() {
        index.visit(Aabb::of(chord[0]).with(chord[1]).grown(limit), |other| {
            let (other_id, other_chord) = chords[other];
            if other > k && other_id != id {
                let (width, at) = apart(chord, other_chord);
                let pair = [id.min(other_id), id.max(other_id)];
                if width < limit && webs.get(&pair).is_none_or(|known| width < known.width) {
                    webs.insert(pair, Web { contours: pair, width, at });
                }
            }
            true
        });
    }
    webs.into_values().collect()
}

/// An upper bound of the width, from the first points of contours.
fn nearest_ends(shapes: &[Shape], contours: &[usize]) -> f64 {
    let firsts: Vec<DVec2> =
        contours.iter().filter_map(|&id| shapes.get(id)?.points.first().copied()).collect();
    let some = firsts.windows(2).map(|w| w[0].distance(w[1])).fold(f64::INFINITY, f64::min);
    if some.is_finite() { some } else { 0.0 }
}

/// Distance of two chords and the point halfway between them; 0 where they cross.
fn apart([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> (f64, DVec2) {
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return (0.0, (a + b) / 2.0);
    }
    let mut best = (f64::INFINITY, a);
    for (p, [u, v]) in [(a, [c, d]), (b, [c, d]), (c, [a, b]), (d, [a, b])] {
        let along = ((p - u).dot(v - u) / (v - u).length_squared()).clamp(0.0, 1.0);
        let foot = u + (v - u) * along;
        if p.distance(foot) < best.0 {
            best = (p.distance(foot), (p + foot) / 2.0);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Arc, Segment};

    #[test]
    fn between_two_circles_and_by_brute_force() {
        let mut shapes = Vec::new();
        // A row of circles of radius 1, 3 mm apart; the last two are closer.
        for k in 0..30 {
            let x = f64::from(k) * 3.0 - if k == 29 { 0.4 } else { 0.0 };
            let mut shape = Shape::default();
            shape.add(&[Segment::Arc(Arc::circle(DVec2::new(x, 0.5 * f64::from(k % 3)), 1.0))]);
            shapes.push(shape);
        }
        let all: Vec<usize> = (0..30).collect();
        let web = between(&shapes, &all).unwrap();
        let mut least = f64::INFINITY;
        for i in 0..30 {
            for j in 0..i {
                for a in shapes[i].chords() {
                    for b in shapes[j].chords() {
                        least = least.min(apart(a, b).0);
                    }
                }
            }
        }
        assert_eq!(web.width.to_bits(), least.to_bits());
        assert_eq!(web.contours, [28, 29]);
        assert!(between(&shapes, &[3]).is_none());
        // The same web, and no other is so narrow: the others are about 1 mm wide.
        let close = closer_than(&shapes, &all, web.width + 0.1);
        assert_eq!(close, [Web { contours: [28, 29], ..web }]);
        assert_eq!(closer_than(&shapes, &all, 2.0).len(), 29);
    }
}
