//! A step of the smooth problem: how much flow enters each state and leaves it, and the potentials that bring both together.

use super::super::powers::{exp, ln};
use super::FlowBound;

/// Length of a step: both ends of a leg move, so that a quarter never overshoots.
const STEP: f64 = 0.25;
/// Most temperatures by which a potential moves in a step, before [`STEP`].
const MOST: f64 = 4.0;
/// Less flow does not move a potential.
const FEW: f64 = 1e-12;
/// The least sum that is divided by.
const TINY: f64 = 1e-200;
/// Largest power of e: potentials that have just been made can be far off.
const LARGEST: f64 = 80.0;

/// For each item the sum of the weights of some of its states and knots, relative to the potential that counts most.
#[derive(Clone, Copy, Debug, Default)]
struct Weight {
    sum: f64,
    potential: f64,
}

impl FlowBound {
    /// Moves all potentials and all prices once.
    pub(super) fn step(&mut self) {
        let pairs = self.ground.pairs.list.len();
        let (mut credit, mut crossed) = (vec![0.0; pairs], vec![0.0; pairs]);
        for cut in &self.cuts {
            for e in cut.pairs.iter().map(|&e| e as usize) {
                credit[e] += cut.price;
                crossed[e] += 1.0;
            }
        }
        let mut sums = self.enter(&credit);
        let (out, into) = self.far_weights();
        let mut far_in = vec![0.0; sums.len()];
        self.use_far((&out, &into), &mut far_in);
        sums.iter_mut().zip(&far_in).for_each(|(sum, far)| *sum += far);
        let part: Vec<f64> = sums.iter().map(|sum| 1.0 / sum.max(TINY)).collect();
        let mut far_out = vec![0.0; sums.len()];
        for (from, to, uses) in &mut self.flow.far {
            *uses *= part[*to];
            far_out[*from] += *uses;
        }
        let colder = 1.0 / self.temperature;
        for (s, key) in self.net.keys.iter().enumerate() {
            let (item, range) = (key.0, self.net.range(s));
            self.flow.inflow[range.clone()].iter_mut().for_each(|x| *x *= part[item]);
            if far_out[item] > FEW {
                for at in range.clone() {
                    let weight = exp((out[item].potential - self.potentials[at]) * colder);
                    self.flow.outflow[at] += far_out[item] * weight / out[item].sum;
                }
            }
            let comes = far_in[item] * part[item];
            if comes > FEW && self.net.fresh[item] == Some(s) {
                for at in range {
                    let weight = exp((self.potentials[at] - into[item].potential) * colder);
                    self.flow.inflow[at] += comes * weight / into[item].sum;
                }
            }
        }
        self.leave(&part);
        let by = STEP * self.temperature;
        let flows = self.flow.inflow.iter().zip(&self.flow.outflow);
        for (potential, (&into, &out)) in
            self.potentials.iter_mut().zip(flows).filter(|f| *f.1.0 > FEW || *f.1.1 > FEW)
        {
            *potential += by * (ln(out.max(FEW)) - ln(into.max(FEW))).clamp(-MOST, MOST);
        }
        let mut value = 0.0;
        for (pay, &sum) in self.pays.iter_mut().zip(&sums).filter(|p| *p.1 > 0.0) {
            *pay -= self.temperature * ln(sum);
            value += *pay;
        }
        self.flow.value = value + 2.0 * self.cuts.iter().map(|c| c.price).sum::<f64>();
        self.move_prices(&crossed);
    }

