//! Shapes as outlines in user units: `path` and the basic shapes.

use super::length::{Axis, Lengths};
use super::numbers::Scanner;
use super::outline::{Chain, Piece};
use super::own::Own;
use super::path_data;
use super::xml::Document;
use crate::geometry::{DVec2, Ellipse};
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The outline of a shape.
#[derive(Debug, Default)]
pub(super) struct Outline {
    pub(super) chains: Vec<Chain>,
    /// What is wrong with it, as the end of a sentence.
    pub(super) fault: Option<&'static str>,
}

impl From<Vec<Chain>> for Outline {
    fn from(chains: Vec<Chain>) -> Self {
        Self { chains, fault: None }
    }
}

impl Outline {
    fn invalid(fault: &'static str) -> Self {
        Self { chains: Vec::new(), fault: Some(fault) }
    }
}

/// The kind of a shape as a name that lives as long as the program; `None` for what is no shape.
pub(super) fn kind(name: &str) -> Option<&'static str> {
    const KINDS: [&str; 7] = ["path", "rect", "circle", "ellipse", "line", "polyline", "polygon"];
    KINDS.into_iter().find(|k| *k == name)
}

/// The outline of a shape. `own`: what its style sheets say.
pub(super) fn outline(
    document: &Document<'_>,
    element: u32,
    kind: &str,
    own: &Own,
    lengths: &Lengths,
) -> Outline {
    let unread = Cell::new(false);
    let text = |name: &str| own.geometry(document, element, name);
    let length = |name: &str, axis: Axis| {
        let text = text(name)?;
        let length = lengths.read(text, axis);
        unread.set(unread.get() || (length.is_none() && !is_missing(text)));
        length
    };
    let outline = of_kind(kind, &text, &length);
    if unread.get() {
        return Outline {
            fault: Some("one of its lengths cannot be read, and counts as missing"),
            ..outline
        };
    }
    outline
}

/// Whether a length says that there is none.
pub(super) fn is_missing(length: &str) -> bool {
    matches!(length.trim(), "" | "auto")
}

fn of_kind<'t>(
    kind: &str,
    text: &impl Fn(&str) -> Option<&'t str>,
    length: &impl Fn(&str, Axis) -> Option<f64>,
) -> Outline {
    let x = |name: &str| length(name, Axis::Width);
    let y = |name: &str| length(name, Axis::Height);
    match kind {
        "path" => {
            let read = path_data::read(text("d").unwrap_or_default());
            let fault = read.faulty.then_some("its path data is damaged, and is read up to the fault");
            Outline { chains: read.chains, fault }
        }
        "rect" => {
            let (Some(width), Some(height)) = (x("width"), y("height")) else {
                return Outline::invalid("it has no width or no height");
            };
            if width <= 0.0 || height <= 0.0 {
                return Outline::invalid("it has no width or no height");
            }
            let corner = DVec2::new(x("x").unwrap_or(0.0), y("y").unwrap_or(0.0));
            // A radius that is missing is that of the other axis.
            let given = [x("rx"), y("ry")].map(|r| r.filter(|r| *r >= 0.0));
            let rx = given[0].or(given[1]).unwrap_or(0.0).min(width / 2.0);
            let ry = given[1].or(given[0]).unwrap_or(0.0).min(height / 2.0);
            vec![rectangle(corner, DVec2::new(width, height), DVec2::new(rx, ry))].into()
        }
        "circle" | "ellipse" => {
            let center = DVec2::new(x("cx").unwrap_or(0.0), y("cy").unwrap_or(0.0));
            let radii = if kind == "circle" {
                length("r", Axis::Diagonal).map(DVec2::splat)
            } else {
                // As with rectangles.
                let given = [x("rx"), y("ry")];
                given[0].or(given[1]).zip(given[1].or(given[0])).map(DVec2::from)
            };
            match radii {
                Some(radii) if radii.min_element() > 0.0 => vec![ellipse(center, radii)].into(),
                _ => Outline::invalid("it has no radius"),
            }
        }
        "line" => {
            let end = |nx: &str, ny: &str| DVec2::new(x(nx).unwrap_or(0.0), y(ny).unwrap_or(0.0));
            let mut chain = Chain::new(end("x1", "y1"));
            chain.pieces.push(Piece::Line(end("x2", "y2")));
            vec![chain].into()
        }
        "polyline" | "polygon" => points(text("points").unwrap_or_default(), kind == "polygon"),
        _ => Outline::default(),
    }
}

