//! A piece that may tip: its outline, and what a move does near it.

use crate::geometry::{Aabb, DVec2, math};
use std::f64::consts::FRAC_PI_4;

/// A move is over a piece if it is this deep inside the outline, mm: more than the chords of arcs leave.
const DEPTH: f64 = 0.03;
/// A move comes nearer to a piece than at its ends if it does so by more than this, mm: far below what matters, and above
/// rounding.
const NEARER: f64 = 1e-6;
/// Directions of the octagon around a piece.
const SIDES: u32 = 8;

/// A piece that may tip once everything that holds it is cut.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// What frees it, once all of these are cut: contours of the sheet, which are items of the search.
    pub cut_by: Vec<u32>,
    /// The contour of the sheet that is drawn where it is.
    pub drawn: u32,
    /// The corners of its outline.
    outline: Vec<DVec2>,
    bounds: Aabb,
}

impl Piece {
    /// A piece with the corners of its outline, in either direction. It is drawn as the first of what frees it.
    pub fn new(cut_by: Vec<u32>, outline: Vec<DVec2>) -> Self {
        let bounds = outline.iter().fold(Aabb::EMPTY, |b, &p| b.with(p));
        Self { drawn: cut_by.first().copied().unwrap_or_default(), cut_by, outline, bounds }
    }

    /// The same, drawn as another contour.
    pub fn drawn_as(self, drawn: u32) -> Self {
        Self { drawn, ..self }
    }

    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The corners of its outline.
    pub fn outline(&self) -> &[DVec2] {
        &self.outline
    }

    fn edges(&self) -> impl Iterator<Item = (DVec2, DVec2)> {
        let last = self.outline.last().copied().into_iter();
        last.chain(self.outline.iter().copied()).zip(self.outline.iter().copied())
    }

    /// Distance of a place from the piece, mm; 0 inside.
    pub fn distance(&self, place: DVec2) -> f64 {
        if self.holds(place) { 0.0 } else { self.to_outline(place) }
    }

    fn to_outline(&self, place: DVec2) -> f64 {
        self.edges().map(|(a, b)| to_line(place, a, b)).fold(f64::INFINITY, f64::min).sqrt()
    }

