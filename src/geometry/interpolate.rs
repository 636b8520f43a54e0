//! Splines through fit points, as drawing programs make them from the points a person clicked.
//!
//! The result is a cubic spline with continuous curvature through all points, parametrised by chord length. At an end
//! it has the given direction, or zero curvature ("natural"); a closed spline is periodic. CAD programs draw the same
//! curve (ezdxf found this by comparison with BricsCAD, see its `fit_points_to_cad_cv`). L. Piegl, W. Tiller, "The
//! NURBS Book", 2nd ed., section 9.2; C. de Boor, "A Practical Guide to Splines", chapter IV, for the slopes.

use super::knots::CurveError;
use super::nurbs::Nurbs;
use glam::DVec2;

impl Nurbs {
    /// The cubic spline through `points` (mm). Only the directions of the tangents matter; a zero tangent counts as
    /// missing. Repeated points count once. Two points without tangents give a line.
    ///
    /// # Errors
    /// There are fewer than two distinct points, or a value is not finite.
    pub fn interpolate(
        points: &[DVec2],
        start_tangent: Option<DVec2>,
        end_tangent: Option<DVec2>,
        closed: bool,
    ) -> Result<Self, CurveError> {
        let finite = points.iter().all(|p| p.is_finite());
        if !(finite && start_tangent.is_none_or(DVec2::is_finite) && end_tangent.is_none_or(DVec2::is_finite))
        {
            return Err(CurveError::NotFinite);
        }
        let mut points = points.to_vec();
        points.dedup();
        if let (true, Some(first)) = (closed, points.first().copied())
            && points.last() != Some(&first)
        {
            points.push(first);
        }
        if points.len() < 2 {
            return Err(CurveError::TooFewFitPoints);
        }
        let steps: Vec<f64> = points.windows(2).map(|w| w[0].distance(w[1])).collect();
        let direction = |t: Option<DVec2>| t.and_then(DVec2::try_normalize);
        let periodic = closed && points.len() > 3;
        let slopes = if periodic {
            periodic_slopes(&points, &steps)
        } else {
            end_slopes(&points, &steps, direction(start_tangent), direction(end_tangent))
        };
        from_hermite(&points, &steps, &slopes)
    }
}

/// The spline with the given points and slopes, as cubic Bezier pieces with every knot three times.
fn from_hermite(points: &[DVec2], steps: &[f64], slopes: &[DVec2]) -> Result<Nurbs, CurveError> {
    let mut control = vec![points[0]];
    let mut knots = vec![0.0; 4];
    let mut at = 0.0;
    for (i, h) in steps.iter().enumerate() {
        control.push(points[i] + slopes[i] * (h / 3.0));
        control.push(points[i + 1] - slopes[i + 1] * (h / 3.0));
        control.push(points[i + 1]);
        at += h;
        knots.extend([at; 3]);
    }
    knots.push(at);
    Nurbs::new(3, control, Vec::new(), knots)
}

/// One row of the system `below * m[i - 1] + diagonal * m[i] + above * m[i + 1] = right`.
#[derive(Clone, Copy)]
struct Row {
    below: f64,
    diagonal: f64,
    above: f64,
    right: DVec2,
}

/// The row that makes the curvature continuous at an inner point between steps `h0` and `h1`.
fn inner(before: DVec2, at: DVec2, after: DVec2, h0: f64, h1: f64) -> Row {
    Row {
        below: h1,
        diagonal: 2.0 * (h0 + h1),
        above: h0,
        right: ((at - before) * (h1 / h0) + (after - at) * (h0 / h1)) * 3.0,
    }
}

/// Slopes for given or natural ends.
fn end_slopes(points: &[DVec2], steps: &[f64], start: Option<DVec2>, end: Option<DVec2>) -> Vec<DVec2> {
    let n = points.len();
    // The parameter is the chord length, so the slope at an end is the unit vector of the given direction.
    let given = |t: DVec2| Row { below: 0.0, diagonal: 1.0, above: 0.0, right: t };
    let chord = |i: usize| (points[i + 1] - points[i]) / steps[i];
    let mut rows = Vec::with_capacity(n);
    rows.push(start.map_or(Row { below: 0.0, diagonal: 2.0, above: 1.0, right: chord(0) * 3.0 }, given));
    rows.extend((1..n - 1).map(|i| inner(points[i - 1], points[i], points[i + 1], steps[i - 1], steps[i])));
    rows.push(end.map_or(Row { below: 1.0, diagonal: 2.0, above: 0.0, right: chord(n - 2) * 3.0 }, given));
    tridiagonal(&rows)
}

/// Slopes of a closed curve, whose last point is the first. The Sherman-Morrison formula accounts for the two corners
/// of the cyclic matrix.
fn periodic_slopes(points: &[DVec2], steps: &[f64]) -> Vec<DVec2> {
    let n = steps.len();
    let mut rows: Vec<Row> = (0..n)
        .map(|i| {
            let before = (i + n - 1) % n;
            inner(points[before], points[i], points[i + 1], steps[before], steps[i])
        })
        .collect();
    let (corner_top, corner_bottom) = (rows[0].below, rows[n - 1].above);
    // The matrix plus u v^T, with u = (g, 0, .., bottom) and v = (1, 0, .., top / g).
    let g = -rows[0].diagonal;
    rows[0].diagonal -= g;
    rows[n - 1].diagonal -= corner_bottom * corner_top / g;
    let y = tridiagonal(&rows);
    let u: Vec<Row> = rows
        .iter()
        .enumerate()
        .map(|(i, r)| {
            let entry = if i == 0 { g } else { 0.0 } + if i == n - 1 { corner_bottom } else { 0.0 };
            Row { right: DVec2::new(entry, 0.0), ..*r }
        })
        .collect();
    let z = tridiagonal(&u);
    let ratio = corner_top / g;
    let factor = (y[0] + y[n - 1] * ratio) / (1.0 + z[0].x + z[n - 1].x * ratio);
    let mut slopes: Vec<DVec2> = y.iter().zip(&z).map(|(y, z)| *y - factor * z.x).collect();
    slopes.push(slopes[0]);
    slopes
}

/// Thomas' algorithm. The rows are diagonally dominant, so no pivoting is needed.
fn tridiagonal(rows: &[Row]) -> Vec<DVec2> {
    let mut above = Vec::with_capacity(rows.len());
    let mut out: Vec<DVec2> = Vec::with_capacity(rows.len());
    for (i, r) in rows.iter().enumerate() {
        let (a, x) = if i == 0 { (0.0, DVec2::ZERO) } else { (above[i - 1], out[i - 1]) };
        let pivot = r.diagonal - r.below * a;
        above.push(r.above / pivot);
        out.push((r.right - x * r.below) / pivot);
    }
    for i in (0..rows.len().saturating_sub(1)).rev() {
        let next = out[i + 1];
        out[i] -= next * above[i];
    }
    out
}
