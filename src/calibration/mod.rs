//! Fits a machine to measured times: `cut.accel`, `junction_deviation` and `pierce_time` from the seconds that one or two
//! jobs really took.
//!
//! A stopwatch gives one number for each job, and three values are wanted, so the times of one or two jobs agree with many
//! sets of values. The set closest to the present machine is taken: the sum of the squared relative errors of the jobs, plus
//! [`WEIGHT`] times the squared changes of the values (logarithms of the acceleration's and the deviation's ratios, and the
//! change of the pierce time in units of itself), is minimised by damped least squares (Levenberg 1944, Marquardt 1963). Jobs
//! of different kinds, one with many piercings and one with many corners, tell the values apart best.

use crate::geometry::{Segment, math};
use crate::machine::{AirTime, Process, Profile, cut_time};
use crate::plan::AirMoves;
use crate::plan::document::{Document, Element, Move};
use crate::sheet::Operation;
use glam::DVec2;
use serde::Serialize;

/// How much a change of the values counts against an error in the times: a change by a factor of e as much as an error of
/// 0.01 %, far less than a stopwatch tells apart. Measured times are met where a machine can meet them, and the weight only
/// chooses among those machines. At 1e-6, a job of few piercings stayed 1 % off.
const WEIGHT: f64 = 1e-8;
/// Largest change of acceleration and deviation, as a factor: more means that something else is wrong.
const LARGEST: f64 = 20.0;
/// How far a fitted machine may be from a measured time, as a share of it: more is no matter of acceleration, corners and
/// piercing, but of wrong seconds or speeds.
const MISSED: f64 = 0.1;
/// Longest pierce time that a fit may end at, s, if the machine had none longer: no plate takes longer to pierce.
const LONGEST_PIERCE: f64 = 60.0;
/// Unit for changes of a pierce time that is 0, s.
const PIERCE: f64 = 0.1;
/// Rounds of the fit. It converges in fewer than ten.
const ROUNDS: u32 = 40;
/// Step for numerical derivatives.
const STEP: f64 = 1e-4;

/// A plan that was run, and the seconds it took.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The plan.
    pub plan: Document,
    /// Seconds by the clock.
    pub seconds: f64,
}

/// One job of a calibration.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CalibratedJob {
    /// Name of its file.
    pub name: String,
    /// Seconds by the clock.
    pub measured: f64,
    /// Seconds planned with the machine as it was.
    pub before: f64,
    /// Seconds planned with the fitted machine.
    pub after: f64,
}

/// A machine fitted to measured times.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Calibration {
    /// The machine with the fitted values.
    pub machine: Profile,
    /// The jobs it was fitted to.
    pub jobs: Vec<CalibratedJob>,
}

/// Fits a machine to the seconds that jobs took. The plans must be of this machine; its three values are replaced.
///
/// # Errors
/// One sentence: there is no job, a time that cannot be one, or one that no machine near to this one takes.
pub fn calibrate(machine: &Profile, measured: &[Measured]) -> Result<Calibration, String> {
    if measured.is_empty() {
        return Err("There is no job to calibrate with. Give a plan and the seconds it took.".to_owned());
    }
    for Measured { plan, seconds } in measured {
        let holds = seconds.is_finite() && *seconds > 0.0 && *seconds < 1e7;
        if !holds {
            return Err(format!("{} took {seconds} s, which is no time that a job takes.", plan.input.name));
        }
        if plan.summary.cut_length <= 0.0 {
            return Err(format!(
                "{} cuts nothing, so its time says nothing about the machine.",
                plan.input.name
            ));
        }
    }
    let jobs: Vec<Job> = measured.iter().map(Job::new).collect();
    let fitted = fit(machine, &jobs);
    let jobs = jobs.iter().map(|job| CalibratedJob {
        name: job.name.clone(),
        measured: job.measured,
        before: job.seconds(machine),
        after: job.seconds(&fitted),
    });
    let calibration = Calibration { jobs: jobs.collect(), machine: fitted };
    match calibration.unexplained(machine) {
        None => Ok(calibration),
        Some(job) => Err(format!(
            "{} took {} s, and {:.1} s are planned: no acceleration, corner deviation and pierce time near those of the \
             machine explain {}. Check the seconds, and the speeds of the machine.",
            job.name,
            job.measured,
            job.before,
            if measured.len() > 1 { "the times of all jobs together" } else { "the difference" }
        )),
    }
}

