//! Sharp corners, which need a macro in thick material.
//!
//! Cut without a pause, a sharp corner burns off, because the heat of one side cannot escape before the beam returns on
//! the other side. The head therefore stops in the corner, the beam goes off, the corner cools, and the cut goes on
//! without piercing again (Dewil et al., section 2: "a special sharp angle macro"). A cut that begins or ends in a
//! corner does not cut through it. Marks need no macro.

use super::profile::Profile;
use crate::geometry::{DVec2, Segment, math};

/// A corner is sharp if its angle is below the limit by more than this, rad, so that the right angles of a rotated
/// drawing are all treated alike.
pub(crate) const MARGIN: f64 = 1e-6;

impl Profile {
    /// Whether a cut that leaves one element and enters the next in these directions (unit vectors) needs a macro
    /// between them.
    pub fn is_sharp(&self, leaves: DVec2, enters: DVec2) -> bool {
        self.sharp_corner.is_some_and(|c| -leaves.dot(enters) > math::cos((c.angle - MARGIN).max(0.0)))
    }

    /// The parts of a path between sharp corners, each cut in one run of the beam: one more than there are sharp
    /// corners on it.
    pub fn runs<'p>(&self, path: &'p [Segment]) -> impl Iterator<Item = &'p [Segment]> {
        path.chunk_by(|a, b| !self.is_sharp(a.tangent(1.0), b.tangent(0.0)))
    }

    /// Seconds of the pause in a sharp corner with the beam off.
    pub fn macro_time(&self) -> f64 {
        self.sharp_corner.map_or(0.0, |c| c.time)
    }

    /// Seconds that a cut loses in a sharp corner: the cooling and the delays of the beam.
    pub fn macro_seconds(&self) -> f64 {
        self.sharp_corner.map_or(0.0, |c| c.time + self.beam_delays())
    }

    /// Seconds of beam delays of a run that begins moving, or at rest.
    pub fn delays_of_cut(&self, moving: bool) -> f64 {
        if moving { self.beam_off_delay } else { self.beam_delays() }
    }

    /// Seconds of beam delays before and after every run of the beam that begins at rest.
    pub fn beam_delays(&self) -> f64 {
        self.beam_on_delay + self.beam_off_delay
    }
}
