//! Certificates of the bound by walks: what they prove of small problems of every kind, against exact optima, and what is refused.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::lower_bound::{entered_anywhere, scattered};
use crate::testkit::sheets::{XorShift, machine, nested_sheet};
use kerfway::geometry::DVec2;
use kerfway::job::problem_of;
use kerfway::plan::{CertificateFault, Certified, LowerBound, MixedLegs, Part, PricedCut, WalkCertificate};
use kerfway::problem::{Item, Node, Problem, Table};
use kerfway::solve;
use std::time::Instant;

/// The bound of walks alone and its certificate. A known path twice as long as the shortest keeps the bound from looking at all orders.
fn certified(problem: &Problem, least: f64, work: u32) -> (f64, WalkCertificate) {
    let mut bound = LowerBound::new(problem);
    bound.improve(work, 2.0 * least + 1.0);
    (bound.value(), bound.certificate(problem, f64::NEG_INFINITY).unwrap())
}

/// What a certificate proves, s: that of its bound.
fn proven(problem: &Problem, certificate: &WalkCertificate) -> Result<f64, CertificateFault> {
    let bound = certificate.adds_up_to(problem)?;
    let certificate = WalkCertificate { bound: i64::try_from(bound).unwrap(), ..certificate.clone() };
    assert_eq!(certificate.check(problem), Ok(certificate.seconds()));
    // One unit more is not proven.
    let above = WalkCertificate { bound: certificate.bound + 1, ..certificate.clone() };
    assert!(matches!(above.check(problem), Err(CertificateFault::Bound { .. })));
    Ok(certificate.seconds())
}

/// Scattered items of every kind and, every fourth time, tables of costs, every other one of them not the same both ways.
pub(crate) fn of_every_kind(rng: &mut XorShift, k: u64) -> Problem {
    let mut problem = scattered(rng, k);
    if k % 4 != 3 || problem.items.len() < 2 {
        return problem;
    }
    problem.items.iter_mut().for_each(|i| (i.before, i.rank) = (None, 0));
    let ordered = k % 16 == 3 && problem.items.len() > 3;
    problem.pairs = if ordered { vec![(1, 0), (2, 1)] } else { Vec::new() };
    let n = problem.nodes.len();
    let mut costs: Vec<f64> = (0..n * n).map(|_| rng.below(1000) as f64).collect();
    if k % 8 == 3 {
        for a in 0..n {
            for b in 0..a {
                costs[a * n + b] = costs[b * n + a];
            }
        }
    }
    problem.table = Table::new(n, costs);
    problem
}

#[test]
fn certificates_prove_the_bound_and_no_more_than_the_optimum() {
    let mut rng = XorShift::new(23);
    let (mut open, mut paired, mut ordered, mut directed, mut higher) = (0, 0, 0, 0, 0);
    let (mut sum, mut sum_least) = (0.0, 0.0);
    for k in 0..800_u64 {
        let problem = of_every_kind(&mut rng, k);
        let least = solve::exact(&problem).unwrap().cost;
        let (value, certificate) = certified(&problem, least, 150_000);
        let seconds = proven(&problem, &certificate).unwrap();
        assert_eq!(seconds.to_bits(), certificate.seconds().to_bits());
        let rounding = 1e-6 + 1e-9 * least;
        assert!(seconds <= least + 1e-9 * least.abs(), "{k}: {seconds} above {least}");
        assert!(seconds >= value - rounding, "{k}: {seconds} is less than {value}");
        // The check also remembers what may not come any more because of precedence.
        let is_ordered =
            !problem.pairs.is_empty() || problem.items.iter().any(|i| i.before.is_some() || i.rank > 0);
        assert!(is_ordered || seconds <= value + rounding, "{k}: {seconds} is more than {value}");
        higher += i32::from(seconds > value + rounding);
        open += i32::from(!problem.closed);
        paired += i32::from(problem.nodes.iter().any(|n| n.entry != n.exit));
        ordered += i32::from(is_ordered);
        directed += i32::from(problem.table().is_some_and(|t| !t.is_symmetric()));
        (sum, sum_least) = (sum + seconds, sum_least + least);
    }
    assert!(sum >= 0.95 * sum_least, "{sum} of {sum_least} proven");
    let kinds = [open, paired, ordered, directed];
    assert!(kinds.iter().all(|&cases| cases > 50) && higher < 50, "{kinds:?}, {higher}");
}

