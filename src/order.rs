//! Sorting, once for the whole crate.
//!
//! Every use of std's sort on another type is 3 to 7 KB of wasm of its own; thirty of them were a fifth of the file.
//! Here all keys become numbers of one type, which one sort puts in order; equal keys keep their order.

/// Up to three numbers to sort by, the first first; see [`real`] for floats.
pub(crate) type Key = [u64; 3];

/// Sorts by key, stable.
pub(crate) fn sort_by<T>(items: &mut Vec<T>, key: impl Fn(&T) -> Key) {
    if items.len() < 2 {
        return;
    }
    let mut keys: Vec<(Key, usize)> = items.iter().enumerate().map(|(i, item)| (key(item), i)).collect();
    sort_keys(&mut keys);
    let mut from: Vec<Option<T>> = items.drain(..).map(Some).collect();
    items.extend(keys.iter().filter_map(|&(_, i)| from[i].take()));
}

/// The one sort. Never inlined, so that there is one.
#[inline(never)]
fn sort_keys(keys: &mut [(Key, usize)]) {
    keys.sort_unstable();
}

/// A float as a number of the same order (that of [`f64::total_cmp`]).
pub(crate) fn real(x: f64) -> u64 {
    let bits = x.to_bits();
    // Negative ones run the other way and come first.
    if bits >> 63 == 1 { !bits } else { bits | 1 << 63 }
}

/// A signed number as an unsigned one of the same order.
pub(crate) fn whole(x: i64) -> u64 {
    x.cast_unsigned() ^ 1 << 63
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_std_sorts() {
        let mut list: Vec<(f64, usize)> =
            [3.0, -0.0, 0.0, -7.5, f64::INFINITY, 1e-300, 3.0, -7.5].into_iter().zip(0..).collect();
        let mut wanted = list.clone();
        wanted.sort_by(|a, b| a.0.total_cmp(&b.0));
        sort_by(&mut list, |x| [real(x.0), 0, 0]);
        assert_eq!(list, wanted);
        sort_by(&mut list, |x| [x.1 as u64 % 3, u64::MAX - x.1 as u64, 0]);
        assert_eq!(list.iter().map(|x| x.1).collect::<Vec<_>>(), [6, 3, 0, 7, 4, 1, 5, 2]);
        let mut signed = vec![4, -3, i64::MAX, 0, i64::MIN];
        sort_by(&mut signed, |&x| [0, whole(x), 0]);
        assert_eq!(signed, [i64::MIN, -3, 0, 4, i64::MAX]);
    }
}
