//! When the stops of a sequence end, and what is due before each because of heat.
//!
//! A change of a window moves everything after it in time. It is replayed from the beginning of the window until all stops have moved by
//! the same seconds for as long as cuts stay hot: from then on, what is due is what it was.
//!
//! Where a cut may be begun in more than one way, which of them is best depends on when it is reached (`begin.rs`). What is due then includes what the
//! best way takes longer than the quickest one, which is what legs are.

use super::begin::{Beginning, hot};
use super::visit::Visit;
use crate::heat::Cooling;

/// Times that differ by less are the same, s.
const SAME: f64 = 1e-9;

/// A window of a sequence that has changed.
#[derive(Clone, Copy)]
pub(super) struct Window {
    /// Position of its first stop.
    pub(super) low: usize,
    /// Number of stops that went from its beginning to its end, if all else kept its order.
    pub(super) rotated: Option<usize>,
}

/// The price of a beginning, by when the cut begins and the seconds that it takes (`begin.rs`).
pub(super) type Price<'a> = dyn Fn(Option<f64>, f64) -> f64 + 'a;

/// A place in a stretch of stops that keep their order.
struct Stretch {
    /// The position that the stop had.
    old: usize,
    /// Whether the stretch begins with it.
    first: bool,
    /// Number of stops of the stretch after it.
    rest: usize,
}

impl Window {
    /// The stretch of the stop at `k`, where the window ends before `high`, of `all` stops.
    fn stretch(self, k: usize, high: usize, all: usize) -> Option<Stretch> {
        if k >= high {
            return Some(Stretch { old: k, first: k == high, rest: all - 1 - k });
        }
        let ahead = self.rotated?;
        // The window is now the stops from `turn` on, and then those before it.
        let (turn, seam) = (self.low + ahead, high - ahead);
        Some(if k < seam {
            Stretch { old: k + ahead, first: k == self.low, rest: seam - 1 - k }
        } else {
            Stretch { old: k + turn - high, first: k == seam, rest: high - 1 - k }
        })
    }
}

/// The times of a sequence.
pub(super) struct Clock<'p> {
    cooling: &'p Cooling,
    /// By position: when the stop ends, s.
    ends: Vec<f64>,
    /// By position: the seconds that are waited or charged before the stop.
    dues: Vec<f64>,
    /// The same of the stops that were last replayed.
    new_ends: Vec<f64>,
    new_dues: Vec<f64>,
}

impl<'p> Clock<'p> {
    pub(super) fn new(cooling: &'p Cooling) -> Self {
        let none = Vec::new;
        Self { cooling, ends: none(), dues: none(), new_ends: none(), new_dues: none() }
    }

