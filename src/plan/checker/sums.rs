//! Adds up lengths, counts and times again, with the formulas of `textbook.rs`.

use super::groups::Groups;
use super::joints;
use super::leads::overcut;
use super::textbook::{air_time, is_lifted, trapezoid};
use super::tolerance::{SAME, rounding};
use super::violation::Violation;
use crate::geometry::{Aabb, DVec2, Path, Segment};
use crate::machine::{Profile, cut_time};
use crate::order::sort_by;
use crate::plan::model::{Leads, Move, Plan, Summary, Way};
use crate::sheet::Sheet;
use rustc_hash::FxHashSet;

/// Relative difference within which sums agree: thousands of additions in another order.
const RELATIVE: f64 = 1e-9;

pub(super) fn check(
    sheet: &Sheet,
    machine: &Profile,
    groups: &Groups,
    plan: &Plan,
    found: &mut Vec<Violation>,
) {
    let mut sums = Sums::new(sheet, machine, groups, &plan.moves);
    for (step, m) in plan.moves.iter().enumerate() {
        sums.add(step, m);
    }
    sums.check_bounds(&plan.summary, found);
    for (what, says, adds_up) in sums.finish(&plan.summary) {
        // Written so that NaN is a violation too.
        let agrees = (says - adds_up).abs() <= RELATIVE * (1.0 + adds_up.abs());
        if !agrees {
            found.push(Violation::Sum { what, says, found: adds_up });
        }
    }
}

/// The contour of a cut that leaves its path in a corner.
fn turned(m: &Move) -> Option<u32> {
    match m {
        Move::Cut { contour, turns, .. } if !turns.is_empty() => Some(*contour),
        _ => None,
    }
}

/// How often something happens.
#[derive(Default)]
struct Counts {
    /// Times that the beam is switched on along contours.
    cuts: u32,
    pierces: u32,
    moving_starts: u32,
    pre_cuts: u32,
    macros: u32,
    fly_cuts: u32,
    chains: u32,
    edge_starts: u32,
    /// Joints with a stop.
    stops: u32,
    waits: u32,
    lifts: u32,
    detours: u32,
    crossings: u32,
}

/// Lengths in mm.
#[derive(Default)]
struct Lengths {
    air: f64,
    cut: f64,
    lead: f64,
    chain: f64,
}

/// Times in s.
#[derive(Default)]
struct Seconds {
    /// Moves with the beam off, those over joints, lowering and waits among them.
    air: f64,
    cut: f64,
    joint: f64,
    wait: f64,
}

/// The sums so far, and what the next move needs to know.
struct Sums<'c> {
    sheet: &'c Sheet,
    machine: &'c Profile,
    moves: &'c [Move],
    /// The path of each contour.
    paths: Vec<&'c Path>,
    /// Contours that leave their paths in a corner, in any of their cuts.
    turned: FxHashSet<u32>,
    head: DVec2,
    height: f64,
    /// The elements of a motion that goes on over a joint or to the next cut.
    motion: Vec<Segment>,
    /// The contours of all cuts.
    worked: Vec<u32>,
    bounds: Aabb,
    /// How far bounds may be off, mm: rounding of the elements of the contours.
    slack: f64,
    counts: Counts,
    lengths: Lengths,
    seconds: Seconds,
}

impl<'c> Sums<'c> {
    fn new(sheet: &'c Sheet, machine: &'c Profile, groups: &'c Groups, moves: &'c [Move]) -> Self {
        Self {
            sheet,
            machine,
            moves,
            paths: groups.paths(),
            turned: moves.iter().filter_map(turned).collect(),
            head: machine.home(),
            height: 0.0,
            motion: Vec::new(),
            worked: Vec::new(),
            bounds: Aabb::EMPTY,
            slack: 0.0,
            counts: Counts::default(),
            lengths: Lengths::default(),
            seconds: Seconds::default(),
        }
    }

