//! The state of the controller: the rounded position, the feed and the power in force, and the program lines that
//! change them.
//!
//! Coordinates are rounded to the dialect's decimals from their absolute values, so errors do not add up. An arc is
//! written in pieces of at most half a turn, as G2 or G3 with I and J: a full circle becomes two halves, because
//! controllers differ on arcs that end where they start. I and J are computed from the rounded ends: the centre is moved
//! onto the perpendicular bisector of the rounded chord, so both radii agree up to the rounding of I and J themselves. An
//! arc that coincides with its chord after rounding is written as a line, and an element that rounds to one point is
//! skipped. So is an element shorter than a step of the grid within a cut, and a place between short lines that a longer line
//! passes within half a step: rounding would turn them into other directions, and the controller would slow down for corners that
//! nobody drew. An arc that a controller might refuse or distort, because of its 32-bit numbers or because I and J have few
//! decimals, is written as chords (`grbl_arc.rs`), as is every arc in a dialect without arcs.
//!
//! Every motion, as written, lies within 0.002 mm of its element, or within the dialect's tolerance of chords.

mod rapids;
mod waits;

use super::super::process::CutProcess;
use super::beam::Beam;
use super::facts::Facts;
use super::grbl_arc;
use super::text::Lines;
use crate::geometry::{Arc, DVec2, Segment, arcs};
use crate::machine::dialect::{Dialect, PowerBy};
use crate::machine::{Profile, Start};
use crate::number::{fixed, power_of_ten};
use std::f64::consts::PI;
use std::fmt::Write as _;

/// Switches Marlin's inline power on, with nothing to burn with yet: up to 2.0.9.3, `M3 I` without S is 80 % of full power.
const INLINE_DARK: &str = "M3 I S0";

/// Largest distance between an arc and the chords written for it in a dialect with arcs, mm. With the rounding of their
/// ends, 0.0007 mm, it is less than the 0.002 mm that GRBL itself allows for the chords of an arc.
const CHORD_DEVIATION: f64 = 0.001;
/// Lines of fewer steps of the grid are short: rounding turns longer ones by 2 degrees at most.
const SHORT: f64 = 40.0;
/// Share of a dialect's tolerance that chords take; the rest is for the rounding of their ends.
const CHORD_SHARE: f64 = 0.5;

/// Writes the program and keeps track of the state in force.
pub(super) struct Pen<'d> {
    dialect: &'d Dialect,
    /// Whether places are written as they are, or as seen from the one before.
    start: Start,
    beam: Beam<'d>,
    pub(super) lines: Lines<'d>,
    /// Points of the coordinate grid in one unit of the file.
    grid: f64,
    /// Power value at full power.
    full: f64,
    /// Feeds of rapids and of moves of the height alone in units of the file a minute, if the dialect writes them.
    rapid_feed: Option<String>,
    z_feed: Option<String>,
    /// Rounded position of the head, in units of the file.
    at: DVec2,
    /// Feed for the next cuts, and the F word in force.
    feed: String,
    feed_in_force: String,
    /// Power for the next cuts, and the power in force.
    power: String,
    power_in_force: String,
    /// A wait that the controller can make dark only after its next motion, s.
    owed: f64,
    /// Rounded height of the head, in units of the file.
    z: f64,
    air: bool,
}

impl<'d> Pen<'d> {
    /// Starts at the machine's home with the beam off and an empty program. `rapid`: speed of rapids, mm/s.
    pub(super) fn new(dialect: &'d Dialect, machine: &Profile, rapid: f64, start: Start) -> Self {
        let dark = || "0".to_owned();
        let mut pen = Self {
            dialect,
            start,
            beam: Beam::new(dialect),
            lines: Lines::new(dialect),
            grid: power_of_ten(dialect.decimals.xy),
            full: dialect.power.full_or(machine.max_s),
            rapid_feed: None,
            z_feed: None,
            at: DVec2::ZERO,
            feed: String::new(),
            feed_in_force: String::new(),
            power: dark(),
            power_in_force: dark(),
            owed: 0.0,
            z: 0.0,
            air: false,
        };
        pen.at = pen.rounded(machine.home());
        if dialect.rapid_feed {
            pen.rapid_feed = Some(pen.feed_word(rapid));
            pen.z_feed = machine.z_speed.map(|speed| pen.feed_word(speed));
        }
        pen
    }