impl Calibration {
    /// The job whose time is farthest from that of the fitted machine, if the fit has gone as far as it goes and its values
    /// mean nothing.
    fn unexplained(&self, before: &Profile) -> Option<&CalibratedJob> {
        let missed = |job: &CalibratedJob| (job.after / job.measured - 1.0).abs();
        let worst = self.jobs.iter().max_by(|a, b| missed(a).total_cmp(&missed(b)))?;
        let pierces = self.machine.pierce_time <= before.pierce_time.max(LONGEST_PIERCE);
        (missed(worst) > MISSED || !pierces).then_some(worst)
    }
}

/// What of a plan takes time.
struct Job {
    name: String,
    measured: f64,
    /// Seconds that do not depend on the fitted values: air moves, pre-cuts, pauses, heights.
    fixed: f64,
    pierces: f64,
    /// Runs of the beam, with the process of each, but for its acceleration.
    cuts: Vec<(bool, Process, Vec<Segment>)>,
}

impl Job {
    fn new(measured: &Measured) -> Self {
        let Measured { plan, seconds } = measured;
        let machine = &plan.machine;
        let (air, over_joint) = (AirMoves::new(machine), AirTime::head_down(machine));
        let (mut head, mut height) = (machine.home(), 0.0);
        let (mut moving, mut flying, mut chained, mut after_cut) = (false, false, false, false);
        let (mut fixed, mut pierces, mut cuts) = (0.0, 0.0, Vec::<(bool, Process, Vec<Segment>)>::new());
        let mut chain = None;
        for step in &plan.moves {
            match step {
                Move::Air { to, way } => {
                    let to = DVec2::from(*to);
                    fixed += air.seconds(head, to, *way);
                    head = to;
                }
                Move::Pierce => pierces += 1.0,
                Move::MovingStart => moving = true,
                Move::PreCut { to, .. } => {
                    fixed += machine.pre_cut_time.unwrap_or(0.0);
                    head = DVec2::from(*to);
                }
                Move::Macro { .. } => fixed += machine.macro_time(),
                Move::Wait { seconds } => fixed += seconds,
                Move::Joint { path, flying: runs, .. } => {
                    let from = head;
                    let path = Element::segments(path, &mut head);
                    flying = *runs;
                    match cuts.last_mut().filter(|_| flying) {
                        Some(cut) => cut.2.extend(path),
                        None => fixed += over_joint.seconds(from, head),
                    }
                }
                Move::Fly { path } => {
                    let path = Element::segments(path, &mut head);
                    flying = true;
                    cuts.last_mut().iter_mut().for_each(|cut| cut.2.extend(&path));
                }
                Move::Chain { path } => {
                    chain = Some(Element::segments(path, &mut head));
                    // On a kerf, the beam goes on after it went off.
                    chained = after_cut;
                }
                Move::Height { z } => {
                    fixed += machine.height_seconds(z - height);
                    height = *z;
                }
                Move::Cut { contour, path, .. } => {
                    let known = contour.first().and_then(|c| plan.contours.get(c as usize));
                    let mark = known.is_some_and(|c| c.operation == Operation::Mark);
                    let process = plan.process_by_id(contour.first());
                    // A chain is run like the cut that it leads to.
                    cuts.extend(chain.take().map(|path| (mark, process, path)));
                    let path = Element::segments(path, &mut head);
                    // Over a flying joint the motion goes on.
                    match cuts.last_mut().filter(|_| std::mem::take(&mut flying)) {
                        Some(cut) => cut.2.extend(path),
                        None => {
                            // After a chain the beam is on.
                            if !std::mem::take(&mut chained) {
                                fixed += machine.delays_of_cut(std::mem::take(&mut moving));
                            }
                            cuts.push((mark, process, path));
                        }
                    }
                }
            }
            after_cut = matches!(step, Move::Cut { .. });
        }
        Self { name: plan.input.name.clone(), measured: *seconds, fixed, pierces, cuts }
    }

