//! The strong bound: walks, charges that drive them to visit every item once, and rounds that sharpen both what walks
//! remember and how finely contours are divided.

use super::net::{Item, homes, items};
use super::order::Order;
use super::pairs::{Pairs, Scan};
use super::prices::Prices;
use super::space::Space;
use super::walks::{Ground, Pass, Visit};
use crate::geometry::DVec2;
use crate::order::{real, sort_by};
use crate::problem::Problem;

/// Nearest items in the company of each item to begin with: with none the first rounds only find that out.
const COMPANY: usize = 4;
/// The most there may be: the states of an item may double with each.
const MOST_COMPANY: usize = 16;
/// Circles and faults of order over more stops than this are left alone: all that lies on them would have to remember.
const LONGEST: usize = 12;
/// Looks at the charges in a round at least, and at most.
const LOOKS: [usize; 2] = [8, 60];
/// A round goes on while this many looks gain this part of what is missing: charges that have settled need not be exact
/// for what they work on to be sharpened.
const WORTH: (usize, f64) = (4, 0.1);
/// Walks kept for a round to learn from: the last ones, when charges have settled.
const KEPT: usize = 12;
/// Looks without a better value after which steps get shorter.
const PATIENCE: usize = 8;
/// By how much.
const SHORTER: f64 = 0.6;
/// What the last direction counts in the next.
const KEEP: f64 = 0.5;
/// Numbers in the rows of a pass and states at most: some 100 MB.
const MOST_NUMBERS: usize = 12_000_000;
/// What is to be done next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Task {
    Scan,
    Table(usize),
    Spaces,
    Row(usize),
    Meet,
    Nothing,
}

/// The strong bound under way.
#[derive(Debug)]
pub(super) struct Strong {
    ground: Ground,
    scan: Scan,
    /// Pairs to have tables.
    wanted: Vec<[usize; 2]>,
    task: Task,
    passes: [Pass; 2],
    /// What each item charges a stop, now and at the best value.
    pay: Vec<f64>,
    best_pay: Vec<f64>,
    way: Vec<f64>,
    share: f64,
    best: f64,
    round_best: f64,
    stalled: usize,
    looks: usize,
    /// The best value of the round some looks ago.
    before: f64,
    walks: Vec<Vec<Visit>>,
    /// The company of each item in the round before.
    company_before: Vec<Vec<usize>>,
    /// Walks cannot remember more: there would be too many states.
    full: bool,
}

impl Strong {
    pub(super) fn new(problem: &Problem) -> Self {
        let items = items(problem);
        let count = items.len();
        let first = homes(problem);
        let prices = Prices::new(problem);
        let order = Order::new(problem, first);
        let scan = Scan::new(&items, first);
        let ground = Ground {
            pairs: Pairs::new(count),
            company: vec![Vec::new(); count],
            spaces: Vec::new(),
            items,
            first,
            prices,
            order,
        };
        Self {
            ground,
            scan,
            wanted: Vec::new(),
            task: Task::Scan,
            passes: <[Pass; 2]>::default(),
            pay: vec![0.0; count],
            best_pay: vec![0.0; count],
            way: vec![0.0; count],
            share: 1.0,
            best: 0.0,
            round_best: f64::NEG_INFINITY,
            stalled: 0,
            looks: 0,
            before: f64::NEG_INFINITY,
            walks: Vec::new(),
            company_before: vec![Vec::new(); count],
            full: false,
        }
    }

    pub(super) fn value(&self) -> f64 {
        self.best
    }

    /// One piece of work; returns how large it was, 0 when nothing is left to do.
    pub(super) fn once(&mut self, upper: f64) -> u64 {
        match self.task {
            Task::Scan => {
                let ground = &self.ground;
                self.scan.next(&ground.items, ground.first, &ground.prices).unwrap_or_else(|| {
                    self.wanted = self.scan.wanted(ground.first, ground.items.len());
                    if ground.prices.directed() {
                        let back: Vec<_> = self.wanted.iter().map(|&[a, b]| [b, a]).collect();
                        self.wanted.extend(back);
                    }
                    self.task = Task::Table(0);
                    1
                })
            }
            Task::Table(next) => {
                let Some(&[a, b]) = self.wanted.get(next) else {
                    self.task = Task::Spaces;
                    return 1;
                };
                let ground = &mut self.ground;
                ground.pairs.add(&ground.items, &ground.prices, [a, b], true);
                self.task = Task::Table(next + 1);
                // A price takes about as long as 16 numbers of a row.
                16 * (ground.items[a].knots * ground.items[b].knots) as u64
            }
            Task::Spaces => self.new_spaces(),
            Task::Row(side) => {
                self.ground.advance(side, &mut self.passes[side], &self.pay);
                if self.passes[side].rows() >= self.ground.stops()[side] {
                    self.task =
                        if side + 1 < self.ground.spaces.len() { Task::Row(side + 1) } else { Task::Meet };
                }
                self.ground.work(side)
            }
            Task::Meet => {
                self.task = Task::Row(0);
                self.look(upper);
                self.passes = <[Pass; 2]>::default();
                1
            }
            Task::Nothing => 0,
        }
    }