    /// Writes the lines of the dialect's header. A job that starts where the head stands selects G91 instead of G90.
    pub(super) fn header(&mut self, facts: &Facts) {
        for line in &self.dialect.header {
            if self.start.is_absolute() || line.starts_with(';') {
                self.lines.push_template(line, facts);
            } else {
                self.lines.push_template(&relative(line), facts);
            }
        }
    }

    /// Writes the lines of the dialect's footer, in absolute coordinates again.
    pub(super) fn footer(&mut self, facts: &Facts) {
        if !self.start.is_absolute() {
            self.lines.push("G90");
        }
        for line in &self.dialect.footer {
            self.lines.push_template(line, facts);
        }
    }

    /// Switches the beam off, and the air with it.
    pub(super) fn off(&mut self) {
        self.push_all(self.beam.off_now());
        // The S of Smoothieware's motions stays in force, and the next rapid sets it to 0.
        if self.dialect.power.by != PowerBy::Motion {
            "0".clone_into(&mut self.power_in_force);
        }
        self.set_air(false);
        self.lower_to(0.0);
    }

    /// Sets how the following cuts are made. The beam is off. A feed of 0, which controllers refuse, is never written.
    pub(super) fn set_process(&mut self, process: &CutProcess) {
        self.feed = self.feed_word(process.speed);
        self.power = fixed(process.power * self.full, self.dialect.power.decimals as usize).to_string();
        self.set_air(process.air);
        self.lower_to(process.z);
    }

    /// Moves along the elements of a cut with the beam on.
    pub(super) fn cut(&mut self, path: &[Segment]) {
        let mut passed: Vec<DVec2> = Vec::new();
        for (segment, next) in path.iter().zip(path.iter().skip(1)) {
            passed.push(segment.end());
            if !self.is_within_a_step(segment) && !self.passes(&passed, segment, next) {
                self.element(segment);
                passed.clear();
            }
        }
        path.last().into_iter().for_each(|last| self.element(last));
    }

    fn element(&mut self, segment: &Segment) {
        match segment {
            Segment::Line(l) => self.straight(self.rounded(l.end)),
            Segment::Arc(a) => match self.dialect.chords {
                Some(tolerance) => self.chords(a, tolerance * CHORD_SHARE),
                None => arcs::split(a, PI).for_each(|piece| self.arc(&piece)),
            },
        }
    }

    /// Runs along elements as if it cut, with the power at 0.
    pub(super) fn run_dark(&mut self, path: &[Segment]) {
        let power = std::mem::replace(&mut self.power, "0".to_owned());
        self.cut(path);
        self.power = power;
    }

    /// The F word for a speed in mm/s.
    pub(super) fn feed_word(&self, speed: f64) -> String {
        let decimals = self.dialect.decimals.feed;
        let feed = speed * 60.0 / self.dialect.units.mm();
        fixed(feed.max(1.0 / power_of_ten(decimals)), decimals as usize).to_string()
    }

    /// Sets the feed of the next motions to that of a speed in mm/s.
    pub(super) fn set_speed(&mut self, speed: f64) {
        self.feed = self.feed_word(speed);
    }

    fn chords(&mut self, arc: &Arc, deviation: f64) {
        arcs::flattened(arc, deviation).for_each(|end| self.straight(self.rounded(end)));
    }

    fn straight(&mut self, to: DVec2) {
        if !self.same(self.at, to) {
            self.motion(format!("G1{}", self.xy_words(to)), to);
        }
    }

