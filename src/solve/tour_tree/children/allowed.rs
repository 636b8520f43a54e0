//! Whether ranks, precedence and nesting allow a move.

use super::chain_move::ChainMove;
use super::chain_move::Context;
use super::chain_move::Target;
use super::swap_with_host::swap_with_host;
use super::tree::Tree;

/// Whether what hangs from an item is finished in an order that precedence allows.
pub(super) fn keeps_order(g: Context, tree: &Tree, item: u32) -> bool {
    let after = |i: u32| tree.finish_order.label(i);
    !g.space.precedence.any
        || !tree
            .finish_order
            .stretch(tree.head(item), item)
            .any(|i| g.space.precedence.waits(i, |o| after(o) < after(i)))
}

/// Whether ranks, precedence and nesting allow a chain move.
pub(super) fn may_move(g: Context, tree: &mut Tree, m: ChainMove) -> bool {
    let ChainMove { first, last, reversed, target, at, enter } = m;
    let mark = tree.changes();
    if let Some(at) = at.filter(|_| enter != first) {
        let fits = !g.space.precedence.any || {
            swap_with_host(g.space, tree, enter, at);
            keeps_order(g, tree, enter)
        };
        tree.undo(g.space, mark);
        if !fits {
            return false;
        }
    }
    let to = match target {
        Target::After(to) => to,
        Target::Child(host, at) => tree.open(g.space, host, at),
    };
    let may = ranks_allow(g, tree, first, last, to)
        && order_allows(g, tree, first, last, to)
        && tree.areas_hold(g.space, first, last, to)
        && (!reversed || may_reverse(g, tree, first, last));
    tree.undo(g.space, mark);
    may
}

/// Whether ranks do not fall along the root route, and every route has the rank of the item it hangs from.
fn ranks_allow(g: Context, tree: &Tree, first: u32, last: u32, to: u32) -> bool {
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

/// Whether at its new position the chain is finished before everything that waits for it and after everything it waits for.
fn order_allows(g: Context, tree: &Tree, first: u32, last: u32, to: u32) -> bool {
    let (precedence, finish_order, head) = (&g.space.precedence, &tree.finish_order, tree.head(first));
    if !precedence.any {
        return true;
    }
    let mut behind = tree.finished_before(to);
    if finish_order.holds(head, last, behind) {
        behind = finish_order.previous(head);
    }
    let sooner =
        |i: u32| !finish_order.holds(head, last, i) && finish_order.label(i) <= finish_order.label(behind);
    let later =
        |i: u32| !finish_order.holds(head, last, i) && finish_order.label(i) > finish_order.label(behind);
    !finish_order
        .stretch(head, last)
        .any(|i| precedence.waits(i, sooner) || precedence.before(i).iter().any(|&o| later(o)))
}

/// Whether a stretch may be reversed: nothing in it waits for anything else in it, and no route hangs from a pierce group in
/// it, because it hangs from the path that would be reversed.
pub(super) fn may_reverse(g: Context, tree: &Tree, first: u32, last: u32) -> bool {
    let label = |i: u32| tree.finish_order.label(i);
    if g.space.rank[first as usize] != g.space.rank[last as usize] {
        return false;
    }
    let stops = || std::iter::successors(Some(first), |&stop| (stop != last).then(|| tree.next(stop)));
    if g.space.leave_places.any() && stops().any(|stop| tree.keeps_path(g.space, stop)) {
        return false;
    }
    !g.space.precedence.any
        || !stops().any(|stop| {
            let later = label(stop) + 1..=label(last);
            let mut block = tree.finish_order.stretch(tree.head(stop), stop);
            block.any(|i| g.space.precedence.waits(i, |o| later.contains(&label(o))))
        })
}
