//! Writes a plan as a Ruida file (`.rd`). **Experimental**: the format is not published, and no controller has run a file of
//! ours; MeerK40t's reader understands them.
//!
//! A file is a list of commands: a byte of 0x80 or more, then data of seven bits a byte, all of it scrambled byte by byte.
//! Coordinates are micrometres in five bytes; powers are parts of 16383 in two, speeds micrometres a second in five. Arcs
//! become chords within [`CHORD_DEVIATION`]. Each way of cutting is a *part* with a block of settings, which is repeated
//! whenever the way changes, so marks and cuts alternate as planned. Every pass is cut on its own.
//!
//! The piercing time is left to the controller. Heights and ways around tipped pieces are not part of the files, so plans that
//! lower the head for a pass, lift it between cuts or lead it around are refused.
//!
//! Sources: "Ruida", EduTech Wiki, University of Geneva (edutechwiki.unige.ch/en/Ruida); the reader of MeerK40t (MIT),
//! `meerk40t/ruida/rdjob.py`.

use super::cuts::{Cut, cuts};
use super::gcode::OutputError;
use super::process::CutProcess;
use super::sheet_facts::SheetFacts;
use crate::geometry::{Aabb, DVec2, Segment, arcs};
use crate::machine::Profile;
use crate::plan::{Move, Plan};

/// Largest distance between an arc and its chords, mm.
const CHORD_DEVIATION: f64 = 0.005;
/// The key of the scrambling for the 644 family of controllers.
const MAGIC: u8 = 0x88;
/// A part has a number of seven bits; the controllers show fewer.
const PARTS: usize = 100;
/// Largest coordinate in micrometres: 32 bits with a sign.
const FARTHEST: f64 = 2_147_483_647.0;

/// The Ruida file of a plan.
///
/// # Errors
/// The plan cuts in too many ways, too far from the origin, or at several heights, it waits, it pauses in corners, it makes pre-cuts
/// that have a length, or it lifts the head.
pub fn rd(plan: &Plan, sheet: &SheetFacts, profile: &Profile) -> Result<Vec<u8>, OutputError> {
    let cuts = cuts(plan);
    refuse(plan, &cuts)?;
    let process_of = |cut: &Cut| CutProcess::of_cut(sheet, profile, cut);
    let mut parts: Vec<CutProcess> = Vec::new();
    for cut in &cuts {
        let process = process_of(cut);
        if !parts.contains(&process) {
            parts.push(process);
        }
    }
    if parts.len() > PARTS {
        return Err(OutputError::Format(format!(
            "A Ruida file has at most {PARTS} layers, and this plan cuts in {} ways: give some layers the same settings.",
            parts.len()
        )));
    }
    let box_of = |cuts: &mut dyn Iterator<Item = &Cut>| {
        cuts.flat_map(|c| c.path.iter()).fold(Aabb::EMPTY, |b, s| b.union(s.bounds()))
    };
    let all = box_of(&mut cuts.iter());
    let farthest = all.min.abs().max(all.max.abs()).max_element();
    if farthest * 1000.0 > FARTHEST {
        return Err(OutputError::Format(format!(
            "A Ruida file reaches 2147 m, and this plan {:.0} m: correct the drawing's unit.",
            farthest / 1000.0
        )));
    }
    let mut file = File::default();
    file.begin(all);
    for (part, process) in parts.iter().enumerate() {
        let of_part = &mut cuts.iter().filter(|c| process_of(c) == *process);
        file.part(small(part), process, box_of(of_part));
    }
    file.end_of_parts(small(parts.len().saturating_sub(1)), all);
    let mut current = None;
    for cut in &cuts {
        let process = process_of(cut);
        let part = parts.iter().position(|p| *p == process).unwrap_or(0);
        if current != Some(part) {
            file.settings(small(part), &process, current.is_some());
            current = Some(part);
        }
        file.cut(cut);
    }
    Ok(file.finish())
}

