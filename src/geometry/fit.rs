//! From a parametric curve to lines and arcs within a tolerance.
//!
//! 1. The curve is sampled and split where its direction jumps ([`sample`](super::sample)).
//! 2. A run between two kinks that is one line, one arc or one circle within the tolerance becomes just that.
//! 3. Otherwise the stretches of a run that *are* a line or an arc, far below the tolerance, are taken as such: a
//!    drawn line or fillet comes back exact.
//! 4. What is left is covered by the longest possible biarcs, one after the other. For pieces that interpolate the
//!    curve and its direction the greedy choice is optimal in number (R. L. S. Drysdale, G. Rote, A. Sturm,
//!    "Approximation of an open polygonal curve with a minimum number of circular arcs and biarcs", Comput. Geom. 41
//!    (2008), doi:10.1016/j.comgeo.2007.10.009).
//! 5. Neighbours that lie on one line or circle are merged.
//!
//! Chains join bit for bit; within a run the direction is continuous; the ends are those of the curve.

use super::biarc::{Biarc, Bow};
use super::math;
use super::sample::{self, Curve, Sample};
use super::segment::{Arc, Segment};
use glam::DVec2;
use std::f64::consts::TAU;

/// Share of the tolerance a fit may use as measured at the samples. The rest covers the samples' own resolution (a
/// twentieth) and what lies between them.
const MEASURED: f64 = 0.85;
/// Share of the tolerance within which a stretch *is* a line or an arc, and two neighbours lie on one.
const EXACT: f64 = 0.002;
/// A stretch that is exact is taken as one piece when it reaches at least this share of what the full tolerance
/// reaches with one arc. On a curve of steadily changing curvature the shares are as the cube roots of the
/// tolerances, 0.13 here: such a stretch is no drawn line or arc.
const DRAWN: f64 = 0.6;
/// A drawn line or arc arrives in its own direction, but for rounding of the drawing: sine of 0.006 degrees.
const ARRIVES: f64 = 1e-4;
/// Largest sum of sines of the turns inside one biarc: about half a circle, so that its arcs stay below that.
const TURN: f64 = 3.0;
/// The finest tolerance, mm: a nanometre. Below, rounding of coordinates of 1 m decides.
const FINEST: f64 = 1e-6;

/// The curve as lines and arcs, each nowhere farther than `tolerance` mm (at least a nanometre) from it, and the
/// curve from them. Empty for a curve without length or with
/// numbers that are not finite.
pub(super) fn fit(curve: &dyn Curve, tolerance: f64) -> Vec<Segment> {
    let tolerance = if tolerance.is_finite() { tolerance.max(FINEST) } else { FINEST };
    let mut out = Vec::new();
    if !curve.extent().is_finite() {
        return out;
    }
    for run in sample::runs(curve, tolerance) {
        match whole(&run, tolerance * MEASURED) {
            Some(segment) => out.push(segment),
            None => pieces(&run, tolerance, &mut out),
        }
    }
    out
}

/// The run as one line, circle or arc within `within` mm.
fn whole(run: &[Sample], within: f64) -> Option<Segment> {
    let (first, last) = (run.first()?, run.last()?);
    if first.point == last.point {
        return circle(run, within);
    }
    let chord = (last.point - first.point).normalize_or_zero();
    if let Some(line) = Bow::new(first.point, chord, last.point)
        && run.iter().all(|s| line.distance(s).is_some_and(|d| d <= within))
    {
        return Some(Segment::line(first.point, last.point));
    }
    arc(run, within)
}

