//! Speed limit on an arc.
//!
//! GRBL divides an arc into chords that deviate from it by at most its arc tolerance e (setting `$12`), and plans them
//! like any other lines, so only the corners between chords limit the speed. A chord of an arc of radius r turns by 2
//! x, with x = sqrt(e (2 r - e)) / r. The junction speed of `lookahead.rs` then gives
//!
//! v^2 = a delta cos x / (1 - cos x), which is about a r delta / e.
//!
//! With GRBL's delta of 0.010 mm and e of 0.002 mm, that is five times what a centripetal acceleration of a would
//! allow. Between two corners the head accelerates and brakes again. The model uses the mean speed over a chord, so a
//! part of an arc takes its share of the time wherever the arc is divided. GRBL rounds the number of chords down, which
//! can drop up to one chord of an arc; this depends on the entry of the contour and is neglected.
//!
//! **Short arcs.** GRBL runs an arc of less than two chords as one line, whose corners turn by half of the arc's sweep
//! each. An outline with jogs of a few micrometres has hundreds of such arcs once it is offset by the kerf. The part of
//! an arc between an entry and its end is short, too, but must not be faster than it is within the whole arc, or a plan
//! could take less time than its lower bound. It is not: the head starts or stops at the entry, and two chords, 4 r x, are
//! too short to reach the limit of the whole arc, as 8 a r x <= a r delta / e if delta >= 8 x e.
//!
//! A machine without a junction deviation is limited by the centripetal acceleration: v^2 = a r.
//!
//! Source: GRBL 1.1, wiki "Grbl v1.1 Configuration" (`$11`, `$12`), `mc_arc` of motion_control.c.

use super::ramp::seconds;
use crate::geometry::math;

/// Largest deviation of chords from an arc, mm: the default of GRBL's `$12`.
const ARC_TOLERANCE: f64 = 0.002;
/// Least junction deviation, in x times the arc tolerance, with which short arcs count as lines: 8, and a margin for
/// what the formula above neglects.
const DEVIATION_FOR_LINES: f64 = 10.0;
/// Cosine above which GRBL treats a corner as straight.
const STRAIGHT: f64 = 0.999_999;

/// Square of the speed limit, (mm/s)^2, on an arc of radius `radius` mm and of `sweep` rad; at most `top2`.
pub(super) fn arc_speed2(deviation: Option<f64>, accel: f64, top2: f64, radius: f64, sweep: f64) -> f64 {
    let Some(deviation) = deviation else { return top2.min(accel * radius) };
    let half2 = ARC_TOLERANCE * (2.0 * radius - ARC_TOLERANCE);
    // The controller runs a circle smaller than the tolerance as one line.
    if half2 <= 0.0 {
        return top2;
    }
    // Since 1 - cos x is at most x^2 / 2, this test needs no root nor cosine where the arc is no limit, which is nearly
    // everywhere.
    if accel * deviation * (2.0 * radius * radius / half2 - 1.0) >= top2 {
        return top2;
    }
    let half = half2.sqrt();
    let mut x = half / radius;
    if deviation >= DEVIATION_FOR_LINES * ARC_TOLERANCE * x {
        x = x.min(0.25 * sweep.abs());
    }
    let cos = math::cos(x);
    if 2.0 * cos * cos - 1.0 > STRAIGHT {
        return top2;
    }
    let corner2 = (accel * deviation * cos / (1.0 - cos)).max(0.0);
    if corner2 >= top2 {
        return top2;
    }
    let chord = 2.0 * radius * math::sin(x);
    let mean = chord / seconds(chord, top2, corner2, corner2, accel);
    mean * mean
}
