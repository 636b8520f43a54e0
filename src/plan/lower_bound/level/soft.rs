//! The seconds of a leg with soft maxima in place of "the slower axis".

use super::super::limits::Limits;
use super::super::mixtures::Mixture;
use crate::geometry::DVec2;

/// The scale of ramps, s: they are squared seconds, of moves that take about as long as this or longer.
const RAMPS: f64 = 0.1;

/// A leg as a function of how far it goes along each axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub(super) seconds: f64,
    /// How fast the seconds grow with the distance along each axis.
    pub(super) slope: DVec2,
    /// Where they are curved: how much, and the slopes of what is compared.
    pub(super) curved: [(f64, DVec2); 2],
    /// How much x counts in the time at top speed and in the ramps.
    pub(super) mixture: Mixture,
}

/// A leg that goes this way, at a temperature, s.
pub(super) fn leg(limits: &Limits, way: DVec2, temperature: f64) -> Leg {
    let away = way.abs();
    let (run, ramp2) = (away * limits.per_speed, away * limits.per_accel);
    let apart = |per: DVec2| DVec2::new(per.x, -per.y);
    if limits.each_axis {
        let [x, y] = [0, 1].map(|k| limits.seconds(run[k], ramp2[k]));
        let per = |k: usize, by: [f64; 2]| by[0] * limits.per_speed[k] + by[1] * limits.per_accel[k];
        let slopes = DVec2::new(per(0, x.1), per(1, y.1));
        let greater = greater(x.0, y.0, temperature);
        return Leg {
            seconds: greater.value,
            slope: greater.shares() * slopes,
            curved: [(greater.curved, apart(slopes)), (0.0, DVec2::ZERO)],
            mixture: [greater.share; 2],
        };
    }
    let run = greater(run.x, run.y, temperature);

    let ramp2 = greater(ramp2.x, ramp2.y, temperature * RAMPS);
    let (seconds, by) = limits.seconds(run.value, ramp2.value);
    Leg {
        seconds,
        slope: by[0] * run.shares() * limits.per_speed + by[1] * ramp2.shares() * limits.per_accel,
        curved: [
            (by[0] * run.curved, apart(limits.per_speed)),
            (by[1] * ramp2.curved, apart(limits.per_accel)),
        ],
        mixture: [run.share, ramp2.share],
    }
}

/// The soft maximum of two numbers.
struct Greater {
    value: f64,
    /// How much the first one counts.
    share: f64,
    /// How fast the share grows with the difference of both.
    curved: f64,
}

impl Greater {
    fn shares(&self) -> DVec2 {
        DVec2::new(self.share, 1.0 - self.share)
    }
}

fn greater(a: f64, b: f64, temperature: f64) -> Greater {
    let small = libm::exp(-(a - b).abs() / temperature);
    let less = small / (1.0 + small);
    let share = if a > b { 1.0 - less } else { less };
    Greater {
        value: a.max(b) + temperature * libm::log1p(small),
        share,
        curved: share * (1.0 - share) / temperature,
    }
}
