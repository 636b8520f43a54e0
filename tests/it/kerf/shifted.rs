//! Parts that a small shift would bring one kerf from a neighbour: offered, or shifted (`levers.common_cuts.shift`).

use super::made::{KERF, bulged, spaced, started};
use super::together::{random, together};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use kerfway::finding::{Code, Finding};
use kerfway::geometry::{Aabb, DVec2};
use kerfway::job::Job;
use kerfway::machine::{Profile, SharedCuts};

pub(super) fn shifting(shift: f64, shift_parts: bool) -> Profile {
    let mut machine = together("fibre-6kw-thick");
    machine.levers.common_cuts = Some(SharedCuts { shift, shift_parts });
    machine
}

fn found(job: &Job) -> Vec<Finding> {
    job.run().unwrap().findings.iter().filter(|f| f.code == Code::PartShift).cloned().collect()
}

/// The outlines as they are made, by contour, as boxes.
pub(super) fn made(job: &Job) -> Vec<Aabb> {
    let drawn = |c: &kerfway::sheet::Contour| c.drawn.as_ref().unwrap_or(&c.path).bounds();
    job.beam_sheet().contours.iter().take(job.sheet().contours.len()).map(drawn).collect()
}

/// The distance between two boxes.
fn apart(a: Aabb, b: Aabb) -> f64 {
    (a.min - b.max).max(b.min - a.max).max(DVec2::ZERO).length()
}

#[test]
fn a_shift_is_offered_and_nothing_moves() {
    let bytes = drawing(&spaced(3, 2, KERF + 0.1));
    let job = started(bytes.clone(), shifting(0.5, false));
    let offers = found(&job);
    // All but one, which is in the middle: the others move the least if they move to it.
    let said: Vec<String> = offers.iter().map(|f| f.message.clone()).collect();
    assert_eq!(offers.len(), 5, "{said:?}");
    let first = "Shifted by (-0.100, 0.000) mm, this part would stand one kerf from a neighbour. It stays where it is drawn.";
    assert!(said.iter().any(|s| s == first), "{said:?}");
    let corner = offers.iter().find(|f| f.at.map(|p| p.round()) == Some(DVec2::new(141.0, 111.0))).unwrap();
    assert!(corner.message.contains("(-0.100, "), "{}", corner.message);
    // Of two, the one at the lower left stays.
    let two = found(&started(drawing(&spaced(2, 1, KERF + 0.1)), shifting(0.5, false)));
    assert_eq!(two.iter().map(|f| f.message.as_str()).collect::<Vec<_>>(), [first]);
    let plan = job.plan().unwrap().summary;
    assert_eq!(plan.pierces, 6);
    let without = started(bytes, together("fibre-6kw-thick"));
    assert!(found(&without).is_empty());
    assert_eq!(without.plan().unwrap().summary.total_time.to_bits(), plan.total_time.to_bits());
}

#[test]
fn accepted_the_parts_are_moved_and_cut_together() {
    let job = started(drawing(&spaced(3, 2, KERF + 0.1)), shifting(0.5, true));
    let moved = found(&job);
    assert_eq!(moved.len(), 5);
    assert!(moved.iter().all(|f| f.message.starts_with("This part is shifted by (")), "{moved:?}");
    let plan = job.plan().unwrap().summary;
    let union = 3.0 * 3.0 * (20.0 + KERF) + 4.0 * 2.0 * (10.0 + KERF);
    assert_eq!(plan.pierces, 1);
    assert!((plan.cut_length - union).abs() < 1e-6, "{} {union}", plan.cut_length);
    // The drawing is as it was.
    assert_eq!(job.sheet().contours[5].bounds.min.round(), DVec2::new(141.0, 111.0));
    // No further than the machine says: of three in a row, two move to the one between them; of four, one would have to move by 0.2 mm.
    for (count, moved, pierces) in [(3, 2, 1), (4, 2, 2)] {
        let job = started(drawing(&spaced(count, 1, KERF + 0.1)), shifting(0.15, true));
        assert_eq!((found(&job).len(), job.plan().unwrap().summary.pierces), (moved, pierces), "{count}");
    }
}

#[test]
fn nothing_is_moved_against_a_neighbour() {
    // A disc to the left stands nearer than the side that the part would move to.
    let side = [[0.0, 0.0, 0.0], [20.0, 0.0, 0.0], [20.0, 30.0, 0.0], [0.0, 30.0, 0.0]];
    let moved: Vec<[f64; 3]> = side.iter().map(|[x, y, b]| [x + 20.0 + KERF + 0.3, *y + 5.0, *b]).collect();
    let job = started(bulged(&[&side, &moved], &[]), shifting(0.5, true));
    assert_eq!(found(&job).len(), 1);
    let disc = [20.0 + KERF + 0.3 - KERF - 0.1 - 4.0, 35.0 + 4.0 - 5.0, 3.9];
    let job = started(bulged(&[&side, &moved], &[disc]), shifting(0.5, true));
    assert!(found(&job).is_empty(), "{:?}", found(&job));
    // Nor are parts moved that stand nearer than a kerf.
    let near = [rectangle([0.0, 0.0, 20.0, 20.0]), rectangle([20.0 + KERF - 0.2, 0.0, 20.0, 20.0])];
    assert!(found(&started(drawing(&near), shifting(0.5, true))).is_empty());
}

#[test]
fn of_thirty_nests_no_part_overlaps_after_the_shift() {
    let (mut all, mut saved) = (0, 0.0);
    for seed in 0..30 {
        let bytes = drawing(&random(seed, KERF + 0.05 + 0.01 * (seed % 20) as f64));
        let drawn = started(bytes.clone(), shifting(1.0, false));
        let job = started(bytes, shifting(1.0, true));
        assert_eq!(found(&drawn).len(), found(&job).len(), "seed {seed}");
        all += found(&job).len();
        let (before, after) = (made(&drawn), made(&job));
        let outer: Vec<usize> =
            (0..before.len()).filter(|&c| job.sheet().contours[c].inside.is_none()).collect();
        for &a in &outer {
            assert!((after[a].min - before[a].min).length() <= 1.0 + 1e-9, "seed {seed}: {a}");
            assert!((after[a].size() - before[a].size()).length() < 1e-9, "seed {seed}: {a}");
            for &b in outer.iter().filter(|&&b| b > a) {
                assert!(apart(after[a], after[b]) >= KERF - 1e-6, "seed {seed}: {a} {b}");
            }
        }
        for (hole, around) in
            job.sheet().contours.iter().enumerate().filter_map(|(k, c)| Some((k, c.inside? as usize)))
        {
            let of = |boxes: &[Aabb]| boxes[hole].min - boxes[around].min;
            assert!((of(&before) - of(&after)).length() < 1e-9, "seed {seed}: holes move with their part");
        }
        let (then, now) = (drawn.plan().unwrap().summary, job.plan().unwrap().summary);
        assert!(now.cut_length <= then.cut_length + 1e-6, "seed {seed}");
        saved += 1.0 - now.total_time / then.total_time;
    }
    assert!(all > 60 && saved > 1.0, "{all} {saved}");
}
