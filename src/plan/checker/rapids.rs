//! Where the head is on a rapid, from the motion of each axis by itself.
//!
//! On a machine that moves each axis as fast as it can (`travel: per-axis`), the head leaves the straight line. Its places follow
//! from the ramps of both axes.

use super::fractions::fractions;
use super::textbook::trapezoid;
use crate::geometry::DVec2;
use crate::machine::{Profile, Travel};

/// Distance of the places, mm, as if the head moved evenly, and their largest number.
const STEP: f64 = 0.5;
const MOST: f64 = 2000.0;

/// Places along a rapid of a machine that moves each axis by itself, both ends included; `None` for other machines, whose
/// rapids are straight.
pub(super) fn places(machine: &Profile, from: DVec2, to: DVec2) -> Option<Vec<DVec2>> {
    if machine.travel != Travel::PerAxis {
        return None;
    }
    let [vx, vy] = machine.rapid.speed;
    let [ax, ay] = machine.rapid.accel.unwrap_or([f64::INFINITY; 2]);
    let (way, toward) = ((to - from).abs(), (to - from).signum());
    let (x, y) = (Axis::new(way.x, vx, ax), Axis::new(way.y, vy, ay));
    let seconds = x.seconds.max(y.seconds);
    let mut places = vec![from];
    let between = fractions(way.x + way.y, STEP, [2.0, MOST]).filter(|f| 0.0 < *f && *f < 1.0);
    places.extend(between.map(|f| from + DVec2::new(x.at(f * seconds), y.at(f * seconds)) * toward));
    places.push(to);
    Some(places)
}

/// The motion of one axis from rest to rest.
struct Axis {
    length: f64,
    /// Its highest speed, mm/s, and the seconds until it has that.
    speed: f64,
    ramp: f64,
    accel: f64,
    seconds: f64,
}

impl Axis {
    fn new(length: f64, most: f64, accel: f64) -> Self {
        let speed = most.min((accel * length).sqrt());
        let ramp = if accel.is_finite() { speed / accel } else { 0.0 };
        Self { length, speed, ramp, accel, seconds: trapezoid(length, most, accel) }
    }

    /// How far it has gone after `t` seconds, mm.
    fn at(&self, t: f64) -> f64 {
        let left = self.seconds - t;
        if left <= 0.0 {
            self.length
        } else if t < self.ramp {
            0.5 * self.accel * t * t
        } else if left < self.ramp {
            self.length - 0.5 * self.accel * left * left
        } else {
            self.speed * (t - 0.5 * self.ramp)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::preset;

    #[test]
    fn the_shorter_axis_is_there_first() {
        let machine = |accel| {
            let mut machine = preset("fibre-3kw-thin").unwrap();
            (machine.rapid.speed, machine.rapid.accel) = ([100.0; 2], accel);
            machine
        };
        let (from, to) = (DVec2::new(10.0, 50.0), DVec2::new(110.0, 20.0));
        let near = |accel, place: DVec2| {
            let places = places(&machine(accel), from, to).unwrap();
            places.iter().map(|p| p.distance(place)).fold(f64::INFINITY, f64::min)
        };
        // Without ramps, a corner.
        assert!(near(None, DVec2::new(40.0, 20.0)) < 0.3);
        // With 1000 mm/s2, y needs 0.1 s and 5 mm to speed up and slow down. After 0.35 s it has 1.25 mm to go, and x 30 mm behind it.
        assert!(near(Some([1000.0; 2]), DVec2::new(40.0, 21.25)) < 0.3);
        assert!(near(Some([1000.0; 2]), DVec2::new(40.0, 20.0)) > 0.8);
        assert_eq!(places(&Profile { travel: Travel::Straight, ..machine(None) }, from, to), None);
    }
}
