//! The length of a user unit in millimetres, and how the page lies on the sheet.
//!
//! A page whose width or height is in mm, cm, inches or points says how large it is. A page in pixels, or without a size,
//! does not: browsers and Inkscape show 96 pixels to the inch, Inkscape before 0.92 had 90, and Illustrator has 72. The
//! program that wrote the file decides then; if it is not known, 96 is a guess that a person should check.

use super::aspect::ViewBox;
use super::length::{Length, LengthUnit};
use super::xml::{Document, Space};
use crate::drawing::{CSS_DPI, ReadOptions, Unit, Units, UnitsSource};
use crate::finding::{Code, Finding, Severity};
use crate::geometry::{Affine, DVec2};

/// How user units become millimetres.
#[derive(Clone, Debug)]
pub(super) struct Scale {
    /// The map from the user units of the root to the sheet: mm, y up.
    pub(super) map: Affine,
    /// User units per inch for lengths in mm, inches and so on inside the drawing.
    pub(super) dpi: f64,
    /// Size of the page in user units, of which percentages are parts.
    pub(super) viewport: DVec2,
    /// Whether the page has a height, so that its lower edge is y = 0.
    pub(super) has_page: bool,
    pub(super) units: Units,
    pub(super) finding: Option<Finding>,
}

/// What the root element says about the page.
struct Page {
    width: Option<Length>,
    height: Option<Length>,
    view_box: Option<ViewBox>,
    aspect: String,
}

/// Decides the scale.
pub(super) fn decide(document: &Document<'_>, options: &ReadOptions) -> Scale {
    let length = |name: &str| document.attribute(0, name).and_then(Length::read).filter(|l| l.number > 0.0);
    let page = Page {
        width: length("width"),
        height: length("height"),
        view_box: document.attribute(0, "viewBox").and_then(ViewBox::read),
        aspect: document.attribute(0, "preserveAspectRatio").unwrap_or_default().to_owned(),
    };
    let guess = Guess::of(document);
    if let Some((units, unit)) = chosen(options) {
        // Without a view box, lengths in the drawing that state mm have to keep their size. With one, they are pixels of
        // the page, as without a choice.
        let of_unit = if page.view_box.is_none() { 25.4 / unit } else { guess.dpi };
        let dpi = units.dpi.unwrap_or(of_unit);
        return page.in_user_units(unit, dpi, units, None);
    }
    match (page.size_in_mm(), page.view_box) {
        (Some((size, unit)), Some(view_box)) => page.in_real_units(size, unit, &view_box),
        (size, _) => {
            let (units, finding) = guess.units(size.is_some());
            let dpi = guess.dpi;
            page.in_pixels(dpi, units, Some(finding))
        }
    }
}

/// The unit that a person chose: what it is called, and the length of a user unit in mm.
fn chosen(options: &ReadOptions) -> Option<(Units, f64)> {
    let units = Units::chosen(options.unit, options.dpi)?;
    let unit = units.scale;
    Some((units, unit))
}

impl Page {
    /// Width and height in mm, if one of them is in such a unit, and the name of that unit. A missing one follows from
    /// the view box.
    fn size_in_mm(&self) -> Option<(DVec2, Unit)> {
        let [width, height] = [self.width, self.height].map(|l| l.and_then(Length::millimetres));
        let ratio = self.view_box.map_or(1.0, |v| v.size.y / v.size.x);
        let size = match (width, height) {
            (Some(w), Some(h)) => DVec2::new(w, h),
            (Some(w), None) => DVec2::new(w, w * ratio),
            (None, Some(h)) => DVec2::new(h / ratio, h),
            (None, None) => return None,
        };
        let unit =
            match [self.width, self.height].into_iter().flatten().find(|l| l.millimetres().is_some())?.unit {
                LengthUnit::Cm => Unit::Cm,
                LengthUnit::In | LengthUnit::Pt | LengthUnit::Pc => Unit::In,
                _ => Unit::Mm,
            };
        Some((size, unit))
    }

    /// Width and height in pixels, as far as they are known.
    fn size_in_pixels(&self, dpi: f64) -> Option<DVec2> {
        let pixels = |l: Option<Length>| {
            l.and_then(|l| match (l.unit, l.millimetres()) {
                (LengthUnit::None | LengthUnit::Px, _) => Some(l.number),
                (_, mm) => mm.map(|mm| mm * dpi / 25.4),
            })
        };
        match (pixels(self.width), pixels(self.height), self.view_box) {
            (Some(w), Some(h), _) => Some(DVec2::new(w, h)),
            (Some(w), None, Some(v)) => Some(DVec2::new(w, w * v.size.y / v.size.x)),
            (None, Some(h), Some(v)) => Some(DVec2::new(h * v.size.x / v.size.y, h)),
            (None, None, Some(v)) => Some(v.size),
            (None, Some(h), None) => Some(DVec2::new(h, h)),
            (_, None, None) => None,
        }
    }

