//! Certificates that all orders were looked at: of the optimum of small problems of every kind, against exact optima.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::certificate::grid;
use crate::lower_bound::entered_anywhere;
use crate::testkit::outlines::drawing;
use crate::testkit::sheets::{XorShift, machine, nested_sheet};
use crate::walk_certificate::{of_every_kind, some};
use kerfway::drawing::TextDecoder;
use kerfway::geometry::DVec2;
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions, Proof, WarmPath, problem_of, verify};
use kerfway::plan::{CertificateFault, Certified, LowerBound, WalkCertificate};
use kerfway::problem::Problem;
use kerfway::solve;
use std::time::Instant;

/// The bound after so much work, with a path of this length known, and its certificate.
fn certified(problem: &Problem, upper: f64, work: u32) -> (f64, WalkCertificate) {
    let mut bound = LowerBound::new(problem);
    bound.improve(work, upper);
    (bound.value(), bound.certificate(problem, f64::NEG_INFINITY).unwrap())
}

/// The least travel of all orders by a certificate's numbers, s, but at most what it states.
fn best_of_orders(problem: &Problem, certificate: &WalkCertificate, stated: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "whole")]
    let bound = (stated / certificate.seconds() * certificate.bound as f64).floor() as i64;
    let asked = WalkCertificate { all_orders: true, bound, ..certificate.clone() };
    let proven = i64::try_from(asked.adds_up_to(problem).unwrap()).unwrap();
    let certificate = WalkCertificate { bound: proven, ..asked };
    assert_eq!(certificate.check(problem), Ok(certificate.seconds()));
    certificate.seconds()
}

#[test]
fn optima_of_every_kind_are_certified() {
    let mut rng = XorShift::new(47);
    let (mut by_orders, mut less, mut proven) = (0, 0, 0);
    for k in 0..400_u64 {
        let problem = of_every_kind(&mut rng, k);
        let least = solve::exact(&problem).unwrap().cost;
        // A path is known that is a little longer, so that there are orders that may take less.
        let (value, certificate) = certified(&problem, 1.01 * least, 3_000_000);
        let seconds = certificate.seconds();
        assert_eq!(certificate.check(&problem), Ok(seconds));
        assert!(seconds <= least + 1e-9 * least.abs(), "{k}: {seconds} above {least}");
        // A table's start of several points may be left from one and come back to at another: only the bound itself looks at each of them.
        let tied = problem.table().is_none();
        assert!(!tied || seconds >= value - 1e-6 - 1e-8 * least, "{k}: {seconds} is less than {value}");
        proven += i32::from(tied && seconds >= least - 1e-6 - 1e-7 * least);
        if !certificate.all_orders {
            continue;
        }
        by_orders += 1;
        // Nobody makes it state more than the optimum, and the walks alone prove less.
        let more = best_of_orders(&problem, &certificate, 1.2 * seconds);
        assert!(more <= least + 1e-9 * least.abs(), "{k}: {more} above {least}");
        let above =
            WalkCertificate { bound: certificate.bound + certificate.bound / 10, ..certificate.clone() };
        assert!(matches!(above.check(&problem), Err(CertificateFault::Bound { .. })), "{k}");
        let walks = WalkCertificate { all_orders: false, ..certificate };
        less += i32::from(walks.adds_up_to(&problem).unwrap() < i128::from(walks.bound));
    }
    assert!(by_orders > 20 && proven > 290, "{by_orders} by orders, {proven} proven");
    // Where the charges have settled in time, walks prove as much.
    assert!(less > 2, "walks prove less in {less} of {by_orders}");
}

