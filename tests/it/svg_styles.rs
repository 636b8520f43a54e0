//! Style sheets and transforms of SVG files: what they move, hide or colour, compared with what Chromium shows.

use super::svg_files::{layers, page};
use crate::testkit::drawings::found;
use kerfway::drawing::{Drawing, ReadOptions};
use kerfway::finding::Code;
use kerfway::svg;

/// The boxes of all shapes, in user units of the page, y down: left, top, right, bottom.
fn boxes(drawing: &Drawing) -> Vec<[f64; 4]> {
    let rounded = |v: f64| (v * 1e4).round() / 1e4;
    let bounds = drawing.shapes.iter().map(|s| s.path.bounds());
    bounds.map(|b| [b.min.x, 50.0 - b.max.y, b.max.x, 50.0 - b.min.y].map(rounded)).collect()
}

/// A circle of radius 2 around a point with this style and these attributes.
fn circle(x: f64, y: f64, more: &str) -> String {
    format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"2\" fill=\"none\" stroke=\"red\" {more}/>")
}

/// The box of a circle of radius 2 around a point.
fn around(x: f64, y: f64) -> [f64; 4] {
    [x - 2.0, y - 2.0, x + 2.0, y + 2.0]
}

fn messages(drawing: &Drawing) -> Vec<&str> {
    drawing.findings.iter().map(|f| f.message.as_str()).collect()
}

fn says(drawing: &Drawing, what: &str) -> bool {
    messages(drawing).iter().any(|m| m.contains(what))
}

/// A stroke in `var()` or in a new colour function counted as none, and the line was not cut.
#[test]
fn a_line_whose_colour_cannot_be_read_was_lost() {
    let drawn = |style: &str, stroke: &str| {
        page(&format!("<style>{style}</style><path d=\"M10 10h20v20h-20z\" fill=\"none\" {stroke}/>"))
    };
    for (style, stroke, layer) in [
        ("", "stroke=\"var(--stroke-0, black)\"", "#000000"),
        (":root{--cut:#f00}", "stroke=\"var(--cut)\"", "#ff0000"),
        ("svg{--cut:var(--red, blue)} path{stroke:var(--cut)}", "", "#0000ff"),
        ("", "style=\"--mine:lime;stroke:var(--mine)\"", "#00ff00"),
        // Without a value that all know, the line is cut, and that it is guessed is said.
        (".a{--cut:red} .b{--cut:blue}", "stroke=\"var(--cut)\"", "unknown colour"),
        ("", "stroke=\"var(--unknown)\"", "unknown colour"),
        ("", "stroke=\"oklch(60% 0.2 30)\"", "unknown colour"),
        ("", "stroke=\"rgb(none 0 255)\"", "unknown colour"),
        // Programs write a colour for all before one for few.
        ("", "stroke=\"#f00\" style=\"stroke:color(display-p3 1 0 0)\"", "#ff0000"),
        ("", "stroke=\"#f00\" style=\"STROKE:light-dark(#000, #fff)\"", "#ff0000"),
    ] {
        let drawing = drawn(style, stroke);
        assert_eq!(layers(&drawing), [layer], "{style} {stroke}");
        let unknown = says(&drawing, "1 shape is drawn in a colour that cannot be read");
        assert_eq!(unknown, layer == "unknown colour", "{stroke}: {:?}", messages(&drawing));
    }
    let hidden =
        page(&format!("{}{}", circle(10.0, 10.0, "style=\"display:var(--d)\""), circle(30.0, 10.0, "")));
    assert!(
        says(&hidden, "1 object has a style with a value that cannot be read"),
        "{:?}",
        messages(&hidden)
    );
    let off = circle(10.0, 10.0, "style=\"--d:none;display:var(--d)\"");
    assert_eq!(boxes(&page(&(off + &circle(30.0, 10.0, "")))), [around(30.0, 10.0)]);
}

/// A value that is none took the place of one that hid a shape.
#[test]
fn a_value_that_is_none_changes_nothing() {
    for style in ["visibility:hidden;visibility:bogus", "stroke-opacity:0;stroke-opacity:bogus"] {
        let hidden = circle(10.0, 10.0, &format!("style=\"{style}\""));
        assert_eq!(boxes(&page(&(hidden + &circle(30.0, 10.0, "")))), [around(30.0, 10.0)], "{style}");
    }
    let inherits = page(&format!("<g stroke=\"blue\">{}</g>", circle(9.0, 9.0, "style=\"stroke:unset\"")));
    assert_eq!(layers(&inherits), ["#0000ff"]);
}

