//! G-code for GRBL 1.1 in laser mode (setting 32 at 1), from a plan. mm, mm/min, seconds.
//!
//! **Dark on the way.** M4 (dynamic power) is chosen once, at the head of the program, and stays; between contours the
//! S word goes to 0 on the very line of the rapid. Two independent things keep the beam off there: the power is 0, and
//! in laser mode GRBL passes no power to any motion but G1, G2 and G3. Switching M5 and M4 around every contour would
//! add nothing to that, and each switch empties the planner's buffer.
//!
//! **Piercing.** Under M4 the power follows the speed, so at standstill the beam is off and a dwell pierces nothing.
//! A pierce therefore is, at the entry: `G1 M3 S.. F..` (constant power; G1 on the same line because in the motion
//! mode G0, left by the rapid, GRBL would hold the beam off), `G4 P..` with the beam on, and `M4` back to dynamic
//! power. The settling time of the beam before a cut is part of that dwell; the one after a cut is a dwell at S0.
//!
//! **Contours left unfinished** go on with the beam as it comes, under M4 and without the dwell of a pierce: a cut that no
//! pierce precedes is resumed from its pre-cut. A pre-cut with a length is cut ahead, and the head comes back dark.
//!
//! **Sharp corners** are a dwell with the beam off in the corner (`S0`, `G4 P..`); the cut goes on as the beam comes.
//!
//! **Comments** begin with a semicolon, which nests in nothing and needs no closing. GRBL picks its real-time commands
//! (`?`, `!`, `~`, and every byte from 0x80) out of the stream before it knows of comments, so names are written in
//! plain letters, digits and a few marks. Lines are short of the 80 characters GRBL holds.
//!
//! Source: GRBL 1.1, gcode.c (steps 4 and 7 of the block), spindle_control.c, protocol.c, wiki "Grbl v1.1 Laser Mode".

mod pen;

use super::number::fixed;
use super::walk::{cuts, layer_name};
use crate::geometry::Segment;
use crate::machine::{Dialect, Process, Profile};
use crate::plan::{Move, Plan};
use crate::sheet::Sheet;
use pen::Pen;
use std::mem;

/// Longest comment, in characters: with the semicolon well short of GRBL's 80.
const COMMENT: usize = 66;

/// The program of a plan for a machine; `name` of the job for its head comment. mm, absolute, in the work coordinates
/// that are active on the machine. The head may stand anywhere: it goes to the plan's home first.
pub fn gcode(plan: &Plan, sheet: &Sheet, profile: &Profile, name: &str) -> String {
    match profile.dialect {
        Dialect::GrblM4 => grbl(plan, sheet, profile, name),
    }
}

fn grbl(plan: &Plan, sheet: &Sheet, profile: &Profile, name: &str) -> String {
    let mut pen = Pen::new(profile.home());
    head(&mut pen, plan, profile, name);

    // The way home is run with the laser switched off.
    let (work, way_home) = match plan.moves.split_last() {
        Some((Move::Air { to }, work)) => (work, Some(*to)),
        _ => (plan.moves.as_slice(), None),
    };
    let all = cuts(plan).len();
    let (mut order, mut pierce, mut goes_on) = (0, 0.0, false);
    for step in work {
        match step {
            Move::Air { to } => pen.rapid(*to),
            Move::Pierce => pierce += profile.pierce_time,
            // Where pre-cuts have no length they are a charge of time: nothing to burn.
            Move::PreCut { contour, to, ahead } if !ahead.is_empty() => {
                comment(&mut pen, &format!("pre-cut into contour {contour}"));
                work_contour(&mut pen, profile, &profile.cut, ahead, mem::take(&mut pierce));
                pen.rapid(*to);
            }
            Move::PreCut { .. } => {}
            Move::Macro { .. } => pen.settle_dark(profile.macro_time()),
            Move::Cut { contour, path, mark, .. } => {
                if !goes_on {
                    order += 1;
                    let layer = layer_name(sheet, *contour);
                    let verb = if *mark { "mark" } else { "cut" };
                    comment(&mut pen, &format!("{order} of {all}: {verb} contour {contour}, layer {layer}"));
                }
                work_contour(&mut pen, profile, profile.process(*mark), path, mem::take(&mut pierce));
            }
        }
        goes_on = matches!(step, Move::Macro { .. });
    }

    pen.off();
    if let Some(home) = way_home {
        pen.rapid(home);
    }
    pen.command("M2");
    pen.into_program()
}

/// One contour: the dwell with the beam on, the path, the dwell after it.
fn work_contour(pen: &mut Pen, profile: &Profile, process: &Process, path: &[Segment], pierce: f64) {
    pen.set_process(process.speed * 60.0, process.power * profile.max_s);
    pen.pierce(pierce + profile.beam_on_delay);
    for segment in path {
        pen.cut(segment);
    }
    pen.settle_dark(profile.beam_off_delay);
}

fn head(pen: &mut Pen, plan: &Plan, profile: &Profile, name: &str) {
    let sums = &plan.summary;
    let version = env!("CARGO_PKG_VERSION");
    comment(pen, &format!("Kerfway {version}, {name}"));
    comment(pen, &format!("machine {}: {}", profile.name, profile.title));
    comment(
        pen,
        &format!(
            "{} contours, {} pierces, cut {} mm, air {} mm, about {} s",
            sums.contours,
            sums.pierces,
            fixed(sums.cut_length, 1),
            fixed(sums.air_length, 1),
            fixed(sums.total_time, 1)
        ),
    );
    let [x0, y0, x1, y1] = sums.bounds.map(|v| fixed(v, 1).to_string());
    comment(pen, &format!("mm, x {x0} to {x1}, y {y0} to {y1}"));
    comment(pen, "GRBL 1.1, laser mode on, setting 32 at 1");
    pen.off();
    pen.command("G21 G90 G91.1 G17 G94");
    pen.command("M4 S0");
    pen.find_start();
}

/// A comment line of plain characters that no controller acts upon; parentheses, which some take for the comments they
/// are in other dialects, are left out.
fn comment(pen: &mut Pen, text: &str) {
    let plain = |c: char| match c {
        ' ' | '.' | ',' | ':' | '_' | '+' | '-' | '=' | '/' => c,
        c if c.is_ascii_alphanumeric() => c,
        _ => '_',
    };
    let line: String = text.chars().filter(|c| !matches!(c, '(' | ')')).map(plain).take(COMMENT).collect();
    pen.command(&format!("; {}", line.trim_end()));
}
