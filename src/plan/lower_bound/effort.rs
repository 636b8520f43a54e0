//! What the check of a certificate may take.

use super::fault::CertificateFault;

/// Most knots of all items: about 50 MB.
pub(super) const MOST_KNOTS: usize = 400_000;

/// What a check may still take, so that a certificate from elsewhere neither fills the memory nor takes hours.
pub(super) struct Effort {
    legs: u128,
}

impl Effort {
    /// Most legs between the knots of two items: 150 MB.
    const OF_A_PAIR: u128 = 4_000_000;
    /// Most legs between knots, and most knots looked at for cuts: some minutes in wasm, where 64 million legs took 49 s on a busy machine.
    const IN_ALL: u128 = 400_000_000;
    /// Cuts that look at a leg in the time in which one is made, which takes square roots.
    const CUTS_OF_A_LEG: u128 = 32;

    /// What a check may take of items with `knots` knots in all, after it has looked at all of them for each of its `cuts` cuts.
    pub(super) fn after(cuts: usize, knots: usize) -> Result<Self, CertificateFault> {
        if knots > MOST_KNOTS {
            return Err(CertificateFault::TooMuch("knots"));
        }
        let legs = Self::IN_ALL.checked_sub(cuts as u128 * knots as u128);
        Ok(Self { legs: legs.ok_or(CertificateFault::TooMuch("cuts"))? })
    }

    /// Counts the work for the legs between two items with `n` and `m` knots, each of which is compared with `cuts` cuts. It is called
    /// before the legs are made.
    pub(super) fn look_at(&mut self, [n, m]: [usize; 2], cuts: usize) -> Result<(), CertificateFault> {
        let legs = n as u128 * m as u128;
        let all = legs + legs * cuts as u128 / Self::CUTS_OF_A_LEG;
        let left = self.legs.checked_sub(all).filter(|_| legs <= Self::OF_A_PAIR);
        self.legs = left.ok_or(CertificateFault::TooMuch("legs between knots"))?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A few megabytes of cuts with one knot each made a check take hours.
    #[test]
    fn cuts_that_look_at_each_leg_count_as_effort() {
        let too_much = Err(CertificateFault::TooMuch("legs between knots"));
        let mut effort = Effort::after(11_000, 20_000).unwrap();
        assert_eq!(effort.look_at([2_000, 2_000], 11_000), too_much);
        assert_eq!(Effort::after(100, 4_000).unwrap().look_at([2_000, 2_001], 0), too_much);
        let mut effort = Effort::after(100, 4_000).unwrap();
        for _ in 0..24 {
            assert_eq!(effort.look_at([2_000, 2_000], 96), Ok(()));
        }
        assert_eq!(effort.look_at([2_000, 2_000], 96), too_much);
    }
}
