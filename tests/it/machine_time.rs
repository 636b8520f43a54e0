//! The seconds of cuts against a simulation of GRBL's planner that runs the same programs chord by chord.

use crate::testkit::grbl_planner::{self, Machine, Settings};
use crate::testkit::linuxcnc_planner;
use crate::testkit::outlines::drawing;
use crate::testkit::paths::Element;
use crate::testkit::{files, fixtures, name};
use glam::DVec2;
use kerfway::geometry::{Arc, Segment, math};
use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::{Process, Profile, cut_time, preset};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Speed, acceleration, junction deviation, and how far the seconds of an arc may be off, as a fraction: GRBL makes fewer
/// chords than the arc tolerance asks for, by up to one, which counts on arcs of a few chords on machines that are slow in
/// corners.
const MACHINES: [(f64, f64, f64, f64); 5] = [
    (35.0, 2000.0, 0.01, 0.015),
    (200.0, 2000.0, 0.01, 0.015),
    (400.0, 5000.0, 0.02, 0.015),
    (50.0, 300.0, 0.005, 0.045),
    (30.0, 500.0, 0.001, 0.065),
];

fn element(segment: &Segment) -> Element {
    let arc = match segment {
        Segment::Line(_) => None,
        Segment::Arc(a) => Some((a.center, a.sweep)),
    };
    Element { from: segment.start(), to: segment.end(), arc }
}

/// Seconds of a path: ours, and those of the simulation, which is given arcs of at most half a turn as a program has them.
fn both(path: &[Segment], (speed, accel, deviation): (f64, f64, f64)) -> (f64, f64) {
    let process = Process::new(speed, Some(accel), 1.0);
    let profile = Profile { junction_deviation: Some(deviation), ..preset("co2-100w").unwrap() };
    let halved = path.iter().flat_map(|s| match s {
        Segment::Arc(a) if a.sweep.abs() > PI => vec![s.piece(0.0, 0.5), s.piece(0.5, 1.0)],
        _ => vec![*s],
    });
    let elements: Vec<(Element, f64)> = halved.map(|s| (element(&s), speed)).collect();
    let settings = Settings { accel, junction_deviation: deviation };
    (cut_time(&profile, &process, path), grbl_planner::seconds(settings, &elements))
}

#[test]
fn arcs_take_as_long_as_their_chords_do() {
    for (speed, accel, deviation, limit) in MACHINES {
        for radius in [0.05, 0.1, 0.3, 1.0, 2.5, 7.0, 20.0, 60.0, 400.0, 3000.0, 20_000.0] {
            for sweep in [0.1, FRAC_PI_2, PI, TAU] {
                let arc = Segment::Arc(Arc::from_angles(DVec2::new(3.0, 4.0), radius, 0.3, sweep));
                let (ours, grbl) = both(&[arc], (speed, accel, deviation));
                assert!(
                    (ours / grbl - 1.0).abs() <= limit,
                    "{ours} s, GRBL {grbl} s: radius {radius}, sweep {sweep}, {speed} mm/s, {accel} mm/s2, {deviation} mm"
                );
            }
        }
    }
}

#[test]
fn paths_of_lines_and_arcs_take_as_long_as_their_chords_do() {
    for (speed, accel, deviation, limit) in MACHINES {
        for radius in [0.2, 1.0, 4.0, 25.0] {
            // A slot with a corner at one end: tangent joins, and joins at an angle.
            let p = |x: f64, y: f64| DVec2::new(x, y);
            let turn = Segment::Arc(Arc::from_angles(p(30.0, radius), radius, -FRAC_PI_2, PI));
            let bow = Segment::Arc(Arc::from_angles(p(0.0, radius), radius, FRAC_PI_2 + 0.4, PI - 0.8));
            let path = [
                Segment::line(p(0.0, 0.0), turn.start()),
                turn,
                Segment::line(turn.end(), bow.start()),
                bow,
                Segment::line(bow.end(), p(0.0, 0.0)),
            ];
            let (ours, grbl) = both(&path, (speed, accel, deviation));
            let off = (ours / grbl - 1.0).abs();
            assert!(off <= limit, "{ours} s, GRBL {grbl} s: radius {radius}, {speed} mm/s, {deviation} mm");
        }
    }
}

