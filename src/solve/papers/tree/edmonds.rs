//! Minimum arborescence: the cheapest arcs of a directed graph by which a root reaches every vertex (Chu and Liu, Science
//! Sinica 14 (1965); Edmonds, J. Res. NBS 71B (1967)).
//!
//! Every vertex takes its cheapest incoming arc. Where these arcs form a cycle, the cycle is contracted to one vertex, and
//! each arc into the cycle becomes cheaper by the cost of the cycle's own arc to the same vertex. This repeats until there
//! is no cycle. Then the cycles are expanded again, the last first: the arc chosen into each replaces one of its own.

/// An arc of a directed graph.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Arc {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) cost: f64,
}

/// One level of contraction.
struct Level {
    /// Arcs of this level, each with its index in the level below.
    arcs: Vec<(Arc, usize)>,
    /// Index in `arcs` of the cheapest arc into each vertex.
    cheapest: Vec<Option<usize>>,
    /// For each vertex of this level, the vertex of the next level that contains it.
    into: Vec<usize>,
}

/// The indices of the chosen arcs, one into each vertex except the root; `None` if some vertex cannot be reached.
pub(super) fn arborescence(vertices: usize, root: usize, arcs: &[Arc]) -> Option<Vec<usize>> {
    let (mut count, mut root) = (vertices, root);
    let mut arcs: Vec<(Arc, usize)> = arcs.iter().copied().zip(0..).collect();
    let mut levels: Vec<Level> = Vec::new();
    loop {
        let mut cheapest: Vec<Option<usize>> = vec![None; count];
        for (k, (arc, _)) in arcs.iter().enumerate() {
            let own = &mut cheapest[arc.to];
            if arc.to != root && arc.from != arc.to && own.is_none_or(|o| arc.cost < arcs[o].0.cost) {
                *own = Some(k);
            }
        }
        if (0..count).any(|v| v != root && cheapest[v].is_none()) {
            return None;
        }
        let (into, vertices) = shrunk(&cheapest, &arcs, count);
        let whole = vertices == count;
        let level = Level { arcs, cheapest, into };
        if whole {
            levels.push(level);
            return Some(opened(&levels));
        }
        arcs = level
            .arcs
            .iter()
            .zip(0..)
            .filter(|((arc, _), _)| level.into[arc.from] != level.into[arc.to])
            .map(|(&(arc, _), k)| {
                let own = level.cheapest[arc.to].map_or(0.0, |c| level.arcs[c].0.cost);
                let shrinks = level.cheapest[arc.to]
                    .is_some_and(|c| level.into[level.arcs[c].0.from] == level.into[arc.to]);
                let cost = arc.cost - if shrinks { own } else { 0.0 };
                (Arc { from: level.into[arc.from], to: level.into[arc.to], cost }, k)
            })
            .collect();
        root = level.into[root];
        count = vertices;
        levels.push(level);
    }
}

/// The vertices of the next level, where each cycle of cheapest arcs becomes one; and their number.
fn shrunk(cheapest: &[Option<usize>], arcs: &[(Arc, usize)], count: usize) -> (Vec<usize>, usize) {
    const NEW: usize = usize::MAX;
    let (mut into, mut seen, mut next) = (vec![NEW; count], vec![NEW; count], 0);
    for start in 0..count {
        let mut v = start;
        while seen[v] == NEW {
            seen[v] = start;
            match cheapest[v] {
                Some(arc) => v = arcs[arc].0.from,
                None => break,
            }
        }
        // The walk has returned to one of its own vertices that has no number yet: a cycle.
        if seen[v] == start && into[v] == NEW && cheapest[v].is_some() {
            let mut w = v;
            loop {
                into[w] = next;
                w = cheapest[w].map_or(w, |arc| arcs[arc].0.from);
                if w == v {
                    break;
                }
            }
            next += 1;
        }
    }
    for number in &mut into {
        if *number == NEW {
            *number = next;
            next += 1;
        }
    }
    (into, next)
}

