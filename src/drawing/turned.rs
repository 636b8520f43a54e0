//! Turns a drawing by quarter turns around its origin, exactly: coordinates change places and signs, and no digit changes.

use super::model::Drawing;
use crate::geometry::Affine;
use glam::DVec2;

impl Drawing {
    /// The drawing after `quarter_turns`, counter-clockwise.
    pub fn turned(mut self, quarter_turns: u8) -> Self {
        let x = match quarter_turns % 4 {
            0 => return self,
            1 => DVec2::Y,
            2 => DVec2::NEG_X,
            _ => DVec2::NEG_Y,
        };
        let turn = Affine { x, y: x.perp(), origin: DVec2::ZERO };
        for segment in self.shapes.iter_mut().flat_map(|shape| &mut shape.path.segments) {
            // A rotation keeps arcs, so every element has an image.
            *segment = turn.segment(segment).unwrap_or(*segment);
        }
        for finding in &mut self.findings {
            finding.at = finding.at.map(|at| turn.point(at));
        }
        self
    }
}
