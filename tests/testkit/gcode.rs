//! A simulated controller: reads G-code as GRBL 1.1 in laser mode does, and returns what the head and the beam would do.
//!
//! Written from GRBL's documentation, sharing no code with the writer. It is strict: what GRBL refuses is an error here
//! (two words of one modal group, an arc whose radii differ, motion without feed, too long a line), and so is any word
//! it does not know. Geometry is kept in `f64`; GRBL's own checks of arcs are done in `f32` (`grbl_arc.rs`).

use super::grbl_arc::{self, READINGS, Vec32};
use crate::testkit::paths::Element;
use glam::DVec2;
use std::f64::consts::TAU;

/// A step of the head.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Event {
    /// The text of a comment.
    Comment(String),
    /// Moves.
    Motion(Motion),
    /// A pause.
    Dwell {
        /// How long, s.
        seconds: f64,
        /// The S the beam burns with meanwhile; 0: dark.
        beam: f64,
    },
}

/// One motion.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Motion {
    /// G0.
    pub(crate) rapid: bool,
    /// From where to where, mm; straight, or an arc.
    pub(crate) path: Element,
    /// The S the beam burns with; 0: dark.
    pub(crate) beam: f64,
    /// The S in force, whether the mode lets it through or not; 0 under M5.
    pub(crate) commanded: f64,
    /// mm/min; 0 for rapids.
    pub(crate) feed: f64,
}

/// A program read to its end.
#[derive(Debug, Default)]
pub(crate) struct Program {
    /// In order.
    pub(crate) events: Vec<Event>,
    /// Ended by M2.
    pub(crate) ended: bool,
}

