//! What a program must keep to: rules of every controller, and agreement with its machine and its plan.

use super::expected::Expected;
use super::problem::{Code, Problems};
use super::program::{Event, Program};
use super::report::Figures;
use super::words::commands;
use crate::finding::Severity;
use crate::machine::Profile;
use crate::machine::dialect::{Dialect, PierceBy};
use crate::number::{fixed, power_of_ten};

/// Largest difference of seconds from the plan, as a fraction and in s. Rounding of coordinates and dwells explains less;
/// a wait in the wrong unit is far more.
const SECONDS: (f64, f64) = (0.02, 0.1);
/// The same where arcs are chords or the piercing is a slow motion, which the plan's seconds do not know.
const SECONDS_ROUGH: (f64, f64) = (0.15, 1.0);
/// Largest difference of the box of all cuts from the plan, mm, besides the rounding of a coordinate.
const BOUNDS: f64 = 0.01;
/// Largest difference of the length of cuts: mm for each contour, and as a fraction, besides the rounding of each motion.
const LENGTH: (f64, f64) = (0.05, 1e-3);
/// By how much chords may be shorter than their arcs, as a fraction of their tolerance: for each contour, and for each rad that they
/// turn. Chords of half the tolerance are shorter by 0.17 of it for a rad of a large circle, and by 0.23 at most.
const CHORDS: f64 = 0.25;
/// Piercings of one wait: a plan may pierce a few times at one place.
const PIERCES_AT_ONCE: u32 = 4;

/// The rules about beam, power, feed and waits, motion by motion.
pub(super) fn beam(
    program: &Program,
    dialect: &Dialect,
    profile: &Profile,
    expected: &Expected,
    problems: &mut Problems,
) {
    let strict = expected.by_kerfway;
    let doubtful = if strict { Severity::Error } else { Severity::Warning };
    let full = dialect.power.full_or(profile.max_s);
    // Half of the last decimal is rounding.
    let slack = 0.5 / power_of_ten(dialect.power.decimals);
    for &(line, power) in &program.powers {
        if !(0.0..=full + slack).contains(&power) {
            problems.error(Code::PowerOutOfRange, Some(line), || {
                format!("Line {line} sets the power {power}; it goes from 0 to {full} on this machine.")
            });
        }
    }
    let fastest = profile.top_speed();
    // Contours since the last wait. Where the beam goes off with the next motion only, contours that follow each other
    // without a rapid leave their waits to the rapid after them.
    let mut contours = 0_u32;
    for event in &program.events {
        match event {
            Event::Height { line, power, .. } | Event::Move { line, rapid: true, power, .. } => {
                let n = *line;
                if power.lit > 0.0 {
                    problems.error(Code::BeamOnRapid, Some(n), || {
                        let to = match event {
                            Event::Move { path, .. } => {
                                format!("to {:.3}, {:.3}", path.end().x, path.end().y)
                            }
                            _ => "to another height".into(),
                        };
                        format!("Line {n} is a rapid {to} with the beam on, at power {}.", power.lit)
                    });
                } else if power.asked > 0.0 {
                    problems.add(Code::PowerOnRapid, doubtful, Some(n), || {
                        format!(
                            "Line {n} is a rapid with the power {} in force: only {} itself keeps the beam off, if it is set up for that.",
                            power.asked, dialect.controller
                        )
                    });
                }
            }
            Event::Move { line, path, power, feed, lifted, .. } => {
                let n = *line;
                if power.lit <= 0.0 && path.length() > 0.0 && strict && expected.dark_length <= 0.0 {
                    problems
                        .error(Code::DarkCut, Some(n), || format!("Line {n} is a cut with the beam off."));
                }
                if *lifted && power.lit > 0.0 && strict {
                    problems
                        .error(Code::LiftedCut, Some(n), || format!("Line {n} cuts with the head lifted."));
                }
                if *feed > fastest * 1.001 {
                    problems.add(Code::FeedOutOfRange, doubtful, Some(n), || {
                        format!(
                            "Line {n} cuts with {:.0} mm/min; this machine moves with at most {:.0}.",
                            feed * 60.0,
                            fastest * 60.0
                        )
                    });
                }
            }
            Event::Dwell { line, seconds, .. } => {
                let contours = std::mem::take(&mut contours).max(1);
                wait(*line, *seconds, contours, dialect, profile, strict, problems);
            }
            Event::Contour { .. } => contours = contours.saturating_add(1),
        }
    }
}