    /// Adds a move.
    fn add(&mut self, step: usize, m: &Move) {
        match m {
            Move::Air { to, way } => self.air(step, *to, *way),
            Move::Pierce => self.counts.pierces += 1,
            Move::MovingStart => self.counts.moving_starts += 1,
            Move::PreCut { .. } => self.counts.pre_cuts += 1,
            Move::Macro { .. } => self.counts.macros += 1,
            Move::Wait { seconds } => {
                self.counts.waits += 1;
                self.seconds.wait += seconds;
                self.seconds.air += seconds;
            }
            Move::Height { z } => {
                let by = (z - self.height).abs();
                self.seconds.air += self.machine.z_speed.map_or(0.0, |speed| by / speed);
                self.height = *z;
            }
            Move::Chain { path } => self.chain(step, path),
            Move::Fly { path } => {
                self.counts.fly_cuts += 1;
                self.motion.extend(path);
            }
            Move::Joint { path, flying: true, .. } => self.motion.extend(path),
            Move::Joint { path, .. } => {
                let to = path.last().map_or(self.head, Segment::end);
                let seconds = air_time(self.machine, to - self.head, false);
                self.lengths.air += (to - self.head).length();
                self.seconds.air += seconds;
                self.seconds.joint += seconds;
                self.counts.stops += 1;
            }
            Move::Cut { contour, with, path, leads, .. } => {
                self.worked.push(*contour);
                self.worked.extend(with);
                self.bound(*contour, with, path);
                self.leads(path, leads);
                self.cut(step, *contour, path);
            }
        }
        self.head = m.end().unwrap_or(self.head);
    }

    fn air(&mut self, step: usize, to: DVec2, way: Way) {
        let lifted = is_lifted(self.machine, to - self.head, way);
        self.lengths.air += (to - self.head).length();
        self.seconds.air += air_time(self.machine, to - self.head, lifted);
        let is_around = |m: &Move| matches!(m, Move::Air { way: Way::Around, .. });
        let begins = !(step > 0 && is_around(&self.moves[step - 1]));
        self.counts.detours += u32::from(way == Way::Around && begins);
        self.counts.crossings += u32::from(way == Way::Crosses);
        self.counts.lifts += u32::from(lifted);
    }

    fn chain(&mut self, step: usize, path: &[Segment]) {
        let length = path.iter().map(|s| s.end().distance(s.start())).sum::<f64>();
        self.counts.chains += 1;
        self.counts.edge_starts += u32::from(step > 0 && !matches!(self.moves[step - 1], Move::Cut { .. }));
        self.lengths.chain += length;
        self.lengths.cut += length;
        // From rest to rest, with the speed and acceleration of the cut that follows.
        let process = match self.moves.get(step + 1) {
            Some(Move::Cut { contour, .. }) => self.sheet.process_by_id(*contour, self.machine),
            _ => self.machine.cut,
        };
        let (v, a) = (process.speed, process.accel.unwrap_or(f64::INFINITY));
        self.seconds.cut += path.iter().map(|s| trapezoid(s.end().distance(s.start()), v, a)).sum::<f64>();
        // It may begin at the edge of the sheet, beyond all contours.
        self.bounds = path.iter().fold(self.bounds, |b, s| b.union(s.bounds()));
    }

    /// Adds what a cut of contours bounds.
    fn bound(&mut self, contour: u32, with: &[u32], path: &[Segment]) {
        let known = self.sheet.contours.get(contour as usize);
        let has_gap = known.is_some_and(|c| overcut(self.sheet, self.machine, contour, c) < 0.0);
        let has_joints = joints::asked(self.sheet, self.machine, contour).is_some();
        if has_gap || has_joints || self.turned.contains(&contour) {
            // A gap, a joint or a rounded corner may be where the contour reaches farthest, and a loop reaches beyond it.
            self.bounds = path.iter().fold(self.bounds, |b, s| b.union(s.bounds()));
            return;
        }
        for path in with.iter().chain([&contour]).filter_map(|&c| self.paths.get(c as usize)) {
            self.bounds = self.bounds.union(path.bounds());
            self.slack = path.segments.iter().map(rounding).fold(self.slack, f64::max);
        }
    }

    fn leads(&mut self, path: &[Segment], leads: &Leads) {
        let [lead_in, _, overcut, lead_out] = leads.divide(path);
        for s in lead_in.iter().chain(lead_out) {
            self.bounds = self.bounds.union(s.bounds());
            self.lengths.lead += s.length();
        }
        self.lengths.lead += overcut.iter().map(|s| s.length()).sum::<f64>();
    }

    fn cut(&mut self, step: usize, contour: u32, path: &[Segment]) {
        self.lengths.cut += path.iter().map(|s| s.length()).sum::<f64>();
        self.motion.extend(path);
        if self.moves.get(step + 1).is_some_and(Move::runs_on) {
            return;
        }
        // After a chain the beam is on, unless that began on a kerf.
        let chained =
            step > 1 && matches!(self.moves[step - 2..step], [Move::Cut { .. }, Move::Chain { .. }]);
        self.counts.cuts += u32::from(!chained);
        let process = self.sheet.process_by_id(contour, self.machine);
        self.seconds.cut += cut_time(self.machine, &process, &self.motion);
        self.motion.clear();
    }

