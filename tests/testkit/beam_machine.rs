//! Controllers on paper: what the head and the beam of each do with a program, from their manuals (CAM facts in
//! `docs/machines`). Shares no code with the writer nor with the reader of the product, and is strict: a word that it does
//! not know is an error.

#![allow(
    clippy::disallowed_methods,
    clippy::unwrap_used,
    reason = "arithmetic of its own; a test fails by panicking"
)]

use crate::testkit::paths::Element;
use glam::DVec2;
use std::f64::consts::TAU;

/// The rules by which a program is run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Controller {
    /// GRBL 1.1 and grblHAL in laser mode: G0 is dark, M3 burns at rest in G1 only, M4 never does.
    Grbl,
    /// FluidNC: as GRBL, but G0 under M3 or M4 was not dark in versions of 2022.
    FluidNc,
    /// LinuxCNC with the beam on the spindle: on whenever M3 is in force, whatever moves.
    LinuxCncSpindle,
    /// LinuxCNC and Mach4 with the beam on analog output 0. M67 counts from the next motion, M68 at once; Mach4 is not
    /// trusted with M68.
    Analog { m68: bool },
    /// Marlin: `M3 I` counts from the next motion, `M3` at once; G0 is dark in inline mode. One command a line; G0 runs
    /// with the feed in force.
    MarlinInline,
    /// Marlin with the laser on a fan output.
    MarlinFan,
    /// Smoothieware: the beam fires during G1, G2 and G3 only.
    Smoothie,
    /// The macros of the shipped template.
    Template,
}

impl Controller {
    pub(crate) fn of(dialect: &str) -> Self {
        match dialect {
            "grbl-m4" | "grbl-m3" | "grblhal" => Self::Grbl,
            "fluidnc" => Self::FluidNc,
            "linuxcnc-m67" => Self::Analog { m68: true },
            "linuxcnc-spindle" => Self::LinuxCncSpindle,
            "marlin-inline" => Self::MarlinInline,
            "marlin-fan" => Self::MarlinFan,
            "smoothie" => Self::Smoothie,
            "mach4-m67" => Self::Analog { m68: false },
            "template" => Self::Template,
            other => panic!("no controller for the dialect {other}"),
        }
    }

    fn is_marlin(self) -> bool {
        matches!(self, Self::MarlinInline | Self::MarlinFan)
    }

    /// Seconds of a dwell, from its words P, S and X.
    fn seconds(self, p: Option<f64>, s: Option<f64>) -> f64 {
        match self {
            Self::MarlinInline | Self::MarlinFan => s.unwrap_or(p.unwrap_or(0.0) / 1000.0),
            Self::Smoothie => s.unwrap_or(p.unwrap_or(0.0) / 1000.0),
            Self::Template => p.unwrap_or(0.0) / 1000.0,
            _ => p.unwrap_or(f64::NAN),
        }
    }
}

/// What happens, in order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Step {
    Move {
        rapid: bool,
        path: Element,
        beam: f64,
        asked: f64,
        feed: f64,
        line: usize,
    },
    Wait {
        seconds: f64,
        beam: f64,
        line: usize,
    },
    /// `3 of 7: cut contour 5`.
    Contour,
}

#[derive(Debug, Default)]
pub(crate) struct Run {
    pub(crate) steps: Vec<Step>,
    pub(crate) comments: Vec<String>,
    /// The beam could still fire.
    pub(crate) armed: bool,
}

struct State {
    controller: Controller,
    at: DVec2,
    motion: u32,
    unit: Option<f64>,
    relative: bool,
    feed: f64,
    spindle: char,
    inline: bool,
    s: f64,
    level: f64,
    pending: Option<f64>,
}

/// Runs a program; an error names the line.
pub(crate) fn run(text: &str, controller: Controller) -> Result<Run, String> {
    let mut run = Run::default();
    let mut state = State {
        controller,
        at: DVec2::ZERO,
        motion: 0,
        unit: None,
        relative: false,
        feed: 0.0,
        spindle: '5',
        inline: false,
        s: 0.0,
        level: 0.0,
        pending: None,
    };
    for (i, line) in text.lines().enumerate() {
        state.line(line, i + 1, &mut run).map_err(|e| format!("line {}: {e}: {line}", i + 1))?;
    }
    run.armed = state.spindle != '5' && controller != Controller::Smoothie
        || state.level > 0.0
        || state.pending.is_some_and(|q| q > 0.0);
    Ok(run)
}