    fn arc(&mut self, arc: &Arc) {
        let (unit, to) = (self.dialect.units.mm(), self.rounded(arc.end));
        // An arc flatter than half the grid is a line, because rounding its ends moves it as far.
        if self.same(self.at, to) || arcs::sagitta(arc) <= self.half_grid() * unit {
            return self.straight(to);
        }
        let middle = (self.at + to) * 0.5;
        let across = (to - self.at).perp().normalize_or_zero();
        let decimals = self.dialect.decimals.ij;
        let exact = middle + across * (arc.center / unit - middle).dot(across) - self.at;
        let offset = (exact * power_of_ten(decimals)).round() / power_of_ten(decimals);
        if !grbl_arc::is_safe(self.at * unit, to * unit, offset * unit) {
            return self.chords(arc, CHORD_DEVIATION);
        }
        let word = if arc.ccw() { "G3" } else { "G2" };
        let [i, j] = [offset.x, offset.y].map(|v| fixed(v, decimals as usize));
        self.motion(format!("{word}{} I{i} J{j}", self.xy_words(to)), to);
    }

    /// Writes a motion with the beam on, with the feed and power words it needs.
    fn motion(&mut self, mut line: String, to: DVec2) {
        if self.feed != self.feed_in_force {
            let _ = write!(line, " F{}", self.feed);
            self.feed_in_force.clone_from(&self.feed);
        }
        if self.power != self.power_in_force {
            if self.beam.is_on_motions() {
                let _ = write!(line, " {}{}", self.dialect.power.word, self.power);
            } else {
                self.push_all(self.beam.on(&self.power));
            }
            self.power_in_force.clone_from(&self.power);
        }
        self.lines.push(&line);
        self.at = to;
    }

    fn set_air(&mut self, on: bool) {
        if self.air == on {
            return;
        }
        if let Some(air) = &self.dialect.air {
            self.lines.push(if on { &air.on } else { &air.off });
        }
        self.air = on;
    }

    fn push_all(&mut self, lines: Vec<String>) {
        for line in lines {
            self.lines.push(&line);
        }
    }

    /// The X and Y words of the next place. Differences of rounded places are as exact as the places, so nothing adds up.
    fn xy_words(&self, to: DVec2) -> String {
        let to = if self.start.is_absolute() { to } else { to - self.at };
        let decimals = self.dialect.decimals.xy as usize;
        format!(" X{} Y{}", fixed(to.x, decimals), fixed(to.y, decimals))
    }

    /// A place in mm, rounded in units of the file.
    fn rounded(&self, p: DVec2) -> DVec2 {
        (p / self.dialect.units.mm() * self.grid).round() / self.grid
    }

    /// A step of the grid, mm.
    fn step(&self) -> f64 {
        self.dialect.units.mm() / self.grid
    }

    /// Where the head is, mm.
    fn head(&self) -> DVec2 {
        self.at * self.dialect.units.mm()
    }

    /// Whether an element is shorter than a step of the grid and ends within one of where the head is, so that several in a row
    /// are not lost.
    fn is_within_a_step(&self, segment: &Segment) -> bool {
        segment.length() < self.step() && segment.end().distance(self.head()) < self.step()
    }

    /// Whether a short line from where the head is to the end of the next line passes these places, the last of which is between
    /// the two lines.
    fn passes(&self, places: &[DVec2], line: &Segment, next: &Segment) -> bool {
        let (Segment::Line(_), Segment::Line(_)) = (line, next) else { return false };
        let step = self.step();
        let whole = Segment::line(self.head(), next.end());
        whole.length() < SHORT * step && places.iter().all(|p| whole.nearest(*p).1.sqrt() <= 0.5 * step)
    }

    fn half_grid(&self) -> f64 {
        0.5 / self.grid
    }

    /// Whether two rounded places are the same.
    fn same(&self, a: DVec2, b: DVec2) -> bool {
        (a - b).abs().max_element() < self.half_grid()
    }
}

/// A line of a header with G91 for G90, but not for G90.1; blanks between words may be missing.
fn relative(line: &str) -> String {
    let mut words = line.split("G90");
    let first = words.next().unwrap_or_default().to_owned();
    words.fold(first, |line, after| {
        let is_g90 = !after.starts_with(|c: char| c == '.' || c.is_ascii_digit());
        line + if is_g90 { "G91" } else { "G90" } + after
    })
}
