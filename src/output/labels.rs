//! Places for the numbers beside the entries of a picture, so that none covers another.

use crate::geometry::{Aabb, DVec2};

/// Width of a digit by the height of the letters: that of DejaVu Sans, the widest of the usual fonts without serifs, and a little room.
const DIGIT: f64 = 0.7;
/// Height of a digit by the height of the letters.
const CAP: f64 = 0.75;

/// The lower left corner of each number, from 1 on, beside its entry: at its upper right, upper left, lower right or lower left, whatever is free first and
/// within the picture. A number for which nothing is free has none; the first ones go before. `gap` is the distance to the entry along both axes, `height`
/// that of the letters.
pub(super) fn numbers(entries: &[DVec2], picture: &Aabb, gap: f64, height: f64) -> Vec<Option<DVec2>> {
    let mut taken: Vec<Aabb> = Vec::new();
    let place = |(k, &entry): (usize, &DVec2)| {
        let digits = (k + 1).ilog10() + 1;
        let size = DVec2::new(f64::from(digits) * DIGIT, CAP) * height;
        let (left, below) = (entry.x - gap - size.x, entry.y - gap - size.y);
        let (right, above) = (entry.x + gap, entry.y + gap);
        let corners = [(right, above), (left, above), (right, below), (left, below)];
        let rooms = corners.map(DVec2::from).map(|corner| Aabb::of(corner).with(corner + size));
        let is_free =
            |room: &Aabb| picture.contains_box(room) && !taken.iter().any(|other| other.overlaps(room));
        let room = rooms.into_iter().find(is_free)?;
        taken.push(room);
        Some(room.min)
    };
    entries.iter().enumerate().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_go_around_their_entry_and_are_left_out_where_nothing_is_free() {
        let entry = DVec2::new(100.0, 50.0);
        let far = DVec2::new(200.0, 50.0);
        let picture = Aabb::of(DVec2::ZERO).with(DVec2::new(210.0, 100.0));
        // Five at one place, between two that are alone, of which the first has no room at its right.
        let places = [far, entry, entry, entry, entry, entry, DVec2::ZERO];
        let placed = numbers(&places, &picture, 4.0, 10.0);
        let at = |x, y| Some(DVec2::new(x, y));
        assert_eq!(
            placed,
            [
                at(189.0, 54.0),
                at(104.0, 54.0),
                at(89.0, 54.0),
                at(104.0, 38.5),
                at(89.0, 38.5),
                None,
                at(4.0, 4.0)
            ]
        );
    }

    #[test]
    fn of_a_dense_grid_no_two_overlap_and_the_first_one_is_there() {
        let grid: Vec<DVec2> =
            (0..400).map(|k| DVec2::new(f64::from(k % 20), f64::from(k / 20)) * 7.0).collect();
        let picture = Aabb::of(DVec2::ZERO).with(DVec2::splat(140.0));
        let placed = numbers(&grid, &picture, 1.0, 5.0);
        let boxes: Vec<(Aabb, usize)> = placed
            .iter()
            .enumerate()
            .filter_map(|(k, p)| {
                let digits = (k + 1).to_string().len();
                p.map(|p| (Aabb::of(p).with(p + DVec2::new(3.5 * digits as f64, 3.75)), k))
            })
            .collect();
        assert!(placed[0].is_some());
        assert!((120..400).contains(&boxes.len()), "{}", boxes.len());
        for (a, i) in &boxes {
            assert!(boxes.iter().all(|(b, j)| i == j || !a.grown(-1e-9).overlaps(b)));
        }
    }
}