/// Contours that are entered anywhere, with holes that come first.
#[test]
fn contours_entered_anywhere() {
    for seed in 0..24 {
        let (problem, least) = entered_anywhere(1 + usize::try_from(seed).unwrap() % 3, seed);
        let (value, certificate) = certified(&problem, least, 5_000_000);
        assert!(certificate.knots.iter().any(|knots| knots.len() > 2));
        let seconds = proven(&problem, &certificate).unwrap();
        assert!(
            seconds <= least && seconds >= value - 1e-6 - 1e-9 * least,
            "{seed}: {value}, {seconds}, {least}"
        );
    }
}

/// More contours than have a table of legs for each pair: the bound has cuts, and legs priced by boxes.
#[test]
fn sheets_with_cuts_and_far_contours() {
    for (name, closed) in [("length", true), ("co2-100w", false)] {
        let mut machine = machine(name);
        machine.return_home = closed;
        let problem = problem_of(&nested_sheet(75, 5), &machine);
        assert!(problem.items.len() > 65);
        let mut search = solve::methods()[0].start(&problem, 1, None);
        search.step(300_000);
        let cost = search.best().cost;
        let mut bound = LowerBound::new(&problem);
        while bound.certificate(&problem, f64::NEG_INFINITY).is_none_or(|c| c.cuts.len() < 3) {
            assert!(bound.improve(100_000_000, 1.5 * cost), "there are cuts");
        }
        // They get prices.
        bound.improve(500_000_000, 1.5 * cost);
        let certificate = bound.certificate(&problem, f64::NEG_INFINITY).unwrap();
        let near: usize = certificate.near.iter().map(Vec::len).sum();
        assert!(near < problem.items.len() * problem.items.len() / 3);
        let (seconds, value) = (proven(&problem, &certificate).unwrap(), bound.value());
        let rounding = 1e-5 + 1e-8 * cost;
        assert!(seconds <= cost && seconds >= value - rounding, "{name}: {seconds} of {value}");
        // Nobody gets it for a bound that is higher.
        assert_eq!(bound.certificate(&problem, value), None);
        // Prices of cuts count.
        let without = WalkCertificate { cuts: Vec::new(), ..certificate };
        let less = proven(&problem, &without).unwrap();
        assert!((less - seconds).abs() > 1e-6 * value, "{name}: {less} of {seconds} without cuts");
    }
}

/// Some numbers of the list, in ascending order.
pub(crate) fn some(rng: &mut XorShift, from: usize, count: usize, of_ten: u64) -> Vec<usize> {
    (from..count).filter(|_| rng.below(10) < of_ten).collect()
}

/// A cut of some items, or of some knots of items beside them.
pub(crate) fn cut(
    rng: &mut XorShift,
    count: usize,
    knots: &[usize],
    paired: &[bool],
    price: i64,
) -> PricedCut {
    let first = count - knots.len();
    let members = some(rng, first, count, 3);
    let mut parts: Vec<Part> = Vec::new();
    for item in some(rng, first, count, 3).into_iter().filter(|i| !members.contains(i)) {
        let step = if paired[item - first] { 2 } else { 1 };
        let ends = some(rng, 0, knots[item - first] / step, 5);
        let knots: Vec<usize> = ends.into_iter().flat_map(|k| step * k..step * (k + 1)).collect();
        parts.push(Part { item, knots });
    }
    let at = usize::try_from(rng.below(2)).unwrap();
    let visited = if members.is_empty() || rng.below(2) == 0 { parts.get(at) } else { None };
    PricedCut { visited: visited.map(|p| p.item), members, parts, price }
}

