//! The checksum of a program, by which its check sees whether a line was changed, added or removed since it was written.
//!
//! It covers all lines, without the blanks at their ends and whatever ends them, so that a program may be copied between systems. In its own
//! place it counts as zeros. It protects from accidents, not from forgery.

use sha2::{Digest, Sha256};

/// What a program holds in place of its checksum until it is complete.
pub(super) const PLACE: &str = "checksum 0000000000000000";
/// The word before the checksum, and its number of hexadecimal digits: 64 bits.
const WORD: &str = "checksum ";
const DIGITS: usize = 16;
/// Most checksums that are tried: each takes a look at the whole program.
const MOST: usize = 16;

/// The program with its checksum, if it has a place for one.
pub(super) fn filled(mut program: String) -> String {
    if let Some(at) = program.rfind(PLACE) {
        let sum = of(&program);
        program.replace_range(at..at + PLACE.len(), &sum);
    }
    program
}

/// Whether a program says its checksum and is not as it was written. A layer or a file may have a name that reads like a checksum, so it is
/// enough that one of the last [`MOST`] of them is right.
pub(super) fn is_changed(program: &str) -> bool {
    let found = program.rmatch_indices(WORD).filter_map(|(at, _)| {
        let said = program.get(at..at + PLACE.len())?;
        said.bytes().skip(WORD.len()).all(|b| b.is_ascii_hexdigit()).then_some((at, said))
    });
    let mut right = found.take(MOST).map(|(at, said)| {
        let mut blank = program.to_owned();
        blank.replace_range(at..at + PLACE.len(), PLACE);
        of(&blank) == said
    });
    right.next().is_some_and(|first| !first && !right.any(|right| right))
}

/// The word and the checksum of a program that holds zeros in its place.
fn of(program: &str) -> String {
    let mut hash = Sha256::new();
    for line in program.lines() {
        hash.update(line.trim_end());
        hash.update("\n");
    }
    let hash = hash.finalize();
    let digits = hash.iter().flat_map(|b| [b >> 4, b & 15]).take(DIGITS);
    WORD.chars().chain(digits.filter_map(|d| char::from_digit(d.into(), 16))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_checksum_follows_every_line_but_not_how_lines_end() {
        let program = filled("G21\nG1 X1\n; checksum 0000000000000000\nM2\n".to_owned());
        assert_eq!(program, "G21\nG1 X1\n; checksum 80b250f071f90a23\nM2\n");
        assert!(!is_changed(&program));
        assert!(!is_changed(&program.replace('\n', " \r\n")));
        let changes = [("G21", "G20"), ("G1 X1\n", ""), ("X1", "X1 "), ("M2", "M2\nM2"), ("80b", "00b")];
        let changed = changes.map(|(from, to)| is_changed(&program.replace(from, to)));
        assert_eq!(changed, [true, true, false, true, true]);
    }

    #[test]
    fn names_that_read_like_a_checksum_are_none() {
        let name = "; layer checksum 0123456789abcdef\n";
        let program = filled(format!("; checksum 0000000000000000\nG21\n{name}M2\n"));
        assert!(!is_changed(&program));
        assert!(is_changed(&program.replace("G21", "G20")));
        assert!(is_changed(&format!("{program}{name}")));
        let often = format!("{program}{}", name.repeat(1000));
        assert!(is_changed(&often));
    }

    #[test]
    fn a_program_without_a_checksum_is_not_changed() {
        assert_eq!(filled("G21\nM2\n".to_owned()), "G21\nM2\n");
        for text in ["G21\nM2\n", "; checksum unknown\nM2\n", "; checksum 12"] {
            assert!(!is_changed(text), "{text}");
        }
    }
}