/// The run as one arc through its ends. The height over the chord is chosen to make the largest distance least.
fn arc(run: &[Sample], within: f64) -> Option<Segment> {
    let (first, middle, last) = (run.first()?, run.get(run.len() / 2)?, run.last()?);
    let turn = total_turn(run);
    let through =
        Arc::new(first.point, last.point, circumcenter(first.point, middle.point, last.point)?, turn > 0.0);
    // One turn of the curve must be one turn of the arc; samples turn by sines, so compare loosely.
    if (through.sweep - turn).abs() > 0.5 || through.radius() > 1e9 {
        return None;
    }
    let half = (last.point - first.point) * 0.5;
    let bulge = math::tan(through.sweep * 0.25);
    let candidate = |scale: f64| Arc::from_bulge(first.point, last.point, bulge * scale);
    let worst = |scale: f64| {
        candidate(scale)
            .and_then(|a| deviation_from_circle(run, a.center, a.radius(), a.ccw()))
            .unwrap_or(f64::INFINITY)
    };
    // Moving the middle by d moves no other point by more: when the first try is off by more than twice the
    // tolerance no arc fits.
    let start = worst(1.0);
    if start > 2.0 * within {
        return None;
    }
    let rise = (half.length() * bulge.abs()).max(within);
    let best = least(1.0 - 2.0 * within / rise, 1.0 + 2.0 * within / rise, worst);
    let scale = if start <= worst(best) { 1.0 } else { best };
    (worst(scale) <= within).then(|| candidate(scale).map(Segment::Arc)).flatten()
}

/// A closed run as one circle through its start.
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

/// Signed sum of the angles between successive directions, rad.
fn total_turn(run: &[Sample]) -> f64 {
    run.windows(2).map(|w| math::turn(w[0].tangent, w[1].tangent)).sum()
}

