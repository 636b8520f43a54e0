//! What a dialect cannot do: machines and plans that are refused, each with what to change.

use super::beam::Beam;
use crate::machine::Profile;
use crate::machine::dialect::Dialect;
use crate::number::power_of_ten;
use crate::output::cuts::cuts;
use crate::output::process::CutProcess;
use crate::output::{OutputError, SheetFacts};
use crate::plan::{Move, Plan};

/// Refuses what the dialect cannot do.
pub(super) fn refuse(
    plan: &Plan,
    sheet: &SheetFacts,
    profile: &Profile,
    dialect: &Dialect,
) -> Result<(), OutputError> {
    let Dialect { name, controller, .. } = dialect;
    let refuse = |why: &str| Err(OutputError::Dialect(format!("{controller} (dialect \"{name}\") {why}")));
    let has = |wanted: fn(&Move) -> bool| plan.moves.iter().any(wanted);
    let waits = |seconds: f64| seconds > 0.0 && dialect.dwell.is_none();
    if dialect.pierce.is_none()
        && profile.pierce_time + profile.beam_on_delay > 0.0
        && has(|m| matches!(m, Move::Pierce))
    {
        return refuse(
            "cannot pierce at rest: set the machine's piercing time and beam-on delay to 0, or choose a dialect that pierces.",
        );
    }
    if has(|m| matches!(m, Move::Macro { .. })) {
        if waits(profile.macro_time()) {
            return refuse("cannot wait in sharp corners: switch them off in the machine.");
        }
        if !Beam::new(dialect).goes_off_at_rest() {
            return refuse(
                "cannot switch the beam off at rest, as sharp corners need: switch them off in the machine.",
            );
        }
    }
    if has(|m| matches!(m, Move::Wait { .. })) && dialect.dwell.is_none() {
        return refuse(
            "cannot wait until it has cooled: give near cuts a charge in the machine's levers.heat instead.",
        );
    }
    let waits_lit =
        |m: &[Move; 2]| matches!(m, [before, Move::Wait { .. }] if !matches!(before, Move::Air { .. }));
    if !Beam::new(dialect).goes_off_at_rest() && plan.moves.array_windows().any(waits_lit) {
        return refuse(
            "switches the beam off with the next motion only, and cannot wait where two cuts meet: give near cuts a charge in the machine's levers.heat instead.",
        );
    }
    if has(Move::runs_on) && !Beam::new(dialect).changes_in_motion() {
        return refuse(
            "switches the beam only at rest, so it cannot leave flying joints or cut on the run: set the kind of the joints to stop, and switch off fly cuts.",
        );
    }
    if waits(profile.beam_off_delay) {
        return refuse("cannot wait: set the machine's beam-off delay to 0.");
    }
    let processes: Vec<_> = cuts(plan).iter().map(|cut| CutProcess::of_cut(sheet, profile, cut)).collect();
    let most = profile.top_speed();
    if let Some(fast) = processes.iter().find(|p| p.speed > most) {
        return refuse(&format!(
            "cannot be asked for {} mm/s by a layer, because the machine moves with at most {most} mm/s: lower the speed of the layer, or raise the rapids of the machine.",
            fast.speed
        ));
    }
    let full = dialect.power.full_or(profile.max_s);
    let least = 0.5 / power_of_ten(dialect.power.decimals);
    // Half of the least step is written as 0, too.
    if processes.iter().any(|p| p.power * full <= least) {
        return refuse(
            "cannot cut or mark with a power of 0: raise the power of the machine's process, or of the layer.",
        );
    }
    if dialect.air.is_none() && processes.iter().any(|p| p.air) {
        return refuse(
            "has no command for air: switch the air off in the layers, or give \"air\" in the dialect.",
        );
    }
    if !dialect.z && plan.summary.lifts > 0 {
        return refuse("has no Z axis: switch off lifting the head in the machine.");
    }
    if !dialect.z && processes.iter().any(|p| p.z != 0.0) {
        return refuse("has no Z axis: set the z step of the passes to 0.");
    }
    Ok(())
}
