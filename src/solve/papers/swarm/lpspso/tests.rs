//! The flights and step 7, checked by hand.
#![allow(clippy::float_cmp, reason = "the numbers of the examples are exact")]

use super::super::particles::Swarm;
use super::super::rules::Levy;
use super::super::settings::SwarmSettings;
use super::guide::LpspsoGuide;
use super::parameters::{Flights, Lpspso, Stagnation};
use crate::problem::Problem;
use crate::solve::Solver;
use crate::solve::papers::keys::Decode;
use crate::solve::papers::test_sheet::sheet;
use crate::solve::rng::Draw;
use crate::solve::rng::seeded;

fn points() -> Problem {
    sheet(&[&[[0.0, 0.0]], &[[1.0, 0.0]], &[[2.0, 0.0]], &[[3.0, 0.0]]], None, "length")
}

#[test]
fn equations_21_and_22_by_hand() {
    let problem = points();
    let fly = |decode, flights| {
        let by = Lpspso { flights, levy_step: 1.0, ..Lpspso::default() };
        let settings = SwarmSettings { particles: 1, decode, ..by.settings };
        let mut swarm = Swarm::new(&problem, 4, &settings);
        swarm.particles[0].keys = vec![0.125, 0.375, 0.625, 0.875];
        let mut guide = LpspsoGuide::new(by);
        guide.alpha = 0.25;
        guide.fly(&mut swarm, 0, 0..4);
        swarm.particles.remove(0).keys
    };
    // Each key moves by alpha times a Levy step of its own, and stays between 0 and 1.
    let (levy, mut rng) = (Levy::new(1.5), seeded(4));
    let moved = [0.125, 0.375, 0.625, 0.875].map(|x: f64| (x + 0.25 * levy.step(&mut rng)).clamp(0.0, 1.0));
    assert_eq!(fly(Decode::Keys, Flights::Keys), moved);
    // A permutation takes the order of these keys.
    let ranked = fly(Decode::Permutation, Flights::Keys);
    let below = |a: usize, b: usize| moved[a] < moved[b];
    assert!((0..4).all(|a| (0..4).all(|b| !below(a, b) || ranked[a] < ranked[b])), "{moved:?} {ranked:?}");
    // An insertion: one step, then the item, as drawn.
    let mut rng = seeded(4);
    let step = levy.step(&mut rng);
    let k = rng.below(4);
    let to = (k as f64 + if step.abs() < 1.0 { step.signum() } else { step }).round().clamp(0.0, 3.0);
    let inserted = fly(Decode::Permutation, Flights::Insertion);
    assert_eq!(inserted[k], (to + 0.5) / 4.0, "{inserted:?}");
}

#[test]
fn step_7_by_hand() {
    let stagnates = |stagnation, idle, kappa| {
        let mut guide = LpspsoGuide::new(Lpspso { stagnation, ..Lpspso::default() });
        (guide.idle, guide.kappa, guide.tau) = (idle, kappa, 0.5);
        (guide.stagnates(Stagnation::Chaos), guide.stagnates(Stagnation::Step4), guide.idle)
    };
    // After ten iterations without a gain below the threshold, and only as the reading has it.
    assert_eq!(stagnates(Stagnation::Chaos, 10, 0.4), (true, false, 0));
    assert_eq!(stagnates(Stagnation::Step4, 10, 0.4), (false, true, 0));
    assert_eq!(stagnates(Stagnation::Step4, 9, 0.4), (false, false, 9));
    assert_eq!(stagnates(Stagnation::Step4, 10, 0.6), (false, false, 10));
}

#[test]
fn going_back_to_step_4_takes_a_swarm_of_evaluations_within_one_iteration() {
    // The first path is the best there is, so the swarm stagnates again and again.
    let problem = points();
    let moves = |stagnation| {
        let settings = SwarmSettings { particles: 8, rounds: 40, ..Lpspso::default().settings };
        let by = Lpspso { settings, stagnation, patience: 2, ..Lpspso::default() };
        let mut search = by.start(&problem, 3, None);
        while search.step(1000).status != crate::solve::Status::Exhausted {}
        (search.insight().map(|i| i.round), search.telemetry().moves)
    };
    let (chaos, back) = (moves(Stagnation::Chaos), moves(Stagnation::Step4));
    assert_eq!(chaos.0, back.0, "as many iterations");
    assert!(back.1 > chaos.1, "{back:?} {chaos:?}");
}