impl State {
    fn line(&mut self, line: &str, number: usize, run: &mut Run) -> Result<(), String> {
        let code = match (line.find(';'), line.find('(')) {
            (Some(at), _) => {
                run.comments.push(line[at + 1..].trim().into());
                &line[..at]
            }
            (None, Some(at)) => {
                run.comments.push(line[at + 1..].trim_end_matches([')', '\r']).trim().into());
                &line[..at]
            }
            _ => line,
        };
        if code.trim().is_empty() {
            if run.comments.last().is_some_and(|c| c.contains(" contour ")) && line.len() > 1 {
                run.steps.push(Step::Contour);
            }
            return Ok(());
        }
        let words: Vec<(char, &str)> = code
            .split_whitespace()
            .map(|w| w.chars().next().map(|c| (c, &w[c.len_utf8()..])).ok_or("an empty word"))
            .collect::<Result<_, _>>()?;
        let value = |letter: char| -> Result<Option<f64>, String> {
            let Some((_, text)) = words.iter().find(|w| w.0 == letter) else { return Ok(None) };
            text.parse().map(Some).map_err(|_| format!("{letter}{text} is no number"))
        };
        for (k, w) in words.iter().enumerate() {
            if words[..k].iter().any(|v| v.0 == w.0 && !"GM".contains(w.0)) {
                return Err(format!("{} twice", w.0));
            }
        }
        let commands = words.iter().filter(|w| "GM".contains(w.0)).count();
        if self.controller.is_marlin() && commands != 1 {
            return Err("Marlin takes one command a line".into());
        }
        let (p, s, q) =
            (value('P')?, value('S')?, if words.iter().any(|w| w.0 == 'Q') { value('Q')? } else { None });
        let dwells = words.contains(&('G', "4"));
        if let Some(f) = value('F')? {
            self.feed = f;
        }
        if let Some(s) = s
            && !dwells
            && !matches!(
                self.controller,
                Controller::Analog { .. } | Controller::MarlinFan | Controller::Template
            )
        {
            self.s = s;
        }
        for &(letter, code) in words.iter().filter(|w| "GM".contains(w.0)) {
            match (letter, code) {
                ('G', "0" | "1" | "2" | "3") => self.motion = code.parse().unwrap(),
                ('G', "4") => {}
                ('G', "20") => self.unit = Some(25.4),
                ('G', "21") => self.unit = Some(1.0),
                ('G', "90") => self.relative = false,
                ('G', "91") => self.relative = true,
                ('G', "91.1" | "17" | "94" | "40" | "49" | "80" | "64") => {}
                ('M', _) => self.m(code, p, s, q, words.iter().any(|w| w.0 == 'I'))?,
                _ => return Err(format!("unknown command {letter}{code}")),
            }
        }
        if dwells {
            let seconds = self.controller.seconds(p, s);
            run.steps.push(Step::Wait { seconds, beam: self.at_rest(), line: number });
            return Ok(());
        }
        if let (Controller::Template, true) = (self.controller, words.contains(&('P', "9003"))) {
            run.steps.push(Step::Wait { seconds: q.unwrap(), beam: self.level, line: number });
        }
        let (x, y) = (value('X')?, value('Y')?);
        if x.is_some() || y.is_some() {
            self.moves([x, y], [value('I')?, value('J')?], number, run)?;
        }
        Ok(())
    }

