//! Bridges that the machine cuts later (`levers.bridges.cut_later`): every part comes out with its own outline, after the cut around all of them.

use super::others::{kinds, random};
use super::{
    bridging, cut, merge, nest, nest_with_holes, p, pairs, plan_of, planned, rectangle, started, with,
};
use crate::testkit::dialects::read_back;
use crate::testkit::dxf_text::Entity;
use crate::testkit::jobs::each_planned;
use crate::testkit::sheets::XorShift;
use crate::testkit::{files, fixtures};
use kerfway::geometry::{DVec2, Segment};
use kerfway::job::{Job, LoadOptions, OutputKind};
use kerfway::machine::Profile;
use kerfway::plan::{Move, Plan};
use kerfway::quote::quote;
use kerfway::sheet::PassOrder;
use serde_json::{Value, json};

pub(super) fn later(machine: &Profile) -> Profile {
    with(machine, &json!({ "levers": { "bridges": { "cut_later": true } } }))
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-6 * (1.0 + b.abs()), "{a} is not {b}");
}

/// The cuts of a plan by contour.
fn cuts(plan: &Plan) -> Vec<(u32, Vec<Segment>)> {
    let all = plan.moves.iter();
    all.filter_map(|m| {
        if let Move::Cut { contour, path, .. } = m { Some((*contour, path.clone())) } else { None }
    })
    .collect()
}

/// A plan, checked, whose parts all come out: along every drawn outline there is a cut at `beside` mm from each of 500 places.
fn whole(job: &Job, beside: f64) -> Plan {
    let plan = job.plan().unwrap();
    let all = cut(&plan);
    for group in job.beam_sheet().bridged.iter() {
        for (id, outline) in &group.outlines {
            for k in 0..500 {
                let place = outline.at(outline.length() * f64::from(k) / 500.0).unwrap();
                let off = all.iter().map(|s| s.nearest(place).1).fold(f64::INFINITY, f64::min).sqrt();
                assert!(off <= beside + 1e-6, "contour {id} is not cut at {place}: {off}");
            }
        }
    }
    plan
}

#[test]
fn two_squares_are_cut_apart_after_the_cut_around_both() {
    let squares = nest(2, 1, p(20.0, 20.0), 8.0);
    let stops = with(&bridging(3.0, 10.0), &json!({ "junction_deviation": 0.0, "pierce_time": 3.0 }));
    let job = planned(&squares, later(&stops));
    let plan = whole(&job, 0.0);
    let s = &plan.summary;
    assert_eq!((s.bridges, s.pierces, s.contours, s.open_contours, s.parts), (1, 1, 2, 0, 2));
    near(s.cut_length, 2.0 * 80.0 + 2.0 * 8.0);
    let run = |length: f64| length / 33.0 + 33.0 / 3000.0;
    near(s.cut_time, 6.0 * run(20.0) + 4.0 * run(8.5) + 2.0 * run(8.0) + 2.0 * run(3.0));
    near(s.pierce_time, 3.0 + 3.0 * (0.2 + 0.1));
    let all = cuts(&plan);
    assert_eq!(all.iter().map(|c| c.0).collect::<Vec<_>>().iter().filter(|c| **c == 0).count(), 1);
    assert_eq!(all[0].0, 0);
    let ends = |k: usize| {
        let mut ends = [all[k].1[0].start(), all[k].1[0].end()];
        ends.sort_by(|a, b| a.y.total_cmp(&b.y));
        ends
    };
    let mut both = [ends(1), ends(2)];
    both.sort_by(|a, b| a[0].x.total_cmp(&b[0].x));
    for (found, x) in both.into_iter().zip([30.0, 38.0]) {
        assert!(found[0].distance(p(x, 18.5)) < 1e-9 && found[1].distance(p(x, 21.5)) < 1e-9, "{found:?}");
    }
    let findings = &job.run().unwrap().findings;
    let said = "2 parts are connected by 1 bridge to 1 piece, which the machine separates later.";
    assert!(findings.iter().any(|f| f.message == said));
    // Without the option, or with it switched off, the plan is what it was.
    let off = with(&stops, &json!({ "levers": { "bridges": { "cut_later": false } } }));
    assert_eq!(plan_of(&squares, off), plan_of(&squares, stops.clone()));
    assert!(plan_of(&squares, stops).summary.total_time < s.total_time);
}

