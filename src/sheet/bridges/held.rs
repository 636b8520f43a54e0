//! In which order the machine cuts the bridges of one piece apart, where it minds what drops and what tips.
//!
//! What has dropped or tipped cannot be cut any more. So every cut through a bridge is made in a piece that stays on the slats: connected parts
//! have one among them that stays by itself, and a part that does not stay is cut off from that one outwards in. The bridge by which it hangs on the way
//! to the nearest part that stays is its last one: it is cut on the side of the part when all else along the outline of the part is cut, and on its
//! other side after that. Then a part is free with the last cut along its outline, and by its own size.

use super::super::model::{BridgeCut, Bridged, Strip};
use crate::geometry::Path;
use crate::machine::{Bridges, Falls, Profile, Tips};
use rustc_hash::{FxHashMap, FxHashSet};

/// What drops and what tips, if bridges are cut later beside it.
pub(super) fn tips<'m>(bridges: &Bridges, machine: &'m Profile) -> Option<&'m Tips> {
    machine.levers.tips.as_ref().filter(|_| bridges.cut_later)
}

/// Whether a part stays on the slats once it is cut off.
pub(super) fn stays(tips: &Tips, outline: &Path) -> bool {
    tips.falls_within(outline) == Falls::Stays
}

/// The parts that do not stay by themselves, each with the strip that holds it until last, as its place in the list. Parts that no strips connect
/// to one that stays are not among them.
pub(super) fn holders(tips: &Tips, outlines: &[(u32, Path)], strips: &[Strip]) -> Vec<(u32, usize)> {
    let mut of: FxHashMap<u32, Vec<(usize, u32)>> = FxHashMap::default();
    for (k, [one, other]) in strips.iter().map(|s| s.contours).enumerate() {
        of.entry(one).or_default().push((k, other));
        of.entry(other).or_default().push((k, one));
    }
    let mut reached: Vec<u32> = outlines.iter().filter(|o| stays(tips, &o.1)).map(|o| o.0).collect();
    let mut seen: FxHashSet<u32> = reached.iter().copied().collect();
    let mut holders = Vec::new();
    let mut next = 0;
    while let Some(part) = reached.get(next).copied() {
        next += 1;
        for &(k, far) in of.get(&part).into_iter().flatten() {
            if seen.insert(far) {
                reached.push(far);
                holders.push((far, k));
            }
        }
    }
    holders
}

/// Pairs of cuts through the bridges of one piece, of which the first comes before the second.
pub(super) fn in_order(group: &Bridged) -> Vec<(u32, u32)> {
    let last: FxHashMap<u32, usize> = group.holders.iter().copied().collect();
    let is_last = |cut: &&BridgeCut| last.get(&cut.outline) == Some(&cut.strip);
    let lasts = group.cuts.iter().filter(is_last).map(|cut| (cut.outline, cut));
    let lasts: FxHashMap<u32, &BridgeCut> = lasts.collect();
    let mut pairs = Vec::new();
    for cut in &group.cuts {
        // Before the last cut along the same outline, and after it if it is across the other end of its strip.
        if let Some(last) = lasts.get(&cut.outline).filter(|last| last.contour != cut.contour) {
            pairs.push((cut.contour, last.contour));
        }
        let strip = group.strips.get(cut.strip).map_or([cut.outline; 2], |s| s.contours);
        let far = strip.into_iter().find(|part| *part != cut.outline).and_then(|part| lasts.get(&part));
        if let Some(last) = far.filter(|last| last.strip == cut.strip) {
            pairs.push((last.contour, cut.contour));
        }
    }
    pairs
}
