//! Instances in the plane with more nodes than a table of costs may have: valid tours with rounded lengths, and what is refused.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "lengths are sums of whole numbers")]

use crate::testkit::rng::seeded;
use glam::DVec2;
use kerfway::job::Solving;
use kerfway::problem::{Fault, check, instance};
use rand::RngExt;
use std::fmt::Write;

/// Towns in the plane, and the set of each: the square of a grid in which it lies.
struct Towns {
    at: Vec<[i32; 2]>,
    sets: Vec<Vec<usize>>,
}

const SIDE: i32 = 100_000;

fn towns(count: usize, squares: usize) -> Towns {
    let mut rng = seeded(7);
    let mut any = || rng.random_range(0..SIDE);
    let at: Vec<[i32; 2]> = (0..count).map(|_| [any(), any()]).collect();
    let mut sets = vec![Vec::new(); squares * squares];
    let square = |x: i32| usize::try_from(x).unwrap() * squares / usize::try_from(SIDE).unwrap();
    for (k, [x, y]) in at.iter().enumerate() {
        sets[square(*y) * squares + square(*x)].push(k);
    }
    sets.retain(|set| !set.is_empty());
    Towns { at, sets }
}

impl Towns {
    fn file(&self, weights: &str) -> String {
        let mut text = format!(
            "NAME : towns\nTYPE : GTSP\nDIMENSION : {}\nGTSP_SETS : {}\nEDGE_WEIGHT_TYPE : {weights}\nNODE_COORD_SECTION\n",
            self.at.len(),
            self.sets.len()
        );
        for (k, [x, y]) in (1..).zip(&self.at) {
            writeln!(text, "{k} {x} {y}").unwrap();
        }
        text += "GTSP_SET_SECTION\n";
        for (k, set) in (1..).zip(&self.sets) {
            let members: Vec<String> = set.iter().map(|n| (n + 1).to_string()).collect();
            writeln!(text, "{k} {} -1", members.join(" ")).unwrap();
        }
        text + "EOF\n"
    }

    /// The length of a tour by the numbers of the file, rounded leg by leg.
    fn length(&self, tour: &[u32], round: impl Fn(f64) -> f64) -> f64 {
        let at = |n: u32| self.at[n as usize - 1].map(f64::from);
        let next = tour.iter().cycle().skip(1);
        tour.iter()
            .zip(next)
            .map(|(&a, &b)| {
                let (a, b) = (at(a), at(b));
                let d = DVec2::from(a) - DVec2::from(b);
                round(d.dot(d).sqrt())
            })
            .sum()
    }
}

/// The local search once took the rounding of such lengths for gains, for ever.
#[test]
fn a_search_over_coordinates_of_hundreds_of_millions_ends_and_finds_what_it_finds_over_small_ones() {
    // The small ones are those of the large ones that the search works on.
    let [near, far] = [1 << 5, 1 << 13].map(|longer: i32| {
        let towns = towns(5000, 31);
        let towns = Towns { at: towns.at.iter().map(|p| p.map(|x| x * longer)).collect(), ..towns };
        let mut solving = Solving::start(towns.file("EUC_2D").as_bytes(), 1).unwrap();
        solving.step(1_000_000);
        (solving.tour(), solving.length().unwrap() / f64::from(longer))
    });
    assert_eq!(near.0, far.0);
    assert!((near.1 / far.1 - 1.0).abs() < 1e-4, "{} and {}", near.1, far.1);
}

#[test]
fn a_tour_of_five_thousand_nodes_visits_every_set_once_and_is_measured_by_the_file() {
    let towns = towns(5000, 31);
    for (weights, round) in [("EUC_2D", (|d| (d + 0.5).floor()) as fn(f64) -> f64), ("CEIL_2D", f64::ceil)] {
        let text = towns.file(weights);
        let mut solving = Solving::start(text.as_bytes(), 1).unwrap();
        let first = solving.length().unwrap();
        assert_eq!(first, towns.length(&solving.tour(), round), "{weights}");
        solving.step(1_000_000);
        let (tour, last) = (solving.tour(), solving.length().unwrap());
        assert_eq!(last, towns.length(&tour, round), "{weights}");
        assert!(last < 0.85 * first, "{weights}: {last} of {first}");
        assert_eq!(solving.lower_bound(), None);
        let mut of: Vec<usize> = tour
            .iter()
            .map(|&n| towns.sets.iter().position(|set| set.contains(&(n as usize - 1))).unwrap())
            .collect();
        of.sort_unstable();
        assert_eq!(of, (0..towns.sets.len()).collect::<Vec<_>>(), "{weights}");
    }
}

/// The set at which the cycle starts is no item of the search: its node is chosen when a tour is asked for.
#[test]
fn the_start_is_the_best_node_of_its_set() {
    let towns = towns(4001, 20);
    let text = towns.file("EUC_2D");
    let mut solving = Solving::start(text.as_bytes(), 1).unwrap();
    solving.step(200_000);
    let (tour, length) = (solving.tour(), solving.length().unwrap());
    let read = instance(text.as_bytes()).unwrap();
    let smallest = towns.sets.iter().map(Vec::len).min().unwrap();
    let start = towns.sets.iter().find(|set| set.contains(&(tour[0] as usize - 1))).unwrap();
    assert_eq!(start.len(), smallest);
    for &other in start {
        let mut changed = tour.clone();
        changed[0] = u32::try_from(other + 1).unwrap();
        assert!(check(&read, &changed).unwrap() >= length);
    }
}

#[test]
fn faults_of_large_tours_are_named() {
    let towns = towns(4100, 10);
    let text = towns.file("EUC_2D");
    let read = instance(text.as_bytes()).unwrap();
    let solving = Solving::start(text.as_bytes(), 1).unwrap();
    let tour = solving.tour();
    assert_eq!(check(&read, &[&tour[..], &[4101]].concat()), Err(Fault::Unknown(4101)));
    assert_eq!(check(&read, &[&tour[..], &tour[..1]].concat()), Err(Fault::Twice(tour[0])));
    let smallest = towns.sets.iter().min_by_key(|set| set.len()).unwrap();
    let first = u32::try_from(smallest[0] + 1).unwrap();
    assert_eq!(check(&read, &tour[1..]), Err(Fault::Missing(first)));
}

#[test]
fn what_large_instances_may_not_have_is_refused_with_its_line() {
    let text = towns(4100, 10).file("EUC_2D");
    let with = |section: &str| text.replace("EOF\n", section);
    let cases = [
        (with("GTSP_SET_ORDERING\n1 2 -1\nEOF\n"), "GTSP_SET_ORDERING is not read for more than 4000 nodes."),
        (text.replace("EUC_2D", "GEO"), "DIMENSION has to be a number of nodes from 1 to 4000."),
        (
            text.replace("DIMENSION : 4100", "DIMENSION : 100001"),
            "DIMENSION has to be a number of nodes from 1 to 100000.",
        ),
    ];
    for (text, sentence) in cases {
        let refused = instance(text.as_bytes()).unwrap_err().to_string();
        assert!(refused.ends_with(sentence), "{refused}");
    }
}
