//! The methods compared with the optimum of small problems. The optimum is found by trying every order, every entry and
//! every place to leave a contour.

use super::super::entries::cheapest;
use super::super::forest::{Forest, ROOT};
use super::super::gtsp::Gtsp;
use super::super::visits::keeps_precedence;
use super::super::{GtspLk, InitialPartitions, PartitionTree, Pfr, TourRepair};
use super::super::{graph::Graph, pfr};
use super::{graph, near, random, sheet};
use crate::geometry::DVec2;
use crate::problem::{NodeId, Problem};
use crate::solve::rng::seeded;
use crate::solve::{Solution, Solver, Status, exact};

/// What the head is in the middle of, outermost first.
#[derive(Clone)]
enum Open {
    /// A route: its parent node, and whether some of it is cut.
    Route(Option<NodeId>, bool),
    /// A contour: its entry, and the number of nodes passed.
    Contour(NodeId, u32),
}

struct Search<'p> {
    g: Graph<'p>,
    best: f64,
}

impl Search<'_> {
    /// Continues from a point in every possible way.
    fn go(&mut self, open: &mut Vec<Open>, done: &mut Vec<u8>, head: DVec2, cost: f64) {
        if cost >= self.best {
            return;
        }
        match open.last().cloned() {
            None => {}
            Some(Open::Route(at, some)) => {
                if let Some(node) = at.filter(|_| some) {
                    let back = cost + self.g.air(head, self.g.entry(node)) + self.g.charge(node);
                    let route = open.pop();
                    self.go(open, done, self.g.exit(node), back);
                    open.extend(route);
                }
                if at.is_none() && done.iter().all(|&d| d == 2) {
                    let home =
                        if self.g.problem.closed { self.g.air(head, self.g.problem.home) } else { 0.0 };
                    self.best = self.best.min(cost + home);
                }
                for item in
                    (0..).take(done.len()).filter(|&i: &u32| done[i as usize] == 0).collect::<Vec<_>>()
                {
                    for node in self.g.nodes(item) {
                        done[item as usize] = 1;
                        let route = open.pop();
                        open.push(Open::Route(at, true));
                        open.push(Open::Contour(node, 0));
                        let there = cost + self.g.air(head, self.g.entry(node)) + self.g.extra(node);
                        self.go(open, done, self.g.exit(node), there);
                        open.truncate(open.len() - 2);
                        open.extend(route);
                        done[item as usize] = 0;
                    }
                }
            }
            Some(Open::Contour(entry, gone)) => {
                let item = self.g.item(entry);
                let nodes = self.g.nodes(item);
                let count = nodes.end - nodes.start;
                let contour = open.pop();
                if self.g.inner[item as usize].iter().all(|&i| done[i as usize] == 2) {
                    done[item as usize] = 2;
                    self.go(open, done, self.g.exit(entry), cost);
                    done[item as usize] = 1;
                }
                let last = if self.g.may_leave(item) { count } else { 0 };
                for k in gone + 1..last {
                    let node = nodes.start + (entry - nodes.start + k) % count;
                    open.push(Open::Contour(entry, k));
                    open.push(Open::Route(Some(node), false));
                    self.go(open, done, self.g.exit(node), cost);
                    open.truncate(open.len() - 2);
                }
                open.extend(contour);
            }
        }
    }
}

fn optimum(problem: &Problem) -> f64 {
    let mut search = Search { g: graph(problem), best: f64::INFINITY };
    let mut done = vec![0; problem.items.len()];
    search.go(&mut vec![Open::Route(None, false)], &mut done, problem.home, 0.0);
    search.best
}

fn run(method: &dyn Solver, problem: &Problem) -> Solution {
    let mut search = method.start(problem, 1, None);
    while search.step(10_000).status == Status::Running {}
    search.best().clone()
}

#[test]
fn trying_everything_is_the_exact_solver_where_nothing_may_be_left() {
    let mut rng = seeded(8);
    for _ in 0..10 {
        let mut problem = random(4, 3, &mut rng);
        problem.items.iter_mut().for_each(|i| i.leave = None);
        near(optimum(&problem), exact(&problem).unwrap().cost);
    }
}

