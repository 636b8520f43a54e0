//! The image of a path under an affine map.

use super::affine::Affine;
use super::ellipse::Ellipse;
use super::path::{Path, pin_ends};
use super::segment::Segment;

impl Affine {
    /// The image of a path, joined like the original. Arcs whose images are elliptic are fitted within `tolerance` mm.
    /// Arcs that shrink to a point disappear.
    pub fn path(&self, path: &Path, tolerance: f64) -> Path {
        let similar = self.is_similarity();
        let mut out = Vec::with_capacity(path.segments.len());
        for s in &path.segments {
            match s {
                Segment::Arc(a) if !similar => {
                    let from = out.len();
                    out.extend(Ellipse::of_arc(a, self).to_segments(tolerance));
                    pin_ends(&mut out[from..], self.point(a.start), self.point(a.end));
                }
                _ => out.extend(self.segment(s)),
            }
        }
        Path::new(out, path.closed)
    }
}
