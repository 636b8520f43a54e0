//! Seconds that a strip saves: a piercing and a move, for the time in which its sides are cut.
//!
//! Cutting is priced around the strip: from some way before each opening to some way behind it, once along both outlines, and once along both
//! sides of the strip. The stretches are long enough to reach the speed of the cut, or half of what is left of the outline. Strips of one
//! outline are priced as if each were alone.
//!
//! Where the machine cuts the bridges later, the two cuts across the strip are charged as well: from rest to rest, with the delays of the beam, a
//! move from one to the other, and one to the strip, which is counted as long as a side of a square as large as the smaller part.

use super::strip::Candidate;
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::{AirTime, Process, Profile, process_time};

/// What cutting costs on one machine.
pub(super) struct Prices<'m> {
    machine: &'m Profile,
    air: AirTime,
}

impl<'m> Prices<'m> {
    pub(super) fn new(machine: &'m Profile) -> Self {
        Self { machine, air: AirTime::new(machine) }
    }

    /// The seconds that a strip between two outlines saves, each run in `passes` passes. The move that it saves is counted as long as
    /// the strip: no move between the two outlines is shorter.
    pub(super) fn saved(
        &self,
        candidate: &Candidate,
        outlines: [&Path; 2],
        process: &Process,
        passes: u32,
    ) -> f64 {
        let [[a, b], [c, d]] = candidate.strip.sides;
        let sides = [Segment::line(a, b), Segment::line(c, d)];
        let reach = process.accel.map_or(0.0, |accel| process.speed * process.speed / accel);
        let open = |k: usize| Stretch::new(outlines[k], candidate.openings[k], reach);
        let (first, second) = (open(0), open(1));
        let time = |parts: [&[Segment]; 3]| process_time(self.machine, process, false, &parts.concat());
        let apart = time([&first.before, &first.opening, &first.after])
            + time([&second.before, &second.opening, &second.after]);
        let joined = time([&first.before, &sides[..1], &second.after])
            + time([&second.before, &sides[1..], &first.after]);
        // What begins moving is pierced on the way.
        let moving = passes == 1 && self.machine.levers.moving_pierce.is_some();
        let pierce = if moving { 0.0 } else { self.machine.pierce_time };
        let delays = self.machine.delays_of_cut(moving);
        let later = self.machine.levers.bridges.is_some_and(|bridges| bridges.cut_later);
        let later = if later { self.later(candidate, outlines, process, passes) } else { 0.0 };
        self.air.seconds(a, b) + f64::from(passes) * (pierce + delays + apart - joined) - later
    }

    /// The seconds of the two cuts across a strip, which begin on a kerf.
    fn later(&self, candidate: &Candidate, outlines: [&Path; 2], process: &Process, passes: u32) -> f64 {
        let [[a, b], _] = candidate.strip.sides;
        let cut = |k: usize| {
            let [from, to] = candidate.openings[k];
            let seconds = process_time(self.machine, process, false, &outlines[k].between(from, to));
            f64::from(passes) * (seconds + self.machine.beam_delays())
        };
        let [one, other] = outlines.map(|outline| outline.area().abs());
        let there = self.air.seconds(a, a + DVec2::X * one.min(other).sqrt());
        cut(0) + cut(1) + self.air.seconds(a, b) + there
    }
}

/// An opening of an outline, and what comes before and after it.
struct Stretch {
    before: Vec<Segment>,
    opening: Vec<Segment>,
    after: Vec<Segment>,
}

impl Stretch {
    /// With `reach` mm on either side of the opening, or half of the rest of the outline.
    fn new(outline: &Path, [from, to]: [f64; 2], reach: f64) -> Self {
        let whole = outline.length();
        let open = if from < to { to - from } else { to + whole - from };
        let reach = reach.max(1.0).min(0.5 * (whole - open));
        let wrapped = |along: f64| {
            if along < 0.0 {
                along + whole
            } else if along >= whole {
                along - whole
            } else {
                along
            }
        };
        Self {
            before: outline.between(wrapped(from - reach), from),
            opening: outline.between(from, to),
            after: outline.between(to, wrapped(to + reach)),
        }
    }
}
