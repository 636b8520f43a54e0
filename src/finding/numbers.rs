//! Numbers in the sentences of findings.

/// A number to three decimals, without zeros at its end: "140", "0.3".
pub(crate) fn short(number: f64) -> String {
    format!("{number:.3}").trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn zeros_are_left_out_only_behind_the_point() {
        let written = [140.0, 0.3, 12.3456, 0.0, 100.0004, 1200.5].map(short);
        assert_eq!(written, ["140", "0.3", "12.346", "0", "100", "1200.5"]);
    }
}
