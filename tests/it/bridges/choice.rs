//! The choice of bridges against every choice there is, up to six parts, with strips and seconds that the test works out by itself.

use super::{bridging, p, pairs, plain, plan_of, rectangle, with};
use crate::testkit::sheets::XorShift;
use kerfway::geometry::DVec2;
use kerfway::machine::air_time;

const WIDTH: f64 = 3.0;
const REACH: f64 = 14.0;
const CLEARANCE: f64 = 1.0;

#[derive(Clone, Copy, Debug)]
struct Rectangle {
    min: DVec2,
    max: DVec2,
}

#[derive(Clone, Copy, Debug)]
struct Strip {
    parts: [usize; 2],
    place: Rectangle,
    length: f64,
}

/// Distance of two rectangles along the axes.
fn apart(a: Rectangle, b: Rectangle) -> f64 {
    (a.min - b.max).max(b.min - a.max).max(DVec2::ZERO).length()
}

/// Every strip between two of the rectangles: across their facing sides, in the middle and at the quarters of the stretch in which they
/// face each other, a millimetre from their corners and from every other rectangle.
fn strips(parts: &[Rectangle]) -> Vec<Strip> {
    let mut all = Vec::new();
    for i in 0..parts.len() {
        for j in i + 1..parts.len() {
            for axis in 0..2 {
                let (a, b) = (parts[i], parts[j]);
                let side = 1 - axis;
                let (low, high) = if a.max[axis] < b.min[axis] { (a, b) } else { (b, a) };
                let (from, to) = (low.max[axis], high.min[axis]);
                let (first, last) = (a.min[side].max(b.min[side]), a.max[side].min(b.max[side]));
                if from >= to || to - from > REACH || first >= last {
                    continue;
                }
                for part in [0.5, 0.25, 0.75] {
                    let middle = first + part * (last - first);
                    let (mut min, mut max) = (p(from, from), p(to, to));
                    (min[side], max[side]) = (middle - WIDTH / 2.0, middle + WIDTH / 2.0);
                    let place = Rectangle { min, max };
                    let corners = [a, b].iter().all(|r| {
                        min[side] - r.min[side] >= CLEARANCE && r.max[side] - max[side] >= CLEARANCE
                    });
                    let others = parts.iter().enumerate().filter(|(k, _)| *k != i && *k != j);
                    if corners && others.into_iter().all(|(_, r)| apart(*r, place) >= CLEARANCE) {
                        all.push(Strip { parts: [i, j], place, length: to - from });
                    }
                }
            }
        }
    }
    all
}

/// Seconds that a strip saves on a head that stops in every corner.
fn saved(strip: &Strip) -> f64 {
    let machine = plain();
    let stop = 33.0 / 3000.0;
    let sides = 2.0 * (strip.length / 33.0 + stop);
    // Each opening ends a run and begins another one, 3 mm on.
    let openings = 2.0 * (stop - WIDTH / 33.0);
    let air = air_time(&machine, p(0.0, 0.0), p(strip.length, 0.0));
    machine.pierce_time + machine.beam_on_delay + machine.beam_off_delay + air - sides - openings
}

/// The most seconds that any choice of strips saves, of which none close a circle of parts or are near each other.
fn most(strips: &[Strip], chosen: &mut Vec<Strip>, group: &mut Vec<usize>) -> f64 {
    let Some((first, rest)) = strips.split_first() else { return chosen.iter().map(saved).sum() };
    let mut best = most(rest, chosen, group);
    let [a, b] = first.parts.map(|k| group[k]);
    if a != b && chosen.iter().all(|c| apart(c.place, first.place) >= CLEARANCE) {
        let before = group.clone();
        group.iter_mut().filter(|g| **g == b).for_each(|g| *g = a);
        chosen.push(*first);
        best = best.max(most(rest, chosen, group));
        chosen.pop();
        *group = before;
    }
    best
}

#[test]
fn no_other_choice_of_bridges_saves_more() {
    let stops = with(&bridging(WIDTH, REACH), &serde_json::json!({ "junction_deviation": 0.0 }));
    let (mut connected, mut apart_still, mut left) = (0, 0, 0);
    for seed in 0..30 {
        let mut rng = XorShift::new(7000 + seed);
        let count = 3 + usize::try_from(seed % 4).unwrap();
        let parts: Vec<Rectangle> = (0..count)
            .map(|k| {
                let at = p((k % 3) as f64, (k / 3) as f64) * p(36.0, 30.0);
                let min = at + 10.0 + p(rng.between(0.0, 6.0), rng.between(0.0, 6.0));
                Rectangle { min, max: min + p(rng.between(14.0, 28.0), rng.between(12.0, 22.0)) }
            })
            .collect();
        let drawing: Vec<_> = parts.iter().map(|r| rectangle(r.min, r.max - r.min)).collect();
        let plan = plan_of(&drawing, stops.clone());
        let all: Vec<Strip> = strips(&parts).into_iter().filter(|s| saved(s) > 0.0).collect();
        let best = most(&all, &mut Vec::new(), &mut (0..count).collect());
        let found: f64 = plan
            .bridges
            .iter()
            .map(|s| {
                let length = s.sides[0][0].distance(s.sides[0][1]);
                saved(&Strip { parts: [0, 0], place: parts[0], length })
            })
            .sum();
        assert!((found - best).abs() < 1e-6, "seed {seed}: {found} {best} {:?}", pairs(&plan));
        // The plan says the same in seconds of cutting and piercing.
        let apart = plan_of(&drawing, with(&plain(), &serde_json::json!({ "junction_deviation": 0.0 })));
        let less = apart.summary.cut_time + apart.summary.pierce_time
            - plan.summary.cut_time
            - plan.summary.pierce_time;
        let air: f64 = plan.bridges.iter().map(|s| air_time(&plain(), s.sides[0][0], s.sides[0][1])).sum();
        assert!((less + air - found).abs() < 1e-6, "seed {seed}: {less} {air} {found}");
        connected += plan.bridges.len();
        apart_still += usize::from(plan.bridges.len() + 1 < count);
        left += all.len();
    }
    // The cases are no trivial ones: many strips to choose from, and not all parts can be connected.
    assert!(connected > 50 && apart_still > 10 && left > 2 * connected, "{connected} {apart_still} {left}");
}
