//! The dual code and its operators. Each position holds a contour (first row) and the feature point where it is entered
//! (second row). Every operator returns a valid code.

use crate::problem::{ItemId, Problem};
use crate::solve::rng::{Draw, Rng};

/// A chromosome.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Code {
    /// First row: the contours in cutting order.
    pub(super) order: Vec<ItemId>,
    /// Second row: for each contour of the first row its feature point, counted from 0.
    pub(super) points: Vec<u32>,
}

/// Number of feature points of a contour.
pub(super) fn count(problem: &Problem, item: ItemId) -> u32 {
    let nodes = &problem.items[item as usize].nodes;
    nodes.end - nodes.start
}

impl Code {
    /// A random code over these contours.
    pub(super) fn random(problem: &Problem, contours: &[ItemId], rng: &mut Rng) -> Self {
        let mut order = contours.to_vec();
        for k in (1..order.len()).rev() {
            order.swap(k, rng.below(k + 1));
        }
        let points = order.iter().map(|&i| below(count(problem, i), rng)).collect();
        Self { order, points }
    }

    /// The feature point of each contour; `None` for contours that are not in the code.
    fn point_of(&self, contours: usize) -> Vec<Option<u32>> {
        let mut points = vec![None; contours];
        self.order.iter().zip(&self.points).for_each(|(&i, &p)| points[i as usize] = Some(p));
        points
    }
}

fn below(n: u32, rng: &mut Rng) -> u32 {
    u32::try_from(rng.below(n as usize)).unwrap_or(0)
}

/// Crosses two codes by one of the three methods of the paper, drawn at random.
pub(super) fn cross(problem: &Problem, pair: [&Code; 2], rng: &mut Rng) -> [Code; 2] {
    let places = pair[0].order.len();
    let method = rng.below(3);
    let mut children = pair.map(Clone::clone);
    if method != 1 {
        let [a, b] = [(); 2].map(|()| rng.below(places));
        children = order_crossover([&children[0], &children[1]], a.min(b)..a.max(b) + 1);
    }
    if method != 0 {
        let [a, b] = &children;
        children = if rng.below(2) == 0 && places > 1 {
            // The paper: "Larger than 1 and not exceeding n".
            point_exchange([a, b], 2 + rng.below(places - 1))
        } else {
            arithmetic(problem, [a, b], rng)
        };
    }
    children
}

/// Order crossover: the positions between the crossover points are kept; the others take the remaining contours in the
/// order of the other code. A contour keeps its feature point.
pub(super) fn order_crossover(pair: [&Code; 2], kept: std::ops::Range<usize>) -> [Code; 2] {
    [0, 1].map(|side| {
        let (own, other) = (pair[side], pair[1 - side]);
        let mut held = vec![false; own.order.iter().map(|&i| i as usize + 1).max().unwrap_or(0)];
        own.order[kept.clone()].iter().for_each(|&i| held[i as usize] = true);
        let mut rest = other.order.iter().zip(&other.points).filter(|(i, _)| !held[**i as usize]);
        let mut child = own.clone();
        for place in (0..own.order.len()).filter(|p| !kept.contains(p)) {
            if let Some((&item, &point)) = rest.next() {
                (child.order[place], child.points[place]) = (item, point);
            }
        }
        child
    })
}

/// Contours that both codes have among their first `left` positions exchange their feature points.
pub(super) fn point_exchange(pair: [&Code; 2], left: usize) -> [Code; 2] {
    let contours = pair[0].order.iter().map(|&i| i as usize + 1).max().unwrap_or(0);
    let first = |c: &Code| Code { order: c.order[..left].to_vec(), points: c.points[..left].to_vec() };
    let points = pair.map(|c| first(c).point_of(contours));
    [0, 1].map(|side| {
        let mut child = pair[side].clone();
        for (item, point) in child.order.iter().zip(&mut child.points).take(left) {
            if let Some(other) = points[1 - side][*item as usize] {
                *point = other;
            }
        }
        child
    })
}

