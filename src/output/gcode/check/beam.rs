//! What the beam does under a controller's rules: after every command, whether and how strongly it is on.

use super::words::Line;
use crate::machine::dialect::{Dialect, PowerBy};

#[derive(Clone, Copy, Debug, PartialEq, Default)]
enum Spindle {
    #[default]
    Off,
    Constant,
    Dynamic,
}

/// The state of the beam's controls.
#[derive(Debug)]
pub(super) struct Beam<'d> {
    dialect: &'d Dialect,
    spindle: Spindle,
    /// S in force.
    s: f64,
    /// Marlin's inline mode.
    inline: bool,
    /// Power of the analog output, the fan or the macro.
    level: f64,
    /// Power that M67 sets with the next motion.
    pending: Option<f64>,
}

/// Power while the head moves or stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Power {
    /// What the beam burns with.
    pub(super) lit: f64,
    /// What the program has asked for, whether the controller lets it through or not.
    pub(super) asked: f64,
}

impl<'d> Beam<'d> {
    pub(super) fn new(dialect: &'d Dialect) -> Self {
        Self { dialect, spindle: Spindle::Off, s: 0.0, inline: false, level: 0.0, pending: None }
    }

    /// Carries out the commands of a line that concern the beam. Returns the powers it sets.
    pub(super) fn line(&mut self, line: &Line) -> Vec<f64> {
        let by = self.dialect.power.by;
        let s = line.value('S');
        let on = line.codes('M').any(|m| m == 30) || line.codes('M').any(|m| m == 40);
        let off = line.codes('M').any(|m| m == 50);
        let dynamic = line.codes('M').any(|m| m == 40);
        let waits = line.codes('G').any(|g| g == 40);
        let mut set = Vec::new();
        match by {
            PowerBy::OutputM67 => {
                let ours = self.is_ours(line.value('E'));
                if let (true, Some(q)) = (ours, line.value('Q')) {
                    if line.codes('M').any(|m| m == 670) {
                        self.pending = Some(q);
                        set.push(q);
                    } else if line.codes('M').any(|m| m == 680) {
                        (self.level, self.pending) = (q, None);
                        set.push(q);
                    }
                }
            }
            PowerBy::FanM106 => {
                if self.is_ours(line.value('P')) {
                    if line.codes('M').any(|m| m == 1060) {
                        self.level = s.unwrap_or(255.0);
                        set.push(self.level);
                    } else if line.codes('M').any(|m| m == 1070) {
                        self.level = 0.0;
                    }
                }
            }
            PowerBy::Macro => {}
            PowerBy::LaserM4
            | PowerBy::LaserM3
            | PowerBy::SpindleM3
            | PowerBy::InlineM3
            | PowerBy::Motion => {
                // S after G4 is a time where the dialect says so.
                if let Some(s) = s.filter(|_| !waits) {
                    self.s = s;
                    set.push(s);
                }
                if on {
                    self.spindle = if dynamic { Spindle::Dynamic } else { Spindle::Constant };
                    self.inline = line.has('I');
                    // Marlin: the power of the inline mode counts from the next motion on.
                    if self.inline && s.is_none() {
                        self.s = 0.0;
                    }
                } else if off {
                    self.spindle = Spindle::Off;
                    self.inline = false;
                }
            }
        }
        set
    }

    /// Whether this is the number of the dialect's output.
    fn is_ours(&self, number: Option<f64>) -> bool {
        (number.unwrap_or(0.0) - f64::from(self.dialect.power.output.unwrap_or(0))).abs() < 0.5
    }

    /// A macro of the dialect has switched the beam.
    pub(super) fn macro_sets(&mut self, power: f64) {
        self.level = power;
    }

    /// The power of a motion, rapid or not, which begins now.
    pub(super) fn moving(&mut self, rapid: bool) -> Power {
        let Dialect { power, rapids_dark, .. } = self.dialect;
        if let Some(q) = self.pending.take() {
            self.level = q;
        }
        let asked = match power.by {
            PowerBy::LaserM4 | PowerBy::LaserM3 | PowerBy::SpindleM3 | PowerBy::InlineM3 => {
                if self.spindle == Spindle::Off { 0.0 } else { self.s }
            }
            PowerBy::Motion => self.s,
            PowerBy::OutputM67 | PowerBy::FanM106 | PowerBy::Macro => self.level,
        };
        // Marlin: from 2.0.9.4 on a rapid takes the inline power back; before, it keeps it.
        if rapid && self.inline {
            self.s = 0.0;
        }
        Power { lit: if rapid && *rapids_dark { 0.0 } else { asked }, asked }
    }

    /// The power while the head stands; `cutting`: the motion mode is G1, G2 or G3.
    pub(super) fn standing(&self, cutting: bool) -> Power {
        let asked = match self.dialect.power.by {
            PowerBy::LaserM4 | PowerBy::LaserM3 | PowerBy::SpindleM3 | PowerBy::InlineM3
                if self.spindle == Spindle::Off =>
            {
                0.0
            }
            PowerBy::LaserM4 | PowerBy::LaserM3 | PowerBy::SpindleM3 | PowerBy::InlineM3 => self.s,
            // Nothing is asked for at rest: the power of a motion stays in force.
            PowerBy::Motion => 0.0,
            PowerBy::OutputM67 => self.pending.unwrap_or(self.level),
            PowerBy::FanM106 | PowerBy::Macro => self.level,
        };
        let lit = match self.dialect.power.by {
            PowerBy::LaserM4 | PowerBy::LaserM3 if !(cutting && self.spindle == Spindle::Constant) => 0.0,
            PowerBy::InlineM3 if self.inline => 0.0,
            PowerBy::OutputM67 => self.level,
            _ => asked,
        };
        Power { lit, asked }
    }

    /// Whether anything could still light the beam.
    pub(super) fn is_off(&self) -> bool {
        let level = self.pending.map_or(self.level, |q| q.max(self.level));
        match self.dialect.power.by {
            PowerBy::LaserM4 | PowerBy::LaserM3 | PowerBy::SpindleM3 | PowerBy::InlineM3 => {
                self.spindle == Spindle::Off
            }
            // It fires during motions only, and the next one would have this power.
            PowerBy::Motion => self.s == 0.0,
            PowerBy::OutputM67 | PowerBy::FanM106 | PowerBy::Macro => level == 0.0,
        }
    }
}
