//! What the checker says of wrong plans.

use super::*;
use kerfway::geometry::{DVec2, Path, Segment};
use kerfway::plan::{Violation, check, evaluate};
use kerfway::sheet::Sheet;

/// A sound plan with its sheet and machine, and a plan changed in some way with its sums made right again.
fn changed(change: impl Fn(&mut Sheet, &mut Plan)) -> Vec<Violation> {
    let skeleton = Skeleton { joint_spacing: Some(200.0), ..grid(100.0, 100.0) };
    let job = started(square_and_disk(), with(skeleton)).unwrap();
    let machine = &job.run().unwrap().machine;
    let (mut sheet, mut plan) = (job.beam_sheet().clone(), job.plan().unwrap());
    change(&mut sheet, &mut plan);
    let parts = plan.summary.parts;
    plan.summary = evaluate(&plan.moves, &sheet, machine);
    plan.summary.parts = parts;
    check(&sheet, machine, &plan).err().unwrap_or_default()
}

/// Moves the skeleton cut that lies at x = `from` to x = `to`.
fn shifted(sheet: &mut Sheet, plan: &mut Plan, from: f64, to: f64) {
    let by = DVec2::new(to - from, 0.0);
    let is_there = |p: DVec2| (p.x - from).abs() < 1e-9;
    for m in &mut plan.moves {
        match m {
            Move::Cut { contour, path, .. } if sheet.contours[*contour as usize].skeleton => {
                if let [Segment::Line(l)] = path.as_mut_slice()
                    && is_there(l.start)
                    && is_there(l.end)
                {
                    (l.start, l.end) = (l.start + by, l.end + by);
                    sheet.contours[*contour as usize].path = Path::new(path.clone(), false);
                    sheet.contours[*contour as usize].bounds = path[0].bounds();
                }
            }
            Move::Air { to: place, .. } if is_there(*place) => *place += by,
            _ => {}
        }
    }
}

#[test]
fn sound_plans_pass() {
    assert_eq!(changed(|_, _| {}), vec![]);
}

#[test]
fn a_cut_too_near_to_a_part_or_through_it_is_found() {
    // The square ends at x 80: 81.9 is nearer than 2 mm, 82.1 is not.
    let near = changed(|sheet, plan| shifted(sheet, plan, 100.0, 81.9));
    assert!(matches!(near[..], [Violation::Skeleton { .. }]), "{near:?}");
    assert_eq!(changed(|sheet, plan| shifted(sheet, plan, 100.0, 82.1)), vec![]);
    let through = changed(|sheet, plan| shifted(sheet, plan, 100.0, 50.0));
    assert!(through.iter().any(|v| matches!(v, Violation::Skeleton { .. })), "{through:?}");
}

#[test]
fn a_part_after_a_skeleton_cut_is_found() {
    let found = changed(|_, plan| {
        // The last skeleton cut, with its way and its piercing, becomes the first of all.
        let end = plan.moves.iter().rposition(|m| matches!(m, Move::Cut { .. })).unwrap();
        let cut: Vec<Move> = plan.moves.drain(end - 2..=end).collect();
        plan.moves.splice(0..0, cut);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::Rank { .. })), "{found:?}");
}

#[test]
fn a_long_cut_without_a_joint_is_found() {
    let found = changed(|sheet, plan| {
        for m in &mut plan.moves {
            let Move::Cut { contour, path, .. } = m else { continue };
            let known = &mut sheet.contours[*contour as usize];
            if let ([Segment::Line(l)], true) = (path.as_mut_slice(), known.skeleton)
                && l.length_is_whole()
            {
                l.end += (l.end - l.start).normalize();
                known.path = Path::new(path.clone(), false);
                known.length += 1.0;
            }
        }
    });
    let long = |v: &Violation| matches!(v, Violation::Beam { what, .. } if what.contains("without a joint"));
    assert!(found.iter().any(long), "{found:?}");
}

trait Whole {
    fn length_is_whole(&self) -> bool;
}

impl Whole for kerfway::geometry::Line {
    /// Whether it runs across the whole sheet.
    fn length_is_whole(&self) -> bool {
        (self.start.distance(self.end) - 200.0).abs() < 1e-9
    }
}

#[test]
fn wrong_sums_are_found() {
    let job = started(square_and_disk(), with(grid(100.0, 100.0))).unwrap();
    let (machine, sheet) = (&job.run().unwrap().machine, job.beam_sheet());
    let plan = job.plan().unwrap();
    let changes: [fn(&mut Plan); 3] = [
        |p| p.summary.skeleton_cuts -= 1,
        |p| p.summary.skeleton_length += 0.01,
        |p| p.summary.skeleton_time *= 1.001,
    ];
    for change in changes {
        let mut wrong = plan.clone();
        change(&mut wrong);
        let found = check(sheet, machine, &wrong).unwrap_err();
        assert!(matches!(found[..], [Violation::Sum { .. }]), "{found:?}");
    }
}
