//! The seconds of each part: its cuts, its piercings, and a share of the moves with the beam off.
//!
//! What a part takes by itself (cuts, marks on it, piercings, pre-cuts, pauses in corners) is charged to it. A cut along a
//! side that parts share is divided equally between the contours that it runs along, and one around parts that bridges connect by the lengths
//! of their outlines. A cut through a bridge is charged to the part whose outline it completes. Air moves belong to no part; they are
//! shared by the number of places where the beam is switched on, so that equal parts cost the same wherever they lie.
//! Marks and cuts that belong to no part are kept apart, so that all together add up to the job.

use super::times::Times;
use crate::geometry::{DVec2, Segment};
use crate::machine::{PLANS_ALL_LEVERS, cut_time};
use crate::plan::document::{Contours, Document, Element, Move, segments};
use std::mem;

/// Times and piercings of one part, or of what belongs to no part.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Seconds {
    pub(super) times: Times,
    pub(super) pierces: u32,
    /// Number of places where the beam is switched on.
    starts: f64,
}

/// The seconds of each part, and of what belongs to none. `part_of` gives the part of a contour.
pub(super) fn seconds(
    document: &Document,
    parts: usize,
    part_of: &[Option<usize>],
) -> (Vec<Seconds>, Seconds) {
    let mut shares = Shares::new(document, parts, part_of);
    for (index, step) in document.moves.iter().enumerate() {
        shares.add(index, step);
    }
    let mut all = shares.all;
    let starts: f64 = all.iter().map(|s| s.starts).sum();
    for s in &mut all {
        s.times.air = if starts > 0.0 { document.summary.air_time * s.starts / starts } else { 0.0 };
    }
    add_up(&mut all, document);
    let loose = all.pop().unwrap_or_default();
    (all, loose)
}

/// The shares of the parts in the moves so far, and what the next cut needs to know.
struct Shares<'d> {
    document: &'d Document,
    part_of: &'d [Option<usize>],
    /// By part; the last place holds what belongs to no part.
    all: Vec<Seconds>,
    at: DVec2,
    /// Piercings since the last cut, and whether the beam was off or the next cut begins moving.
    pierces: u32,
    dark: bool,
    moving: bool,
    /// A chain to the next cut, and whether the beam was on before it.
    chain: Option<(Vec<Segment>, bool)>,
    /// The elements of a motion that goes on over a joint or to the next cut, and the contours of its cuts with their lengths.
    motion: Vec<Segment>,
    cut_on: Vec<(u32, f64)>,
}

impl<'d> Shares<'d> {
    fn new(document: &'d Document, parts: usize, part_of: &'d [Option<usize>]) -> Self {
        Self {
            document,
            part_of,
            all: vec![Seconds::default(); parts + 1],
            at: document.machine.home(),
            pierces: 0,
            dark: true,
            moving: false,
            chain: None,
            motion: Vec::new(),
            cut_on: Vec::new(),
        }
    }

    /// The seconds of the part that pays for a contour, or of what belongs to no part.
    fn of(&mut self, contour: Option<u32>) -> &mut Seconds {
        let last = contour.map(|contour| self.document.last_pass(contour));
        let known = last.and_then(|last| self.document.contours.get(last as usize));
        let completed = known.filter(|_| PLANS_ALL_LEVERS).and_then(|c| c.completes());
        let part = completed.or(last).and_then(|c| self.part_of.get(c as usize).copied().flatten());
        let none = self.all.len() - 1;
        &mut self.all[part.unwrap_or(none)]
    }

    /// Adds a move.
    fn add(&mut self, index: usize, step: &Move) {
        let machine = &self.document.machine;
        match step {
            Move::Air { to, .. } => (self.at, self.dark) = (DVec2::from(*to), true),
            Move::Pierce => self.pierces += 1,
            Move::MovingStart => self.moving = true,
            Move::PreCut { contour, to, .. } => {
                self.at = DVec2::from(*to);
                self.of(Some(*contour)).times.pre_cut += machine.pre_cut_time.unwrap_or(0.0);
            }
            Move::Macro { contour, .. } => self.of(Some(*contour)).times.macros += machine.macro_time(),
            // With a stop, the time of a joint is part of the air time, which is shared.
            Move::Joint { path, flying, .. } => {
                let path = segments(path, &mut self.at);
                if *flying {
                    self.motion.extend(path);
                }
            }
            // A chain is paid by the part that it leads to, and run like the cut there.
            Move::Chain { path } => {
                let before = index.checked_sub(1).and_then(|before| self.document.moves.get(before));
                let after_cut = matches!(before, Some(Move::Cut { .. }));
                self.chain = Some((segments(path, &mut self.at), after_cut));
            }
            Move::Fly { path } => self.motion.extend(segments(path, &mut self.at)),
            // Their time is part of the air time, which is shared.
            Move::Height { .. } | Move::Wait { .. } => {}
            Move::Cut { contour: Contours::One(id), path, .. } => self.cut(index, &[*id], path),
            Move::Cut { contour: Contours::Several(ids), path, .. } => self.cut(index, ids, path),
        }
    }

