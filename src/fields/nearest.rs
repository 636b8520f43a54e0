//! The known name that a caller probably meant.

use super::value::shown;

/// The name among `known` that is nearest to `name`, if it is close enough to be a misspelling: at most two characters, or
/// a third of them, differ. Case, hyphens and underscores are ignored.
pub fn nearest<'n>(name: &str, known: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let name = key(name);
    let near = |other: &&str| {
        let other = key(other);
        (other.len().abs_diff(name.len()) <= 8).then(|| distance(&name, &other))
    };
    let most = (name.len() / 3).max(2).min(name.len().saturating_sub(1));
    let all = known.into_iter().filter_map(|other| near(&other).map(|d| (d, other)));
    // Of equally near names the first is used, so that the answer depends only on the order of the table.
    let best = all.reduce(|best, other| if other.0 < best.0 { other } else { best });
    best.filter(|(d, _)| *d <= most).map(|(_, other)| other)
}

/// The sentence for a name that is not among the known ones. `what` is the kind of thing: `machine`.
pub fn no_such(what: &str, name: &str, known: &[&str]) -> String {
    let hint = nearest(name, known.iter().copied()).map(|near| format!(" Did you mean \"{near}\"?"));
    let (name, hint) = (shown(name), hint.unwrap_or_default());
    format!("There is no {what} named \"{name}\".{hint} Choose one of: {}.", known.join(", "))
}

/// Largest number of characters that are compared: far more than any field's name, and a limit on the work for hostile
/// input.
const LONGEST: usize = 64;

fn key(name: &str) -> Vec<char> {
    let letters = name.chars().filter(|c| !matches!(c, '_' | '-' | ' '));
    letters.take(LONGEST).map(|c| c.to_ascii_lowercase()).collect()
}

/// Number of insertions, deletions, substitutions and transpositions of neighbours between two names (optimal string
/// alignment).
fn distance(a: &[char], b: &[char]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for (i, &x) in a.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, &y) in b.iter().enumerate() {
            let mut best = (last[j] + usize::from(x != y)).min(last[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && x == b[j - 1] && a[i - 1] == y {
                best = best.min(before[j - 1] + 1);
            }
            row.push(best);
        }
        before = std::mem::replace(&mut last, row);
    }
    last[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_recognised_and_other_words_are_not() {
        let known = ["kerf_width", "cut", "pierce_time", "joinTolerance"];
        let of = |name| nearest(name, known);
        assert_eq!(of("kerf_witdh"), Some("kerf_width"));
        assert_eq!(of("kerfWidth"), Some("kerf_width"));
        assert_eq!(of("join_tolerence"), Some("joinTolerance"));
        assert_eq!(of("cutt"), Some("cut"));
        assert_eq!(of("nonsense"), None);
        assert_eq!(of(""), None);
        assert_eq!(of(&"x".repeat(1_000_000)), None);
    }
}
