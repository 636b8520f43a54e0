//! What names of layers say about the unit: threads (`M3`, `1/4-20`), units (`3mm`, `0.25in`) and sizes of sheets
//! (`2440x1220`).

/// A hint in a name.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Hint {
    /// A metric thread or a metric unit.
    Metric,
    /// An inch thread or an inch unit.
    Imperial,
    /// The larger side of a sheet, in its unit: millimetres if it is 200 or more, otherwise inches.
    Sheet(f64),
}

/// The number of threads to the inch of the usual inch threads.
const THREADS: [&str; 15] =
    ["56", "48", "40", "32", "24", "28", "20", "18", "16", "14", "13", "12", "11", "10", "8"];

/// The hint in a name.
pub(super) fn hint(name: &str) -> Option<Hint> {
    let name = name.to_ascii_lowercase();
    let words =
        || name.split(|c: char| c.is_whitespace() || matches!(c, '_' | ',' | ';' | '(' | ')' | '[' | ']'));
    words().find_map(sheet).or_else(|| words().find_map(word))
}

fn word(word: &str) -> Option<Hint> {
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit() || b == b'.');
    // M3, M10, M3x0.5: but not a layer that is only called M.
    if let Some(rest) = word.strip_prefix('m') {
        let size = rest.split(['x', '-', '.']).next().unwrap_or(rest);
        if matches!(size, "2" | "2.5" | "3" | "4" | "5" | "6" | "8" | "10" | "12" | "14" | "16" | "20") {
            return Some(Hint::Metric);
        }
    }
    for (unit, hint) in [
        ("mm", Hint::Metric),
        ("cm", Hint::Metric),
        ("inch", Hint::Imperial),
        ("in", Hint::Imperial),
        ("\"", Hint::Imperial),
    ] {
        if word == "mm" || word.strip_suffix(unit).is_some_and(|n| is_number(n) || is_fraction(n)) {
            return Some(hint);
        }
    }
    // 4-40, 1/4-20, #8-32.
    let (size, threads) = word.trim_start_matches('#').split_once('-')?;
    let is_size = is_fraction(size) || matches!(size, "2" | "4" | "6" | "8" | "10" | "12");
    (is_size && THREADS.contains(&threads)).then_some(Hint::Imperial)
}

fn is_fraction(text: &str) -> bool {
    let is_small = |t: &str| t.parse::<u32>().is_ok_and(|n| (1..=64).contains(&n));
    text.split_once('/')
        .is_some_and(|(a, b)| is_small(a) && matches!(b, "2" | "4" | "8" | "16" | "32" | "64") && is_small(b))
}

/// The larger side in `2440x1220` or `48X96`.
fn sheet(word: &str) -> Option<Hint> {
    let (a, b) = word.split_once(['x', '*', '×'])?;
    let side = |text: &str| {
        let digits = text.strip_suffix("mm").unwrap_or(text);
        let n: f64 = digits.parse().ok()?;
        (12.0..=10_000.0).contains(&n).then_some(n)
    };
    Some(Hint::Sheet(side(a)?.max(side(b)?)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_units_and_sheets_in_names() {
        for name in ["M3", "holes_M4", "Tap M10x1.5", "3mm", "ply 6mm", "CUT (mm)"] {
            assert_eq!(hint(name), Some(Hint::Metric), "{name}");
        }
        for name in ["4-40", "1/4-20", "#8-32 tap", "1/8in", "0.25\"", "0.5inch"] {
            assert_eq!(hint(name), Some(Hint::Imperial), "{name}");
        }
        assert_eq!(hint("2440x1220"), Some(Hint::Sheet(2440.0)));
        assert_eq!(hint("SHEET 48X96"), Some(Hint::Sheet(96.0)));
        for name in
            ["0", "M", "Material", "MARK", "in", "4-4", "10-2-2020", "cut", "1x1", "box", "2020-10-20"]
        {
            assert_eq!(hint(name), None, "{name}");
        }
    }
}