/// Expands the cycles, the last first. Returns indices of arcs of the first level.
fn opened(levels: &[Level]) -> Vec<usize> {
    let Some((last, rest)) = levels.split_last() else { return Vec::new() };
    let mut chosen: Vec<usize> = last.cheapest.iter().flatten().copied().collect();
    let mut above = last;
    for level in rest.iter().rev() {
        // As indices of this level.
        let mut own: Vec<usize> = chosen.iter().map(|&k| above.arcs[k].1).collect();
        let mut entered = vec![false; level.cheapest.len()];
        own.iter().for_each(|&k| entered[level.arcs[k].0.to] = true);
        for (v, cheapest) in level.cheapest.iter().enumerate() {
            let Some(arc) = *cheapest else { continue };
            let in_circle = level.into[level.arcs[arc].0.from] == level.into[v];
            if in_circle && !entered[v] {
                own.push(arc);
            }
        }
        chosen = own;
        above = level;
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::rng::{Draw, seeded};

    /// The cost of the cheapest arborescence, by trying all.
    fn brute(vertices: usize, root: usize, arcs: &[Arc]) -> Option<f64> {
        let mut choices: Vec<Vec<Option<&Arc>>> = vec![vec![None; vertices]];
        for v in (0..vertices).filter(|&v| v != root) {
            let into: Vec<&Arc> = arcs.iter().filter(|a| a.to == v && a.from != v).collect();
            let mut next = Vec::new();
            for choice in &choices {
                next.extend(into.iter().map(|&arc| {
                    let mut choice = choice.clone();
                    choice[v] = Some(arc);
                    choice
                }));
            }
            choices = next;
        }
        let reaches = |choice: &Vec<Option<&Arc>>| {
            (0..vertices).all(|v| {
                let up = std::iter::successors(Some(v), |&v| choice[v].map(|a: &Arc| a.from));
                up.take(vertices).any(|v| v == root)
            })
        };
        let cost = |c: &Vec<Option<&Arc>>| c.iter().flatten().map(|a| a.cost).sum::<f64>();
        choices.iter().filter(|c| reaches(c)).map(cost).min_by(f64::total_cmp)
    }

    #[test]
    fn as_cheap_as_the_best_of_all_choices() {
        let mut rng = seeded(5);
        let (mut solved, mut cut_off) = (0, 0);
        for _ in 0..600 {
            let vertices = 2 + rng.below(5);
            let root = rng.below(vertices);
            let arcs: Vec<Arc> = (0..rng.below(3 * vertices) + vertices)
                .map(|_| Arc {
                    from: rng.below(vertices),
                    to: rng.below(vertices),
                    cost: rng.below(9) as f64,
                })
                .collect();
            let (found, best) = (arborescence(vertices, root, &arcs), brute(vertices, root, &arcs));
            assert_eq!(found.is_some(), best.is_some(), "{arcs:?}");
            let (Some(found), Some(best)) = (found, best) else {
                cut_off += 1;
                continue;
            };
            solved += 1;
            let mut into: Vec<usize> = found.iter().map(|&k| arcs[k].to).collect();
            into.sort_unstable();
            assert_eq!(into, (0..vertices).filter(|&v| v != root).collect::<Vec<_>>());
            let only: Vec<Arc> = found.iter().map(|&k| arcs[k]).collect();
            assert_eq!(brute(vertices, root, &only), Some(best), "{arcs:?} from {root}");
        }
        assert!(solved > 100 && cut_off > 100, "{solved} {cut_off}");
    }

    #[test]
    fn a_circle_within_a_circle_is_opened_where_it_is_cheapest() {
        let arc = |from, to, cost| Arc { from, to, cost };
        // 1 and 2 point at each other, and both form a cycle with 3. The root reaches 3 cheaply, but then 1 and 2 cost
        // more.
        let arcs =
            [arc(1, 2, 1.0), arc(2, 1, 1.0), arc(2, 3, 2.0), arc(3, 1, 2.0), arc(0, 3, 8.0), arc(0, 2, 9.0)];
        // 0 to 3 (8), 3 to 1 (2), 1 to 2 (1): 11; or 0 to 2 (9), 2 to 1 (1), 2 to 3 (2): 12.
        let mut chosen = arborescence(4, 0, &arcs).unwrap();
        chosen.sort_unstable();
        assert_eq!(chosen, [0, 3, 4]);
    }
}