#[test]
fn with_a_kerf_the_cuts_run_beside_the_outlines() {
    let squares = nest(2, 1, p(20.0, 20.0), 8.0);
    let job = planned(&squares, Profile { kerf_width: 0.4, pierce_time: 3.0, ..later(&bridging(3.0, 10.0)) });
    let plan = whole(&job, 0.2);
    near(plan.summary.cut_length, 8.0 * 20.4 + 2.0 * 7.6);
    for (_, path) in &cuts(&plan)[1..] {
        let [Segment::Line(line)] = path[..] else { panic!("{path:?}") };
        near(line.start.distance(line.end), 3.4);
        assert!((line.start.x - 30.2).abs() < 1e-9 || (line.start.x - 37.8).abs() < 1e-9, "{line:?}");
    }
    // On discs the cuts are arcs.
    let discs: Vec<Entity> =
        (0..3).map(|k| Entity::Circle(p(30.0 + 50.0 * f64::from(k), 30.0), 20.0)).collect();
    let job = planned(&discs, Profile { kerf_width: 0.4, pierce_time: 3.0, ..later(&bridging(4.0, 12.0)) });
    let plan = whole(&job, 0.2);
    assert_eq!(plan.summary.bridges, 2);
    assert_eq!(cuts(&plan).iter().filter(|c| matches!(c.1[..], [Segment::Arc(_)])).count(), 4);
}

#[test]
fn a_strip_stays_only_where_it_saves_more_than_cutting_it_takes() {
    // A piercing of 2 s pays for the sides of the strip and the cuts across it; one of 0.6 s for the sides alone.
    let squares = nest(2, 1, p(20.0, 20.0), 8.0);
    let machine = bridging(3.0, 10.0);
    let quick = Profile { pierce_time: 0.6, beam_on_delay: 0.0, beam_off_delay: 0.0, ..machine.clone() };
    assert_eq!(plan_of(&squares, quick.clone()).summary.bridges, 1);
    assert_eq!(plan_of(&squares, later(&quick)).summary.bridges, 0);
    let slow = Profile { pierce_time: 2.0, ..machine };
    let plan = plan_of(&squares, later(&slow));
    assert_eq!(plan.summary.bridges, 1);
    let apart = plan_of(&squares, with(&slow, &json!({ "levers": { "bridges": null } })));
    assert!(plan.summary.total_time < apart.summary.total_time);
}

/// Seconds of air moves in straight lines, and of everything else, of each order in which the holes, the cut around the parts, and the cuts
/// through bridges may come.
#[test]
fn no_other_order_of_the_cuts_takes_less() {
    for seed in 0..12_u64 {
        let mut rng = XorShift::new(40 + seed);
        let parts = 2 + usize::try_from(seed % 2).unwrap();
        let mut drawing = nest(u32::try_from(parts).unwrap(), 1, p(20.0, 20.0), 8.0);
        drawing.push(Entity::Circle(p(20.0 + rng.between(-3.0, 3.0), 20.0), 3.0));
        let machine =
            with(&later(&bridging(3.0, 10.0)), &json!({ "junction_deviation": 0.0, "pierce_time": 3.0 }));
        let job = started(&drawing, machine.clone(), &LoadOptions::default(), 50_000);
        let plan = whole(&job, 0.0);
        assert_eq!(plan.summary.bridges as usize, parts - 1);
        // Everything but air is the same in all orders: the head stops in every corner, so entries do not matter but for a stop saved in a corner.
        let sheet = job.beam_sheet();
        let through: Vec<[DVec2; 2]> = sheet
            .contours
            .iter()
            .filter(|c| c.completes().is_some())
            .map(|c| [c.path.start().unwrap(), c.path.end().unwrap()])
            .collect();
        assert_eq!(through.len(), 2 * (parts - 1));
        // The order that the plan has for the rest: from where the cut around the parts ends, the shortest way through all cuts and home.
        let moves = &plan.moves;
        let around = moves.iter().position(|m| matches!(m, Move::Cut { contour: 0, .. })).unwrap();
        let from = moves[around].end().unwrap();
        let air = |a: DVec2, b: DVec2| kerfway::machine::air_time(&machine, a, b);
        let mut best = f64::INFINITY;
        ways(from, &through, &mut Vec::new(), 0.0, &air, machine.home(), &mut best);
        let mut head = from;
        let mut found = 0.0;
        for m in &moves[around + 1..] {
            let to = m.end().unwrap_or(head);
            if let Move::Air { .. } = m {
                found += air(head, to);
            }
            head = to;
        }
        assert!(found <= best + 1e-9, "seed {seed}: {found} {best}");
    }
}

