//! Regular grids against ways laid by hand, and sheets without rows.

use crate::geometry::{DVec2, Path, Segment};
use crate::machine;
use crate::problem::{Item, Node, Problem};
use crate::solve::methods;

/// Items in a row, and rows.
const SIDE: u32 = 40;

/// Rectangles around centres, entered anywhere.
fn rectangles(centers: &[DVec2], half: DVec2) -> Problem {
    let (mut items, mut nodes) = (Vec::new(), Vec::new());
    for (item, &center) in (0..).zip(centers) {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let corner = |k: usize| center + half * DVec2::from(corners[k % 4]);
        let sides = (0..4).map(|k| Segment::line(corner(k), corner(k + 1))).collect();
        let track = Some(Path::new(sides, true));
        nodes.push(Node { item, entry: corner(0), exit: corner(0), along: 0.0, reversed: false, twin: item });
        items.push(Item { nodes: item..item + 1, track, ..Item::default() });
    }
    Problem {
        items,
        nodes,
        home: DVec2::ZERO,
        closed: true,
        ..Problem::empty(machine::preset("length").unwrap())
    }
}

/// Up and down two columns at a time, from one to the other at every row, by the sides that face each other; mm. Every
/// second crossing runs back, unless columns are staggered.
fn by_hand(centers: impl Fn(u32, u32) -> DVec2, half: f64, staggered: bool) -> f64 {
    let mut way = vec![DVec2::ZERO];
    for pair in 0..SIDE / 2 {
        for k in 0..SIDE {
            let row = if pair % 2 == 0 { k } else { SIDE - 1 - k };
            let left = centers(2 * pair, row) + DVec2::new(half, 0.0);
            let right = centers(2 * pair + 1, row) - DVec2::new(half, 0.0);
            let ahead = if staggered { pair % 2 == 0 } else { row % 2 == 0 };
            way.extend(if ahead { [left, right] } else { [right, left] });
        }
    }
    way.push(DVec2::ZERO);
    way.windows(2).map(|w| w[0].distance(w[1])).sum()
}

/// Ways by hand are 10,568 and 12,636 mm long. From nearest next alone, the first local search of grids like these, of slots and of
/// round holes, came to 15,418 and 12,644 mm.
#[test]
fn regular_grids_are_planned_no_worse_than_row_by_row() {
    for (pitch, stagger, half) in [((25.0, 10.0), 0.0, (12.0, 2.0)), ((8.66, 10.0), 5.0, (1.5, 1.5))] {
        let (pitch, half) = (DVec2::from(pitch), DVec2::from(half));
        let at = |column: u32, row: u32| {
            let shift = DVec2::new(0.0, stagger * f64::from(column % 2));
            DVec2::new(20.0, 10.0) + shift + pitch * DVec2::new(f64::from(column), f64::from(row))
        };
        let centers: Vec<DVec2> = (0..SIDE * SIDE).map(|k| at(k % SIDE, k / SIDE)).collect();
        let problem = rectangles(&centers, half);
        let mut search = methods()[0].start(&problem, 1, None);
        search.step(600_000);
        let (found, hand) = (search.best().cost, by_hand(at, half.x, stagger > 0.0));
        assert!(found <= 0.99 * hand, "{found} mm, by hand {hand} mm");
    }
}

#[test]
fn scattered_items_have_no_rows() {
    let at = |k: u32| DVec2::new(f64::from(k * 7919 % 10_007), f64::from(k * 104_729 % 9_973)) * 0.1;
    let centers: Vec<DVec2> = (0..SIDE * SIDE).map(at).collect();
    let problem = rectangles(&centers, DVec2::splat(0.2));
    let space = super::Space::new(&problem);
    let tour = space.snapshot(&crate::solve::greedy(&problem));
    assert!(super::Rows::new(&space, &tour).is_none());
}

/// What the first local search has gained is shown before its end.
#[test]
fn a_large_sheet_is_better_than_nearest_next_before_it_is_locally_best() {
    let at = |k: u32| DVec2::new(f64::from(k * 7919 % 10_007), f64::from(k * 104_729 % 9_973)) * 0.1;
    let centers: Vec<DVec2> = (0..SIDE * SIDE).map(at).collect();
    let problem = rectangles(&centers, DVec2::splat(0.2));
    let mut search = methods()[0].start(&problem, 1, None);
    let first = search.best().cost;
    search.step(100 * u64::from(SIDE * SIDE + 1) + 20_000);
    assert!(search.best().cost < first, "{first} mm and no less");
}
