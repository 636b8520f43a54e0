//! Small pierce groups against brute force: every order and direction of their elements.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_cmp,
    unreachable_pub,
    reason = "a test fails by panicking"
)]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "groups of a few elements"
)]

use crate::testkit::by_hand::{ByHand, CELL, air};
use crate::testkit::plates::{job, rectangle, thick, together};
use crate::testkit::rng::seeded;
use kerfway::geometry::DVec2;
use kerfway::job::problem_of;
use kerfway::machine::Profile;
use kerfway::plan;
use kerfway::problem::{Stroke, SubPath};
use kerfway::sheet::CommonCuts;
use rand::RngExt;

/// Rectangles by lattice: left, bottom, width, height.
fn parts(all: &[[i32; 4]]) -> Vec<Vec<DVec2>> {
    all.iter().map(|r| rectangle(r.map(|k| f64::from(k) * CELL))).collect()
}

/// Cutting at one speed: all but the order is the same.
fn even() -> Profile {
    let mut machine = thick();
    machine.cut.accel = None;
    machine
}

/// Corners by lattice.
fn outline(corners: &[[i32; 2]]) -> Vec<DVec2> {
    corners.iter().map(|c| DVec2::from(c.map(|k| f64::from(k) * CELL))).collect()
}

/// Groups of at most 9 elements.
fn small() -> Vec<(String, Vec<Vec<DVec2>>)> {
    let all = [
        ("two parts", parts(&[[3, 2, 2, 1], [5, 2, 2, 1]])),
        ("two of different height", parts(&[[3, 2, 2, 3], [5, 3, 2, 1]])),
        ("a row of three", parts(&[[3, 2, 2, 1], [5, 2, 2, 1], [7, 2, 2, 1]])),
        ("an L of three", parts(&[[3, 2, 2, 1], [5, 2, 2, 1], [3, 3, 2, 1]])),
        ("a T", parts(&[[3, 2, 4, 1], [3, 3, 2, 2], [5, 3, 2, 2]])),
        ("2 x 2", parts(&[[3, 2, 2, 1], [5, 2, 2, 1], [3, 3, 2, 1], [5, 3, 2, 1]])),
        ("a row of four", parts(&[[3, 2, 1, 1], [4, 2, 1, 1], [5, 2, 1, 1], [6, 2, 1, 1]])),
        (
            "a ring of two around an island",
            vec![
                outline(&[[3, 2], [6, 2], [6, 3], [4, 3], [4, 5], [3, 5]]),
                outline(&[[6, 3], [6, 5], [4, 5], [4, 4], [5, 4], [5, 3]]),
            ],
        ),
        (
            "a ring of three around an island",
            vec![
                outline(&[[3, 2], [6, 2], [6, 3], [4, 3], [4, 5], [3, 5]]),
                outline(&[[5, 3], [6, 3], [6, 4], [5, 4]]),
                outline(&[[4, 4], [6, 4], [6, 5], [4, 5]]),
            ],
        ),
    ];
    all.into_iter().map(|(name, outlines)| (name.to_owned(), outlines)).collect()
}

/// Rectangles cut in two again and again, some left out: nets of one group and up to 8 elements.
fn random() -> Vec<(String, Vec<Vec<DVec2>>)> {
    let mut found = Vec::new();
    for seed in 0..40 {
        let mut rng = seeded(seed);
        let mut below = |n: i32| rng.random_range(0..n);
        let mut all = vec![[2, 1, 4 + below(3), 3 + below(3)]];
        for _ in 0..2 + below(3) {
            let k = below(all.len() as i32) as usize;
            let [x, y, w, h] = all[k];
            if w > 1 && (h == 1 || below(2) == 0) {
                let part = 1 + below(w - 1);
                all[k] = [x, y, part, h];
                all.push([x + part, y, w - part, h]);
            } else if h > 1 {
                let part = 1 + below(h - 1);
                all[k] = [x, y, w, part];
                all.push([x, y + part, w, h - part]);
            }
        }
        if all.len() > 3 && below(3) == 0 {
            all.remove(below(all.len() as i32) as usize);
        }
        let job = job(&parts(&all), CommonCuts::Best, even(), None);
        let sheet = job.sheet();
        let mut cut: Vec<u32> = sheet.groups.iter().flat_map(|g| g.contours.clone()).collect();
        cut.sort_unstable();
        let whole = cut.len() == sheet.contours.len() && sheet.groups.len() == 1;
        if whole && (4..=8).contains(&sheet.groups[0].elements.len()) {
            found.push((format!("random {seed}: {all:?}"), parts(&all)));
        }
    }
    found
}

