//! The elements of a contour by height, so that a point is tested only against those at its height.

use crate::geometry::{Path, Segment};

/// Contours with fewer elements are tested as a whole.
const MIN_ELEMENTS: usize = 24;
/// Entries per element on average: enough slabs to separate the elements, with memory linear in their number for any
/// height.
const ENTRIES_PER_ELEMENT: f64 = 6.0;

/// Slabs of equal height over a contour's box, each with the elements that reach into it.
pub(super) enum Slabs {
    /// A contour with few elements, which are all tested at any height.
    One,
    /// Slab `k` holds `items[offsets[k]..offsets[k + 1]]`.
    Many {
        /// Lower edge of the first slab, mm.
        low: f64,
        /// Slabs per mm.
        per_mm: f64,
        /// Start of each slab in `items`, and the end of the last one.
        offsets: Vec<u32>,
        /// Element indices.
        items: Vec<u32>,
    },
}

impl Slabs {
    /// Builds the slabs of a contour.
    pub(super) fn new(path: &Path) -> Self {
        let bounds = path.bounds();
        let height = bounds.size().y;
        let n = path.segments.len();
        if n < MIN_ELEMENTS || height <= 0.0 {
            return Self::One;
        }
        let spans: Vec<(f64, f64)> = path
            .segments
            .iter()
            .map(|s| {
                let b = s.bounds();
                (b.min.y, b.max.y)
            })
            .collect();
        let tall: f64 = spans.iter().map(|(a, b)| b - a).sum::<f64>() / height;
        #[allow(clippy::cast_precision_loss, reason = "counts are far below 2^52")]
        let slabs = (n as f64).min((ENTRIES_PER_ELEMENT - 1.0) * n as f64 / tall.max(1.0)).max(1.0).floor();
        let per_mm = slabs / height;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at least 1, at most n")]
        let count = slabs as usize;
        let reach = |&(a, b): &(f64, f64)| {
            (slab(a - bounds.min.y, per_mm, count), slab(b - bounds.min.y, per_mm, count))
        };
        let mut offsets = vec![0_u32; count + 1];
        for s in &spans {
            let (a, b) = reach(s);
            for o in &mut offsets[a + 1..=b + 1] {
                *o += 1;
            }
        }
        for k in 1..offsets.len() {
            offsets[k] += offsets[k - 1];
        }
        let mut next = offsets.clone();
        let mut items = vec![0; offsets.last().map_or(0, |&o| o as usize)];
        for (i, s) in (0_u32..).zip(&spans) {
            let (a, b) = reach(s);
            for k in &mut next[a..=b] {
                items[*k as usize] = i;
                *k += 1;
            }
        }
        Self::Many { low: bounds.min.y, per_mm, offsets, items }
    }

    /// The elements that may reach height `y`.
    pub(super) fn at<'a>(&'a self, path: &'a Path, y: f64) -> impl Iterator<Item = &'a Segment> {
        self.between(path, [y, y])
    }

    /// The elements that may reach a height from `bottom` to `top`.
    pub(super) fn between<'a>(
        &'a self,
        path: &'a Path,
        [bottom, top]: [f64; 2],
    ) -> impl Iterator<Item = &'a Segment> {
        let (all, picked) = match self {
            Self::One => (&path.segments[..], &[][..]),
            Self::Many { low, per_mm, offsets, items } => {
                let [first, last] = [bottom, top].map(|y| slab(y - low, *per_mm, offsets.len() - 1));
                (&[][..], &items[offsets[first] as usize..offsets[last + 1] as usize])
            }
        };
        all.iter().chain(picked.iter().map(|&i| &path.segments[i as usize]))
    }
}

fn slab(above: f64, per_mm: f64, count: usize) -> usize {
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "negative saturates to slab 0"
    )]
    ((above * per_mm) as usize).min(count - 1)
}
