//! The steps that may be put back next.

use super::super::net::{Net, Step};
use super::places::Places;
use super::state::State;

/// Nodes that are tried as the end of the previous trail: the nearest with one element left, and as many others, preferably
/// with an odd number left.
const JUMPS: usize = 3;

impl Places {
    /// The steps that may be put back at the end of a state and, with `true`, after a jump.
    pub(super) fn steps(&self, net: &Net, state: &State) -> Vec<(Step, bool)> {
        let open =
            |node: u32| self.arriving[node as usize].iter().copied().filter(|&s| state.may_take(net, s));
        let here = state.at.here;
        let mut steps: Vec<_> = open(here).map(|s| (s, false)).collect();
        if state.at.after.is_none() {
            return steps;
        }
        // With one element left, with an odd number, with an even one.
        let mut ends: [Vec<u32>; 3] = Default::default();
        let look = |ends: &mut [Vec<u32>; 3], node: u32| {
            let kind = match state.left(node) {
                0 => return false,
                1 => 0,
                left => 2 - usize::from(left % 2),
            };
            if ends[kind].len() < JUMPS && open(node).next().is_some() {
                ends[kind].push(node);
            }
            ends[0].len() + ends[1].len() == 2 * JUMPS
        };
        let enough = self.near[here as usize].iter().any(|&n| look(&mut ends, n));
        if !enough && ends.iter().all(Vec::is_empty) {
            net.nodes().filter(|&n| n != here).any(|n| look(&mut ends, n));
        }
        let [last, odd, even] = &ends;
        for &node in last.iter().chain(odd.iter().chain(even).take(JUMPS)) {
            steps.extend(open(node).map(|s| (s, true)));
        }
        steps
    }
}