/// Eq. (3): the two feature points of each contour are blended with one random weight. The weighted mean of two indices
/// lies between them, so it is valid in both codes.
fn arithmetic(problem: &Problem, pair: [&Code; 2], rng: &mut Rng) -> [Code; 2] {
    let mut points = pair.map(|c| c.point_of(problem.items.len()));
    let [a, b] = &mut points;
    for (x, y) in a.iter_mut().zip(b) {
        if let (Some(x), Some(y)) = (x, y)
            && x != y
        {
            (*x, *y) = blend(*x, *y, rng.uniform());
        }
    }
    [0, 1].map(|side| {
        let mut child = pair[side].clone();
        for (item, point) in child.order.iter().zip(&mut child.points) {
            *point = points[side][*item as usize].unwrap_or(*point);
        }
        child
    })
}

/// Eq. (3) for two feature points.
pub(super) fn blend(x: u32, y: u32, epsilon: f64) -> (u32, u32) {
    let mix = |x: u32, y: u32| (epsilon * f64::from(x) + (1.0 - epsilon) * f64::from(y)).round();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between two indices")]
    (mix(x, y) as u32, mix(y, x) as u32)
}

/// Mutates a code by one of the three methods of the paper, drawn at random. The two places that are exchanged may be the same;
/// then nothing changes.
pub(super) fn mutate(problem: &Problem, code: &mut Code, rng: &mut Rng) {
    let method = rng.below(3);
    let places = code.order.len();
    if method != 1 {
        swap(code, [(); 2].map(|()| rng.below(places)));
    }
    if method != 0 {
        let place = rng.below(places);
        let points = count(problem, code.order[place]);
        if points > 1 {
            // A different point from the current one.
            code.points[place] = (code.points[place] + 1 + below(points - 1, rng)) % points;
        }
    }
}

/// Two contours exchange their positions and keep their points.
pub(super) fn swap(code: &mut Code, [a, b]: [usize; 2]) {
    code.order.swap(a, b);
    code.points.swap(a, b);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::papers::test_sheet::sheet;
    use crate::solve::rng::seeded;

    /// As printed in the paper: contours and points are counted from 1.
    fn code(order: [u32; 5], points: [u32; 5]) -> Code {
        Code { order: order.map(|i| i - 1).to_vec(), points: points.map(|p| p - 1).to_vec() }
    }

    fn parents() -> [Code; 2] {
        [code([1, 4, 2, 5, 3], [6, 1, 3, 2, 4]), code([4, 2, 5, 3, 1], [3, 2, 7, 5, 8])]
    }

    #[test]
    fn figure_3_order_crossover() {
        let [a, b] = parents();
        let children = order_crossover([&a, &b], 1..3);
        let wanted = [code([5, 4, 2, 3, 1], [7, 1, 3, 5, 8]), code([1, 2, 5, 4, 3], [6, 2, 7, 1, 4])];
        assert_eq!(children, wanted);
    }

    #[test]
    fn figure_4_exchange_of_starting_points() {
        let [a, b] = parents();
        let children = point_exchange([&a, &b], 4);
        let wanted = [code([1, 4, 2, 5, 3], [6, 3, 2, 7, 4]), code([4, 2, 5, 3, 1], [1, 3, 2, 5, 8])];
        assert_eq!(children, wanted);
    }

    #[test]
    fn figure_5_mutation_of_the_order() {
        let [mut a, _] = parents();
        swap(&mut a, [0, 2]);
        assert_eq!(a, code([2, 4, 1, 5, 3], [3, 1, 6, 2, 4]));
    }

    #[test]
    fn a_mutated_starting_point_is_another_one_of_its_contour() {
        let problem = sheet(&[&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]], None, "length");
        let drawn = (0..300).map(|seed| {
            let mut code = Code { order: vec![0], points: vec![1] };
            mutate(&problem, &mut code, &mut seeded(seed));
            code.points[0]
        });
        let mut drawn: Vec<u32> = drawn.collect();
        drawn.sort_unstable();
        // The point stays where only the order mutates: in a third of the cases. Both others are as likely as that.
        let count = |point| drawn.iter().filter(|p| **p == point).count();
        assert!([0, 1, 2].into_iter().all(|point| (70..130).contains(&count(point))), "{drawn:?}");
    }

    #[test]
    fn equation_3_by_hand() {
        assert_eq!(blend(2, 7, 0.25), (6, 3));
        assert_eq!(blend(2, 7, 0.0), (7, 2));
        // 0.5 * 3 + 0.5 * 6 = 4.5 both ways, which is rounded away from zero.
        assert_eq!(blend(3, 6, 0.5), (5, 5));
    }
}