/// Places and sizes in style sheets were ignored, without a word.
#[test]
fn the_geometry_of_style_sheets_was_ignored() {
    let drawn = |style: &str, shape: &str| {
        page(&format!("<style>{style}</style><g fill=\"none\" stroke=\"red\">{shape}</g>"))
    };
    let rect = "<rect x=\"5\" y=\"5\" width=\"40\" height=\"20\"/>";
    for (style, shape, expected) in [
        ("circle{r:2.5px}", "<circle cx=\"15\" cy=\"15\" r=\"5\"/>", [12.5, 12.5, 17.5, 17.5]),
        ("circle{cx:20px;cy:10%}", "<circle r=\"5\"/>", [15.0, 0.0, 25.0, 10.0]),
        ("ellipse{rx:3px;ry:auto}", "<ellipse cx=\"10\" cy=\"10\" ry=\"5\"/>", [7.0, 7.0, 13.0, 13.0]),
        ("rect{x:1px;width:10px !important} rect{width:3px}", rect, [1.0, 5.0, 11.0, 25.0]),
        // A number without a unit is no length of a style sheet.
        ("rect{x:1;y:0}", rect, [5.0, 0.0, 45.0, 20.0]),
        ("path{d:path('M1 2h3v4z')}", "<path d=\"M0 0h50v50z\"/>", [1.0, 2.0, 4.0, 6.0]),
        (
            "use{x:10px}",
            "<defs><path id=\"p\" d=\"M1 2h3v4z\"/></defs><use href=\"#p\"/>",
            [11.0, 2.0, 14.0, 6.0],
        ),
    ] {
        let drawing = drawn(style, shape);
        assert_eq!(boxes(&drawing), [expected], "{style}");
        assert!(drawing.findings.is_empty(), "{style}: {:?}", messages(&drawing));
    }
    let rounded = drawn("rect{rx:6px}", rect);
    assert_eq!(rounded.shapes[0].path.segments.len(), 8);
}

/// `x="calc(50% - 5px)"` was cut at 0 without a word.
#[test]
fn a_place_that_cannot_be_read_is_a_finding() {
    for body in [
        "<rect x=\"calc(50% - 5px)\" width=\"9\" height=\"9\" stroke=\"red\"/>",
        "<rect width=\"9\" height=\"9\" style=\"x:10vw;stroke:red\"/>",
    ] {
        let drawing = page(body);
        let expected = "A rect: one of its lengths cannot be read, and counts as missing.";
        assert_eq!(found(&drawing, Code::InvalidGeometry).message, expected, "{body}");
    }
    let copied = page(&format!("<defs>{}</defs><use href=\"#c\" x=\"10ch\"/>", circle(9.0, 9.0, "id=\"c\"")));
    assert!(says(&copied, "1 object has a place or size that cannot be read"), "{:?}", messages(&copied));
    let automatic = page("<rect width=\"9\" height=\"9\" rx=\"auto\" fill=\"none\" stroke=\"red\"/>");
    assert!(automatic.findings.is_empty(), "{:?}", messages(&automatic));
}

