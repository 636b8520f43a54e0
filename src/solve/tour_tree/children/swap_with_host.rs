//! A stop of a child route changes places with its host, the item that the route hangs from.
//!
//! Routes and contours form a tree, and only the end from which the head comes makes one contour the host and the other a
//! stop. The route remains the same ring, entered from the other contour. So the host can go into its own child route, at
//! the place where that was attached, and the stop takes the host's place, at no cost except for the legs to and from it.
//! Without this move a subtree could be attached elsewhere only by its current host.

use super::super::space::Space;
use super::tree::Tree;

/// Puts `stop`, entered at place `at`, where the host of its route is, and the host into the route.
pub(super) fn swap_with_host(space: &Space, tree: &mut Tree, stop: u32, at: u32) {
    let anchor = tree.route(stop);
    let (host, hung, met) = (tree.item(anchor), tree.at(anchor), tree.at(stop));
    // The rest of the ring: before the stop and after it.
    let before = (tree.next(anchor), tree.previous(stop));
    let after = (tree.next(stop), tree.previous(anchor));
    tree.move_chain(stop, stop, host);
    tree.place(space, stop, at);
    let reversed = tree.open(space, stop, met);
    tree.move_chain(host, host, reversed);
    if after.0 != anchor {
        tree.move_chain(after.0, after.1, reversed);
    }
    if before.0 != stop {
        tree.move_chain(before.0, before.1, host);
    }
    tree.place(space, host, hung);
}
