//! Shifts of parts against an exhaustive choice: every order of the parts, and every neighbour that each may be moved to.
#![allow(clippy::print_stdout, reason = "the figures of docs/levers.md")]

use super::made::KERF;
use super::shifted::{made, shifting};
use super::together::divide;
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use crate::testkit::rng::seeded;
use kerfway::geometry::{Aabb, DVec2};
use kerfway::job::Job;
use kerfway::job::{LoadOptions, MachineChoice, PlanOptions};
use rand::RngExt;
use std::collections::HashSet;

const MOST: f64 = 0.5;
const NEAR: f64 = 1e-6;
/// Distances that differ by this are one, mm: the tolerance of copies.
const ONE: f64 = 0.01 + NEAR;
/// Least length over which sides that are one kerf apart save a cut, mm.
const FACING: f64 = 1.0;

/// Three to six parts of a plate that is cut across, 0.4 mm more than a kerf apart, and each moved by up to 0.18 mm in x and in y.
fn nest(seed: u64) -> Vec<Aabb> {
    let mut rng = seeded(seed);
    let gap = KERF + 0.4;
    let mut all = vec![[100.0, 100.0, 90.0, 70.0]];
    let mut below = |n: i32| rng.random_range(0..n);
    let count = 3 + below(4) as usize;
    while all.len() < count {
        divide(&mut all, gap, &mut below);
    }
    let mut moved = |low: f64, size: f64| {
        let by = 0.03 * f64::from(below(13) - 6);
        (low + by, low + by + size)
    };
    let boxed = |[x, y, w, h]: [f64; 4]| {
        let ((x0, x1), (y0, y1)) = (moved(x, w), moved(y, h));
        Aabb { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) }
    };
    all.into_iter().map(boxed).collect()
}

fn placed(part: Aabb, by: DVec2) -> Aabb {
    Aabb { min: part.min + by, max: part.max + by }
}

/// How far a box begins after the end of another, in x and in y; below zero if they overlap there.
fn gaps(a: Aabb, b: Aabb) -> DVec2 {
    (a.min - b.max).max(b.min - a.max)
}

/// Length of the sides of two boxes that are one kerf apart, mm.
fn shared(a: Aabb, b: Aabb) -> f64 {
    let gap = gaps(a, b);
    let over = |along: f64| if -along > FACING { -along } else { 0.0 };
    let one = |gap: f64, along: f64| if (gap - KERF).abs() < ONE { over(along) } else { 0.0 };
    one(gap.x, gap.y) + one(gap.y, gap.x)
}

fn all_shared(parts: &[Aabb]) -> f64 {
    let pairs = parts.iter().enumerate().flat_map(|(k, a)| parts[..k].iter().map(move |b| shared(*a, *b)));
    pairs.sum()
}

/// The most length that two boxes can share when each is moved.
fn potential(a: Aabb, b: Aabb) -> f64 {
    let gap = gaps(a, b);
    let one = |gap: f64, along: f64| {
        let in_reach = gap <= KERF + 2.0 * MOST && -along + 2.0 * MOST > FACING;
        if in_reach { 2.0 * MOST - along } else { 0.0 }
    };
    one(gap.x, gap.y).max(one(gap.y, gap.x))
}

/// The greatest length that parts can share, each moved in x and in y to neighbours where they are at the time, in any order.
struct Exhaustive<'p> {
    parts: &'p [Aabb],
    seen: HashSet<Vec<Option<(i64, i64)>>>,
    best: f64,
}

impl Exhaustive<'_> {
    /// The greatest length, if it is more than what is known.
    fn of(parts: &[Aabb], known: f64) -> f64 {
        let mut search = Exhaustive { parts, seen: HashSet::new(), best: known };
        search.extend(&mut vec![None; parts.len()]);
        search.best
    }

    /// What is shared, and may be when the parts that are left have their place.
    fn bound(&self, by: &[Option<DVec2>]) -> f64 {
        let pair = |j: usize, k: usize| match (by[j], by[k]) {
            (Some(a), Some(b)) => shared(placed(self.parts[j], a), placed(self.parts[k], b)),
            _ => potential(self.parts[j], self.parts[k]),
        };
        (0..by.len()).flat_map(|k| (0..k).map(move |j| pair(j, k))).sum()
    }

    fn extend(&mut self, by: &mut Vec<Option<DVec2>>) {
        let key = |v: f64| (v * 1e6).round() as i64;
        let state = by.iter().map(|b| b.map(|b| (key(b.x), key(b.y)))).collect();
        if self.bound(by) <= self.best + NEAR || !self.seen.insert(state) {
            return;
        }
        if by.iter().all(Option::is_some) {
            self.best = self.bound(by);
        }
        for k in (0..by.len()).filter(|&k| by[k].is_none()).collect::<Vec<_>>() {
            let own = self.parts[k];
            let others = (0..by.len()).filter(|&j| j != k && potential(own, self.parts[j]) > 0.0);
            let now: Vec<Aabb> = others.map(|j| placed(self.parts[j], by[j].unwrap_or_default())).collect();
            let along = |low: fn(DVec2) -> f64| {
                let to = now
                    .iter()
                    .flat_map(move |d| [low(d.min) - KERF - low(own.max), low(d.max) + KERF - low(own.min)]);
                [0.0].into_iter().chain(to.filter(|s| s.abs() <= MOST)).collect::<Vec<f64>>()
            };
            let (xs, ys) = (along(|p| p.x), along(|p| p.y));
            for to in xs.iter().flat_map(|x| ys.iter().map(|y| DVec2::new(*x, *y))) {
                let is_clear = |j: usize| {
                    let Some(b) = by[j] else { return true };
                    gaps(placed(own, to), placed(self.parts[j], b)).max(DVec2::ZERO).length() > KERF - ONE
                };
                if to.length() <= MOST + NEAR && (0..by.len()).all(is_clear) {
                    by[k] = Some(to);
                    self.extend(by);
                    by[k] = None;
                }
            }
        }
    }
}

#[test]
fn offered_shifts_against_every_order_and_every_neighbour() {
    let (mut offered, mut best, mut equal) = (0.0, 0.0, 0);
    for seed in 0..100 {
        let parts = nest(seed);
        let outlines: Vec<_> = parts
            .iter()
            .map(|p| rectangle([p.min.x, p.min.y, p.max.x - p.min.x, p.max.y - p.min.y]))
            .collect();
        let mut job = Job::load(drawing(&outlines), "nest.dxf", &LoadOptions::default()).unwrap();
        let machine = MachineChoice::Profile(Box::new(shifting(MOST, true)));
        job.start(&PlanOptions { machine, allow_off_bed: true, seed: 1, ..PlanOptions::default() }).unwrap();
        let placed = made(&job);
        for (a, b) in (0..placed.len()).flat_map(|k| (0..k).map(move |j| (j, k))) {
            let apart = gaps(placed[a], placed[b]).max(DVec2::ZERO).length();
            assert!(apart > KERF - ONE, "seed {seed}: {a} {b} {apart}");
        }
        let found = all_shared(&placed);
        let most = Exhaustive::of(&parts, found);
        assert!(found >= 0.85 * most, "seed {seed}: {found} of {most}");
        offered += found;
        best += most;
        equal += u32::from(found > most - NEAR);
    }
    println!("{offered:.1} of {best:.1} mm, and all of it on {equal} of 100 nests");
    assert!(offered > 0.99 * best && equal >= 80, "{offered} of {best}, {equal}");
}