#[test]
fn no_method_is_below_the_optimum_and_the_tree_is_often_at_it() {
    let mut rng = seeded(9);
    let tree = |start| PartitionTree { start, ..PartitionTree::default() };
    let trees = [InitialPartitions::Pfr, InitialPartitions::Single, InitialPartitions::Each].map(tree);
    let (mut at, mut left, mut built) = (0, 0, 0);
    for round in 0..40 {
        let problem = random(2 + round % 3, 2 + round % 2, &mut rng);
        let optimum = optimum(&problem);
        for method in [&trees[0] as &dyn Solver, &trees[1], &trees[2], &GtspLk::default(), &Pfr::default()] {
            let found = run(method, &problem);
            assert!(found.cost >= optimum - 1e-9, "{}: {} below {optimum}", method.info().name, found.cost);
            left += usize::from(found.stops.len() > problem.items.len());
        }
        let (own, pfr) = (run(&trees[0], &problem).cost, run(&Pfr::default(), &problem).cost);
        assert!(own <= pfr + 1e-9, "improves on PFr: {own} {pfr}");
        at += u32::from(own < optimum + 1e-9);
        built += u32::from(pfr < optimum + 1e-9);
    }
    assert!(at >= 30 && built < at && left > 20, "{at} {built} {left} of 40");
}

/// All orders of these numbers.
fn orders(of: &[u32]) -> Vec<Vec<u32>> {
    if of.is_empty() {
        return vec![Vec::new()];
    }
    let of_rest = |&first: &u32| {
        let rest: Vec<u32> = of.iter().copied().filter(|&i| i != first).collect();
        orders(&rest).into_iter().map(move |order| [vec![first], order].concat())
    };
    of.iter().flat_map(of_rest).collect()
}

#[test]
fn the_gtsp_of_a_partition_is_solved_while_its_parent_node_stays() {
    let mut rng = seeded(14);
    for _ in 0..10 {
        let mut problem = random(6, 3, &mut rng);
        problem.items[0].leave = Some(1.0);
        let g = graph(&problem);
        let mut forest = Forest::new(&g);
        forest.splice(ROOT, 0, vec![0]);
        let route = forest.open(vec![1, 2, 3, 4, 5]);
        forest.hang(&g, route, 1);
        let mut gtsp = Gtsp::new(&g, &mut forest, route, (1, 10_000), &mut 0).unwrap();
        while gtsp.piece().is_some() {}
        gtsp.take(&g, &mut forest);
        let hook = forest.hook(&g, 1);
        let least = orders(&[1, 2, 3, 4, 5]).into_iter().map(|order| {
            let layers: Vec<Vec<NodeId>> = order.iter().map(|&i| g.nodes(i).collect()).collect();
            cheapest(&g, &layers, (hook.out, Some(hook.back)), |n| g.extra(n)).0
        });
        near(forest.route_seconds(&g, route), least.fold(f64::INFINITY, f64::min) + hook.seconds);
        assert_eq!(forest.at(route), Some(1));
    }
}

#[test]
fn a_tour_is_repaired_forwards_or_backwards() {
    // From home outwards at 10, 20 and 30; the last lies inside the first. Forwards 30, 10, 20; backwards 20, 30, 10.
    let mut problem = Problem { closed: false, ..sheet(&[&[[10.0, 0.0]], &[[20.0, 0.0]], &[[30.0, 0.0]]]) };
    problem.items[2].before = Some(0);
    let cost = |repair| run(&GtspLk { repair, ..GtspLk::default() }, &problem).cost;
    near(cost(TourRepair::InnerForward), 60.0);
    near(cost(TourRepair::OuterBack), 50.0);
}

#[test]
fn pfr_leaves_a_contour_where_that_is_cheaper() {
    // 1 is 2 mm to the right of the upper end of 0; 2 lies inside 1.
    let mut problem = sheet(&[&[[0.0, 0.0], [0.0, 10.0]], &[[2.0, 10.0], [2.0, 20.0]], &[[2.0, 12.0]]]);
    problem.items[2].before = Some(1);
    // 2 right and back, and on the way round 1 at (2,10), where it ends: 2 up to (2,12) first.
    let found = run(&Pfr::default(), &problem);
    let path: Vec<(u32, f64)> = found.stops.iter().map(|s| (s.node, s.until)).collect();
    assert_eq!(path, [(0, 1.0), (4, 0.0), (2, 0.0), (1, 0.0)]);
    near(found.cost, 104.0_f64.sqrt().min(148.0_f64.sqrt().min(8.0_f64.sqrt())) + 2.0 + 2.0 + 1.0);
    // If leaving costs more than it saves, the contours are cut whole.
    problem.items[0].leave = Some(100.0);
    let whole = run(&Pfr::default(), &problem);
    assert_eq!(whole.stops.len(), 3);
    near(whole.cost, 148.0_f64.sqrt() + 2.0 + 104.0_f64.sqrt());
}

#[test]
fn pfr_keeps_precedence_on_deep_nestings() {
    let mut rng = seeded(12);
    for _ in 0..20 {
        let problem = random(30, 4, &mut rng);
        let g = graph(&problem);
        let mut construction = pfr::Pfr::new(&g);
        while construction.piece(&g).is_some() {
            assert!(keeps_precedence(&g, &construction.forest), "at every moment");
        }
        assert!(construction.forest.is_sound(&g));
    }
}
