//! Which states lie on circles through home.

/// A state: an item and the members of its ng-set that are barred, as bits.
pub(super) type Key = (usize, u32);

/// A leg between states: the one it leads to, the item left and the state left.
pub(super) type Leg = [usize; 3];

/// For each state whether it can be reached from home, and home from it. The last state is home. `legs`: between states; `far`: for each item
/// those from where a leg may lead to the state in which nothing is barred.
pub(super) fn on_circles(keys: &[Key], legs: &[Leg], far: &[Vec<(usize, f64)>]) -> [Vec<bool>; 2] {
    let home = keys.len() - 1;
    // After the states a place for each item, by way of which far legs leave it.
    let leaves = |item: usize| home + 1 + item;
    let mut ways: Vec<[usize; 2]> = legs.iter().map(|&[to, _, source]| [source, to]).collect();
    let mut fresh = vec![None; far.len()];
    for (s, &(item, barred)) in keys.iter().enumerate().take(home) {
        ways.push([s, leaves(item)]);
        if barred == 0 {
            fresh[item] = Some(s);
        }
    }
    for (list, fresh) in far.iter().zip(fresh) {
        ways.extend(fresh.iter().flat_map(|&s| list.iter().map(move |&(from, _)| [leaves(from), s])));
    }
    [[0, 1], [1, 0]].map(|[from, to]| {
        let mut next = vec![Vec::new(); leaves(far.len())];
        ways.iter().for_each(|way| next[way[from]].push(way[to]));
        let mut seen = vec![false; next.len()];
        seen[home] = true;
        let mut left = vec![home];
        while let Some(place) = left.pop() {
            left.extend(next[place].iter().filter(|&&p| !std::mem::replace(&mut seen[p], true)));
        }
        seen.truncate(home + 1);
        seen
    })
}

#[cfg(test)]
mod tests {
    use super::on_circles;

    /// Items 1 to 4 and home: 1 and 2 by legs, 3 by a far leg from 2, from which nothing leads home, and 4, to which nothing leads.
    #[test]
    fn states_that_are_reached_and_left() {
        let keys = [(1, 0), (2, 0), (3, 0), (3, 1), (4, 0), (0, 0)];
        let legs = [[0, 0, 5], [1, 1, 0], [5, 2, 1], [1, 4, 4]];
        let mut far = vec![Vec::new(); 5];
        far[3].push((2, 1.0));
        let [comes, goes] = on_circles(&keys, &legs, &far);
        assert_eq!(comes, [true, true, true, false, false, true]);
        assert_eq!(goes, [true, true, false, false, true, true]);
    }
}
