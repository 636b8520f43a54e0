//! Seeded damage to files, and a strict test whether the damaged file is still well formed.

use crate::testkit::rng::Rng;
use rand::RngExt;

/// One piece of damage.
#[derive(Clone, Debug, PartialEq)]
pub enum Mutation {
    /// All from this byte on is lost.
    Truncate(usize),
    /// A line is lost.
    DeleteLine(usize),
    /// A line is repeated.
    DoubleLine(usize),
    /// A line has changed places with the next.
    SwapLines(usize),
    /// The value on a line is something else.
    BadNumber(usize, &'static str),
    /// A bit of a byte has flipped.
    FlipBit(usize, u8),
}

/// Text in the place of a number.
const BAD_NUMBERS: [&str; 12] =
    ["", "abc", "1.2.3", "NaN", "-nan", "inf", "1e999", "--5", "0x1F", "1.#QNAN", "12 34", "\u{FF11}"];

/// The lines of a file, each with its line end.
pub fn lines(bytes: &[u8]) -> Vec<&[u8]> {
    bytes.split_inclusive(|b| *b == b'\n').collect()
}

/// A line and its LF as the lines that CR alone makes of it; a stray CR at its start or end makes none.
fn cr_lines(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.trim_ascii().split(|b| *b == b'\r')
}

fn trimmed(line: &[u8]) -> &[u8] {
    line.trim_ascii()
}

impl Mutation {
    /// Random damage to an ASCII file; every kind as likely.
    pub fn draw(rng: &mut Rng, bytes: &[u8], lines: &[&[u8]]) -> Self {
        let line = rng.random_range(0..lines.len());
        match rng.random_range(0..6) {
            0 => Self::Truncate(rng.random_range(0..bytes.len())),
            1 => Self::DeleteLine(line),
            2 => Self::DoubleLine(line),
            3 => Self::SwapLines(line.min(lines.len().saturating_sub(2))),
            4 => match (0..200)
                .map(|_| rng.random_range(0..lines.len() / 2) * 2)
                .find(|&i| holds_real(lines[i]))
            {
                Some(i) => Self::BadNumber(i + 1, BAD_NUMBERS[rng.random_range(0..BAD_NUMBERS.len())]),
                None => Self::DeleteLine(line),
            },
            _ => Self::FlipBit(rng.random_range(0..bytes.len()), 1 << rng.random_range(0..8)),
        }
    }

    /// Random damage to any file: truncation or a flipped bit.
    pub fn draw_binary(rng: &mut Rng, bytes: &[u8]) -> Self {
        if rng.random_bool(0.5) {
            Self::Truncate(rng.random_range(0..bytes.len()))
        } else {
            Self::FlipBit(rng.random_range(0..bytes.len()), 1 << rng.random_range(0..8))
        }
    }

    pub fn apply(&self, bytes: &[u8], lines: &[&[u8]]) -> Vec<u8> {
        match *self {
            Self::Truncate(at) => bytes[..at].to_vec(),
            Self::FlipBit(at, bit) => {
                let mut out = bytes.to_vec();
                out[at] ^= bit;
                out
            }
            Self::DeleteLine(i) => [&lines[..i], &lines[i + 1..]].concat().concat(),
            Self::DoubleLine(i) => [&lines[..=i], &lines[i..]].concat().concat(),
            Self::SwapLines(i) => {
                let mut out = lines.to_vec();
                out.swap(i, (i + 1).min(lines.len() - 1));
                out.concat()
            }
            Self::BadNumber(i, value) => {
                let end = &lines[i][lines[i].trim_ascii_end().len()..];
                let line = [value.as_bytes(), end].concat();
                let mut out = lines.to_vec();
                out[i] = &line;
                out.concat()
            }
        }
    }

    pub fn kind(&self) -> &'static str {
        match self {
            Self::Truncate(_) => "truncated",
            Self::DeleteLine(_) => "line deleted",
            Self::DoubleLine(_) => "line doubled",
            Self::SwapLines(_) => "lines swapped",
            Self::BadNumber(..) => "bad number",
            Self::FlipBit(..) => "bit flipped",
        }
    }
}

