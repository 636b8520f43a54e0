//! Weighs what speaks for millimetres and what for inches.
//!
//! Every piece of evidence has a weight in the manner of a log-likelihood ratio: positive for inches, negative for
//! millimetres; 1 is a hint, 3 is strong. The weights are added. They were set by hand from 31 public drawings
//! (`tests/it/units_evidence.rs` prints the decision about each).

use super::facts::Facts;
use super::names::{self, Hint};
use crate::dxf::header::Header;
use crate::geometry::math;
use crate::number::fixed;

/// Smallest and largest extent of a drawing that raises no doubt, mm. Only 2 % of real drawings are smaller, most of
/// them in another unit than they say; no common machine has a bed above 6 m.
pub(super) const PLAUSIBLE_SIZE: std::ops::RangeInclusive<f64> = 20.0..=6000.0;

/// Weight of all drawings together: most are in millimetres.
const PRIOR: f64 = -1.0;
/// Largest weight of several values of one kind, which are not independent of each other.
const MOST: f64 = 3.5;

/// A piece of evidence.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Evidence {
    /// Positive for inches, negative for millimetres.
    pub(super) weight: f64,
    /// What was seen, as part of a sentence after "because".
    pub(super) reason: String,
}

/// All evidence together.
#[derive(Debug, Default)]
pub(super) struct Weighed {
    list: Vec<Evidence>,
}

impl Weighed {
    /// Collects the evidence of a drawing.
    pub(super) fn of(header: &Header<'_>, facts: &Facts) -> Self {
        let mut weighed = Self::default();
        weighed.extent(facts.extent);
        weighed.holes(&facts.diameters);
        weighed.names(facts);
        weighed.texts(&facts.text_heights);
        weighed.settings(header);
        weighed.round_values(&facts.lengths);
        weighed
    }

    /// The probability of inches, if there is nothing else than millimetres.
    pub(super) fn inches(&self) -> f64 {
        let sum = self.list.iter().fold(PRIOR, |sum, e| sum + e.weight);
        1.0 / (1.0 + math::exp(-sum))
    }

    /// The strongest reasons for one of the two units, joined by ", and"; empty if there is none.
    pub(super) fn reasons(&self, for_inches: bool) -> String {
        let mut reasons: Vec<&Evidence> =
            self.list.iter().filter(|e| (e.weight > 0.0) == for_inches).collect();
        crate::order::sort_by(&mut reasons, |e| [crate::order::real(-e.weight.abs()), 0, 0]);
        let words: Vec<&str> = reasons.iter().take(2).map(|e| e.reason.as_str()).collect();
        words.join(", and ")
    }

    fn add(&mut self, weight: f64, reason: impl Into<String>) {
        if weight.abs() > 0.0 {
            self.list.push(Evidence { weight: weight.clamp(-MOST, MOST), reason: reason.into() });
        }
    }

    fn extent(&mut self, extent: f64) {
        let (as_mm, as_in) = (PLAUSIBLE_SIZE.contains(&extent), PLAUSIBLE_SIZE.contains(&(extent * 25.4)));
        match (as_mm, as_in) {
            (true, false) => self.add(-3.0, "only in millimetres the size is usual"),
            (false, true) => self.add(2.5, "only in inches the size is usual"),
            _ => {}
        }
    }

    fn holes(&mut self, diameters: &[f64]) {
        let (mut imperial, mut metric, mut tiny) = (Vec::new(), Vec::new(), 0_usize);
        let mut weight = 0.0;
        for &d in diameters {
            match (is_metric_hole(d), is_inch_hole(d)) {
                (true, false) => {
                    weight -= 1.2;
                    metric.push(d);
                }
                (false, true) => {
                    weight += 1.2;
                    imperial.push(d);
                }
                // The same hole drawn in the other unit.
                (false, false) if is_metric_hole(d * 25.4) => weight += 0.8,
                (false, false) if is_inch_hole(d / 25.4) => weight -= 0.8,
                _ => {}
            }
            if d < SMALLEST_HOLE {
                tiny += 1;
                weight += 0.5;
            }
        }
        let sizes = |list: &[f64]| {
            list.iter().take(2).map(|&d| fixed(d, 3).to_string()).collect::<Vec<_>>().join(", ")
        };
        let reason = match weight > 0.0 {
            true if !imperial.is_empty() => {
                format!("holes of {} are drill sizes in inches", sizes(&imperial))
            }
            true if tiny > 0 => "its holes would be too small in millimetres".to_owned(),
            true => "its holes are usual in millimetres when it is read in inches".to_owned(),
            false if !metric.is_empty() => format!("holes of {} are usual in millimetres", sizes(&metric)),
            false => "its holes are inch drill sizes when it is read in millimetres".to_owned(),
        };
        self.add(weight, reason);
    }

    fn names(&mut self, facts: &Facts) {
        let (mut metric, mut imperial) = (0, 0);
        for name in &facts.layers {
            match names::hint(name) {
                Some(Hint::Metric) => {
                    metric += 1;
                    if metric == 1 {
                        self.add(-1.5, format!("a layer is called {name}"));
                    }
                }
                Some(Hint::Imperial) => {
                    imperial += 1;
                    if imperial == 1 {
                        self.add(1.5, format!("a layer is called {name}"));
                    }
                }
                Some(Hint::Sheet(side)) => {
                    // The drawing fills the sheet that its layer names, or a part of it.
                    let sheet = if side >= 200.0 { side } else { side * 25.4 };
                    let fills = |mm: f64| (0.2..=1.5).contains(&(mm / sheet));
                    match (fills(facts.extent), fills(facts.extent * 25.4)) {
                        (true, false) => self.add(-MOST, format!("it fits the sheet of layer {name}")),
                        (false, true) => self.add(MOST, format!("it fits the sheet of layer {name}")),
                        _ => {}
                    }
                }
                None => {}
            }
        }
    }

