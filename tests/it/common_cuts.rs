//! Contours that share cuts: found, pierced once, cut as a whole, in an order in which nothing falls out too early.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, reason = "a test fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "sheets of a few contours"
)]

use crate::testkit::outlines::covers;
use crate::testkit::plates::{grid, pinwheel, rectangle, thick, together};
use crate::testkit::rng::seeded;
use kerfway::geometry::DVec2;
use kerfway::job::{BestPath, Job, OutputKind, WarmPath};
use kerfway::machine::{Levers, MovingPierce, Profile};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::{CommonCuts, Sheet};
use rand::RngExt;

/// Length of all lines of a grid.
fn union(m: usize, n: usize) -> f64 {
    (n + 1) as f64 * 20.0 * m as f64 + (m + 1) as f64 * 10.0 * n as f64
}

/// Rows of bricks: partial overlaps, T-junctions.
fn bricks() -> Vec<Vec<DVec2>> {
    let row = |y: usize| {
        (0..3).map(move |x| {
            rectangle([50.0 + 20.0 * x as f64 + 10.0 * (y % 2) as f64, 50.0 + 8.0 * y as f64, 20.0, 8.0])
        })
    };
    (0..3).flat_map(row).collect()
}

fn job(outlines: &[Vec<DVec2>], common_cuts: CommonCuts, warm: Option<WarmPath>) -> Job {
    crate::testkit::plates::job(outlines, common_cuts, thick(), warm)
}

fn planned(outlines: &[Vec<DVec2>], common_cuts: CommonCuts) -> (Sheet, Plan) {
    let mut job = job(outlines, common_cuts, None);
    job.run_mut().unwrap().step(100_000);
    // Checked.
    let plan = job.plan().unwrap();
    (job.sheet().clone(), plan)
}

#[test]
fn a_grid_is_cut_once_and_pierced_once() {
    for (m, n) in [(2, 1), (2, 2), (3, 2), (3, 3), (5, 4)] {
        let (sheet, plan) = planned(&grid(m, n), CommonCuts::Best);
        assert_eq!(sheet.groups.len(), 1, "{m} x {n}");
        assert_eq!(sheet.groups[0].faces as usize, m * n + 1, "{m} x {n}");
        assert!(
            (plan.summary.cut_length - union(m, n)).abs() < 1e-6,
            "{m} x {n}: {}",
            plan.summary.cut_length
        );
        assert_eq!(plan.summary.pierces, 1, "{m} x {n}");
        let (apart, separately) = planned(&grid(m, n), CommonCuts::Off);
        assert!(apart.groups.is_empty());
        assert_eq!(separately.summary.pierces as usize, apart.contours.len());
        assert!(plan.summary.total_time < separately.summary.total_time, "{m} x {n}");
    }
}

#[test]
fn bricks_and_islands_are_groups_and_what_an_island_holds_comes_first() {
    let (sheet, plan) = planned(&bricks(), CommonCuts::Best);
    assert_eq!((sheet.groups.len(), sheet.groups[0].faces, plan.summary.pierces), (1, 10, 1));
    // Three rows of three 20 mm bricks of 8 mm, rows shifted by half: sides of 60 mm, uprights, what sticks out.
    assert!(
        (plan.summary.cut_length - (4.0 * 60.0 + 2.0 * 10.0 + 12.0 * 8.0)).abs() < 1e-6,
        "{}",
        plan.summary.cut_length
    );

    let (sheet, plan) = planned(&pinwheel(), CommonCuts::Best);
    assert_eq!(sheet.groups.len(), 1);
    let group = &sheet.groups[0];
    // One of the parts has lost two sides, and is two open contours.
    assert_eq!((group.contours.len(), group.faces), (5, 6), "four parts and the island");
    let [inner] = group.inside[..] else { panic!("{:?}", group.inside) };
    // The checker has followed the areas: it comes before the island falls out. It is not last, at any rate.
    let cut = |m: &Move| if let Move::Cut { contour, .. } = m { Some(*contour) } else { None };
    assert!(plan.moves.iter().any(|m| cut(m) == Some(inner)));
    assert_ne!(plan.moves.iter().rev().find_map(cut), Some(inner));
}

#[test]
fn the_insertion_heuristic_gives_a_path_and_the_best_is_no_worse() {
    for outlines in [grid(2, 2), grid(4, 3), bricks(), pinwheel()] {
        let best = planned(&outlines, CommonCuts::Best).1.summary.total_time;
        let by_insertion = planned(&outlines, CommonCuts::Insertion).1.summary.total_time;
        assert!(best <= by_insertion + 1e-9, "{best} {by_insertion}");
    }
}