    /// Lays out the states of the walks; as they were before, for good, when there would be too many.
    fn new_spaces(&mut self) -> u64 {
        let ground = &mut self.ground;
        if ground.company.iter().all(Vec::is_empty) {
            ground.company = nearest_company(&ground.items, ground.first, &ground.pairs);
        }
        let symmetric = ground.first == 1 && ground.order.is_free() && !ground.prices.directed();
        let sides = if symmetric { 0..1 } else { 0..2 };
        let spaces: Option<Vec<Space>> = sides.map(|side| Space::new(ground, side == 1)).collect();
        if let Some(mut spaces) = spaces {
            spaces.iter_mut().for_each(|s| s.lay_out(|i| ground.items[i].knots));
            ground.spaces = spaces;
            self.task = Task::Row(0);
        } else if self.full {
            self.task = Task::Nothing;
        } else {
            ground.company.clone_from(&self.company_before);
            self.full = true;
        }
        let ground = &self.ground;
        (ground.items.len() * (1 + ground.spaces.iter().map(|s| s.states.len()).sum::<usize>())) as u64
    }

    /// Takes in what the passes found, and moves the charges.
    fn look(&mut self, upper: f64) {
        let Some((sum, walk)) = self.ground.meet(&self.passes, &self.pay) else {
            // No walk at all: the order leaves no tour. Nothing can be said.
            self.task = Task::Nothing;
            return;
        };
        let first = self.ground.first;
        let charges: f64 = self.pay[first..].iter().sum();
        let largest = self.pay.iter().fold(0.0_f64, |m, p| m.max(p.abs()));
        let value = sum - charges;
        // What rounding can add: each of at most 2 n sums of a walk is off by a part in 2^53 of at most n charges and
        // all legs.
        let stops = self.ground.count() as f64;
        let guard = 2.0 * (stops + 2.0) * f64::EPSILON * (stops * largest + value.abs());
        let mut way = vec![-1.0; self.pay.len()];
        for v in &walk {
            way[v.item] += 1.0;
        }
        let tour = way[first..].iter().all(|&w| w == 0.0);
        self.best = self.best.max(value - guard);
        if value > self.round_best + 1e-6 * value.abs() {
            self.round_best = value;
            self.best_pay.clone_from(&self.pay);
            self.stalled = 0;
        } else {
            self.stalled += 1;
            if self.stalled >= PATIENCE {
                self.stalled = 0;
                self.share *= SHORTER;
                self.pay.clone_from(&self.best_pay);
                self.way.fill(0.0);
            }
        }
        self.walks.push(walk);
        if self.walks.len() > KEPT {
            self.walks.remove(0);
        }
        self.looks += 1;
        if self.best >= upper * (1.0 - 1e-10) {
            self.task = Task::Nothing;
        } else if tour || self.settled(upper) {
            self.next_round(upper);
        } else {
            let mut norm = 0.0;
            for (w, d) in self.way.iter_mut().zip(&way).skip(first) {
                *w = *w * KEEP + d;
                norm += *w * *w;
            }
            // Towards the known cost; a little beyond the bound when that is not above it.
            let target = upper.max(value + 1e-3 * value.abs());
            if norm > 0.0 {
                let by = self.share * (target - value) / norm;
                for (p, w) in self.pay.iter_mut().zip(&self.way).skip(first) {
                    *p += by * w;
                }
            }
        }
    }

    /// Whether a round has given what it can.
    fn settled(&mut self, upper: f64) -> bool {
        if !self.looks.is_multiple_of(WORTH.0) {
            return self.looks >= LOOKS[1];
        }
        let gained = self.round_best - self.before;
        self.before = self.round_best;
        self.looks >= LOOKS[0] && gained < WORTH.1 * (upper - self.round_best)
    }

    /// Longer memory where walks went round, halved pieces where legs lost seconds.
    fn next_round(&mut self, upper: f64) {
        self.company_before.clone_from(&self.ground.company);
        let fuller = !self.full && self.remember();
        let finer = self.refine(upper);
        let width: usize = self.ground.spaces.iter().map(|s| s.width + s.steps.len()).sum();
        if !(fuller || finer) || width * self.ground.count() / 2 > MOST_NUMBERS {
            self.task = Task::Nothing;
            return;
        }
        self.pay.clone_from(&self.best_pay);
        self.way.fill(0.0);
        self.round_best = f64::NEG_INFINITY;
        (self.looks, self.stalled, self.before) = (0, 0, f64::NEG_INFINITY);
        // The charges are nearly right already: a third of the first step is enough to follow.
        self.share = 0.3;
        self.walks.clear();
        if finer {
            self.ground.pairs = Pairs::new(self.ground.items.len());
            self.task = Task::Table(0);
        } else {
            self.task = Task::Spaces;
        }
    }

