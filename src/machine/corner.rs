//! Sharp corners: where thick material needs a macro.
//!
//! Cut through without a pause, a sharp corner burns off: the heat of one side has nowhere to go before the other side
//! comes past. So the head stops in the corner, the beam goes off, the corner cools, and the beam goes on with the cut
//! without piercing again (Dewil et al., section 2: "a special sharp angle macro"). A cut that begins or ends in a corner
//! is not cut through there. Marks need none.

use super::profile::Profile;
use crate::geometry::{DVec2, Segment, math};

/// Corners are sharp below the limit by more than this, rad: the right angles of a turned drawing are right angles still.
pub(crate) const MARGIN: f64 = 1e-6;

impl Profile {
    /// Whether a cut that leaves one element and enters the next in these directions (unit vectors) needs a macro.
    pub fn is_sharp(&self, leaves: DVec2, enters: DVec2) -> bool {
        self.sharp_corner.is_some_and(|c| -leaves.dot(enters) > math::cos((c.angle - MARGIN).max(0.0)))
    }

    /// The runs of the beam that cut along these elements: one more than there are sharp corners on the way.
    pub fn runs<'p>(&self, path: &'p [Segment]) -> impl Iterator<Item = &'p [Segment]> {
        path.chunk_by(|a, b| !self.is_sharp(a.tangent(1.0), b.tangent(0.0)))
    }

    /// Seconds of a pause in a sharp corner, the beam off.
    pub fn macro_time(&self) -> f64 {
        self.sharp_corner.map_or(0.0, |c| c.time)
    }

    /// Seconds that a sharp corner takes in which a cut stops and goes on: to cool, and of the beam.
    pub fn macro_seconds(&self) -> f64 {
        self.sharp_corner.map_or(0.0, |c| c.time + self.beam_delays())
    }

    /// Seconds that every run of the beam takes before and after.
    pub fn beam_delays(&self) -> f64 {
        self.beam_on_delay + self.beam_off_delay
    }
}
