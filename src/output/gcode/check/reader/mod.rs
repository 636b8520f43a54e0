//! Follows a program line by line under the rules of its dialect: where the head goes, and what the beam does meanwhile.
//!
//! Written from the controllers' rules; it shares no code with the writer.

mod motion;

use super::beam::Beam;
use super::macros::{Does, Macros};
use super::problem::{Code, Problems};
use super::program::{Event, Program};
use super::words::{self, Line};
use crate::geometry::DVec2;
use crate::machine::dialect::{Dialect, PowerBy};

/// Above this height the head is lifted, mm.
const LIFTED: f64 = 0.01;

struct Reader<'d, 'p> {
    dialect: &'d Dialect,
    beam: Beam<'d>,
    macros: Macros,
    program: Program,
    problems: &'p mut Problems,
    /// mm in a unit of the file; `None` before the program has said so.
    unit: Option<f64>,
    relative: bool,
    centers_absolute: bool,
    /// Whether there was a motion.
    moved: bool,
    motion: i64,
    /// mm/s.
    feed: f64,
    at: DVec2,
    /// Height of the head, mm; 0 is where it cuts first.
    z: f64,
    number: u32,
    /// The line with M2 or M30, after which the controller reads no more.
    ended: Option<u32>,
}

/// Follows a program. What cannot be read becomes a problem, and the reading goes on.
pub(super) fn follow(text: &str, dialect: &Dialect, problems: &mut Problems) -> Program {
    let mut reader = Reader {
        dialect,
        beam: Beam::new(dialect),
        macros: Macros::new(dialect),
        program: Program { dark_at_end: true, ..Program::default() },
        problems,
        unit: None,
        relative: false,
        centers_absolute: false,
        moved: false,
        motion: 0,
        feed: 0.0,
        at: DVec2::ZERO,
        z: 0.0,
        number: 0,
        ended: None,
    };
    for line in text.lines() {
        reader.number = reader.number.saturating_add(1);
        reader.line(line);
    }
    let mut program = reader.program;
    program.lines = reader.number;
    program.dark_at_end &= reader.beam.is_off();
    program
}

impl Reader<'_, '_> {
    fn line(&mut self, text: &str) {
        let (number, most) = (Some(self.number), self.dialect.line_length as usize);
        if text.len() > most {
            self.problems.error(Code::BadLine, number, || {
                format!(
                    "Line {} has {} characters, and this controller holds {most}.",
                    self.number,
                    text.len()
                )
            });
        }
        let acted_upon = matches!(self.dialect.power.by, PowerBy::LaserM4 | PowerBy::LaserM3);
        if acted_upon && let Some(c) = text.chars().find(|&c| matches!(c, '?' | '!' | '~') || c > '\u{7f}') {
            self.problems.error(Code::BadLine, number, || {
                format!(
                    "Line {} contains {c:?}, on which the controller acts at once, even in a comment.",
                    self.number
                )
            });
        }
        let mut line = match words::divided(text) {
            Ok(line) => line,
            Err(why) => return self.unreadable(&why),
        };
        if let Some(comment) = line.comments.iter().find(|c| announces(c)) {
            let mark = comment.contains(": mark contour ");
            self.program.events.push(Event::Contour { mark });
        }
        self.program.comments.extend(line.comments.iter().cloned());
        if line.command.is_empty() {
            return;
        }
        self.program.tail.push(line.command.clone());
        if self.program.tail.len() > self.dialect.footer.len() {
            self.program.tail.remove(0);
        }
        if self.run_macro(&line.command) {
            return;
        }
        match line.read_words() {
            Ok(()) => self.command(&line),
            Err(_) if self.macros.hold(&line.command) => {}
            Err(why) => self.unreadable(&why),
        }
    }

    fn unreadable(&mut self, why: &str) {
        let number = self.number;
        self.problems.error(Code::Unreadable, Some(number), || format!("Line {number} {why}."));
    }

    /// Whether a macro of the dialect ends with the line.
    fn run_macro(&mut self, command: &str) -> bool {
        let Some(does) = self.macros.line(command) else { return false };
        let (Does::Sets(power) | Does::Pierces(power, _)) = does;
        self.program.powers.push((self.number, power));
        self.beam.macro_sets(power);
        if let Does::Pierces(_, seconds) = does {
            let (line, power) = (self.number, self.beam.standing(true));
            self.program.events.push(Event::Dwell { line, seconds, power });
        }
        true
    }

