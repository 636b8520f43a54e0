//! Motions with the beam off: rapids, lifts, and other heights of the head.

use super::Pen;
use crate::geometry::DVec2;
use crate::machine::Lift;
use crate::number::fixed;
use std::fmt::Write as _;

impl Pen<'_> {
    /// Moves the head from wherever it is to the pen's position, unless the job starts where the head stands.
    pub(in crate::output::gcode) fn find_start(&mut self) {
        if self.start.is_absolute() {
            let line = self.rapid_line(self.at, "");
            self.lines.push(&line);
        }
    }

    /// Moves to a place with the beam off.
    pub(in crate::output::gcode) fn rapid(&mut self, to: DVec2) {
        self.leg(self.rounded(to), None);
        self.wait_owed();
    }

    /// Moves to a place with the beam off and the head lifted: on the way, or before and after it.
    pub(in crate::output::gcode) fn lifted(&mut self, to: DVec2, lift: &Lift) {
        let end = self.rounded(to);
        if self.same(self.at, end) {
            return self.rapid(to);
        }
        if lift.at_rest {
            self.leg(self.at, Some(lift.height));
            self.leg(end, None);
            self.leg(end, Some(0.0));
        } else {
            let middle = ((self.at + end) * 0.5 * self.grid).round() / self.grid;
            self.leg(middle, Some(lift.height));
            self.leg(end, Some(0.0));
        }
        self.wait_owed();
    }

    /// Moves to a rounded place with the beam off, and to a height.
    fn leg(&mut self, to: DVec2, z: Option<f64>) {
        let moves = !self.same(self.at, to) || z.is_some();
        if self.power_in_force != "0" && !self.beam.is_on_motions() {
            self.push_all(self.beam.off_for_motion());
            "0".clone_into(&mut self.power_in_force);
        }
        let height = z.map(|z| self.z_word(z)).unwrap_or_default();
        let mut line = match moves {
            true if self.same(self.at, to) => self.with_feed(format!("G0{height}"), self.z_feed.clone()),
            true => self.rapid_line(to, &height),
            false => String::new(),
        };
        if self.power_in_force != "0" && (moves || self.beam.takes_bare_power()) {
            let _ = write!(line, "{}{}0", if line.is_empty() { "" } else { " " }, self.dialect.power.word);
            "0".clone_into(&mut self.power_in_force);
        }
        if !line.is_empty() {
            self.lines.push(&line);
        }
        self.at = to;
    }

    /// Takes the power back that motions would go on with, by a rapid to where the head is, if the last rapid has not.
    pub(in crate::output::gcode) fn take_power_back(&mut self) {
        if self.power_in_force != "0" {
            let line = self.rapid_line(self.at, &format!(" {}0", self.dialect.power.word));
            self.lines.push(&line);
            "0".clone_into(&mut self.power_in_force);
        }
    }

    /// Moves to a height with the beam off, like every rapid.
    pub(in crate::output::gcode) fn lower_to(&mut self, z: f64) {
        if (self.z - self.rounded_height(z)).abs() >= self.half_grid() {
            self.leg(self.at, Some(z));
        }
    }

    /// The Z word of the next height, which is then the head's. Like places, heights are rounded before their differences.
    fn z_word(&mut self, z: f64) -> String {
        let height = self.rounded_height(z);
        let word = if self.start.is_absolute() { height } else { height - self.z };
        self.z = height;
        format!(" Z{}", fixed(word, self.dialect.decimals.xy as usize))
    }

    /// A height in mm, rounded in units of the file.
    fn rounded_height(&self, z: f64) -> f64 {
        (z / self.dialect.units.mm() * self.grid).round() / self.grid
    }

    fn rapid_line(&mut self, to: DVec2, height: &str) -> String {
        self.with_feed(format!("G0{}{height}", self.xy_words(to)), self.rapid_feed.clone())
    }

    /// A rapid with its feed, if the dialect writes it and another one is in force.
    fn with_feed(&mut self, mut line: String, feed: Option<String>) -> String {
        if let Some(feed) = feed.filter(|feed| *feed != self.feed_in_force) {
            let _ = write!(line, " F{feed}");
            self.feed_in_force = feed;
        }
        line
    }
}
