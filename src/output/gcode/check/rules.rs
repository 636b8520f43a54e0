//! What every motion of a program must keep to: the rules of the controllers, and those of its machine.

use super::beam::Power;
use super::expected::Expected;
use super::problem::{Code, Problems};
use super::program::{Event, Program};
use crate::finding::Severity;
use crate::geometry::DVec2;
use crate::machine::Profile;
use crate::machine::dialect::Dialect;
use crate::number::{fixed, power_of_ten};

/// Piercings of one wait: a plan may pierce a few times at one place.
const PIERCES_AT_ONCE: u32 = 4;

/// The rules about beam, power, feed and waits, motion by motion.
pub(super) fn beam(
    program: &Program,
    dialect: &Dialect,
    profile: &Profile,
    expected: &Expected,
    problems: &mut Problems,
) {
    let full = dialect.power.full_or(profile.max_s);
    // Half of the last decimal is rounding.
    let slack = 0.5 / power_of_ten(dialect.power.decimals);
    for &(line, power) in &program.powers {
        if !(0.0..=full + slack).contains(&power) {
            problems.error(Code::PowerOutOfRange, Some(line), || {
                format!("Line {line} sets the power {power}; it goes from 0 to {full} on this machine.")
            });
        }
    }
    let mut rules = Rules { dialect, profile, expected, fastest: profile.top_speed(), problems };
    // Contours since the last wait. Where the beam goes off with the next motion only, contours that follow each other
    // without a rapid leave their waits to the rapid after them.
    let mut contours = 0_u32;
    for event in &program.events {
        match event {
            Event::Height { line, power, .. } => rules.dark(*line, power, None),
            Event::Move { line, rapid: true, path, power, .. } => rules.dark(*line, power, Some(path.end())),
            Event::Move { line, path, power, feed, lifted, .. } => {
                rules.cut(*line, path.length() > 0.0 && power.lit <= 0.0, *lifted && power.lit > 0.0, *feed);
            }
            Event::Dwell { line, seconds, .. } => {
                rules.wait(*line, *seconds, std::mem::take(&mut contours).max(1));
            }
            Event::Contour { .. } => contours = contours.saturating_add(1),
        }
    }
}

struct Rules<'a> {
    dialect: &'a Dialect,
    profile: &'a Profile,
    expected: &'a Expected,
    /// mm/s.
    fastest: f64,
    problems: &'a mut Problems,
}

impl Rules<'_> {
    /// What is certainly wrong in a program of Kerfway's, and may be meant in another one.
    fn doubtful(&self) -> Severity {
        if self.expected.by_kerfway { Severity::Error } else { Severity::Warning }
    }

    /// A motion that is made with the beam off: a rapid to a place, or to another height.
    fn dark(&mut self, line: u32, power: &Power, to: Option<DVec2>) {
        if power.lit > 0.0 {
            self.problems.error(Code::BeamOnRapid, Some(line), || {
                let to = to.map_or("to another height".into(), |to| format!("to {:.3}, {:.3}", to.x, to.y));
                format!("Line {line} is a rapid {to} with the beam on, at power {}.", power.lit)
            });
        } else if power.asked > 0.0 {
            self.problems.add(Code::PowerOnRapid, self.doubtful(), Some(line), || {
                format!(
                    "Line {line} is a rapid with the power {} in force: only {} itself keeps the beam off, if it is set up for that.",
                    power.asked, self.dialect.controller
                )
            });
        }
    }

    /// A cut. `dark`: it has a length, and the beam is off; `lifted`: the beam is on, and the head lifted; `feed`: mm/s.
    fn cut(&mut self, line: u32, dark: bool, lifted: bool, feed: f64) {
        let strict = self.expected.by_kerfway;
        if dark && strict && self.expected.dark_length <= 0.0 {
            self.problems
                .error(Code::DarkCut, Some(line), || format!("Line {line} is a cut with the beam off."));
        }
        if lifted && strict {
            self.problems
                .error(Code::LiftedCut, Some(line), || format!("Line {line} cuts with the head lifted."));
        }
        if feed > self.fastest * 1.001 {
            self.problems.add(Code::FeedOutOfRange, self.doubtful(), Some(line), || {
                format!(
                    "Line {line} cuts with {:.0} mm/min; this machine moves with at most {:.0}.",
                    feed * 60.0,
                    self.fastest * 60.0
                )
            });
        }
    }

    /// A wait of Kerfway's is one that the machine asks for after this many contours; of others, one that a laser may ask
    /// for.
    fn wait(&mut self, line: u32, seconds: f64, contours: u32) {
        const LONGEST: f64 = 600.0;
        // Of the shortest waits, without what dividing milliseconds by 1000 adds.
        const DIGITS: usize = 9;
        let (dialect, profile) = (self.dialect, self.profile);
        let rounding =
            dialect.dwell.as_ref().map_or(1e-3, |d| 0.5 / power_of_ten(d.decimals) / d.unit.per_second());
        let near = |wanted: f64| wanted > 0.0 && (seconds - wanted).abs() <= rounding + 1e-9;
        let pierces =
            (0..=PIERCES_AT_ONCE).map(|k| f64::from(k) * profile.pierce_time + profile.beam_on_delay);
        let settles = (1..=contours).any(|k| near(f64::from(k) * profile.beam_off_delay));
        let cools =
            profile.levers.heat.is_some_and(|h| h.charge.is_none() && seconds <= h.seconds + rounding);
        let of_machine = settles || cools || near(profile.macro_time()) || pierces.into_iter().any(near);
        if (self.expected.by_kerfway && !of_machine) || !(0.0..=LONGEST).contains(&seconds) {
            self.problems.error(Code::WaitOutOfRange, Some(line), || {
                format!(
                    "Line {line} waits {} s; this machine pierces in {} s. Look at the unit of the wait (seconds or milliseconds).",
                    fixed(seconds, DIGITS),
                    fixed(profile.pierce_time + profile.beam_on_delay, DIGITS)
                )
            });
        }
    }
}
