//! Proofs for machines that join contours through waste: what this may save is part of every bound, and costs may be below 0.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use kerfway::drawing::TextDecoder;
use kerfway::job::{BestPath, Job, LoadOptions, MachineChoice, PlanOptions, Proof, WarmPath, verify};
use kerfway::machine::{Chains, Profile, preset};

/// Squares of 40 mm, 5 mm apart.
fn squares(columns: u32, rows: u32) -> Vec<u8> {
    let square = |(column, row): (u32, u32)| {
        let [x, y] = [column, row].map(|k| 10 + 45 * k);
        let corners = [(x, y), (x + 40, y), (x + 40, y + 40), (x, y + 40)];
        let vertices: String = corners.iter().map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).collect();
        format!("0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n{vertices}")
    };
    let all: String = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))).map(square).collect();
    format!("0\nSECTION\n2\nENTITIES\n{all}0\nENDSEC\n0\nEOF\n").into()
}

/// A machine that pierces for a second, which chains save.
fn joining(edge_starts: bool) -> PlanOptions {
    let mut machine = Profile { pierce_time: 1.0, ..preset("fibre-6kw-thick").unwrap() };
    machine.levers.chains = Some(Chains { reach: 30.0, clearance: 1.0, edge_starts });
    let machine = MachineChoice::Profile(Box::new(machine));
    PlanOptions { machine, allow_off_bed: true, seed: 1, ..PlanOptions::default() }
}

fn started(drawing: &[u8], options: &PlanOptions, moves: u64) -> Job {
    let mut job = Job::load(drawing.to_vec(), "squares.dxf", &LoadOptions::default()).unwrap();
    job.start(options).unwrap();
    job.run_mut().unwrap().step(moves);
    job
}

#[test]
fn a_certificate_counts_what_chains_may_save() {
    let drawing = squares(3, 3);
    for edge_starts in [false, true] {
        let options = joining(edge_starts);
        let mut proof =
            Proof::start(drawing.clone(), "squares.dxf", LoadOptions::default(), &options).unwrap();
        proof.improve(20_000_000);
        let text = proof.certificate().unwrap();
        let proven = verify(&text, &drawing, None, TextDecoder::default()).unwrap();
        let plan = started(&drawing, &options, 100_000).plan().unwrap();
        let total = plan.summary.total_time;
        assert!(plan.summary.chains > 0, "chains save piercing");
        assert!(proven.seconds <= total, "{edge_starts}: {} above {total}", proven.seconds);
        let stated = proof.seconds();
        let off = (proven.seconds - stated).abs();
        assert!(off <= 1e-6 * total, "{edge_starts}: {} certified, {stated} shown", proven.seconds);
    }
}

#[test]
fn its_own_path_is_not_better_where_costs_are_below_0() {
    let drawing = squares(3, 3);
    let options = joining(false);
    let mut job = started(&drawing, &options, 50_000);
    let (best, _) = BestPath::of(job.run().unwrap(), job.beam_sheet());
    let (contours, along) = (best.contours, best.along);
    let path = WarmPath { contours, along, until: best.until, reversed: best.reversed };
    assert!(!job.run_mut().unwrap().take_over(&path).unwrap());
    let mut proof = Proof::start(drawing, "squares.dxf", LoadOptions::default(), &options).unwrap();
    proof.improve(60_000_000);
    let told = proof.better_path();
    assert!(told.is_some());
    assert_eq!(proof.better_path(), None, "the same path is told once");
}

#[test]
fn the_bound_rises_where_costs_are_below_0() {
    let mut job = started(&squares(3, 3), &joining(false), 1);
    let mut bounds: Vec<f64> = Vec::new();
    for _ in 0..12 {
        job.run_mut().unwrap().step(100_000);
        bounds.push(job.plan().unwrap().summary.lower_bound);
    }
    let (first, last) = (bounds[0], bounds[11]);
    assert!(last > first + 1e-3, "{bounds:?}");
}