    /// Adds a cut along contours.
    fn cut(&mut self, index: usize, ids: &[u32], path: &[Element]) {
        let path = segments(path, &mut self.at);
        let length = path.iter().map(Segment::length).sum::<f64>();
        let outlines = bridged(self.document, ids);
        match &outlines {
            Some(outlines) => {
                let all: f64 = outlines.iter().sum();
                self.cut_on.extend(ids.iter().zip(outlines).map(|(&id, own)| (id, length * own / all)));
            }
            None => self.cut_on.extend(ids.iter().map(|&id| (id, length / ids.len().max(1) as f64))),
        }
        self.motion.extend(path);
        let next = self.document.moves.get(index + 1);
        if !matches!(next, Some(Move::Joint { flying: true, .. } | Move::Fly { .. })) {
            self.end_of_motion(ids, outlines.is_some());
        }
    }

    /// Shares the time of a motion that ends with a cut along contours. `is_bridged`: whether that is around connected parts.
    fn end_of_motion(&mut self, ids: &[u32], is_bridged: bool) {
        let machine = &self.document.machine;
        let process = self.document.process_by_id(ids.first().copied());
        let cut = cut_time(machine, &process, &mem::take(&mut self.motion));
        // A motion is shared by what it cuts of each contour; a cut along several contours equally.
        let cut_on = mem::take(&mut self.cut_on);
        let whole: f64 = cut_on.iter().map(|c| c.1).sum();
        let equal = 1.0 / ids.len().max(1) as f64;
        let alike = cut_on.len() == ids.len() && !is_bridged;
        for &(id, length) in &cut_on {
            let share = if alike { equal } else { length / whole };
            self.of(Some(id)).times.cut += cut * share;
        }
        let (chain, is_on) = self.chain.take().unwrap_or_default();
        let delays = if is_on { 0.0 } else { machine.delays_of_cut(mem::take(&mut self.moving)) };
        let (pierces, dark) = (mem::take(&mut self.pierces), mem::take(&mut self.dark));
        let entered = self.of(cut_on.first().map(|c| c.0));
        entered.pierces += pierces;
        entered.times.cut += cut_time(machine, &process, &chain);
        entered.times.pierce += delays + f64::from(pierces) * machine.pierce_time;
        entered.starts += f64::from(u8::from(dark));
    }
}

/// The lengths of the outlines of connected parts, mm, if a cut goes around these.
fn bridged(document: &Document, ids: &[u32]) -> Option<Vec<f64>> {
    let length =
        |id: &u32| document.contours.get(*id as usize).filter(|c| c.bridged.is_some()).map(|c| c.length);
    if PLANS_ALL_LEVERS && ids.len() > 1 { ids.iter().map(length).collect() } else { None }
}

/// One kind of time.
type Kind = fn(&mut Times) -> &mut f64;

/// Scales each kind of time so that all add up to the job's: a document writes some arcs as chords or as halves, and
/// its times differ from the job's by rounding.
fn add_up(all: &mut [Seconds], document: &Document) {
    let s = &document.summary;
    let kinds: [(Kind, f64); 5] = [
        (|t| &mut t.cut, s.cut_time),
        (|t| &mut t.air, s.air_time),
        (|t| &mut t.pierce, s.pierce_time),
        (|t| &mut t.pre_cut, s.pre_cut_time),
        (|t| &mut t.macros, s.macro_time),
    ];
    for (kind, whole) in kinds {
        let sum: f64 = all.iter_mut().map(|s| *kind(&mut s.times)).sum();
        if sum > 0.0 {
            all.iter_mut().for_each(|s| *kind(&mut s.times) *= whole / sum);
        } else if let Some(loose) = all.last_mut() {
            *kind(&mut loose.times) = whole;
        }
    }
    for s in all {
        let t = &mut s.times;
        t.total = t.cut + t.air + t.pierce + t.pre_cut + t.macros;
    }
}
