//! Axis-parallel boxes, in mm.

use glam::DVec2;

/// An axis-parallel box. It is empty when `min` exceeds `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Lower left corner.
    pub min: DVec2,
    /// Upper right corner.
    pub max: DVec2,
}

impl Aabb {
    /// The empty box.
    pub const EMPTY: Self = Self { min: DVec2::INFINITY, max: DVec2::NEG_INFINITY };

    /// The box of one point.
    pub fn of(p: DVec2) -> Self {
        Self { min: p, max: p }
    }

    /// Whether the box contains no point.
    pub fn is_empty(&self) -> bool {
        self.min.x > self.max.x || self.min.y > self.max.y
    }

    /// The box extended to contain `p`.
    pub fn with(self, p: DVec2) -> Self {
        Self { min: self.min.min(p), max: self.max.max(p) }
    }

    /// The smallest box around both.
    pub fn union(self, o: Self) -> Self {
        Self { min: self.min.min(o.min), max: self.max.max(o.max) }
    }

    /// The box extended by `d` mm on every side.
    pub fn grown(self, d: f64) -> Self {
        Self { min: self.min - d, max: self.max + d }
    }

    /// Width and height, mm; zero when empty.
    pub fn size(&self) -> DVec2 {
        if self.is_empty() { DVec2::ZERO } else { self.max - self.min }
    }

    /// The middle.
    pub fn center(&self) -> DVec2 {
        (self.min + self.max) * 0.5
    }

    /// Whether `p` lies inside or on the edge.
    pub fn contains(&self, p: DVec2) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    /// Whether `o` lies completely inside or on the edge.
    pub fn contains_box(&self, o: &Self) -> bool {
        self.contains(o.min) && self.contains(o.max)
    }

    /// Whether the boxes share a point.
    pub fn overlaps(&self, o: &Self) -> bool {
        self.min.cmple(o.max).all() && o.min.cmple(self.max).all()
    }
}
