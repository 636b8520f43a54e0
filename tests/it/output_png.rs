//! The PNG renderer: decoded again, ink must lie where contours are and white where nothing is.
#![cfg(feature = "png")]
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "tests stop where they cannot go on, and count pixels"
)]

use glam::DVec2;
use kerfway::geometry::{Path, Segment};
use kerfway::output::png::{WIDTHS, render};
use kerfway::plan::Plan;
use kerfway::sheet::{Operation, Sheet};
use tiny_skia::Pixmap;

/// The colour families of a picture.
#[derive(Debug, PartialEq)]
enum Shade {
    White,
    Ink,
    Blue,
    Orange,
}

/// A decoded picture and the sheet on it: home (0, 0) and everything else within `size` mm.
struct Picture {
    pixels: Pixmap,
    size: DVec2,
}

impl Picture {
    fn of(sheet: &Sheet, plan: &Plan, size: DVec2, width: u32) -> Self {
        let png = render(&crate::testkit::plans::document(sheet, plan), width).unwrap();
        Self { pixels: Pixmap::decode_png(&png).unwrap(), size }
    }

    /// The pixel at a place of the sheet; the rim is a fiftieth of the width.
    fn pixel(&self, x: f64, y: f64) -> (u32, u32) {
        let rim = f64::from(self.pixels.width()) / 50.0;
        let scale = (f64::from(self.pixels.width()) - 2.0 * rim) / self.size.x;
        ((rim + x * scale) as u32, (f64::from(self.pixels.height()) - rim - y * scale) as u32)
    }

    /// The shade at a pixel, of the darkest among it and its neighbours.
    fn shade(&self, x: f64, y: f64) -> Shade {
        let (px, py) = self.pixel(x, y);
        let near = (px - 1..=px + 1).flat_map(|x| (py - 1..=py + 1).map(move |y| (x, y)));
        let darkest = near
            .map(|(x, y)| self.pixels.pixel(x, y).unwrap())
            .min_by_key(|c| u32::from(c.red()) + u32::from(c.green()) + u32::from(c.blue()))
            .unwrap();
        let (r, g, b) = (i32::from(darkest.red()), i32::from(darkest.green()), i32::from(darkest.blue()));
        match () {
            () if r > 200 && g > 200 && b > 200 => Shade::White,
            () if r > b + 30 => Shade::Orange,
            () if b > r + 30 => Shade::Blue,
            () if r < 100 => Shade::Ink,
            () => panic!("what is ({r}, {g}, {b})?"),
        }
    }
}

#[test]
fn contours_are_ink_marks_blue_entries_and_air_orange_the_rest_white() {
    let (sheet, plan) = crate::testkit::plans::small();
    let picture = Picture::of(&sheet, &plan, DVec2::new(50.0, 40.0), 1000);
    assert_eq!((picture.pixels.width(), picture.pixels.height()), (1000, 808));

    // The plate: all four sides, the round corner at 45 degrees, and nothing where the sharp corner would be.
    for (x, y) in [
        (30.0, 10.0),
        (50.0, 20.0),
        (30.0, 40.0),
        (10.0, 30.0),
        (46.0 + 8.0_f64.sqrt(), 36.0 + 8.0_f64.sqrt()),
    ] {
        assert_eq!(picture.shade(x, y), Shade::Ink, "at {x} {y}");
    }
    assert_eq!(picture.shade(49.8, 39.8), Shade::White);
    // The hole, all around but at its entry on the left.
    for (x, y) in [(35.0, 25.0), (30.0, 30.0), (30.0, 20.0), (33.0, 29.0), (27.0, 21.0)] {
        assert_eq!(picture.shade(x, y), Shade::Ink, "at {x} {y}");
    }
    assert_eq!(picture.shade(30.0, 25.0), Shade::White);
    assert_eq!(picture.shade(20.0, 11.0), Shade::Blue);
    for (x, y) in [(12.0, 11.0), (25.0, 25.0), (10.0, 10.0)] {
        assert_eq!(picture.shade(x, y), Shade::Orange, "entry at {x} {y}");
    }

    // The way home, dashed: some of it orange, some white.
    let way: Vec<Shade> = (5..90).map(|i| picture.shade(f64::from(i) * 0.1, f64::from(i) * 0.1)).collect();
    assert!(way.contains(&Shade::Orange) && way.iter().all(|s| [Shade::Orange, Shade::White].contains(s)));
    let orange = way.iter().filter(|s| **s == Shade::Orange).count();
    assert!((way.len() / 2..way.len()).contains(&orange), "{orange} of {}", way.len());
    assert_eq!(picture.shade(45.0, 5.0), Shade::White);
}

