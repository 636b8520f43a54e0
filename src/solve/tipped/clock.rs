//! When the stops of a sequence end, and what is due before each because of heat.
//!
//! A change of a window moves everything after it in time. It is replayed from the beginning of the window until all stops have moved by
//! the same seconds for as long as cuts stay hot: from then on, what is due is what it was.

use super::visit::Visit;
use crate::heat::Cooling;

/// Times that differ by less are the same, s.
const SAME: f64 = 1e-9;

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

    /// The times of a new sequence; returns the seconds of all that is due.
    pub(super) fn begin(&mut self, visits: &[Visit], legs: &[f64]) -> f64 {
        self.ends = vec![f64::INFINITY; visits.len()];
        self.dues = vec![0.0; visits.len()];
        let due = self.replay(visits, legs, &[], 0).0;
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

    /// Replays the stops from `low` on; `window` has the legs that differ from `legs`, from that to `low` on. Returns by how much more is due than
    /// before, s, and how many stops were looked at. [`Clock::keep`] makes it so.
    pub(super) fn replay(
        &mut self,
        visits: &[Visit],
        legs: &[f64],
        window: &[f64],
        low: usize,
    ) -> (f64, u64) {
        let cooling = self.cooling;
        self.new_ends.clear();
        self.new_dues.clear();
        let mut now = low.checked_sub(1).and_then(|k| self.ends.get(k)).copied().unwrap_or(0.0);
        let mut more = 0.0;
        // The stops from here on have moved by the same seconds, and when the one before it ended, now and before.
        let mut steady = (f64::NAN, [now, now]);
        for (k, visit) in visits.iter().enumerate().skip(low) {
            let leg = window.get(k - low).or(legs.get(k)).copied().unwrap_or(0.0);
            let arrival = now + leg;
            let replayed = self.new_ends.iter().zip(visits.iter().skip(low)).rev();
            let kept = self.ends.iter().zip(visits).take(low).rev();
            let due = cooling.due(visit.item, arrival, replayed.chain(kept).map(|(end, v)| (v.item, *end)));
            let cost = cooling.cost(due);
            let before = [now, k.checked_sub(1).and_then(|b| self.ends.get(b)).copied().unwrap_or(0.0)];
            now = arrival + due.wait + visit.seconds;
            self.new_ends.push(now);
            self.new_dues.push(cost);
            let (old_end, old_due) = (self.ends.get(k).copied().unwrap_or(now), self.due(k));
            more += cost - old_due;
            let shift = now - old_end;
            let same = (shift - steady.0).abs() <= SAME;
            if k - low < window.len() || !same {
                steady = (shift, before);
            } else if now - steady.1[0] >= cooling.seconds() && old_end - steady.1[1] >= cooling.seconds() {
                break;
            }
        }
        (more, self.new_ends.len() as u64)
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
