//! How members move that are permutations of the segments, each with a cutting direction: the rules of `rules.rs` without
//! arithmetic on random keys. The paper does not say how its comparators represent a path, so both are offered.
//!
//! A difference between two members is the list of changes that leads from one to the other (Wang et al., International
//! Conference on Machine Learning and Cybernetics, 2003): exchanges of two segments, and segments that turn round. Where
//! an equation multiplies a difference by a number, each change is made with that probability. A permutation has no
//! opposite direction, so for a negative number a random change is made instead, and for a number above 1 the excess is
//! the probability of a random change in addition.
//!
//! A member still has keys, two for each segment; exchanging the keys of two segments exchanges their places.

use super::chromosome::ascending;
use super::members::Members;
use super::rules::{Foragers, MoveRule, Whales};
use crate::geometry::math;
use crate::solve::rng::{Draw, Rng};
use std::f64::consts::TAU;

/// A change of a member.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Change {
    /// Two segments exchange their places.
    Exchange(u32, u32),
    /// A segment is cut in the other direction.
    Turn(u32),
}

impl Change {
    fn random(segments: usize, rng: &mut Rng) -> Self {
        let mut any = || u32::try_from(rng.below(segments)).unwrap_or(0);
        let (a, b) = (any(), any());
        if a == b { Self::Turn(a) } else { Self::Exchange(a, b) }
    }

    fn apply(self, keys: &mut [f32]) {
        let segments = keys.len() / 2;
        match self {
            Self::Exchange(a, b) => keys.swap(a as usize, b as usize),
            Self::Turn(s) => {
                let way = &mut keys[segments + s as usize];
                *way = if *way >= 0.5 { 0.25 } else { 0.75 };
            }
        }
    }
}

/// The changes that lead from one member to another, in this order.
fn difference(from: &[f32], to: &[f32]) -> Vec<Change> {
    let segments = from.len() / 2;
    let (mut now, goal) = (ascending(&from[..segments]), ascending(&to[..segments]));
    let mut place = vec![0; segments];
    now.iter().enumerate().for_each(|(at, &s)| place[s as usize] = at);
    let mut changes = Vec::new();
    for (at, &wanted) in goal.iter().enumerate() {
        let here = now[at];
        if here != wanted {
            let other = place[wanted as usize];
            now.swap(at, other);
            (place[wanted as usize], place[here as usize]) = (at, other);
            changes.push(Change::Exchange(here, wanted));
        }
    }
    let ways = from[segments..].iter().zip(&to[segments..]);
    changes.extend(
        (0..).zip(ways).filter(|(_, (a, b))| (**a >= 0.5) != (**b >= 0.5)).map(|(s, _)| Change::Turn(s)),
    );
    changes
}

/// The changes of a difference that are made. `size` gives the number by which the difference is multiplied.
fn part(
    difference: &[Change],
    segments: usize,
    rng: &mut Rng,
    mut size: impl FnMut(&mut Rng) -> f64,
) -> Vec<Change> {
    let mut made = Vec::new();
    for &change in difference {
        let size = size(rng);
        if rng.uniform() < size.abs() {
            made.push(if size > 0.0 { change } else { Change::random(segments, rng) });
        }
        if size.abs() > 1.0 && rng.uniform() < size.abs() - 1.0 {
            made.push(Change::random(segments, rng));
        }
    }
    made
}

/// The keys of a member after some changes.
fn changed(keys: &[f32], changes: &[Change]) -> Vec<f32> {
    let mut keys = keys.to_vec();
    changes.iter().for_each(|c| c.apply(&mut keys));
    keys
}

/// Particle swarm optimisation on permutations. A velocity is the list of changes of the last move.
pub(super) struct SwapParticles {
    pub(super) inertia: f64,
    pub(super) own: f64,
    pub(super) all: f64,
    velocities: Vec<Vec<Change>>,
    /// The best keys of each member, and their lengths.
    bests: Vec<(Vec<f32>, f64)>,
}

impl SwapParticles {
    pub(super) fn new(inertia: f64, own: f64, all: f64) -> Self {
        Self { inertia, own, all, velocities: Vec::new(), bests: Vec::new() }
    }
}

impl MoveRule for SwapParticles {
    fn trial(&mut self, members: &Members, member: usize, _done: f64, rng: &mut Rng) -> Vec<f32> {
        let (here, length) = (&members.keys[member], members.lengths[member]);
        if self.bests.len() == member {
            self.velocities.push(Vec::new());
            self.bests.push((here.clone(), length));
        } else if length < self.bests[member].1 {
            self.bests[member] = (here.clone(), length);
        }
        let segments = here.len() / 2;
        let mut velocity = part(&self.velocities[member], segments, rng, |_| self.inertia);
        let pulls = [(self.own, &self.bests[member].0), (self.all, &members.best)];
        for (weight, goal) in pulls {
            velocity.extend(part(&difference(here, goal), segments, rng, |rng| weight * rng.uniform()));
        }
        let moved = changed(here, &velocity);
        // As long as the longest difference in order, so that memory stays bounded.
        velocity.truncate(segments);
        self.velocities[member] = velocity;
        moved
    }
}

