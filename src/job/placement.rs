//! Where the job lies on the bed of the machine.
//!
//! A search works in the coordinates of the drawing, in which the machine's home is moved the other way, so that the air
//! moves from home and back have their right price. The finished plan is moved once, when it is written. A placement
//! therefore changes the coordinates of a plan, and nothing else.

use super::JobError;
use super::ranges::PLACE;
use crate::fields::FieldError;
use crate::finding::{Code, Finding, Severity};
use crate::geometry::{Aabb, DVec2};
use crate::machine::{Anchor, Profile, Start};
use serde::{Deserialize, Serialize};

/// A point of the job and the point of the bed that it comes to lie on.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Place {
    /// A point of the box around everything that is cut or marked, as drawn. Default `lower-left`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<Anchor>,
    /// A point of the drawing instead, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<[f64; 2]>,
    /// Where it comes to lie, in machine coordinates, or as seen from where the head stands, mm.
    pub at: [f64; 2],
}

/// A job on its machine.
#[derive(Clone, Debug)]
pub struct Placed {
    /// The machine as given. If the job starts where the head stands, its home is the origin.
    pub profile: Profile,
    /// From the coordinates of the drawing to those of the machine, mm.
    pub shift: DVec2,
    /// What the coordinates of a program mean.
    pub start: Start,
    /// Whether a program may leave the bed.
    pub allow_off_bed: bool,
}

impl Placed {
    /// Places a job with the box `bounds`, in the coordinates of the drawing.
    pub(super) fn new(
        mut profile: Profile,
        place: Option<Place>,
        start: Start,
        bounds: &Aabb,
    ) -> Result<Self, JobError> {
        if !start.is_absolute() {
            profile.home = [0.0, 0.0];
        }
        let shift = place.map_or(Ok(DVec2::ZERO), |place| place.shift(bounds))?;
        Ok(Self { profile, shift, start, allow_off_bed: false })
    }

    /// The same, where a program may leave the bed if `allow`.
    pub(super) fn allow_off_bed(self, allow: bool) -> Self {
        Self { allow_off_bed: allow, ..self }
    }

    /// The machine in the coordinates of the drawing.
    pub(super) fn seen_from_drawing(&self) -> Profile {
        let shift = self.shift;
        let moved = |[x0, y0, x1, y1]: [f64; 4]| [x0 - shift.x, y0 - shift.y, x1 - shift.x, y1 - shift.y];
        // Where the head stands is known to the person only.
        let bed = self.profile.bed.filter(|_| self.start.is_absolute()).map(moved);
        Profile { home: (self.profile.home() - shift).to_array(), bed, ..self.profile.clone() }
    }

    /// Whether the job is where it was drawn, in machine coordinates.
    pub(super) fn is_as_drawn(&self) -> bool {
        self.shift == DVec2::ZERO && self.start.is_absolute()
    }

    /// Reports a job with the box `bounds`, in the coordinates of the drawing, that does not lie on the bed.
    pub(super) fn finding(&self, bounds: &Aabb) -> Option<Finding> {
        let sentence = self.off_bed(bounds)?;
        Some(Finding::new(Code::OffBed, Severity::Error, sentence))
    }

    /// Refuses to write a program for a job that does not lie on the bed.
    pub(super) fn check(&self, bounds: &Aabb) -> Result<(), JobError> {
        match self.off_bed(bounds) {
            Some(sentence) if !self.allow_off_bed => Err(JobError::OffBed(sentence)),
            _ => Ok(()),
        }
    }

    fn off_bed(&self, bounds: &Aabb) -> Option<String> {
        if bounds.is_empty() {
            return None;
        }
        let there = Aabb { min: bounds.min + self.shift, max: bounds.max + self.shift };
        self.profile.off_bed(&there, self.start)
    }
}

impl Place {
    fn shift(&self, bounds: &Aabb) -> Result<DVec2, JobError> {
        let numbers = [("place.at", Some(self.at)), ("place.from", self.from)];
        for (name, pair) in numbers {
            if let Some(n) = pair.into_iter().flatten().find(|n| !PLACE.holds(*n)) {
                return Err(FieldError::out_of_range("The option", name, n, &PLACE).into());
            }
        }
        let from = match (self.point, self.from) {
            (Some(_), Some(_)) => {
                return Err(JobError::Conflict {
                    field: "place",
                    sentence: "The option \"place\" has both \"point\" and \"from\". Give one of them.",
                });
            }
            (point, None) => point.unwrap_or_default().of(bounds),
            (None, Some(from)) => DVec2::from_array(from),
        };
        Ok(DVec2::from_array(self.at) - from)
    }
}