/// A wait of Kerfway's is one that the machine asks for after this many contours; of others, one that a laser may ask for.
fn wait(
    line: u32,
    seconds: f64,
    contours: u32,
    dialect: &Dialect,
    profile: &Profile,
    strict: bool,
    problems: &mut Problems,
) {
    const LONGEST: f64 = 600.0;
    // Of the shortest waits, without what dividing milliseconds by 1000 adds.
    const DIGITS: usize = 9;
    let rounding =
        dialect.dwell.as_ref().map_or(1e-3, |d| 0.5 / power_of_ten(d.decimals) / d.unit.per_second());
    let near = |wanted: f64| wanted > 0.0 && (seconds - wanted).abs() <= rounding + 1e-9;
    let pierces = (0..=PIERCES_AT_ONCE).map(|k| f64::from(k) * profile.pierce_time + profile.beam_on_delay);
    let settles = (1..=contours).any(|k| near(f64::from(k) * profile.beam_off_delay));
    let cools = profile.levers.heat.is_some_and(|h| h.charge.is_none() && seconds <= h.seconds + rounding);
    let of_machine = settles || cools || near(profile.macro_time()) || pierces.into_iter().any(near);
    if (strict && !of_machine) || !(0.0..=LONGEST).contains(&seconds) {
        problems.error(Code::WaitOutOfRange, Some(line), || {
            format!(
                "Line {line} waits {} s; this machine pierces in {} s. Look at the unit of the wait (seconds or milliseconds).",
                fixed(seconds, DIGITS),
                fixed(profile.pierce_time + profile.beam_on_delay, DIGITS)
            )
        });
    }
}

