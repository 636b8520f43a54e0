//! Writes a plan as G-code for GRBL 1.1 in laser mode (setting 32 at 1), in mm, mm/min and seconds.
//!
//! **Beam off on air moves.** M4 (dynamic power) is selected once, at the head of the program. Between contours, the
//! line of the rapid also sets S to 0. Two independent mechanisms keep the beam off there: the power is 0, and in laser
//! mode GRBL passes no power to any motion but G1, G2 and G3. Switching M5 and M4 around every contour would add
//! nothing, and each switch empties the planner's buffer.
//!
//! **Piercing.** Under M4 the power follows the speed, so at standstill the beam is off and a dwell pierces nothing. A
//! pierce at the entry is therefore `G1 M3 S.. F..` (constant power; G1 is on the same line because in the motion mode
//! G0, left by the rapid, GRBL would keep the beam off), `G4 P..` with the beam on, and `M4` back to dynamic power. The
//! settling time of the beam before a cut is part of that dwell; the one after a cut is a dwell at S0.
//!
//! **Partial cuts.** A contour is resumed from its pre-cut under M4 without a pierce, so a cut without a pierce before
//! it has no dwell. A pre-cut with a length is cut in advance, and the head returns with the beam off.
//!
//! **Sharp corners** are a dwell with the beam off in the corner (`S0`, `G4 P..`); then the cut goes on.
//!
//! **Comments** begin with a semicolon, which needs no closing and cannot be nested. GRBL picks its real-time commands
//! (`?`, `!`, `~`, and every byte from 0x80) out of the stream before it recognises comments, so names are reduced to
//! plain letters, digits and a few marks. Lines are shorter than the 80 characters that GRBL holds.
//!
//! Source: GRBL 1.1, gcode.c (steps 4 and 7 of the block), spindle_control.c, protocol.c, wiki "Grbl v1.1 Laser Mode".

mod grbl_arc;
mod pen;

use super::cuts::cuts;
use super::number::fixed;
use crate::geometry::{Aabb, DVec2, Segment};
use crate::machine::{Dialect, Process, Profile, Start, far_out};
use crate::plan::{Move, Plan};
use crate::sheet::Sheet;
use pen::Pen;
use std::mem;

/// Longest comment in characters. With the semicolon and a space it is well below the 80 that GRBL holds.
const MAX_COMMENT: usize = 66;

/// Why a plan cannot be written as a program, as one sentence for people.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The job reaches a place where the controller's numbers are too coarse.
    #[error(
        "The program would reach x {x:.0}, y {y:.0} mm, where the controller's 32-bit numbers are {spacing:.3} mm apart: \
         move the drawing and the machine's home near the origin, or correct the drawing's unit."
    )]
    FarFromOrigin {
        /// x of that place, mm.
        x: f64,
        /// y of that place, mm.
        y: f64,
        /// Distance between neighbouring numbers there, mm.
        spacing: f64,
    },
}

/// The program of a plan for a machine; `name` is the name of the job for the comment at its head. Coordinates are in mm.
/// With [`Start::Absolute`] they are those of the work coordinates active on the machine. The head may be anywhere at
/// the start, because the program first moves it to the plan's home. With [`Start::Current`] every motion is given as
/// seen from the one before (G91), so the job lies where the head stands when the program begins. The result is an error where the controller's 32-bit numbers are too
/// coarse for the job.
pub fn gcode(
    plan: &Plan,
    sheet: &Sheet,
    profile: &Profile,
    name: &str,
    start: Start,
) -> Result<String, OutputError> {
    let [x0, y0, x1, y1] = plan.summary.bounds;
    let bounds = Aabb { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) };
    if let Some(far) = far_out(&bounds.with(profile.home())) {
        return Err(OutputError::FarFromOrigin { x: far.at.x, y: far.at.y, spacing: far.spacing });
    }
    Ok(match profile.dialect {
        Dialect::GrblM4 => grbl(plan, sheet, profile, name, start),
    })
}

