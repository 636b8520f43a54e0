//! What each layer and material does: seconds by hand, passes, heights, and what the checker says to plans that do otherwise.
#![allow(clippy::float_cmp, reason = "numbers that are exact, or must not change at all")]

use crate::testkit::gcode;
use kerfway::finding::Code;
use kerfway::job::{Job, JobError, LayerChoice, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::{Axes, MaterialSetting, Process, Profile, Settings, Start, preset};
use kerfway::plan::document::Document;
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::quote::{Material, Terms};
use kerfway::sheet::{Operation, PassOrder};

/// A machine without accelerations: 10 mm/s to cut, 50 mm/s to mark, 100 mm/s rapids, 0.5 s to pierce, 0.1 s of delays.
fn machine() -> Profile {
    Profile {
        bed: None,
        rapid: Axes { speed: [100.0; 2], accel: None },
        cut: Process::new(10.0, None, 0.8),
        mark: Process::new(50.0, None, 0.2),
        junction_deviation: None,
        pierce_time: 0.5,
        beam_on_delay: 0.06,
        beam_off_delay: 0.04,
        z_speed: Some(5.0),
        ..preset("co2-100w").unwrap()
    }
}

/// A square of 100 mm on layer CUT with a square of 20 mm in it on layer INNER, and a line of 50 mm on layer LINE.
fn drawing() -> Vec<u8> {
    let square = |layer: &str, x: f64, a: f64| {
        let corners = [(x, x), (x + a, x), (x + a, x + a), (x, x + a)];
        let points: String = corners.iter().map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).collect();
        format!("0\nLWPOLYLINE\n8\n{layer}\n90\n4\n70\n1\n{points}")
    };
    let line = "0\nLINE\n8\nLINE\n10\n120\n20\n10\n11\n170\n21\n10\n";
    let entities = [square("CUT", 0.0, 100.0), square("INNER", 40.0, 20.0), line.to_owned()].concat();
    format!("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n")
        .into_bytes()
}

fn layer(name: &str, settings: impl FnOnce(&mut LayerChoice)) -> LayerChoice {
    let mut layer = LayerChoice::new(name, Operation::Cut);
    settings(&mut layer);
    layer
}

fn options(machine: Profile) -> PlanOptions {
    let machine = MachineChoice::Profile(Box::new(machine));
    PlanOptions { machine, seed: 1, moves: Some(20_000), allow_off_bed: true, ..PlanOptions::default() }
}

fn planned(layers: Vec<LayerChoice>, pass_order: PassOrder, machine: Profile) -> Job {
    let load = LoadOptions { layers, pass_order, ..LoadOptions::default() };
    let mut job = Job::load(drawing(), "job.dxf", &load).unwrap();
    job.start(&options(machine)).unwrap();
    job.run_mut().unwrap().step(20_000);
    job
}

fn document(job: &Job) -> Document {
    Document::read(&job.output(OutputKind::Json).unwrap()).unwrap()
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9 * b.abs().max(1.0), "{a} is not {b}");
}

#[test]
fn a_layer_has_a_speed_and_an_operation_of_its_own() {
    let layers = vec![
        layer("INNER", |l| l.speed = Some(4.0)),
        layer("LINE", |l| (l.operation, l.speed) = (Some(Operation::Mark), Some(25.0))),
    ];
    let s = planned(layers, PassOrder::Contour, machine()).plan().unwrap().summary;
    near(s.cut_time, 400.0 / 10.0 + 80.0 / 4.0 + 50.0 / 25.0);
    // Two cuts are pierced, and all three have the delays of the beam.
    near(s.pierce_time, 2.0 * 0.5 + 3.0 * 0.1);
}