    fn command(&mut self, line: &Line) {
        let is = |letter: char, code: i64| line.codes(letter).any(|c| c == code);
        for code in line.codes('G') {
            match code {
                0 | 10 | 20 | 30 => self.motion = code / 10,
                200 | 210 => self.unit = Some(if code == 200 { 25.4 } else { 1.0 }),
                900 | 910 => self.relative = code == 910,
                901 | 911 => self.centers_absolute = code == 901,
                // The plane, the feed a minute, no compensation, path modes, cycles off, and the work coordinates in use.
                40 | 170 | 400 | 490 | 540 | 610 | 640 | 800 | 940 => {}
                _ => {
                    let (number, g) = (self.number, code as f64 / 10.0);
                    self.problems.error(Code::Unreadable, Some(number), || {
                        format!("Line {number} has G{g}, which this check does not follow, so it cannot say where the head goes.")
                    });
                }
            }
        }
        let calls = [970, 980].into_iter().find(|&m| is('M', m));
        if let Some(m) = calls.filter(|_| !self.macros.hold(&line.command)) {
            let (number, m) = (self.number, m / 10);
            self.problems.error(Code::Unreadable, Some(number), || {
                format!("Line {number} calls another program by M{m}, which this check does not see, so it cannot say what the machine does.")
            });
        }
        let unit = self.unit.unwrap_or(self.dialect.units.mm());
        // F after G4 is a time where the dialect says so, and no feed.
        if let Some(feed) = line.value('F').filter(|_| !is('G', 40)) {
            self.feed = feed * unit / 60.0;
        }
        self.follows_the_end(line);
        let set = self.beam.line(line);
        self.program.powers.extend(set.into_iter().map(|p| (self.number, p)));
        if is('G', 40) {
            return self.dwell(line);
        }
        if let Some(z) = line.value('Z') {
            let (was, from) = (self.is_lifted(), self.z);
            self.z = if self.relative { from } else { 0.0 } + z * unit;
            if !line.has('X') && !line.has('Y') {
                let distance = if was || self.is_lifted() { 0.0 } else { (self.z - from).abs() };
                let (line, power) = (self.number, self.beam.moving(self.motion == 0));
                self.program.events.push(Event::Height { line, power, distance });
            }
            self.program.lifts = self.program.lifts.saturating_add(u32::from(!was && self.is_lifted()));
        }
        // A full circle has no end, and its centre may be given along one axis; the I of an `M3 I` is no centre.
        let circle = self.motion >= 2 && (line.has('I') || line.has('J')) && line.codes('M').next().is_none();
        if line.has('X') || line.has('Y') || circle {
            self.moves(line, unit);
        }
    }

    /// Reports commands after M2 or M30, which the controller does not run. The `%` that ends a tape is no command.
    fn follows_the_end(&mut self, line: &Line) {
        let number = self.number;
        if let Some(end) = self.ended.filter(|_| !line.words.is_empty()) {
            self.problems.error(Code::Incomplete, Some(number), || {
                format!("Line {number} comes after the end of the program in line {end}: the controller does not run it.")
            });
        }
        if line.codes('M').any(|m| m == 20 || m == 300) {
            self.ended = self.ended.or(Some(number));
        }
    }

    /// Relative programs add heights up, and their last digits are rounded.
    fn is_lifted(&self) -> bool {
        self.z > LIFTED
    }
}

/// Whether a comment is Kerfway's `3 of 7: cut contour 5, layer 0`.
fn announces(comment: &str) -> bool {
    comment.split_once(" contour ").is_some_and(|(before, _)| {
        before.starts_with("pre-cut")
            || before.split_once(" of ").is_some_and(|(n, _)| n.parse::<u32>().is_ok())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::dialect::DialectChoice;

    fn told(text: &str) -> Vec<String> {
        let dialect = DialectChoice::named("grbl-m4").document().unwrap();
        let mut problems = Problems::default();
        follow(text, &dialect, &mut problems);
        problems.0.into_iter().map(|p| p.message).collect()
    }

    #[test]
    fn calls_of_other_programs_are_reported() {
        for (call, word) in [("M98 P100", "M98"), ("M97 P5 L2", "M97")] {
            assert_eq!(
                told(&format!("G21 G90\n{call}\nM2\n")),
                [format!(
                    "Line 2 calls another program by {word}, which this check does not see, so it cannot say what the machine does."
                )]
            );
        }
    }

    #[test]
    fn commands_after_the_end_are_reported_and_the_end_of_a_tape_is_none() {
        for end in ["M2\n%\n", "M30\n%\n\n; made by hand\n"] {
            assert_eq!(told(&format!("G21 G90\nG0 X5 Y5\nM5\n{end}")), Vec::<String>::new(), "{end}");
        }
        let late = told("G21 G90\nM2\nG0 X5 Y5\n");
        assert_eq!(
            late,
            ["Line 3 comes after the end of the program in line 2: the controller does not run it."]
        );
    }
}
