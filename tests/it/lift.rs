//! Lifting the head for moves with the beam off (`levers.lift`): the seconds by hand, what the search finds, what the checker says
//! of wrong plans, and where the head is in programs.
#![allow(clippy::unwrap_used, reason = "tests stop where they cannot go on")]

use crate::testkit::exact::{planned, search_of_exact_cost};
use crate::testkit::sheets::{Builder, circle, machine, nested_sheet, p, rectangle};
use kerfway::geometry::DVec2;
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{
    Axes, JointRule, Joints, Levers, Lift, Process, Profile, Start, Travel, air_time, presets,
};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::Sheet;

const UP: Lift = Lift { height: 10.0, stay_down: 0.0, at_rest: false };

fn lifting(machine: &Profile, lift: Lift) -> Profile {
    let levers = Levers { lift: Some(lift), ..machine.levers };
    Profile { levers, z_speed: Some(200.0), ..machine.clone() }
}

/// 1000 mm/s and 10,000 mm/s2 on both axes; the head rises 10 mm and sinks again in 0.1 s.
fn simple(travel: Travel, lift: Lift) -> Profile {
    let rapid = Axes { speed: [1000.0; 2], accel: Some([10_000.0; 2]) };
    lifting(&Profile { travel, rapid, ..machine("fibre-3kw-thin") }, lift)
}

/// The length of each air move.
fn hops(plan: &Plan, machine: &Profile) -> Vec<f64> {
    let mut head = machine.home();
    let hops = plan.moves.iter().filter_map(|m| {
        let to = m.end().unwrap_or(head);
        let from = std::mem::replace(&mut head, to);
        matches!(m, Move::Air { .. }).then(|| from.distance(head))
    });
    hops.collect()
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9, "{a} is not {b}");
}

#[test]
fn seconds_by_hand() {
    let seconds = |lift, x, y| air_time(&simple(Travel::Vector, lift), DVec2::ZERO, DVec2::new(x, y));
    // 100 mm at 1000 mm/s are as long as the lift: it costs nothing.
    near(seconds(UP, 100.0, 0.0), 0.1 + 0.1);
    near(seconds(UP, 60.0, 80.0), 0.2);
    // Over 50 mm the head travels with 500 mm/s at most, which takes 0.05 s to reach.
    near(seconds(UP, 50.0, 0.0), 0.1 + 0.05);
    // At rest, 50 mm take two ramps of 25 mm, and the lift its 0.1 s.
    near(seconds(Lift { at_rest: true, ..UP }, 50.0, 0.0), 2.0 * (50.0_f64 / 10_000.0).sqrt() + 0.1);
    // Shorter moves stay down.
    let low = Lift { stay_down: 50.0, ..UP };
    near(seconds(low, 50.0, 0.0), 2.0 * (50.0_f64 / 10_000.0).sqrt());
    near(seconds(low, 50.001, 0.0), 0.1 + 50.001 / 10_000.0 / 0.1);
    near(seconds(UP, 0.0, 0.0), 0.0);
    // With each axis on its own, none moves faster than the z axis follows.
    let each = |x, y| air_time(&simple(Travel::PerAxis, UP), DVec2::ZERO, DVec2::new(x, y));
    near(each(50.0, 20.0), 0.1 + 0.05);
    near(each(0.0, 50.0), 0.1 + 0.05);
}

#[test]
fn a_lift_on_the_way_is_never_slower_than_one_at_rest_and_never_faster_than_none() {
    for travel in [Travel::Vector, Travel::Straight, Travel::PerAxis] {
        for accel in [None, Some([3000.0, 8000.0])] {
            let rapid = Axes { speed: [900.0, 400.0], accel };
            let with = |lift| Profile { rapid, ..simple(travel, lift) };
            let down = Profile { levers: Levers::default(), ..with(UP) };
            for way in [(0.1, 0.0), (3.0, 40.0), (50.0, 1.0), (700.0, 900.0)] {
                let seconds = |m: &Profile| air_time(m, DVec2::ZERO, DVec2::new(way.0, way.1));
                let (none, moving) = (seconds(&down), seconds(&with(UP)));
                let rest = seconds(&with(Lift { at_rest: true, ..UP }));
                assert!(none <= moving + 1e-12 && moving <= rest + 1e-12, "{none} {moving} {rest}");
                near(rest, none + 0.1);
                assert!(moving >= 0.1 - 1e-12);
            }
        }
    }
}

#[test]
fn plans_of_every_machine_pass_the_checker_and_count_their_lifts() {
    let sheet = nested_sheet(12, 3);
    for preset in presets() {
        for travel in [Travel::Vector, Travel::Straight, Travel::PerAxis] {
            for (at_rest, stay_down) in [(false, 0.0), (true, 0.0), (false, 40.0), (true, 40.0), (false, 1e5)]
            {
                let machine =
                    lifting(&Profile { travel, ..preset.clone() }, Lift { height: 8.0, stay_down, at_rest });
                machine.validate().unwrap();
                let plan = planned(&sheet, &machine);
                assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()), "{} {travel:?}", preset.name);
                let lifted = hops(&plan, &machine).into_iter().filter(|d| *d > stay_down + 1e-6).count();
                assert_eq!(plan.summary.lifts as usize, lifted, "{} {stay_down}", preset.name);
            }
        }
    }
}

