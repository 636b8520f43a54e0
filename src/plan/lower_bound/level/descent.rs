//! Newton's method for all stops of a path together: each stop has one unknown, and legs join only stops that follow each other, so that the equations are
//! solved from the first stop to the last and back.

use super::super::limits::Limits;
use super::soft::{self, Leg};
use super::stop::{Step, Stop};
use crate::geometry::DVec2;

/// Most steps at a temperature: it takes a dozen where stops stay on their stretches.
const STEPS: usize = 200;
/// A step that gains less ends the descent, s.
const LITTLE: f64 = 1e-14;
/// The first damping, in s/mm^2, and its least: curvatures of balanced legs are far greater.
const DAMPING: f64 = 1e-6;
const LEAST_DAMPING: f64 = 1e-12;
/// What becomes of it after a step that gains and after one that does not, and how often it is raised.
const LESS: f64 = 0.2;
const MORE: f64 = 5.0;
const RAISED: usize = 40;

/// A path whose stops slide.
pub(super) struct Line<'g> {
    pub(super) limits: Limits,
    pub(super) stops: Vec<Stop<'g>>,
    /// Of the soft maxima, s.
    pub(super) temperature: f64,
}

/// The slopes of the seconds along the track of each stop, and their curvatures: of each stop, and of each with the next.
struct Slopes {
    slope: Vec<f64>,
    own: Vec<f64>,
    next: Vec<f64>,
}

impl Line<'_> {
    /// The ways of the legs.
    pub(super) fn ways(&self) -> impl Iterator<Item = DVec2> + '_ {
        self.stops.windows(2).map(|s| s[1].places()[0] - s[0].places()[1])
    }

    /// Extra seconds of all stops.
    pub(super) fn extra(&self) -> f64 {
        self.stops.iter().map(Stop::extra).sum()
    }

    fn leg(&self, way: DVec2) -> Leg {
        soft::leg(&self.limits, way, self.temperature)
    }

    fn seconds(&self) -> f64 {
        self.ways().map(|way| self.leg(way).seconds).sum::<f64>() + self.extra()
    }

    /// Slides all stops until nothing is gained.
    pub(super) fn descend(&mut self) {
        let mut damping = DAMPING;
        let mut seconds = self.seconds();
        for _ in 0..STEPS {
            let (slopes, fixed) = self.at_corners();
            let from: Vec<f64> = self.stops.iter().map(Stop::along).collect();
            let gains = (0..RAISED).any(|_| {
                let steps = slopes.steps(&fixed, damping);
                for (k, stop) in self.stops.iter_mut().enumerate() {
                    stop.go(from[k] + steps[k]);
                }
                let gains = self.seconds() < seconds;
                damping = if gains { (LESS * damping).max(LEAST_DAMPING) } else { MORE * damping };
                gains
            });
            if !gains {
                self.stops.iter_mut().zip(from).for_each(|(stop, along)| stop.go(along));
                return;
            }
            let gained = seconds - self.seconds();
            seconds -= gained;
            if gained < LITTLE {
                return;
            }
        }
    }

    /// Lets stops turn corners where that is downhill. Returns the slopes, and which stops stay in their corners.
    fn at_corners(&mut self) -> (Slopes, Vec<bool>) {
        let slopes = self.slopes();
        for (stop, &slope) in self.stops.iter_mut().zip(&slopes.slope) {
            if stop.leaves(slope) {
                stop.turn(slope);
            }
        }
        let slopes = self.slopes();
        let fixed = self.stops.iter().zip(&slopes.slope).map(|(stop, &slope)| stop.leaves(slope)).collect();
        (slopes, fixed)
    }

    fn slopes(&self) -> Slopes {
        let steps: Vec<Step> = self.stops.iter().map(|s| s.step().unwrap_or_default()).collect();
        let mut all = Slopes {
            slope: steps.iter().map(|s| s.extra).collect(),
            own: vec![0.0; steps.len()],
            next: vec![0.0; steps.len()],
        };
        for (k, way) in self.ways().enumerate() {
            let leg = self.leg(way);
            let sign = DVec2::new(1.0_f64.copysign(way.x), 1.0_f64.copysign(way.y));
            let ends = [(k, -1.0), (k + 1, 1.0)];
            for (stop, to) in ends {
                all.slope[stop] += to * (leg.slope * sign).dot(steps[stop].tangent);
                all.own[stop] += to * (leg.slope * sign).dot(steps[stop].curvature);
            }
            for (much, apart) in leg.curved {
                let [a, b] = ends.map(|(stop, to)| to * (apart * sign).dot(steps[stop].tangent));
                all.own[k] += much * a * a;
                all.own[k + 1] += much * b * b;
                all.next[k] += much * a * b;
            }
        }
        all
    }
}

impl Slopes {
    /// The steps of the stops that are not fixed: the solution of (curvatures + damping) steps = -slopes.
    fn steps(&self, fixed: &[bool], damping: f64) -> Vec<f64> {
        let count = self.slope.len();
        let joined = |k: usize| if fixed[k] || fixed[k + 1] { 0.0 } else { self.next[k] };
        let (mut after, mut steps) = (vec![0.0; count], vec![0.0; count]);
        for k in 0..count {
            if fixed[k] {
                continue;
            }
            let before =
                k.checked_sub(1).map_or((0.0, 0.0), |b| (joined(b) * after[b], joined(b) * steps[b]));
            let own = (self.own[k].max(0.0) + damping - before.0).max(damping);
            after[k] = if k + 1 < count { joined(k) / own } else { 0.0 };
            steps[k] = (-self.slope[k] - before.1) / own;
        }
        for k in (1..count).rev() {
            steps[k - 1] -= after[k - 1] * steps[k];
        }
        steps
    }
}
