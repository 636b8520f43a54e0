//! Pierce groups on a lattice by brute force: every order and direction of their elements.
//!
//! Shares nothing with those who plan but the elements' geometry: what hangs on the sheet is found by filling the cells of
//! the lattice from outside, seconds are added up here.

use kerfway::geometry::DVec2;
use kerfway::machine::{Profile, Travel};
use kerfway::sheet::PierceGroup;
use std::collections::HashMap;

/// Side of a cell, mm.
pub(crate) const CELL: f64 = 10.0;

pub(crate) type Point = [i32; 2];

/// A place on the lattice. All corners are on it.
fn point(p: DVec2) -> Point {
    let q = p / CELL;
    assert!(q.distance(q.round()) < 1e-9, "{p} is not on the lattice");
    [q.x.round() as i32, q.y.round() as i32]
}

/// Seconds of an air move, each axis from rest to rest by itself.
pub(crate) fn air(machine: &Profile, a: DVec2, b: DVec2) -> f64 {
    assert_eq!(machine.travel, Travel::PerAxis);
    let d = (b - a).abs().to_array();
    let axis = |k: usize| {
        let (v, a) = (machine.rapid.speed[k], machine.rapid.accel.unwrap()[k]);
        if d[k] < v * v / a { 2.0 * (d[k] / a).sqrt() } else { d[k] / v + v / a }
    };
    axis(0).max(axis(1))
}

struct Element {
    ends: [usize; 2],
    /// Pairs of cells it parts.
    walls: Vec<[Point; 2]>,
    /// All its corners, ends among them.
    corners: Vec<DVec2>,
    length: f64,
}

/// A group by hand.
pub(crate) struct ByHand<'m> {
    machine: &'m Profile,
    pub(crate) nodes: Vec<DVec2>,
    elements: Vec<Element>,
    /// By elements cut: which may be cut next, and nodes at which something has come loose.
    known: HashMap<usize, (usize, usize)>,
    /// Nodes at which an element ends that may be the last.
    last: Vec<usize>,
    /// Least seconds by start and end.
    least: Vec<Vec<f64>>,
}

/// What has been done.
#[derive(Clone)]
struct Done {
    cut: usize,
    head: usize,
    visited: usize,
    /// Nodes at which the beam has stopped in time.
    ready: usize,
    /// Seconds of all runs that have ended, and all between.
    seconds: f64,
    /// The run at work: its corners.
    run: Vec<DVec2>,
}

impl<'m> ByHand<'m> {
    /// Least seconds from each node to each, of everything that is done in a group.
    pub(crate) fn new(group: &PierceGroup, machine: &'m Profile) -> Self {
        let mut all = Self::net(group, machine);
        let full = (1 << all.count()) - 1;
        for e in 0..all.count() {
            if all.stand(full ^ 1 << e).0 >> e & 1 == 1 {
                let ends = all.elements[e].ends;
                all.last.extend(ends);
            }
        }
        for start in 0..all.nodes.len() {
            // Without pre-cuts, the beam begins again on any kerf of the group.
            let ready = if machine.pre_cut_time.is_none() { usize::MAX } else { 0 };
            let done = Done { cut: 0, head: usize::MAX, visited: 0, ready, seconds: 0.0, run: Vec::new() };
            all.go_on(start, &done);
        }
        all
    }

