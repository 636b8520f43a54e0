//! The bound by flows and its certificates: small problems of every kind against exact optima, sheets, and certificates that were changed.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::lower_bound::{entered_anywhere, scattered};
use crate::testkit::sheets::{XorShift, machine, nested_sheet};
use crate::walk_certificate::{cut, knots_of, of_every_kind, some};
use kerfway::job::problem_of;
use kerfway::plan::{CertificateFault, Certified, FlowBound, FlowCertificate};
use kerfway::problem::Problem;
use kerfway::solve;

/// The bound after so much work; `None` if it does not apply.
fn by_flows(problem: &Problem, work: u32) -> Option<FlowBound> {
    let mut bound = FlowBound::new(problem)?;
    let mut last = bound.value();
    for _ in 0..work / 50_000 {
        let more = bound.improve(50_000);
        assert!(bound.value() >= last, "it only rises");
        last = bound.value();
        if !more {
            break;
        }
    }
    Some(bound)
}

/// What a certificate proves, s: that of its bound, and not one unit more.
fn proven(problem: &Problem, certificate: &FlowCertificate) -> Result<f64, CertificateFault> {
    let bound = i64::try_from(certificate.adds_up_to(problem)?).unwrap();
    let certificate = FlowCertificate { bound, ..certificate.clone() };
    assert_eq!(certificate.check(problem), Ok(certificate.seconds()));
    let above = FlowCertificate { bound: bound + 1, ..certificate.clone() };
    assert!(matches!(above.check(problem), Err(CertificateFault::Bound { .. })));
    Ok(certificate.seconds())
}

/// 2,000 seeded problems: points, open contours, ranks, precedence, open and closed paths, and tables that are the same both ways or not.
#[test]
fn never_above_the_optimum() {
    let mut rng = XorShift::new(41);
    let (mut sum, mut sum_least, mut cases, mut directed, mut ordered) = (0.0, 0.0, 0, 0, 0);
    for k in 0..2400_u64 {
        let problem = of_every_kind(&mut rng, k);
        let Some(bound) = by_flows(&problem, 1_000_000) else { continue };
        let least = solve::exact(&problem).unwrap().cost;
        let value = bound.value();
        let rounding = 1e-6 + 1e-9 * least;
        assert!(value <= least + 1e-9 * least, "{k}: {value} above {least}");
        let seconds = proven(&problem, &bound.certificate().unwrap()).unwrap();
        assert!(seconds <= least + 1e-9 * least, "{k}: the certificate proves {seconds}, above {least}");
        assert!((seconds - value).abs() <= rounding, "{k}: the certificate proves {seconds}, not {value}");
        cases += 1;
        directed += i32::from(problem.table().is_some_and(|t| !t.is_symmetric()));
        ordered += i32::from(!problem.pairs.is_empty() || problem.items.iter().any(|i| i.before.is_some()));
        (sum, sum_least) = (sum + value, sum_least + least);
    }
    assert!(cases >= 2000 && directed > 100 && ordered > 100, "{cases} {directed} {ordered}");
    assert!(sum >= 0.93 * sum_least, "{sum} of {sum_least} proven");
}

/// Contours that are entered anywhere, with holes that come first: against the optimum over many nodes.
#[test]
fn entries_anywhere() {
    let (mut sum, mut sum_least) = (0.0, 0.0);
    for seed in 0..24 {
        let (problem, least) = entered_anywhere(2 + usize::try_from(seed).unwrap() % 2, seed);
        let bound = by_flows(&problem, 30_000_000).unwrap();
        let certificate = bound.certificate().unwrap();
        assert!(certificate.knots.iter().any(|knots| knots.len() > 2));
        let seconds = proven(&problem, &certificate).unwrap();
        assert!(seconds <= least && seconds >= bound.value() - 1e-6 - 1e-9 * least, "{seed}");
        (sum, sum_least) = (sum + seconds, sum_least + least);
    }
    assert!(sum >= 0.9 * sum_least, "{sum} of {sum_least} proven");
}

/// Sheets with legs priced by boxes, for a closed and an open path: cuts have prices, and less is proven without them.
#[test]
fn sheets_with_cuts_and_far_contours() {
    for (name, closed) in [("length", true), ("co2-100w", false)] {
        let mut machine = machine(name);
        machine.return_home = closed;
        let problem = problem_of(&nested_sheet(75, 5), &machine);
        let mut search = solve::methods()[0].start(&problem, 1, None);
        search.step(300_000);
        let cost = search.best().cost;
        let bound = by_flows(&problem, 1_500_000_000).unwrap();
        let certificate = bound.certificate().unwrap();
        let near: usize = certificate.near.iter().map(Vec::len).sum();
        assert!(near < problem.items.len() * problem.items.len() / 3 && !certificate.cuts.is_empty());
        let seconds = proven(&problem, &certificate).unwrap();
        assert!(seconds <= cost && seconds >= 0.8 * cost, "{name}: {seconds} of {cost}");
        let less = proven(&problem, &FlowCertificate { cuts: Vec::new(), ..certificate }).unwrap();
        assert!(less < seconds, "{name}: {less} of {seconds} without cuts");
    }
}

/// The same numbers in slices of any size.
#[test]
fn the_same_in_slices() {
    let problem = problem_of(&nested_sheet(12, 3), &machine("length"));
    let after = |slice: u32| {
        let mut bound = FlowBound::new(&problem).unwrap();
        (0..60_000_000 / slice).for_each(|_| {
            bound.improve(slice);
        });
        (bound.value().to_bits(), bound.certificate())
    };
    let whole = after(60_000_000);
    assert!(whole == after(1_000_000) && whole == after(30_000));
}