/// For each item besides home its number of knots, and whether it is an open contour.
pub(crate) fn knots_of(problem: &Problem) -> (Vec<usize>, Vec<bool>) {
    let given = problem.table().is_some();
    let mut items: Vec<(usize, bool)> = (problem.items.iter())
        .map(|i| {
            let nodes = &problem.nodes[i.nodes.start as usize..i.nodes.end as usize];
            let paired = !given && nodes.iter().any(|n| n.entry != n.exit);
            (nodes.len(), paired)
        })
        .collect();
    if given {
        items.rotate_right(1);
        items.remove(0);
    }
    items.into_iter().unzip()
}

/// Whatever the numbers are, no more than the optimum is proven: charges, ng-sets, near items, and cuts by the places in them.
#[test]
fn any_numbers_prove_no_more_than_the_optimum() {
    let mut rng = XorShift::new(31);
    let (mut more, mut less, mut through) = (0, 0, 0);
    for k in 0..1500_u64 {
        let problem = of_every_kind(&mut rng, k);
        let least = solve::exact(&problem).unwrap().cost;
        let (_, good) = certified(&problem, least, 30_000);
        let before = proven(&problem, &good).unwrap();
        let given = problem.table().is_some();
        let count = good.charges.len();
        let (knots, paired) = knots_of(&problem);
        let first = count - knots.len();
        for turn in 0..5 {
            let mut changed = good.clone();
            let size = 1 + good.charges.iter().map(|c| c.abs()).max().unwrap() / 4;
            let mut any = |most: i64| i64::try_from(rng.below(u64::try_from(most).unwrap())).unwrap();
            if turn % 2 == 0 {
                changed.charges[first..].iter_mut().for_each(|c| *c += any(2 * size) - size);
            }
            if turn > 0 {
                for _ in 0..3 {
                    let price = if turn == 4 { 8 * size } else { 1 + size / 3 };
                    let cut = cut(&mut rng, count, &knots, &paired, price);
                    through += i32::from(cut.visited.is_some());
                    changed.cuts.push(cut);
                }
                changed.cuts.retain(|c| c.visited.is_some() || !c.members.is_empty());
            }
            if turn == 3 {
                (first..count).for_each(|i| changed.ng_sets[i] = some(&mut rng, first, count, 6));
                if !given {
                    (first..count).for_each(|i| changed.near[i] = some(&mut rng, i + 1, count, 7));
                }
            }
            // All legs are priced by boxes, which cuts make cheaper, too.
            if turn == 4 && !given {
                changed.near.iter_mut().for_each(Vec::clear);
            }
            let seconds = proven(&problem, &changed).unwrap();
            assert!(seconds <= least + 1e-9 * least.abs(), "{k}, {turn}: {seconds} above {least}");
            more += i32::from(seconds > before);
            less += i32::from(seconds < before);
        }
    }
    assert!(more > 50 && less > 1000 && through > 1000, "{more} {less} {through}");
}

/// What walks remember decides what they prove.
#[test]
fn without_ng_sets_less_is_proven() {
    let (mut rng, mut less) = (XorShift::new(5), 0);
    for k in 0..60_u64 {
        let problem = scattered(&mut rng, 7 + 8 * (k % 9));
        let (_, good) = certified(&problem, solve::exact(&problem).unwrap().cost, 150_000);
        let with = proven(&problem, &good).unwrap();
        let without = WalkCertificate { ng_sets: vec![Vec::new(); good.ng_sets.len()], ..good };
        let without = proven(&problem, &without).unwrap();
        assert!(without <= with);
        less += i32::from(without < with - 1.0);
    }
    assert!(less > 20, "{less}");
}