    /// The elements of a group and the cells of the lattice that they part.
    pub(crate) fn net(group: &PierceGroup, machine: &'m Profile) -> Self {
        let mut nodes: Vec<DVec2> = Vec::new();
        let mut elements = Vec::new();
        for e in &group.elements {
            let path = group.path(e);
            let mut corners = vec![path.segments[0].start()];
            let mut walls = Vec::new();
            for s in &path.segments {
                let (a, b) = (point(s.start()), point(s.end()));
                let (dx, dy) = ((b[0] - a[0]).signum(), (b[1] - a[1]).signum());
                assert!(dx == 0 || dy == 0, "a line that is not along the lattice");
                let steps = (b[0] - a[0]).abs().max((b[1] - a[1]).abs());
                for k in 0..steps {
                    // The lower left end of this bit.
                    let (x, y) = (a[0] + dx * k + dx.min(0), a[1] + dy * k + dy.min(0));
                    walls.push(if dx == 0 { [[x - 1, y], [x, y]] } else { [[x, y - 1], [x, y]] });
                }
                corners.push(s.end());
            }
            let ends = [corners[0], *corners.last().unwrap()].map(|p| {
                nodes.iter().position(|n| point(*n) == point(p)).unwrap_or_else(|| {
                    nodes.push(p);
                    nodes.len() - 1
                })
            });
            let length = corners.windows(2).map(|c| c[0].distance(c[1])).sum();
            elements.push(Element { ends, walls, corners, length });
        }
        let least = vec![vec![f64::INFINITY; nodes.len()]; nodes.len()];
        Self { machine, nodes, elements, known: HashMap::new(), last: Vec::new(), least }
    }

    /// Whether a cell lies in an area of the group.
    pub(crate) fn covers(&self, cell: Point) -> bool {
        let all = (1 << self.count()) - 1;
        let cells = self.elements.iter().flat_map(|e| e.walls.iter().flatten());
        let within = |k: usize| {
            let span = || cells.clone().map(|c| c[k]);
            (span().min().unwrap()..=span().max().unwrap()).contains(&cell[k])
        };
        within(0) && within(1) && !self.held(all).contains(&cell)
    }

    /// The nodes where an element ends, and its length.
    pub(crate) fn element(&self, e: usize) -> ([usize; 2], f64) {
        (self.elements[e].ends, self.elements[e].length)
    }

    pub(crate) fn count(&self) -> usize {
        self.elements.len()
    }

    /// Least seconds from a place through the group to a place.
    pub(crate) fn between(&self, from: DVec2, to: DVec2) -> f64 {
        let all = (0..self.nodes.len()).flat_map(|a| (0..self.nodes.len()).map(move |b| [a, b]));
        let seconds = |[a, b]: [usize; 2]| {
            air(self.machine, from, self.nodes[a]) + self.least[a][b] + air(self.machine, self.nodes[b], to)
        };
        all.map(seconds).fold(f64::INFINITY, f64::min)
    }

    /// The cells that hang on the sheet when these elements are cut: they are filled from outside, through everything that is
    /// not cut.
    pub(crate) fn held(&self, cut: usize) -> std::collections::HashSet<Point> {
        let cells = || self.elements.iter().flat_map(|e| e.walls.iter().flatten());
        let span =
            |k: usize| cells().map(|c| c[k]).min().unwrap() - 1..=cells().map(|c| c[k]).max().unwrap() + 1;
        let (xs, ys) = (span(0), span(1));
        let is_cut = |a: Point, b: Point| {
            (0..self.elements.len()).any(|e| {
                cut >> e & 1 == 1 && self.elements[e].walls.iter().any(|w| *w == [a, b] || *w == [b, a])
            })
        };
        let mut queue = vec![[*xs.start(), *ys.start()]];
        let mut held = std::collections::HashSet::new();
        while let Some(c) = queue.pop() {
            if xs.contains(&c[0]) && ys.contains(&c[1]) && held.insert(c) {
                let next = [[c[0] + 1, c[1]], [c[0] - 1, c[1]], [c[0], c[1] + 1], [c[0], c[1] - 1]];
                queue.extend(next.into_iter().filter(|n| !is_cut(c, *n)));
            }
        }
        held
    }

    /// What may be cut next, and where something is loose, when these elements are cut.
    pub(crate) fn stand(&mut self, cut: usize) -> (usize, usize) {
        if let Some(known) = self.known.get(&cut) {
            return *known;
        }
        let held = self.held(cut);
        let hangs = |e: &Element| e.walls.iter().flatten().any(|c| held.contains(c));
        let may = (0..self.elements.len()).filter(|&e| cut >> e & 1 == 0 && hangs(&self.elements[e]));
        let fell = |n: &DVec2| {
            let [x, y] = point(*n);
            [[x, y], [x - 1, y], [x, y - 1], [x - 1, y - 1]].iter().any(|c| !held.contains(c))
        };
        let loose = (0..self.nodes.len()).filter(|&n| fell(&self.nodes[n]));
        let known = (may.fold(0, |s, e| s | 1 << e), loose.fold(0, |s, n| s | 1 << n));
        self.known.insert(cut, known);
        known
    }