    /// Whether a place is inside the outline, by the parity of the edges to its right.
    fn holds(&self, p: DVec2) -> bool {
        if !self.bounds.contains(p) {
            return false;
        }
        let right = |(a, b): &(DVec2, DVec2)| {
            (a.y <= p.y) != (b.y <= p.y) && a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) > p.x
        };
        self.edges().filter(right).count() % 2 == 1
    }

    /// Whether a place is inside, and not only by the rounding of the outline.
    fn is_over(&self, place: DVec2) -> bool {
        self.holds(place) && self.to_outline(place) > DEPTH
    }

    /// Whether a straight move with the head down crosses the piece; see the module's documentation.
    pub fn is_crossed(&self, from: DVec2, to: DVec2, reach: f64) -> bool {
        if !meets(from, to, &self.bounds.grown(reach)) {
            return false;
        }
        let (nearest, ends) = self.approach(from, to, reach);
        if nearest >= reach {
            // All outside, or all within, where it begins.
            return false;
        }
        let is_nearer = nearest < ends - NEARER && !self.holds(from) && !self.holds(to);
        is_nearer || self.runs_over(&[from, to])
    }

    /// Whether a move with the head down that runs anywhere within a triangle, from its first place to its last, crosses the piece
    /// along the other two sides or has it within.
    pub fn is_crossed_within(&self, triangle: [DVec2; 3], reach: f64) -> bool {
        let [from, corner, to] = triangle;
        let area = self.bounds.grown(reach);
        let legs = [(from, corner), (corner, to)].into_iter().filter(|(a, b)| meets(*a, *b, &area));
        let nearest = legs.map(|(a, b)| self.approach(a, b, reach).0).fold(f64::INFINITY, f64::min);
        let outside = !self.holds(from) && !self.holds(to);
        let is_nearer = || nearest < self.to_outline(from).min(self.to_outline(to)) - NEARER;
        (nearest < reach && ((outside && is_nearer()) || self.runs_over(&triangle)))
            || (outside && self.outline.iter().any(|&p| is_within(p, triangle)))
    }

    /// How near a move comes to the outline, and how near its ends are, mm; anything from `reach` on if it keeps that distance,
    /// and anything farther than the move if its ends are. Edges that are too far away to matter are passed over by their
    /// corners' places along the move and beside it.
    fn approach(&self, from: DVec2, to: DVec2, reach: f64) -> (f64, f64) {
        let length = from.distance(to);
        let along = (to - from) / length;
        let seen = |p: DVec2| (along.dot(p - from), along.perp_dot(p - from));
        let (mut nearest, mut ends) = (f64::INFINITY, f64::INFINITY);
        let mut far = reach + 2.0 * NEARER;
        let Some(mut a) = self.outline.last().copied() else { return (nearest, ends) };
        let mut at_a = seen(a);
        for &b in &self.outline {
            let at_b = seen(b);
            let beside = at_a.1.min(at_b.1) > far || at_a.1.max(at_b.1) < -far;
            let beyond = at_a.0.min(at_b.0) > length + far || at_a.0.max(at_b.0) < -far;
            // A move of no length has no direction, and everything is looked at.
            if !beside && !beyond {
                let end = to_line(from, a, b).min(to_line(to, a, b));
                ends = ends.min(end);
                nearest = nearest.min(end.min(between((from, to), (a, b))));
                far = far.min(nearest.sqrt() + 2.0 * NEARER);
            }
            (a, at_a) = (b, at_b);
        }
        (nearest.sqrt(), ends.sqrt())
    }

    /// Whether a move by these places runs over the piece between places outside it. Where it begins or ends inside, that stretch
    /// is exempt.
    fn runs_over(&self, places: &[DVec2]) -> bool {
        let over: Vec<bool> = places.windows(2).flat_map(|w| self.stretches(w[0], w[1])).collect();
        let is_over = |place: Option<&DVec2>| place.is_some_and(|&p| self.is_over(p));
        let first = if is_over(places.first()) { over.iter().position(|o| !o) } else { Some(0) };
        let last =
            if is_over(places.last()) { over.iter().rposition(|o| !o) } else { over.len().checked_sub(1) };
        first.zip(last).and_then(|(a, b)| over.get(a..=b)).is_some_and(|rest| rest.contains(&true))
    }

    /// Whether the stretches between outlines of a straight move are over the piece, in order.
    fn stretches(&self, from: DVec2, to: DVec2) -> Vec<bool> {
        let way = to - from;
        let mut cuts: Vec<f64> = Vec::new();
        for (a, b) in self.edges() {
            let edge = b - a;
            // Where an edge that the move runs along ends, what follows may be over the piece.
            let t = (a - from).dot(way) / way.length_squared();
            if (a - from).perp_dot(way).abs() <= DEPTH * way.length() && t > 0.0 && t < 1.0 {
                cuts.push(t);
            }
            if (a - from).perp_dot(way) * (b - from).perp_dot(way) > 0.0 {
                // Both corners are on one side.
                continue;
            }
            let across = way.perp_dot(edge);
            if across != 0.0 {
                let (t, u) = ((a - from).perp_dot(edge) / across, (a - from).perp_dot(way) / across);
                if t > 0.0 && t < 1.0 && (0.0..=1.0).contains(&u) {
                    cuts.push(t);
                }
            }
        }
        cuts.sort_unstable_by(f64::total_cmp);
        let stops: Vec<f64> = [0.0].into_iter().chain(cuts).chain([1.0]).collect();
        let lengths = stops.windows(2).filter(|w| w[1] > w[0]);
        lengths.map(|w| self.is_over(from + way * (0.5 * (w[0] + w[1])))).collect()
    }

    /// The corners of an octagon that keeps `reach` mm from the piece.
    pub fn octagon(&self, reach: f64) -> impl Iterator<Item = DVec2> {
        let side = move |k: u32| {
            let normal = math::unit(FRAC_PI_4 * f64::from(k % SIDES));
            let far = self.outline.iter().map(|p| p.dot(normal)).fold(f64::NEG_INFINITY, f64::max);
            (normal, far + reach)
        };
        (0..SIDES).map(move |k| {
            let ((n, d), (m, e)) = (side(k), side(k + 1));
            // Where both sides meet.
            DVec2::new(d * m.y - e * n.y, e * n.x - d * m.x) / n.perp_dot(m)
        })
    }
}