/// With the kerf, an outline with jogs of a few micrometres has arcs of half a kerf of which GRBL makes one chord each. They counted as
/// slow as long arcs, and the program was refused because it took less time than planned.
#[test]
fn arcs_of_less_than_two_chords_take_as_long_as_lines() {
    let machines = MACHINES.into_iter().filter(|m| m.2 >= 0.005);
    for (speed, accel, deviation, _) in machines {
        for sweep in [0.05, 0.15, 0.3, 0.39, 0.7] {
            // Lines of 3 mm with jogs between them: an arc to the left, and one to the right.
            let mut path = vec![Segment::line(DVec2::ZERO, DVec2::X * 3.0)];
            for _ in 0..20 {
                for turn in [sweep, -sweep] {
                    let from = path.last().map_or(DVec2::ZERO, Segment::end);
                    let at = if turn > 0.0 { -FRAC_PI_2 } else { FRAC_PI_2 + sweep };
                    let center = from - math::unit(at) * 0.1;
                    path.push(Segment::Arc(Arc::from_angles(center, 0.1, at, turn)));
                }
                let from = path.last().map_or(DVec2::ZERO, Segment::end);
                path.push(Segment::line(from, from + DVec2::X * 3.0));
            }
            let (ours, grbl) = both(&path, (speed, accel, deviation));
            let off = ours / grbl - 1.0;
            assert!(
                off.abs() <= 0.01,
                "{ours} s, GRBL {grbl} s: sweep {sweep}, {speed} mm/s, {deviation} mm"
            );
        }
    }
}

/// Every drawing that can be planned, on a machine: name, seconds in all, of its cuts, and of the cuts in the simulation.
fn drawings(machine: &str) -> Vec<(String, f64, f64, f64)> {
    let profile = preset(machine).unwrap();
    let settings = Settings {
        accel: profile.cut.accel.unwrap(),
        junction_deviation: profile.junction_deviation.unwrap(),
    };
    let planned = |file: std::path::PathBuf| {
        let name = name(&file);
        let mut job = Job::load(std::fs::read(&file).unwrap(), &name, &LoadOptions::default()).ok()?;
        let machine = MachineChoice::Preset(machine.to_owned());
        job.start(&PlanOptions { machine, allow_off_bed: true, moves: Some(2000), ..PlanOptions::default() })
            .ok()?;
        job.run_mut().unwrap().step(2000);
        let summary = job.plan().unwrap().summary;
        let program = crate::testkit::gcode::run(&job.output(OutputKind::Gcode).unwrap()).unwrap();
        let grbl = grbl_planner::work_seconds(settings, &program);
        Some((name, summary.total_time, summary.cut_time, grbl))
    };
    let folder = std::env::var_os("KERFWAY_DRAWINGS").map_or(fixtures().join("dxf-dev"), Into::into);
    files(&folder, "dxf").into_iter().filter_map(planned).collect()
}

/// The rounding of a program to 0.001 mm and the whole number of chords are in the simulation only.
/// `KERFWAY_DRAWINGS=FOLDER cargo test --features png --test it machine_time -- --nocapture` prints the table.
#[test]
#[allow(clippy::print_stdout, reason = "the table of the comparison, shown with --nocapture")]
fn real_drawings_take_as_long_as_in_a_simulation_of_the_planner() {
    for machine in ["co2-100w", "diode-hobby", "fibre-3kw-thin"] {
        for (name, total, cut, grbl) in drawings(machine) {
            let (simulated, off) = (total - cut + grbl, (cut - grbl) / total);
            println!(
                "{machine:<14} {name:<55.55} {total:>9.2} s, GRBL {simulated:>9.2} s, {:+.2} %",
                100.0 * off
            );
            assert!(off.abs() <= 0.003, "{name} on {machine}: {total} s, GRBL {simulated} s");
        }
    }
}

