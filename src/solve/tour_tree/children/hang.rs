//! The other start: everything hangs from what is nearest to it.

use super::allowed::may_shift;
use super::bridges::Bridge;
use super::moves::{is_left, perform};
use super::shift::Ground;
use super::shift::Shift;
use super::shift::Spot;
use super::tree::Tree;
use super::tree::leaving;
use crate::order::{real, sort_by};

/// Puts a stop on a route of its own, at the nearest item that it may hang from. Done to all, that is the other end of
/// what routes may be, from which the local search makes rings again where those are shorter.
pub(super) fn hang(g: Ground, tree: &mut Tree, stop: u32) {
    if g.space.places(stop).is_empty() {
        return;
    }
    let spots = g.near.of_item(stop).iter().zip(0..).map(|(&host, k)| (host, g.bridges.of(stop, k)));
    let mut spots: Vec<(f64, u32, Bridge)> = spots
        .filter(|s| is_left(g.space, s.0) && !g.space.two_ends(stop))
        .map(|(host, bridge)| (bridge.seconds + leaving(g.space, host), host, bridge))
        .collect();
    sort_by(&mut spots, |s| [real(s.0), s.1.into(), 0]);
    for (_, host, bridge) in spots {
        tree.priced += 1;
        let spot = Spot::Child(host, bridge.to);
        let shift =
            Shift { first: stop, last: stop, turned: false, spot, at: Some(bridge.from), enter: stop };
        if !tree.closing.holds(tree.head(stop), stop, host) && may_shift(g, tree, shift) {
            perform(g, tree, shift, |_| ());
            break;
        }
    }
}
