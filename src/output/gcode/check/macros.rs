//! The macros of a dialect in a program: the lines of its own that switch the beam and the air, and those that pierce.
//!
//! A macro is recognised by all of its lines in order, and it acts with the last one. Its values may be in any of them: some
//! controllers take them as arguments (`M98 P9001 S80`), others as variables before the call (`#500=80`).

use super::words;
use crate::machine::dialect::{Dialect, PowerBy};

/// What a macro does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Does {
    /// Sets the power of the beam, 0 for off.
    Sets(f64),
    /// Sets the power and waits, s.
    Pierces(f64, f64),
}

/// The macros of a dialect, and how far they have been followed.
#[derive(Debug)]
pub(super) struct Macros {
    on: Followed,
    pierce: Followed,
    off: Vec<String>,
    air: Vec<String>,
}

impl Macros {
    pub(super) fn new(dialect: &Dialect) -> Self {
        let of = |lines: &[String]| match dialect.power.by {
            PowerBy::Macro => words::commands(lines),
            _ => Vec::new(),
        };
        let air = dialect.air.iter().flat_map(|air| [air.on.clone(), air.off.clone()]);
        Self {
            on: Followed::new(of(&dialect.power.on)),
            pierce: Followed::new(of(dialect.pierce.as_ref().map_or(&[], |p| &p.lines))),
            off: of(&dialect.power.off),
            air: words::commands(&air.collect::<Vec<_>>()),
        }
    }

    /// What the macro does that ends with this command. A macro without a power in its lines sets it to 1.
    pub(super) fn line(&mut self, command: &str) -> Option<Does> {
        let (on, pierce) = (self.on.line(command), self.pierce.line(command));
        if let Some([power, seconds]) = pierce {
            return Some(Does::Pierces(power.unwrap_or(1.0), seconds.unwrap_or(0.0)));
        }
        if let Some([power, _]) = on {
            return Some(Does::Sets(power.unwrap_or(1.0)));
        }
        self.off.iter().any(|line| line == command).then_some(Does::Sets(0.0))
    }

    /// Whether a command is a line of a macro, or switches the air: the controller knows it, whatever it looks like.
    pub(super) fn hold(&self, command: &str) -> bool {
        let values = self.on.lines.iter().chain(&self.pierce.lines);
        values.chain(&self.air).any(|line| matched(line, command).is_some())
    }
}

/// The lines of a macro.
#[derive(Debug)]
struct Followed {
    lines: Vec<String>,
    /// Number of its lines that the last commands were, and their power and seconds.
    count: usize,
    values: [Option<f64>; 2],
}

impl Followed {
    fn new(lines: Vec<String>) -> Self {
        Self { lines, count: 0, values: [None; 2] }
    }

    /// The power and seconds of the macro if it ends with this command.
    fn line(&mut self, command: &str) -> Option<[Option<f64>; 2]> {
        let found = |count: usize| matched(self.lines.get(count)?, command).map(|values| (count, values));
        let Some((count, [power, seconds])) = found(self.count).or_else(|| found(0)) else {
            self.count = 0;
            return None;
        };
        let before = if count > 0 { self.values } else { [None; 2] };
        self.values = [power.or(before[0]), seconds.or(before[1])];
        self.count = (count + 1) % self.lines.len();
        (self.count == 0).then_some(self.values)
    }
}

/// The values of `{power}` and `{seconds}` if a command is written after this template.
fn matched(template: &str, command: &str) -> Option<[Option<f64>; 2]> {
    let mut values = [None, None];
    let (mut template, mut rest) = (template, command);
    while let Some((before, open)) = template.split_once('{') {
        let (name, after) = open.split_once('}')?;
        rest = rest.strip_prefix(before)?;
        let end = rest.find(|c: char| !matches!(c, '0'..='9' | '.' | '-')).unwrap_or(rest.len());
        let value = words::number(&rest[..end])?;
        match name {
            "power" => values[0] = Some(value),
            "seconds" => values[1] = Some(value),
            _ => {}
        }
        rest = &rest[end..];
        template = after;
    }
    (rest == template).then_some(values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::dialect::dialect;

    #[test]
    fn a_macro_is_all_of_its_lines_in_order() {
        let lines = |list: &[&str]| list.iter().map(|l| (*l).to_owned()).collect::<Vec<_>>();
        let mut template = dialect("template").unwrap();
        template.power.on = lines(&["M98 P1 S{power}"]);
        template.pierce.as_mut().unwrap().lines = lines(&["M98 P1 S{power} (beam on)", "", "G4 P{seconds}"]);
        let mut macros = Macros::new(&template);
        let mut does = |command: &str| macros.line(command);
        assert_eq!(does("M98 P1 S80"), Some(Does::Sets(80.0)));
        assert_eq!(does("G4 P0.5"), Some(Does::Pierces(80.0, 0.5)));
        // A wait alone is no piercing.
        assert_eq!(does("G4 P0.5"), None);
        assert_eq!(does("M98 P1 S80"), Some(Does::Sets(80.0)));
        assert_eq!(does("G1 X1"), None);
        assert_eq!(does("G4 P0.5"), None);
        assert_eq!(does("M98 P9002"), Some(Does::Sets(0.0)));
        assert!(macros.hold("G4 P2") && macros.hold("M98 P9004") && !macros.hold("G1 X1"));
    }
}
