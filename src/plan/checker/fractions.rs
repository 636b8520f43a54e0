//! Places along a line at which the checker looks, as fractions of its length.

/// Fractions from 0 to 1, both included, that are `step` mm apart on a line of `length` mm, or less to come out even. There
/// are at least `least` and at most `most` steps.
pub(super) fn fractions(length: f64, step: f64, [least, most]: [f64; 2]) -> impl Iterator<Item = f64> {
    let count = (length / step).ceil().clamp(least, most);
    std::iter::successors(Some(0.0), move |k| (*k < count).then_some(k + 1.0)).map(move |k| k / count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[allow(clippy::float_cmp, reason = "halves and quarters are exact")]
    fn both_ends_are_included_and_the_steps_are_even_and_limited() {
        let all = |length| fractions(length, 0.5, [2.0, 4.0]).collect::<Vec<_>>();
        assert_eq!(all(0.0), [0.0, 0.5, 1.0]);
        assert_eq!(all(1.75), [0.0, 0.25, 0.5, 0.75, 1.0]);
        assert_eq!(all(1e6), all(1.75));
    }
}