/// Whatever the charges, what is remembered and what is near: the best order is found, where all legs are priced from point to point exactly, and
/// otherwise nothing above it.
#[test]
fn any_numbers_find_the_best_order() {
    let mut rng = XorShift::new(53);
    let (mut exact, mut lower) = (0, 0);
    for k in 0..600_u64 {
        let problem = of_every_kind(&mut rng, k);
        let least = solve::exact(&problem).unwrap().cost;
        let (_, good) = certified(&problem, 2.0 * least + 1.0, 30_000);
        if good.seconds() <= 1e-3 * least {
            continue;
        }
        let (count, given) = (good.charges.len(), problem.table().is_some());
        let first = count + usize::from(given) - problem.items.len();
        for turn in 0..3 {
            let mut changed = good.clone();
            let size = 1 + good.bound / 4;
            let mut any = || i64::try_from(rng.below(u64::try_from(2 * size).unwrap())).unwrap() - size;
            changed.charges[first..].iter_mut().for_each(|charge| *charge += any());
            (first..count).for_each(|i| changed.ng_sets[i] = some(&mut rng, first, count, 5));
            if turn == 2 && !given {
                (first..count).for_each(|i| changed.near[i] = some(&mut rng, i + 1, count, 5));
            }
            let found = best_of_orders(&problem, &changed, 3.0 * least);
            assert!(found <= least + 1e-9 * least.abs(), "{k}, {turn}: {found} above {least}");
            // As above.
            let is_exact = turn < 2 && !given;
            assert!(!is_exact || found >= least - 1e-6 - 1e-8 * least, "{k}, {turn}: {found} of {least}");
            exact += i32::from(is_exact);
            lower += i32::from(found < 0.999 * least);
        }
    }
    assert!(exact > 600 && lower > 50, "{exact} exact, {lower} lower");
}

/// Contours that are entered anywhere: the certificate of the optimum is within a ten-millionth of it.
#[test]
fn contours_entered_anywhere() {
    let (mut by_orders, mut optimal) = (0, 0);
    for seed in 0..12 {
        let (problem, _) = entered_anywhere(1 + usize::try_from(seed).unwrap() % 3, seed);
        let mut search = solve::methods()[0].start(&problem, 1, None);
        search.step(400_000);
        let cost = search.best().cost;
        let (value, certificate) = certified(&problem, cost, 400_000_000);
        let seconds = certificate.check(&problem).unwrap();
        assert!(
            seconds <= cost && seconds >= value - 1e-6 - 1e-8 * cost,
            "{seed}: {value}, {seconds}, {cost}"
        );
        optimal += i32::from(seconds >= cost * (1.0 - 1e-6));
        by_orders += i32::from(certificate.all_orders);
    }
    assert!(by_orders > 3 && optimal > 8, "{by_orders} by orders, {optimal} optimal");
}

/// The proof of a job finds and proves the best path of twelve circles, entered anywhere: its file shows it to anyone.
#[test]
fn the_certificate_of_a_job_shows_that_its_path_is_optimal() {
    let drawing = grid(4, 3);
    let options = PlanOptions { machine: MachineChoice::Preset("length".into()), ..PlanOptions::default() };
    let mut proof = Proof::start(drawing.clone(), "grid.dxf", LoadOptions::default(), &options).unwrap();
    let mut job = Job::load(drawing.clone(), "grid.dxf", &LoadOptions::default()).unwrap();
    job.start(&options).unwrap();
    job.run_mut().unwrap().step(2_000_000);
    let path = job.run().unwrap().plan(job.sheet()).summary.total_time;
    while proof.seconds() < path * (1.0 - 1e-6) {
        assert!(proof.improve(100_000_000), "{} of {path}", proof.seconds());
    }
    let text = proof.certificate().unwrap();
    assert!(text.contains("\"all_orders\":true"), "{text}");
    let seconds = verify(&text, &drawing, None, TextDecoder::default()).unwrap().seconds;
    assert!(seconds <= path && seconds >= path * (1.0 - 1e-6), "{seconds} of {path}");
}

/// A proof finds a path of its own, which the plan takes over: on a machine with two axes it has the best entries.
#[test]
fn a_plan_takes_over_the_better_path_of_its_proof() {
    for machine in ["co2-100w", "fibre-3kw-thin", "length"] {
        let drawing = grid(4, 3);
        let options =
            PlanOptions { machine: MachineChoice::Preset(machine.into()), ..PlanOptions::default() };
        let mut proof = Proof::start(drawing.clone(), "grid.dxf", LoadOptions::default(), &options).unwrap();
        let mut job = Job::load(drawing, "grid.dxf", &LoadOptions::default()).unwrap();
        job.start(&options).unwrap();
        let first = job.run().unwrap().plan(job.sheet()).summary.total_time;
        let mut seconds = first;
        while proof.seconds() < seconds * (1.0 - 1e-6) {
            let more = proof.improve(20_000_000);
            if let Some(path) = proof.better_path() {
                assert!(
                    job.run_mut().unwrap().offer(&path).unwrap(),
                    "{machine}: the plan keeps a worse path"
                );
                let total = job.run().unwrap().plan(job.sheet()).summary.total_time;
                assert!(total < seconds, "{machine}: {total} s after {seconds} s");
                seconds = total;
            }
            assert!(
                more || proof.seconds() >= seconds * (1.0 - 1e-6),
                "{machine}: {} of {seconds}",
                proof.seconds()
            );
        }
        assert!(
            seconds < 0.999 * first && proof.seconds() <= seconds + 1e-9,
            "{machine}: {seconds} of {first}"
        );
        assert_eq!(proof.better_path(), None, "{machine}: it was told before");
        // Checked.
        job.document().unwrap();
    }
}