    /// Breaks the shortest faults of the walks, circles and stops out of order: what lies between the two stops
    /// remembers both. No more in a round than there are items, as each may double the states of one.
    fn remember(&mut self) -> bool {
        let order = &self.ground.order;
        let mut faults: Vec<[usize; 3]> = Vec::new();
        for (w, walk) in self.walks.iter().enumerate() {
            for (i, v) in walk.iter().enumerate() {
                let wrong = |other: &Visit| other.item == v.item || order.forbids(v.item, other.item, false);
                let length = walk[i + 1..].iter().take(LONGEST).position(wrong);
                faults.extend(length.map(|length| [length, w, i]));
            }
        }
        sort_by(&mut faults, |c| c.map(|x| x as u64));
        let mut added = 0;
        for [length, w, i] in faults {
            let (walk, last) = (&self.walks[w], i + 1 + length);
            for between in &walk[i + 1..last] {
                for fault in [walk[i].item, walk[last].item] {
                    let company = &mut self.ground.company[between.item];
                    if company.len() < MOST_COMPANY && between.item != fault && !company.contains(&fault) {
                        company.push(fault);
                        added += 1;
                    }
                }
            }
            if added >= self.ground.count() {
                break;
            }
        }
        added > 0
    }

    /// Halves the pieces at knots between which legs of the walks cost less than they should.
    fn refine(&mut self, upper: f64) -> bool {
        let ground = &self.ground;
        if !ground.items.iter().any(Item::can_halve) {
            return false;
        }
        // What an average leg may lose without counting.
        let little = 0.1 * (upper - self.best).max(0.0) / ground.count() as f64;
        let mut marks: Vec<Vec<bool>> = ground.items.iter().map(|i| vec![false; i.pieces.len()]).collect();
        let mut any = false;
        let home = Visit { item: 0, knot: 0 };
        for walk in &self.walks {
            let mut last = home;
            for &v in walk.iter().chain(ground.first.eq(&1).then_some(&home)) {
                let (a, b) = (&ground.items[last.item], &ground.items[v.item]);
                let left = if a.paired { last.knot ^ 1 } else { last.knot };
                if lost(ground, last.item, left, v) > little {
                    for (item, knot, i) in [(a, left, last.item), (b, v.knot, v.item)] {
                        for (mark, piece) in marks[i].iter_mut().zip(&item.pieces) {
                            if item.can_halve() && piece.knots.contains(&knot) {
                                *mark = true;
                                any = true;
                            }
                        }
                    }
                }
                last = v;
            }
        }
        if any {
            for (item, marked) in self.ground.items.iter_mut().zip(&marks) {
                if marked.contains(&true)
                    && let Some(finer) = item.halved(marked)
                {
                    *item = finer;
                }
            }
        }
        any
    }
}

/// What a leg between two knots costs less than it should.
fn lost(ground: &Ground, item: usize, knot: usize, to: Visit) -> f64 {
    let pair =
        ground.pairs.of[item].iter().find(|&&(e, side)| ground.pairs.list[e].items[1 - side] == to.item);
    let Some(&(e, side)) = pair else { return 0.0 };
    let (a, b) = (&ground.items[item], &ground.items[to.item]);
    let table = ground.pairs.table(&ground.pairs.list[e], a.knots * b.knots);
    let seconds = if side == 0 { table[knot * b.knots + to.knot] } else { table[to.knot * a.knots + knot] };
    ground.prices.minorant.air().seconds(place(a, knot), place(b, to.knot)) - seconds
}

fn place(item: &Item, knot: usize) -> DVec2 {
    let piece = item.pieces.iter().find(|p| p.knots[0] == knot);
    piece.map_or(DVec2::ZERO, |p| p.ends[0])
}

/// The nearest few items of each.
fn nearest_company(items: &[Item], first: usize, pairs: &Pairs) -> Vec<Vec<usize>> {
    let mut company = vec![Vec::new(); items.len()];
    for (i, list) in company.iter_mut().enumerate().skip(first) {
        let mut near: Vec<(usize, f64)> = pairs.of[i]
            .iter()
            .map(|&(e, side)| (pairs.list[e].items[1 - side], pairs.list[e].least))
            .filter(|n| n.0 >= first)
            .collect();
        sort_by(&mut near, |n| [real(n.1), n.0 as u64, 0]);
        list.extend(near.iter().take(COMPANY).map(|n| n.0));
    }
    company
}
