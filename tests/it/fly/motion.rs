//! Seconds of cuts on the run against a simulation of the motion.

use super::{checked, flying, plate, round, square};
use crate::testkit::gcode;
use crate::testkit::grbl_planner::{self, Machine, Settings};
use crate::testkit::paths::Element;
use crate::testkit::sheets::{circle, machine};
use kerfway::geometry::Segment;
use kerfway::machine::{Levers, MovingPierce, Profile, Start};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{Move, Plan};
use kerfway::sheet::Sheet;

/// Seconds of the program of a plan in a simulation of a controller that looks ahead over `blocks` lines.
fn simulated(sheet: &Sheet, machine: &Profile, plan: &Plan, blocks: usize) -> f64 {
    let text = output::gcode(plan, &SheetFacts::of(sheet), machine, "plate.dxf", Start::Absolute).unwrap();
    let program = gcode::run(&text).unwrap();
    let [ax, ay] = machine.rapid.accel.unwrap();
    let told = Machine {
        rapid_speed: machine.rapid.speed,
        rapid_accel: [ax, ay],
        accel: machine.cut.accel.unwrap(),
        junction_deviation: machine.junction_deviation.unwrap(),
        blocks,
        stops: true,
    };
    grbl_planner::program_seconds(told, &program)
}

#[test]
fn ten_thousand_holes_on_the_run_take_as_long_as_a_simulation_of_the_motion_says() {
    let sheet = plate(100, 100, 6.0, 0.0, round);
    let rest = machine("fibre-3kw-thin");
    let moving = Levers { moving_pierce: Some(MovingPierce { overcut: 0.0 }), ..Levers::default() };
    let moving = Profile { levers: moving, ..rest.clone() };
    let mut seconds = Vec::new();
    for (name, machine) in
        [("hole by hole", rest), ("moving pierce", moving), ("on the run", flying(20.0, 0.0))]
    {
        let plan = checked(&sheet, &machine);
        // The longest braking is over 16 mm, 110 chords of such a hole.
        let run = simulated(&sheet, &machine, &plan, 200);
        let planned = plan.summary.total_time;
        println!("{name}: {planned:.1} s, simulated {run:.1} s");
        assert!((run / planned - 1.0).abs() < 0.02, "{name}: {planned} s, simulated {run} s");
        seconds.push(planned);
    }
    assert!(seconds[2] < 0.5 * seconds[1] && seconds[2] < 0.3 * seconds[0], "{seconds:?}");
}

#[test]
fn grids_take_as_long_as_a_simulation_of_the_motion_says() {
    let machine = flying(20.0, 0.3);
    for sheet in [plate(12, 9, 20.0, 0.0, square), plate(12, 9, 20.0, 0.4, |at, _| circle(at, 4.0))] {
        let plan = checked(&sheet, &machine);
        assert!(plan.summary.fly_cuts > 0);
        let element = |s: &Segment| Element {
            from: s.start(),
            to: s.end(),
            arc: if let Segment::Arc(a) = s { Some((a.center, a.sweep)) } else { None },
        };
        let (mut run, mut seconds) = (Vec::new(), 0.0);
        let settings = Settings { accel: 5000.0, junction_deviation: 0.02 };
        for m in &plan.moves {
            match m {
                Move::Cut { path, .. } | Move::Fly { path } => {
                    let halves = path.iter().flat_map(|s| [s.piece(0.0, 0.5), s.piece(0.5, 1.0)]);
                    run.extend(halves.map(|s| (element(&s), 400.0)));
                }
                _ => seconds += grbl_planner::seconds(settings, &std::mem::take(&mut run)),
            }
        }
        let off = seconds / plan.summary.cut_time - 1.0;
        assert!(off.abs() < 0.015, "{seconds} s, planned {}", plan.summary.cut_time);
    }
}