    /// The times of a new sequence; returns the seconds of all that is due. `best`: as for [`Clock::replay`].
    pub(super) fn begin(
        &mut self,
        visits: &[Visit],
        legs: &[f64],
        best: impl Fn(usize, &Price<'_>) -> Option<Beginning>,
    ) -> f64 {
        self.ends = vec![f64::INFINITY; visits.len()];
        self.dues = vec![0.0; visits.len()];
        let due = self.replay(visits, legs, &[], Window { low: 0, rotated: None }, best).0;
        self.keep(0);
        due
    }

    /// What is due before the stop at a position, s.
    pub(super) fn due(&self, k: usize) -> f64 {
        self.dues.get(k).copied().unwrap_or(0.0)
    }

    /// What is due in a window and before the stops that begin while it is hot, s.
    pub(super) fn due_near(&self, low: usize, high: usize) -> f64 {
        let cool =
            high.checked_sub(1).and_then(|k| self.ends.get(k)).map_or(0.0, |e| e + self.cooling.seconds());
        // The stop before it has ended by then.
        let begun = |k: usize| k.checked_sub(1).and_then(|b| self.ends.get(b)).is_none_or(|e| *e <= cool);
        let within = |k: &usize| *k <= high || begun(*k);
        (low..self.ends.len()).take_while(within).map(|k| self.due(k)).sum()
    }

    /// The position of the last cut that is hot when the stop at `k` is reached.
    pub(super) fn hot(&self, visits: &[Visit], k: usize) -> Option<usize> {
        let visit = visits.get(k).filter(|_| self.due(k) > 0.0)?;
        let arrival =
            self.ends.get(k)? - visit.seconds - if self.cooling.waits() { self.due(k) } else { 0.0 };
        let recent = |j: &usize| self.ends.get(*j).is_some_and(|e| arrival - e < self.cooling.seconds());
        let is_near = |j: &usize| visits.get(*j).is_some_and(|v| self.cooling.are_near(v.item, visit.item));
        (0..k).rev().take_while(recent).find(is_near)
    }

    /// Replays the stops from the beginning of a window on; `new_legs` has the legs of the window and the one after it. Returns by how much
    /// more is due than before, s, and how many stops were looked at. [`Clock::keep`] makes it so. `best`: the best way to begin the cut at a position by a
    /// price; `None` if there is but one.
    pub(super) fn replay(
        &mut self,
        visits: &[Visit],
        legs: &[f64],
        new_legs: &[f64],
        window: Window,
        best: impl Fn(usize, &Price<'_>) -> Option<Beginning>,
    ) -> (f64, u64) {
        let (cooling, low) = (self.cooling, window.low);
        let high = low + new_legs.len().saturating_sub(1);
        self.new_ends.clear();
        self.new_dues.clear();
        let ended =
            |ends: &[f64], k: usize| k.checked_sub(1).and_then(|b| ends.get(b)).copied().unwrap_or(0.0);
        let mut now = ended(&self.ends, low);
        let (mut more, mut looked_at) = (0.0, 0);
        // The stops from here on have moved by the same seconds, and when the one before them ended, now and before.
        let mut steady = (f64::NAN, [now, now]);
        let mut k = low;
        while let Some(visit) = visits.get(k) {
            let leg = new_legs.get(k - low).or(legs.get(k)).copied().unwrap_or(0.0);
            let before = now;
            let replayed = self.new_ends.iter().zip(visits.iter().skip(low)).rev();
            let kept = self.ends.iter().zip(visits).take(low).rev();
            let cut = replayed.chain(kept).map(|(end, v)| (v.item, *end));
            let cost = match best(k, &hot(cooling, visit.item, now, cut.clone())) {
                Some(best) => {
                    now = best.end(cooling, now, visit.seconds);
                    best.price - leg
                }
                None => {
                    let arrival = now + leg;
                    let due = cooling.due(visit.item, arrival, cut);
                    now = arrival + due.wait + visit.seconds;
                    cooling.cost(due)
                }
            };
            self.new_ends.push(now);
            self.new_dues.push(cost);
            more += cost - self.due(k);
            looked_at += 1;
            let stretch = window.stretch(k, high, visits.len());
            k += 1;
            // What is in another order is replayed stop by stop.
            let Some(Stretch { old, first, rest }) = stretch else { continue };
            let old_end = self.ends.get(old).copied().unwrap_or(now);
            let shift = now - old_end;
            // No shift from an end that is not known yet.
            let is_steady = (shift - steady.0).abs() <= SAME;
            if first || !is_steady {
                steady = (shift, [before, ended(&self.ends, old)]);
                continue;
            }
            if now - steady.1[0] < cooling.seconds() || old_end - steady.1[1] < cooling.seconds() {
                continue;
            }
            if k > high {
                break;
            }
            // The rest of the stretch moves as one, as long as its legs are what they were.
            for old in old + 1..=old + rest {
                let (leg, new_leg) = (legs.get(old), new_legs.get(k - low));
                if leg.zip(new_leg).is_none_or(|(a, b)| a.total_cmp(b).is_ne()) {
                    break;
                }
                now = self.ends.get(old).copied().unwrap_or(0.0) + shift;
                let due = self.due(old);
                self.new_ends.push(now);
                self.new_dues.push(due);
                more += due - self.due(k);
                k += 1;
            }
        }
        (more, looked_at)
    }

    /// Takes over what was last replayed, from `low` on.
    pub(super) fn keep(&mut self, low: usize) {
        let stop = low + self.new_ends.len();
        let last = stop.checked_sub(1).and_then(|k| self.ends.get(k));
        let shift = self.new_ends.last().zip(last).map_or(0.0, |(new, old)| new - old);
        if let (Some(ends), Some(dues)) = (self.ends.get_mut(low..stop), self.dues.get_mut(low..stop)) {
            ends.copy_from_slice(&self.new_ends);
            dues.copy_from_slice(&self.new_dues);
        }
        self.ends.iter_mut().skip(stop).for_each(|end| *end += shift);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{DVec2, Path, Segment};
    use crate::machine::Heat;
    use crate::solve::rng::{Draw, seeded};
    use crate::solve::traits::Stop;

    /// Replaying a window gives what replaying everything gives, however the window was changed.
    #[test]
    fn a_window_is_replayed_as_if_it_were_everything() {
        let mut rng = seeded(3);
        let count = 120_u32;
        let lines: Vec<Path> = (0..count)
            .map(|k| {
                let at = DVec2::new(f64::from(k % 12) * 10.0, f64::from(k / 12) * 10.0);
                Path::new(vec![Segment::line(at, at + DVec2::X)], false)
            })
            .collect();
        let lines: Vec<Option<&Path>> = lines.iter().map(Some).collect();
        let mut skipped = 0;
        for charge in [None, Some(0.7)] {
            let heat = Heat { distance: 15.0, seconds: 2.0, charge, small_holes: None };
            let Some(cooling) = Cooling::new(&heat, &lines) else { continue };
            let visit = |item: u32| Visit {
                stop: Stop::whole(item, 0.0),
                item,
                entry: DVec2::ZERO,
                exit: DVec2::ZERO,
                extra: 0.0,
                seconds: 0.1 + 0.01 * f64::from(item % 7),
            };
            let mut visits: Vec<Visit> = (0..count).map(visit).collect();
            let leg = |a: &Visit, b: &Visit| 0.01 * f64::from((a.item * 31 + b.item * 17) % 40);
            let legs_of = |visits: &[Visit]| -> Vec<f64> {
                let between = visits.windows(2).map(|w| leg(&w[0], &w[1]));
                std::iter::once(0.3).chain(between).chain([0.2]).collect()
            };
            let mut legs = legs_of(&visits);
            let mut clock = Clock::new(&cooling);
            let mut total = clock.begin(&visits, &legs, |_, _| None);
            for _ in 0..600 {
                let low = rng.below(visits.len() - 2);
                let high = low + 2 + rng.below(visits.len() - 1 - low);
                let ahead =
                    if rng.below(2) == 0 { 1 + rng.below((high - low - 1).min(3)) } else { high - low - 1 };
                visits[low..high].rotate_left(ahead);
                let changed = legs_of(&visits);
                let window = Window { low, rotated: Some(ahead) };
                let (more, looked_at) =
                    clock.replay(&visits, &legs, &changed[low..=high], window, |_, _| None);
                skipped += visits.len() as u64 - low as u64 - looked_at;
                clock.keep(low);
                (legs, total) = (changed, total + more);
                let mut whole = Clock::new(&cooling);
                let all = whole.begin(&visits, &legs, |_, _| None);
                assert!((all - total).abs() < 1e-6, "{all} s, not {total} s");
                let off = whole.ends.iter().zip(&clock.ends).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(off < 1e-6 && whole.dues.iter().zip(&clock.dues).all(|(a, b)| (a - b).abs() < 1e-6));
            }
        }
        assert!(skipped > 10_000, "{skipped} stops were not looked at");
    }
}
