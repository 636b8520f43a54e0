//! The SVG, read back and compared with the plan.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_cmp,
    clippy::print_stdout,
    reason = "tests stop where they cannot go on and compare what must be equal"
)]

use crate::testkit::paths::{Element, assert_same_path};
use glam::DVec2;
use kerfway::geometry::Segment;
use kerfway::machine::Profile;
use kerfway::output;
use kerfway::plan::{Move, Plan};
use kerfway::sheet::Sheet;

/// Largest distance between the picture and the plan, mm.
const DEVIATION: f64 = 0.003;

/// The value of an attribute in each element that carries all of `marks`.
fn attributes<'a>(svg: &'a str, marks: &[&str], name: &str) -> Vec<&'a str> {
    svg.split('<')
        .filter(|tag| marks.iter().all(|m| tag.contains(m)))
        .map(|tag| tag.split_once(&format!("{name}=\"")).unwrap().1.split_once('"').unwrap().0)
        .collect()
}

/// Commands and numbers of path data.
fn commands(data: &str) -> Vec<(char, Vec<f64>)> {
    let mut list: Vec<(char, String)> = Vec::new();
    for c in data.chars() {
        if c.is_ascii_alphabetic() {
            list.push((c, String::new()));
        } else {
            list.last_mut().unwrap().1.push(c);
        }
    }
    list.into_iter().map(|(c, n)| (c, n.split_whitespace().map(|n| n.parse().unwrap()).collect())).collect()
}

/// The elements of one contour's path data, in the coordinates of the sheet.
fn elements(data: &str) -> (Vec<Element>, bool) {
    let place = |x: f64, y: f64| DVec2::new(x, -y);
    let (mut at, mut list, mut closed) = (DVec2::ZERO, Vec::new(), false);
    for (command, n) in commands(data) {
        match (command, n.as_slice()) {
            ('M', &[x, y]) => at = place(x, y),
            ('L', &[x, y]) => {
                list.push(Element::line(at, place(x, y)));
                at = place(x, y);
            }
            ('A', &[rx, ry, turn, large, sweep, x, y]) => {
                assert_eq!((rx, turn, large), (ry, 0.0, 0.0));
                let to = place(x, y);
                // SVG leaves out arcs without length.
                if to != at {
                    // y runs down: what SVG calls positive is clockwise on the sheet.
                    list.push(Element::of_radius(at, to, rx, sweep == 0.0));
                }
                at = to;
            }
            ('Z', []) => closed = true,
            other => panic!("{other:?}"),
        }
    }
    (list, closed)
}

/// Contour and path of each cut and mark.
fn cuts(plan: &Plan) -> Vec<(usize, &[Segment])> {
    plan.moves
        .iter()
        .filter_map(|m| match m {
            Move::Cut { contour, path, .. } => Some((*contour as usize, path.as_slice())),
            _ => None,
        })
        .collect()
}

#[test]
fn contours_come_back_in_order_as_planned() {
    crate::testkit::random_plans::each(300, assert_same);
}

fn assert_same(sheet: &Sheet, plan: &Plan, profile: &Profile) {
    let svg = output::svg(plan, &output::SheetFacts::of(sheet), profile);
    let drawn = attributes(&svg, &["path class=\""], "d");
    // Two more: air moves and entries.
    assert_eq!(drawn.len(), cuts(plan).len() + 2);
    for ((contour, path), data) in cuts(plan).into_iter().zip(drawn) {
        let (list, closed) = elements(data);
        assert_same_path(&list, path, DEVIATION);
        // A stretch of a contour that is left unfinished does not close, nor does a run through a pierce group.
        let comes_back = path[0].start() == path[path.len() - 1].end();
        let contour = &sheet.contours[contour];
        let length: f64 = path.iter().map(Segment::length).sum();
        assert_eq!(closed, contour.path.closed && comes_back && length > contour.length - 1e-6);
    }
}

#[test]
fn air_moves_are_drawn_from_home_and_back() {
    let (sheet, plan) = crate::testkit::plans::small();
    let svg = output::svg(&plan, &output::SheetFacts::of(&sheet), &crate::testkit::plans::machine());
    assert_eq!(
        attributes(&svg, &["class=\"air\""], "d"),
        ["M0 0L12 -11M38 -11L25 -25M25 -25L10 -10M10 -10L0 0"]
    );
    assert_eq!(attributes(&svg, &["class=\"entry\""], "d"), ["M12 -11h0M25 -25h0M10 -10h0"]);
}

#[test]
fn size_and_view_box_are_millimetres_and_hold_everything() {
    let (sheet, plan) = crate::testkit::plans::small();
    let svg = output::svg(&plan, &output::SheetFacts::of(&sheet), &crate::testkit::plans::machine());
    assert_eq!(attributes(&svg, &["svg xmlns"], "width"), ["52mm"]);
    assert_eq!(attributes(&svg, &["svg xmlns"], "height"), ["42mm"]);
    assert_eq!(attributes(&svg, &["svg xmlns"], "viewBox"), ["-1 -41 52 42"]);
}

#[test]
fn order_and_names_are_readable_and_escaped() {
    let (sheet, plan) = crate::testkit::plans::small();
    let svg = output::svg(&plan, &output::SheetFacts::of(&sheet), &crate::testkit::plans::machine());
    let titles: Vec<&str> = svg.split("<title>").skip(1).map(|t| t.split_once('<').unwrap().0).collect();
    assert_eq!(
        titles,
        [
            "3 contours, about 12.5 s",
            "1: contour 0, layer Gravur &lt;\u{df}&gt;",
            "2: contour 1, layer Cut 3mm",
            "3: contour 2, layer Cut 3mm"
        ]
    );
    assert_eq!(svg.matches("<text").count(), 3);
    assert!(attributes(&svg, &["path class=\"mark\""], "d").len() == 1);
    for forbidden in ["script", "href", "url("] {
        assert!(!svg.contains(forbidden), "{forbidden}");
    }
}

#[test]
fn layer_names_cannot_break_out() {
    let (mut sheet, plan) = crate::testkit::plans::small();
    sheet.layers[0].name = "a</title><script>alert(1)</script>&\"\u{0}\u{1b}".into();
    let svg = output::svg(&plan, &output::SheetFacts::of(&sheet), &crate::testkit::plans::machine());
    assert!(!svg.contains("<script"));
    assert!(svg.contains("a&lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt;&amp;\"\u{fffd}\u{fffd}"));
    assert!(svg.chars().all(|c| c == '\n' || !c.is_control()));
}

#[test]
fn an_empty_plan_is_a_picture_of_home() {
    let (sheet, plan) = crate::testkit::plans::plan_of(vec![], &[], &crate::testkit::plans::machine());
    let svg = output::svg(&plan, &output::SheetFacts::of(&sheet), &crate::testkit::plans::machine());
    assert!(
        svg.starts_with("<svg ") && svg.ends_with("</svg>\n") && !svg.contains("inf") && !svg.contains("NaN")
    );
}
