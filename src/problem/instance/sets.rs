//! The sets of an instance, which set comes before which, and where the cycle starts; all counted from 0.

use super::error::InstanceError;
use super::file::{File, Part};

/// Sets and their order.
pub(super) struct Sets {
    /// Nodes of each set.
    pub(super) members: Vec<Vec<usize>>,
    /// The first comes before the second.
    pub(super) pairs: Vec<(usize, usize)>,
    pub(super) start: usize,
}

/// The sets of a file with this many nodes; without a section of sets every node is a set.
pub(super) fn sets(file: &File, nodes: usize) -> Result<Sets, InstanceError> {
    let Some(part) = file.part("GTSP_SET_SECTION") else {
        let members = (0..nodes).map(|n| vec![n]).collect();
        return Ok(Sets { members, pairs: Vec::new(), start: 0 });
    };
    let count = file.wanted("GTSP_SETS")?;
    let rows = rows(part)?;
    if file.word("GTSP_SETS") != Some(rows.len().to_string()) {
        let what = format!("GTSP_SETS does not say {}, which is how many sets are listed.", rows.len());
        return Err(InstanceError::at(count.line, what));
    }
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); rows.len()];
    let mut set_of = vec![None; nodes];
    for row in &rows {
        let set = part.ordinal(row.start, rows.len())?;
        if row.len() < 2 || !members[set].is_empty() {
            let what = format!("Set {} is empty or listed twice.", set + 1);
            return Err(InstanceError::at(part.line_of(row.start), what));
        }
        for k in row.start + 1..row.end {
            let node = part.ordinal(k, nodes)?;
            if set_of[node].replace(set).is_some() {
                let what = format!("Node {} is in a set already.", node + 1);
                return Err(InstanceError::at(part.line_of(k), what));
            }
            members[set].push(node);
        }
    }
    if let Some(node) = set_of.iter().position(Option::is_none) {
        return Err(InstanceError::at(part.line, format!("Node {} is in no set.", node + 1)));
    }
    let start = match file.part("START_GROUP_SECTION") {
        Some(start) => start.ordinal(0, rows.len())?,
        // A cycle starts anywhere; with few nodes the start is settled soonest.
        None => (0..rows.len()).min_by_key(|&s| members[s].len()).unwrap_or(0),
    };
    let pairs = match file.part("GTSP_SET_ORDERING") {
        Some(order) => ordering(order, rows.len(), start)?,
        None => Vec::new(),
    };
    Ok(Sets { members, pairs, start })
}

/// Indices of the numbers between one -1 and the next.
fn rows(part: &Part) -> Result<Vec<std::ops::Range<usize>>, InstanceError> {
    let mut rows = Vec::new();
    let mut first = 0;
    for (k, number) in part.numbers.iter().enumerate() {
        if *number < 0.0 {
            rows.push(first..k);
            first = k + 1;
        }
    }
    if first < part.numbers.len() {
        return Err(InstanceError::at(part.line_of(first), "The list does not end with -1.".into()));
    }
    Ok(rows)
}

/// Pairs of sets, the first before the second, as long as some order of the sets keeps them all.
fn ordering(part: &Part, sets: usize, start: usize) -> Result<Vec<(usize, usize)>, InstanceError> {
    let mut after: Vec<Vec<usize>> = vec![Vec::new(); sets];
    let mut waits_for = vec![0; sets];
    for row in rows(part)?.iter().filter(|row| !row.is_empty()) {
        let first = part.ordinal(row.start, sets)?;
        for k in row.start + 1..row.end {
            let then = part.ordinal(k, sets)?;
            if then == start || then == first {
                let what = format!("Set {} cannot come before set {}.", first + 1, then + 1);
                return Err(InstanceError::at(part.line_of(k), what));
            }
            if !after[first].contains(&then) {
                after[first].push(then);
                waits_for[then] += 1;
            }
        }
    }
    // Kahn: take out what waits for nothing, as long as there is any.
    let pairs = (0..sets).flat_map(|first| after[first].iter().map(move |&then| (first, then))).collect();
    let mut free: Vec<usize> = (0..sets).filter(|&s| waits_for[s] == 0).collect();
    while let Some(set) = free.pop() {
        for &then in &after[set] {
            waits_for[then] -= 1;
            if waits_for[then] == 0 {
                free.push(then);
            }
        }
    }
    match waits_for.iter().position(|&w| w > 0) {
        None => Ok(pairs),
        Some(set) => {
            let what = format!("The order of sets runs in a circle around set {}.", set + 1);
            Err(InstanceError::at(part.line, what))
        }
    }
}

/// Edges that every tour must take, by the numbers of the file; only where every node is a set.
pub(super) fn fixed_edges(file: &File, nodes: usize) -> Result<Vec<[u32; 2]>, InstanceError> {
    let Some(part) = file.part("FIXED_EDGES_SECTION") else { return Ok(Vec::new()) };
    if file.part("GTSP_SET_SECTION").is_some() {
        let what = "Fixed edges are read only for tours of all nodes, not of sets.";
        return Err(InstanceError::at(part.line, what.into()));
    }
    let list = rows(part)?.first().map_or(0..0, Clone::clone);
    if list.len() % 2 == 1 {
        return Err(InstanceError::at(part.line, "A fixed edge lacks its second node.".into()));
    }
    let number = |k| part.ordinal(k, nodes).map(|n| u32::try_from(n + 1).unwrap_or(u32::MAX));
    list.step_by(2).map(|k| Ok([number(k)?, number(k + 1)?])).collect()
}
