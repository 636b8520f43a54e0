//! Time of an air move from rest to rest, at the limits of the axes.
//!
//! A motion over distance d with top speed v and acceleration a is a trapezoid of speed over time, or a triangle when d
//! is too short to reach v. It is described by `run` = d / v, the time at top speed, and `ramp2` = d / a, a squared
//! time. The ramps of the trapezoid add v / a = `ramp2` / `run`; the triangle takes 2 sqrt(`ramp2`). In this form, the
//! limits in a direction need no division by its components: the limiting axis is the one with the larger |dx| / v, and
//! likewise for the acceleration.
//!
//! Where the machine lifts the head on the way ([`Lift`]), the head goes straight up to the middle of the move and straight down
//! from there, without a stop. So it travels no faster than the z axis can follow: `run` is at least the time of lifting and
//! lowering.

use super::levers::Lift;
use super::profile::{Profile, Travel};
use glam::DVec2;

/// Time of air moves on one machine, prepared for many evaluations.
#[derive(Clone, Copy, Debug)]
pub struct AirTime {
    travel: Travel,
    /// Whether the length of a move alone gives its seconds: the travel is [`Travel::Vector`], and the head stays down.
    by_length: bool,
    /// Whether the head is lifted for moves that are long enough.
    lifts: bool,
    /// Seconds per mm at top speed, by axis.
    per_speed: DVec2,
    /// Seconds squared per mm, by axis; 0 when the machine reaches its speed instantly.
    per_accel: DVec2,
    /// Whether the machine reaches its speed instantly.
    at_once: bool,
    lifting: Lifting,
}

/// Lifting the head, in the numbers that a move is priced with.
#[derive(Clone, Copy, Debug)]
struct Lifting {
    /// The head is lifted for moves longer than this, mm.
    above: f64,
    /// Least seconds at top speed of a move on which the head rises and sinks.
    least_run: f64,
    /// Seconds that lifting and lowering at rest add.
    at_rest: f64,
}

impl Lifting {
    const NONE: Self = Self { above: f64::INFINITY, least_run: 0.0, at_rest: 0.0 };

    /// `seconds`: of lifting and lowering.
    fn new(lift: &Lift, seconds: f64) -> Self {
        let (least_run, at_rest) = if lift.at_rest { (0.0, seconds) } else { (seconds, 0.0) };
        Self { above: lift.longest_down(), least_run, at_rest }
    }

    /// What a move of this length has of it.
    #[inline(always)]
    fn of(self, distance: f64) -> Self {
        if distance > self.above { self } else { Self::NONE }
    }
}

impl AirTime {
    /// Prepares the air moves of a machine.
    pub fn new(profile: &Profile) -> Self {
        Self::with_lift(profile, profile.levers.lift_by_length())
    }

    /// The same for moves with the head lifted, however short; `None` if the machine does not lift its head.
    pub fn lifted_always(profile: &Profile) -> Option<Self> {
        let lift = Lift { stay_down: 0.0, ..profile.levers.lift? };
        Some(Self::with_lift(profile, Some(lift)))
    }

    fn with_lift(profile: &Profile, lift: Option<Lift>) -> Self {
        let down = Self::head_down(profile);
        let Some(lift) = lift else { return down };
        let lifting = Lifting::new(&lift, 2.0 * profile.height_seconds(lift.height));
        Self { lifting, lifts: true, by_length: false, ..down }
    }

    /// The same for moves with the head down, such as those over a joint. They are never slower.
    pub fn head_down(profile: &Profile) -> Self {
        let per_speed = 1.0 / DVec2::from_array(profile.rapid.speed);
        let per_accel = profile.rapid.accel.map_or(DVec2::ZERO, |a| 1.0 / DVec2::from_array(a));
        let (travel, at_once) = (profile.travel, profile.rapid.accel.is_none());
        let by_length = travel == Travel::Vector;
        let (per_speed, per_accel) = if by_length {
            (DVec2::splat(per_speed.max_element()), DVec2::splat(per_accel.max_element()))
        } else {
            (per_speed, per_accel)
        };
        Self { travel, by_length, lifts: false, per_speed, per_accel, at_once, lifting: Lifting::NONE }
    }

    /// Seconds from `from` to `to`, mm. The time is symmetric, 0 for no distance, and never decreases with the distance
    /// along either axis; where the head is lifted, it jumps at the length above which it is.
    pub fn seconds(&self, from: DVec2, to: DVec2) -> f64 {
        self.seconds_here(from, to)
    }

    /// The same, inlined for loops in which a call is noticeable.
    #[inline(always)]
    pub(crate) fn seconds_here(&self, from: DVec2, to: DVec2) -> f64 {
        let d = (to - from).abs();
        if self.by_length {
            let d = d.length();
            return self.ramped(d * self.per_speed.x, d * self.per_accel.x);
        }
        let (mut run, mut ramp2, mut at_rest) = (d * self.per_speed, d * self.per_accel, 0.0);
        // Not a call: it would make the loops of all machines save what they have in registers, which took 3 ns a move in wasm.
        if self.lifts {
            let distance = d.length();
            let lifting = self.lifting.of(distance);
            if self.travel == Travel::Vector {
                (run, ramp2) = (self.per_speed * distance, self.per_accel * distance);
            }
            run = DVec2::new(larger(run.x, lifting.least_run), larger(run.y, lifting.least_run));
            at_rest = lifting.at_rest;
        }
        let seconds = if self.travel != Travel::PerAxis || self.at_once {
            self.ramped(larger(run.x, run.y), larger(ramp2.x, ramp2.y))
        } else {
            larger(self.ramped(run.x, ramp2.x), self.ramped(run.y, ramp2.y))
        };
        seconds + at_rest
    }

