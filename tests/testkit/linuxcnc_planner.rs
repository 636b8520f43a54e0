//! How long LinuxCNC takes to run a program with G64 P: its trapezoidal blending, written from its documentation.
//!
//! Source: "Trajectory Control" in the LinuxCNC user manual (user-concepts, G64 P-) and the description of the blend in the
//! developer manual: every segment is a trapezoid of speed from rest to rest. While one segment brakes, the next starts, as
//! soon as the speed has fallen to v = 2 sqrt(a P / cos(t)), where P is the tolerance and t half the angle between the
//! segments as seen from the corner, so that the corner is cut short by at most P. This is the planner that looks ahead by
//! one segment; later versions run tangent segments together.

use super::gcode::{Event, Program};
use super::grbl_planner::Machine;
use super::paths::Element;
use glam::DVec2;

struct Segment {
    /// Seconds from rest to rest.
    seconds: f64,
    /// Highest speed that is reached, mm/s.
    peak: f64,
    accel: f64,
    enters: DVec2,
    leaves: DVec2,
}

/// Seconds of a whole program with the tolerance P, mm.
pub(crate) fn program_seconds(machine: Machine, tolerance: f64, program: &Program) -> f64 {
    let (mut sum, mut stretch) = (0.0, Vec::new());
    for event in &program.events {
        match event {
            Event::Motion(m) if (m.path.to - m.path.from).length() > 0.0 || m.path.arc.is_some() => {
                stretch.push(segment(machine, &m.path, m.rapid, m.feed / 60.0));
            }
            Event::Dwell { seconds, .. } => sum += seconds + run(tolerance, &std::mem::take(&mut stretch)),
            Event::Motion(_) | Event::Comment(_) => {}
        }
    }
    sum + run(tolerance, &stretch)
}

fn segment(machine: Machine, path: &Element, rapid: bool, feed: f64) -> Segment {
    let (length, enters, leaves, turn) = match path.arc {
        None => {
            let way = path.to - path.from;
            (way.length(), way.normalize(), way.normalize(), f64::INFINITY)
        }
        Some((center, sweep)) => {
            let (a, b) = (path.from - center, path.to - center);
            let tangent = |v: DVec2| v.perp().normalize() * sweep.signum();
            (a.length() * sweep.abs(), tangent(a), tangent(b), a.length())
        }
    };
    let along = |limits: [f64; 2]| (limits[0] / enters.x.abs()).min(limits[1] / enters.y.abs());
    let (nominal, accel) =
        if rapid { (along(machine.rapid_speed), along(machine.rapid_accel)) } else { (feed, machine.accel) };
    // On an arc, the acceleration also turns the head.
    let nominal = nominal.min((accel * turn).sqrt());
    let peak = nominal.min((accel * length).sqrt());
    Segment { seconds: length / peak + peak / accel, peak, accel, enters, leaves }
}

fn run(tolerance: f64, segments: &[Segment]) -> f64 {
    let whole: f64 = segments.iter().map(|s| s.seconds).sum();
    let blend = |pair: &[Segment]| {
        let (a, b) = (&pair[0], &pair[1]);
        let accel = a.accel.min(b.accel);
        // The angle as seen from the corner is pi for straight on, where nothing limits the blend.
        let half = 0.5 * (-a.leaves.dot(b.enters)).clamp(-1.0, 1.0).acos();
        let limit = 2.0 * (accel * tolerance / half.cos().max(1e-9)).sqrt();
        limit.min(a.peak).min(b.peak) / accel
    };
    whole - segments.windows(2).map(blend).sum::<f64>()
}
