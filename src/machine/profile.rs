//! The machine profile: versioned data in mm, s and rad.

use super::dialect::DialectChoice;
use super::joints::Joints;
use super::leads::Leads;
use super::levers::{Levers, PLANS_ALL_LEVERS};
use super::process::Process;
use super::settings::MaterialSetting;
use super::sharp_corner::SharpCorner;
use super::skeleton::Skeleton;
use crate::geometry::{Path, Segment};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// How the axes move on an air move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Travel {
    /// Both axes move along a straight line, as fast as the limiting axis allows in this direction; at 45 degrees the
    /// head is faster than either axis. GRBL and similar controllers do this.
    Straight,
    /// The head moves along a straight line with the same limits in every direction, the lower of the two axes' limits,
    /// so the time depends on the Euclidean distance. This fits controllers with one idle speed for x and y, and
    /// comparison with published lengths.
    Vector,
    /// Each axis moves at its own top speed; the slower axis determines the time (Chebyshev).
    PerAxis,
}

/// Limits of the two axes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Axes {
    /// Top speed of x and y, mm/s.
    pub speed: [f64; 2],
    /// Acceleration of x and y, mm/s2; `None` if the speed is reached instantly.
    pub accel: Option<[f64; 2]>,
}

/// The file that a machine's controller takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Takes {
    /// G-code.
    #[default]
    Gcode,
    /// Contours in cutting order as DXF, for the program that drives the machine.
    Dxf,
    /// The same as SVG.
    Svg,
}

impl Takes {
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
    fn is_gcode(&self) -> bool {
        *self == Self::Gcode
    }
}

/// A machine with a material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "MachineProfile"))]
pub struct Profile {
    /// Version of this data format: 1.
    #[cfg_attr(test, ts(type = "1"))]
    pub version: u32,
    /// Name of the preset (`co2-100w`).
    pub name: String,
    /// Title for people.
    pub title: String,
    /// Position of the head before the first move, mm.
    pub home: [f64; 2],
    /// What the head can reach, in machine coordinates: xmin, ymin, xmax, ymax in mm; `None` if it is not known. A program
    /// that reaches beyond it is not written.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub bed: Option<[f64; 4]>,
    /// Whether the head returns home at the end.
    pub return_home: bool,
    /// How air moves are run.
    pub travel: Travel,
    /// Limits of air moves.
    pub rapid: Axes,
    /// Cutting.
    pub cut: Process,
    /// Marking.
    pub mark: Process,
    /// Allowed deviation at corners in the look-ahead, mm (GRBL's junction deviation, `$11`). It also limits the speed
    /// on arcs, which such a controller runs as chords. With `None`, corners are passed at full speed, and the speed on
    /// arcs is limited by the centripetal acceleration.
    pub junction_deviation: Option<f64>,
    /// Seconds to pierce the material.
    pub pierce_time: f64,
    /// Seconds of a pre-cut. A contour may be interrupted where a pre-cut is made, and is resumed there without
    /// piercing. With 0, contours may be interrupted without charge and without pre-cuts (the partial cutting of the
    /// hull-part papers). With `None`, every contour is cut in one go.
    #[serde(default)]
    #[cfg_attr(test, ts(optional = nullable))]
    pub pre_cut_time: Option<f64>,
    /// Length of a pre-cut, mm. It is cut and the head returns within [`Profile::pre_cut_time`].
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    pub pre_cut_length: f64,
    /// The corners that are cut with a pause; `None` for no such corners.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub sharp_corner: Option<SharpCorner>,
    /// Width of the cut, mm. If it is above 0, contours are outlines of parts and holes, and the beam is offset from
    /// them by half the kerf width. If it is 0, the beam follows the drawn lines.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    pub kerf_width: f64,
    /// Lead-ins, lead-outs and overcuts; `None` for none of them: cuts begin and end on their contours.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub leads: Option<Leads>,
    /// Levers: abilities that make jobs shorter. Default: all off.
    #[serde(default, skip_serializing_if = "Levers::is_none")]
    #[cfg_attr(test, ts(optional, as = "Option<Levers>"))]
    pub levers: Levers,
    /// Micro-joints; `None` for none, unless they are placed by hand.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub joints: Option<Joints>,
    /// Cuts through the waste after everything else; `None` for none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub skeleton: Option<Skeleton>,
    /// Speed at which the head is lowered and raised, mm/s; `None` if it cannot be.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub z_speed: Option<f64>,
    /// Settings for materials, by name.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<MaterialSetting>>"))]
    pub materials: Vec<MaterialSetting>,
    /// Time for the beam to settle before a cut, s.
    pub beam_on_delay: f64,
    /// Time for the beam to settle after a cut, s.
    pub beam_off_delay: f64,
    /// The file that its controller takes, which is offered first. Default `gcode`.
    #[serde(default, skip_serializing_if = "Takes::is_gcode")]
    #[cfg_attr(test, ts(optional, as = "Option<Takes>"))]
    pub takes: Takes,
    /// Dialect of G-code: the name of a shipped one, or a document.
    pub dialect: DialectChoice,
    /// Power value at full power, for dialects that do not state it.
    pub max_s: f64,
}

impl Profile {
    /// Seconds to lower or raise the head by `distance` mm.
    pub fn height_seconds(&self, distance: f64) -> f64 {
        self.z_speed.map_or(0.0, |speed| distance.abs() / speed)
    }

    /// The process along a contour that is marked or cut.
    pub fn process(&self, mark: bool) -> &Process {
        if mark { &self.mark } else { &self.cut }
    }

    /// Whether a contour that is left unfinished gets a pre-cut.
    pub fn charges_for_pre_cuts(&self) -> bool {
        self.pre_cut_time.is_some_and(|seconds| seconds > 0.0)
    }

    /// Whether pre-cuts have a cost, and contours take one pass unless their layer says otherwise.
    pub fn makes_pre_cuts(&self) -> bool {
        self.charges_for_pre_cuts() && self.cut.passes == 1
    }

    /// Whether contours that share cuts are cut as one: on a machine that makes pre-cuts, or with `levers.common_cuts`.
    pub fn cuts_as_one(&self) -> bool {
        let lever = PLANS_ALL_LEVERS && self.levers.common_cuts.is_some() && self.cut.passes == 1;
        self.makes_pre_cuts() || lever
    }

    /// The part of the rest of a contour that a pre-cut at its start covers: at most half of it.
    pub fn cut_ahead(&self, rest: &Path) -> Vec<Segment> {
        let length = self.pre_cut_length.min(0.5 * rest.length());
        if length > 0.0 { rest.between(0.0, length) } else { Vec::new() }
    }

    /// The greatest speed of the head, mm/s.
    pub fn top_speed(&self) -> f64 {
        let [x, y] = self.rapid.speed;
        x.max(y).max(self.cut.speed).max(self.mark.speed)
    }

    /// Home as a point.
    pub fn home(&self) -> DVec2 {
        DVec2::from_array(self.home)
    }
}
