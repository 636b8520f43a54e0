//! The state of the controller: the rounded position, the feed and the power in force, and the program lines that
//! change them.
//!
//! Coordinates are rounded to 0.001 mm from their absolute values, so errors do not add up. An arc is written in pieces
//! of at most half a turn, as G2 or G3 with I and J: a full circle becomes two halves, because controllers differ on
//! arcs that end where they start. I and J are computed from the rounded ends: the centre is moved onto the
//! perpendicular bisector of the rounded chord, so both radii agree up to the rounding of I and J themselves, 0.0001
//! mm. An arc that coincides with its chord after rounding is written as a line, and an element that rounds to one
//! point is skipped. An arc that the controller might refuse or distort because of its 32-bit numbers is written as
//! chords (`grbl_arc.rs`).
//!
//! Every motion, as written, lies within 0.002 mm of its element.

use super::super::number::fixed;
use super::grbl_arc;
use crate::geometry::{Arc, DVec2, Segment, arcs};
use crate::machine::Start;
use std::f64::consts::PI;
use std::fmt::Write as _;

/// Decimals of X, Y, F, S and P. A micrometre is ten times finer than the step of any such machine.
const DECIMALS: usize = 3;
/// Grid points per mm at these decimals.
const GRID: f64 = 1000.0;
/// Slowest feed that these decimals can express, mm/min.
const SLOWEST: f64 = 1.0 / GRID;
/// Decimals of I and J: one more, so that the two radii of an arc agree to a tenth of the grid.
const CENTER_DECIMALS: usize = 4;
/// An arc flatter than half the grid is a line, mm, because rounding its ends moves it as far.
const MIN_SAGITTA: f64 = 0.5 / GRID;
/// Largest distance between an arc and the chords written for it, mm. With the rounding of their ends, 0.0007 mm, it is
/// less than the 0.002 mm that GRBL itself allows for the chords of an arc.
const CHORD_DEVIATION: f64 = 0.001;

/// Writes the program and keeps track of the state in force.
pub(super) struct Pen {
    program: String,
    /// Whether places are written as they are, or as seen from the one before.
    start: Start,
    /// Rounded position of the head, mm.
    at: DVec2,
    /// Feed for the next cuts, mm/min, and the F word in force.
    feed: String,
    feed_in_force: String,
    /// Power for the next cuts, and the S word in force.
    power: String,
    power_in_force: String,
}

impl Pen {
    /// Starts at `home` with the beam off and an empty program.
    pub(super) fn new(home: DVec2, start: Start) -> Self {
        let dark = || "0".to_owned();
        Self {
            program: String::new(),
            start,
            at: rounded(home),
            feed: String::new(),
            feed_in_force: String::new(),
            power: dark(),
            power_in_force: dark(),
        }
    }

    /// Selects mm, the kind of coordinates, the plane and the kind of feed.
    pub(super) fn select_units(&mut self) {
        let places = if self.start.is_absolute() { "G90" } else { "G91" };
        self.command(&format!("G21 {places} G91.1 G17 G94"));
    }

    /// Moves the head from wherever it is to the pen's position, unless the job starts where the head stands.
    pub(super) fn find_start(&mut self) {
        if self.start.is_absolute() {
            let line = format!("G0{}", XyWords(self.at));
            self.command(&line);
        }
    }

    /// The X and Y words of the next place. Differences of rounded places are as exact as the places, so nothing adds up.
    fn words(&self, to: DVec2) -> XyWords {
        XyWords(if self.start.is_absolute() { to } else { to - self.at })
    }

    /// The whole program, one command per line.
    pub(super) fn into_program(self) -> String {
        self.program
    }

    /// Writes a line unchanged.
    pub(super) fn command(&mut self, line: &str) {
        self.program.push_str(line);
        self.program.push('\n');
    }

    /// Switches the laser off.
    pub(super) fn off(&mut self) {
        self.command("M5 S0");
        "0".clone_into(&mut self.power_in_force);
    }