    /// Number of contours that are worked, and of open ones among them.
    fn contours(&mut self) -> [usize; 2] {
        // A contour that is cut in several stretches counts once.
        sort_by(&mut self.worked, |&c| [c.into(), 0, 0]);
        self.worked.dedup();
        // The earlier passes over a line are no contours of their own, nor are cuts that nobody drew.
        let known = self.worked.iter().filter_map(|&c| self.sheet.contours.get(c as usize));
        let counted = known.filter(|c| c.next_pass.is_none() && !c.is_added());
        counted.fold([0, 0], |[all, open], c| [all + 1, open + usize::from(!c.path.closed)])
    }

    /// Compares the bounds of the summary with those of the cuts.
    fn check_bounds(&self, summary: &Summary, found: &mut Vec<Violation>) {
        if self.bounds.is_empty() {
            return;
        }
        let names = ["the least x", "the least y", "the greatest x", "the greatest y"];
        let Aabb { min, max } = self.bounds;
        for ((what, says), place) in names.into_iter().zip(summary.bounds).zip([min.x, min.y, max.x, max.y]) {
            // Coordinates are not sums. The bounding box of an arc that is entered in its middle, or cut backwards, is computed
            // from other ends.
            let agrees = (says - place).abs() <= SAME + self.slack;
            if !agrees {
                found.push(Violation::Sum { what, says, found: place });
            }
        }
    }

    /// Each sum with its name: what the summary says, and what the moves add up to.
    fn finish(mut self, s: &Summary) -> Vec<(&'static str, f64, f64)> {
        let [contours, open] = self.contours();
        let parts = u32::try_from(self.sheet.parts.len()).unwrap_or(u32::MAX);
        let Self { machine, counts, lengths, seconds, .. } = self;
        let at_rest = f64::from(counts.cuts) - f64::from(counts.moving_starts);
        let pierce = f64::from(counts.pierces) * machine.pierce_time
            + at_rest * machine.beam_on_delay
            + f64::from(counts.cuts) * machine.beam_off_delay;
        let pre_cut = f64::from(counts.pre_cuts) * machine.pre_cut_time.unwrap_or(0.0);
        let macros = machine.macro_time() * f64::from(counts.macros);
        let joint = seconds.joint
            + f64::from(counts.stops)
                * (machine.pierce_time + machine.beam_on_delay + machine.beam_off_delay);
        let total = seconds.air + seconds.cut + pierce + pre_cut + macros;
        let mut sums = vec![
            ("the number of contours", f64::from(s.contours), contours as f64),
            ("the number of open contours", f64::from(s.open_contours), open as f64),
            ("the number of parts", f64::from(s.parts), f64::from(parts)),
            ("the number of piercings", f64::from(s.pierces), f64::from(counts.pierces)),
            ("the number of moving starts", f64::from(s.moving_starts), f64::from(counts.moving_starts)),
            ("the number of cuts on the run", f64::from(s.fly_cuts), f64::from(counts.fly_cuts)),
            ("the number of chains", f64::from(s.chains), f64::from(counts.chains)),
            ("the number of edge starts", f64::from(s.edge_starts), f64::from(counts.edge_starts)),
            ("the length of chains", s.chain_length, lengths.chain),
            ("the number of lifts", f64::from(s.lifts), f64::from(counts.lifts)),
            ("the number of detours", f64::from(s.detours), f64::from(counts.detours)),
            ("the number of crossings", f64::from(s.crossings), f64::from(counts.crossings)),
            ("the number of waits", f64::from(s.waits), f64::from(counts.waits)),
            ("the time of waits", s.wait_time, seconds.wait),
            ("the number of pre-cuts", f64::from(s.pre_cuts), f64::from(counts.pre_cuts)),
            ("the length of air moves", s.air_length, lengths.air),
            ("the length of cuts", s.cut_length, lengths.cut),
            ("the time of joints", s.joint_time, joint),
            ("the length of leads", s.lead_length, lengths.lead),
            ("the time of air moves", s.air_time, seconds.air),
            ("the time of cuts", s.cut_time, seconds.cut),
            ("the time of piercing", s.pierce_time, pierce),
            ("the time of pre-cuts", s.pre_cut_time, pre_cut),
            ("the time of macros", s.macro_time, macros),
            ("the total time", s.total_time, total),
        ];
        if s.lower_bound > 0.0 {
            sums.push(("the lower bound", s.lower_bound, s.lower_bound.min(total)));
            sums.push(("the gap", s.gap.unwrap_or(f64::NAN), (total - s.lower_bound) / s.lower_bound));
        }
        sums
    }
}
