//! The improved proximity method, Qu & Du section II.B: a nearest-neighbour tour from every feature point. The shortest
//! path is kept. Its length G has the distance d0 from the origin (eq. (3)); step 5 compares the sums D between contours (eq.
//! (2)), and `shortest` says which of them counts.
//!
//! Steps 1 to 3 are [`NearestNeighbour`]; steps 4 and 5 are here. After a fixed start, each feature point comes second in
//! one path; the paper's only path is among them. A cycle given by a table is rotated to start at the item that it names.
//! All ties of step 5 are kept, and so are the next shortest paths, because the swarm needs many.

use super::super::keys::Keys;
use super::super::legs::Legs;
use super::super::unvisited::{NearestNeighbour, Unvisited};
use super::particles::Swarm;
use crate::problem::NodeId;
use serde::{Deserialize, Serialize};

/// Largest number of steps of all tours that the method constructs, unless a parameter gives another: about a second.
pub(super) const PROXIMITY_STEPS: u64 = 1_000_000;

/// Where the particles of a swarm begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Initial {
    /// At random positions.
    Random,
    /// At the shortest paths of the improved proximity method. The paper says so of LPSPSO only; but its sequences of all
    /// four swarms from a fixed start enter most contours at the nearest point, which random positions do not.
    Proximity,
}

/// What step 5 compares. From a fixed start both are the same where the path does not return.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shortest {
    /// The whole path, with d0: G of eq. (3), and the way back if the machine returns home.
    #[default]
    Whole,
    /// The sum between contours: D of eq. (2), as step 5 is printed.
    Between,
}

/// Gives the particles of a swarm their first positions.
pub(super) struct Initialisation {
    initial: Initial,
    /// Largest number of steps of all tours of the proximity method.
    most: u64,
    shortest: Shortest,
    proximity: Option<Proximity>,
    /// Number of particles that have their keys.
    done: usize,
}

impl Initialisation {
    /// No particle has its keys yet.
    pub(super) fn new(initial: Initial, most: u64, shortest: Shortest) -> Self {
        Self { initial, most, shortest, proximity: None, done: 0 }
    }

    /// Does the next piece and returns its cost, or `None` when every particle has its keys.
    pub(super) fn piece(&mut self, swarm: &mut Swarm) -> Option<u64> {
        let count = swarm.particles.len();
        if self.done == count {
            self.proximity = None;
            return None;
        }
        let cost = swarm.evaluator.keys.count() as u64;
        if self.initial == Initial::Random {
            swarm.draw(self.done, None);
            self.done += 1;
            return Some(cost);
        }
        let (legs, keys) = (&swarm.evaluator.space.legs, &swarm.evaluator.keys);
        let proximity =
            self.proximity.get_or_insert_with(|| Proximity::new(legs, keys, count, self.most, self.shortest));
        if let Some(priced) = proximity.piece(legs, keys, &swarm.all) {
            if let Some(path) = proximity.shorter() {
                swarm.found = Some(path);
            }
            return Some(priced);
        }
        // If there are fewer paths than particles, several particles get the same path and differ by their velocities.
        let path = proximity.paths.get(self.done % proximity.paths.len().max(1)).map(|p| p.1.as_slice());
        swarm.draw(self.done, path);
        self.done += 1;
        Some(cost)
    }
}

/// The method under way.
pub(super) struct Proximity {
    /// Feature points at which tours are still to be started; the last is next.
    starts: Vec<NodeId>,
    walk: Option<NearestNeighbour>,
    shortest: Shortest,
    /// The paths found with their lengths, by [`Shortest`], the shortest first. Equal lengths stay in the order of their starting points.
    pub(super) paths: Vec<(f64, Vec<NodeId>)>,
    keep: usize,
    /// Whether the shortest path is new.
    fresh: bool,
}

