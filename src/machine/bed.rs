//! The bed of a machine: the rectangle that the head can reach, and the nine points by which a job is placed on it.

use super::profile::Profile;
use crate::geometry::Aabb;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// One of nine points of a box: its corners, the middles of its sides, its centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Anchor {
    /// The corner with the least x and y.
    #[default]
    LowerLeft,
    /// The middle of the side with the least y.
    LowerCenter,
    /// The corner with the greatest x and the least y.
    LowerRight,
    /// The middle of the side with the least x.
    CenterLeft,
    /// The centre.
    Center,
    /// The middle of the side with the greatest x.
    CenterRight,
    /// The corner with the least x and the greatest y.
    UpperLeft,
    /// The middle of the side with the greatest y.
    UpperCenter,
    /// The corner with the greatest x and y.
    UpperRight,
}

impl Anchor {
    /// The names of all nine, as callers write them.
    pub const NAMES: &'static [&'static str] = &[
        "lower-left",
        "lower-center",
        "lower-right",
        "center-left",
        "center",
        "center-right",
        "upper-left",
        "upper-center",
        "upper-right",
    ];

    /// The point of a box.
    pub fn of(self, b: &Aabb) -> DVec2 {
        let center = b.center();
        let x = match self {
            Self::LowerLeft | Self::CenterLeft | Self::UpperLeft => b.min.x,
            Self::LowerCenter | Self::Center | Self::UpperCenter => center.x,
            Self::LowerRight | Self::CenterRight | Self::UpperRight => b.max.x,
        };
        let y = match self {
            Self::LowerLeft | Self::LowerCenter | Self::LowerRight => b.min.y,
            Self::CenterLeft | Self::Center | Self::CenterRight => center.y,
            Self::UpperLeft | Self::UpperCenter | Self::UpperRight => b.max.y,
        };
        DVec2::new(x, y)
    }
}

/// What the coordinates of a program mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Start {
    /// Machine coordinates: the head first moves home.
    #[default]
    Absolute,
    /// The job starts where the head stands when the program begins: that place is the origin, and home. Where it is on
    /// the bed is not known.
    Current,
}

impl Start {
    /// Whether the job is at a known place of the bed.
    pub fn is_absolute(&self) -> bool {
        *self == Self::Absolute
    }
}

/// How far beyond the edge of the bed still counts as on it, mm: half of the last digit of a program.
const EDGE: f64 = 0.000_5;

impl Profile {
    /// The bed, if the profile has one.
    pub fn bed(&self) -> Option<Aabb> {
        let [x0, y0, x1, y1] = self.bed?;
        Some(Aabb { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) })
    }

    /// Why a job with this box, in machine coordinates, does not lie on the bed: one sentence; `None` if it does, or if
    /// the machine has no bed. A job that starts where the head stands only has to be small enough, with the way to it.
    pub fn off_bed(&self, job: &Aabb, start: Start) -> Option<String> {
        let bed = self.bed()?;
        let (size, room) = (job.size(), bed.size());
        let fits = |size: DVec2| size.cmple(room + 2.0 * EDGE).all();
        if !fits(size) {
            let turned = DVec2::new(size.y, size.x);
            let advice = if fits(turned) {
                "It fits after a quarter turn."
            } else {
                "Choose a larger machine, or divide the drawing."
            };
            return Some(format!(
                "The job of {} x {} mm is larger than the bed of {} x {} mm. {advice}",
                mm(size.x),
                mm(size.y),
                mm(room.x),
                mm(room.y),
            ));
        }
        if !start.is_absolute() {
            // The head begins at the origin, so that place has to be on the bed as well.
            let reach = job.with(DVec2::ZERO).size();
            return (!fits(reach)).then(|| {
                format!(
                    "From where the head stands, the job reaches over {} x {} mm, more than the bed of {} x {} mm. \
                     Place it where the head stands.",
                    mm(reach.x),
                    mm(reach.y),
                    mm(room.x),
                    mm(room.y),
                )
            });
        }
        if !bed.grown(EDGE).contains_box(job) {
            return Some(format!(
                "The job reaches from x {} to {} and y {} to {} mm, beyond the bed (x {} to {}, y {} to {} mm). \
                 Place it on the bed, for example with its middle at that of the bed.",
                mm(job.min.x),
                mm(job.max.x),
                mm(job.min.y),
                mm(job.max.y),
                mm(bed.min.x),
                mm(bed.max.x),
                mm(bed.min.y),
                mm(bed.max.y),
            ));
        }
        let home = self.home();
        (!bed.grown(EDGE).contains(home)).then(|| {
            format!(
                "The head starts and ends beyond the bed, at x {}, y {} mm. Correct the machine's home or its bed.",
                mm(home.x),
                mm(home.y)
            )
        })
    }
}