    fn m(
        &mut self,
        code: &str,
        p: Option<f64>,
        s: Option<f64>,
        q: Option<f64>,
        i: bool,
    ) -> Result<(), String> {
        match (self.controller, code) {
            (_, "8" | "9" | "2" | "30") => {}
            (Controller::Template, "98") => match p {
                Some(9001.0 | 9003.0) => self.level = s.ok_or("a macro without power")?,
                Some(9002.0) => self.level = 0.0,
                Some(9004.0 | 9005.0) => {}
                _ => return Err("unknown macro".into()),
            },
            (Controller::Analog { .. }, "67") => self.pending = Some(q.ok_or("M67 without Q")?),
            (Controller::Analog { m68: true }, "68") => {
                (self.level, self.pending) = (q.ok_or("M68 without Q")?, None)
            }
            (Controller::Analog { .. }, "5") => {}
            (Controller::MarlinFan, "400") => {}
            (Controller::MarlinFan, "106") => self.level = s.ok_or("M106 without S")?,
            (Controller::MarlinFan, "107") => self.level = 0.0,
            (Controller::MarlinInline, "3") => {
                (self.spindle, self.inline) = ('3', i);
                // What an earlier M3 has set does not count for the inline mode.
                if s.is_none() {
                    self.s = 0.0;
                }
            }
            (Controller::MarlinInline, "5") => (self.spindle, self.inline) = ('5', false),
            (Controller::Smoothie, "5") => {}
            (Controller::Grbl | Controller::FluidNc | Controller::LinuxCncSpindle, "3" | "4" | "5") => {
                self.spindle = code.chars().next().unwrap();
            }
            _ => return Err(format!("unknown command M{code}")),
        }
        Ok(())
    }

    fn at_rest(&self) -> f64 {
        match self.controller {
            Controller::Grbl | Controller::FluidNc => {
                if self.spindle == '3' && self.motion != 0 {
                    self.s
                } else {
                    0.0
                }
            }
            Controller::LinuxCncSpindle => {
                if self.spindle == '5' {
                    0.0
                } else {
                    self.s
                }
            }
            Controller::MarlinInline => {
                if self.spindle == '3' && !self.inline {
                    self.s
                } else {
                    0.0
                }
            }
            Controller::Smoothie => 0.0,
            Controller::Analog { .. } | Controller::MarlinFan | Controller::Template => self.level,
        }
    }

    fn moves(
        &mut self,
        xy: [Option<f64>; 2],
        ij: [Option<f64>; 2],
        line: usize,
        run: &mut Run,
    ) -> Result<(), String> {
        let unit = self.unit.ok_or("a motion before the unit is known")?;
        let base = if self.relative { self.at } else { DVec2::ZERO };
        let to = DVec2::new(
            xy[0].map_or(self.at.x, |x| base.x + x * unit),
            xy[1].map_or(self.at.y, |y| base.y + y * unit),
        );
        if let Some(q) = self.pending.take() {
            self.level = q;
        }
        let rapid = self.motion == 0;
        let asked = match self.controller {
            Controller::Smoothie => self.s,
            Controller::Analog { .. } | Controller::MarlinFan | Controller::Template => self.level,
            _ if self.spindle == '5' => 0.0,
            _ => self.s,
        };
        let dark = rapid
            && matches!(self.controller, Controller::Grbl | Controller::MarlinInline | Controller::Smoothie);
        if !rapid && self.feed <= 0.0 {
            return Err("a cut without feed".into());
        }
        let path = if self.motion < 2 {
            Element::line(self.at, to)
        } else {
            let center = self.at + DVec2::new(ij[0].ok_or("no I")?, ij[1].ok_or("no J")?) * unit;
            let (a, b) = (self.at - center, to - center);
            if (a.length() - b.length()).abs() > 0.005_f64.max(0.001 * a.length()) {
                return Err(format!("radii {} and {}", a.length(), b.length()));
            }
            let turn = f64::atan2(a.perp_dot(b), a.dot(b));
            let sweep = match self.motion {
                3 if turn <= 5e-7 => turn + TAU,
                2 if turn >= -5e-7 => turn - TAU,
                _ => turn,
            };
            Element { from: self.at, to, arc: Some((center, sweep)) }
        };
        // Marlin runs G0 with the feed in force.
        let feed = if rapid && !self.controller.is_marlin() { f64::INFINITY } else { self.feed * unit };
        run.steps.push(Step::Move { rapid, path, beam: if dark { 0.0 } else { asked }, asked, feed, line });
        self.at = to;
        Ok(())
    }
}