/// `translate`, `rotate` and `scale` were ignored, and moves with units or percentages were "placed without, as browsers do".
#[test]
fn transforms_of_style_sheets_were_left_out() {
    let drawn = |style: &str| page(&format!("<g style=\"{style}\">{}</g>", circle(10.0, 10.0, "")));
    for (style, [x, y]) in [
        ("translate:40px 20px", [50.0, 30.0]),
        ("translate:40px", [50.0, 10.0]),
        ("translate:50%", [60.0, 10.0]),
        ("rotate:90deg;transform-origin:20px 10px", [20.0, 0.0]),
        ("translate:1px 2px;rotate:0.25turn;transform:translate(3px,0)", [-9.0, 15.0]),
        ("translate:none;rotate:none;scale:none", [10.0, 10.0]),
        ("transform:translate(50%,0)", [60.0, 10.0]),
        ("transform:translate3d(20px,0,0)", [30.0, 10.0]),
        ("transform:translate(1in,0)", [106.0, 10.0]),
        ("--a:5px;transform:translate(var(--a),0)", [15.0, 10.0]),
    ] {
        let drawing = drawn(style);
        assert_eq!(boxes(&drawing), [around(x, y)], "{style}");
        assert!(drawing.findings.is_empty(), "{style}: {:?}", messages(&drawing));
    }
    assert_eq!(boxes(&drawn("scale:2")), [[16.0, 16.0, 24.0, 24.0]]);
    // An ellipse is fitted.
    let [uneven] = boxes(&drawn("scale:2 1.5"))[..] else { unreachable!("one shape") };
    assert!(uneven.iter().zip([16.0, 12.0, 24.0, 18.0]).all(|(is, should)| (is - should).abs() < 0.01));
    for style in ["rotate:x 45deg", "transform:matrix3d(1)", "transform:translate(calc(1px + 2px))"] {
        let drawing = drawn(style);
        assert_eq!(boxes(&drawing), [around(10.0, 10.0)], "{style}");
        assert!(
            says(&drawing, "1 object has a transform that cannot be read: placed without it."),
            "{style}"
        );
    }
    assert!(says(&drawn("offset-path:path('M0 0h9')"), "1 object has a style with a value"));
}

/// Boxy SVG turns every shape about a point of its own box, which was reported as not readable, and misplaced.
#[test]
fn a_shape_is_turned_about_a_point_of_its_own_box() {
    let turned = |shape: &str, style: &str| {
        let style = format!("fill:none;stroke:red;transform-box:fill-box;{style}");
        page(&shape.replace("/>", &format!(" style=\"{style}\"/>")))
    };
    let rect = "<rect x=\"40\" y=\"20\" width=\"20\" height=\"10\"/>";
    for (shape, style, expected) in [
        (rect, "transform-origin:50% 50%;transform:rotate(90deg)", [45.0, 15.0, 55.0, 35.0]),
        (rect, "transform-origin:center;rotate:90deg", [45.0, 15.0, 55.0, 35.0]),
        (rect, "transform-origin:right bottom;transform:scale(0.5)", [50.0, 25.0, 60.0, 30.0]),
        // Without an origin, it is the corner of the box.
        (rect, "transform:rotate(90deg)", [30.0, 20.0, 40.0, 40.0]),
        (rect, "transform:translate(100%,-50%)", [60.0, 15.0, 80.0, 25.0]),
        (
            "<path d=\"M40 20h20v10h-20z\"/>",
            "transform-origin:50% 50%;rotate:90deg",
            [45.0, 15.0, 55.0, 35.0],
        ),
        ("<circle cx=\"50\" cy=\"25\" r=\"5\"/>", "transform:scale(0.5)", [45.0, 20.0, 50.0, 25.0]),
    ] {
        let drawing = turned(shape, style);
        assert_eq!(boxes(&drawing), [expected], "{shape} {style}");
        assert!(drawing.findings.is_empty(), "{style}: {:?}", messages(&drawing));
    }
    // Groups have no box here, and no shape has one with its stroke.
    let group =
        format!("<g style=\"transform-box:fill-box;transform:rotate(90deg)\">{}</g>", circle(9.0, 9.0, ""));
    let stroke = circle(9.0, 9.0, "style=\"transform-box:stroke-box;transform:rotate(90deg)\"");
    for body in [group, stroke] {
        assert!(says(&page(&body), "transform-origin"), "{body}");
    }
}

/// The place of a `symbol` was ignored.
#[test]
fn a_symbol_has_a_place() {
    let symbol = format!(
        "<symbol id=\"s\" x=\"30\" y=\"20\" width=\"20\" height=\"20\" viewBox=\"0 0 20 20\">{}</symbol><use href=\"#s\"/>",
        circle(10.0, 10.0, "")
    );
    assert_eq!(boxes(&page(&symbol)), [around(40.0, 30.0)]);
}