impl Proximity {
    /// `keep` is the number of paths to keep, `most` the largest number of steps of all tours together. If there are more
    /// feature points than that allows, evenly spaced ones are used, at least `keep` of them.
    pub(super) fn new(legs: &Legs, keys: &Keys, keep: usize, most: u64, shortest: Shortest) -> Self {
        let problem = legs.problem();
        let fixed = keys.pinned.map(|n| problem.nodes[n as usize].item);
        let points = (0..).zip(&problem.nodes).filter(|(_, n)| Some(n.item) != fixed).map(|(n, _)| n);
        let points: Vec<NodeId> = points.collect();
        let walks = most / (keys.items().len() as u64).max(1);
        let count = points.len().min(usize::try_from(walks).unwrap_or(usize::MAX).max(keep));
        let mut starts: Vec<NodeId> = (0..count).rev().map(|k| points[k * points.len() / count]).collect();
        if points.is_empty() {
            starts.extend(keys.pinned);
        }
        Self { starts, walk: None, shortest, paths: Vec::new(), keep, fresh: false }
    }

    /// The shortest path so far, if it was not returned before.
    pub(super) fn shorter(&mut self) -> Option<Vec<NodeId>> {
        let fresh = std::mem::replace(&mut self.fresh, false);
        self.paths.first().filter(|_| fresh).map(|p| p.1.clone())
    }