/// Blocks that GRBL looks ahead.
const BLOCKS: usize = 16;
/// Tolerance of LinuxCNC's blending, G64 P, mm.
const BLEND: f64 = 0.02;
/// A machine that cuts four times as fast as its class, without piercing and delays.
const FAST: &str = "diode, 20 mm/s";

/// The machines of the comparison: presets with GRBL's way of moving, and two with slower drives.
fn compared() -> Vec<Profile> {
    let with = |name: &str, preset: &str, change: fn(&mut Profile)| {
        let mut p = kerfway::machine::preset(preset).unwrap();
        change(&mut p);
        Profile { name: name.into(), bed: None, ..p }
    };
    vec![
        with("co2-100w", "co2-100w", |_| {}),
        with("diode-hobby", "diode-hobby", |_| {}),
        with("co2-fluidnc", "co2-fluidnc", |_| {}),
        with("co2, heavy gantry", "co2-100w", |p| {
            (p.rapid.accel, p.cut.accel, p.mark.accel) = (Some([800.0, 500.0]), Some(500.0), Some(500.0));
        }),
        with(FAST, "diode-hobby", |p| p.cut.speed = 20.0),
    ]
}

/// `total_time` and the program of every drawing that can be planned on a machine.
fn programs(profile: &Profile) -> Vec<(String, f64, crate::testkit::gcode::Program)> {
    let folder = std::env::var_os("KERFWAY_DRAWINGS").map_or(fixtures().join("dxf-dev"), Into::into);
    let sheets = fixtures().join("sheets/sheet_100.dxf");
    let planned = |file: std::path::PathBuf| {
        let name = name(&file);
        let mut job = Job::load(std::fs::read(&file).unwrap(), &name, &LoadOptions::default()).ok()?;
        let machine = MachineChoice::Profile(Box::new(profile.clone()));
        job.start(&PlanOptions { machine, moves: Some(2000), ..PlanOptions::default() }).ok()?;
        job.run_mut().unwrap().step(2000);
        let program = crate::testkit::gcode::run(&job.output(OutputKind::Gcode).unwrap()).unwrap();
        Some((name, job.plan().unwrap().summary.total_time, program))
    };
    files(&folder, "dxf").into_iter().chain([sheets]).filter_map(planned).collect()
}

