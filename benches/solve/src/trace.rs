//! The curves of a run, for figures: what a method says about itself, every so many rounds.

use kerfway::solve::{Insight, Search};
use serde_json::{Value, json};

/// Values of the curves of one run, by round.
pub struct Trace {
    every: u64,
    next: u64,
    names: Vec<&'static str>,
    rounds: Vec<u64>,
    values: Vec<Vec<f64>>,
}

impl Trace {
    /// Records a run every so many rounds; 0 records nothing.
    pub fn every(every: u64) -> Self {
        Self { every, next: 0, names: Vec::new(), rounds: Vec::new(), values: Vec::new() }
    }

    /// Records the current values if it is time, or if this is the end.
    pub fn look(&mut self, search: &dyn Search, end: bool) {
        if self.every == 0 {
            return;
        }
        let Some(Insight { round, curves, .. }) = search.insight() else { return };
        if round < self.next && !(end && self.rounds.last() != Some(&round)) {
            return;
        }
        self.next = round + self.every;
        self.names = curves.iter().map(|c| c.name).collect();
        self.rounds.push(round);
        self.values.push(curves.iter().map(|c| c.value).collect());
    }

    /// The record as JSON; null where nothing was recorded.
    pub fn json(&self) -> Value {
        if self.every == 0 {
            return Value::Null;
        }
        json!({ "names": self.names, "rounds": self.rounds, "values": self.values })
    }
}
