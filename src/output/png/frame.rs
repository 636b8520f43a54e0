//! Maps the sheet (millimetres, y up) to the picture (pixels, y down).

use crate::geometry::{Aabb, DVec2};

/// White margin around everything, as a fraction of the picture's width.
const MARGIN: f64 = 0.02;
/// Largest number of pixels of a picture. They take 134 MB at four bytes each, which a browser tab still allows.
const MAX_PIXELS: u32 = 1 << 25;
/// Largest height of a picture, px.
const MAX_HEIGHT: u32 = 8192;
/// Up to this width, px, lines keep their smallest width, because thinner lines fade.
const SMALL: f64 = 1000.0;
/// Smallest side of a sheet that counts as more than a point, mm.
const POINT: f64 = 1e-6;

/// A picture and the position of the sheet on it. It has the requested width and the height that the sheet needs. If
/// that would be too high, the sheet is drawn smaller and centred.
pub(super) struct Frame {
    /// Width, px.
    pub(super) width: u32,
    /// Height, px.
    pub(super) height: u32,
    /// Pixels per mm.
    scale: f64,
    /// Centre of the sheet, mm.
    middle: DVec2,
}

impl Frame {
    /// A picture of `bounds` that is `width` px wide; `None` when the bounds are not finite.
    pub(super) fn around(bounds: Aabb, width: u32) -> Option<Self> {
        let size = bounds.size().max(DVec2::splat(POINT));
        let rim = 2.0 * MARGIN * f64::from(width);
        let scale = (f64::from(width) - rim) / size.x;
        let most = f64::from(MAX_HEIGHT.min(MAX_PIXELS / width));
        let height = (size.y * scale + rim).clamp(rim + 1.0, most).round();
        let scale = scale.min((height - rim) / size.y);
        let middle = bounds.center();
        if !(middle.is_finite() && scale.is_finite() && scale > 0.0) {
            return None;
        }
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "held between 1 and MAX_HEIGHT above"
        )]
        let height = height as u32;
        Some(Self { width, height, scale, middle })
    }

    /// Width in this picture, px, of a line one px wide in a small picture: lines grow with pictures wider than
    /// [`SMALL`].
    #[allow(clippy::cast_possible_truncation, reason = "the drawing library works in f32")]
    pub(super) fn line_px(&self) -> f32 {
        (f64::from(self.width) / SMALL).max(1.0) as f32
    }

    /// A place of the sheet, in px from the upper left corner.
    #[allow(clippy::cast_possible_truncation, reason = "the drawing library works in f32")]
    pub(super) fn place(&self, p: DVec2) -> (f32, f32) {
        let at = (p - self.middle) * self.scale;
        ((f64::from(self.width) * 0.5 + at.x) as f32, (f64::from(self.height) * 0.5 - at.y) as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(w: f64, h: f64, width: u32) -> Frame {
        Frame::around(Aabb { min: DVec2::ZERO, max: DVec2::new(w, h) }, width).unwrap()
    }

    #[test]
    fn the_sheet_fills_the_width_inside_the_margin() {
        let f = frame(50.0, 40.0, 1000);
        assert_eq!((f.width, f.height), (1000, 808));
        assert_eq!(f.place(DVec2::new(0.0, 40.0)), (20.0, 20.0));
        assert_eq!(f.place(DVec2::new(50.0, 0.0)), (980.0, 788.0));
    }

    #[test]
    fn high_and_flat_sheets_stay_within_the_limits() {
        let high = frame(1.0, 1000.0, 1000);
        assert_eq!((high.width, high.height), (1000, MAX_HEIGHT));
        let (x, y) = high.place(DVec2::new(0.5, 1000.0));
        assert!((x - 500.0).abs() < 1e-3 && (y - 20.0).abs() < 1e-2, "{x} {y}");
        let wide = frame(100.0, 100.0, 8192);
        assert_eq!(wide.width * wide.height, MAX_PIXELS);
        assert_eq!(frame(100.0, 0.0, 1000).height, 41);
        assert!(frame(0.0, 0.0, 64).height >= 1);
        let endless = Aabb { min: DVec2::splat(-1e308), max: DVec2::splat(1e308) };
        assert!(Frame::around(endless, 100).is_none());
    }
}