fn ways(
    from: DVec2,
    cuts: &[[DVec2; 2]],
    done: &mut Vec<usize>,
    seconds: f64,
    air: &impl Fn(DVec2, DVec2) -> f64,
    home: DVec2,
    best: &mut f64,
) {
    if done.len() == cuts.len() {
        *best = best.min(seconds + air(from, home));
    }
    for k in 0..cuts.len() {
        if done.contains(&k) {
            continue;
        }
        done.push(k);
        let [a, b] = cuts[k];
        for (to, end) in [(a, b), (b, a)] {
            ways(end, cuts, done, seconds + air(from, to), air, home, best);
        }
        done.pop();
    }
}

/// What machines may have besides. Of what tips, some parts stay, so that others hang on them: the nests of these tests have parts of this size.
fn kinds_later() -> Vec<(&'static str, Value)> {
    let mut kinds = kinds();
    kinds.retain(|kind| kind.0 != "rounded corners");
    for (_, change) in kinds.iter_mut().filter(|kind| kind.0 == "tips") {
        merge(change, &json!({ "levers": { "tips": { "tips_below": 30.0, "drops_below": 5.0 } } }));
    }
    kinds
}

#[test]
fn every_kind_of_machine_cuts_bridges_later() {
    let drawing = nest_with_holes(3, 2);
    for (name, change) in kinds_later() {
        let machine = with(&bridging(3.0, 10.0), &json!({ "pierce_time": 3.0 }));
        let machine = with(&later(&machine), &change);
        for order in [PassOrder::Contour, PassOrder::Sheet] {
            let load = LoadOptions { pass_order: order, ..LoadOptions::default() };
            let job = started(&drawing, machine.clone(), &load, 5_000);
            let plan = job.plan().unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!((plan.summary.contours, plan.summary.parts), (12, 6), "{name}");
            if name == "moving pierce" {
                // Nothing is pierced at rest, so the delays of the beam at the cuts through bridges cost more than one saves.
                assert_eq!(plan.summary.bridges, 0);
                continue;
            }
            assert_eq!(plan.summary.bridges, 5, "{name}");
            let through =
                job.beam_sheet().contours.iter().filter(|c| c.completes().is_some() && c.next_pass.is_none());
            assert_eq!(through.count(), 10, "{name}");
            // Where the kerf around the parts is whole, nothing is pierced for them.
            let held = name == "joints";
            let pierced = plan.moves.windows(2).filter(|w| {
                let through = matches!(w[1], Move::Cut { contour, .. } if job.beam_sheet().contours[contour as usize].completes().is_some());
                through && w[0] == Move::Pierce
            });
            assert_eq!(pierced.count() > 0, held, "{name}");
        }
    }
}

#[test]
fn layers_and_windows_keep_their_order() {
    let drawing = nest_with_holes(3, 1);
    let machine = with(&later(&bridging(3.0, 10.0)), &json!({ "pierce_time": 3.0 }));
    let by_layer = LoadOptions { order_by_layer: true, ..LoadOptions::default() };
    let job = started(&drawing, machine.clone(), &by_layer, 5_000);
    assert_eq!(whole(&job, 0.0).summary.bridges, 2);
    // The bridge in a window is cut before the window, and that before the outline around it.
    let mut drawing = vec![rectangle(p(10.0, 10.0), p(100.0, 60.0)), rectangle(p(20.0, 20.0), p(80.0, 40.0))];
    drawing.extend([rectangle(p(28.0, 28.0), p(20.0, 20.0)), rectangle(p(56.0, 28.0), p(20.0, 20.0))]);
    let job = planned(&drawing, machine);
    let plan = whole(&job, 0.0);
    assert_eq!(pairs(&plan), [[2, 3]]);
    let order: Vec<u32> = cuts(&plan).iter().map(|c| c.0).collect();
    assert_eq!((order.len(), order[0], &order[3..]), (5, 2, &[1, 0][..]), "{order:?}");
}

#[test]
fn programs_of_all_dialects_cut_the_bridges() {
    let drawing = nest_with_holes(2, 2);
    let planned = |machine: &Profile| {
        let job = planned(&drawing, machine.clone());
        (job.beam_sheet().clone(), job.plan().unwrap())
    };
    // Four parts and four holes come out, and three strips.
    let machine = with(&later(&bridging(3.0, 10.0)), &json!({ "pierce_time": 3.0 }));
    read_back(&machine, planned, 1, |dialect, plan, text| {
        assert_eq!((plan.summary.bridges, plan.summary.pierces), (3, 5), "{dialect}");
        let cuts = plan.moves.iter().filter(|m| matches!(m, Move::Cut { .. })).count();
        assert_eq!(cuts, 4 + 1 + 6, "{dialect}");
        assert!(text.is_none_or(|t| !t.is_empty()));
    });
}