/// Largest distance of the samples from a circle; `None` when one of them runs another way round.
fn deviation_from_circle(run: &[Sample], center: DVec2, radius: f64, ccw: bool) -> Option<f64> {
    let mut worst = 0.0_f64;
    for s in run {
        let v = s.point - center;
        let distance = v.length();
        let direction = if ccw { v.perp() } else { -v.perp() };
        // Within 37 degrees, as for biarcs.
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

/// Centre of the circle nearest to the samples in the algebraic least-squares sense (I. Kasa, "A circle fitting
/// procedure and its error analysis", IEEE Trans. Instrum. Meas. 25 (1976), doi:10.1109/TIM.1976.6312298). On a
/// whole turn it is unbiased.
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

/// Where a function with one valley is least between `a` and `b`, by golden sections.
fn least(mut a: f64, mut b: f64, f: impl Fn(f64) -> f64) -> f64 {
    /// (sqrt 5 - 1) / 2
    const SECTION: f64 = 0.618_033_988_749_894_9;
    let (mut c, mut d) = (b - SECTION * (b - a), a + SECTION * (b - a));
    let (mut fc, mut fd) = (f(c), f(d));
    // 0.618^16 < 1/2000 of the interval, which is four tolerances wide: well below the margin.
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

/// A run as drawn lines and arcs with biarcs between them.
fn pieces(run: &[Sample], tolerance: f64, out: &mut Vec<Segment>) {
    let chain_start = out.len();
    // Directions at the ends of exact stretches are replaced by the exact ones: keeps the joints smooth.
    let mut run = doubled(run);
    let mut from = 0;
    for (start, end, bow) in drawn(&run, tolerance) {
        if let (Some(a), Some(b)) = (run.get(start).copied(), run.get(end).copied()) {
            run[start] = Sample { tangent: bow.start_tangent(), ..a };
            run[end] = Sample { tangent: bow.end_tangent(), ..b };
        }
        biarcs(&run[from..=start], tolerance, chain_start, out);
        push(out, chain_start, bow.segment(EXACT * tolerance), tolerance);
        from = end;
    }
    biarcs(&run[from..], tolerance, chain_start, out);
}

/// The run with a sample between any two. An interval of four samples is its own biarc to a twentieth of the tolerance,
/// so over one gap the biarc is exact to a thousandth: as good as the curve, and cheaper.
fn doubled(run: &[Sample]) -> Vec<Sample> {
    let mut out = Vec::with_capacity(2 * run.len());
    for w in run.windows(2) {
        out.push(w[0]);
        out.extend(Biarc::new(w[0], w[1]).map(|b| b.joint()));
    }
    out.extend(run.last());
    out
}

/// Stretches that are a line or an arc as drawn: index of first and last sample, and the piece.
fn drawn(run: &[Sample], tolerance: f64) -> Vec<(usize, usize, Bow)> {
    let mut out: Vec<(usize, usize, Bow)> = Vec::new();
    let mut i = 0;
    while i + 2 < run.len() {
        let exact = reach(run, i, |j| bow(run, i, j, EXACT * tolerance, ARRIVES));
        let step = exact.as_ref().map_or(1, |(j, _)| ((j - i) / 2).max(1));
        if let Some((j, piece)) = exact
            && j >= i + 4
            && let Some((full, _)) = reach(run, i, |j| bow(run, i, j, MEASURED * tolerance, 1.0))
            && run[i].point.distance(run[j].point) >= DRAWN * run[i].point.distance(run[full].point)
        {
            out.push((i, j, piece));
            i = j;
        } else {
            i += step;
        }
    }
    out
}

/// The arc from sample `i` in its direction to sample `j`, when the samples between lie within `within` mm of it
/// and it arrives in the direction of `j`, but for an angle of sine `off`.
fn bow(run: &[Sample], i: usize, j: usize, within: f64, off: f64) -> Option<Bow> {
    let (a, b) = (run.get(i)?, run.get(j)?);
    let bow = Bow::new(a.point, a.tangent, b.point)?;
    let near = run.get(i + 1..j)?.iter().all(|s| bow.distance(s).is_some_and(|d| d <= within));
    (near && bow.end_tangent().perp_dot(b.tangent).abs() <= off).then_some(bow)
}

/// The longest biarcs over a stretch, one after the other.
fn biarcs(run: &[Sample], tolerance: f64, chain_start: usize, out: &mut Vec<Segment>) {
    let flat = EXACT * tolerance;
    let stretch = Stretch::new(run, tolerance);
    let (mut i, mut tilt) = (0, 0.0);
    while i + 1 < run.len() {
        let found = reach(run, i, |j| stretch.biarc(i, tilt, j));
        let found = found.map(|(j, b)| stretch.shared(i, tilt, j).unwrap_or((j, b)));
        match found {
            Some((j, (biarc, at_end))) => {
                push(out, chain_start, biarc.first.segment(flat), tolerance);
                push(out, chain_start, biarc.second.segment(flat), tolerance);
                (i, tilt) = (j, at_end);
            }
            None => {
                // Two samples no biarc joins: nearer than the resolution, a line is as good.
                push(out, chain_start, Segment::line(run[i].point, run[i + 1].point), tolerance);
                (i, tilt) = (i + 1, 0.0);
            }
        }
    }
}

/// Samples to be covered by biarcs.
struct Stretch<'r> {
    run: &'r [Sample],
    tolerance: f64,
    /// Sum of sines of the turns up to each sample.
    turned: Vec<f64>,
    /// Length up to each sample, mm.
    length: Vec<f64>,
}

impl<'r> Stretch<'r> {
    fn new(run: &'r [Sample], tolerance: f64) -> Self {
        let (mut turned, mut length) = (vec![0.0; run.len()], vec![0.0; run.len()]);
        for i in 1..run.len() {
            turned[i] = turned[i - 1] + run[i - 1].tangent.perp_dot(run[i].tangent).abs();
            length[i] = length[i - 1] + run[i - 1].point.distance(run[i].point);
        }
        Self { run, tolerance, turned, length }
    }

    /// The biarc from sample `i`, starting `tilt` rad off its direction, to sample `j`, and how far it ends off the
    /// direction there; `None` when it is not near enough.
    fn biarc(&self, i: usize, tilt: f64, j: usize) -> Option<(Biarc, f64)> {
        if self.turned[j] - self.turned[i] > TURN {
            return None;
        }
        let (from, to, between) = (tilted(self.run[i], tilt), self.run[j], &self.run[i + 1..j]);
        // The ends of the stretch keep their directions.
        let best = match self.run.get(j + 1) {
            // Off by this angle, a piece over the next gap alone misses the curve by 0.15 tolerances at most.
            Some(next) => {
                let most = self.tolerance / next.point.distance(to.point);
                best_tilt(&Biarc::new(from, to)?, tilt).clamp(-most, most)
            }
            None => 0.0,
        };
        let biarc = Biarc::along(from, tilted(to, best), between)?;
        (biarc.deviation(between)? <= MEASURED * self.tolerance).then_some((biarc, best))
    }

    /// When a piece that reaches from `i` to `j` leaves but a sliver to the end: one to the middle of both instead.
    fn shared(&self, i: usize, tilt: f64, j: usize) -> Option<(usize, (Biarc, f64))> {
        /// What is left, as a part of the piece: below it two halves of the sum are well within reach.
        const SLIVER: f64 = 0.3;
        let (start, end) = (self.length[i], *self.length.last()?);
        let rest = end - self.length[j];
        if rest <= 0.0 || rest > SLIVER * (self.length[j] - start) {
            return None;
        }
        let middle = self.length.partition_point(|l| *l < 0.5 * (start + end)).clamp(i + 1, j);
        Some((middle, self.biarc(i, tilt, middle)?))
    }
}

/// A sample with its direction turned by a small angle, rad.
fn tilted(s: Sample, angle: f64) -> Sample {
    Sample { tangent: (s.tangent + s.tangent.perp() * angle).normalize_or_zero(), ..s }
}

/// The angle (rad) between fit and curve at a joint that lets the pieces be longest, given a biarc that ends in the
/// direction of the curve and starts `tilt` off it.
///
/// Where the curvature changes at rate k, arcs of length h with all joints on the curve stay nearest to it when they
/// leave and arrive at an angle of -k h^2 / 12: their distance is then the even wave of amplitude k h^3 / 125, a third
/// of what biarcs in the curve's own directions reach. The biarc given changes its curvature by
/// 4/3 k h + 2 tilt / h, hence k.
fn best_tilt(biarc: &Biarc, tilt: f64) -> f64 {
    /// Beyond 6 degrees the small-angle reckoning is void.
    const MOST: f64 = 0.1;
    /// 1/16 follows from the above; a quarter less gave the fewest pieces on ellipses and random splines, since the
    /// rate k changes along a piece.
    const DAMPED: f64 = 0.75 / 16.0;
    let (bend, h) = biarc.bend();
    (-(bend * h - 2.0 * tilt) * DAMPED).clamp(-MOST, MOST)
}

/// The farthest sample that `piece` reaches from `i`, and its piece: steps double while it fits, then halve.
fn reach<T>(run: &[Sample], i: usize, piece: impl Fn(usize) -> Option<T>) -> Option<(usize, T)> {
    let last = run.len() - 1;
    let mut best: Option<(usize, T)> = None;
    let mut step = 1;
    let mut beyond = last + 1;
    loop {
        let from = best.as_ref().map_or(i, |(j, _)| *j);
        let j = (from + step).min(beyond - 1);
        if j <= from {
            return best;
        }
        match piece(j) {
            Some(p) => {
                best = Some((j, p));
                step *= 2;
            }
            None => {
                beyond = j;
                step = ((j - from) / 2).max(1);
            }
        }
    }
}

/// Adds a segment, merged into the last one of the chain when both lie on one line or circle.
fn push(out: &mut Vec<Segment>, chain_start: usize, next: Segment, tolerance: f64) {
    let same = EXACT * tolerance;
    let merged = match (out.get(chain_start..).and_then(|c| c.last()), next) {
        (Some(Segment::Line(a)), Segment::Line(b)) => {
            let chord = (b.end - a.start).normalize_or_zero();
            let forward = chord.dot(a.end - a.start) > 0.0 && chord.dot(b.end - b.start) > 0.0;
            (forward && chord.perp_dot(a.end - a.start).abs() <= same).then(|| Segment::line(a.start, b.end))
        }
        (Some(Segment::Arc(a)), Segment::Arc(b)) => {
            let one = a.center.distance(b.center) + (a.radius() - b.radius()).abs() <= same;
            let sweep = a.sweep + b.sweep;
            let closes = sweep.abs() > TAU - 1e-9;
            let fits = if closes { a.start == b.end && sweep.abs() < TAU + 1e-6 } else { a.start != b.end };
            (one && a.ccw() == b.ccw() && fits).then(|| {
                let sweep = if closes { TAU.copysign(sweep) } else { sweep };
                Segment::Arc(Arc { start: a.start, end: b.end, center: a.center, sweep })
            })
        }
        _ => None,
    };
    match merged {
        Some(segment) => {
            out.pop();
            out.push(segment);
        }
        None => out.push(next),
    }
}