fn grbl(plan: &Plan, sheet: &Sheet, profile: &Profile, name: &str, start: Start) -> String {
    let mut pen = Pen::new(profile.home(), start);
    head(&mut pen, plan, profile, name);

    // The move home is run with the laser switched off.
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
            // A pre-cut without length is only a charge of time, so nothing is cut.
            Move::PreCut { contour, to, ahead } if !ahead.is_empty() => {
                comment(&mut pen, &format!("pre-cut into contour {contour}"));
                write_contour(&mut pen, profile, &profile.cut, ahead, mem::take(&mut pierce));
                pen.rapid(*to);
            }
            Move::PreCut { .. } => {}
            Move::Macro { .. } => pen.settle_dark(profile.macro_time()),
            Move::Cut { contour, path, mark, .. } => {
                if !goes_on {
                    order += 1;
                    let layer = sheet.layer_name(*contour);
                    let verb = if *mark { "mark" } else { "cut" };
                    let words = format!("{order} of {all}: {verb} contour {contour}, layer ");
                    comment_naming(&mut pen, &words, layer);
                }
                write_contour(&mut pen, profile, profile.process(*mark), path, mem::take(&mut pierce));
            }
        }
        goes_on = matches!(step, Move::Macro { .. });
    }

    pen.off();
    if let Some(home) = way_home {
        pen.rapid(home);
    }
    if !start.is_absolute() {
        pen.command("G90");
    }
    pen.command("M2");
    pen.into_program()
}

/// Writes one contour: the dwell with the beam on, the path, and the dwell after it.
fn write_contour(pen: &mut Pen, profile: &Profile, process: &Process, path: &[Segment], pierce: f64) {
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
    comment_naming(pen, &format!("Kerfway {version}, "), name);
    comment_naming(pen, "machine ", &profile.name);
    comment_naming(pen, "", &profile.title);
    comment(pen, &format!("{} contours, {} pierces", sums.contours, sums.pierces));
    let [cut, air] = [sums.cut_length, sums.air_length].map(|v| fixed(v, 1));
    comment(pen, &format!("cut {cut} mm, air {air} mm"));
    comment(pen, &format!("time: about {} s", fixed(sums.total_time, 1)));
    comment(pen, "unit: mm");
    let [x0, y0, x1, y1] = sums.bounds.map(|v| fixed(v, 1));
    comment(pen, &format!("x {x0} to {x1}, y {y0} to {y1}"));
    comment(pen, "GRBL 1.1, laser mode on, setting 32 at 1");
    pen.off();
    pen.select_units();
    pen.command("M4 S0");
    pen.find_start();
}

/// Writes a comment line, in plain characters.
fn comment(pen: &mut Pen, text: &str) {
    debug_assert!(text.len() <= MAX_COMMENT, "a comment that its line cannot hold: {text}");
    let text = plain(text);
    pen.command(&format!("; {}", text.trim_end()));
}

/// Writes a comment line that ends in a name given by the user. A name that is too long for the line is shortened in
/// its middle, so that its start and a file's extension remain.
fn comment_naming(pen: &mut Pen, words: &str, name: &str) {
    const GAP: &str = "...";
    let (name, room) = (plain(name), MAX_COMMENT.saturating_sub(words.len()));
    if name.len() <= room {
        return comment(pen, &format!("{words}{name}"));
    }
    let kept = room.saturating_sub(GAP.len());
    // Plain characters take one byte each.
    let (start, end) = (&name[..kept - kept / 2], &name[name.len() - kept / 2..]);
    comment(pen, &format!("{words}{start}{GAP}{end}"));
}

/// Replaces characters that a controller may act upon. Parentheses are removed, because they delimit comments in other
/// dialects.
fn plain(text: &str) -> String {
    let plain = |c: char| match c {
        ' ' | '.' | ',' | ':' | '_' | '+' | '-' | '=' | '/' => c,
        c if c.is_ascii_alphanumeric() => c,
        _ => '_',
    };
    text.chars().filter(|c| !matches!(c, '(' | ')')).map(plain).collect()
}
