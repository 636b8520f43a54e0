//! The charges of a round: where the least of the known walks is highest.
//!
//! For given charges the value of the bound is the least over all walks of `cost + charges * (stops - 1)`, so each known walk is a
//! linear function above it. The least of these functions is a model that is exact where walks were looked for. The next charges are those
//! for which the model is highest, kept near the best ones so far by a quadratic term (the proximal bundle method: Lemaréchal, 1975;
//! Kiwiel, 1990). The dual of that problem mixes the known walks: the mixture stops at every item once in the mean as far as
//! it can. So it also shows which faults of walks hold the bound back.

use super::super::charges::{Charges, Cut, HAS_CUTS};
use super::super::meet::Found;
use super::super::net::Item;
use super::super::walks::Visit;
use super::excess::{crossings, excess};

/// A step is taken when it gains this share of what the model promises.
const TAKEN: f64 = 0.1;
/// Most known walks: beyond that, those that the mixture does not use are forgotten. A look finds as many as there are items.
const MOST_WALKS: usize = 600;
/// Steps of the mixture for each known walk: more change the charges by less than a look does.
const STEPS: usize = 20;
/// Weights are right when this share of what the model promises is left to gain.
const EXACT: f64 = 1e-3;
/// Largest and least factor by which the length of steps changes at once.
const LONGER: f64 = 4.0;
const SHORTER: f64 = 0.25;

/// A known walk.
#[derive(Clone, Debug)]
struct Known {
    /// Its travel, without charges.
    cost: f64,
    /// What it is charged for, see [`excess`].
    excess: Vec<f64>,
    walk: Vec<Visit>,
    /// Its share of the mixture.
    weight: f64,
}

/// The known walks of a round and the charges they lead to.
#[derive(Clone, Debug, Default)]
pub(super) struct Bundle {
    known: Vec<Known>,
    /// Products of the excesses at items of each two walks.
    products: Vec<Vec<f64>>,
    /// The best charges so far, and their value.
    pub(super) best: Charges,
    pub(super) value: f64,
    /// Length of a step: how far charges move for one stop too many.
    step: f64,
    /// What the model promises beyond the best value.
    promised: f64,
}

impl Bundle {
    /// Begins with these charges.
    pub(super) fn new(best: Charges, step: f64) -> Self {
        Self { best, value: f64::NEG_INFINITY, step, promised: f64::INFINITY, ..Self::default() }
    }

    /// Begins the next round: those walks stay that are walks still.
    pub(super) fn begin_round(&mut self, is_walk: impl Fn(&[Visit]) -> bool) {
        self.keep(&|k: &Known| is_walk(&k.walk));
        self.value = f64::NEG_INFINITY;
        self.promised = f64::INFINITY;
    }

    /// Goes on after pieces were halved. `along`: where the knots of each item were before.
    pub(super) fn halve(&mut self, along: &[Vec<f64>], items: &[Item]) {
        for visit in self.known.iter_mut().flat_map(|k| &mut k.walk) {
            if let Some(&place) = along[visit.item].get(visit.knot) {
                visit.knot = items[visit.item].along.partition_point(|&s| s < place);
            }
        }
    }

    /// Takes note of what the known walks take with new tables.
    pub(super) fn price(&mut self, seconds: impl Fn(&[Visit]) -> f64) {
        self.known.iter_mut().for_each(|k| k.cost = seconds(&k.walk));
    }

