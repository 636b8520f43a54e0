//! The second start of the search over routes: every stop hangs from its nearest item.

use super::allowed::may_move;
use super::bridges::Bridge;
use super::chain_move::ChainMove;
use super::chain_move::Context;
use super::chain_move::Target;
use super::moves::{apply, may_be_left};
use super::tree::Tree;
use super::tree::leaving;
use crate::order::{real, sort_by};

/// Puts a stop on a route of its own, at the nearest item that it may hang from. After all stops, the local search joins
/// routes again where that is shorter.
pub(super) fn hang(g: Context, tree: &mut Tree, stop: u32) {
    if g.space.places(stop).is_empty() {
        return;
    }
    let spots = g.near.of_item(stop).iter().zip(0..).map(|(&host, k)| (host, g.bridges.of(stop, k)));
    let mut spots: Vec<(f64, u32, Bridge)> = spots
        .filter(|s| may_be_left(g.space, s.0) && !g.space.two_ends(stop))
        .filter_map(|(host, bridge)| {
            if !g.space.leave_places.is_group(host) {
                return Some((bridge.seconds + leaving(g.space, host), host, bridge));
            }
            let (to, from, seconds) = tree.hang_on(g.space, host, (stop, stop, stop))?;
            Some((seconds, host, Bridge { from: from?, to, seconds }))
        })
        .collect();
    sort_by(&mut spots, |s| [real(s.0), s.1.into(), 0]);
    for (_, host, bridge) in spots {
        tree.priced += 1;
        let target = Target::Child(host, bridge.to);
        let m = ChainMove {
            first: stop,
            last: stop,
            reversed: false,
            target,
            at: Some(bridge.from),
            enter: stop,
        };
        if !tree.finish_order.holds(tree.head(stop), stop, host) && may_move(g, tree, m) {
            apply(g, tree, m, |_| ());
            break;
        }
    }
}
