//! Drawings of closed polylines, and whether a program cuts along them.

use super::gcode;
use kerfway::geometry::DVec2;
use std::fmt::Write;

/// Closed polylines as a drawing.
pub(crate) fn drawing(outlines: &[Vec<DVec2>]) -> Vec<u8> {
    let mut text =
        String::from("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
    for outline in outlines {
        let _ = write!(text, "0\nLWPOLYLINE\n8\n0\n90\n{}\n70\n1\n", outline.len());
        for p in outline {
            let _ = write!(text, "10\n{}\n20\n{}\n", p.x, p.y);
        }
    }
    text.push_str("0\nENDSEC\n0\nEOF\n");
    text.into_bytes()
}

/// Whether the beam passes every place of every outline within 0.01 mm.
pub(crate) fn covers(outlines: &[Vec<DVec2>], text: &str) {
    let program = gcode::run(text).unwrap();
    let burnt: Vec<_> = program.motions().filter(|m| m.beam > 0.0).map(|m| m.path).collect();
    for outline in outlines {
        for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            for k in 0..=20 {
                let p = a.lerp(*b, f64::from(k) / 20.0);
                let off = burnt.iter().map(|e| e.distance(p)).fold(f64::INFINITY, f64::min);
                assert!(off <= 0.01, "{p} is {off} mm from any cut");
            }
        }
    }
}
