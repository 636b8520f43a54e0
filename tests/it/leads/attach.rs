//! The search with leads against "plan, then attach leads": the order is planned without leads, and each contour then gets the
//! lead that is nearest to its entry.
#![allow(clippy::print_stdout, reason = "the comparison is a table")]

use crate::testkit::leads::{attached, leads, oriented, with_leads};
use crate::testkit::sheets::{machine, nested_sheet};
use crate::testkit::{fixtures, name};
use kerfway::job::{LoadOptions, problem_of};
use kerfway::machine::{LeadKind, Profile};
use kerfway::problem::Problem;
use kerfway::sheet::{self, Sheet};
use kerfway::solve;
use std::time::{Duration, Instant};

fn machine_with_leads(name: &str) -> Profile {
    with_leads(machine(name), leads(LeadKind::Arc, 0.5, 0.2))
}

#[test]
fn the_joint_search_is_never_slower_than_attaching_leads_afterwards() {
    let mut gain = 0.0;
    for seed in 0..20 {
        let sheet = oriented(nested_sheet(25, seed));
        let machine = machine_with_leads("fibre-3kw-thin");
        let with = problem_of(&sheet, &machine);
        let without = problem_of(&sheet, &Profile { leads: None, ..machine });
        let best = |problem: &Problem| {
            let mut search = solve::methods()[0].start(problem, seed, None);
            search.step(60_000);
            search.best().clone()
        };
        let (joint, after) = (best(&with).cost, attached(&with, &without, &best(&without)));
        assert!(joint <= after + 1e-9, "seed {seed}: {joint} s together, {after} s one after the other");
        gain += after - joint;
    }
    assert!(gain > 0.0);
    println!("20 nests of 25 contours: {:.3} s saved on average", gain / 20.0);
}

/// Prints the table of the docs: `cargo test --release --test it leads::attach -- --ignored --nocapture`.
#[test]
#[ignore = "minutes of search; its figures are in docs/leads.md"]
fn table_of_sheets() {
    let seconds = 8.0;
    for (sheet_name, seeds) in [("sheet_100", 5), ("sheet_500", 5), ("sheet_2000", 5), ("sheet_10000", 2)] {
        let path = fixtures().join("sheets").join(format!("{sheet_name}.dxf"));
        let sheet = read(&path);
        let machine = machine_with_leads("fibre-3kw-thin");
        let begun = Instant::now();
        let with = problem_of(&sheet, &machine);
        let prepared = begun.elapsed();
        let begun = Instant::now();
        let without = problem_of(&sheet, &Profile { leads: None, ..machine });
        let plain = begun.elapsed();
        let total: f64 = with.items.iter().map(|i| i.fixed).sum();
        let (mut saved, mut rate) = (Vec::new(), [0, 0]);
        for seed in 0..seeds {
            let mut best = |problem: &Problem, which: usize| {
                let mut search = solve::methods()[0].start(problem, seed, None);
                let end = Instant::now() + Duration::from_secs_f64(seconds);
                while Instant::now() < end {
                    search.step(2_000);
                }
                rate[which] += search.telemetry().moves;
                search.best().clone()
            };
            let joint = best(&with, 0).cost;
            let after = attached(&with, &without, &best(&without, 1));
            saved.push((after - joint, after + total));
        }
        let mean = saved.iter().map(|s| s.0).sum::<f64>() / saved.len() as f64;
        let least = saved.iter().map(|s| s.0).fold(f64::INFINITY, f64::min);
        let with_lead = with
            .items
            .iter()
            .filter(|i| i.leads.as_ref().is_some_and(|l| l.outcome.lead_in <= kerfway::lead::Fit::Moved))
            .count();
        let closed = sheet.contours.iter().filter(|c| c.path.closed && c.is_processed()).count();
        println!(
            "{}: {mean:.3} s saved on average of {:.1} s, least {least:.3}; moves {:.0} % of those without leads; prepared in {:.0} ms (without leads {:.0}); {with_lead} of {closed} closed contours have the full lead",
            name(&path),
            saved[0].1,
            100.0 * rate[0] as f64 / rate[1] as f64,
            1e3 * prepared.as_secs_f64(),
            1e3 * plain.as_secs_f64(),
        );
    }
}

fn read(path: &std::path::Path) -> Sheet {
    let options = LoadOptions::default();
    let drawing =
        kerfway::dxf::read(&std::fs::read(path).unwrap(), &options.read_options().unwrap()).unwrap();
    sheet::build(&drawing, &options.sheet_options().unwrap())
}
