//! The best path as numbers in a row, for drawing it: stop k cuts `contours[k]`, or a stretch of it.

use super::Run;
use crate::geometry::Segment;
use crate::machine::{AirTime, Profile, cut_time};
use crate::plan::{Move, Plan};
use crate::sheet::Sheet;

/// The order of the head.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct BestPath {
    /// Contour of each stop.
    pub contours: Vec<u32>,
    /// Entry x, y and exit x, y of each stop, mm.
    pub points: Vec<f64>,
    /// Arc length from the contour's stored start to the entry, mm.
    pub along: Vec<f64>,
    /// The same to where the stop ends; equal: all of the contour. One that is left unfinished has several stops.
    pub until: Vec<f64>,
    /// 1 where a stop runs its contour against the stored direction.
    pub reversed: Vec<u8>,
    /// Seconds from the start of the job at which each stop's beam goes on along its contour, and off.
    pub times: Vec<f64>,
}

impl BestPath {
    /// The best path of a run, and the plan it comes from.
    pub fn of(run: &Run, sheet: &Sheet) -> (Self, Plan) {
        let plan = run.plan(sheet);
        let problem = run.problem();
        let mut path = Self { times: cutting_times(&plan, &run.machine), ..Self::default() };
        for stop in &run.best().stops {
            let node = &problem.nodes[stop.node as usize];
            let (entry, exit) = stop.ends(problem).unwrap_or((node.entry, node.exit));
            path.contours.push(node.item);
            path.points.extend([entry.x, entry.y, exit.x, exit.y]);
            path.along.push(stop.along);
            path.until.push(stop.until);
            path.reversed.push(node.reversed.into());
        }
        (path, plan)
    }
}

/// When the beam is on along each contour: two numbers a cut, seconds from the start of the job. The same sums as
/// [`crate::plan::evaluate`], kept as they run.
fn cutting_times(plan: &Plan, machine: &Profile) -> Vec<f64> {
    let air = AirTime::new(machine);
    let mut times = Vec::with_capacity(plan.moves.len());
    let (mut now, mut head) = (0.0, machine.home());
    for step in &plan.moves {
        match step {
            Move::Air { to } => {
                now += air.seconds(head, *to);
                head = *to;
            }
            Move::Pierce => now += machine.pierce_time,
            Move::PreCut { to, .. } => {
                now += machine.pre_cut_time.unwrap_or(0.0);
                head = *to;
            }
            Move::Cut { path, mark, .. } => {
                let process = if *mark { &machine.mark } else { &machine.cut };
                let begin = now + machine.beam_on_delay;
                let end = begin + cut_time(machine, process, path);
                times.extend([begin, end]);
                now = end + machine.beam_off_delay;
                head = path.last().map_or(head, Segment::end);
            }
        }
    }
    times
}