#[test]
fn the_checker_finds_wrong_lifts() {
    let sheet = nested_sheet(6, 1);
    let machine = lifting(&machine("fibre-3kw-thin"), UP);
    let sums = |found: Result<(), Vec<Violation>>| -> Vec<&'static str> {
        let found = found.unwrap_err().into_iter();
        found.filter_map(|v| if let Violation::Sum { what, .. } = v { Some(what) } else { None }).collect()
    };
    let mut plan = planned(&sheet, &machine);
    plan.summary.lifts -= 1;
    assert_eq!(sums(plan::check(&sheet, &machine, &plan)), ["the number of lifts"]);
    // The seconds of a head that stays down, or is lifted at rest, are not those of this machine.
    for other in [Levers::default(), Levers { lift: Some(Lift { at_rest: true, ..UP }), ..Levers::default() }]
    {
        let mut plan = planned(&sheet, &machine);
        let (parts, lifts) = (plan.summary.parts, plan.summary.lifts);
        plan.summary = plan::evaluate(&plan.moves, &sheet, &Profile { levers: other, ..machine.clone() });
        (plan.summary.parts, plan.summary.lifts) = (parts, lifts);
        assert_eq!(sums(plan::check(&sheet, &machine, &plan)), ["the time of air moves", "the total time"]);
    }
}

#[test]
fn a_lift_needs_the_speed_of_the_z_axis() {
    let machine = lifting(&machine("co2-100w"), UP);
    let message = Profile { z_speed: None, ..machine.clone() }.validate().unwrap_err().to_string();
    assert_eq!(
        message,
        "The machine has levers.lift, but no z_speed. Give the speed of the z axis, or leave out the lift."
    );
    let high = lifting(&machine, Lift { height: 900.0, ..UP }).validate().unwrap_err().to_string();
    assert!(high.contains("\"levers.lift.height\" is 900"), "{high}");
}

#[test]
fn the_search_is_as_good_as_every_order_and_entry_of_six_contours_and_the_bound_holds() {
    for (seed, stay_down) in (0..12).zip([0.0, 30.0, 80.0].into_iter().cycle()) {
        let sheet = nested_sheet(6, seed);
        let lift = Lift { height: 20.0, stay_down, at_rest: seed % 2 == 0 };
        let machine = lifting(&machine("fibre-3kw-thin"), lift);
        let (problem, least, _) = search_of_exact_cost(&sheet, &machine, seed);
        let bound = crate::lower_bound::bound(&problem, f64::INFINITY, 200_000, 1_000);
        assert!(bound <= least + 1e-9, "seed {seed}: {bound} s, {least} s");
    }
}

/// Holes lie exactly as far apart as the head may travel down, wherever the sheet lies.
#[test]
fn equal_holes_of_a_grid_stay_down_wherever_they_lie() {
    let place = |k: u32, by: f64| p(f64::from(k % 4) * 20.0 + by, f64::from(k / 4) * 20.0 + by / 3.0);
    for by in [0.0, 0.1, 17.3, 1234.567] {
        let mut b = Builder::new();
        for k in 0..16 {
            b.cut(circle(place(k, by), 3.0), None);
        }
        let machine = lifting(&machine("fibre-3kw-thin"), Lift { stay_down: 20.0, ..UP });
        let order = [0, 0, 1, 2, 3, 7, 6, 5, 4, 8, 9, 10, 11, 15, 14, 13, 12];
        let centers: Vec<Move> = order.iter().map(|&k| Move::air(place(k, by))).collect();
        let lifts = plan::evaluate(&centers, &b.sheet, &machine).lifts;
        assert_eq!(lifts, u32::from(machine.home().distance(place(0, by)) > 20.0), "{by}");
    }
}

fn small() -> Sheet {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(10.0, 10.0), p(160.0, 90.0)), None);
    b.cut(circle(p(35.0, 25.0), 4.0), Some(plate));
    b.cut(circle(p(47.0, 25.0), 4.0), Some(plate));
    b.mark(rectangle(p(120.0, 60.0), p(5.0, 5.0)), Some(plate));
    b.sheet
}

/// The heights of a program: at each line with a motion, whether the beam may burn there and the height after it.
fn heights(text: &str) -> Vec<(bool, f64)> {
    let mut z = 0.0;
    let lines = text.lines().map(|l| l.split(';').next().unwrap_or(""));
    let mut all = Vec::new();
    for line in lines {
        let words: Vec<&str> = line.split_whitespace().collect();
        if let Some(height) = words.iter().find_map(|w| w.strip_prefix('Z')) {
            z = height.parse().unwrap();
        }
        if words.iter().any(|w| w.starts_with('X')) {
            all.push((words.iter().any(|w| matches!(*w, "G1" | "G2" | "G3")), z));
        }
    }
    all
}