    /// What enters each state along legs of pairs with tables, and each item in all, before both are divided by the latter. `credit`: the prices that
    /// each pair is given.
    fn enter(&mut self, credit: &[f64]) -> Vec<f64> {
        let colder = 1.0 / self.temperature;
        let flow = &mut self.flow;
        flow.inflow.clear();
        flow.inflow.resize(self.net.width, 0.0);
        flow.outflow.clear();
        flow.outflow.resize(self.net.width, 0.0);
        let mut sums = vec![0.0; self.pays.len()];
        for s in 0..self.legs.slots.len().saturating_sub(1) {
            let (slot, end) = (self.legs.slots[s], self.legs.slots[s + 1].legs as usize);
            let step = &self.net.steps[slot.step as usize];
            let item = self.net.keys[step.to].0;
            let sources = &self.net.sources[step.sources.clone()];
            let left = |s: usize| self.potentials[self.net.at[s] + slot.knot as usize];
            let low = sources.iter().map(|&s| left(s)).fold(f64::INFINITY, |m, v| if v < m { v } else { m });
            let mut sum = 0.0;
            let parts = &mut self.legs.parts[slot.parts as usize..slot.parts as usize + sources.len()];
            for (part, &s) in parts.iter_mut().zip(sources) {
                *part = exp((low - left(s)) * colder);
                sum += *part;
            }
            parts.iter_mut().for_each(|part| *part /= sum);
            let base = self.pays[item] + credit[step.pair.0] - low;
            let legs = &self.legs.legs[slot.legs as usize..end];
            for (uses, leg) in self.legs.uses[slot.legs as usize..end].iter_mut().zip(legs) {
                let power = (base + self.potentials[leg.to as usize] - leg.seconds) * colder;
                *uses = sum * exp(power.min(LARGEST));
                flow.inflow[leg.to as usize] += *uses;
                sums[item] += *uses;
            }
        }
        sums
    }

    /// What leaves each state along these legs. `part`: by what the flow into each item is multiplied, so that it is entered once.
    fn leave(&mut self, part: &[f64]) {
        let flow = &mut self.flow;
        flow.usage.clear();
        flow.usage.resize(self.ground.pairs.list.len(), 0.0);
        for (slot, legs) in self.legs.each() {
            let step = &self.net.steps[slot.step as usize];
            let uses: f64 = self.legs.uses[legs].iter().sum::<f64>() * part[self.net.keys[step.to].0];
            flow.usage[step.pair.0] += uses;
            let sources = &self.net.sources[step.sources.clone()];
            for (p, &s) in self.legs.parts[slot.parts as usize..].iter().zip(sources) {
                flow.outflow[self.net.at[s] + slot.knot as usize] += p * uses;
            }
        }
    }

    /// The weights of all states of each item, which far legs leave, and of the state they come to.
    fn far_weights(&self) -> (Vec<Weight>, Vec<Weight>) {
        let none = vec![Weight::default(); self.pays.len()];
        if self.legs.far.is_empty() {
            return (none.clone(), none);
        }
        let colder = 1.0 / self.temperature;
        let values = |states: &[usize]| -> Vec<f64> {
            states.iter().flat_map(|&s| &self.potentials[self.net.range(s)]).copied().collect()
        };
        let weight = |values: &[f64], sign: f64| {
            let potential = sign * values.iter().fold(f64::INFINITY, |m, v| m.min(sign * v));
            let sum = values.iter().map(|v| exp(sign * (potential - v) * colder)).sum();
            Weight { sum, potential }
        };
        let out = self.net.of.iter().map(|states| weight(&values(states), 1.0)).collect();
        let into = self.net.fresh.iter().map(|fresh| weight(&values(fresh.as_slice()), -1.0)).collect();
        (out, into)
    }

    /// How much far legs are used, and what comes along them to each item.
    fn use_far(&mut self, (out, into): (&[Weight], &[Weight]), far_in: &mut [f64]) {
        let colder = 1.0 / self.temperature;
        self.flow.far.clear();
        for far in &self.legs.far {
            let given = self.pays[far.to] + self.crossing[far.from * self.pays.len() + far.to];
            let power = (given + into[far.to].potential - out[far.from].potential - far.seconds) * colder;
            let uses = out[far.from].sum * into[far.to].sum * exp(power.min(LARGEST));
            far_in[far.to] += uses;
            self.flow.far.push((far.from, far.to, uses));
        }
    }
}