/// Walks stop as often as there are items. With 2,048 charges of 2^50 they seemed to go nowhere, and a bound that was too high was proven.
#[test]
fn charges_whose_sums_do_not_fit_are_refused() {
    let point = |item: u32| Node {
        item,
        entry: DVec2::new(f64::from(item), 0.0),
        exit: DVec2::new(f64::from(item), 0.0),
        along: 0.0,
        reversed: false,
        twin: item,
    };
    let (count, machine) = (1_100_u32, machine("length"));
    let problem = Problem {
        items: (0..count).map(|i| Item { nodes: i..i + 1, ..Item::default() }).collect(),
        nodes: (0..count).map(point).collect(),
        ..Problem::empty(machine)
    };
    let all = 1 + count as usize;
    let lists = vec![Vec::new(); all];
    let charges = |each: i64| (0..all).map(|i| if i == 0 { 0 } else { each }).collect();
    let certificate = WalkCertificate {
        unit: -27,
        knots: vec![Vec::new(); all],
        near: lists.clone(),
        ng_sets: lists,
        charges: charges(1 << 50),
        ..WalkCertificate::default()
    };
    let why = certificate.adds_up_to(&problem).unwrap_err().to_string();
    assert_eq!(why, "The charges of the certificate do not fit the problem.");
}

#[test]
fn lists_that_do_not_fit_are_refused() {
    let problem = scattered(&mut XorShift::new(3), 14);
    let (_, good) = certified(&problem, 1000.0, 100_000);
    let home = good.charges.len() - problem.items.len();
    let refused = |change: &dyn Fn(&mut WalkCertificate)| {
        let mut changed = good.clone();
        change(&mut changed);
        assert_ne!(changed, good);
        changed.adds_up_to(&problem).unwrap_err().to_string()
    };
    let fault = |of: &str| format!("The {of} of the certificate do not fit the problem.");
    for change in [
        &|c: &mut WalkCertificate| c.charges.push(0) as _,
        &|c: &mut WalkCertificate| c.charges[0] = 1,
        &|c: &mut WalkCertificate| c.charges[2] = i64::MAX,
        &|c: &mut WalkCertificate| c.charges[2] = i64::MIN,
    ] as [&dyn Fn(&mut WalkCertificate); 4]
    {
        assert_eq!(refused(change), fault("charges"));
    }
    for change in [
        &|c: &mut WalkCertificate| c.ng_sets.truncate(2),
        &|c: &mut WalkCertificate| c.ng_sets[2] = vec![0],
        &|c: &mut WalkCertificate| c.ng_sets[2] = vec![4, 3],
        &|c: &mut WalkCertificate| c.ng_sets[2] = vec![3, 3],
        &|c: &mut WalkCertificate| c.ng_sets[2] = vec![usize::MAX],
        &|c: &mut WalkCertificate| c.ng_sets[0] = vec![3],
    ] as [&dyn Fn(&mut WalkCertificate); 6]
    {
        assert_eq!(refused(change), fault("lists of company"));
    }
    for change in [
        &|c: &mut WalkCertificate| c.near.truncate(2),
        &|c: &mut WalkCertificate| c.near[3] = vec![2],
        &|c: &mut WalkCertificate| c.near[3] = vec![99],
        &|c: &mut WalkCertificate| c.near[0] = vec![2],
    ] as [&dyn Fn(&mut WalkCertificate); 4]
    {
        assert_eq!(refused(change), fault("near items"));
    }
    let cut = |members: Vec<usize>, parts: Vec<Part>, visited, price| {
        refused(&move |c| {
            c.cuts.push(PricedCut { members: members.clone(), parts: parts.clone(), visited, price });
        })
    };
    assert_eq!(cut(vec![home], Vec::new(), None, -1), fault("cuts"));
    assert_eq!(cut(vec![home], Vec::new(), None, i64::MAX), fault("cuts"));
    assert_eq!(cut(vec![0], Vec::new(), None, 1), fault("cuts"));
    assert_eq!(cut(Vec::new(), Vec::new(), None, 1), fault("cuts"));
    assert_eq!(cut(vec![home], Vec::new(), Some(home), 1), fault("cuts"));
    assert_eq!(cut(Vec::new(), vec![Part { item: home, knots: vec![99] }], Some(home), 1), fault("cuts"));
    assert_eq!(refused(&|c| c.knots[home] = vec![0.0]), fault("knots"));
    assert_eq!(refused(&|c| c.unit += 1), fault("units"));
    let mixed = |items, speed, ramps| MixedLegs { items, speed, ramps };
    for change in [
        vec![mixed([2, 1], 0, 0)],
        vec![mixed([2, 2], 0, 0)],
        vec![mixed([1, 99], 0, 0)],
        vec![mixed([1, 2], (1 << 20) + 1, 0)],
        vec![mixed([1, 2], 0, u32::MAX)],
        vec![mixed([1, 2], 0, 0), mixed([1, 2], 1, 1)],
    ] {
        assert_eq!(refused(&move |c| c.mixtures.clone_from(&change)), fault("mixtures"));
    }
    let mut leaves = machine("length");
    leaves.pre_cut_time = Some(0.0);
    let leaves = problem_of(&nested_sheet(5, 1), &leaves);
    let why = good.check(&leaves).unwrap_err();
    assert_eq!(why, CertificateFault::Problem);
    assert_eq!(why.to_string(), "The problem has no bound of the kind that the certificate is of.");
    // With a table of costs, boxes mean nothing.
    let mut given = scattered(&mut XorShift::new(3), 14);
    let n = given.nodes.len();
    given.table = Table::new(n, vec![1.0; n * n]);
    (given.pairs, given.closed) = (Vec::new(), true);
    given.items.iter_mut().for_each(|i| (i.before, i.rank) = (None, 0));
    let (_, mut table) = certified(&given, 10.0, 100_000);
    table.near[1].clear();
    assert_eq!(table.check(&given), Err(CertificateFault::Shape("near items")));
}

