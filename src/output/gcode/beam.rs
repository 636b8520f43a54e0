//! The commands that switch the beam on and off, for each way of setting the power.
//!
//! Two kinds of controllers. On some, the power is a word on the lines of motions (`S`), and the mode selected in the
//! header lets it through during G1, G2 and G3 only: GRBL's laser mode, Marlin's inline mode, Smoothieware. On the others,
//! the beam is switched by lines of its own before and after each cut, and is on for everything in between.
//!
//! **LinuxCNC's M67** acts with the start of the next motion, so a dwell after it is dark; M68 acts at once.
//!
//! **Marlin's inline mode** counts from the next motion, so a piercing leaves it: `M3 S` without `I` acts at once, after the
//! motions before it have ended.

use crate::machine::dialect::{Dialect, PierceBy, PowerBy};

/// The lines that switch the beam.
pub(super) struct Beam<'d> {
    dialect: &'d Dialect,
}

impl<'d> Beam<'d> {
    pub(super) fn new(dialect: &'d Dialect) -> Self {
        Self { dialect }
    }

    /// Whether the power is a word on the lines of motions.
    pub(super) fn is_on_motions(&self) -> bool {
        use PowerBy::{InlineM3, LaserM3, LaserM4, Motion};
        matches!(self.dialect.power.by, LaserM4 | LaserM3 | InlineM3 | Motion)
    }

    /// Whether the power changes with the motions, without a stop between them.
    pub(super) fn changes_in_motion(&self) -> bool {
        self.is_on_motions() || self.dialect.power.by == PowerBy::OutputM67
    }

    /// Whether a line that holds only a power word is a command: GRBL takes it, Marlin and Smoothieware do not.
    pub(super) fn takes_bare_power(&self) -> bool {
        matches!(self.dialect.power.by, PowerBy::LaserM4 | PowerBy::LaserM3)
    }

    /// Whether the beam can be switched off while the head stands still. An analog output that pierces by creeping has no
    /// M68, so it changes with the next motion only.
    pub(super) fn goes_off_at_rest(&self) -> bool {
        let m68 = self.dialect.pierce.as_ref().is_some_and(|p| p.by == PierceBy::DwellM68);
        self.dialect.power.by != PowerBy::OutputM67 || m68
    }

    /// The lines that switch it on before a cut.
    pub(super) fn on(&self, power: &str) -> Vec<String> {
        let (word, n) = (&self.dialect.power.word, self.output());
        match self.dialect.power.by {
            PowerBy::SpindleM3 => vec![format!("M3 {word}{power}")],
            PowerBy::OutputM67 => vec![format!("M67 E{n} {word}{power}")],
            PowerBy::FanM106 => vec!["M400".into(), format!("M106 P{n} {word}{power}")],
            PowerBy::Macro => filled(&self.dialect.power.on, power, ""),
            _ => Vec::new(),
        }
    }

    /// The lines that switch it off before a rapid.
    pub(super) fn off_for_motion(&self) -> Vec<String> {
        match self.dialect.power.by {
            PowerBy::OutputM67 => vec![format!("M67 E{} {}0", self.output(), self.dialect.power.word)],
            _ => self.off_now(),
        }
    }

    /// The lines that switch it off at once.
    pub(super) fn off_now(&self) -> Vec<String> {
        let (word, n) = (&self.dialect.power.word, self.output());
        match self.dialect.power.by {
            PowerBy::LaserM4 | PowerBy::LaserM3 => vec![format!("M5 {word}0")],
            PowerBy::SpindleM3 | PowerBy::Motion => vec!["M5".into()],
            PowerBy::OutputM67 if self.goes_off_at_rest() => vec![format!("M68 E{n} {word}0")],
            PowerBy::OutputM67 => vec![format!("M67 E{n} {word}0")],
            PowerBy::InlineM3 => vec!["M5 I".into()],
            PowerBy::FanM106 => vec!["M400".into(), format!("M107 P{n}")],
            PowerBy::Macro => filled(&self.dialect.power.off, "", ""),
        }
    }

    fn output(&self) -> u32 {
        self.dialect.power.output.unwrap_or(0)
    }
}

/// Lines of a macro with their values.
pub(super) fn filled(lines: &[String], power: &str, seconds: &str) -> Vec<String> {
    lines.iter().map(|l| l.replace("{power}", power).replace("{seconds}", seconds)).collect()
}