#[test]
fn programs_lift_the_head_on_the_way_and_cut_with_it_down_in_every_dialect() {
    let sheet = small();
    let mut written = 0;
    for (at_rest, stay_down) in [(false, 0.0), (true, 0.0), (false, 25.0), (true, 25.0)] {
        let base = Profile { pierce_time: 0.25, beam_off_delay: 0.01, ..machine("fibre-3kw-thin") };
        let machine = lifting(&base, Lift { height: 12.0, stay_down, at_rest });
        let plan = planned(&sheet, &machine);
        assert!(plan.summary.lifts > 2);
        for dialect in dialects() {
            let profile = Profile { dialect: DialectChoice::named(&dialect.name), ..machine.clone() };
            for start in [Start::Absolute, Start::Current] {
                let result = output::gcode(&plan, &SheetFacts::of(&sheet), &profile, "a.dxf", start);
                if !dialect.z {
                    let refused = result.unwrap_err().to_string();
                    assert!(refused.contains("has no Z axis: switch off lifting"), "{refused}");
                    continue;
                }
                let text = result.unwrap_or_else(|e| panic!("{}: {e}", dialect.name));
                let check = output::check_against(&text, &profile, &plan).unwrap();
                assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
                written += 1;
                if start.is_absolute() {
                    let unit = dialect.units.mm();
                    let all = heights(&text);
                    assert!(all.iter().all(|(cuts, z)| !cuts || *z == 0.0), "{}", dialect.name);
                    let up = all.iter().filter(|(_, z)| (z * unit - 12.0).abs() < 0.01).count();
                    assert_eq!(up, plan.summary.lifts as usize, "{}: {text}", dialect.name);
                    // A head that is left up is found.
                    let left = text.replacen(" Z0", " Z1", 1);
                    let check = output::check_against(&left, &profile, &plan).unwrap();
                    assert!(!check.passed, "{}", dialect.name);
                    let messages: Vec<&str> = check.problems.iter().map(|p| p.message.as_str()).collect();
                    assert!(messages.iter().any(|m| m.contains("cuts with the head lifted")), "{messages:?}");
                }
            }
        }
    }
    assert!(written > 60, "{written} programs");
}

/// LightBurn has no heights between cuts, and its projects did not say that the lift is missing.
#[test]
fn lightburn_shows_that_the_lift_is_not_in_the_project() {
    let sheet = small();
    let note = "The lifts of the head between cuts are not in this project: set the lift in the controller, for every move.";
    let notes = |machine: &Profile| {
        let project = output::lbrn2(&planned(&sheet, machine), &SheetFacts::of(&sheet), machine).unwrap();
        project.matches(note).count()
    };
    let down = machine("fibre-3kw-thin");
    assert_eq!((notes(&down), notes(&lifting(&down, UP))), (0, 1));
}

/// Ruida files have no heights and no ways around tipped pieces. They were written without a word, and the head would have run into
/// what it was to be lifted over.
#[test]
fn ruida_files_refuse_plans_that_lift_the_head() {
    let (sheet, down) = (small(), machine("fibre-3kw-thin"));
    let written = |machine: &Profile| output::rd(&planned(&sheet, machine), &SheetFacts::of(&sheet), machine);
    assert!(written(&down).is_ok());
    let refused = written(&lifting(&down, UP)).unwrap_err().to_string();
    assert!(
        refused.starts_with("Ruida files of Kerfway move the head straight and never lift it: "),
        "{refused}"
    );
}

/// A lowered pass is left at the height of the first, and the lift counts from there.
#[test]
fn deep_passes_and_joints_go_with_a_lift() {
    let base = machine("co2-linuxcnc");
    let cut = Process { passes: 2, z_step: 1.5, ..base.cut };
    let joints = Joints { rules: vec![JointRule { spacing: Some(100.0), ..JointRule::default() }] };
    for base in [Profile { cut, ..base.clone() }, Profile { joints: Some(joints), ..base }] {
        let machine = lifting(&base, Lift { stay_down: 5.0, ..UP });
        let plan = planned(&small(), &machine);
        assert_eq!(plan::check(&small(), &machine, &plan), Ok(()));
        assert!(plan.summary.lifts >= 4, "{:?}", plan.summary);
        let text =
            output::gcode(&plan, &SheetFacts::of(&small()), &machine, "a.dxf", Start::Absolute).unwrap();
        let check = output::check_against(&text, &machine, &plan).unwrap();
        assert!(check.passed, "{:?}", check.problems);
        assert_eq!(text.contains("Z-1.5"), machine.cut.passes == 2);
    }
}