fn points(text: &str, closed: bool) -> Outline {
    let mut scanner = Scanner::new(text);
    let numbers: Vec<f64> = std::iter::from_fn(|| scanner.next_number()).collect();
    let (pairs, rest) = numbers.as_chunks::<2>();
    let mut points = pairs.iter().map(|p| DVec2::from_array(*p));
    let Some(start) = points.next() else { return Outline::invalid("it has no points") };
    let chain = Chain { start, pieces: points.map(Piece::Line).collect(), closed };
    let fault = if !scanner.rest().is_empty() {
        Some("its list of points is damaged, and is read up to the fault")
    } else {
        (!rest.is_empty()).then_some("its last point has no y")
    };
    Outline { chains: vec![chain], fault }
}

/// A rectangle with rounded corners, clockwise on the screen from the end of its first corner, as the specification says.
fn rectangle(corner: DVec2, size: DVec2, radii: DVec2) -> Chain {
    let (a, b) = (corner, corner + size);
    if radii.min_element() <= 0.0 {
        let lines = [DVec2::new(b.x, a.y), b, DVec2::new(a.x, b.y)].map(Piece::Line);
        return Chain { start: a, pieces: lines.to_vec(), closed: true };
    }
    let (x, y) = (DVec2::X * radii.x, DVec2::Y * radii.y);
    let start = a + x;
    let mut chain = Chain { start, pieces: Vec::with_capacity(8), closed: true };
    let mut at = start;
    // For each corner: the corner, and the directions towards the edges before and after it.
    for (corner, before, after) in
        [(DVec2::new(b.x, a.y), -x, y), (b, -y, -x), (DVec2::new(a.x, b.y), x, -y), (a, y, x)]
    {
        let (from, to) = (corner + before, corner + after);
        // The straight part is missing where the radius is half the side.
        if from.distance_squared(at) > 0.0 {
            chain.pieces.push(Piece::Line(from));
        }
        let center = corner + before + after;
        let arc = Ellipse { center, major: -after, minor: -before, start: 0.0, sweep: FRAC_PI_2 };
        chain.pieces.push(Piece::Arc(arc, to));
        at = to;
    }
    chain
}

fn ellipse(center: DVec2, radii: DVec2) -> Chain {
    let (major, minor) = (DVec2::X * radii.x, DVec2::Y * radii.y);
    let start = center + major;
    let whole = Ellipse { center, major, minor, start: 0.0, sweep: TAU };
    Chain { start, pieces: vec![Piece::Arc(whole, start)], closed: true }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounded_rectangle_has_arcs_that_meet_its_sides() {
        let chain = rectangle(DVec2::new(10.0, 20.0), DVec2::new(30.0, 10.0), DVec2::new(4.0, 5.0));
        assert_eq!(chain.start, DVec2::new(14.0, 20.0));
        let mut at = chain.start;
        for piece in &chain.pieces {
            if let Piece::Arc(e, to) = piece {
                assert!(e.at(0.0).distance(at) < 1e-12 && e.at(e.sweep).distance(*to) < 1e-12, "{e:?}");
            }
            at = match *piece {
                Piece::Line(to) | Piece::Arc(_, to) => to,
                _ => at,
            };
        }
        assert_eq!(at, chain.start);
        // The sides of half the height have no straight part.
        assert_eq!(chain.pieces.len(), 6);
    }
}
