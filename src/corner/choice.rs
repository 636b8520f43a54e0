//! Which corners of a cut are cut otherwise: those with which it takes the least time.
//!
//! A corner changes the speed of the head only as far from it as the head needs to reach its speed, v^2 / (2 a). So corners at
//! least twice as far apart do not depend on each other, and a change of some is priced on the cut around them alone. Corners
//! that are nearer are tried in all combinations up to [`ALL`] of them; longer rows are improved one by one and in pairs.

use super::turned::{Corner, turned};
use crate::geometry::Segment;
use crate::machine::{Process, Profile, process_time};

/// Number of near corners that are tried in all combinations: 256 of them.
const ALL: usize = 8;
/// Seconds that a change has to save: sums of thousands of numbers are off by less.
const SAVES: f64 = 1e-9;
/// Rounds of improving a long row of corners; most rows are done after two.
const ROUNDS: usize = 8;

/// A corner on a cut.
#[derive(Clone, Copy)]
struct On {
    corner: usize,
    /// The element before it.
    element: usize,
    /// Distance from the beginning of the cut, mm.
    along: f64,
}

/// The corners that are cut otherwise in a cut from rest to rest, by their place in the list, in the order of the cut. `on`: the
/// elements of the contour, among leads and an overcut.
pub fn chosen(
    machine: &Profile,
    process: &Process,
    path: &[Segment],
    on: std::ops::Range<usize>,
    corners: &[Corner],
) -> Vec<usize> {
    let reach = process.accel.map_or(0.0, |a| process.speed * process.speed / a);
    let cut = Cut { machine, process, path, on, corners, reach };
    let all = cut.corners_on();
    let mut taken = Vec::new();
    let is_near = |a: &On, b: &On| {
        let trims = [a, b].iter().filter_map(|c| corners.get(c.corner)).map(|c| c.trim).sum::<f64>();
        b.along - a.along - trims < reach
    };
    for near in all.chunk_by(is_near) {
        taken.extend(if near.len() <= ALL { cut.best(near) } else { cut.improved(near) });
    }
    taken
}

struct Cut<'a> {
    machine: &'a Profile,
    process: &'a Process,
    path: &'a [Segment],
    on: std::ops::Range<usize>,
    corners: &'a [Corner],
    /// Distance from which corners do not depend on each other, mm.
    reach: f64,
}

impl Cut<'_> {
    fn corners_on(&self) -> Vec<On> {
        let mut along = 0.0;
        let mut all = Vec::new();
        for (element, pair) in self.path.windows(2).enumerate() {
            along += pair[0].length();
            if self.on.contains(&element)
                && self.on.contains(&(element + 1))
                && let Some(corner) = self.corners.iter().position(|c| c.is_between(&pair[0], &pair[1]))
            {
                all.push(On { corner, element, along });
            }
        }
        all
    }

    /// The first and the last element of the cut around some corners. From rest at both ends, it is long enough that these do not
    /// matter to what a change of the corners saves.
    fn window(&self, around: &[On]) -> [usize; 2] {
        let (Some(first), Some(last)) = (around.first(), around.last()) else { return [0, 0] };
        let length = |k: usize| self.path.get(k).map_or(0.0, Segment::length);
        let (mut from, mut left) = (first.element, self.reach - length(first.element));
        while left > 0.0 && from > 0 {
            from -= 1;
            left -= length(from);
        }
        let (mut to, mut left) = (last.element + 1, self.reach - length(last.element + 1));
        while left > 0.0 && to + 1 < self.path.len() {
            to += 1;
            left -= length(to);
        }
        [from, to]
    }

    /// Seconds of a part of the cut, with the corners of `taken`.
    fn seconds(&self, [from, to]: [usize; 2], taken: &[usize]) -> f64 {
        let on = self.on.start.saturating_sub(from)..self.on.end.saturating_sub(from);
        let path = self.path.get(from..=to).unwrap_or_default();
        process_time(self.machine, self.process, false, &turned(path, on, self.corners, taken).0)
    }

    /// The best of all combinations.
    fn best(&self, near: &[On]) -> Vec<usize> {
        let window = self.window(near);
        let mut best: (Vec<usize>, f64) = (Vec::new(), self.seconds(window, &[]));
        for set in 1_u32..1 << near.len() {
            let taken: Vec<usize> =
                near.iter().enumerate().filter(|(k, _)| set >> k & 1 == 1).map(|(_, c)| c.corner).collect();
            let seconds = self.seconds(window, &taken);
            if seconds < best.1 - SAVES {
                best = (taken, seconds);
            }
        }
        best.0
    }

    /// A combination that no change of one corner, or of two neighbours, makes better.
    fn improved(&self, near: &[On]) -> Vec<usize> {
        let mut taken = vec![false; near.len()];
        // The corners taken between two elements.
        let list = |[from, to]: [usize; 2], taken: &[bool]| -> Vec<usize> {
            let among = near.partition_point(|c| c.element < from)..near.partition_point(|c| c.element < to);
            among.filter(|&k| taken[k]).map(|k| near[k].corner).collect()
        };
        for _ in 0..ROUNDS {
            let mut changed = false;
            for first in 0..near.len() {
                for count in 1..=2 {
                    let Some(around) = near.get(first..first + count) else { continue };
                    let window = self.window(around);
                    let change = |taken: &mut [bool]| {
                        taken[first..first + count].iter_mut().for_each(|t| *t = !*t);
                    };
                    let before = self.seconds(window, &list(window, &taken));
                    change(&mut taken);
                    if self.seconds(window, &list(window, &taken)) < before - SAVES {
                        changed = true;
                    } else {
                        change(&mut taken);
                    }
                }
            }
            if !changed {
                break;
            }
        }
        list([0, usize::MAX], &taken)
    }
}
