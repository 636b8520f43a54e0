//! Part by part, an item that waits for one of another part waits for all of that part, and so does all of its own part.

use super::ids::ItemId;
use crate::order::sort_by;
use crate::sheet::Sheet;

/// The pairs of contours between parts that these pairs ask for besides themselves, where each part is cut in one go within its
/// rank: a path that keeps all of them can finish any part that it has begun. Between ranks there is nothing to ask for.
pub(super) fn between_parts(
    sheet: &Sheet,
    ranks: &[u32],
    pairs: &[(ItemId, ItemId)],
) -> Vec<(ItemId, ItemId)> {
    let of = sheet.part_of();
    let rank = |item: ItemId| ranks.get(item as usize).copied();
    // What lies in a part and has a rank; without a part, the item alone.
    let members = |part: Option<u32>, item: ItemId| -> Vec<ItemId> {
        let Some(part) = part else { return vec![item] };
        let within = |c: ItemId| rank(c) == rank(item) && sheet.parts_around(&of, c).any(|p| p == part);
        (0..)
            .zip(&sheet.contours)
            .filter(|(c, known)| known.is_processed() && within(*c))
            .map(|(c, _)| c)
            .collect()
    };
    let mut all = Vec::new();
    let mut known = Vec::new();
    for &(first, then) in pairs.iter().filter(|(a, b)| rank(*a) == rank(*b)) {
        let [before, after] = [(first, then), (then, first)].map(|(a, b)| sheet.part_without(&of, a, b));
        let asked = (before.ok_or(first), after.ok_or(then), rank(then));
        if before.is_none() && after.is_none() || known.contains(&asked) {
            continue;
        }
        known.push(asked);
        let ended = members(before, first);
        // The others come before these by nesting.
        let is_last = |c: &&ItemId| {
            let around = sheet.contours.get(**c as usize).and_then(|c| c.inside);
            around.is_none_or(|around| !ended.contains(&around))
        };
        let ended_last: Vec<ItemId> = ended.iter().filter(is_last).copied().collect();
        for then in members(after, then) {
            all.extend(ended_last.iter().map(|&last| (last, then)));
        }
    }
    sort_by(&mut all, |&(a, b)| [a.into(), b.into(), 0]);
    all.dedup();
    all
}
