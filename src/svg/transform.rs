//! The attribute and the CSS property `transform`.

use super::length::{Axis, Length, Lengths};
use super::numbers::Scanner;
use crate::geometry::{Affine, DVec2, math};

/// The map of a list of transforms, of which the last is applied first; `None` if it is not one that is read here.
pub(super) fn read(text: &str, lengths: &Lengths) -> Option<Affine> {
    let mut scanner = Scanner::new(text);
    let mut map = Affine::IDENTITY;
    loop {
        scanner.skip_separator();
        if scanner.peek().is_none() {
            return Some(map);
        }
        let name = scanner.name();
        if name == b"none" {
            continue;
        }
        // A drawing is even: the third part of a move leads away from it.
        let is_3d = name == b"translate" && scanner.accept(b'3') && scanner.accept(b'd');
        scanner.skip_blanks();
        if !scanner.accept(b'(') {
            return None;
        }
        let (values, count) = arguments(&mut scanner, name, lengths)?;
        let count = if is_3d { count.checked_sub(1).filter(|n| *n == 2)? } else { count };
        map = one(name, &values, count)?.then(&map);
    }
}

/// The point of a `transform-origin` in user units; `None` if it is not one. Parts refer to the nearest viewport, which
/// is the initial box. A third length is a depth, which an even drawing does not have.
pub(super) fn origin(text: &str, lengths: &Lengths) -> Option<DVec2> {
    let mut words: Vec<&str> = text.split_ascii_whitespace().collect();
    let is_vertical = |word: &&str| matches!(*word, "top" | "bottom");
    // Names may come in either order: `top left` is `left top`.
    if words.first().is_some_and(is_vertical) {
        words.resize(words.len().max(2), "center");
        words.swap(0, 1);
    } else if words.get(1).is_some_and(|word| matches!(*word, "left" | "right")) {
        words.swap(0, 1);
    }
    let part = |k: usize, start: &str, end: &str, axis: Axis| {
        let word = match words.get(k).copied().unwrap_or("center") {
            "center" => "50%",
            word if word == start => "0",
            word if word == end => "100%",
            word => word,
        };
        lengths.read(word, axis)
    };
    let at = DVec2::new(part(0, "left", "right", Axis::Width)?, part(1, "top", "bottom", Axis::Height)?);
    (!words.is_empty() && words.len() <= 3).then_some(at)
}

/// Up to six numbers and the bracket after them: lengths in user units, and angles in degrees.
fn arguments(scanner: &mut Scanner<'_>, name: &[u8], lengths: &Lengths) -> Option<([f64; 6], usize)> {
    let mut values = [0.0; 6];
    let mut count = 0;
    loop {
        scanner.skip_separator();
        if scanner.accept(b')') {
            return Some((values, count));
        }
        let value = if name.starts_with(b"translate") {
            let axis = if name == b"translateY" || count == 1 { Axis::Height } else { Axis::Width };
            lengths.resolve(Length::scan(scanner)?, axis)
        } else {
            scanner.number()? * unit(scanner)?
        };
        *values.get_mut(count)? = value;
        count += 1;
    }
}

/// Degrees in the unit of an angle. Numbers without a unit, and pixels, are those that SVG has anyway.
fn unit(scanner: &mut Scanner<'_>) -> Option<f64> {
    Some(match scanner.name() {
        b"" | b"px" | b"deg" => 1.0,
        b"rad" => 1_f64.to_degrees(),
        b"grad" => 0.9,
        b"turn" => 360.0,
        _ => return None,
    })
}

fn one(name: &[u8], v: &[f64; 6], count: usize) -> Option<Affine> {
    let turn = |degrees: f64| Affine::rotation(degrees.to_radians());
    let skew = |x: f64, y: f64| Affine {
        x: DVec2::new(1.0, math::tan(y.to_radians())),
        y: DVec2::new(math::tan(x.to_radians()), 1.0),
        origin: DVec2::ZERO,
    };
    let map = match (name, count) {
        (b"matrix", 6) => {
            Affine { x: DVec2::new(v[0], v[1]), y: DVec2::new(v[2], v[3]), origin: DVec2::new(v[4], v[5]) }
        }
        (b"translate", 1 | 2) => Affine::translation(DVec2::new(v[0], v[1])),
        (b"translateX", 1) => Affine::translation(DVec2::new(v[0], 0.0)),
        (b"translateY", 1) => Affine::translation(DVec2::new(0.0, v[0])),
        (b"scale", 1) => Affine::scale(DVec2::splat(v[0])),
        (b"scale", 2) => Affine::scale(DVec2::new(v[0], v[1])),
        (b"scaleX", 1) => Affine::scale(DVec2::new(v[0], 1.0)),
        (b"scaleY", 1) => Affine::scale(DVec2::new(1.0, v[0])),
        (b"rotate" | b"rotateZ", 1) => turn(v[0]),
        (b"rotate", 3) => {
            let center = DVec2::new(v[1], v[2]);
            Affine::translation(-center).then(&turn(v[0])).then(&Affine::translation(center))
        }
        (b"skewX", 1) => skew(v[0], 0.0),
        (b"skewY", 1) => skew(0.0, v[0]),
        (b"skew", 1 | 2) => skew(v[0], v[1]),
        _ => return None,
    };
    map.is_finite().then_some(map)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTHS: Lengths = Lengths { dpi: 96.0, viewport: DVec2::new(200.0, 100.0) };

    fn image(transform: &str, x: f64, y: f64) -> Vec<f64> {
        let p = read(transform, &LENGTHS).unwrap().point(DVec2::new(x, y));
        [p.x, p.y].iter().map(|v| (v * 1e9).round() / 1e9).collect()
    }

    #[test]
    fn the_last_transform_is_applied_first() {
        assert_eq!(image("translate(10, 20) scale(2)", 1.0, 1.0), [12.0, 22.0]);
        assert_eq!(image("scale(2)translate(10 20)", 1.0, 1.0), [22.0, 42.0]);
        assert_eq!(image("rotate(90)", 1.0, 0.0), [0.0, 1.0]);
        assert_eq!(image("rotate(90, 10, 0)", 11.0, 0.0), [10.0, 1.0]);
        assert_eq!(image("matrix(1 2 3 4 5 6)", 1.0, 1.0), [9.0, 12.0]);
        assert_eq!(image("skewX(45)", 0.0, 3.0), [3.0, 3.0]);
        assert_eq!(image("translate(5px) rotate(0.25turn)", 1.0, 0.0), [5.0, 1.0]);
        assert_eq!(image("none", 1.0, 2.0), [1.0, 2.0]);
        assert_eq!(image("translate(25.4mm, 10%)", 1.0, 2.0), [97.0, 12.0]);
        assert_eq!(image("translateY(50%) translate3d(1px, 2px, 3px)", 0.0, 0.0), [1.0, 52.0]);
        assert_eq!(image("rotateZ(100grad)", 1.0, 0.0), [0.0, 1.0]);
    }

    #[test]
    fn what_is_no_transform_is_refused() {
        for text in [
            "turn(3)",
            "rotate(1 2)",
            "scale",
            "matrix(1 2 3 4 5)",
            "translate(1",
            "scale(1e400)",
            "rotate(2mm)",
            "translate(calc(1px))",
        ] {
            assert_eq!(read(text, &LENGTHS), None, "{text}");
        }
    }
}