#[test]
fn a_material_changes_the_seconds_as_computed_by_hand() {
    let setting = |name: &str, speed| MaterialSetting {
        name: name.into(),
        cut: Settings { speed: Some(speed), passes: Some(2), ..Settings::NONE },
        mark: Settings::NONE,
        pierce_time: Some(0.25),
        kerf_width: None,
    };
    let machine = Profile { materials: vec![setting("4 mm ply", 8.0), setting("Card", 80.0)], ..machine() };
    let planned = |material: Option<&str>| {
        let mut job = Job::load(drawing(), "job.dxf", &LoadOptions::default()).unwrap();
        let material = material.map(str::to_owned);
        job.start(&PlanOptions { material, ..options(machine.clone()) }).map(|_| ())?;
        Ok::<_, JobError>(job)
    };
    let own = planned(None).unwrap().plan().unwrap().summary;
    near(own.cut_time, 530.0 / 10.0);
    near(own.pierce_time, 3.0 * 0.6);
    let job = planned(Some("4 MM ply")).unwrap();
    let ply = job.plan().unwrap().summary;
    near(ply.cut_time, 2.0 * 530.0 / 8.0);
    near(ply.pierce_time, 2.0 * 3.0 * (0.25 + 0.1));
    let written = document(&job);
    assert_eq!(written.material.as_deref(), Some("4 MM ply"));
    assert_eq!((written.machine.cut.speed, written.machine.materials.len()), (8.0, 0));
    assert_eq!(
        planned(Some("oak")).err().unwrap().to_string(),
        "The machine co2-100w has no setting for the material \"oak\". It has: 4 mm ply, Card."
    );
    // Names are the same as in the search for a material, beyond ASCII too: otherwise the second one could not be chosen.
    let twice = vec![setting("Möbelplatte", 8.0), setting("MÖBELPLATTE ", 9.0)];
    assert_eq!(
        Profile { materials: twice, ..machine.clone() }.validate().err().unwrap().to_string(),
        "The machine's materials: two are named \"MÖBELPLATTE\". Give each a name of its own."
    );
    // A quote for another material than was planned is refused instead of priced with the wrong speed.
    let quote = |job: &Job, name: &str| {
        job.quote(&Material { name: Some(name.into()), ..Material::default() }.into())
    };
    assert!(quote(&job, "4 mm ply").is_ok());
    assert!(
        quote(&job, "mild steel")
            .unwrap_err()
            .to_string()
            .starts_with("The machine co2-100w has no setting for")
    );
    assert!(quote(&job, "Card").unwrap_err().to_string().contains("planned for \"4 MM ply\""));
}

#[test]
fn a_quote_for_a_machine_without_a_library_says_that_it_has_no_setting() {
    let job = planned(vec![], PassOrder::Contour, machine());
    let quoted =
        job.quote(&Material { name: Some("Mild steel".into()), ..Material::default() }.into()).unwrap();
    assert!(
        quoted.confidence.reasons.iter().any(|r| r.message.contains("no setting for Mild steel")),
        "{:?}",
        quoted.confidence
    );
}

/// The cuts of each contour in a plan: length, and the contour's own length.
fn lengths(job: &Job, plan: &Plan) -> Vec<(f64, f64)> {
    let sheet = job.beam_sheet();
    let mut lengths: Vec<(f64, f64)> = sheet.contours.iter().map(|c| (0.0, c.path.length())).collect();
    for m in &plan.moves {
        if let Move::Cut { contour, path, .. } = m {
            lengths[*contour as usize].0 += path.iter().map(kerfway::geometry::Segment::length).sum::<f64>();
        }
    }
    lengths
}

#[test]
fn n_passes_give_n_times_the_geometry_and_the_seconds() {
    let once = planned(vec![], PassOrder::Contour, machine()).plan().unwrap().summary;
    for n in [2, 3, 4] {
        let passes = || ["CUT", "INNER", "LINE"].map(|name| layer(name, |l| l.passes = Some(n))).to_vec();
        let times = f64::from(n);
        for order in [PassOrder::Contour, PassOrder::Sheet] {
            let job = planned(passes(), order, machine());
            let plan = job.plan().unwrap();
            let s = &plan.summary;
            near(s.cut_length, times * once.cut_length);
            near(s.cut_time, times * once.cut_time);
            near(s.pierce_time, times * once.pierce_time);
            assert_eq!((s.contours, s.open_contours, s.pierces), (3, 1, 3 * n), "{order:?}");
            for (k, (cut, length)) in lengths(&job, &plan).into_iter().enumerate() {
                let own = if order == PassOrder::Contour { times } else { 1.0 };
                near(cut, own * length);
                assert!(order == PassOrder::Contour || job.beam_sheet().contours[k].pass < n);
            }
            // The program runs as far with the beam on as the plan says.
            let program = gcode::run(&job.output(OutputKind::Gcode).unwrap()).unwrap();
            let run: f64 =
                program.motions().filter(|m| !m.rapid).map(|m| m.path.from.distance(m.path.to)).sum();
            assert!((run - s.cut_length).abs() < 0.05, "{run} {}", s.cut_length);
            // The geometry of a quote is that of one pass.
            let quote = job.quote(&Terms::default()).unwrap();
            assert_eq!((quote.part_count, quote.parts[0].holes), (1, 1));
            near(quote.net_area, 100.0 * 100.0 - 20.0 * 20.0);
            near(quote.parts[0].cut_length, times * 480.0);
            near(quote.smallest_hole.unwrap().width, 20.0);
        }
    }
}