    /// Seconds of the job on a machine with other values.
    fn seconds(&self, machine: &Profile) -> f64 {
        let cut = |(mark, process, path): &(bool, Process, Vec<_>)| {
            let accel = machine.process(*mark).accel;
            cut_time(machine, &Process { accel, ..*process }, path)
        };
        self.fixed + self.pierces * machine.pierce_time + self.cuts.iter().map(cut).sum::<f64>()
    }
}

/// Changes of the three values; see the module's documentation.
type Change = [f64; 3];

fn changed(machine: &Profile, [accel, deviation, pierce]: Change) -> Profile {
    let unit = machine.pierce_time.max(PIERCE);
    let scale = |log: f64| math::exp(log);
    let mut fitted = machine.clone();
    // Marking runs with the same drives, so its acceleration changes with that of cutting.
    fitted.cut.accel = machine.cut.accel.map(|a| a * scale(accel));
    fitted.mark.accel = machine.mark.accel.map(|a| a * scale(accel));
    fitted.junction_deviation = machine.junction_deviation.map(|d| d * scale(deviation));
    fitted.pierce_time = (machine.pierce_time + pierce * unit).max(0.0);
    fitted
}

/// The residuals: relative errors of the jobs, and weighted changes.
fn residuals(machine: &Profile, jobs: &[Job], change: Change) -> Vec<f64> {
    let fitted = changed(machine, change);
    let errors = jobs.iter().map(|job| job.seconds(&fitted) / job.measured - 1.0);
    errors.chain(change.map(|c| c * WEIGHT.sqrt())).collect()
}

fn fit(machine: &Profile, jobs: &[Job]) -> Profile {
    let square = |r: &[f64]| r.iter().map(|v| v * v).sum::<f64>();
    let limit = math::ln(LARGEST);
    let least = -machine.pierce_time / machine.pierce_time.max(PIERCE);
    let clamped = |c: Change| [c[0].clamp(-limit, limit), c[1].clamp(-limit, limit), c[2].max(least)];
    let (mut change, mut damping) = ([0.0; 3], 1e-3);
    let mut now = residuals(machine, jobs, change);
    for _ in 0..ROUNDS {
        let columns: Vec<Vec<f64>> = (0..3)
            .map(|k| {
                let mut beside = change;
                beside[k] += STEP;
                let there = residuals(machine, jobs, beside);
                there.iter().zip(&now).map(|(a, b)| (a - b) / STEP).collect()
            })
            .collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut normal = [[0.0; 4]; 3];
        for (row, a) in normal.iter_mut().zip(&columns) {
            for (cell, b) in row.iter_mut().zip(&columns) {
                *cell = dot(a, b);
            }
            row[3] = -dot(a, &now);
        }
        for (k, row) in normal.iter_mut().enumerate() {
            row[k] *= 1.0 + damping;
        }
        let step = solved(normal);
        let there = clamped([change[0] + step[0], change[1] + step[1], change[2] + step[2]]);
        let then = residuals(machine, jobs, there);
        if square(&then) < square(&now) {
            (change, now, damping) = (there, then, damping * 0.3);
        } else {
            damping *= 10.0;
        }
    }
    changed(machine, change)
}

/// Solves three equations by elimination with pivoting; the last column is the right side.
fn solved(mut rows: [[f64; 4]; 3]) -> Change {
    for k in 0..3 {
        let pivot = (k..3).fold(k, |best, r| if rows[r][k].abs() > rows[best][k].abs() { r } else { best });
        rows.swap(k, pivot);
        if rows[k][k] == 0.0 {
            return [0.0; 3];
        }
        let pivot = rows[k];
        for row in rows.iter_mut().skip(k + 1) {
            let factor = row[k] / pivot[k];
            for (cell, above) in row.iter_mut().zip(pivot).skip(k) {
                *cell -= factor * above;
            }
        }
    }
    let mut x = [0.0; 3];
    for k in (0..3).rev() {
        let known: f64 = (k + 1..3).map(|c| rows[k][c] * x[c]).sum();
        x[k] = (rows[k][3] - known) / rows[k][k];
    }
    x
}