/// Whether a line is a group code whose value is a coordinate, length or angle.
fn holds_real(line: &[u8]) -> bool {
    code(line).is_some_and(is_real)
}

fn code(line: &[u8]) -> Option<i32> {
    std::str::from_utf8(trimmed(line)).ok()?.parse().ok()
}

fn is_real(code: i32) -> bool {
    matches!(code, 10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059)
}

fn is_int(code: i32) -> bool {
    matches!(code, 60..=79 | 90..=99 | 160..=179 | 270..=289 | 370..=389 | 400..=409 | 420..=429 | 440..=459 | 1060..=1071)
}

fn is_known(code: i32) -> bool {
    is_real(code)
        || is_int(code)
        || matches!(code, -5..=9 | 100..=109 | 290..=369 | 390..=399 | 410..=419 | 430..=439 | 470..=481 | 999..=1009)
}

/// Groups that an entity cannot be without.
fn required(kind: &[u8]) -> &'static [i32] {
    match kind {
        b"LINE" => &[10, 20, 11, 21],
        b"CIRCLE" => &[10, 20, 40],
        b"ARC" => &[10, 20, 40, 50, 51],
        b"ELLIPSE" => &[10, 20, 11, 21, 40],
        b"INSERT" => &[2, 10, 20],
        b"VERTEX" | b"LWPOLYLINE" => &[10, 20],
        b"SPLINE" => &[71],
        _ => &[],
    }
}

/// Whether a strict reader would find nothing wrong: known group codes with values of their type in pairs, each y
/// right after its x, sections opened and closed, EOF at the end, entities complete. Damage that leaves such a
/// file has made another drawing, and nobody can tell; any other damage a reader must notice.
pub fn is_well_formed(bytes: &[u8]) -> bool {
    // CR LF, LF or CR, as readers take them.
    let mut all: Vec<&[u8]> = lines(bytes).into_iter().flat_map(cr_lines).map(trimmed).collect();
    while all.last().is_some_and(|l| l.is_empty()) {
        all.pop();
    }
    if all.len() % 2 == 1 || all.len() < 4 {
        return false;
    }
    let pairs: Option<Vec<(i32, &[u8])>> = all.chunks_exact(2).map(|p| Some((code(p[0])?, p[1]))).collect();
    let Some(pairs) = pairs else { return false };
    if pairs.last() != Some(&(0, b"EOF")) || pairs.iter().filter(|p| **p == (0, &b"EOF"[..])).count() != 1 {
        return false;
    }
    let mut open = false;
    for (i, &(code, value)) in pairs.iter().enumerate() {
        let text = std::str::from_utf8(value).unwrap_or("");
        let sound = is_known(code)
            && (!is_real(code) || text.parse::<f64>().is_ok_and(f64::is_finite))
            && (!is_int(code) || text.parse::<i64>().is_ok());
        // A y (20 to 27) comes directly after its x.
        let follows = !(20..=27).contains(&code) || i > 0 && pairs[i - 1].0 == code - 10;
        if !sound || !follows {
            return false;
        }
        match (code, value) {
            (0, b"SECTION") if open => return false,
            (0, b"SECTION") => open = true,
            (0, b"ENDSEC") if !open => return false,
            (0, b"ENDSEC") => open = false,
            _ => {}
        }
    }
    !open && entities_are_complete(&pairs)
}

fn entities_are_complete(pairs: &[(i32, &[u8])]) -> bool {
    let starts: Vec<usize> = (0..pairs.len()).filter(|&i| pairs[i].0 == 0).collect();
    starts.iter().enumerate().all(|(k, &start)| {
        let end = starts.get(k + 1).copied().unwrap_or(pairs.len());
        required(pairs[start].1).iter().all(|code| pairs[start..end].iter().any(|p| p.0 == *code))
    })
}