/// Refuses a plan with something that the files cannot say.
fn refuse(plan: &Plan, cuts: &[Cut]) -> Result<(), OutputError> {
    let lowers = cuts.iter().any(|c| c.z < 0.0);
    let pauses = plan.moves.iter().any(|m| matches!(m, Move::Macro { .. }));
    let evades = plan.summary.lifts + plan.summary.detours > 0;
    let refused = [
        (lowers, "do not lower the head: set the z step of the passes to 0, or write a LightBurn project."),
        (
            plan.summary.waits > 0,
            "have no waits: give near cuts a charge in the machine's levers.heat, or write G-code.",
        ),
        (pauses, "have no pauses in sharp corners: switch them off in the machine, or write G-code."),
        (
            plan.moves.iter().any(Move::cuts_ahead),
            "have no cuts ahead of a pre-cut: set the machine's pre_cut_length to 0, or write G-code.",
        ),
        (
            evades,
            "move the head straight and never lift it: switch off the machine's lift and its ways around pieces that may tip, or write G-code.",
        ),
    ];
    match refused.into_iter().find(|r| r.0) {
        None => Ok(()),
        Some((_, why)) => Err(OutputError::Format(format!("Ruida files of Kerfway {why}"))),
    }
}

fn small(n: usize) -> u8 {
    u8::try_from(n).unwrap_or(u8::MAX) & 0x7F
}

#[derive(Default)]
struct File {
    bytes: Vec<u8>,
}

impl File {
    fn put(&mut self, command: &[u8], data: &[&[u8]]) {
        self.bytes.extend_from_slice(command);
        for part in data {
            self.bytes.extend_from_slice(part);
        }
    }

    fn corners(&mut self, command: u8, low: &[u8], b: Aabb) {
        let (min, max) = (place(b.min), place(b.max));
        self.put(&[0xE7, command], &[low, &min]);
        self.put(&[0xE7, command + 1], &[low, &max]);
    }

    /// Everything before the parts: absolute coordinates from the machine's zero, and the box of the job.
    fn begin(&mut self, b: Aabb) {
        self.put(&[0xD8, 0x10], &[]);
        self.put(&[0xE6, 0x01], &[]);
        self.put(&[0xF0], &[]);
        self.put(&[0xF1, 0x02, 0], &[]);
        self.put(&[0xD8, 0x00], &[]);
        self.put(&[0xE7, 0x06], &[&[0; 10]]);
        self.put(&[0xE7, 0x38, 0], &[]);
        self.put(&[0xE7, 0x03], &[&place(b.min)]);
        self.put(&[0xE7, 0x07], &[&place(b.max)]);
        self.corners(0x50, &[], b);
        self.put(&[0xE7, 0x04], &[&[0, 1, 0, 1], &[0; 10]]);
        self.put(&[0xE7, 0x05, 0], &[]);
    }

    /// Announces a part: speed, least and largest power of both tubes, colour, mode and box.
    fn part(&mut self, part: u8, process: &CutProcess, b: Aabb) {
        self.put(&[0xC9, 0x04, part], &[&micrometres(process.speed)]);
        for [least, most] in [[0x31, 0x32], [0x41, 0x42]] {
            self.put(&[0xC6, least, part], &[&least_power(process)]);
            self.put(&[0xC6, most, part], &[&power(process.power)]);
        }
        self.put(&[0xCA, 0x06, part], &[&seven_bits(i64::from(part) * 0x40)]);
        self.put(&[0xCA, 0x41, part, 0], &[]);
        self.corners(0x52, &[part], b);
        self.corners(0x61, &[part], b);
    }

    fn end_of_parts(&mut self, last: u8, b: Aabb) {
        self.put(&[0xCA, 0x22, last], &[]);
        for command in [0x54, 0x55] {
            self.put(&[0xE7, command, 0], &[&[0; 5]]);
            self.put(&[0xE7, command, 1], &[&[0; 5]]);
        }
        self.put(&[0xF1, 0x03], &[&[0; 10]]);
        self.put(&[0xE7, 0x0A], &[&[0; 5]]);
        self.put(&[0xEA, 0], &[]);
        self.put(&[0xE7, 0x60, 0], &[]);
        self.put(&[0xE7, 0x0B, 0], &[]);
        self.put(&[0xE7, 0x13], &[&place(b.min)]);
        self.put(&[0xE7, 0x17], &[&place(b.max)]);
        self.put(&[0xE7, 0x23], &[&[0; 10]]);
        self.put(&[0xE7, 0x24, 0], &[]);
        self.put(&[0xE7, 0x08], &[&[0, 1, 0, 1], &[0; 10]]);
    }

