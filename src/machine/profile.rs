//! The machine profile: versioned data in mm, s and rad.

use super::sharp_corner::SharpCorner;
use crate::geometry::{Path, Segment};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// How the axes move on an air move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Travel {
    /// Together along a straight line, as fast as the axis that binds in this direction allows: at 45 degrees the
    /// head is faster than either axis. GRBL and most controllers of its kind.
    Straight,
    /// Along a straight line with the same limits in every direction, the lower of the two axes': time by the
    /// distance (Euclidean). Controllers with one idle speed for x and y, and comparison with published lengths.
    Vector,
    /// Each at its own top speed; time is that of the axis that takes longest (Chebyshev).
    PerAxis,
}

/// Limits of one axis pair.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Axes {
    /// Top speed of x and y, mm/s.
    pub speed: [f64; 2],
    /// Acceleration of x and y, mm/s2; `None`: at once.
    pub accel: Option<[f64; 2]>,
}

/// What the beam does in the material: one for cutting, one for marking.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Process {
    /// Speed along the contour, mm/s.
    pub speed: f64,
    /// Acceleration along the contour, mm/s2; `None`: at once.
    pub accel: Option<f64>,
    /// Power, 0 to 1.
    pub power: f64,
}

/// Flavour of G-code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Dialect {
    /// GRBL 1.1 laser mode, M4 dynamic power.
    GrblM4,
}

/// A machine with a material on it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Profile {
    /// Format of this data: 1.
    pub version: u32,
    /// Name of the preset (`co2-100w`).
    pub name: String,
    /// For people.
    pub title: String,
    /// Where the head starts, mm.
    pub home: [f64; 2],
    /// Goes back home at the end.
    pub return_home: bool,
    /// How air moves run.
    pub travel: Travel,
    /// Limits of air moves.
    pub rapid: Axes,
    /// Cutting.
    pub cut: Process,
    /// Marking.
    pub mark: Process,
    /// Allowed deviation at corners for the look-ahead, mm (GRBL's junction deviation, `$11`); it limits the speed on
    /// arcs too, which such a controller runs as chords. `None`: full speed through every corner, and on arcs what the
    /// acceleration allows towards the centre.
    pub junction_deviation: Option<f64>,
    /// Seconds to pierce.
    pub pierce_time: f64,
    /// Seconds of a pre-cut: a contour may be left unfinished wherever one is made, and resumed there without piercing.
    /// 0: contours are left free of charge and without pre-cuts (the hull-part papers' partial cutting); `None`:
    /// contours are cut in one go.
    #[serde(default)]
    pub pre_cut_time: Option<f64>,
    /// How far a pre-cut reaches into the contour, mm: cut there and back within [`Profile::pre_cut_time`].
    #[serde(default, skip_serializing_if = "is_zero")]
    pub pre_cut_length: f64,
    /// Which corners are cut with a pause; `None`: none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sharp_corner: Option<SharpCorner>,
    /// How wide the beam cuts, mm. Above 0, contours are outlines of parts and holes, and the beam follows them half of this
    /// aside; 0: it follows the lines drawn.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub kerf_width: f64,
    /// Beam settling before a cut, s.
    pub beam_on_delay: f64,
    /// Beam settling after a cut, s.
    pub beam_off_delay: f64,
    /// G-code flavour.
    pub dialect: Dialect,
    /// The S word of full power.
    pub max_s: f64,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "what serde asks for; natively it is small enough")]
fn is_zero(length: &f64) -> bool {
    length.total_cmp(&0.0).is_eq()
}

impl Profile {
    /// What the beam does along a contour that is marked, or cut.
    pub fn process(&self, mark: bool) -> &Process {
        if mark { &self.mark } else { &self.cut }
    }

    /// Whether it makes pre-cuts that cost something: then contours that share cuts are cut as one.
    pub fn makes_pre_cuts(&self) -> bool {
        self.pre_cut_time.is_some_and(|seconds| seconds > 0.0)
    }

    /// What a pre-cut reaches of the rest of a contour, from where that begins: half of it at most.
    pub fn cut_ahead(&self, rest: &Path) -> Vec<Segment> {
        let length = self.pre_cut_length.min(0.5 * rest.length());
        if length > 0.0 { rest.between(0.0, length) } else { Vec::new() }
    }

    /// Home as a point.
    pub fn home(&self) -> DVec2 {
        DVec2::from_array(self.home)
    }
}