/// How often a run is interrupted for a pre-cut in the ways through a group.
fn agrees(name: &str, outlines: &[Vec<DVec2>], machine: &Profile) -> usize {
    let mut job = job(outlines, CommonCuts::Best, machine.clone(), None);
    let sheet = job.sheet().clone();
    let [group] = &sheet.groups[..] else { panic!("{name}: {} groups", sheet.groups.len()) };
    let by_hand = ByHand::new(group, machine);
    assert!(by_hand.count() <= 9, "{name}: {} elements", by_hand.count());

    // Every way through the group that is offered is the least between its ends, and none is missing.
    let problem = problem_of(&sheet, machine);
    let ways = &problem.items[group.contours[0] as usize].paths;
    for way in ways {
        let least = by_hand.between(way.ends[0], way.ends[1]);
        assert!((way.seconds - least).abs() < 1e-9, "{name}: {:?} {} {least}", way.ends, way.seconds);
    }
    for &a in &by_hand.nodes {
        for &b in &by_hand.nodes {
            let to = |way: &SubPath| air(machine, a, way.ends[0]) + air(machine, way.ends[1], b);
            let best = ways.iter().map(|w| w.seconds + to(w)).fold(f64::INFINITY, f64::min);
            let least = by_hand.between(a, b);
            assert!((best - least).abs() < 1e-9, "{name}: from {a} to {b}: {best} {least}");
        }
    }

    // The whole plan is the least over all ends, and adds up to that.
    job.run_mut().unwrap().step(100_000);
    let plan = job.plan().unwrap();
    let least = by_hand.between(machine.home(), machine.home());
    let evaluated = plan::evaluate(&plan.moves, job.beam_sheet(), machine).total_time;
    assert!((plan.summary.total_time - least).abs() < 1e-9, "{name}: {} {least}", plan.summary.total_time);
    assert!((evaluated - least).abs() < 1e-9, "{name}: {evaluated} {least}");
    let interrupted = |way: &SubPath| {
        let goes_on =
            |s: &[Stroke]| matches!(s, [Stroke::Cut { .. }, Stroke::PreCut { .. }, Stroke::Cut { .. }]);
        way.strokes.windows(3).filter(|s| goes_on(s)).count()
    };
    ways.iter().map(interrupted).sum()
}

#[test]
fn the_order_of_a_small_group_is_the_least_of_all() {
    let all = small().into_iter().chain(random());
    let interrupted: Vec<usize> = all.map(|(name, outlines)| agrees(&name, &outlines, &even())).collect();
    assert!(interrupted.len() > 20, "{}", interrupted.len());
    // The case that matters: where a run is best interrupted.
    assert!(interrupted.iter().any(|&n| n > 0));
}

#[test]
fn with_corners_and_acceleration_it_is_the_least_of_all_too() {
    for (name, outlines) in small().into_iter().chain(random()) {
        let job = job(&outlines, CommonCuts::Best, thick(), None);
        if job.sheet().groups[0].elements.len() <= 7 {
            for home in [[0.0, 0.0], [55.0, 28.0], [300.0, -40.0]] {
                agrees(&name, &outlines, &Profile { home, ..thick() });
            }
        }
    }
}

#[test]
fn without_pre_cuts_the_order_is_the_least_of_all_that_begin_on_kerfs() {
    let one_speed = |mut machine: Profile| {
        machine.cut.accel = None;
        machine
    };
    for (name, outlines) in small().into_iter().chain(random()) {
        for home in [[0.0, 0.0], [55.0, 28.0]] {
            agrees(&name, &outlines, &one_speed(Profile { home, ..together() }));
        }
        if job(&outlines, CommonCuts::Best, together(), None).sheet().groups[0].elements.len() <= 7 {
            agrees(&name, &outlines, &together());
        }
    }
}

#[test]
fn two_groups_are_cut_in_the_best_order_from_the_best_ends() {
    let pair = |x, y| [[x, y, 2, 1], [x + 2, y, 2, 1], [x, y + 1, 2, 1]];
    let outlines = parts(&[pair(3, 2), pair(15, 4)].concat());
    for home in [[0.0, 0.0], [100.0, 20.0], [300.0, 90.0]] {
        let machine = Profile { home, ..even() };
        let mut job = job(&outlines, CommonCuts::Best, machine.clone(), None);
        let sheet = job.sheet().clone();
        let [one, other] = &sheet.groups[..] else { panic!("{} groups", sheet.groups.len()) };
        let (one, other) = (ByHand::new(one, &machine), ByHand::new(other, &machine));
        let least = |a: &ByHand, b: &ByHand| {
            let first = a.nodes.iter().map(|&n| (n, a.between(machine.home(), n)));
            let then = |(n, seconds)| seconds + b.between(n, machine.home());
            first.map(then).fold(f64::INFINITY, f64::min)
        };
        job.run_mut().unwrap().step(100_000);
        let total = job.plan().unwrap().summary.total_time;
        let least = least(&one, &other).min(least(&other, &one));
        assert!((total - least).abs() < 1e-9, "{home:?}: {total} {least}");
    }
}
