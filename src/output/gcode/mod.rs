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

mod grbl_arc;
mod pen;

use super::number::fixed;
use super::walk::{cuts, layer_name};
use crate::geometry::{Aabb, DVec2, Segment};
use crate::machine::{Dialect, Process, Profile, far_out};
use crate::plan::{Move, Plan};
use crate::sheet::Sheet;
use pen::Pen;
use std::mem;

/// Longest comment, in characters: with the semicolon and a space well short of the 80 that GRBL holds.
const COMMENT: usize = 66;

/// Why a plan cannot be written as a program: one sentence for people.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The controller's numbers are too coarse there.
    #[error(
        "The program would reach x {x:.0}, y {y:.0} mm, where the controller's 32-bit numbers are {spacing:.3} mm apart: \
         move the drawing and the machine's home near the origin, or correct the drawing's unit."
    )]
    FarFromOrigin {
        /// Where, mm.
        x: f64,
        /// Where, mm.
        y: f64,
        /// Distance between neighbouring numbers there, mm.
        spacing: f64,
    },
}

/// The program of a plan for a machine; `name` of the job for its head comment. mm, absolute, in the work coordinates
/// that are active on the machine. The head may stand anywhere: it goes to the plan's home first. An error where the
/// controller's 32-bit numbers are too coarse for the job.
pub fn gcode(plan: &Plan, sheet: &Sheet, profile: &Profile, name: &str) -> Result<String, OutputError> {
    let [x0, y0, x1, y1] = plan.summary.bounds;
    let bounds = Aabb { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) };
    if let Some(far) = far_out(&bounds.with(profile.home())) {
        return Err(OutputError::FarFromOrigin { x: far.at.x, y: far.at.y, spacing: far.spacing });
    }
    Ok(match profile.dialect {
        Dialect::GrblM4 => grbl(plan, sheet, profile, name),
    })
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
                    let words = format!("{order} of {all}: {verb} contour {contour}, layer ");
                    comment_naming(&mut pen, &words, layer);
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
    pen.command("G21 G90 G91.1 G17 G94");
    pen.command("M4 S0");
    pen.find_start();
}

/// A comment line, in plain characters.
fn comment(pen: &mut Pen, text: &str) {
    debug_assert!(text.len() <= COMMENT, "a comment that its line cannot hold: {text}");
    let text = plain(text);
    pen.command(&format!("; {}", text.trim_end()));
}

/// A comment line that ends in a name somebody else chose: where the line would be too long, the name is shortened in its
/// middle, so that the words before it and the ending of a file's name remain.
fn comment_naming(pen: &mut Pen, words: &str, name: &str) {
    const GAP: &str = "...";
    let (name, room) = (plain(name), COMMENT.saturating_sub(words.len()));
    if name.len() <= room {
        return comment(pen, &format!("{words}{name}"));
    }
    let kept = room.saturating_sub(GAP.len());
    // Plain characters are of one byte each.
    let (start, end) = (&name[..kept - kept / 2], &name[name.len() - kept / 2..]);
    comment(pen, &format!("{words}{start}{GAP}{end}"));
}

/// Text in characters that no controller acts upon; parentheses, which some take for the comments they are in other
/// dialects, are left out.
fn plain(text: &str) -> String {
    let plain = |c: char| match c {
        ' ' | '.' | ',' | ':' | '_' | '+' | '-' | '=' | '/' => c,
        c if c.is_ascii_alphanumeric() => c,
        _ => '_',
    };
    text.chars().filter(|c| !matches!(c, '(' | ')')).map(plain).collect()
}