#[test]
fn a_group_of_hundreds_of_parts_hung_with_the_insertion_heuristic_and_the_best_path_is_taken_instead() {
    // 24 x 23 and 25 x 22 sides, of which the two at each of the four corners are one cut.
    let job = job(&grid(24, 22), CommonCuts::Insertion, None);
    let told = "The insertion heuristic takes at most 1000 cuts between the corners of contours that share cuts, and these have 1098: \
                their path is the best that the search finds.";
    let findings = &job.run().unwrap().findings;
    assert_eq!(findings.iter().filter(|f| f.message == told).count(), 1, "{findings:?}");
    assert_eq!(job.plan().unwrap().summary.parts, 24 * 22);
}

#[test]
fn moved_turned_mirrored_and_reordered_drawings_have_the_same_nets() {
    let net = |outlines: &[Vec<DVec2>]| {
        let sheet = planned(outlines, CommonCuts::Best).0;
        let group = &sheet.groups[0];
        let mut degrees = vec![0; group.nodes.len()];
        group.elements.iter().flat_map(|e| e.ends).for_each(|n| degrees[n as usize] += 1);
        degrees.sort_unstable();
        let length: f64 = group.elements.iter().map(|e| group.path(e).length()).sum();
        (group.faces, degrees, (length * 1e6).round() as i64)
    };
    let all = |f: &dyn Fn(DVec2) -> DVec2, o: &[Vec<DVec2>]| -> Vec<Vec<DVec2>> {
        o.iter().map(|p| p.iter().map(|p| f(*p)).collect()).collect()
    };
    for outlines in [grid(3, 3), bricks(), pinwheel()] {
        let wanted = net(&outlines);
        assert_eq!(net(&all(&|p| p + DVec2::new(17.3, -4.1), &outlines)), wanted);
        assert_eq!(net(&all(&|p| DVec2::new(-p.y, p.x) + 300.0, &outlines)), wanted);
        assert_eq!(net(&all(&|p| DVec2::new(400.0 - p.x, p.y), &outlines)), wanted);
        let turned: Vec<_> = outlines.iter().rev().map(|o| o.iter().rev().copied().collect()).collect();
        assert_eq!(net(&turned), wanted);
    }
}

/// Violations after a change to the moves, the sums brought in line.
fn after(change: impl FnOnce(&mut Vec<Move>)) -> Vec<Violation> {
    let (sheet, mut plan) = planned(&grid(2, 2), CommonCuts::Best);
    change(&mut plan.moves);
    let before = plan.summary;
    plan.summary = plan::evaluate(&plan.moves, &sheet, &thick());
    (plan.summary.parts, plan.summary.open_contours) = (before.parts, before.open_contours);
    plan::check(&sheet, &thick(), &plan).unwrap_err()
}

#[test]
fn a_common_cut_made_twice_is_found() {
    let found = after(|moves| {
        let at = moves.iter().position(|m| matches!(m, Move::Cut { .. })).unwrap();
        let Move::Cut { path, .. } = &mut moves[at] else { unreachable!() };
        // There, back and there again.
        let (there, back) = (path[0], path[0].reversed());
        path.splice(0..0, [there, back]);
    });
    assert!(
        found.iter().any(|v| matches!(v, Violation::Again { .. } | Violation::Strays { .. })),
        "{found:?}"
    );
}

#[test]
fn an_element_cut_after_its_composite_contour_is_found() {
    // The runs of the group the other way round: the outer contour closes first.
    let found = after(|moves| {
        let first = moves.iter().position(|m| matches!(m, Move::Pierce)).unwrap();
        let last = moves.iter().rposition(|m| matches!(m, Move::Cut { .. })).unwrap();
        let mut stretch: Vec<Move> = moves.drain(first..=last).collect();
        stretch.reverse();
        for m in &mut stretch {
            if let Move::Cut { path, contour, with, .. } = m {
                *path = path.iter().rev().map(|s| s.reversed()).collect();
                let mut all = vec![*contour];
                all.append(with);
                all.reverse();
                *contour = all.remove(0);
                *with = all;
            }
        }
        moves.splice(first..first, stretch);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::Fallen { .. })), "{found:?}");
}

#[test]
fn a_missing_pre_cut_is_found() {
    let found = after(|moves| {
        let at = moves.iter().position(|m| matches!(m, Move::PreCut { .. })).unwrap();
        moves.remove(at);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::NoPreCut { .. })), "{found:?}");
}

