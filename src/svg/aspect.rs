//! How a view box fits its viewport: `viewBox` and `preserveAspectRatio`.

use super::numbers::list;
use crate::geometry::{Affine, DVec2};

/// A rectangle in user units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ViewBox {
    pub(super) origin: DVec2,
    pub(super) size: DVec2,
}

impl ViewBox {
    /// Reads `viewBox`. A box without area is none.
    pub(super) fn read(text: &str) -> Option<Self> {
        let mut numbers = list(text);
        let mut next = || numbers.next();
        let (origin, size) = (DVec2::new(next()?, next()?), DVec2::new(next()?, next()?));
        (size.min_element() > 0.0).then_some(Self { origin, size })
    }

    /// The map from the view box to a viewport of this size at the origin.
    pub(super) fn fit(&self, viewport: DVec2, aspect: &str) -> Affine {
        let mut words = aspect.split_ascii_whitespace().filter(|w| *w != "defer");
        let align = words.next().unwrap_or("xMidYMid");
        let ratio = viewport / self.size;
        let scale = match (align, words.next()) {
            ("none", _) => ratio,
            (_, Some("slice")) => DVec2::splat(ratio.max_element()),
            _ => DVec2::splat(ratio.min_element()),
        };
        let part = |at: usize| match align.get(at..at + 4) {
            Some("xMin" | "YMin") => 0.0,
            Some("xMax" | "YMax") => 1.0,
            _ => 0.5,
        };
        let free = viewport - self.size * scale;
        let offset = if align == "none" { DVec2::ZERO } else { free * DVec2::new(part(0), part(4)) };
        Affine {
            x: DVec2::new(scale.x, 0.0),
            y: DVec2::new(0.0, scale.y),
            origin: offset - self.origin * scale,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_view_box_is_fitted_as_preserve_aspect_ratio_says() {
        let view_box = ViewBox::read("10,20 100 50").unwrap();
        let corners = |aspect: &str| {
            let map = view_box.fit(DVec2::new(400.0, 400.0), aspect);
            let corner = |x, y| map.point(DVec2::new(x, y)).to_array().to_vec();
            [corner(10.0, 20.0), corner(110.0, 70.0)].concat()
        };
        assert_eq!(corners(""), [0.0, 100.0, 400.0, 300.0]);
        assert_eq!(corners("xMinYMin meet"), [0.0, 0.0, 400.0, 200.0]);
        assert_eq!(corners("xMaxYMax"), [0.0, 200.0, 400.0, 400.0]);
        assert_eq!(corners("xMidYMid slice"), [-200.0, 0.0, 600.0, 400.0]);
        assert_eq!(corners("none"), [0.0, 0.0, 400.0, 400.0]);
        assert_eq!(ViewBox::read("0 0 0 5"), None);
        assert_eq!(ViewBox::read("0 0 5"), None);
    }
}
