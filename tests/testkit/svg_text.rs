//! SVG files made from a seed, in the styles of the programs that write them.

use super::rng::{self, Rng};
use rand::RngExt;
use std::fmt::Write;

/// A random drawing: shapes, groups, transforms, copies and nested pages.
pub(crate) fn seeded(seed: u64) -> String {
    let mut rng = rng::seeded(seed);
    let root = match seed % 5 {
        0 => "width=\"200mm\" height=\"100mm\" viewBox=\"0 0 200 100\"".to_owned(),
        1 => "width=\"8in\" height=\"4in\" viewBox=\"-10 -20 400 200\"".to_owned(),
        2 => "width=\"400\" height=\"300\"".to_owned(),
        3 => "width=\"40cm\" height=\"100mm\" viewBox=\"0 0 300 300\" preserveAspectRatio=\"xMaxYMin meet\""
            .to_owned(),
        _ => "viewBox=\"5 5 320 240\"".to_owned(),
    };
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" {root}>\n\
         <style>.cut{{fill:none;stroke:#f00}} g .mark{{fill:none;stroke:blue}}</style>\n<defs>\n"
    );
    let mut writer = Writer { rng: &mut rng, text: &mut text };
    for id in 0..3 {
        let _ = write!(writer.text, "<g id=\"def{id}\">");
        writer.shape();
        writer.shape();
        writer.text.push_str("</g>\n");
    }
    writer.text.push_str("<symbol id=\"sym\" viewBox=\"0 0 50 40\">");
    writer.shape();
    writer.text.push_str("</symbol></defs>\n");
    let groups = 2 + seed % 4;
    for _ in 0..groups {
        writer.group(0);
    }
    text.push_str("</svg>\n");
    text
}

struct Writer<'w> {
    rng: &'w mut Rng,
    text: &'w mut String,
}

impl Writer<'_> {
    fn pick(&mut self, n: u64) -> u64 {
        self.rng.random_range(0..n)
    }

    /// A number with up to three decimals.
    fn number(&mut self, low: f64, high: f64) -> f64 {
        ((low + self.rng.random::<f64>() * (high - low)) * 1000.0).round() / 1000.0
    }

    fn at(&mut self) -> f64 {
        self.number(10.0, 180.0)
    }

    fn size(&mut self) -> f64 {
        self.number(2.0, 20.0)
    }

    fn group(&mut self, depth: u64) {
        let transform = self.transform();
        let _ = write!(self.text, "<g{transform} class=\"cut\">");
        for _ in 0..=self.pick(3) {
            match self.pick(8) {
                0 if depth < 3 => self.group(depth + 1),
                1 => self.copy(),
                2 => self.page(),
                _ => self.shape(),
            }
        }
        self.text.push_str("</g>\n");
    }

    fn transform(&mut self) -> String {
        let (a, b, c) = (self.number(-20.0, 20.0), self.number(-20.0, 20.0), self.number(0.4, 1.6));
        match self.pick(9) {
            0 => format!(" transform=\"translate({a} {b})\""),
            1 => format!(" transform=\"rotate({a})\""),
            2 => format!(" transform=\"rotate({a},{},{})\"", b * 5.0, a * 3.0),
            3 => format!(" transform=\"scale({c})\""),
            4 => format!(" transform=\"scale({c},{})\"", 2.0 - c),
            5 => format!(" transform=\"matrix({c} 0.1 -0.2 {} {a} {b})\"", 2.0 - c),
            6 => format!(" transform=\"skewX({a}) translate({b})\""),
            7 => format!(" transform=\"scale(-{c} {c}) translate(-150,0)\""),
            _ => String::new(),
        }
    }

    fn copy(&mut self) {
        let (x, y) = (self.number(-30.0, 60.0), self.number(-30.0, 60.0));
        if self.pick(2) == 0 {
            let id = self.pick(3);
            let _ = write!(self.text, "<use xlink:href=\"#def{id}\" x=\"{x}\" y=\"{y}\"/>");
        } else {
            let (w, h) = (self.number(20.0, 100.0), self.number(20.0, 100.0));
            let _ = write!(
                self.text,
                "<use href=\"#sym\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" overflow=\"visible\"/>"
            );
        }
    }

    fn page(&mut self) {
        let (x, y, w) = (self.at(), self.at(), self.number(20.0, 100.0));
        let _ = write!(
            self.text,
            "<svg x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"50%\" viewBox=\"0 0 100 60\" overflow=\"visible\">"
        );
        self.shape();
        self.text.push_str("</svg>");
    }

    fn shape(&mut self) {
        let style = [
            "class=\"cut\"",
            "class=\"mark cut\"",
            "style=\"fill:none;stroke:#0a0\"",
            "fill=\"#333\" stroke=\"none\"",
        ];
        let style = style[usize::try_from(self.pick(4)).unwrap_or(0)];
        let (x, y, w, h) = (self.at(), self.at(), self.size(), self.size());
        let transform = self.transform();
        let shape = match self.pick(8) {
            0 => format!("<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\""),
            1 => format!("<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" rx=\"{}\"", w / 4.0),
            2 => format!(
                "<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" rx=\"{}\" ry=\"{}\"",
                w / 3.0,
                h
            ),
            3 => format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{w}\""),
            4 => format!("<ellipse cx=\"{x}\" cy=\"{y}\" rx=\"{w}\" ry=\"{h}\""),
            5 => format!("<polygon points=\"{x},{y} {},{y} {},{}\"", x + w, x + w, y + h),
            6 => format!("<polyline points=\"{x} {y},{} {} {} {y}\"", x + w, y + h, x + 2.0 * w),
            _ => {
                let d = self.path();
                // With a stroke, so that a single line is visible.
                let _ = write!(self.text, "<path d=\"{d}\" class=\"cut\"{transform}/>");
                return;
            }
        };
        let _ = write!(self.text, "{shape} {style}{transform}/>");
    }

    fn path(&mut self) -> String {
        let mut d = format!("M{} {}", self.at(), self.at());
        for _ in 0..=self.pick(7) {
            let (a, b, c, e, x, y) = (self.at(), self.at(), self.at(), self.at(), self.at(), self.at());
            let (rx, ry, turn) = (self.size() / 2.0, self.size() / 2.0, self.number(-90.0, 90.0));
            let (large, sweep) = (self.pick(2), self.pick(2));
            let piece = match self.pick(13) {
                0 => format!("L{x},{y}"),
                1 => format!("l{}-{}", x / 4.0, y / 8.0),
                2 => format!("H{x}"),
                3 => format!("v{}", y / 6.0),
                4 => format!("C{a} {b} {c} {e} {x} {y}"),
                5 => format!("c{} {} {} {} {} {}", a / 5.0, b / 5.0, -c / 5.0, e / 5.0, x / 5.0, y / 5.0),
                6 => format!("S{a} {b} {x} {y}"),
                7 => format!("Q{a} {b} {x} {y}"),
                8 => format!("T{x} {y}"),
                // The ends are within reach of the radii: usvg draws arcs as curves that are off by 0.03 % of the radius.
                9 => format!("a{rx} {ry} {turn} {large}{sweep} {} {}", rx / 3.0, ry / 3.0),
                10 => format!("a{rx} {rx} 0 {large} {sweep} {} {}", rx, -rx / 3.0),
                11 => format!("zm{} {}l5 5", x / 20.0, y / 20.0),
                _ => format!("M{x} {y}h{}", a / 9.0),
            };
            d.push_str(&piece);
        }
        if self.pick(2) == 0 {
            d.push('z');
        }
        d
    }
}