#[test]
fn a_missing_element_is_found() {
    let found = after(|moves| {
        let at = moves.iter().rposition(|m| matches!(m, Move::Cut { .. })).unwrap();
        moves.remove(at);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::Partly { .. })), "{found:?}");
}

#[test]
fn g_code_covers_every_outline() {
    for outlines in [grid(3, 2), bricks(), pinwheel()] {
        let mut job = job(&outlines, CommonCuts::Best, None);
        job.run_mut().unwrap().step(300_000);
        covers(&outlines, &job.output(OutputKind::Gcode).unwrap());
    }
}

#[test]
fn a_search_continues_from_a_best_path() {
    for outlines in [grid(3, 3), pinwheel()] {
        let mut first = job(&outlines, CommonCuts::Best, None);
        first.run_mut().unwrap().step(50_000);
        let cost = first.run().unwrap().best().cost;
        let (path, plan) = BestPath::of(first.run().unwrap(), first.sheet());
        assert_eq!(path.times.len(), 2 * path.contours.len());
        assert!(path.times.windows(2).all(|t| t[0] <= t[1] + 1e-9));
        assert!(*path.times.last().unwrap() <= plan.summary.total_time);
        let BestPath { contours, along, until, reversed, .. } = path;
        let second = job(&outlines, CommonCuts::Best, Some(WarmPath { contours, along, until, reversed }));
        assert!((second.run().unwrap().best().cost - cost).abs() < 1e-9);
    }
}

/// Turned and written with a few decimals, sides no longer meet exactly.
#[test]
fn parts_that_meet_within_the_tolerance_are_a_group() {
    for (turned, decimals) in [(0.0, 3), (0.3, 6), (0.3, 4), (1.1, 3)] {
        let (sin, cos) = f64::sin_cos(turned);
        let grain = 10_f64.powi(decimals);
        let place = |p: &DVec2| {
            let p = DVec2::new(400.0 + p.x * cos - p.y * sin, 100.0 + p.x * sin + p.y * cos);
            (p * grain).round() / grain
        };
        for (outlines, pierces) in [(grid(2, 1), 1), (grid(3, 2), 1), (bricks(), 1), (pinwheel(), 2)] {
            let turned_outlines: Vec<Vec<DVec2>> =
                outlines.iter().map(|o| o.iter().map(place).collect()).collect();
            let mut job = job(&turned_outlines, CommonCuts::Best, None);
            job.run_mut().unwrap().step(5_000);
            let plan = job.plan().unwrap();
            assert_eq!((job.sheet().groups.len(), plan.summary.pierces), (1, pierces), "{turned} {decimals}");
            covers(&turned_outlines, &job.output(OutputKind::Gcode).unwrap());
        }
    }
}

/// What is cut while a group is left has places of its own for entering and leaving if it begins moving: reversed, it is entered where it was.
#[test]
fn searches_end_with_moving_starts_beside_contours_that_are_cut_together() {
    let moving = |levers: Levers| Levers { moving_pierce: Some(MovingPierce { overcut: 3.0 }), ..levers };
    let machine = Profile { levers: moving(together().levers), ..together() };
    for seed in 0..6 {
        let mut rng = seeded(seed);
        let mut drawn = |from: f64, to: f64| rng.random_range(from..to);
        let mut outlines = grid(2, 2);
        for k in 0..60 {
            // Two in each part, the others beside all of them.
            let (part, beside) = (DVec2::new(f64::from(k % 2), f64::from(k / 2 % 2)), f64::from(k - 8));
            let (corner, size) = if k < 8 {
                (DVec2::new(101.0 + 9.0 * f64::from(k / 4), 101.0) + part * DVec2::new(20.0, 10.0), 4.0)
            } else {
                (DVec2::new(145.0 + 12.0 * (beside % 8.0), 60.0 + 12.0 * (beside / 8.0).floor()), 8.0)
            };
            let at = corner + DVec2::new(drawn(0.0, 3.0), drawn(0.0, 3.0));
            outlines.push(rectangle([at.x, at.y, drawn(2.0, size), drawn(2.0, size)]));
        }
        let mut job = crate::testkit::plates::job(&outlines, CommonCuts::Best, machine.clone(), None);
        job.run_mut().unwrap().step(300_000);
        assert_eq!(job.sheet().groups.len(), 1);
        let plan = job.plan().unwrap();
        assert_eq!(plan.summary.moving_starts, 60);
    }
}
