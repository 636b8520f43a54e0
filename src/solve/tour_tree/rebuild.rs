//! Ruin and recreate: some items are taken out together and put back one by one, each where it costs least.
//!
//! A kick for tours that exchanging stretches does not loosen: with precedence all over an exchange is mostly
//! forbidden, and in small problems the same few are tried again and again. Taken out is a stretch, or items near to
//! one another, or any; put back in random order, best of all allowed places, of which one in [`BLINK`] is
//! overlooked. After Christiaens & Vanden Berghe, Transportation Science 54 (2020), and Smith & Imeson, Computers &
//! Operations Research 87 (2017).

use super::super::dice::Dice;
use super::improve::Queue;
use super::neighbours::Neighbours;
use super::space::Space;
use super::tour::Tour;

/// One place in so many is overlooked: 1 % as Christiaens & Vanden Berghe have it.
const BLINK: usize = 100;
/// Items taken out at most. Numbers are drawn evenly on a log scale, so most are small; 10 never found the optimum of
/// four sheet-cutting instances of 20 contours, 24 did at once, for every seed.
const MOST: usize = 40;

/// Takes out up to [`MOST`] items and puts them back. Touched items are queued. False when precedence left an item no
/// place: the journal then takes the tour back.
pub(super) fn rebuild(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, dice: &mut Dice) -> bool {
    let mut gone = chosen(tour, near, dice);
    let mut out = vec![false; tour.space.home as usize + 1];
    for &item in &gone {
        out[item as usize] = true;
        for touched in [item, tour.previous(item), tour.next(item)] {
            queue.push(touched);
        }
    }
    let mut order: Vec<u32> = (0..=tour.last()).map(|p| tour.item(p)).filter(|&i| !out[i as usize]).collect();
    for k in (1..gone.len()).rev() {
        gone.swap(k, dice.below(k + 1));
    }
    for item in gone {
        let Some((place, at)) = cheapest(tour, &order, &out, dice, item) else { return false };
        tour.enter(item, at);
        queue.push(order[place - 1]);
        queue.push(order.get(place).copied().unwrap_or(tour.space.home));
        order.insert(place, item);
        out[item as usize] = false;
    }
    tour.reorder(order);
    true
}

/// Items to be taken out.
fn chosen(tour: &Tour, near: &Neighbours, dice: &mut Dice) -> Vec<u32> {
    let count = dice.length(MOST.min(tour.last()));
    let mut gone = Vec::with_capacity(count);
    match dice.below(3) {
        0 => {
            let from = 1 + dice.below(tour.last() + 1 - count);
            gone.extend((from..from + count).map(|p| tour.item(p)));
        }
        way => {
            gone.push(tour.item(1 + dice.below(tour.last())));
            // Near ones may all be out already: then fewer go.
            for _ in 0..4 * count {
                if gone.len() == count {
                    break;
                }
                let next = if way == 1 {
                    let list = near.of_item(gone[dice.below(gone.len())]);
                    list[dice.below(list.len())]
                } else {
                    tour.item(1 + dice.below(tour.last()))
                };
                if next != tour.space.home && !gone.contains(&next) {
                    gone.push(next);
                }
            }
        }
    }
    gone
}

/// Where in `order` an item that is out costs least, and where it is entered there.
fn cheapest(
    tour: &mut Tour,
    order: &[u32],
    out: &[bool],
    dice: &mut Dice,
    item: u32,
) -> Option<(usize, u32)> {
    let [early, late] = if tour.free { [Vec::new(), Vec::new()] } else { bounds(&tour.space, out, item) };
    let rank = |i: u32| tour.space.rank[i as usize];
    let mut best: Option<(usize, u32)> = None;
    let mut least = f64::INFINITY;
    let mut priced = 0;
    for place in 1..=order.len() {
        let (from, to) = (order[place - 1], order.get(place).copied().unwrap_or(tour.space.home));
        if late.contains(&from) {
            break;
        }
        if early.contains(&from) {
            (best, least) = (None, f64::INFINITY);
        }
        let ranked =
            (place == 1 || rank(from) <= rank(item)) && (place == order.len() || rank(item) <= rank(to));
        if !ranked {
            continue;
        }
        priced += 1;
        let gap = tour.gap(from, to);
        let given = tour.edge(from, to);
        let on = gap.to.map_or(0.0, |q| tour.space.at_least(q, item, true));
        if tour.space.at_least(gap.from, item, false) + on - given >= least || dice.below(BLINK) == 0 {
            continue;
        }
        let (at, seconds) = tour.space.best_entry(item, gap, least + given);
        if seconds - given < least {
            least = seconds - given;
            best = Some((place, at));
        }
    }
    tour.priced += priced;
    best
}

/// The items in place that an item has to follow, and those that have to follow it: next in line, or behind items
/// that are out themselves.
fn bounds(space: &Space, out: &[bool], item: u32) -> [Vec<u32>; 2] {
    [false, true].map(|later| {
        let mut found = Vec::new();
        let mut open = vec![item];
        while let Some(next) = open.pop() {
            let p = &space.precedence;
            for &other in if later { p.after(next) } else { p.before(next) } {
                if out[other as usize] { open.push(other) } else { found.push(other) }
            }
        }
        found
    })
}