#[test]
fn documents_pictures_and_quotes_know_the_cuts() {
    let drawing = nest_with_holes(3, 1);
    let machine = with(&later(&bridging(3.0, 10.0)), &json!({ "pierce_time": 3.0 }));
    let job = planned(&drawing, machine.clone());
    for kind in [OutputKind::Svg, OutputKind::Dxf, OutputKind::Lbrn2] {
        assert!(!job.output(kind).unwrap().is_empty());
    }
    let document: Value = serde_json::from_str(&job.output(OutputKind::Json).unwrap()).unwrap();
    let schema: Value = serde_json::from_str(include_str!("../../../www/sdk/plan.schema.json")).unwrap();
    assert_eq!(crate::testkit::schema::fault(&schema, &schema, &document, "plan"), None);
    let contours = document["contours"].as_array().unwrap();
    let added: Vec<&Value> = contours[6..].iter().map(|c| &c["bridged"]).collect();
    assert_eq!(added, [&json!(0), &json!(1), &json!(1), &json!(2)]);
    // The parts are the same as before, and each pays for the cuts along its outline: the one in the middle for two more.
    let report = quote(&job.document().unwrap(), &kerfway::quote::Terms::default()).unwrap();
    assert_eq!((report.part_count, report.parts.len(), report.parts[0].count), (3, 1, 3));
    assert_eq!(report.layers.iter().map(|l| (l.contours, l.open)).collect::<Vec<_>>(), [(6, 0)]);
    let times: Vec<f64> = report.parts[0].items.iter().map(|i| i.times.total).collect();
    near(times.iter().sum::<f64>() + report.loose_times.total, report.times.total);
    near(report.loose_times.total, 0.0);
    let cuts: Vec<f64> = report.parts[0].items.iter().map(|i| i.times.cut).collect();
    let one = kerfway::machine::cut_time(&machine, &machine.cut, &[Segment::line(p(0.0, 0.0), p(3.0, 0.0))]);
    near(cuts[1] - cuts[0], one);
    near(cuts[0], cuts[2]);
}

#[test]
fn what_clashes_is_refused() {
    let refused = |change: Value| super::others::refused(&LoadOptions::default(), change);
    assert_eq!(
        refused(json!({ "levers": { "bridges": { "cut_later": true }, "corners": { "outer": "round" } } })),
        "The machine has levers.bridges.cut_later and levers.corners.outer, but rounded corners leave the ends of the strips uncut: give one of them."
    );
}

#[test]
fn random_nests_come_out_on_every_kind_of_machine() {
    let mut bridges = 0;
    for seed in 0..34_u64 {
        let mut rng = XorShift::new(900 + seed);
        let drawing = random(&mut rng);
        let kinds = kinds_later();
        let (name, change) = &kinds[usize::try_from(seed).unwrap() % kinds.len()];
        let own = json!({ "pierce_time": 3.0, "levers": { "bridges": { "width": rng.between(1.0, 5.0), "reach": rng.between(8.0, 30.0), "clearance": rng.between(0.0, 2.0) } } });
        let machine = with(&with(&later(&bridging(3.0, 10.0)), change), &own);
        let beside = 0.5 * machine.kerf_width;
        let job = planned(&drawing, machine);
        let plan = job.plan().unwrap_or_else(|e| panic!("seed {seed}, {name}: {e}"));
        // Joints hold outlines where they are, moved parts are elsewhere than drawn.
        if *name != "joints" {
            whole(&job, beside);
        }
        bridges += plan.summary.bridges;
    }
    assert!(bridges > 150, "{bridges}");
}

#[test]
fn real_drawings_and_sheets_come_out() {
    let kinds: Vec<Value> = kinds_later().into_iter().map(|k| k.1).collect();
    let paths = ["dxf-dev", "sheets"].map(|folder| files(&fixtures().join(folder), "dxf")).concat();
    let small = |path: &std::path::PathBuf| std::fs::metadata(path).unwrap().len() < 300_000;
    let paths: Vec<_> = paths.into_iter().filter(small).collect();
    let machine = |k: usize| {
        let width = [2.0, 5.0][k % 2];
        let own = json!({ "pierce_time": 3.0, "levers": { "bridges": { "width": width, "reach": 40.0, "clearance": 0.5 } } });
        with(&with(&later(&bridging(3.0, 10.0)), &kinds[k % kinds.len()]), &own)
    };
    let mut bridges = 0;
    each_planned(&paths, machine, |_, _, plan| bridges += plan.summary.bridges);
    assert!(bridges > 40, "{bridges}");
}