/// `total_time` against whole programs in the simulation with a buffer of 16 blocks, and LinuxCNC's blending for comparison.
/// `cargo test --features png --test it machine_time -- whole_programs --nocapture` prints the table of docs/internals/times.md.
#[test]
#[allow(clippy::print_stdout, reason = "the table of the comparison, shown with --nocapture")]
fn whole_programs_take_as_long_as_in_a_simulation_with_a_buffer_of_sixteen_blocks() {
    println!(
        "| Machine | Drawings | Median | Worst | Worst drawing | With a stop at each rapid, worst | LinuxCNC, median |\n|---|---|---|---|---|---|---|"
    );
    let by_size = |a: &f64, b: &f64| a.abs().total_cmp(&b.abs());
    let mut all: Vec<f64> = Vec::new();
    for profile in compared() {
        let machine = Machine {
            rapid_speed: profile.rapid.speed,
            rapid_accel: profile.rapid.accel.unwrap(),
            accel: profile.cut.accel.unwrap(),
            junction_deviation: profile.junction_deviation.unwrap(),
            blocks: BLOCKS,
            stops: false,
        };
        let programs = programs(&profile);
        let off_from = |seconds: &dyn Fn(&crate::testkit::gcode::Program) -> f64| -> Vec<f64> {
            programs.iter().map(|(_, total, program)| total / seconds(program) - 1.0).collect()
        };
        let off = off_from(&|program| grbl_planner::program_seconds(machine, program));
        let stopping =
            off_from(&|program| grbl_planner::program_seconds(Machine { stops: true, ..machine }, program));
        let blended = off_from(&|program| linuxcnc_planner::program_seconds(machine, BLEND, program));
        let worst = (0..off.len()).max_by(|a, b| by_size(&off[*a], &off[*b])).unwrap();
        let sorted = |mut values: Vec<f64>| {
            values.sort_by(by_size);
            values
        };
        let (median, blended) = (sorted(off.clone()), sorted(blended));
        let most = *sorted(stopping).last().unwrap();
        println!(
            "| {} | {} | {:.2} % | {:+.2} % | {} | {:+.2} % | {:.2} % |",
            profile.name,
            off.len(),
            100.0 * median[off.len() / 2].abs(),
            100.0 * off[worst],
            programs[worst].0,
            100.0 * most,
            100.0 * blended[off.len() / 2].abs(),
        );
        // Nothing but stops is missing in the plan's sums, on every machine; and no job takes longer than planned.
        assert!(most.abs() <= 0.005, "{}: {most} with a stop at each rapid", profile.name);
        assert!(off.iter().all(|o| *o > -0.005), "{}: a job takes longer than planned", profile.name);
        // Without dwells, the controller runs through contours that nearly touch, which a plan takes as stops. On the one
        // drawing of hundreds of tiny marks this is 6 % on this machine: docs/internals/times.md.
        if profile.name != FAST {
            all.extend(off);
        }
    }
    all.sort_by(by_size);
    let (median, worst) = (all[all.len() / 2].abs(), all[all.len() - 1].abs());
    println!("All: median {:.2} %, worst {:.2} %", 100.0 * median, 100.0 * worst);
    assert!(median <= 0.02 && worst <= 0.05, "median {median}, worst {worst}");
}

/// With a buffer without end, the simulation of one contour is that of the whole planner.
#[test]
fn a_buffer_without_end_gives_the_seconds_of_the_endless_look_ahead() {
    let program = crate::testkit::gcode::run(
        "G21 G90 G91.1 G17 G94\nM4 S0\nG1 X10 Y0 F3000 S500\nG1 X10 Y10\nG3 X0 Y10 I-5 J0\nG1 X0.5 Y3\nG1 X0 Y0\nM2\n",
    )
    .unwrap();
    let settings = Settings { accel: 1000.0, junction_deviation: 0.01 };
    let machine = |blocks| Machine {
        rapid_speed: [100.0; 2],
        rapid_accel: [1000.0; 2],
        accel: 1000.0,
        junction_deviation: 0.01,
        blocks,
        stops: false,
    };
    let endless = grbl_planner::work_seconds(settings, &program);
    let whole = grbl_planner::program_seconds(machine(usize::MAX / 2), &program);
    assert!((whole - endless).abs() < 1e-9, "{whole} {endless}");
    let short = grbl_planner::program_seconds(machine(3), &program);
    assert!(short > endless, "fewer blocks never are faster: {short} {endless}");
}

/// Rounding would turn lines of a few micrometres into other directions, with a corner between each two of them.
#[test]
fn a_circle_of_thousands_of_short_lines_takes_as_long_as_planned() {
    let at = |k: u32| Arc::from_angles(DVec2::new(50.0, 50.0), 10.0, TAU * f64::from(k) / 8000.0, 1.0).start;
    let ring: Vec<DVec2> = (0..8000).map(at).collect();
    let mut job = Job::load(drawing(&[ring]), "ring.dxf", &LoadOptions::default()).unwrap();
    let machine = MachineChoice::Preset("fibre-3kw-thin".into());
    job.start(&PlanOptions { machine, moves: Some(100), ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(100);
    let (program, plan) = (job.preflight().unwrap().seconds, job.plan().unwrap().summary.total_time);
    assert!((program / plan - 1.0).abs() < 0.005, "{program} s, planned {plan} s");
}
