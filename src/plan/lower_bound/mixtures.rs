//! How much each axis counts in the straight functions below the seconds of legs (`minorant.rs`), where that is not left to the two pieces.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The whole of a mixture, so that a certificate states it in whole numbers: pieces are at last some thousandths of a millimetre long, and what
/// rounding loses is a millionth of that.
const ONE: u32 = 1 << 20;

/// How much x counts in the legs between two items, of 2^20.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MixedLegs {
    /// The two items, the lower number first. Home is 0; the end of an open path is 1.
    pub items: [usize; 2],
    /// How much x counts in the time at top speed; in all of the seconds if each axis moves for itself.
    pub speed: u32,
    /// How much x counts in the ramps.
    pub ramps: u32,
}

/// How much x counts in the time at top speed and in the ramps: 0 to 1.
pub(super) type Mixture = [f64; 2];

/// The mixtures of the legs between some pairs of items.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Mixtures(BTreeMap<[usize; 2], [u32; 2]>);

impl Mixtures {
    /// The mixture of the legs between two items, if it is given.
    pub(super) fn between(&self, [a, b]: [usize; 2]) -> Option<Mixture> {
        self.0.get(&[a.min(b), a.max(b)]).map(|parts| parts.map(|part| f64::from(part) / f64::from(ONE)))
    }

    /// Gives the legs between two items a mixture, unless they have one.
    pub(super) fn add(&mut self, [a, b]: [usize; 2], mixture: Mixture) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 2^20")]
        let whole = |share: f64| (share.clamp(0.0, 1.0) * f64::from(ONE)).round() as u32;
        self.0.entry([a.min(b), a.max(b)]).or_insert(mixture.map(whole));
    }

    /// The mixtures that a certificate states, for this number of items; `None` if they do not fit.
    pub(super) fn read(list: &[MixedLegs], count: usize) -> Option<Self> {
        let fits =
            |l: &MixedLegs| l.items[0] < l.items[1] && l.items[1] < count && l.speed.max(l.ramps) <= ONE;
        let all: BTreeMap<_, _> = list.iter().map(|l| (l.items, [l.speed, l.ramps])).collect();
        (list.iter().all(fits) && all.len() == list.len()).then_some(Self(all))
    }

    /// The same for a certificate.
    pub(super) fn list(&self) -> Vec<MixedLegs> {
        self.0.iter().map(|(&items, &[speed, ramps])| MixedLegs { items, speed, ramps }).collect()
    }
}