/// A certificate whose check would take hours or terabytes is refused in a moment, before anything is made.
#[test]
fn what_takes_too_long_to_check_is_refused() {
    let problem = problem_of(&nested_sheet(40, 5), &machine("length"));
    let (_, good) = certified(&problem, 2000.0, 100_000_000);
    let count = good.charges.len();
    let refused = |certificate: WalkCertificate, of: &str| {
        let start = Instant::now();
        let why = certificate.check(&problem).unwrap_err();
        assert_eq!(why.to_string(), format!("The certificate has more {of} than are checked."));
        assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
    };
    let mut remembers_all = good.clone();
    (1..count).for_each(|i| remembers_all.ng_sets[i] = (1..count).collect());
    refused(remembers_all, "states of walks");
    let knots = |n: u32| {
        let mut certificate = good.clone();
        for (knots, item) in certificate.knots[1..].iter_mut().zip(&problem.items) {
            let Some(length) = item.track.as_ref().map(|t| t.length()) else { continue };
            *knots = (0..n).map(|k| length * f64::from(k) / f64::from(n)).collect();
        }
        certificate
    };
    refused(knots(20_000), "knots");
    refused(WalkCertificate { ng_sets: vec![Vec::new(); count], ..knots(2000) }, "legs between knots");
    let mut remembers_some = knots(2000);
    (1..count).for_each(|i| remembers_some.ng_sets[i] = (i + 1..count.min(i + 9)).collect());
    refused(remembers_some, "knots in states of walks");
    let mut slow = knots(130);
    slow.cuts = vec![PricedCut { members: vec![1], parts: Vec::new(), visited: None, price: 1 }; 2000];
    refused(slow, "sums of legs");
    // More contours than the check has sets for.
    let many = problem_of(&nested_sheet(4_200, 3), &machine("length"));
    let knots = many.items.iter().map(|i| i.track.as_ref().map_or(Vec::new(), |_| vec![0.0]));
    let certificate = WalkCertificate { knots: [Vec::new()].into_iter().chain(knots).collect(), ..good };
    assert_eq!(certificate.check(&many), Err(CertificateFault::TooMuch("items")));
}
