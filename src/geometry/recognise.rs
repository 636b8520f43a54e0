//! Recognises a curve that is one line, one arc or one circle within the tolerance.
//!
//! Drawing programs export circles as splines of four cubic pieces, fillets as rational quadratics, and lines as
//! splines of four collinear points. Each of them is converted back to the single element that the person drew, with
//! exact ends.

use super::biarc::TangentArc;
use super::math;
use super::sample::Sample;
use super::segment::{Arc, Segment};
use glam::DVec2;
use std::f64::consts::TAU;

/// The run as one line, circle or arc, if one lies within `within` mm of it.
pub(super) fn single_segment(run: &[Sample], within: f64) -> Option<Segment> {
    let (first, last) = (run.first()?, run.last()?);
    if first.point == last.point {
        return circle(run, within);
    }
    let chord = (last.point - first.point).normalize_or_zero();
    if let Some(line) = TangentArc::new(first.point, chord, last.point)
        && run.iter().all(|s| line.distance(s).is_some_and(|d| d <= within))
    {
        return Some(Segment::line(first.point, last.point));
    }
    arc(run, within)
}

/// The run as one arc through its ends, whose height over the chord minimises the largest distance.
fn arc(run: &[Sample], within: f64) -> Option<Segment> {
    let (first, middle, last) = (run.first()?, run.get(run.len() / 2)?, run.last()?);
    let turn = total_turn(run);
    let through =
        Arc::new(first.point, last.point, circumcenter(first.point, middle.point, last.point)?, turn > 0.0);
    // The arc must turn as far as the curve. The tolerance is loose because the turns of the samples are sums of sines.
    if (through.sweep - turn).abs() > 0.5 || through.radius() > 1e9 {
        return None;
    }
    let half = (last.point - first.point) * 0.5;
    let bulge = math::tan(through.sweep * 0.25);
    let candidate = |scale: f64| Arc::from_bulge(first.point, last.point, bulge * scale);
    let worst = |scale: f64| {
        Arc::bulge_center(first.point, last.point, bulge * scale)
            .and_then(|c| deviation_from_circle(run, c, first.point.distance(c), bulge * scale > 0.0))
            .unwrap_or(f64::INFINITY)
    };
    // Moving the middle by d moves no other point by more than d. If the first attempt misses by more than twice the
    // tolerance, no arc fits.
    let start = worst(1.0);
    if start > 2.0 * within {
        return None;
    }
    let rise = (half.length() * bulge.abs()).max(within);
    let best = minimise(1.0 - 2.0 * within / rise, 1.0 + 2.0 * within / rise, worst);
    let scale = if start <= worst(best) { 1.0 } else { best };
    (worst(scale) <= within).then(|| candidate(scale).map(Segment::Arc)).flatten()
}

/// A closed run as one circle through its start point.
fn circle(run: &[Sample], within: f64) -> Option<Segment> {
    let first = run.first()?;
    let turn = total_turn(run);
    if (turn.abs() - TAU).abs() > 0.5 {
        return None;
    }
    let center = circle_center(run)?;
    let worst = deviation_from_circle(run, center, center.distance(first.point), turn > 0.0)?;
    (worst <= within).then(|| {
        Segment::Arc(Arc { start: first.point, end: first.point, center, sweep: TAU.copysign(turn) })
    })
}

/// Signed sum of the sines of the angles between successive directions: about the angle in rad, as each is small.
fn total_turn(run: &[Sample]) -> f64 {
    run.windows(2).map(|w| w[0].tangent.perp_dot(w[1].tangent)).sum()
}

/// Largest distance of the samples from a circle; `None` when one of them runs in another direction.
fn deviation_from_circle(run: &[Sample], center: DVec2, radius: f64, ccw: bool) -> Option<f64> {
    let mut worst = 0.0_f64;
    for s in run {
        let v = s.point - center;
        let distance = v.length();
        let direction = if ccw { v.perp() } else { -v.perp() };
        // The directions may differ by 37 degrees, as for biarcs.
        if direction.dot(s.tangent) <= 0.8 * distance {
            return None;
        }
        worst = worst.max((distance - radius).abs());
    }
    Some(worst)
}

/// Centre of the circle through three points; `None` when they lie on a line.
fn circumcenter(a: DVec2, b: DVec2, c: DVec2) -> Option<DVec2> {
    let (u, v) = (b - a, c - a);
    let cross = 2.0 * u.perp_dot(v);
    let center = a + (u * v.length_squared() - v * u.length_squared()).perp() * (-1.0 / cross);
    center.is_finite().then_some(center)
}

/// Centre of the circle that fits the samples best in the algebraic least-squares sense (I. Kasa, "A circle fitting
/// procedure and its error analysis", IEEE Trans. Instrum. Meas. 25 (1976), doi:10.1109/TIM.1976.6312298). The estimate
/// is unbiased for samples of a whole turn.
fn circle_center(run: &[Sample]) -> Option<DVec2> {
    let n = run.len() as f64;
    let mean = run.iter().map(|s| s.point).sum::<DVec2>() / n;
    let (mut xx, mut xy, mut yy, mut xz, mut yz) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for s in run {
        let p = s.point - mean;
        let z = p.length_squared();
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
        xz += p.x * z;
        yz += p.y * z;
    }
    let det = 2.0 * (xx * yy - xy * xy);
    let center = mean + DVec2::new(xz * yy - yz * xy, yz * xx - xz * xy) / det;
    center.is_finite().then_some(center)
}

/// Minimum of a unimodal function between `a` and `b`, by golden-section search.
fn minimise(mut a: f64, mut b: f64, f: impl Fn(f64) -> f64) -> f64 {
    /// (sqrt 5 - 1) / 2
    const SECTION: f64 = 0.618_033_988_749_894_9;
    let (mut c, mut d) = (b - SECTION * (b - a), a + SECTION * (b - a));
    let (mut fc, mut fd) = (f(c), f(d));
    // 0.618^16 is less than 1/2000 of the interval, which is four tolerances wide: well below the margin.
    for _ in 0..16 {
        if fc <= fd {
            (b, d, fd) = (d, c, fc);
            c = b - SECTION * (b - a);
            fc = f(c);
        } else {
            (a, c, fc) = (c, d, fd);
            d = a + SECTION * (b - a);
            fd = f(d);
        }
    }
    (a + b) * 0.5
}
