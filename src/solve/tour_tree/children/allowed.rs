//! Whether ranks, precedence and nesting allow a move.

use super::flip::flip;
use super::shift::Ground;
use super::shift::Shift;
use super::shift::Spot;
use super::tree::Tree;

/// Whether nothing that hangs from an item waits for something that hangs from it and is finished later.
pub(super) fn in_order(g: Ground, tree: &Tree, item: u32) -> bool {
    let after = |i: u32| tree.closing.label(i);
    !g.space.precedence.any
        || !tree
            .closing
            .stretch(tree.head(item), item)
            .any(|i| g.space.precedence.waits(i, |o| after(o) < after(i)))
}

/// Whether a chain may go where a shift puts it.
pub(super) fn may_shift(g: Ground, tree: &mut Tree, shift: Shift) -> bool {
    let Shift { first, last, turned, spot, at, enter } = shift;
    let mark = tree.changes();
    if let Some(at) = at.filter(|_| enter != first) {
        let fits = !g.space.precedence.any || {
            flip(g.space, tree, enter, at);
            in_order(g, tree, enter)
        };
        tree.undo(g.space, mark);
        if !fits {
            return false;
        }
    }
    let to = match spot {
        Spot::Behind(to) => to,
        Spot::Child(host, at) => tree.open(g.space, host, at),
    };
    let may = ranks_allow(g, tree, first, last, to)
        && order_allows(g, tree, first, last, to)
        && (!turned || may_turn(g, tree, first, last));
    tree.undo(g.space, mark);
    may
}

/// Ranks do not fall along the root, and a route is of the rank of what it hangs from.
fn ranks_allow(g: Ground, tree: &Tree, first: u32, last: u32, to: u32) -> bool {
    let (rank, home) = (|t: u32| g.space.rank[t as usize], g.space.home);
    let own = rank(first);
    let fits = if tree.route(to) == home {
        let next = tree.next(to);
        (to == home || rank(to) <= own) && (next == home || own <= rank(next))
    } else {
        rank(tree.item(tree.route(to))) == own
    };
    fits && rank(last) == own
}

/// Nothing that waits for something in the chain is finished before it there, nor what it waits for after it.
fn order_allows(g: Ground, tree: &Tree, first: u32, last: u32, to: u32) -> bool {
    let (precedence, closing, head) = (&g.space.precedence, &tree.closing, tree.head(first));
    if !precedence.any {
        return true;
    }
    let mut behind = tree.finished_before(to);
    if closing.holds(head, last, behind) {
        behind = closing.previous(head);
    }
    let sooner = |i: u32| !closing.holds(head, last, i) && closing.label(i) <= closing.label(behind);
    let later = |i: u32| !closing.holds(head, last, i) && closing.label(i) > closing.label(behind);
    !closing
        .stretch(head, last)
        .any(|i| precedence.waits(i, sooner) || precedence.before(i).iter().any(|&o| later(o)))
}

/// Whether a stretch may be run the other way round: nothing in it waits for anything else in it.
pub(super) fn may_turn(g: Ground, tree: &Tree, first: u32, last: u32) -> bool {
    let label = |i: u32| tree.closing.label(i);
    if g.space.rank[first as usize] != g.space.rank[last as usize] {
        return false;
    }
    let stops = std::iter::successors(Some(first), |&stop| (stop != last).then(|| tree.next(stop)));
    !g.space.precedence.any
        || !stops.into_iter().any(|stop| {
            let later = label(stop) + 1..=label(last);
            let mut block = tree.closing.stretch(tree.head(stop), stop);
            block.any(|i| g.space.precedence.waits(i, |o| later.contains(&label(o))))
        })
}
