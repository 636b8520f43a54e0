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
use crate::plan::document::{Contours, Document, Move, segments};

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
    // The last place holds what belongs to no part.
    let mut all = vec![Seconds::default(); parts + 1];
    let owner = |contour: u32| {
        let last = document.last_pass(contour);
        let known = document.contours.get(last as usize).filter(|_| PLANS_ALL_LEVERS);
        let last = known.and_then(|c| c.completes()).unwrap_or(last);
        part_of.get(last as usize).copied().flatten().unwrap_or(parts)
    };
    let machine = &document.machine;
    let mut at = machine.home();
    let (mut pierces, mut dark, mut moving) = (0, true, false);
    // A chain to the next cut, and whether the beam was on before it.
    let mut chain = None;
    // The elements of a motion that goes on over a joint or to the next cut, and the contours of its cuts with their lengths.
    let (mut motion, mut cut_on) = (Vec::new(), Vec::new());
    for (index, step) in document.moves.iter().enumerate() {
        match step {
            Move::Air { to, .. } => (at, dark) = (DVec2::from(*to), true),
            Move::Pierce => pierces += 1,
            Move::MovingStart => moving = true,
            Move::PreCut { contour, to, .. } => {
                at = DVec2::from(*to);
                all[owner(*contour)].times.pre_cut += machine.pre_cut_time.unwrap_or(0.0);
            }
            Move::Macro { contour, .. } => all[owner(*contour)].times.macros += machine.macro_time(),
            // With a stop, the time of a joint is part of the air time, which is shared.
            Move::Joint { path, flying, .. } => {
                let path = segments(path, &mut at);
                if *flying {
                    motion.extend(path);
                }
            }
            // A chain is paid by the part that it leads to, and run like the cut there.
            Move::Chain { path } => {
                let after_cut = index > 0 && matches!(document.moves.get(index - 1), Some(Move::Cut { .. }));
                chain = Some((segments(path, &mut at), after_cut));
            }
            Move::Fly { path } => motion.extend(segments(path, &mut at)),
            // Their time is part of the air time, which is shared.
            Move::Height { .. } | Move::Wait { .. } => {}
            Move::Cut { contour, path, .. } => {
                let ids: &[u32] = match contour {
                    Contours::One(id) => &[*id],
                    Contours::Several(ids) => ids,
                };
                let path = segments(path, &mut at);
                let length = path.iter().map(Segment::length).sum::<f64>();
                let outlines = bridged(document, ids);
                match &outlines {
                    Some(outlines) => {
                        let all: f64 = outlines.iter().sum();
                        cut_on.extend(ids.iter().zip(outlines).map(|(&id, own)| (id, length * own / all)));
                    }
                    None => cut_on.extend(ids.iter().map(|&id| (id, length / ids.len().max(1) as f64))),
                }
                motion.extend(path);
                if matches!(
                    document.moves.get(index + 1),
                    Some(Move::Joint { flying: true, .. } | Move::Fly { .. })
                ) {
                    continue;
                }
                let path = std::mem::take(&mut motion);
                let process = document.process_by_id(ids.first().copied());
                let cut = cut_time(machine, &process, &path);
                // A motion is shared by what it cuts of each contour; a cut along several contours equally.
                let whole: f64 = cut_on.iter().map(|c| c.1).sum();
                let equal = 1.0 / ids.len().max(1) as f64;
                let alike = cut_on.len() == ids.len() && outlines.is_none();
                let share = |length: f64| if alike { equal } else { length / whole };
                for &(id, length) in &cut_on {
                    all[owner(id)].times.cut += cut * share(length);
                }
                let first = cut_on.drain(..).next().map_or(parts, |(id, _)| owner(id));
                let entered = &mut all[first];
                entered.pierces += pierces;
                let (path, is_on) = chain.take().unwrap_or_default();
                entered.times.cut += cut_time(machine, &process, &path);
                let delays = if is_on { 0.0 } else { machine.delays_of_cut(std::mem::take(&mut moving)) };
                entered.times.pierce += delays + f64::from(pierces) * machine.pierce_time;
                entered.starts += f64::from(u8::from(dark));
                (pierces, dark) = (0, false);
            }
        }
    }
    let starts: f64 = all.iter().map(|s| s.starts).sum();
    for s in &mut all {
        s.times.air = if starts > 0.0 { document.summary.air_time * s.starts / starts } else { 0.0 };
    }
    add_up(&mut all, document);
    let loose = all.pop().unwrap_or_default();
    (all, loose)
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