#[test]
fn arcs_are_round_on_the_largest_picture() {
    let (sheet, plan) = crate::testkit::plans::small();
    let picture = Picture::of(&sheet, &plan, DVec2::new(50.0, 40.0), 4000);
    for i in 1..64 {
        let (s, c) = kerfway::geometry::math::unit(f64::from(i) * 0.0982 + std::f64::consts::PI).into();
        let at = |r: f64| picture.shade(30.0 + s * r, 25.0 + c * r);
        assert_eq!(at(5.0), Shade::Ink, "{i}");
        assert_eq!((at(4.9), at(5.1)), (Shade::White, Shade::White), "{i}");
    }
}

#[test]
fn width_is_as_requested_and_limited() {
    let (sheet, plan) = crate::testkit::plans::small();
    let json = crate::testkit::plans::document(&sheet, &plan);
    for width in [*WIDTHS.start(), 333] {
        let picture = Pixmap::decode_png(&render(&json, width).unwrap()).unwrap();
        assert_eq!(picture.width(), width);
    }
    for width in [0, WIDTHS.start() - 1, WIDTHS.end() + 1, u32::MAX] {
        let error = render(&json, width).unwrap_err();
        assert_eq!(error, format!("A picture cannot be {width} pixels wide. Choose 64 to 8192."));
    }
}

#[test]
fn plans_of_any_size_and_shape_are_drawn() {
    for seed in 0..30 {
        let (sheet, plan) = crate::testkit::random_plans::random(seed);
        let picture =
            Pixmap::decode_png(&render(&crate::testkit::plans::document(&sheet, &plan), 100).unwrap())
                .unwrap();
        assert!(picture.pixels().iter().any(|p| p.green() < 128), "seed {seed} left no trace");
    }
    // Nothing at all, and a line without height.
    let (sheet, plan) =
        crate::testkit::plans::plan_of(vec![], &[("0", 7)], &crate::testkit::plans::machine());
    assert!(render(&crate::testkit::plans::document(&sheet, &plan), 100).is_ok());
    let path = Path::new(vec![Segment::line(DVec2::ZERO, DVec2::new(10.0, 0.0))], false);
    let stop = crate::testkit::plans::Stop { layer: 0, operation: Operation::Cut, path };
    let (sheet, plan) =
        crate::testkit::plans::plan_of(vec![stop], &[("0", 7)], &crate::testkit::plans::machine());
    let flat =
        Pixmap::decode_png(&render(&crate::testkit::plans::document(&sheet, &plan), 1000).unwrap()).unwrap();
    assert_eq!((flat.width(), flat.height()), (1000, 41));
}

#[test]
fn a_document_that_is_not_a_plan_is_refused_in_a_sentence() {
    let (sheet, plan) = crate::testkit::plans::small();
    let json = crate::testkit::plans::document(&sheet, &plan);
    let error = |text: &str| render(text, 100).unwrap_err();
    assert!(error("").starts_with("This is not a plan of the kind kerfway.plan/1"));
    assert!(error("{}").contains("`schema`"));
    assert_eq!(
        error(&json.replace("kerfway.plan/1", "kerfway.plan/9")),
        "This is a document of the kind kerfway.plan/9, not kerfway.plan/1."
    );
    assert!(error(&json.replace("[38,11]", "[1e999,11]")).starts_with("This is not a plan"));
    assert_eq!(
        error(&json.replace("[38,11]", "[1e308,-1e308]").replace("[12,11]", "[-1e308,1e308]")),
        "The plan has no size that can be drawn: a coordinate is out of range."
    );
    // Pre-cuts and cuts shared by several contours belong to the format.
    let shared = json
        .replace("\"contour\":2", "\"contour\":[2,1]")
        .replace("{\"kind\":\"pierce\"}", "{\"kind\":\"pre-cut\",\"contour\":2,\"to\":[10,10]}");
    assert_ne!(shared, json);
    assert!(render(&shared, 100).is_ok());
}
