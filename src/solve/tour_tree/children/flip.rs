//! A stop of a child route changes parts with the item the route hangs from.
//!
//! Routes and contours make a tree, and which end of it the head comes from is all that tells a stop from an anchor: the
//! route stays the ring it was, entered now from the other contour. So a host can go into the route that hangs from it,
//! at the place where that hung, and the stop takes its place above, at no cost but the ways above. Without this move a
//! part of the tree could be hung elsewhere only by the contour it hangs from now.

use super::super::space::Space;
use super::tree::Tree;

/// Puts `stop` in the place of the item its route hangs from, entered at place `at`.
pub(super) fn flip(space: &Space, tree: &mut Tree, stop: u32, at: u32) {
    let anchor = tree.route(stop);
    let (host, hung, met) = (tree.item(anchor), tree.at(anchor), tree.at(stop));
    // The rest of the ring: before the stop and after it.
    let before = (tree.next(anchor), tree.previous(stop));
    let after = (tree.next(stop), tree.previous(anchor));
    tree.shift(stop, stop, host);
    tree.place(space, stop, at);
    let turned = tree.open(space, stop, met);
    tree.shift(host, host, turned);
    if after.0 != anchor {
        tree.shift(after.0, after.1, turned);
    }
    if before.0 != stop {
        tree.shift(before.0, before.1, host);
    }
    tree.place(space, host, hung);
}