    /// Seconds of a run from rest to rest: at one speed, or as the machine counts them.
    fn run(&self, corners: &[DVec2]) -> f64 {
        if self.machine.cut.accel.is_none() {
            return corners.windows(2).map(|c| c[0].distance(c[1])).sum::<f64>() / self.machine.cut.speed;
        }
        let line = |c: &[DVec2]| kerfway::geometry::Segment::line(c[0], c[1]);
        let path: Vec<_> = corners.windows(2).map(line).collect();
        kerfway::machine::cut_time(self.machine, &self.machine.cut, &path)
    }

    fn go_on(&mut self, start: usize, done: &Done) {
        let (may, loose) = self.stand(done.cut);
        let begin = self.machine.beam_on_delay + self.machine.beam_off_delay;
        let pre_cut = self.machine.pre_cut_time.unwrap_or(0.0);
        if done.cut + 1 == 1 << self.elements.len() {
            let seconds = done.seconds + self.run(&done.run);
            let least = &mut self.least[start][done.head];
            *least = least.min(seconds);
            return;
        }
        // Seconds so far and of all cutting to come, at full speed: too many for any end that there can be.
        let uncut = (0..self.count()).filter(|e| done.cut >> e & 1 == 0);
        let left: f64 = uncut.map(|e| self.elements[e].length).sum();
        let worst = self.last.iter().map(|&end| self.least[start][end]).fold(0.0, f64::max);
        if done.seconds + self.run(&done.run) + left / self.machine.cut.speed > worst + 1e-9 {
            return;
        }
        // Elements that continue from the head come first, so that good orders are found early.
        let count = self.count();
        let ways =
            move |goes_on: bool| (0..count).flat_map(move |e| [(e, false, goes_on), (e, true, goes_on)]);
        for (e, back, goes_on) in ways(true).chain(ways(false)) {
            if may >> e & 1 == 1 && goes_on == (self.elements[e].ends[usize::from(back)] == done.head) {
                let mut corners = self.elements[e].corners.clone();
                let [mut from, mut to] = self.elements[e].ends;
                if back {
                    corners.reverse();
                    (from, to) = (to, from);
                }
                if done.cut == 0 && from != start {
                    continue;
                }
                let mut next = done.clone();
                let mut also = None;
                if from == done.head {
                    // On, or on after a stop in which pre-cuts are made.
                    if (done.ready | loose) >> from & 1 == 0 {
                        let mut stopped = done.clone();
                        stopped.seconds += self.run(&done.run) + begin;
                        stopped.run = Vec::new();
                        stopped.ready |= 1 << from;
                        also = Some(stopped);
                    }
                } else {
                    next.seconds += self.run(&done.run) + begin;
                    next.run = Vec::new();
                    if done.cut != 0 {
                        next.seconds += air(self.machine, self.nodes[done.head], self.nodes[from]);
                        next.ready |= 1 << done.head & !loose;
                    }
                    if done.visited >> from & 1 == 0 {
                        next.seconds += self.machine.pierce_time;
                        next.ready |= 1 << from;
                    } else if next.ready >> from & 1 == 1 {
                        next.seconds += pre_cut;
                    } else {
                        continue;
                    }
                }
                for mut next in std::iter::once(next).chain(also) {
                    if loose >> to & 1 == 1 {
                        if next.ready >> to & 1 == 0 {
                            continue;
                        }
                        next.seconds += pre_cut;
                    }
                    next.cut |= 1 << e;
                    next.head = to;
                    next.visited |= 1 << from | 1 << to;
                    let skip = usize::from(!next.run.is_empty());
                    next.run.extend(&corners[skip..]);
                    self.go_on(start, &next);
                }
            }
        }
    }
}
