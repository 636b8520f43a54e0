//! What a program must keep to as a whole: it is complete, and agrees with its plan.

use super::expected::Expected;
use super::problem::{Code, Problems};
use super::report::Figures;
use super::words::commands;
use crate::finding::Severity;
use crate::machine::Profile;
use crate::machine::dialect::{Dialect, PierceBy};
use crate::number::power_of_ten;

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
    let both = Both { figures, e, dialect, profile };
    let differences =
        [both.pierces(), both.lifts(), both.cut_length(), both.dark_length(), both.reach(), both.seconds()];
    for Difference { what, is, should } in differences.into_iter().flatten() {
        problems.error(Code::Differs, None, || format!("The program {what} {is}; it should be {should}."));
    }
}

/// A program is not what its plan says.
struct Difference {
    what: &'static str,
    is: String,
    should: String,
}

/// The figures of a program, and those of its plan.
struct Both<'a> {
    figures: &'a Figures,
    e: &'a Expected,
    dialect: &'a Dialect,
    profile: &'a Profile,
}

impl Both<'_> {
    /// Whether the head rests while it pierces.
    fn rests(&self) -> bool {
        self.dialect.pierce.as_ref().is_some_and(|p| p.by != PierceBy::Creep)
            && self.profile.pierce_time > 0.0
    }

    /// What a coordinate is rounded to, mm.
    fn grid(&self) -> f64 {
        self.dialect.units.mm() / power_of_ten(self.dialect.decimals.xy)
    }

    /// Largest distance of chords from their arcs, mm.
    fn chords(&self) -> f64 {
        self.dialect.chords.unwrap_or(0.0)
    }

    /// By how much a length of cuts may differ, mm, besides the rounding of each motion.
    fn length_slack(&self, length: f64) -> f64 {
        self.e.precision + LENGTH.0 * f64::from(self.figures.stretches) + LENGTH.1 * length
    }

    fn pierces(&self) -> Option<Difference> {
        let are = self.figures.pierces;
        // Marks are not pierced, but wait for the beam.
        let should = self.e.pierces.filter(|&n| self.rests() && n > are)?;
        let is = format!("{are} times with the beam on");
        Some(Difference { what: "pierces", is, should: should.to_string() })
    }

    fn lifts(&self) -> Option<Difference> {
        let are = self.figures.lifts;
        let should = self.e.lifts.filter(|&n| n != are)?;
        Some(Difference { what: "lifts the head", is: format!("{are} times"), should: should.to_string() })
    }

    fn cut_length(&self) -> Option<Difference> {
        let (is, should) = (self.figures.cut_length, self.e.cut_length?);
        let turns = self.figures.turns + f64::from(self.figures.stretches);
        let rounding = self.grid() * self.figures.motions + CHORDS * self.chords() * turns;
        let differs = (is - should).abs() > self.length_slack(should) + rounding;
        differs.then(|| Difference {
            what: "cuts",
            is: format!("{is:.1} mm"),
            should: format!("{should:.1} mm"),
        })
    }

    /// The length that is left uncut at joints. Both ends of a joint are rounded.
    fn dark_length(&self) -> Option<Difference> {
        let (is, should) = (self.figures.dark_length, self.e.dark_length);
        let is_known = self.e.by_kerfway && should > 0.0;
        let differs = is_known && (is - should).abs() > self.length_slack(should);
        differs.then(|| Difference {
            what: "leaves",
            is: format!("{is:.2} mm dark at joints"),
            should: format!("{should:.2} mm"),
        })
    }

    /// The box of all cuts.
    fn reach(&self) -> Option<Difference> {
        let b = self.figures.bounds;
        let should = self.e.bounds.filter(|_| !b.is_empty())?;
        let is = [b.min.x, b.min.y, b.max.x, b.max.y];
        let off = is.iter().zip(should).fold(0.0, |d: f64, (a, b)| d.max((a - b).abs()));
        let differs = off > self.e.precision + BOUNDS + 0.5 * self.grid() + self.chords();
        let shown = |[x0, y0, x1, y1]: [f64; 4]| format!("x {x0:.1} to {x1:.1}, y {y0:.1} to {y1:.1} mm");
        differs.then(|| Difference { what: "reaches", is: shown(is), should: shown(should) })
    }

    fn seconds(&self) -> Option<Difference> {
        let (is, should) = (self.figures.seconds, self.e.seconds?);
        let rough = self.dialect.chords.is_some() || !self.rests();
        let (share, least) = if rough { SECONDS_ROUGH } else { SECONDS };
        // A pre-cut is charged with a time of the profile, whatever its motion takes; without a length it has none. A header
        // does not say how many there are: at most one before each stretch.
        let most = self.profile.pre_cut_time.unwrap_or(0.0) * f64::from(self.figures.stretches);
        let charged = self.e.pre_cut_seconds.unwrap_or(most);
        // A plan charges cuts through waste, and passes, from rest to rest, and the program may run on at both of their ends:
        // between passes where nothing waits for the beam.
        let [cut, mark] =
            [(self.profile.cut, self.figures.top_speed), (self.profile.mark, self.figures.top_mark)]
                .map(|(process, speed)| process.accel.map_or(0.0, |accel| speed / accel));
        let ends = f64::from(self.e.chains.max(self.figures.runs_on));
        let runs_on = if is < should { 2.0 * ends * cut.max(mark) } else { 0.0 };
        let slack = self.e.precision + least + share * should + charged + runs_on;
        let differs = (is - should).abs() > slack;
        differs.then(|| Difference {
            what: "takes",
            is: format!("{is:.1} s"),
            should: format!("{should:.1} s"),
        })
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