#[test]
fn an_open_contour_is_run_there_and_back() {
    let ends = |passes| {
        let layers = vec![
            LayerChoice::new("CUT", Operation::Ignore),
            LayerChoice::new("INNER", Operation::Ignore),
            layer("LINE", |l| l.passes = Some(passes)),
        ];
        let job = planned(layers, PassOrder::Contour, Profile { return_home: false, ..machine() });
        let cuts = job.plan().unwrap().moves.into_iter().filter_map(|m| match m {
            Move::Cut { path, .. } => Some((path[0].start().x, path[path.len() - 1].end().x)),
            _ => None,
        });
        (cuts.collect::<Vec<_>>(), job.plan().unwrap().summary.air_length)
    };
    let (cuts, air) = ends(3);
    assert_eq!(cuts, [(120.0, 170.0), (170.0, 120.0), (120.0, 170.0)]);
    near(air, (120.0_f64 * 120.0 + 10.0 * 10.0).sqrt());
    assert_eq!(ends(2).0, [(120.0, 170.0), (170.0, 120.0)]);
}

#[test]
fn what_falls_out_falls_out_in_its_last_pass_and_after_what_is_inside() {
    let layers = || vec![layer("CUT", |l| l.passes = Some(2)), layer("INNER", |l| l.passes = Some(3))];
    let job = planned(layers(), PassOrder::Sheet, machine());
    let sheet = job.beam_sheet();
    // Two earlier passes of the hole, one of the plate; the contours themselves are the last passes.
    assert_eq!(sheet.contours.len(), 3 + 1 + 2);
    let order: Vec<(usize, u32)> = job
        .plan()
        .unwrap()
        .moves
        .iter()
        .filter_map(|m| if let Move::Cut { contour, .. } = m { Some(*contour as usize) } else { None })
        .map(|c| (c, sheet.contours[c].pass))
        .collect();
    let place = |contour: usize| order.iter().position(|o| o.0 == contour).unwrap();
    assert!(place(0) > place(1), "the plate falls out after the last pass of the hole: {order:?}");
    assert_eq!(order.last().map(|o| o.0), Some(0));
    // Sheet by sheet: passes come in their order, except where the plate waits for the hole.
    let passes: Vec<u32> = order.iter().filter(|o| o.0 != 0).map(|o| o.1).collect();
    assert!(passes.is_sorted(), "{order:?}");
}

#[test]
fn the_head_is_lowered_for_each_pass_and_raised_before_it_moves_on() {
    let layers = || vec![layer("CUT", |l| (l.passes, l.z_step) = (Some(3), Some(0.5)))];
    for order in [PassOrder::Contour, PassOrder::Sheet] {
        let job = planned(layers(), order, machine());
        let plain = planned(vec![layer("CUT", |l| l.passes = Some(3))], order, machine()).plan().unwrap();
        let plan = job.plan().unwrap();
        let heights: Vec<f64> = plan
            .moves
            .iter()
            .filter_map(|m| if let Move::Height { z } = m { Some(*z) } else { None })
            .collect();
        // By contour it goes down twice and up once; by sheet it comes up after each pass.
        let (expected, way) = match order {
            PassOrder::Contour => (vec![-0.5, -1.0, 0.0], 2.0),
            PassOrder::Sheet => (vec![-0.5, 0.0, -1.0, 0.0], 3.0),
        };
        assert_eq!(heights, expected, "{order:?}");
        near(plan.summary.air_time - plain.summary.air_time, way / 5.0);
        let text = job.output(OutputKind::Gcode).unwrap();
        assert_eq!(text.matches(" Z-1").count(), 1, "{text}");
    }
    let fixed = Profile { z_speed: None, ..machine() };
    let mut job =
        Job::load(drawing(), "x", &LoadOptions { layers: layers(), ..LoadOptions::default() }).unwrap();
    let sentence = job.start(&options(fixed)).err().unwrap().to_string();
    assert!(
        sentence.starts_with(
            "The passes on layer CUT lower the head, but the machine co2-100w has no \"z_speed\"."
        )
    );
}