    fn texts(&mut self, heights: &[f64]) {
        let count = |range: std::ops::Range<f64>| heights.iter().filter(|h| range.contains(h)).count();
        // Lettering of 0.02 to 0.5 cannot be read in millimetres, one of 1 to 20 is rare in inches.
        let (small, large) = (count(0.02..0.5), count(1.0..20.0));
        if small > 2 * large {
            self.add(1.0, "its texts would be too small in millimetres");
        } else if large > 2 * small {
            self.add(-0.7, "its texts have heights that are usual in millimetres");
        }
    }

    fn settings(&mut self, header: &Header<'_>) {
        match header.measurement {
            Some(0) => self.add(0.8, "its settings are for inches"),
            Some(1) => self.add(-1.3, "its settings are metric"),
            _ => {}
        }
        // Engineering, architectural and fractional lengths.
        match header.length_format {
            Some(3 | 4) => self.add(2.0, "it shows lengths in feet and inches"),
            Some(5) => self.add(1.0, "it shows lengths as fractions"),
            _ => {}
        }
        // Dimension texts of the imperial and of the metric template of AutoCAD.
        match header.dimension_text {
            Some(h) if (h - 0.18).abs() < 1e-6 => {
                self.add(0.5, "its dimension style is that of a drawing in inches")
            }
            Some(h) if (h - 2.5).abs() < 1e-6 => self.add(-0.5, "its dimension style is metric"),
            _ => {}
        }
    }

    fn round_values(&mut self, lengths: &[f64]) {
        // Fewer say nothing.
        const FEWEST: usize = 4;
        if lengths.len() < FEWEST {
            return;
        }
        let share = |is_so: &dyn Fn(f64) -> bool| {
            lengths.iter().filter(|l| is_so(**l)).count() as f64 / lengths.len() as f64
        };
        let tenths = |l: f64| is_multiple(l, 0.1, 1e-4);
        let fractions =
            |l: f64| is_multiple(l, 1.0 / 64.0, 1e-5) || is_multiple(l, 1.0 / 64.0, 6e-5) && l < 8.0;
        let metric = share(&|l| tenths(l) && !fractions(l));
        let imperial = share(&|l| fractions(l) && !tenths(l));
        let converted_metric = share(&|l| !tenths(l) && !fractions(l) && is_multiple(l * 25.4, 0.1, 1e-3));
        let converted_imperial =
            share(&|l| !tenths(l) && !fractions(l) && is_multiple(l / 25.4, 1.0 / 16.0, 1e-4));
        // A share of lengths that are round by chance is a few per cent.
        let weight = |share: f64| if share > 0.15 { 3.0 * share } else { 0.0 };
        self.add(-weight(metric), "its lengths are round in millimetres");
        self.add(weight(imperial), "its lengths are fractions of an inch");
        self.add(weight(converted_metric), "its lengths are round in millimetres if it is in inches");
        self.add(-weight(converted_imperial), "its lengths are round in inches if it is in millimetres");
    }
}

/// Smallest diameter, in mm, that lasers cut in sheets for parts.
const SMALLEST_HOLE: f64 = 0.6;

/// Whether a hole of `d` mm is usual: tenths of a millimetre, as all metric clearance and tap holes are.
fn is_metric_hole(d: f64) -> bool {
    (0.8..=60.0).contains(&d) && is_multiple(d, 0.1, 1e-3)
}

/// Whether a hole of `d` inches is usual: a fraction, or a drill for a thread.
fn is_inch_hole(d: f64) -> bool {
    /// Tap and clearance drills for threads from #2 to 3/8 (ASME B18.2.8 and tables of drill makers).
    const DRILLS: [f64; 26] = [
        0.07, 0.089, 0.096, 0.102, 0.1065, 0.107, 0.113, 0.116, 0.1285, 0.136, 0.144, 0.1495, 0.159, 0.166,
        0.1695, 0.177, 0.19, 0.196, 0.201, 0.257, 0.266, 0.272, 0.323, 0.332, 0.386, 0.397,
    ];
    // Fractions of 64 below an inch, of 8 above.
    let fraction = if d <= 1.0 { 1.0 / 64.0 } else { 1.0 / 8.0 };
    ((0.03..=4.0).contains(&d) && is_multiple(d, fraction, 5e-4))
        || DRILLS.iter().any(|drill| (d - drill).abs() < 4e-4)
}

fn is_multiple(value: f64, step: f64, tolerance: f64) -> bool {
    let steps = (value / step).round();
    steps >= 1.0 && (value - steps * step).abs() <= tolerance
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holes_of_one_system_are_not_those_of_the_other() {
        for d in [0.116, 0.257, 0.1495, 0.0625, 0.375] {
            assert!(is_inch_hole(d) && !is_metric_hole(d), "{d}");
        }
        for d in [3.2, 6.5, 4.3, 2.7, 10.4] {
            assert!(is_metric_hole(d) && !is_inch_hole(d), "{d}");
        }
        // 6.35 mm is a quarter of an inch.
        assert!(!is_metric_hole(6.35) && is_inch_hole(6.35 / 25.4));
    }
}
