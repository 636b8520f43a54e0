//! Lines that move the head or make it wait.

use super::super::problem::Code;
use super::super::program::Event;
use super::super::words::Line;
use super::Reader;
use crate::geometry::{Arc, DVec2, Segment};
use crate::machine::dialect::PowerBy;

/// Differences of the two radii of an arc that every controller accepts, mm and as a fraction (LinuxCNC, GRBL).
const RADIUS: (f64, f64) = (0.005, 0.001);

impl Reader<'_, '_> {
    pub(super) fn dwell(&mut self, line: &Line) {
        let number = self.number;
        let Some(dwell) = &self.dialect.dwell else {
            return self.unreadable("waits, which this dialect cannot");
        };
        let word = dwell.word.chars().next().unwrap_or('P');
        // Marlin takes seconds as S as well, and S wins.
        let seconds = match (line.value(word), line.value('S')) {
            (_, Some(s))
                if self.dialect.power.by == PowerBy::InlineM3
                    || self.dialect.power.by == PowerBy::FanM106 =>
            {
                s
            }
            (Some(time), _) => time / dwell.unit.per_second(),
            _ => return self.unreadable(&format!("waits without the word {word}")),
        };
        let power = self.beam.standing(self.motion != 0);
        if power.asked > 0.0 && power.lit == 0.0 {
            self.problems.error(Code::DarkPierce, Some(number), || {
                format!(
                    "Line {number} waits {seconds} s with the beam off, although the power {} is in force: on {} it acts only with a motion.",
                    power.asked, self.dialect.controller
                )
            });
        }
        self.program.events.push(Event::Dwell { line: number, seconds, power });
    }

    pub(super) fn moves(&mut self, line: &Line, unit: f64) {
        let number = self.number;
        if self.unit.is_none() {
            self.problems.error(Code::UnitsUnknown, Some(number), || {
                format!("Line {number} moves before the program has said whether its numbers are millimetres (G21) or inches (G20).")
            });
            self.unit = Some(unit);
        }
        if !std::mem::replace(&mut self.moved, true) {
            self.program.begins_relative = self.relative;
        }
        let base = if self.relative { self.at } else { DVec2::ZERO };
        let coordinate =
            |letter: char, base: f64, now: f64| line.value(letter).map_or(now, |v| base + v * unit);
        let to = DVec2::new(coordinate('X', base.x, self.at.x), coordinate('Y', base.y, self.at.y));
        let rapid = self.motion == 0;
        let path = if self.motion < 2 { Segment::line(self.at, to) } else { self.arc(line, to, unit) };
        let power = self.beam.moving(rapid);
        if !rapid && self.feed <= 0.0 {
            self.problems.error(Code::FeedOutOfRange, Some(number), || {
                format!("Line {number} cuts without a feed (F).")
            });
        }
        let (feed, lifted) = (self.feed, self.is_lifted());
        self.program.events.push(Event::Move { line: number, rapid, path, power, feed, lifted });
        self.at = to;
    }

    fn arc(&mut self, line: &Line, to: DVec2, unit: f64) -> Segment {
        let ccw = self.motion == 3;
        let (from, number) = (self.at, self.number);
        let center = if let Some(r) = line.value('R') {
            by_radius(from, to, r * unit, ccw)
        } else {
            let base = if self.centers_absolute { DVec2::ZERO } else { from };
            let [i, j] = ['I', 'J'].map(|letter| line.value(letter).unwrap_or(0.0) * unit);
            Some(base + DVec2::new(i, j))
        };
        let radii = center.map(|c| (c.distance(from), c.distance(to)));
        match (center, radii) {
            (Some(center), Some((a, b))) if a > 0.0 && (a - b).abs() <= RADIUS.0.max(RADIUS.1 * a) => {
                Segment::Arc(Arc::new(from, to, center, ccw))
            }
            _ => {
                self.problems.error(Code::BadArc, Some(number), || {
                    format!("Line {number} is an arc whose ends are not equally far from its centre: the controller refuses it.")
                });
                Segment::line(from, to)
            }
        }
    }
}

/// The centre of an arc given by its radius; a negative one takes the longer way round.
fn by_radius(from: DVec2, to: DVec2, r: f64, ccw: bool) -> Option<DVec2> {
    let chord = to - from;
    let height2 = r * r - chord.length_squared() * 0.25;
    if chord.length() == 0.0 || height2 < -1e-6 {
        return None;
    }
    let side = if ccw == (r > 0.0) { 1.0 } else { -1.0 };
    Some((from + to) * 0.5 + chord.perp().normalize() * height2.max(0.0).sqrt() * side)
}
