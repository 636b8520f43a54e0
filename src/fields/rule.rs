//! Sentences about numbers that are out of their range.

use super::table::Range;
use super::value::Value;

/// The sentence for a number that is out of its range. It begins with `what`, for example `The machine's field`.
pub fn out_of_range(what: &str, name: &str, n: f64, range: &Range) -> String {
    let rule = number_rule(range, false, false);
    format!("{what} \"{name}\" is {}. {rule}", Value::Number(n))
}

/// The second half of the sentence: which numbers are allowed.
pub(super) fn number_rule(range: &Range, whole: bool, nullable: bool) -> String {
    let Range { least, most, or_zero, unit, why } = *range;
    let what = if whole { "a whole number" } else { "a number" };
    let range = if least < most { format!("{what} from {least} to {most}") } else { format!("{least}") };
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let zero = if or_zero { ", or 0" } else { "" };
    let null = if nullable { ", or null" } else { "" };
    format!("Give {range}{unit}{zero}{null}: {why}.")
}
