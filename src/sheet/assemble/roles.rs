//! The role of each chain in a network, after joining.

use super::ends::{Ends, NONE};
use super::network::{Joined, Role};
use crate::sheet::element::Chains;

/// Joined chains with their roles: those of contours that are open or that pass a branch are candidates.
pub(super) fn of<'a>(chains: &'a Chains, ends: &'a Ends, tolerance: f64) -> Joined<'a> {
    let mut roles = Vec::with_capacity(chains.chains.len());
    for chain in &chains.chains {
        roles.push(match (chain.closed, chain.rest_of) {
            (true, _) => Role::Closed,
            (false, Some(of)) => Role::Rest(of),
            (false, None) => Role::Candidate,
        });
    }
    // Contours that close without a branch.
    let mut seen = vec![false; roles.len()];
    let mut loops = 0;
    let mut contour: Vec<u32> = Vec::new();
    for first in 0_u32.. {
        if first as usize >= roles.len() {
            break;
        }
        if seen[first as usize] || roles[first as usize] != Role::Candidate {
            continue;
        }
        contour.clear();
        let start = 2 * first;
        let mut end = start;
        let closes = loop {
            seen[(end / 2) as usize] = true;
            contour.push(end / 2);
            let mate = ends.mate[(end ^ 1) as usize];
            let branch = ends.at_branch[end as usize] || ends.at_branch[(end ^ 1) as usize];
            if mate == NONE || branch {
                break false;
            }
            if mate == start {
                break true;
            }
            // The rest is known to be open.
            if seen[(mate / 2) as usize] {
                break false;
            }
            end = mate;
        };
        if closes {
            contour.iter().for_each(|&c| roles[c as usize] = Role::Loop(loops));
            loops += 1;
        }
    }
    Joined { chains, roles, mates: &ends.mate, tolerance }
}