/// A proof begins with the path that is known, whatever it is: its own search finds none that takes longer.
#[test]
fn a_proof_begins_with_the_path_that_is_known() {
    let drawing = grid(4, 3);
    let options = PlanOptions { machine: MachineChoice::Preset("co2-100w".into()), ..PlanOptions::default() };
    let reading = LoadOptions::default();
    let start =
        |options: &PlanOptions| Proof::start(drawing.clone(), "grid.dxf", reading.clone(), options).unwrap();
    let mut proof = start(&options);
    while proof.improve(20_000_000) {}
    let best = proof.better_path().unwrap();
    // With the best path nothing better is told later.
    let mut again = start(&PlanOptions { warm: Some(best.clone()), ..options.clone() });
    assert_eq!(again.better_path(), Some(best.clone()));
    while again.improve(20_000_000) {}
    assert_eq!(again.better_path(), None);
    assert!((again.seconds() - proof.seconds()).abs() < 1e-6, "{} and {}", again.seconds(), proof.seconds());
    // A path of another drawing is no path of this one.
    let other = WarmPath { contours: vec![0], ..best };
    assert!(start(&PlanOptions { warm: Some(other), ..options }).better_path().is_some());
}

/// A certificate that leaves too many orders to look at is refused, and so is one of too many contours.
#[test]
fn too_many_orders_are_refused() {
    let refused = |problem: &Problem, certificate: WalkCertificate, of: &str| {
        let start = Instant::now();
        let why = certificate.check(problem).unwrap_err();
        assert_eq!(why.to_string(), format!("The certificate has more {of} than are checked."));
        assert!(start.elapsed().as_secs() < 60, "{:?}", start.elapsed());
    };
    let problem = problem_of(&nested_sheet(40, 5), &machine("length"));
    let (_, good) = certified(&problem, 2000.0, 100_000_000);
    let all = WalkCertificate { all_orders: true, bound: good.bound + good.bound / 2, ..good };
    refused(&problem, all.clone(), "orders");
    let most = WalkCertificate { bound: i64::MAX, ..all };
    refused(&problem, most, "orders");
    let many = problem_of(&nested_sheet(140, 5), &machine("length"));
    let (_, good) = certified(&many, 5000.0, 200_000_000);
    refused(&many, WalkCertificate { all_orders: true, ..good }, "items in orders");
}

/// A leg at a common corner takes nothing, and its seconds go with the root of its length: pieces there were halved without end, until
/// the memory was full.
#[test]
fn each_turn_of_a_proof_of_contours_with_a_common_corner_ends() {
    let corner = DVec2::new(30.0, 30.0);
    let triangle = vec![corner, DVec2::new(46.7, 32.1), DVec2::new(38.8, 44.0)];
    let square = vec![DVec2::new(30.0, 10.0), DVec2::new(50.0, 10.0), DVec2::new(50.0, 30.0), corner];
    let drawing = drawing(&[triangle, square]);
    let machine = MachineChoice::Preset("fibre-3kw-thin".into());
    let options = PlanOptions { machine, ..PlanOptions::default() };
    let mut proof = Proof::start(drawing.clone(), "corner.dxf", LoadOptions::default(), &options).unwrap();
    let turns = (0..300).take_while(|_| proof.improve(1_000_000)).count();
    assert!(turns > 100, "{turns}: it needs no pieces that are too short");
    let path = proof.better_path().unwrap();
    let mut job = Job::load(drawing.clone(), "corner.dxf", &LoadOptions::default()).unwrap();
    job.start(&options).unwrap();
    job.run_mut().unwrap().offer(&path).unwrap();
    let total = job.plan().unwrap().summary.total_time;
    let text = proof.certificate().unwrap();
    let seconds = verify(&text, &drawing, None, TextDecoder::default()).unwrap().seconds;
    assert!(seconds <= total && seconds >= total * (1.0 - 1e-3), "{seconds} of {total}");
}