    /// Seconds that lifting the head adds to every move longer than `distance` mm, at least.
    pub(crate) fn lift_adds(&self, distance: f64) -> f64 {
        self.lifting.of(distance).at_rest
    }

    /// Seconds of a motion from rest to rest; see the module's documentation.
    #[inline(always)]
    fn ramped(&self, run: f64, ramp2: f64) -> f64 {
        // Machines that reach their speed instantly need no root and no division.
        if self.at_once {
            run
        } else if ramp2 >= run * run {
            2.0 * ramp2.sqrt()
        } else {
            run + ramp2 / run
        }
    }

    /// Least seconds of a move of at least `d` mm along x or along y.
    pub fn seconds_at_least(&self, d: f64) -> f64 {
        self.seconds(DVec2::ZERO, DVec2::X * d).min(self.seconds(DVec2::ZERO, DVec2::Y * d))
    }
}

/// Seconds of an air move between two places in mm.
pub fn air_time(profile: &Profile, from: DVec2, to: DVec2) -> f64 {
    AirTime::new(profile).seconds(from, to)
}

/// The larger of two numbers that are not negative. In wasm, the library's `max` is a call, because it handles NaN, and
/// a comparison is a branch, which is mispredicted half the time. The bits of such numbers have the same order as their
/// values.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if cfg!(target_family = "wasm") {
        f64::from_bits(a.to_bits().max(b.to_bits()))
    } else if a > b {
        a
    } else {
        b
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::presets;

    fn machine(travel: Travel, speed: [f64; 2], accel: Option<[f64; 2]>) -> Profile {
        let mut p = presets().swap_remove(0);
        p.travel = travel;
        p.rapid.speed = speed;
        p.rapid.accel = accel;
        p
    }

    fn seconds(p: &Profile, x: f64, y: f64) -> f64 {
        air_time(p, DVec2::new(3.0, -2.0), DVec2::new(3.0 + x, -2.0 + y))
    }

    #[track_caller]
    fn near(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-12 * b.abs().max(1.0), "{a} is not {b}");
    }

    #[test]
    fn trapezoid_and_triangle_by_hand() {
        let p = machine(Travel::Vector, [100.0, 100.0], Some([1000.0, 1000.0]));
        // It takes 0.1 s and 5 mm to reach 100 mm/s, 5 mm to stop, and 90 mm are run at speed.
        near(seconds(&p, 100.0, 0.0), 1.1);
        near(seconds(&p, 60.0, 80.0), 1.1);
        // Of 4 mm, 2 mm of acceleration at 1000 mm/s2 take sqrt(2 * 2 / 1000).
        near(seconds(&p, 0.0, 4.0), 2.0 * (4.0_f64 / 1000.0).sqrt());
        // Both formulas meet where top speed is just reached.
        near(seconds(&p, 10.0, 0.0), 0.2);
        near(seconds(&p, 0.0, 0.0), 0.0);
    }

    #[test]
    fn speed_is_reached_instantly_without_acceleration() {
        near(seconds(&machine(Travel::Vector, [50.0, 100.0], None), 30.0, 40.0), 1.0);
        near(seconds(&machine(Travel::Straight, [50.0, 100.0], None), 30.0, 40.0), 0.6);
        near(seconds(&machine(Travel::PerAxis, [50.0, 100.0], None), 30.0, 100.0), 1.0);
        near(seconds(&machine(Travel::PerAxis, [50.0, 100.0], None), 0.0, 0.0), 0.0);
    }

    #[test]
    fn straight_moves_may_have_different_limiting_axes_for_speed_and_acceleration() {
        // Along (3, 4)/5, y limits the speed (200 / 0.8 = 250 < 300 / 0.6) and x the acceleration (600 / 0.6 = 1000).
        let p = machine(Travel::Straight, [300.0, 200.0], Some([600.0, 2000.0]));
        let (d, v, a) = (500.0, 250.0, 1000.0);
        near(seconds(&p, 300.0, 400.0), d / v + v / a);
        near(seconds(&p, -300.0, 400.0), d / v + v / a);
        // An axis that does not move is no limit.
        near(seconds(&p, 0.0, 400.0), 400.0 / 200.0 + 200.0 / 2000.0);
    }

    #[test]
    fn per_axis_moves_take_the_time_of_the_slower_axis() {
        let p = machine(Travel::PerAxis, [100.0, 100.0], Some([1000.0, 100.0]));
        // x alone takes 1.1 s; y alone takes 2 sqrt(30 / 100) = 1.095 s, and 1.1 s just above 30.25 mm.
        near(seconds(&p, 100.0, 30.0), 1.1);
        near(seconds(&p, 100.0, 36.0), 2.0 * 0.6);
    }

    #[test]
    fn straight_is_never_faster_than_per_axis() {
        for (x, y) in [(1.0, 2.0), (50.0, 3.0), (700.0, 400.0), (0.1, 900.0)] {
            let at = |t| seconds(&machine(t, [300.0, 200.0], Some([600.0, 2000.0])), x, y);
            assert!(at(Travel::Straight) >= at(Travel::PerAxis) - 1e-12);
            assert!(at(Travel::Vector) >= at(Travel::Straight) - 1e-12);
        }
    }
}