/// Whatever the numbers are, no more than the optimum is proven: potentials, and cuts by the places in them.
#[test]
fn any_numbers_prove_no_more_than_the_optimum() {
    let mut rng = XorShift::new(43);
    let (mut less, mut cases) = (0, 0);
    for k in 0..1500_u64 {
        let problem = of_every_kind(&mut rng, k);
        let Some(bound) = by_flows(&problem, 200_000) else { continue };
        let least = solve::exact(&problem).unwrap().cost;
        let good = bound.certificate().unwrap();
        let before = proven(&problem, &good).unwrap();
        let (knots, paired) = knots_of(&problem);
        for turn in 0..5 {
            let mut changed = good.clone();
            let size = 1 + good
                .potentials
                .iter()
                .flatten()
                .filter(|p| p.abs() < 1 << 49)
                .map(|p| p.abs())
                .max()
                .unwrap()
                / 4;
            let mut any = |most: i64| i64::try_from(rng.below(u64::try_from(most).unwrap())).unwrap();
            if turn % 2 == 0 {
                changed
                    .potentials
                    .iter_mut()
                    .flatten()
                    .for_each(|p| *p += (any(2 * size) - size).clamp(-(1 << 40), 1 << 40));
                changed.potentials.iter_mut().flatten().for_each(|p| *p = (*p).clamp(-(1 << 50), 1 << 50));
            }
            if turn > 0 {
                let price = if turn == 4 { 8 * size } else { 1 + size / 3 };
                let more: Vec<_> =
                    (0..3).map(|_| cut(&mut rng, good.near.len(), &knots, &paired, price)).collect();
                changed.cuts.extend(more);
                changed.cuts.retain(|c| c.visited.is_some() || !c.members.is_empty());
            }
            let seconds = proven(&problem, &changed).unwrap();
            assert!(seconds <= least + 1e-9 * least.abs(), "{k}, {turn}: {seconds} above {least}");
            less += i32::from(seconds < before);
            cases += 1;
        }
    }
    assert!(cases > 6000 && less > cases / 2, "{less} of {cases}");
}

/// With nothing remembered, there are fewer states and less is proven; every other change of the lists no longer fits the potentials, or proves no
/// more than the optimum.
#[test]
fn changed_lists_are_refused_or_prove_no_more() {
    let (mut rng, mut refused, mut less) = (XorShift::new(47), 0, 0);
    for k in 0..400_u64 {
        let problem = scattered(&mut rng, k);
        let Some(bound) = by_flows(&problem, 200_000) else { continue };
        let least = solve::exact(&problem).unwrap().cost;
        let mut changed = bound.certificate().unwrap();
        let count = changed.ng_sets.len();
        let first = count - problem.items.len();
        (first..count).for_each(|i| changed.ng_sets[i] = some(&mut rng, first, count, 6));
        match changed.adds_up_to(&problem) {
            Err(fault) => {
                assert_eq!(fault, CertificateFault::Shape("potentials"));
                refused += 1;
            }
            Ok(_) => {
                let seconds = proven(&problem, &changed).unwrap();
                assert!(seconds <= least + 1e-9 * least, "{k}: {seconds} above {least}");
                less += 1;
            }
        }
    }
    assert!(refused > 100 && less > 5, "{refused} {less}");
}

/// One changed number is noticed, and numbers of the wrong shape have a sentence.
#[test]
fn one_changed_number_is_noticed() {
    let problem = scattered(&mut XorShift::new(3), 14);
    let good = by_flows(&problem, 1_000_000).unwrap().certificate().unwrap();
    assert!(good.check(&problem).is_ok());
    let shape = |change: &dyn Fn(&mut FlowCertificate)| {
        let mut changed = good.clone();
        change(&mut changed);
        changed.check(&problem).unwrap_err()
    };
    for (of, change) in [
        (
            "potentials",
            (&|c: &mut FlowCertificate| c.potentials.truncate(2)) as &dyn Fn(&mut FlowCertificate),
        ),
        ("potentials", &|c| c.potentials[1].push(0)),
        ("potentials", &|c| c.potentials[1][0] = i64::MAX),
        ("potentials", &|c| c.potentials[1][0] = i64::MIN),
        ("lists of company", &|c| c.ng_sets[2] = vec![usize::MAX]),
        ("near items", &|c| c.near[2] = vec![0]),
        ("units", &|c| c.unit += 1),
        ("knots", &|c| c.knots.truncate(1)),
    ] {
        assert_eq!(shape(change), CertificateFault::Shape(of));
    }
    let lower = shape(&|c| c.bound -= 1);
    assert!(matches!(lower, CertificateFault::Bound { .. }), "{lower:?}");
    let home = good.potentials.len() - 1;
    let moved = shape(&|c| c.potentials[home][0] += 1 << 45);
    assert!(matches!(moved, CertificateFault::Bound { .. }), "{moved:?}");
}

/// Where the bound does not apply there is none.
#[test]
fn it_does_not_apply() {
    let mut machine = machine("length");
    machine.pre_cut_time = Some(0.0);
    let resumes = problem_of(&nested_sheet(5, 1), &machine);
    assert!(resumes.items.iter().any(|i| i.leave.is_some()) && FlowBound::new(&resumes).is_none());
    let one = scattered(&mut XorShift::new(1), 8);
    assert!(one.items.len() == 1 && FlowBound::new(&one).is_none());
}
