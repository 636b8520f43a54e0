//! Programs that other people's readers have read: LinuxCNC's `rs274`, and MeerK40t's of Ruida files and of LightBurn projects.
//! They ran once, by `rs274.py`, `rdjob.py` and `lbrn2.py` in `tests/oracle`, which recorded what they found. Here the programs
//! are written again, and must be the same.
//!
//! After a change of programs: `KERFWAY_PROGRAMS=FOLDER cargo test --features png --test it recorded` writes them to a folder, then
//! the scripts with that folder record again.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::testkit::{files, fixtures, name, plans};
use kerfway::geometry::Segment;
use kerfway::job::{Job, LayerChoice, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::dialect::DialectChoice;
use kerfway::machine::{Profile, Start};
use kerfway::output;
use kerfway::plan::Move;
use kerfway::sheet::{LayerUse, Operation};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::fs;
use std::path::Path;

/// Samples that came after the last recording. Their programs hold nothing that those of other drawings do not: lines and arcs.
const NOT_RECORDED: &[&str] = &["perforated.dxf", "held-plates.dxf", "tips-and-skeleton.dxf"];

/// Plans every drawing and the samples, and calls `visit` with the name, the job and its machine. `set` gives the settings of
/// the first layer.
fn each(set: Option<fn(&mut LayerChoice)>, mut visit: impl FnMut(&str, &Job, &Profile)) {
    let machine =
        Profile { pierce_time: 0.25, beam_on_delay: 0.004, beam_off_delay: 0.002, ..plans::machine() };
    let samples = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/app/public/samples");
    let all = files(&fixtures().join("dxf-dev"), "dxf").into_iter().chain(files(&samples, "dxf"));
    for file in all.filter(|f| !NOT_RECORDED.contains(&name(f).as_str())) {
        let load = |options: &LoadOptions| Job::load(fs::read(&file).unwrap(), &name(&file), options);
        let Ok(mut job) = load(&LoadOptions::default()) else { continue };
        let used = |l: &&LayerUse| l.operation != Operation::Ignore && l.contours > 0;
        let first = job.sheet().layers.iter().find(used).map(|l| LayerChoice::new(&l.name, l.operation));
        if let (Some(set), Some(mut choice)) = (set, first) {
            set(&mut choice);
            job = load(&LoadOptions { layers: vec![choice], ..LoadOptions::default() }).unwrap();
        }
        let options = PlanOptions {
            machine: MachineChoice::Profile(Box::new(machine.clone())),
            seed: 1,
            moves: Some(50),
            ..PlanOptions::default()
        };
        if job.start(&options).is_ok() {
            job.run_mut().unwrap().step(50);
            visit(&name(&file), &job, &machine);
        }
    }
}

fn recorded(file: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(fixtures().join("recorded").join(file)).unwrap()).unwrap()
}

/// Writes a file for the scripts, if they ask for it.
fn hand_out(name: &str, bytes: &[u8]) -> bool {
    let Some(folder) = std::env::var_os("KERFWAY_PROGRAMS") else { return false };
    fs::create_dir_all(&folder).unwrap();
    fs::write(Path::new(&folder).join(name), bytes).unwrap();
    true
}

fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|b| format!("{b:02x}")).collect()
}

#[test]
fn linuxcnc_has_run_these_programs_and_waited_as_long_as_planned() {
    let record = recorded("rs274.json");
    let mut compared = 0;
    each(None, |name, job, machine| {
        for dialect in ["linuxcnc-m67", "linuxcnc-spindle"] {
            let profile = Profile { dialect: DialectChoice::named(dialect), ..machine.clone() };
            let plan = job.plan().unwrap();
            let text = output::gcode(
                &plan,
                &output::SheetFacts::of(job.beam_sheet()),
                &profile,
                name,
                Start::Absolute,
            )
            .unwrap();
            // The comments hold the version.
            let code: String =
                text.lines().filter(|l| !l.starts_with(';')).map(|l| format!("{l}\n")).collect();
            let program = format!("{name}.{dialect}.ngc");
            if hand_out(&program, code.as_bytes()) {
                continue;
            }
            let run = &record["programs"][&program];
            assert_eq!(run["sha256"], hash(code.as_bytes()), "{program} has changed: record it again");
            assert_eq!(run["exit"], 0, "{program}");
            let waited = run["dwell"].as_f64().unwrap();
            let planned = plan.summary.pierce_time + plan.summary.macro_time;
            assert!((waited - planned).abs() <= 0.001, "{program} waits {waited} s, not {planned}");
            compared += 1;
        }
    });
    assert!(compared >= 48 || std::env::var_os("KERFWAY_PROGRAMS").is_some(), "{compared} programs");
}

#[test]
fn meerk40t_has_read_these_ruida_files_as_planned() {
    meerk40t_has_read("rd", "rdjob.json", |job| job.output_bytes(OutputKind::Rd).unwrap());
}

#[test]
fn meerk40t_has_read_these_lightburn_projects_as_planned() {
    meerk40t_has_read("lbrn2", "lbrn2.json", |job| job.output(OutputKind::Lbrn2).unwrap().into_bytes());
}

/// Compares the files that `write` writes with what a script has recorded of them.
fn meerk40t_has_read(ending: &str, record: &str, write: impl Fn(&Job) -> Vec<u8>) {
    let record = recorded(record);
    let mut compared = 0;
    let set = |layer: &mut LayerChoice| {
        (layer.speed, layer.power, layer.min_power, layer.passes) =
            (Some(12.5), Some(0.45), Some(0.2), Some(2));
    };
    each(Some(set), |name, job, machine| {
        let bytes = write(job);
        let program = format!("{name}.{ending}");
        if hand_out(&program, &bytes) {
            hand_out(&format!("{program}.json"), planned(job, machine).to_string().as_bytes());
            return;
        }
        let run = &record["files"][&program];
        assert_eq!(run["sha256"], hash(&bytes), "{program} has changed: record it again");
        assert!(run["off"].as_f64().unwrap() <= 0.002, "{program}: {run}");
        let cuts = planned(job, machine)["cuts"].as_array().unwrap().len();
        assert_eq!(run["cuts"], cuts, "{program}");
        assert_eq!(run["settings"], true, "{program}: speed and powers");
        compared += 1;
    });
    assert!(compared >= 24 || std::env::var_os("KERFWAY_PROGRAMS").is_some(), "{compared} files");
}

/// The plan as the script compares it: of each cut its elements, speed in mm/s and power in per cent.
fn planned(job: &Job, machine: &Profile) -> Value {
    let element = |s: &Segment| match s {
        Segment::Line(l) => json!({ "to": [l.end.x, l.end.y] }),
        Segment::Arc(a) => {
            json!({ "to": [a.end.x, a.end.y], "center": [a.center.x, a.center.y], "sweep": a.sweep })
        }
    };
    let cuts: Vec<Value> = job
        .plan()
        .unwrap()
        .moves
        .iter()
        .filter_map(|m| {
            let Move::Cut { path, contour, .. } = m else { return None };
            let (start, process) = (path.first()?.start(), job.beam_sheet().process_by_id(*contour, machine));
            let path: Vec<Value> = path.iter().map(element).collect();
            let least = process.min_power.unwrap_or(process.power);
            Some(json!({
                "from": [start.x, start.y], "path": path,
                "speed": process.speed, "power": process.power * 100.0, "least": least * 100.0,
            }))
        })
        .collect();
    json!({ "cuts": cuts })
}
