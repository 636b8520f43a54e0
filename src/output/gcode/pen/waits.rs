//! Waits: with the beam on, which pierce, and with the beam off.

use super::super::beam::filled;
use super::{INLINE_DARK, Pen};
use crate::machine::dialect::{Pierce, PierceBy, PowerBy};
use crate::number::fixed;

impl Pen<'_> {
    /// Dwells for `seconds` with the beam on; writes nothing if that rounds to 0.
    pub(in crate::output::gcode) fn pierce(&mut self, pierce: &Pierce, seconds: f64) {
        if self.dwell_text(seconds).is_none() {
            return;
        }
        let [power, feed, word] = [&self.power, &self.feed, &self.dialect.power.word].map(Clone::clone);
        match pierce.by {
            PierceBy::DwellM3 => {
                self.lines.push(&format!("G1 M3 {word}{power} F{feed}"));
                self.dwell(seconds);
                if self.dialect.power.by == PowerBy::LaserM4 {
                    self.lines.push("M4");
                }
                self.feed_in_force = feed;
            }
            PierceBy::DwellM68 => {
                self.lines.push(&format!("M68 E{} {word}{power}", self.dialect.power.output.unwrap_or(0)));
                self.dwell(seconds);
            }
            PierceBy::DwellStandard if self.dialect.power.by == PowerBy::InlineM3 => {
                self.lines.push("M5 I");
                self.lines.push(&format!("M3 {word}{power}"));
                self.dwell(seconds);
                self.lines.push("M5");
                self.lines.push(INLINE_DARK);
                "0".clone_into(&mut self.power_in_force);
                return;
            }
            PierceBy::DwellStandard => {
                self.push_all(self.beam.on(&power));
                self.dwell(seconds);
            }
            PierceBy::Macro => {
                let seconds = fixed(seconds, 3).to_string();
                self.push_all(filled(&pierce.lines, &power, &seconds));
            }
            PierceBy::Creep => return,
        }
        self.power_in_force = power;
    }

    /// Dwells for `seconds` with the beam off; writes nothing if that rounds to 0.
    pub(in crate::output::gcode) fn settle_dark(&mut self, seconds: f64) {
        if self.dwell_text(seconds).is_none() {
            return;
        }
        if !self.beam.goes_off_at_rest() {
            // With the next motion the beam is off.
            self.owed += seconds;
            return;
        }
        match self.dialect.power.by {
            PowerBy::LaserM4 | PowerBy::LaserM3 => self.lines.push(&format!("{}0", self.dialect.power.word)),
            // Dark at rest by itself; the S of the motions stays in force.
            PowerBy::Motion => return self.dwell(seconds),
            _ => self.push_all(self.beam.off_now()),
        }
        self.dwell(seconds);
        if self.dialect.power.by == PowerBy::InlineM3 {
            self.lines.push(INLINE_DARK);
        }
        "0".clone_into(&mut self.power_in_force);
    }

    /// Dwells for `seconds` after a rapid, which is dark, or where the beam goes off at rest.
    pub(in crate::output::gcode) fn wait(&mut self, seconds: f64) {
        if self.beam.goes_off_at_rest() {
            self.settle_dark(seconds);
        } else {
            self.dwell(seconds);
        }
    }

    pub(super) fn wait_owed(&mut self) {
        let owed = std::mem::take(&mut self.owed);
        self.dwell(owed);
    }

    fn dwell(&mut self, seconds: f64) {
        if let Some(text) = self.dwell_text(seconds) {
            self.lines.push(&text);
        }
    }

    /// The line of a dwell; `None` if it rounds to 0 or the dialect has no dwell.
    fn dwell_text(&self, seconds: f64) -> Option<String> {
        // A macro that pierces gets the seconds as a value, whether the dialect has a dwell or not.
        let Some(dwell) = &self.dialect.dwell else { return (seconds > 0.0).then(String::new) };
        let time = fixed(seconds * dwell.unit.per_second(), dwell.decimals as usize).to_string();
        (time != "0").then(|| format!("G4 {}{time}", dwell.word))
    }
}