/// A coordinate in a sentence: up to three decimals, without trailing zeros.
fn mm(v: f64) -> f64 {
    (v * 1000.0).round() / 1000.0 + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::preset;

    fn machine() -> Profile {
        Profile { bed: Some([0.0, 0.0, 400.0, 300.0]), ..preset("co2-100w").unwrap() }
    }

    fn at(x0: f64, y0: f64, x1: f64, y1: f64) -> Aabb {
        Aabb { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) }
    }

    #[test]
    fn nine_points_of_a_box() {
        let b = at(10.0, 20.0, 30.0, 60.0);
        let xs = [10.0, 20.0, 30.0];
        let ys = [20.0, 40.0, 60.0];
        for (k, name) in Anchor::NAMES.iter().enumerate() {
            let anchor: Anchor = serde_json::from_str(&format!("\"{name}\"")).unwrap();
            assert_eq!(anchor.of(&b), DVec2::new(xs[k % 3], ys[k / 3]), "{name}");
        }
    }

    #[test]
    fn off_the_bed_is_one_sentence() {
        let m = machine();
        assert_eq!(m.off_bed(&at(0.0, 0.0, 400.0, 300.0), Start::Absolute), None);
        let negative = m.off_bed(&at(-12.5, 0.0, 90.0, 40.0), Start::Absolute).unwrap();
        assert!(negative.starts_with(
            "The job reaches from x -12.5 to 90 and y 0 to 40 mm, beyond the bed (x 0 to 400, y 0 to 300 mm)."
        ));
        assert_eq!(
            m.off_bed(&at(0.0, 0.0, 290.0, 390.0), Start::Absolute).unwrap(),
            "The job of 290 x 390 mm is larger than the bed of 400 x 300 mm. It fits after a quarter turn."
        );
        assert!(
            m.off_bed(&at(0.0, 0.0, 500.0, 10.0), Start::Current)
                .unwrap()
                .ends_with("or divide the drawing.")
        );
    }

    #[test]
    fn from_where_the_head_stands_only_the_size_with_the_way_to_the_job_matters() {
        assert_eq!(machine().off_bed(&at(-100.0, -100.0, 100.0, 100.0), Start::Current), None);
        assert_eq!(machine().off_bed(&at(390.0, -300.0, 400.0, -290.0), Start::Current), None);
        assert_eq!(
            machine().off_bed(&at(1000.0, 20.0, 1010.0, 30.0), Start::Current).unwrap(),
            "From where the head stands, the job reaches over 1010 x 30 mm, more than the bed of 400 x 300 mm. \
             Place it where the head stands."
        );
    }

    #[test]
    fn a_home_beyond_the_bed_is_reported() {
        let m = Profile { home: [-5.0, 0.0], ..machine() };
        let sentence = m.off_bed(&at(1.0, 1.0, 2.0, 2.0), Start::Absolute).unwrap();
        assert!(sentence.starts_with("The head starts and ends beyond the bed, at x -5, y 0 mm."));
    }

    #[test]
    fn machines_without_a_bed_take_any_place() {
        let m = Profile { bed: None, ..machine() };
        assert_eq!(m.off_bed(&at(-1e5, 0.0, 1e5, 1.0), Start::Absolute), None);
    }
}