    /// Sets feed (mm/min) and power (S) for the following cuts. A feed of 0, which GRBL refuses, is never written.
    pub(super) fn set_process(&mut self, feed: f64, power: f64) {
        self.feed = fixed(feed.max(SLOWEST), DECIMALS).to_string();
        self.power = fixed(power, DECIMALS).to_string();
    }

    /// Moves to a place with the beam off.
    pub(super) fn rapid(&mut self, to: DVec2) {
        let to = rounded(to);
        let mut line = String::new();
        if !same(self.at, to) {
            let _ = write!(line, "G0{}", self.words(to));
        }
        if self.power_in_force != "0" {
            line.push_str(if line.is_empty() { "S0" } else { " S0" });
            "0".clone_into(&mut self.power_in_force);
        }
        if !line.is_empty() {
            self.command(&line);
        }
        self.at = to;
    }

    /// Dwells for `seconds` with the beam on; writes nothing if that rounds to 0.
    pub(super) fn pierce(&mut self, seconds: f64) {
        let seconds = fixed(seconds, DECIMALS).to_string();
        if seconds == "0" {
            return;
        }
        let line = format!("G1 M3 S{} F{}", self.power, self.feed);
        self.command(&line);
        self.command(&format!("G4 P{seconds}"));
        self.command("M4");
        self.power_in_force.clone_from(&self.power);
        self.feed_in_force.clone_from(&self.feed);
    }

    /// Dwells for `seconds` with the beam off; writes nothing if that rounds to 0.
    pub(super) fn settle_dark(&mut self, seconds: f64) {
        let seconds = fixed(seconds, DECIMALS).to_string();
        if seconds == "0" {
            return;
        }
        self.command("S0");
        self.command(&format!("G4 P{seconds}"));
        "0".clone_into(&mut self.power_in_force);
    }

    /// Moves along an element with the beam on.
    pub(super) fn cut(&mut self, segment: &Segment) {
        match segment {
            Segment::Line(l) => self.straight(rounded(l.end)),
            Segment::Arc(a) => arcs::split(a, PI).for_each(|piece| self.arc(&piece)),
        }
    }

    fn straight(&mut self, to: DVec2) {
        if !same(self.at, to) {
            self.motion(format!("G1{}", self.words(to)), to);
        }
    }

    fn arc(&mut self, arc: &Arc) {
        let to = rounded(arc.end);
        if same(self.at, to) || arcs::sagitta(arc) <= MIN_SAGITTA {
            return self.straight(to);
        }
        let middle = (self.at + to) * 0.5;
        let across = (to - self.at).perp().normalize_or_zero();
        let offset = middle + across * (arc.center - middle).dot(across) - self.at;
        if !grbl_arc::is_safe(self.at, to, offset) {
            return arcs::flattened(arc, CHORD_DEVIATION).for_each(|end| self.straight(rounded(end)));
        }
        let word = if arc.ccw() { "G3" } else { "G2" };
        let (i, j) = (fixed(offset.x, CENTER_DECIMALS), fixed(offset.y, CENTER_DECIMALS));
        self.motion(format!("{word}{} I{i} J{j}", self.words(to)), to);
    }

    /// Writes a motion with the beam on, with the feed and power words it needs.
    fn motion(&mut self, mut line: String, to: DVec2) {
        if self.feed != self.feed_in_force {
            let _ = write!(line, " F{}", self.feed);
            self.feed_in_force.clone_from(&self.feed);
        }
        if self.power != self.power_in_force {
            let _ = write!(line, " S{}", self.power);
            self.power_in_force.clone_from(&self.power);
        }
        self.command(&line);
        self.at = to;
    }
}

/// The X and Y words of a place.
struct XyWords(DVec2);

impl std::fmt::Display for XyWords {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, " X{} Y{}", fixed(self.0.x, DECIMALS), fixed(self.0.y, DECIMALS))
    }
}

fn rounded(p: DVec2) -> DVec2 {
    (p * GRID).round() / GRID
}

/// Whether two rounded places are the same.
fn same(a: DVec2, b: DVec2) -> bool {
    (a - b).abs().max_element() < MIN_SAGITTA
}