    fn in_real_units(&self, size: DVec2, unit: Unit, view_box: &ViewBox) -> Scale {
        let reason = "The page says its size in a unit of length.".to_owned();
        let fit = view_box.fit(size, &self.aspect);
        let scale = fit.determinant().abs().sqrt();
        Scale {
            map: upright(&fit, size.y),
            dpi: CSS_DPI,
            viewport: view_box.size,
            has_page: true,
            units: Units {
                unit,
                dpi: None,
                scale,
                source: UnitsSource::Header,
                reason,
                doubtful: false,
                confidence: 0.99,
            },
            finding: None,
        }
    }

    fn in_pixels(&self, dpi: f64, mut units: Units, finding: Option<Finding>) -> Scale {
        let pixel = 25.4 / dpi;
        let size = self.size_in_pixels(dpi);
        let page = size.unwrap_or_default();
        let fit = self.view_box.map_or(Affine::IDENTITY, |v| v.fit(page, &self.aspect));
        let map = fit.then(&Affine::scale(DVec2::splat(pixel)));
        units.scale = map.determinant().abs().sqrt();
        Scale {
            map: upright(&map, page.y * pixel),
            dpi,
            viewport: self.view_box.map_or(page, |v| v.size),
            has_page: size.is_some(),
            units,
            finding,
        }
    }

    /// Takes a user unit for a length that a person chose, whatever the page says.
    fn in_user_units(&self, unit: f64, dpi: f64, units: Units, finding: Option<Finding>) -> Scale {
        let size = self.view_box.map(|v| v.size).or(self.size_in_pixels(dpi));
        let page = size.unwrap_or_default();
        let origin = self.view_box.map_or(DVec2::ZERO, |v| v.origin);
        let map = Affine::translation(-origin).then(&Affine::scale(DVec2::splat(unit)));
        Scale {
            map: upright(&map, page.y * unit),
            dpi,
            viewport: page,
            has_page: size.is_some(),
            units,
            finding,
        }
    }
}

/// Turns a map whose y axis points down into one whose y axis points up, with the lower edge of the page at 0.
fn upright(map: &Affine, height: f64) -> Affine {
    map.then(&Affine { x: DVec2::X, y: DVec2::NEG_Y, origin: DVec2::new(0.0, height) })
}

/// What the program that wrote the file takes for a pixel.
struct Guess {
    dpi: f64,
    /// The end of the sentence "... are taken as ..., because".
    because: String,
    is_sure: bool,
}

impl Guess {
    fn of(document: &Document<'_>) -> Self {
        let sure = |dpi: f64, because: &str| Self { dpi, because: because.to_owned(), is_sure: true };
        if let Some(version) = document.attribute_in(0, Space::Inkscape, "version") {
            return if is_before_0_92(version) {
                sure(90.0, "Inkscape before 0.92 made them so")
            } else {
                sure(CSS_DPI, "Inkscape makes them so")
            };
        }
        if document.is_by_illustrator() {
            return sure(72.0, "Illustrator makes them so");
        }
        let because =
            "browsers show them so; Illustrator means 72 to the inch, Inkscape before 0.92 meant 90"
                .to_owned();
        Self { dpi: CSS_DPI, because, is_sure: false }
    }

    /// The units of a page in pixels; `has_size`: its size is in a unit of length, but not what is drawn on it.
    fn units(&self, has_size: bool) -> (Units, Finding) {
        let what = if has_size {
            "The page has a size but no viewBox, so what is drawn on it is in pixels"
        } else {
            "The size of the SVG is in pixels"
        };
        let reason = format!("{what}: {} to the inch are taken, because {}.", self.dpi, self.because);
        let severity = if self.is_sure { Severity::Info } else { Severity::Warning };
        let message = if self.is_sure { reason.clone() } else { format!("{reason} Check the units.") };
        let units = Units {
            unit: Unit::Px,
            dpi: Some(self.dpi),
            scale: 25.4 / self.dpi,
            source: UnitsSource::Guessed,
            reason,
            doubtful: !self.is_sure,
            // The program is known, or three resolutions and a millimetre are in use.
            confidence: if self.is_sure { 0.95 } else { 0.5 },
        };
        (units, Finding::new(Code::UnitsGuessed, severity, message))
    }
}

/// Whether a version of Inkscape (`0.91 r13725`) is from the time when a pixel was a ninetieth of an inch.
fn is_before_0_92(version: &str) -> bool {
    let mut numbers = version.split(|c: char| !c.is_ascii_digit()).map_while(|n| n.parse::<u32>().ok());
    let (major, minor) = (numbers.next(), numbers.next());
    major == Some(0) && minor.is_some_and(|m| m < 92)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_of_inkscape() {
        for old in ["0.48.4 r9939", "0.91 r13725", "0.91+devel r14591"] {
            assert!(is_before_0_92(old), "{old}");
        }
        for new in ["0.92.4 (5da689c313, 2019-01-14)", "1.0", "1.3.2 (091e20e, 2023-11-25)", ""] {
            assert!(!is_before_0_92(new), "{new}");
        }
    }
}