    /// Takes note of the value of some charges and of walks found with them, and moves the charges. `first`: the first contour.
    /// `upper`: a known value of the problem, above which no charges are. Returns the work done.
    pub(super) fn learn(
        &mut self,
        charges: &mut Charges,
        value: f64,
        found: &[Found],
        (first, upper): (usize, f64),
    ) -> u64 {
        let gained = (value - self.value) / self.promised;
        if self.step == 0.0 {
            let norm: f64 =
                found.first().map_or(1.0, |f| excess(&f.walk, charges, first).iter().map(|e| e * e).sum());
            let gap = if upper.is_finite() { upper - value } else { value.abs() };
            self.step = gap.max(0.0) / norm.max(1.0);
        } else if self.value.is_finite() && !(0.0..=0.5).contains(&gained) {
            // The best length along this line, if the value is a quadratic function on it.
            let factor = if gained < 1.0 { 0.5 / (1.0 - gained) } else { LONGER };
            self.step *= factor.clamp(SHORTER, LONGER);
        }
        if !self.value.is_finite() || gained > TAKEN {
            self.value = value;
            self.best.clone_from(charges);
        }
        // No walk takes less than the least one: these took more than was known.
        let least = value - 1e-9 * value.abs();
        self.keep(&|k: &Known| k.at(charges.values()) >= least);
        for f in found {
            self.add(f, charges, first);
        }
        self.forget();
        self.move_charges(charges, upper)
    }

    /// Moves the charges to where the model with its quadratic term is highest.
    fn move_charges(&mut self, charges: &mut Charges, upper: f64) -> u64 {
        let (values, work) = self.mix(upper);
        charges.set(&values);
        let model = self.known.iter().map(|k| k.at(charges.values())).fold(f64::INFINITY, f64::min);
        self.promised = (model.min(upper) - self.value).max(1e-12);
        work
    }

    /// Adds cuts, and moves the charges with them.
    pub(super) fn add_cuts(&mut self, cuts: Vec<Cut>, charges: &mut Charges, upper: f64) -> u64 {
        for cut in cuts {
            for known in &mut self.known {
                known.excess.push(2.0 - crossings(&known.walk, &cut));
            }
            self.best.add(cut.clone());
            charges.add(cut);
        }
        self.move_charges(charges, upper)
    }

    /// What the model promises beyond the best value.
    pub(super) fn promised(&self) -> f64 {
        self.promised
    }

    /// The walks of the mixture with their shares.
    pub(super) fn mixture(&self) -> Vec<(f64, Vec<Visit>)> {
        self.known.iter().filter(|k| k.weight > 0.0).map(|k| (k.weight, k.walk.clone())).collect()
    }

    /// Goes on without cuts.
    pub(super) fn drop_cuts(&mut self) {
        self.best.drop_cuts();
        let items = self.best.items();
        self.known.iter_mut().for_each(|k| k.excess.truncate(items));
    }

    fn add(&mut self, found: &Found, charges: &Charges, first: usize) {
        let excess = excess(&found.walk, charges, first);
        let cost = found.value - charges.back() - dot(charges.values(), &excess);
        let same = |k: &Known| k.excess == excess && (k.cost - cost).abs() <= 1e-9 * cost.abs();
        if self.known.iter().any(same) {
            return;
        }
        let items = charges.items();
        let mut products: Vec<f64> =
            self.known.iter().map(|k| dot(&k.excess[..items], &excess[..items])).collect();
        products.push(dot(&excess[..items], &excess[..items]));
        for (row, p) in self.products.iter_mut().zip(&products) {
            row.push(*p);
        }
        self.products.push(products);
        self.known.push(Known { cost, excess, walk: found.walk.clone(), weight: 0.0 });
    }

    /// Forgets the oldest walks that the mixture does not use, if there are too many.
    fn forget(&mut self) {
        let mut out = self.known.len().saturating_sub(MOST_WALKS);
        if out == 0 {
            return;
        }
        let mut goes = |k: &Known| {
            let goes = out > 0 && k.weight == 0.0;
            out -= usize::from(goes);
            goes
        };
        let kept: Vec<bool> = self.known.iter().map(|k| !goes(k)).collect();
        self.sift(&kept);
    }

    /// Keeps some walks.
    fn keep(&mut self, stays: &dyn Fn(&Known) -> bool) {
        let kept: Vec<bool> = self.known.iter().map(stays).collect();
        self.sift(&kept);
    }

    /// Keeps the walks marked.
    fn sift(&mut self, kept: &[bool]) {
        if kept.iter().all(|&k| k) {
            return;
        }
        fn sift<T>(list: &mut Vec<T>, kept: &[bool]) {
            let mut flags = kept.iter();
            list.retain(|_| flags.next().is_none_or(|&k| k));
        }
        sift(&mut self.known, kept);
        sift(&mut self.products, kept);
        self.products.iter_mut().for_each(|row| sift(row, kept));
    }

