//! A file of the TSPLIB family taken apart: header values, and sections of numbers.
//!
//! A line that starts with a letter is a keyword with or without a value; numbers belong to the keyword above them,
//! however they are broken into lines. Unknown keywords are skipped with their numbers. Only remarks may be there twice.

use super::error::InstanceError;
use crate::problem::Table;
use std::collections::HashMap;

/// Most nodes of an instance in the plane, which needs no table of costs: the largest of GTSPLIB has 85,900, and 100,000 take
/// about 200 MB in a search.
pub(super) const MOST_IN_PLANE: usize = 100_000;

/// The parts of a file.
pub(super) struct File<'t> {
    parts: Vec<Part<'t>>,
}

/// A keyword with what belongs to it.
pub(super) struct Part<'t> {
    key: String,
    value: &'t str,
    /// Line of the keyword.
    pub(super) line: usize,
    /// The numbers under it.
    pub(super) numbers: Vec<f64>,
    /// Index of the first number of a line, and the line: to say where a number stands.
    lines: Vec<(usize, usize)>,
}

impl<'t> File<'t> {
    pub(super) fn parse(text: &'t str) -> Result<Self, InstanceError> {
        let mut parts: Vec<Part> = Vec::new();
        let mut lines: HashMap<String, usize> = HashMap::new();
        for (line, row) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
            let row = row.trim();
            if row.starts_with(|c: char| c.is_alphabetic()) {
                let (key, value) = row.split_once(':').unwrap_or((row, ""));
                let key = key.trim().to_ascii_uppercase();
                if key == "EOF" {
                    break;
                }
                let first = *lines.entry(key.clone()).or_insert(line);
                if first != line && key != "COMMENT" {
                    let what = format!("{} is in line {first} already.", short(&key));
                    return Err(InstanceError::at(line, what));
                }
                parts.push(Part { key, value: value.trim(), line, numbers: Vec::new(), lines: Vec::new() });
            } else if !row.is_empty() {
                let Some(part) = parts.last_mut() else {
                    let what = "The file does not start with a keyword such as NAME or TYPE.";
                    return Err(InstanceError::at(line, what.into()));
                };
                part.lines.push((part.numbers.len(), line));
                for word in row.split_ascii_whitespace() {
                    let number = word.parse().ok().filter(|n: &f64| n.is_finite());
                    let no_number = || InstanceError::at(line, format!("\"{}\" is no number.", short(word)));
                    part.numbers.push(number.ok_or_else(no_number)?);
                }
            }
        }
        Ok(Self { parts })
    }

    /// The part under a keyword.
    pub(super) fn part(&self, key: &str) -> Option<&Part<'t>> {
        self.parts.iter().find(|p| p.key == key)
    }

    /// The part under a keyword that has to be there.
    pub(super) fn wanted(&self, key: &str) -> Result<&Part<'t>, InstanceError> {
        self.part(key).ok_or_else(|| InstanceError::whole(format!("The file has no {key}.")))
    }

    /// The word after a keyword, in capitals.
    pub(super) fn word(&self, key: &str) -> Option<String> {
        self.part(key).map(|p| p.value.to_ascii_uppercase())
    }

    /// What the file calls itself.
    pub(super) fn name(&self) -> String {
        self.part("NAME").map_or(String::new(), |p| p.value.to_owned())
    }

    /// How many nodes there are, in a file of a type that is read here: 1 to [`Table::MOST`], or to [`MOST_IN_PLANE`]
    /// where their distances are those of points in the plane.
    pub(super) fn dimension(&self) -> Result<usize, InstanceError> {
        let kind = self.wanted("TYPE")?;
        let known = ["TSP", "ATSP", "GTSP", "AGTSP", "PCGLNS"];
        // The rest of the line may be a remark: `TSP (M.~Hofmeister)`.
        let word = kind.value.split_ascii_whitespace().next().unwrap_or("").to_ascii_uppercase();
        if !known.contains(&word.as_str()) {
            let what = format!("Type \"{}\" is not read here: {} are.", short(&word), known.join(", "));
            return Err(InstanceError::at(kind.line, what));
        }
        let part = self.wanted("DIMENSION")?;
        let in_plane = matches!(self.word("EDGE_WEIGHT_TYPE").as_deref(), Some("EUC_2D" | "CEIL_2D"));
        let most = if in_plane { MOST_IN_PLANE } else { Table::MOST };
        match part.value.parse() {
            Ok(n) if (1..=most).contains(&n) => Ok(n),
            _ => {
                let what = format!("DIMENSION has to be a number of nodes from 1 to {most}.");
                Err(InstanceError::at(part.line, what))
            }
        }
    }
}

impl Part<'_> {
    /// Line of the number at an index.
    pub(super) fn line_of(&self, index: usize) -> usize {
        let after = self.lines.partition_point(|l| l.0 <= index);
        self.lines.get(after.saturating_sub(1)).map_or(self.line, |l| l.1)
    }

    /// The number at an index as one of a node or set, counted from 0; the file counts from 1 to `most`.
    pub(super) fn ordinal(&self, index: usize, most: usize) -> Result<usize, InstanceError> {
        let number = self.numbers.get(index).copied().unwrap_or(0.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked right here")]
        let n = number as usize;
        if (1..=most).contains(&n) && number.fract().abs() < f64::EPSILON {
            return Ok(n - 1);
        }
        let what = format!("{number} is no number from 1 to {most}.");
        Err(InstanceError::at(self.line_of(index), what))
    }

    /// The numbers if their count is as given, or else an error.
    pub(super) fn exactly(&self, count: usize) -> Result<&[f64], InstanceError> {
        if self.numbers.len() == count {
            return Ok(&self.numbers);
        }
        let what = format!("{} holds {} numbers where {count} are needed.", self.key, self.numbers.len());
        Err(InstanceError::at(self.line, what))
    }
}

/// What fits into a sentence.
fn short(word: &str) -> &str {
    word.char_indices().nth(20).map_or(word, |(end, _)| &word[..end])
}
