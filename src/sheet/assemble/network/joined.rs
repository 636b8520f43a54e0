//! Joined chains, as the network sees them.

use crate::sheet::element::{Chain, Chains};

/// What a chain is to the network.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::sheet::assemble) enum Role {
    /// An open chain, or one that passes a branch: its contour is to be found.
    Candidate,
    /// A closed chain.
    Closed,
    /// A chain of a contour that closes without a branch; the number of that contour.
    Loop(u32),
    /// A rest of the closed shape with this outline.
    Rest(u32),
}

/// The joined chains, as the assembly sees them.
pub(in crate::sheet::assemble) struct Joined<'a> {
    /// All chains.
    pub(in crate::sheet::assemble) chains: &'a Chains,
    /// The role of each chain.
    pub(in crate::sheet::assemble) roles: Vec<Role>,
    /// For each chain end, the one it is joined to. Chain `c` has the ends `2 c` and `2 c + 1`.
    pub(in crate::sheet::assemble) mates: &'a [u32],
    /// Largest distance between ends that meet, mm.
    pub(in crate::sheet::assemble) tolerance: f64,
}

impl Joined<'_> {
    pub(in crate::sheet::assemble) fn chain(&self, c: u32) -> Option<&Chain> {
        self.chains.chains.get(c as usize)
    }
}
