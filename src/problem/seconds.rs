//! The seconds of contours that do not depend on the order: piercing, the cut, what an entry costs, and what leaving costs.

use crate::lead::starts_moving;
use crate::machine::{ClosedRun, Profile, process_time};
use crate::sheet::{Contour, Operation, Sheet};

/// The fixed seconds of all passes of a contour, and the run whose seconds depend on the entry.
///
/// `may_move`: whether it may begin moving.
pub(super) fn seconds(
    sheet: &Sheet,
    machine: &Profile,
    contour: &Contour,
    passes: u32,
    may_move: bool,
) -> (f64, Option<ClosedRun>) {
    let mark = contour.operation != Operation::Cut;
    let process = &sheet.process_of(contour, machine);
    let start = start_seconds(machine, mark, may_move && starts_moving(sheet, machine, contour, None));
    let path = &contour.path;
    let run = if path.closed { ClosedRun::new(machine, process, mark, &path.segments) } else { None };
    let run = run.map(|run| run.repeated(passes));
    let rounds = f64::from(passes);
    let least = run
        .as_ref()
        .map_or_else(|| rounds * process_time(machine, process, mark, &path.segments), ClosedRun::least);
    // The head is lowered to the deepest pass and raised again before it goes on.
    let deepest = f64::from(contour.pass + passes - 1) * process.z_step;
    (rounds * start + least + 2.0 * machine.height_seconds(deepest), run)
}

/// Seconds of a contour that is worked by itself, from its cheapest entry.
pub(super) fn seconds_alone(sheet: &Sheet, machine: &Profile, contour: &Contour) -> f64 {
    seconds(sheet, machine, contour, 1, true).0
}

/// Seconds of piercing and of the beam's delays of a cut or mark.
pub(super) fn start_seconds(machine: &Profile, mark: bool, moving: bool) -> f64 {
    let pierce = if mark || moving { 0.0 } else { machine.pierce_time };
    pierce + machine.delays_of_cut(moving)
}

/// Seconds of leaving a contour and resuming it: the pre-cut, and the beam off and on once more. `None` for marks and open
/// contours, which are run without interruption.
pub(super) fn leave_seconds(machine: &Profile, contour: &Contour) -> Option<f64> {
    machine
        .pre_cut_time
        .filter(|_| contour.path.closed && contour.operation == Operation::Cut)
        .map(|pre_cut| pre_cut + machine.beam_delays())
}