/// What the page itself asks for was not looked at.
#[test]
fn clips_markers_and_transforms_of_the_page_are_findings() {
    let root = |more: &str| {
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\" {more}>{}</svg>",
            circle(10.0, 10.0, "")
        );
        svg::read(text.as_bytes(), &ReadOptions::default()).unwrap()
    };
    for (more, said) in [
        ("clip-path=\"url(#c)\"", "1 object is clipped"),
        ("mask=\"url(#c)\"", "1 object has a mask"),
        ("marker-end=\"url(#c)\"", "1 object has arrowheads"),
        ("transform=\"scale(1,-1)\"", "The page itself has a transform"),
        ("style=\"rotate:90deg\"", "The page itself has a transform"),
    ] {
        assert!(says(&root(more), said), "{more}: {:?}", messages(&root(more)));
    }
    assert!(root("").findings.is_empty());
}

/// Nested rules, sheets of other files and sheets for printers were lost or applied without a word.
#[test]
fn style_sheets_that_are_not_read_are_findings() {
    let nested = page(
        "<style>.a{stroke:red;fill:none;.b{display:none}}</style><g class=\"a\"><path d=\"M1 1h9v9z\"/></g>",
    );
    assert_eq!(layers(&nested), ["#ff0000"]);
    assert!(says(&nested, "1 rule"), "{:?}", messages(&nested));
    let printed =
        page(&format!("<style media=\"print\">circle{{display:none}}</style>{}", circle(9.0, 9.0, "")));
    assert_eq!(boxes(&printed), [around(9.0, 9.0)]);
    assert!(says(&printed, "1 style sheet is not read"), "{:?}", messages(&printed));
    for more in ["", "media=\"\"", "media=\"print, Screen\"", "type=\"text/CSS\" media=\"all\""] {
        let hides = format!(
            "<style {more}>circle{{display:none}}</style><path d=\"M1 1h9v9z\"/>{}",
            circle(9.0, 9.0, "")
        );
        assert_eq!(boxes(&page(&hides)), [[1.0, 1.0, 10.0, 10.0]], "{more}");
    }
    let text = format!(
        "<?xml-stylesheet type=\"text/css\" href=\"cut.css\"?><svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9mm\" viewBox=\"0 0 9 9\">{}</svg>",
        circle(4.0, 4.0, "")
    );
    let other = svg::read(text.as_bytes(), &ReadOptions::default()).unwrap();
    assert!(says(&other, "1 style sheet is not read"), "{:?}", messages(&other));
}

/// A gradient that is not in the file paints nothing; a stroke without width is cut, which is said.
#[test]
fn lines_that_no_screen_shows() {
    let drawn = |stroke: &str| {
        page(&format!("<path d=\"M1 1h9\" fill=\"none\" {stroke}/>{}", circle(30.0, 10.0, "")))
    };
    assert_eq!(drawn("stroke=\"url(#gone)\"").shapes.len(), 1);
    assert!(says(&drawn("stroke=\"url(#gone)\""), "1 shape is without stroke and fill"));
    assert_eq!(layers(&drawn("stroke=\"url(#gone) blue\"")), ["#0000ff", "#ff0000"]);
    assert_eq!(drawn("stroke=\"url(other.svg#there)\"").shapes.len(), 2);
    let thin = drawn("stroke=\"blue\" stroke-width=\"0\"");
    assert_eq!(thin.shapes.len(), 2);
    assert_eq!(
        found(&thin, Code::OutlineTaken).message,
        "1 shape has a stroke of width 0, which no screen shows: cut all the same."
    );
}

/// Illustrator writes its name into the root since 2024, and underscores of layers as codes.
#[test]
fn illustrator_of_2024_was_not_recognised() {
    let text = "<svg id=\"Layer_1\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 283.46 283.46\">
        <!-- Generator: Adobe Illustrator 29.1.0, SVG Export Plug-In . SVG Version: 2.1.0 Build 142)  -->
        <defs><style>.st0{fill:none;stroke:#000;}</style></defs>
        <g id=\"Cut_x5F_outer\"><rect class=\"st0\" width=\"283.46\" height=\"283.46\"/></g>
        <g id=\"_x31_mm_x20_mark_x\"><rect class=\"st0\" x=\"10\" y=\"10\" width=\"20\" height=\"20\"/></g></svg>";
    let drawing = svg::read(text.as_bytes(), &ReadOptions::default()).unwrap();
    assert_eq!(layers(&drawing), ["Cut_outer", "1mm mark_x"]);
    let width = drawing.shapes[0].path.bounds().size().x;
    assert!((width - 100.0).abs() < 0.01, "{width}");
}