/// From where the head stands, each height is written as seen from the one before, and the head comes back to where it was.
#[test]
fn the_rounding_of_relative_heights_does_not_add_up() {
    let layers = vec![layer("CUT", |l| (l.passes, l.z_step) = (Some(4), Some(1.0 / 3.0)))];
    let load = LoadOptions { layers, ..LoadOptions::default() };
    let mut job = Job::load(drawing(), "job.dxf", &load).unwrap();
    job.start(&PlanOptions { start: Start::Current, ..options(machine()) }).unwrap();
    job.run_mut().unwrap().step(20_000);
    let text = job.output(OutputKind::Gcode).unwrap();
    let words = text.lines().filter_map(|l| l.split(';').next()).flat_map(str::split_whitespace);
    let heights: Vec<&str> = words.filter_map(|word| word.strip_prefix('Z')).collect();
    assert_eq!(heights, ["-0.333", "-0.334", "-0.333", "1"], "{text}");
}

#[test]
fn plans_with_wrong_passes_fail_their_check() {
    let layers = vec![layer("CUT", |l| (l.passes, l.z_step) = (Some(2), Some(0.5)))];
    for order in [PassOrder::Contour, PassOrder::Sheet] {
        let job = planned(layers.clone(), order, machine());
        let good = job.plan().unwrap();
        let after = |change: &dyn Fn(&mut Vec<Move>)| {
            let mut moves = good.moves.clone();
            change(&mut moves);
            let mut summary = plan::evaluate(&moves, job.beam_sheet(), &machine());
            summary.parts = good.summary.parts;
            plan::check(job.beam_sheet(), &machine(), &Plan { moves, summary, bridges: Vec::new() })
                .err()
                .unwrap_or_default()
        };
        assert_eq!(after(&|_| {}), []);
        let cut = |m: &Move| matches!(m, Move::Cut { contour, .. } if *contour == 0);
        let missing = after(&|m| {
            let at = m.iter().rposition(cut).unwrap();
            m.drain(at - 1..=at);
        });
        assert!(!missing.is_empty(), "{order:?}: a pass is missing");
        let again = after(&|m| {
            let at = m.iter().rposition(cut).unwrap();
            let both = [m[at - 1].clone(), m[at].clone()];
            m.splice(at + 1..at + 1, both);
        });
        assert!(again.iter().any(|v| matches!(v, Violation::Again { .. })), "{order:?}: {again:?}");
        let high = after(&|m| m.retain(|m| !matches!(m, Move::Height { .. })));
        assert!(high.iter().any(|v| matches!(v, Violation::Height { .. })), "{order:?}: {high:?}");
        let low = after(&|m| {
            let at = m.iter().rposition(|m| matches!(m, Move::Height { .. })).unwrap();
            m.remove(at);
        });
        assert!(low.iter().any(|v| matches!(v, Violation::Height { .. })), "{order:?}: {low:?}");
    }
}

/// The sheet found the settings, but the document, and with it the seconds of a quote, did not.
#[test]
fn the_settings_of_a_layer_are_found_in_the_document_without_case_beyond_ascii_too() {
    let bytes = String::from_utf8(drawing()).unwrap().replace("8\nINNER\n", "8\nÄtzung\n");
    let layers = vec![layer("ÄTZUNG", |l| l.speed = Some(4.0))];
    let load = LoadOptions { layers, ..LoadOptions::default() };
    let mut job = Job::load(bytes.into_bytes(), "job.dxf", &load).unwrap();
    job.start(&options(machine())).unwrap();
    job.run_mut().unwrap().step(20_000);
    let written = document(&job);
    let inner = (0..).zip(&written.contours).find(|(_, c)| c.layer == "Ätzung").unwrap().0;
    assert_eq!(written.process_by_id(Some(inner)).speed, 4.0);
    near(job.plan().unwrap().summary.cut_time, (400.0 + 50.0) / 10.0 + 80.0 / 4.0);
}