/// Optimal foraging on permutations.
pub(super) struct SwapForagers(pub(super) Foragers);

impl MoveRule for SwapForagers {
    fn begin(&mut self, members: &Members) {
        self.0.begin(members);
    }

    fn trial(&mut self, members: &Members, member: usize, done: f64, rng: &mut Rng) -> Vec<f32> {
        let here = &members.keys[member];
        let other = &members.keys[self.0.other(member, rng)];
        let k = self.0.factor(done);
        let size = |rng: &mut Rng| {
            let back = rng.uniform();
            k * (rng.uniform() - back)
        };
        changed(here, &part(&difference(here, other), here.len() / 2, rng, size))
    }

    fn accepts(&mut self, before: f64, after: f64, generation: f64, rng: &mut Rng) -> bool {
        self.0.accepts(before, after, generation, rng)
    }
}

/// Whale optimisation on permutations: a move starts from the prey and leads towards the member.
pub(super) struct SwapWhales(pub(super) Whales);

impl MoveRule for SwapWhales {
    fn trial(&mut self, members: &Members, member: usize, done: f64, rng: &mut Rng) -> Vec<f32> {
        let here = &members.keys[member];
        let (prey, size) = if rng.uniform() >= 0.5 {
            let l = 2.0 * rng.uniform() - 1.0;
            (&members.best, math::exp(self.0.spiral * l) * math::cos(TAU * l))
        } else {
            let a = self.0.coefficient(done, rng);
            let prey =
                if a.abs() < 1.0 { &members.best } else { &members.keys[rng.below(members.keys.len())] };
            (prey, a * self.0.weight)
        };
        changed(prey, &part(&difference(prey, here), here.len() / 2, rng, |_| size))
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "the numbers of the examples are exact")]
mod tests {
    use super::*;
    use crate::solve::rng::seeded;

    /// Three segments in this order, all in the stored direction except the last one named.
    const FROM: [f32; 6] = [0.1, 0.5, 0.9, 0.0, 0.0, 0.0];
    const TO: [f32; 6] = [0.9, 0.1, 0.5, 0.0, 1.0, 0.0];

    fn members() -> Members {
        let keys = vec![FROM.to_vec(), TO.to_vec()];
        Members { best: TO.to_vec(), keys, lengths: vec![5.0, 3.0], shortest: 3.0 }
    }

    /// The order of the segments, and whether each is turned.
    fn read(keys: &[f32]) -> (Vec<u32>, Vec<bool>) {
        (ascending(&keys[..3]), keys[3..].iter().map(|&w| w >= 0.5).collect())
    }

    #[test]
    fn differences_by_hand() {
        // From 0 1 2 to 1 2 0: exchange 0 and 1 (1 0 2), then 0 and 2; segment 1 turns.
        let changes = difference(&FROM, &TO);
        assert_eq!(changes, [Change::Exchange(0, 1), Change::Exchange(0, 2), Change::Turn(1)]);
        assert_eq!(read(&changed(&FROM, &changes)), read(&TO));
        assert!(difference(&TO, &TO).is_empty());
        // Turning twice gives the first direction again.
        assert_eq!(read(&changed(&FROM, &[Change::Turn(2); 2])), read(&FROM));
    }

    #[test]
    fn parts_of_a_difference_by_hand() {
        let changes = difference(&FROM, &TO);
        let made = |size: f64| part(&changes, 3, &mut seeded(1), |_| size);
        // All of it, none of it, as many random ones for -1, twice as many changes for 2.
        assert_eq!(made(1.0), changes);
        assert!(made(0.0).is_empty());
        assert_eq!((made(-1.0).len(), made(2.0).len()), (3, 6));
        assert!(made(2.0).iter().step_by(2).eq(&changes));
    }

    #[test]
    fn moves_by_hand() {
        let members = members();
        // With a pull of 0 a particle stays; inertia repeats its last changes.
        let mut still = SwapParticles::new(1.0, 0.0, 0.0);
        assert_eq!(still.trial(&members, 0, 0.0, &mut seeded(3)), FROM);
        still.velocities[0] = vec![Change::Exchange(1, 2)];
        assert_eq!(read(&still.trial(&members, 0, 0.0, &mut seeded(3))).0, [0, 2, 1]);
        // With k = 0 a forager stays.
        let mut foragers = SwapForagers(Foragers::new(0.0, 0.0));
        foragers.begin(&members);
        assert_eq!(foragers.trial(&members, 0, 0.5, &mut seeded(3)), FROM);
        // At the end A is 0: a whale that does not spiral is at the prey, the best of all.
        let mut whales = SwapWhales(Whales { reach: 2.0, least: 0.0, weight: 1.0, spiral: 1.0 });
        let mut at_prey = 0;
        for seed in 0..40 {
            let found = whales.trial(&members, 0, 1.0, &mut seeded(seed));
            if seeded(seed).uniform() < 0.5 {
                assert_eq!(found, TO);
                at_prey += 1;
            }
            // Whatever the move, every segment is cut once.
            let mut order = read(&found).0;
            order.sort_unstable();
            assert_eq!(order, [0, 1, 2]);
        }
        assert!(at_prey > 10);
    }
}