/// The rules about the program as a whole.
pub(super) fn compare(
    figures: &Figures,
    e: &Expected,
    dialect: &Dialect,
    profile: &Profile,
    problems: &mut Problems,
) {
    if figures.stretches == 0 {
        problems.error(Code::Empty, None, || "The program cuts nothing.".into());
    }
    if !figures.dark_at_end {
        problems.error(Code::BeamOnAtEnd, Some(figures.lines), || {
            "The program ends without switching the beam off.".into()
        });
    }
    if figures.fits_bed == Some(false) && !e.may_leave_bed {
        problems.error(Code::OffBed, None, || "The head leaves the bed of the machine.".into());
    }
    once(figures, e, problems);
    if e.by_kerfway {
        ending(figures, dialect, problems);
    }
    let mut differs = |what: &str, is: String, should: String| {
        problems.error(Code::Differs, None, || format!("The program {what} {is}; it should be {should}."));
    };
    let rests = dialect.pierce.as_ref().is_some_and(|p| p.by != PierceBy::Creep) && profile.pierce_time > 0.0;
    // Marks are not pierced, but wait for the beam.
    if let Some(pierces) = e.pierces.filter(|&n| rests && n > figures.pierces) {
        differs("pierces", format!("{} times with the beam on", figures.pierces), pierces.to_string());
    }
    if let Some(lifts) = e.lifts.filter(|&n| n != figures.lifts) {
        differs("lifts the head", format!("{} times", figures.lifts), lifts.to_string());
    }
    // What a coordinate is rounded to, mm.
    let grid = dialect.units.mm() / power_of_ten(dialect.decimals.xy);
    let chords = dialect.chords.unwrap_or(0.0);
    if let Some(length) = e.cut_length {
        let rounding =
            grid * figures.motions + CHORDS * chords * (figures.turns + f64::from(figures.stretches));
        let slack = e.precision + LENGTH.0 * f64::from(figures.stretches) + LENGTH.1 * length + rounding;
        if (figures.cut_length - length).abs() > slack {
            differs("cuts", format!("{:.1} mm", figures.cut_length), format!("{length:.1} mm"));
        }
    }
    if e.by_kerfway && e.dark_length > 0.0 {
        // Both ends of a joint are rounded.
        let slack = e.precision + LENGTH.0 * f64::from(figures.stretches) + LENGTH.1 * e.dark_length;
        if (figures.dark_length - e.dark_length).abs() > slack {
            differs(
                "leaves",
                format!("{:.2} mm dark at joints", figures.dark_length),
                format!("{:.2} mm", e.dark_length),
            );
        }
    }
    let b = figures.bounds;
    if let Some(bounds) = e.bounds.filter(|_| !b.is_empty()) {
        let off = [b.min.x, b.min.y, b.max.x, b.max.y]
            .iter()
            .zip(bounds)
            .fold(0.0, |d: f64, (a, b)| d.max((a - b).abs()));
        if off > e.precision + BOUNDS + 0.5 * grid + chords {
            let shown = |[x0, y0, x1, y1]: [f64; 4]| format!("x {x0:.1} to {x1:.1}, y {y0:.1} to {y1:.1} mm");
            differs("reaches", shown([b.min.x, b.min.y, b.max.x, b.max.y]), shown(bounds));
        }
    }
    if let Some(seconds) = e.seconds {
        let rough = dialect.chords.is_some() || !rests;
        let (share, least) = if rough { SECONDS_ROUGH } else { SECONDS };
        // A pre-cut is charged with a time of the profile, whatever its motion takes; without a length it has none. A header
        // does not say how many there are: at most one before each stretch.
        let most = profile.pre_cut_time.unwrap_or(0.0) * f64::from(figures.stretches);
        let charged = e.pre_cut_seconds.unwrap_or(most);
        // A plan charges a cut through waste from rest to rest, and the program may run on at both of its ends.
        let stop = profile.cut.accel.map_or(0.0, |accel| figures.top_speed / accel);
        let runs_on = if figures.seconds < seconds { 2.0 * f64::from(e.chains) * stop } else { 0.0 };
        if (figures.seconds - seconds).abs() > e.precision + least + share * seconds + charged + runs_on {
            differs("takes", format!("{:.1} s", figures.seconds), format!("{seconds:.1} s"));
        }
    }
}

/// Every contour is cut as often as planned. Of a program of others it is only known what most contours have.
fn once(figures: &Figures, e: &Expected, problems: &mut Problems) {
    if let Some(stretches) = e.stretches {
        if figures.stretches > stretches {
            problems.error(Code::CutTwice, None, || {
                format!(
                    "The program makes {} cuts instead of {stretches}: something is cut more than once.",
                    figures.stretches
                )
            });
        }
        return;
    }
    let Some(normal) = figures.repeats.iter().map(|(_, n)| *n).min() else { return };
    for &(line, n) in figures.repeats.iter().filter(|(_, n)| *n != normal) {
        problems.add(Code::CutTwice, Severity::Warning, Some(line), || {
            format!("The contour that begins at line {line} is cut {n} times, and others {normal} times.")
        });
    }
}

/// The footer is there, command by command, so the program was not cut off.
fn ending(figures: &Figures, dialect: &Dialect, problems: &mut Problems) {
    let mut tail = figures.tail.iter().rev().peekable();
    let is_there = commands(&dialect.footer).iter().rev().all(|line| match line.split_once('{') {
        // A line without a value for its placeholder is not written.
        Some((before, _)) => {
            tail.next_if(|command| command.starts_with(before));
            true
        }
        None => tail.next() == Some(line),
    });
    if !is_there {
        problems.error(Code::Incomplete, Some(figures.lines), || {
            "The end of the program is missing, as if it had been cut off.".into()
        });
    }
}
