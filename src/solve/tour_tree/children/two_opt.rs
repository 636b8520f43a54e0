//! 2-opt within a route.

use super::super::queue::Queue;
use super::allowed::may_reverse;
use super::chain_move::Context;
use super::tree::Tree;
use crate::solve::epsilon::EPSILON;

/// Reverses the stretch between a touch and a near touch of its route, so that their exits or their entries become
/// neighbours.
pub(super) fn two_opt(g: Context, tree: &mut Tree, queue: &mut Queue, touch: u32) -> Option<f64> {
    for ahead in [true, false] {
        let pair = |t: u32| if ahead { (t, tree.next(t)) } else { (tree.previous(t), t) };
        let one = pair(touch);
        let given = tree.edge(g.space, one.0, one.1);
        // Lists by place are those of places of entry.
        let near = match tree.leave_place(g.space, touch) {
            Some(_) => g.near.of_item(tree.item(touch)),
            None => g.near.of_place(g.space, tree.item(touch), tree.at(touch)),
        };
        for &b in near {
            for c in 0..=tree.anchors(b).len() {
                let c = *tree.anchors(b).get(c).unwrap_or(&b);
                if tree.route(c) != tree.route(touch)
                    || g.space.travel.seconds(tree.exit(touch), tree.entry(c)) >= given
                {
                    continue;
                }
                let other = pair(c);
                let earlier = tree.is_anchor(one.0)
                    || (!tree.is_anchor(other.0)
                        && tree.finish_order.label(one.0) < tree.finish_order.label(other.0));
                let ((a, first), (last, d)) = if earlier { (one, other) } else { (other, one) };
                if a == last || first == last {
                    continue;
                }
                let (enter, leave) = tree.ends(g.space, (first, last), true);
                let taken = g.space.travel.seconds(tree.exit(a), enter)
                    + tree.leg_seconds(g.space, leave, d, tree.entry(d));
                let gain = tree.edge(g.space, a, first) + tree.edge(g.space, last, d)
                    - taken
                    - tree.reversal_cost(g.space, first, last);
                if gain > EPSILON && may_reverse(g, tree, first, last) {
                    tree.reverse_stretch(g.space, first, last);
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