/// Squared distance of a place from a line.
fn to_line(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let edge = b - a;
    let squared = edge.length_squared();
    let t = if squared > 0.0 { ((p - a).dot(edge) / squared).clamp(0.0, 1.0) } else { 0.0 };
    p.distance_squared(a + edge * t)
}

/// Squared distance of a line from the ends of another; 0 where they cross.
fn between((a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2)) -> f64 {
    let sides =
        |p: DVec2, q: DVec2, x: DVec2, y: DVec2| (q - p).perp_dot(x - p) * (q - p).perp_dot(y - p) < 0.0;
    if sides(a, b, c, d) && sides(c, d, a, b) {
        return 0.0;
    }
    to_line(c, a, b).min(to_line(d, a, b))
}

/// Whether a place is within a triangle, and not on a side of it.
fn is_within(p: DVec2, [a, b, c]: [DVec2; 3]) -> bool {
    let [u, v, w] = [(a, b), (b, c), (c, a)].map(|(a, b)| (b - a).perp_dot(p - a));
    u * v > 0.0 && v * w > 0.0
}

/// Whether a line shares a point with a box.
fn meets(a: DVec2, b: DVec2, area: &Aabb) -> bool {
    let (low, high) = (a.min(b), a.max(b));
    if low.cmpgt(area.max).any() || high.cmplt(area.min).any() {
        return false;
    }
    // All corners of the box are on one side of the line, or it meets the box.
    let (way, half) = (b - a, area.size() * 0.5);
    way.perp_dot(area.center() - a).abs() <= way.x.abs() * half.y + way.y.abs() * half.x
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_xoshiro::Xoshiro256PlusPlus;

    fn p(x: f64, y: f64) -> DVec2 {
        DVec2::new(x, y)
    }

    /// Edges that are far away are passed over, and that changes nothing: random stars and moves, also along their edges.
    #[test]
    fn edges_that_are_passed_over_do_not_matter() {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(11);
        let mut place = |size: f64| p(size * rng.random::<f64>(), size * rng.random::<f64>());
        let (mut crossed, mut clear) = (0, 0);
        for _ in 0..300 {
            let mut star = |k: u32| p(50.0, 50.0) + math::unit(f64::from(k) * 0.3) * (5.0 + place(30.0).x);
            let piece = Piece::new(vec![0], (0..21).map(&mut star).collect());
            for k in 0..40 {
                let corner = piece.outline[k % 21];
                let (from, to) = match k % 3 {
                    0 => (place(100.0), place(100.0)),
                    1 => (corner, place(100.0)),
                    _ => (corner, piece.outline[(k * 7 + 1) % 21]),
                };
                let to_move = |a: DVec2, b: DVec2| {
                    to_line(from, a, b).min(to_line(to, a, b)).min(between((from, to), (a, b)))
                };
                let nearest = piece.edges().map(|(a, b)| to_move(a, b)).fold(f64::INFINITY, f64::min).sqrt();
                let ends = piece.distance(from).min(piece.distance(to));
                let expected =
                    nearest < 5.0 && (nearest < ends - NEARER || piece.runs_over(&[from, to])) && from != to;
                assert_eq!(piece.is_crossed(from, to, 5.0), expected, "{from} to {to}");
                if expected { crossed += 1 } else { clear += 1 }
            }
        }
        assert!(crossed > 2000 && clear > 2000, "{crossed} crossed, {clear} clear");
    }

    /// A square of 20 mm, and a reach of 5 mm.
    fn crossed(from: DVec2, to: DVec2) -> bool {
        let corners = vec![p(0.0, 0.0), p(20.0, 0.0), p(20.0, 20.0), p(0.0, 20.0)];
        let turned: Vec<DVec2> = corners.iter().rev().copied().collect();
        let [one, other] = [corners, turned].map(|c| Piece::new(vec![0], c).is_crossed(from, to, 5.0));
        assert_eq!(one, other);
        assert_eq!(
            one,
            Piece::new(
                vec![0],
                [(0, 0), (20, 0), (20, 20), (0, 20)].map(|(x, y)| p(x.into(), y.into())).to_vec()
            )
            .is_crossed(to, from, 5.0)
        );
        one
    }

    #[test]
    fn moves_past_and_over_a_piece_by_hand() {
        assert!(!crossed(p(-50.0, 26.0), p(50.0, 26.0)), "clear of it");
        assert!(crossed(p(-50.0, 24.0), p(50.0, 24.0)), "past it, too near");
        assert!(crossed(p(-50.0, 10.0), p(50.0, 10.0)), "over it");
        assert!(crossed(p(0.0, 10.0), p(20.0, 10.0)), "from its edge over it");
        assert!(crossed(p(0.0, 10.0), p(60.0, 10.0)), "from its edge over it and away");
        assert!(!crossed(p(20.0, 10.0), p(60.0, 10.0)), "from its edge away");
        assert!(!crossed(p(22.0, 10.0), p(22.0, 60.0)), "from beside it, no nearer");
        assert!(crossed(p(24.0, 24.0), p(-24.0, 23.0)), "from beside it, nearer");
        assert!(!crossed(p(10.0, 10.0), p(60.0, 10.0)), "from within it, straight out");
        assert!(!crossed(p(0.0, 20.0), p(0.0, 60.0)), "from a corner away");
        assert!(!crossed(p(0.0, 0.0), p(20.0, 0.0)), "along an edge");
        assert!(!crossed(p(5.0, 5.0), p(15.0, 15.0)), "within it");
    }

    /// The move runs along the edge below the notch, and is over the piece after that. By rounding it passes a hair below the corner.
    #[test]
    fn a_move_along_an_edge_and_then_over_the_piece_crosses_it() {
        let y = 73.712_916_666_666_7;
        let notched = [(67.0, y), (126.0, y), (126.0, 88.0), (138.0, 88.0), (138.0, 60.0), (67.0, 60.0)];
        let piece = Piece::new(vec![0], notched.map(|(x, y)| p(x, y)).to_vec());
        let [from, corner, beyond] = [p(67.0, y), p(126.0, y), p(210.0, y - 2e-14)];
        assert!(beyond.y < y);
        assert!(piece.is_crossed(from, beyond, 5.0) && piece.is_crossed(beyond, from, 5.0));
        assert!(!piece.is_crossed(from, corner, 5.0) && piece.is_crossed(corner, beyond, 5.0));
    }

    #[test]
    fn an_octagon_keeps_its_distance() {
        let square = Piece::new(vec![0], vec![p(0.0, 0.0), p(20.0, 0.0), p(20.0, 20.0), p(0.0, 20.0)]);
        let places: Vec<DVec2> = square.octagon(5.0).collect();
        assert_eq!(places.len(), 8);
        assert!(places.iter().all(|&place| square.distance(place) >= 5.0 - 1e-9), "{places:?}");
        let round: Vec<bool> =
            (0..8).map(|k| square.is_crossed(places[k], places[(k + 1) % 8], 5.0 - 1e-6)).collect();
        assert_eq!(round, [false; 8], "its sides keep it, too");
    }
}