    /// Does the next step and returns its cost, or `None` when all tours are complete.
    pub(super) fn piece(&mut self, legs: &Legs, keys: &Keys, all: &Unvisited) -> Option<u64> {
        let problem = legs.problem();
        let Some(walk) = &mut self.walk else {
            let start = self.starts.pop()?;
            let mut begun = vec![start];
            if let Some(fixed) = keys.pinned.filter(|&f| f != start) {
                begun.insert(0, fixed);
            }
            self.walk = Some(NearestNeighbour::new(all.clone(), problem, &begun));
            return Some(problem.nodes.len() as u64);
        };
        if let Some(priced) = walk.step(legs) {
            return Some(priced);
        }
        let mut path = std::mem::take(&mut walk.tour);
        self.walk = None;
        if let Some(at) = path.iter().position(|&n| Some(problem.nodes[n as usize].item) == problem.start()) {
            path.rotate_left(at);
        }
        let length = match self.shortest {
            Shortest::Whole => legs.tour_length(&path),
            Shortest::Between => legs.between_items(&path),
        };
        let cost = path.len() as u64;
        let place = self.paths.partition_point(|p| p.0 <= length);
        self.fresh |= place == 0;
        self.paths.insert(place, (length, path));
        self.paths.truncate(self.keep);
        Some(cost)
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::keys::Decode;
    use super::super::settings::{Draws, SwarmSettings};
    use super::*;
    use crate::problem::Problem;
    use crate::solve::papers::Measure;
    use crate::solve::papers::test_sheet::sheet;

    /// The feature points of seven contours: the worked example, table 2.
    const SEVEN: [&[[f64; 2]]; 7] = [
        &[[5.0, 84.6], [100.7, 5.0], [150.0, 53.6], [93.4, 174.0]],
        &[[56.1, 69.8], [108.4, 70.3], [87.6, 116.5]],
        &[[237.3, 94.8], [288.3, 5.0], [395.6, 50.2], [303.8, 152.0], [313.9, 88.0]],
        &[
            [303.1, 53.4],
            [303.1, 39.7],
            [320.7, 41.2],
            [331.0, 53.4],
            [320.7, 64.1],
            [303.1, 67.9],
            [287.6, 64.1],
            [276.5, 53.4],
            [287.6, 41.2],
        ],
        &[[169.4, 355.2], [31.5, 253.6], [14.0, 276.9], [15.7, 305.3]],
        &[
            [289.7, 279.8],
            [289.7, 204.1],
            [343.5, 226.1],
            [365.0, 279.8],
            [343.5, 333.4],
            [289.7, 355.9],
            [234.2, 333.4],
            [214.7, 279.8],
            [263.1, 226.1],
        ],
        &[
            [289.7, 243.1],
            [316.4, 253.1],
            [326.0, 279.8],
            [316.4, 306.4],
            [289.7, 316.8],
            [263.1, 306.4],
            [253.5, 279.8],
            [263.1, 253.1],
        ],
    ];

    /// A path from the origin over contours with these feature points that does not return.
    fn problem(contours: &[&[[f64; 2]]]) -> Problem {
        Problem { closed: false, ..sheet(contours, None, "length") }
    }

    fn paths(problem: &Problem, first: Option<NodeId>, most: u64) -> Vec<(f64, Vec<NodeId>)> {
        paths_by(Shortest::Whole, problem, first, most)
    }

    fn paths_by(
        shortest: Shortest,
        problem: &Problem,
        first: Option<NodeId>,
        most: u64,
    ) -> Vec<(f64, Vec<NodeId>)> {
        let (legs, keys) = (Legs::new(problem, Measure::Euclidean), Keys::new(problem, first, Decode::Keys));
        let mut proximity = Proximity::new(&legs, &keys, 3, most, shortest);
        let all = Unvisited::all(problem);
        while proximity.piece(&legs, &keys, &all).is_some() {}
        proximity.paths
    }

    #[test]
    fn the_worked_example_of_seven_contours() {
        let problem = problem(&SEVEN);
        // From S12, the paper's path is S12 S22 S31 S48 S62 S71 S51. It prints 709.1; the coordinates give 709.509.
        let fixed = paths(&problem, Some(1), u64::MAX);
        assert_eq!(fixed[0].1, [1, 5, 7, 19, 26, 34, 21]);
        assert!((fixed[0].0 - 709.509_075_257_584).abs() < 1e-9);
        // Over all starting points the shortest path begins at S22, by brute force; the paper's path is the second.
        let free = paths(&problem, None, u64::MAX);
        assert_eq!(free[0].1, [5, 2, 7, 19, 26, 34, 21]);
        assert!((free[0].0 - 682.285_405_481_085).abs() < 1e-9);
        assert_eq!(free[1], fixed[0]);
        // Without d0, as step 5 is printed, another path is the shortest, by brute force.
        let between = paths_by(Shortest::Between, &problem, None, u64::MAX);
        assert_eq!(between[0].1, [21, 31, 39, 10, 17, 2, 5]);
        assert!((between[0].0 - 550.289_184_293).abs() < 1e-8);
        // Even with no steps to spare, as many tours are constructed as paths are kept.
        assert_eq!(paths(&problem, None, 0).len(), 3);
    }

    #[test]
    fn the_standard_swarm_can_begin_at_the_paths_of_the_proximity_method() {
        let problem = problem(&SEVEN);
        let settings = SwarmSettings { particles: 3, ..SwarmSettings::with(0.2, Draws::Key) };
        let first = |initial| {
            let mut swarm = Swarm::new(&problem, 1, &settings);
            let mut initialisation = Initialisation::new(initial, PROXIMITY_STEPS, Shortest::Whole);
            while initialisation.piece(&mut swarm).is_some() {}
            let Swarm { evaluator, particles, .. } = &swarm;
            let tour = |keys: &[f64]| evaluator.keys.tour(&evaluator.space.legs, keys);
            particles.iter().map(|p| tour(&p.keys)).collect::<Vec<_>>()
        };
        let shortest: Vec<Vec<NodeId>> = paths(&problem, None, u64::MAX).into_iter().map(|p| p.1).collect();
        assert_eq!(first(Initial::Proximity), shortest);
        assert!(first(Initial::Random).iter().all(|tour| !shortest.contains(tour)));
    }

    #[test]
    fn ties_are_all_kept_in_the_order_of_their_starts() {
        // Two points at the same distance from the origin: both starts give the same length.
        let problem = problem(&[&[[3.0, 4.0]], &[[4.0, 3.0]]]);
        let both = paths(&problem, None, u64::MAX);
        assert_eq!(both.iter().map(|p| p.1.as_slice()).collect::<Vec<_>>(), [[0, 1], [1, 0]]);
        assert!((both[0].0 - both[1].0).abs() < 1e-12);
    }
}
