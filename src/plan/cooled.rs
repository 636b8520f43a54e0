//! Finds what is due before each cut of a plan because of heat: waits, or pairs of cuts that follow each other too soon.

use super::evaluate::Sums;
use super::model::Move;
use crate::heat::Cooling;
use crate::machine::Profile;
use crate::sheet::Sheet;

/// The same moves with the waits of a machine that waits, and the number of hot pairs of one that does not.
///
/// A cut begins where the head has arrived, before it is lowered and before it pierces, and ends when the beam is off after its last
/// stretch.
pub(super) fn cooled(
    cooling: &Cooling,
    sheet: &Sheet,
    machine: &Profile,
    moves: Vec<Move>,
) -> (Vec<Move>, u32) {
    let mut sums = Sums::new(sheet, machine);
    let mut out: Vec<Move> = Vec::with_capacity(moves.len());
    // The contours cut so far and the seconds at which they ended, and where in `out` the moves of the next cut begin.
    let mut ended: Vec<(u32, f64)> = Vec::new();
    let (mut begins, mut arrival) = (0, 0.0);
    let mut hot = 0;
    let mut rest = moves.into_iter().peekable();
    while let Some(step) = rest.next() {
        if let Move::Cut { contour, .. } = step
            && ended.last().is_none_or(|last| last.0 != contour)
        {
            let due = cooling.due(contour, arrival, ended.iter().rev().copied());
            hot += due.hot;
            if due.wait > 0.0 {
                let wait = Move::Wait { seconds: due.wait };
                sums.add(&wait, false);
                out.insert(begins, wait);
            }
            ended.push((contour, arrival));
        }
        sums.add(&step, rest.peek().is_some_and(Move::runs_on));
        let is_cut = matches!(step, Move::Cut { .. });
        if let Some(last) = ended.last_mut().filter(|_| is_cut) {
            last.1 = sums.seconds();
        }
        let goes_on = !matches!(step, Move::Air { .. } | Move::Cut { .. });
        out.push(step);
        if !goes_on {
            (begins, arrival) = (out.len(), sums.seconds());
        }
    }
    (out, hot)
}