    /// Finds the mixture of walks that is the dual of the model with its quadratic term, and returns the charges it leads to:
    /// weight moves from the walk that is worst to the one that is best, as far as it pays.
    fn mix(&mut self, upper: f64) -> (Vec<f64>, u64) {
        let items = self.best.items();
        let total: f64 = self.known.iter().map(|k| k.weight).sum();
        if total <= 0.0 {
            let least = self
                .known
                .iter_mut()
                .min_by(|a, b| a.at(self.best.values()).total_cmp(&b.at(self.best.values())));
            if let Some(k) = least {
                k.weight = 1.0;
            }
        } else {
            self.known.iter_mut().for_each(|k| k.weight /= total);
        }
        let center = self.best.values();
        let mut way = vec![0.0; center.len()];
        for k in self.known.iter().filter(|k| k.weight > 0.0) {
            way.iter_mut().zip(&k.excess).for_each(|(w, e)| *w += k.weight * e);
        }
        let step = self.step;
        let moved = |d: usize, way: f64| {
            let value = center[d] + step * way;
            if d < items { value } else { value.max(0.0) }
        };
        let mut values: Vec<f64> = way.iter().enumerate().map(|(d, &w)| moved(d, w)).collect();
        // The slope of each weight: the value of its walk.
        let mut slopes: Vec<f64> = self.known.iter().map(|k| k.at(&values)).collect();
        let mut work = self.known.len() * way.len();
        // The excess of all walks, one cut after the other.
        let cuts = if HAS_CUTS { items..way.len() } else { 0..0 };
        let of_cuts: Vec<Vec<f64>> = cuts.map(|d| self.known.iter().map(|k| k.excess[d]).collect()).collect();
        // In a new round nothing is promised yet; no more than this can be gained.
        let left = (upper - self.value).max(0.0);
        for _ in 0..STEPS * self.known.len() {
            work += 3 * self.known.len();
            let (mut low, mut high) = ((f64::INFINITY, 0), (f64::NEG_INFINITY, 0));
            for (i, (&slope, known)) in slopes.iter().zip(&self.known).enumerate() {
                if slope < low.0 {
                    low = (slope, i);
                }
                if slope > high.0 && known.weight > 0.0 {
                    high = (slope, i);
                }
            }
            let (to, from) = (low.1, high.1);
            if high.0 - low.0 <= EXACT * self.promised.min(low.0.abs()).min(left) {
                break;
            }
            let p = &self.products;
            let [a, b] = [to, from].map(|k| &self.known[k].excess);
            let by_cuts: f64 = if HAS_CUTS {
                a[items..].iter().zip(&b[items..]).map(|(x, y)| (x - y) * (x - y)).sum()
            } else {
                0.0
            };
            let curve = step * (p[to][to] + p[from][from] - 2.0 * p[to][from] + by_cuts);
            let most = self.known[from].weight;
            let by = if curve > 0.0 { most.min((high.0 - low.0) / curve) } else { most };
            for (slope, (x, y)) in slopes.iter_mut().zip(p[to].iter().zip(&p[from])) {
                *slope += step * by * (x - y);
            }
            for d in 0..way.len() {
                way[d] += by * (a[d] - b[d]);
                let value = moved(d, way[d]);
                let change = value - values[d];
                values[d] = value;
                if HAS_CUTS && d >= items && change != 0.0 {
                    work += self.known.len();
                    slopes.iter_mut().zip(&of_cuts[d - items]).for_each(|(s, e)| *s += change * e);
                }
            }
            self.known[to].weight += by;
            self.known[from].weight = if by < most { most - by } else { 0.0 };
        }
        (values, work as u64)
    }
}

impl Known {
    /// The value of this walk with these charges.
    fn at(&self, pay: &[f64]) -> f64 {
        self.cost + dot(&self.excess, pay)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