impl Program {
    /// The motions, in order.
    pub(crate) fn motions(&self) -> impl Iterator<Item = &Motion> {
        self.events.iter().filter_map(|e| match e {
            Event::Motion(m) => Some(m),
            _ => None,
        })
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Spindle {
    Off,
    Constant,
    Dynamic,
}

/// The modal state.
struct Controller {
    motion: u8,
    spindle: Spindle,
    s: f64,
    feed: f64,
    inches: bool,
    relative: bool,
    at: DVec2,
    /// The same place in GRBL's numbers, by each way to read them.
    at32: [Vec32; 2],
}

/// One line's words.
#[derive(Default)]
struct Block {
    motion: Option<u8>,
    dwell: bool,
    spindle: Option<Spindle>,
    inches: Option<bool>,
    relative: Option<bool>,
    plane: bool,
    feed_mode: bool,
    arc_mode: bool,
    end: bool,
    values: [Option<f64>; 8],
    /// The text of each value, which GRBL reads as a 32-bit float.
    texts: [String; 8],
}

/// Letters with values, in the order of [`Block::values`].
const VALUES: &str = "XYIJFSPZ";

/// Runs a program. An error names the line and its fault.
pub(crate) fn run(text: &str) -> Result<Program, String> {
    let mut program = Program::default();
    let mut controller = Controller {
        motion: 0,
        spindle: Spindle::Off,
        s: 0.0,
        feed: 0.0,
        inches: false,
        relative: false,
        at: DVec2::ZERO,
        at32: [[0.0; 2]; 2],
    };
    for (i, line) in text.lines().enumerate() {
        controller.line(line, &mut program).map_err(|e| format!("line {}: {e}: {line}", i + 1))?;
    }
    Ok(program)
}

impl Controller {
    fn line(&mut self, line: &str, program: &mut Program) -> Result<(), String> {
        if program.ended {
            return Err("after the end of the program".into());
        }
        if line.len() > 70 {
            return Err(format!("{} characters", line.len()));
        }
        if line.bytes().any(|b| !(b' '..=b'~').contains(&b) || b"?!~".contains(&b)) {
            return Err("a character the controller acts upon".into());
        }
        let (words, comment) = line.split_once(';').unwrap_or((line, ""));
        if !comment.is_empty() {
            program.events.push(Event::Comment(comment.trim().to_owned()));
        }
        let block = parse(words)?;
        self.execute(&block, program)
    }

    fn execute(&mut self, block: &Block, program: &mut Program) -> Result<(), String> {
        let [x, y, i, j, f, s, p, z] = block.values;
        // The order of execution: feed, power, spindle, dwell, units, distance, motion, end.
        if let Some(f) = f {
            self.feed = f;
        }
        if let Some(s) = s {
            self.s = s;
        }
        if let Some(spindle) = block.spindle {
            self.spindle = spindle;
        }
        if let Some(motion) = block.motion {
            self.motion = motion;
        }
        if block.dwell {
            let seconds = p.ok_or("dwell without P")?;
            let burns = self.spindle == Spindle::Constant && self.motion != 0;
            program.events.push(Event::Dwell { seconds, beam: if burns { self.s } else { 0.0 } });
            return Ok(());
        }
        self.inches = block.inches.unwrap_or(self.inches);
        self.relative = block.relative.unwrap_or(self.relative);
        if z.is_some() && (self.motion != 0 || x.is_some() || y.is_some() || self.s != 0.0) {
            return Err("the head is lowered or raised on the way, or with the beam on".into());
        }
        if x.is_some() || y.is_some() {
            let motion = self.motion(DVec2::new(x.unwrap_or(f64::NAN), y.unwrap_or(f64::NAN)), i, j)?;
            self.at32 = self.arrive32(block, motion.path.arc.map(|(_, sweep)| sweep))?;
            self.at = motion.path.to;
            program.events.push(Event::Motion(motion));
        } else if i.is_some() || j.is_some() || p.is_some() {
            return Err("a value without its command".into());
        }
        program.ended = block.end;
        Ok(())
    }

    fn motion(&self, words: DVec2, i: Option<f64>, j: Option<f64>) -> Result<Motion, String> {
        let unit = if self.inches { 25.4 } else { 1.0 };
        let base = if self.relative { self.at } else { DVec2::ZERO };
        let target = base + words * unit;
        let to = DVec2::new(
            if words.x.is_nan() { self.at.x } else { target.x },
            if words.y.is_nan() { self.at.y } else { target.y },
        );
        let commanded = if self.spindle == Spindle::Off { 0.0 } else { self.s };
        let (path, beam, feed) = match self.motion {
            0 => (Element::line(self.at, to), 0.0, 0.0),
            _ if self.feed <= 0.0 => return Err("motion without feed".into()),
            1 => (Element::line(self.at, to), commanded, self.feed),
            g => {
                if i.is_none() && j.is_none() {
                    return Err("arc without centre".into());
                }
                let offset = DVec2::new(i.unwrap_or(0.0), j.unwrap_or(0.0)) * unit;
                (arc(self.at, to, offset, g == 3), commanded, self.feed)
            }
        };
        if self.motion < 2 && (i.is_some() || j.is_some()) {
            return Err("a centre without an arc".into());
        }
        Ok(Motion { rapid: self.motion == 0, path, beam, commanded, feed })
    }

    /// Where a motion ends in GRBL's numbers, by each way to read them; an error for an arc (of this sweep, rad) that
    /// GRBL would refuse, or run as another one.
    fn arrive32(&self, block: &Block, sweep: Option<f64>) -> Result<[Vec32; 2], String> {
        let unit = if self.inches { 25.4 } else { 1.0 };
        let mut ends = self.at32;
        for ((read, from), end) in READINGS.iter().zip(self.at32).zip(&mut ends) {
            let value = |i: usize| block.values[i].map(|_| read(&block.texts[i]) * unit);
            for axis in 0..2 {
                let base = if self.relative { from[axis] } else { 0.0 };
                end[axis] = value(axis).map_or(from[axis], |v| base + v);
            }
            if let Some(sweep) = sweep {
                let offset = [value(2).unwrap_or(0.0), value(3).unwrap_or(0.0)];
                grbl_arc::check(from, *end, offset, sweep)?;
            }
        }
        Ok(ends)
    }
}

/// An arc, exactly as it is written; anything under 5e-7 rad is a full circle.
fn arc(from: DVec2, to: DVec2, offset: DVec2, ccw: bool) -> Element {
    let center = from + offset;
    let (a, b) = (-offset, to - center);
    let turn = f64::atan2(a.perp_dot(b), a.dot(b));
    let sweep = match ccw {
        true if turn <= 5e-7 => turn + TAU,
        false if turn >= -5e-7 => turn - TAU,
        _ => turn,
    };
    Element { from, to, arc: Some((center, sweep)) }
}

fn parse(words: &str) -> Result<Block, String> {
    let mut block = Block::default();
    for word in words.split_whitespace() {
        let (letter, number) = word.split_at(1);
        let value: f64 = number.parse().map_err(|_| format!("{word} is not a word"))?;
        if number.contains(['e', 'E', 'n', 'N']) || !value.is_finite() {
            return Err(format!("{word} is not a plain number"));
        }
        let repeated = match (letter, number) {
            ("G", "0" | "1" | "2" | "3") => block.motion.replace(value as u8).is_some(),
            ("G", "4") => std::mem::replace(&mut block.dwell, true),
            ("G", "17") => std::mem::replace(&mut block.plane, true),
            ("G", "20" | "21") => block.inches.replace(number == "20").is_some(),
            ("G", "90" | "91") => block.relative.replace(number == "91").is_some(),
            ("G", "91.1") => std::mem::replace(&mut block.arc_mode, true),
            ("G", "94") => std::mem::replace(&mut block.feed_mode, true),
            ("M", "2") => std::mem::replace(&mut block.end, true),
            ("M", "3") => block.spindle.replace(Spindle::Constant).is_some(),
            ("M", "4") => block.spindle.replace(Spindle::Dynamic).is_some(),
            ("M", "5") => block.spindle.replace(Spindle::Off).is_some(),
            (letter, _) => match VALUES.find(letter) {
                Some(at) => {
                    number.clone_into(&mut block.texts[at]);
                    block.values[at].replace(value).is_some()
                }
                None => return Err(format!("unknown word {word}")),
            },
        };
        if repeated {
            return Err(format!("{word} repeats a modal group or value"));
        }
    }
    Ok(block)
}
