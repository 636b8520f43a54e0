//! 2-opt within a route.

use super::super::queue::Queue;
use super::allowed::may_turn;
use super::shift::Ground;
use super::tree::Tree;
use crate::solve::epsilon::EPSILON;

/// 2-opt: the stretch between a touch and a near one of its route reversed, so that one leaves for the other's exit, or
/// is entered from the other's entry.
pub(super) fn turn(g: Ground, tree: &mut Tree, queue: &mut Queue, touch: u32) -> Option<f64> {
    for ahead in [true, false] {
        let pair = |t: u32| if ahead { (t, tree.next(t)) } else { (tree.previous(t), t) };
        let one = pair(touch);
        let given = tree.edge(g.space, one.0, one.1);
        for &b in g.near.of_place(g.space, tree.item(touch), tree.at(touch)) {
            for c in 0..=tree.kids(b).len() {
                let c = *tree.kids(b).get(c).unwrap_or(&b);
                if tree.route(c) != tree.route(touch)
                    || g.space.travel.seconds(tree.exit(touch), tree.entry(c)) >= given
                {
                    continue;
                }
                let other = pair(c);
                let earlier = tree.is_anchor(one.0)
                    || (!tree.is_anchor(other.0) && tree.closing.label(one.0) < tree.closing.label(other.0));
                let ((a, first), (last, d)) = if earlier { (one, other) } else { (other, one) };
                if a == last || first == last {
                    continue;
                }
                let taken = g.space.travel.seconds(tree.exit(a), tree.exit(last))
                    + tree.way(g.space, tree.entry(first), d, tree.entry(d));
                let gain = tree.edge(g.space, a, first) + tree.edge(g.space, last, d)
                    - taken
                    - tree.turning(g.space, first, last);
                if gain > EPSILON && may_turn(g, tree, first, last) {
                    tree.turn(g.space, first, last);
                    for t in [a, first, last, d] {
                        queue.push(t);
                    }
                    tree.priced += 1;
                    return Some(gain);
                }
            }
        }
        tree.priced += 1;
    }
    None
}
