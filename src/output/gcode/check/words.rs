//! One line of a program as words: a letter and a number, or a letter alone.

/// A word of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Word {
    /// Upper case.
    pub(super) letter: char,
    /// `None`: a letter without a number, such as Marlin's `I`.
    pub(super) value: Option<f64>,
}

/// A line without its comments.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Line {
    pub(super) words: Vec<Word>,
    /// The texts of its comments.
    pub(super) comments: Vec<String>,
    /// The command as it is written, without comments.
    pub(super) command: String,
}

/// Divides a line into its command and its comments, which are in parentheses or after a semicolon.
///
/// # Errors
/// What cannot be read, as the second half of a sentence.
pub(super) fn divided(text: &str) -> Result<Line, String> {
    let mut line = Line::default();
    let mut rest = text;
    while let Some(at) = rest.find([';', '(']) {
        line.command.push_str(&rest[..at]);
        let comment = &rest[at + 1..];
        if rest[at..].starts_with(';') {
            line.comments.push(comment.trim().to_owned());
            rest = "";
        } else {
            let (inside, after) = comment.split_once(')').ok_or("has a comment that is not closed")?;
            line.comments.push(inside.trim().to_owned());
            rest = after;
        }
    }
    line.command.push_str(rest);
    line.command = line.command.trim().to_owned();
    Ok(line)
}

/// The commands of lines of a dialect. Lines of comments and blank ones are none.
pub(super) fn commands(lines: &[String]) -> Vec<String> {
    let commands = lines.iter().filter_map(|line| Some(divided(line).ok()?.command));
    commands.filter(|command| !command.is_empty()).collect()
}

fn number_of(text: &str, letter: char) -> Result<f64, String> {
    number(text).ok_or_else(|| format!("has the word {letter}{text}, which is not a number"))
}

/// A finite number. Not `str::parse`, whose table of powers is 10 kB of the wasm file.
pub(super) fn number(text: &str) -> Option<f64> {
    let value = lexical_parse_float::FromLexical::from_lexical(text.as_bytes()).ok();
    value.filter(|n: &f64| n.is_finite())
}

impl Line {
    /// Reads the words of the command; `%` begins and ends a tape.
    ///
    /// # Errors
    /// What cannot be read, as the second half of a sentence.
    pub(super) fn read_words(&mut self) -> Result<(), String> {
        let mut rest = self.command.trim_start_matches('%').trim_start();
        while let Some(letter) = rest.chars().next() {
            if !letter.is_ascii_alphabetic() {
                return Err(format!("has {letter:?} where a word should begin"));
            }
            let after = rest[1..].trim_start();
            let end = after.find(|c: char| !matches!(c, '0'..='9' | '.' | '+' | '-')).unwrap_or(after.len());
            let (number, next) = after.split_at(end);
            let value = if number.is_empty() { None } else { Some(number_of(number, letter)?) };
            self.words.push(Word { letter: letter.to_ascii_uppercase(), value });
            rest = next.trim_start();
        }
        Ok(())
    }

    /// The value of the first word with this letter.
    pub(super) fn value(&self, letter: char) -> Option<f64> {
        self.words.iter().find(|w| w.letter == letter)?.value
    }

    /// Whether a word has this letter.
    pub(super) fn has(&self, letter: char) -> bool {
        self.words.iter().any(|w| w.letter == letter)
    }

    /// The numbers after a letter, times ten: G91.1 is 911.
    pub(super) fn codes(&self, letter: char) -> impl Iterator<Item = i64> {
        #[expect(clippy::cast_possible_truncation, reason = "a code far outside is unknown in any case")]
        let tenfold = |n: f64| (n * 10.0).round() as i64;
        self.words.iter().filter(move |w| w.letter == letter).filter_map(move |w| w.value.map(tenfold))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Line, String> {
        let mut line = divided(text)?;
        line.read_words().map(|()| line)
    }

    #[test]
    fn words_are_read_with_and_without_spaces() {
        let line = read("N10 g1X1.5 Y-2 (to the corner) F 600 ; end").unwrap();
        let words: Vec<(char, Option<f64>)> = line.words.iter().map(|w| (w.letter, w.value)).collect();
        let expected = [('N', 10.0), ('G', 1.0), ('X', 1.5), ('Y', -2.0), ('F', 600.0)];
        assert_eq!(words, expected.map(|(l, v)| (l, Some(v))));
        assert_eq!(line.comments, ["to the corner", "end"]);
        assert_eq!(line.command, "N10 g1X1.5 Y-2  F 600");
        assert_eq!(read("M3 I").unwrap().value('I'), None);
        assert!(read("M3 I").unwrap().has('I'));
        assert_eq!(read("G91.1 G17").unwrap().codes('G').collect::<Vec<_>>(), [911, 170]);
        assert_eq!(read("%").unwrap().words, []);
        assert_eq!(read("G1 X1e3").unwrap().words.len(), 3);
        assert!(read("G1 X1.2.3").unwrap_err().contains("X1.2.3"));
        assert!(read("G1 (open").unwrap_err().contains("not closed"));
        assert!(read("$H").unwrap_err().contains('$'));
    }
}