    /// The settings in force from here on.
    fn settings(&mut self, part: u8, process: &CutProcess, follows: bool) {
        if follows {
            self.end_of_block();
        }
        self.put(&[0xCA, 0x02, part], &[]);
        self.put(&[0xCA, 0x01, 0x10], &[]);
        self.put(&[0xCA, 0x01, if process.air { 0x13 } else { 0x12 }], &[]);
        self.put(&[0xC9, 0x02], &[&micrometres(process.speed)]);
        self.put(&[0xC6, 0x12], &[&[0; 5]]);
        self.put(&[0xC6, 0x13], &[&[0; 5]]);
        for [least, most] in [[0x01, 0x02], [0x21, 0x22]] {
            self.put(&[0xC6, least], &[&least_power(process)]);
            self.put(&[0xC6, most], &[&power(process.power)]);
        }
        self.put(&[0xCA, 0x03, 1], &[]);
    }

    fn end_of_block(&mut self) {
        self.put(&[0xE7, 0x00], &[]);
        self.put(&[0xCA, 0x01, 0x00], &[]);
        self.put(&[0xCA, 0x01, 0x30], &[]);
    }

    fn cut(&mut self, cut: &Cut) {
        self.put(&[0x88], &[&place(cut.entry)]);
        for segment in cut.path.iter() {
            match segment {
                Segment::Line(l) => self.put(&[0xA8], &[&place(l.end)]),
                Segment::Arc(a) => {
                    arcs::flattened(a, CHORD_DEVIATION).for_each(|p| self.put(&[0xA8], &[&place(p)]))
                }
            }
        }
    }

    /// Adds the sum of all bytes, which the controller compares, and scrambles the file.
    fn finish(mut self) -> Vec<u8> {
        const END: u8 = 0xD7;
        self.end_of_block();
        let sum: i64 = self.bytes.iter().map(|b| i64::from(*b)).sum();
        self.put(&[0xE5, 0x05], &[&seven_bits(sum + i64::from(END))]);
        self.put(&[END], &[]);
        self.bytes.iter().map(|b| scrambled(*b)).collect()
    }
}

/// Swaps the first and the last bit, and adds the key.
fn scrambled(byte: u8) -> u8 {
    let swapped = (byte & 0x7E) | (byte >> 7) | (byte << 7);
    (swapped ^ MAGIC).wrapping_add(1)
}

/// A number in five bytes of seven bits; negative ones as 32 bits in two's complement.
fn seven_bits(n: i64) -> [u8; 5] {
    let bits = n & 0xFFFF_FFFF;
    [28, 21, 14, 7, 0].map(|shift| u8::try_from((bits >> shift) & 0x7F).unwrap_or(0))
}

/// mm, or mm/s, as micrometres.
fn micrometres(mm: f64) -> [u8; 5] {
    #[expect(clippy::cast_possible_truncation, reason = "places beyond 32 bits are refused before")]
    seven_bits((mm * 1000.0).round() as i64)
}

fn place(p: DVec2) -> [u8; 10] {
    let mut bytes = [0; 10];
    bytes[..5].copy_from_slice(&micrometres(p.x));
    bytes[5..].copy_from_slice(&micrometres(p.y));
    bytes
}

/// The least power; the power itself if there is none.
fn least_power(process: &CutProcess) -> [u8; 2] {
    power(process.min_power.unwrap_or(process.power))
}

/// A fraction of full power.
fn power(fraction: f64) -> [u8; 2] {
    #[expect(clippy::cast_possible_truncation, reason = "a share of 14 bits")]
    let parts = (fraction.clamp(0.0, 1.0) * 16383.0).round() as i64;
    [7, 0].map(|shift| u8::try_from((parts >> shift) & 0x7F).unwrap_or(0))
}