#[test]
fn settings_out_of_their_range_are_refused_with_their_name() {
    let layers = vec![layer("CUT", |l| l.power = Some(1.5))];
    let load = LoadOptions { layers, ..LoadOptions::default() };
    let sentence = Job::load(drawing(), "x", &load).err().unwrap().to_string();
    assert!(
        sentence.starts_with("The option \"layers: CUT: power\" is 1.5. Give a number from 0 to 1"),
        "{sentence}"
    );
}

#[test]
fn a_layer_cuts_at_its_own_speed_and_power_in_the_program() {
    let layers = vec![layer("LINE", |l| (l.speed, l.power) = (Some(7.5), Some(0.35)))];
    let text = planned(layers, PassOrder::Contour, machine()).output(OutputKind::Gcode).unwrap();
    assert!(text.contains("S350 F450"), "{text}");
    assert!(text.contains("S800 F600"), "{text}");
}

/// The plan was made, and its program was then refused without a hint at the layer.
#[test]
fn layers_that_are_faster_than_the_machine_or_without_power_are_not_written() {
    let at = |speed| planned(vec![layer("LINE", |l| l.speed = Some(speed))], PassOrder::Contour, machine());
    let told = |job: &Job| -> Vec<(Code, String)> {
        job.run().unwrap().findings.iter().map(|f| (f.code, f.message.clone())).collect()
    };
    assert!(told(&at(100.0)).iter().all(|f| f.0 != Code::LayerTooFast));
    at(100.0).output(OutputKind::Gcode).unwrap();
    let job = at(150.0);
    let message = "Layer LINE is worked at 150 mm/s, but the machine moves with at most 100 mm/s: it takes longer than planned, and is not written as G-code. \
        Lower the speed of the layer, or raise the rapids of the machine.";
    assert!(told(&job).contains(&(Code::LayerTooFast, message.to_owned())), "{:?}", told(&job));
    // Without power nothing is cut either, however small it was meant to be.
    for power in [0.0, 1e-9] {
        let weak = planned(vec![layer("LINE", |l| l.power = Some(power))], PassOrder::Contour, machine());
        assert_eq!(
            weak.output(OutputKind::Gcode).unwrap_err().to_string(),
            "GRBL 1.1 (dialect \"grbl-m4\") cannot cut or mark with a power of 0: raise the power of the machine's process, or of the layer."
        );
    }
    planned(vec![layer("LINE", |l| l.power = Some(0.0004))], PassOrder::Contour, machine())
        .output(OutputKind::Gcode)
        .unwrap();
    assert_eq!(
        job.output(OutputKind::Gcode).unwrap_err().to_string(),
        "GRBL 1.1 (dialect \"grbl-m4\") cannot be asked for 150 mm/s by a layer, because the machine moves with at most 100 mm/s: \
        lower the speed of the layer, or raise the rapids of the machine."
    );
}

/// The report called a pass `0 (1/2)`, and programs and pictures by an id of its own, which no drawing has.
#[test]
fn programs_and_pictures_name_a_pass_by_its_contour() {
    let layers = vec![layer("INNER", |l| l.passes = Some(2))];
    let job = planned(layers, PassOrder::Sheet, machine());
    let id = job.sheet().contours.iter().position(|c| c.path.length() < 100.0 && c.path.closed).unwrap();
    for kind in [OutputKind::Gcode, OutputKind::Svg] {
        let text = job.output(kind).unwrap();
        for pass in 1..=2 {
            let name = format!("contour {id}, pass {pass}/2, layer INNER");
            assert_eq!(text.matches(&name).count(), 1, "{kind:?}: {name}: {text}");
        }
        assert_eq!(text.matches("layer INNER").count(), 2, "{kind:?}");
        assert!(!text.contains("contour 3"), "{kind:?}: {text}");
    }
    // With all passes of a contour at once there is one cut for each, and no number of a pass.
    let layers = vec![layer("INNER", |l| l.passes = Some(2))];
    let program = planned(layers, PassOrder::Contour, machine()).output(OutputKind::Gcode).unwrap();
    assert!(!program.contains("pass "), "{program}");
}
