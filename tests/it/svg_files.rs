//! SVG files: scale, layers, findings with their places, and what is refused.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::drawings::{close, found, length};
use kerfway::drawing::{Drawing, Limits, ReadError, ReadOptions, Unit, UnitsSource};
use kerfway::finding::{Code, Severity};
use kerfway::geometry::{DVec2, Segment};
use kerfway::job::{Job, LoadOptions};
use kerfway::svg;

fn read(text: &str) -> Drawing {
    svg::read(text.as_bytes(), &ReadOptions::default()).unwrap()
}

fn refused(text: &str) -> String {
    svg::read(text.as_bytes(), &ReadOptions::default()).unwrap_err().to_string()
}

/// A page of 100 by 50 mm whose user unit is a millimetre.
pub(crate) fn page(body: &str) -> Drawing {
    read(&format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\">{body}</svg>"
    ))
}

pub(crate) fn layers(drawing: &Drawing) -> Vec<&str> {
    drawing.layers.iter().map(|l| l.name.as_str()).collect()
}

/// Width in mm of a line of 100 user units in a file with this root element, and where its unit comes from.
fn scale(root: &str, before: &str) -> (f64, Unit, UnitsSource, bool) {
    let drawing = read(&format!(
        "{before}<svg xmlns=\"http://www.w3.org/2000/svg\" {root}><path d=\"M0 0h100\" stroke=\"red\"/></svg>"
    ));
    let units = &drawing.units;
    ((length(&drawing) * 1e6).round() / 1e6, units.unit, units.source, units.doubtful)
}

#[test]
fn the_size_of_the_page_decides_the_scale() {
    use UnitsSource::{Guessed, Header};
    let mm = |root: &str| scale(root, "");
    assert_eq!(
        mm("width=\"200mm\" height=\"100mm\" viewBox=\"0 0 100 50\""),
        (200.0, Unit::Mm, Header, false)
    );
    assert_eq!(mm("width=\"10cm\" viewBox=\"0 0 100 50\""), (100.0, Unit::Cm, Header, false));
    assert_eq!(mm("height=\"2in\" viewBox=\"0 0 200 100\""), (50.8, Unit::In, Header, false));
    assert_eq!(mm("width=\"72pt\" height=\"72pt\" viewBox=\"0 0 100 100\""), (25.4, Unit::In, Header, false));
    // Pixels, or nothing.
    assert_eq!(mm("width=\"96\" height=\"96\""), (26.458333, Unit::Px, Guessed, true));
    assert_eq!(mm("viewBox=\"0 0 100 100\""), (26.458333, Unit::Px, Guessed, true));
    assert_eq!(
        mm("width=\"200px\" height=\"200px\" viewBox=\"0 0 100 100\""),
        (52.916667, Unit::Px, Guessed, true)
    );
    assert_eq!(
        mm("width=\"100%\" height=\"100%\" viewBox=\"0 0 100 100\""),
        (26.458333, Unit::Px, Guessed, true)
    );
    // A size without a viewBox: what is drawn is in pixels.
    assert_eq!(mm("width=\"210mm\" height=\"297mm\""), (26.458333, Unit::Px, Guessed, true));
}

#[test]
fn the_program_decides_what_a_pixel_is() {
    let inkscape = "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"90\" height=\"90\" inkscape:version=";
    let (old, unit, source, doubtful) = scale(&format!("{inkscape}\"0.48.5 r10040\""), "");
    assert_eq!((old, unit, source, doubtful), (28.222222, Unit::Px, UnitsSource::Guessed, false));
    close(scale(&format!("{inkscape}\"1.3.2\""), "").0, 26.458333);
    let illustrator =
        "<?xml version=\"1.0\"?><!-- Generator: Adobe Illustrator 27.0.0, SVG Export Plug-In -->";
    assert_eq!(
        scale("viewBox=\"0 0 100 100\"", illustrator),
        (35.277778, Unit::Px, UnitsSource::Guessed, false)
    );
}

#[test]
fn a_guess_is_a_finding_and_a_choice_is_not() {
    let text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\"><path d=\"M0 0h100\" stroke=\"red\"/></svg>";
    let guessed = found(&read(text), Code::UnitsGuessed).clone();
    assert_eq!(guessed.severity, Severity::Warning);
    assert!(
        guessed.message.contains("96 to the inch") && guessed.message.ends_with("Check the units."),
        "{}",
        guessed.message
    );
    for (options, expected) in [
        (ReadOptions { dpi: Some(72.0), ..ReadOptions::default() }, 100.0 * 25.4 / 72.0),
        (ReadOptions { unit: Some(Unit::Mm), ..ReadOptions::default() }, 100.0),
        (ReadOptions { unit: Some(Unit::Px), ..ReadOptions::default() }, 100.0 * 25.4 / 96.0),
    ] {
        let drawing = svg::read(text.as_bytes(), &options).unwrap();
        close(length(&drawing), expected);
        assert_eq!((drawing.units.source, drawing.units.doubtful), (UnitsSource::Given, false));
        assert!(drawing.findings.iter().all(|f| f.code != Code::UnitsGuessed));
    }
}

#[test]
fn the_page_stands_upright_with_its_lower_edge_at_zero() {
    let drawing = page("<path d=\"M10 10 H30 V40\" stroke=\"red\"/>");
    let path = &drawing.shapes[0].path;
    assert_eq!((path.start(), path.end()), (Some(DVec2::new(10.0, 40.0)), Some(DVec2::new(30.0, 10.0))));
    // Without a page, the lower edge of the drawing is at zero.
    let bare = read("<svg><path d=\"M0 -50 V50\" stroke=\"red\"/></svg>");
    let bounds = bare.shapes[0].path.bounds();
    assert!(bounds.min.y.abs() < 1e-12 && (bounds.max.y - 26.458333).abs() < 1e-5, "{bounds:?}");
}

#[test]
fn circles_and_arcs_stay_exact_under_similar_maps() {
    let drawing = page(
        "<g transform=\"translate(20,20) rotate(30) scale(-2,2)\"><circle r=\"5\" stroke=\"red\" fill=\"none\"/>\
         <path d=\"M0 0 a3 3 0 0 1 6 0 a3 3 0 0 1 -6 0z\" stroke=\"red\"/><rect width=\"8\" height=\"6\" rx=\"2\" stroke=\"red\"/></g>",
    );
    let arcs = |k: usize| -> Vec<f64> {
        let arc =
            |s: &Segment| if let Segment::Arc(a) = s { Some((a.radius() * 1e9).round() / 1e9) } else { None };
        drawing.shapes[k].path.segments.iter().filter_map(arc).collect()
    };
    assert_eq!((arcs(0), arcs(1), arcs(2)), (vec![10.0], vec![6.0; 2], vec![4.0; 4]));
    assert!(drawing.shapes.iter().all(|s| s.path.closed && s.path.largest_gap() <= 0.0));
}

#[test]
fn colours_and_inkscape_layers_become_layers() {
    let colours = page(
        "<style>.a{stroke:blue}</style><g stroke=\"#F00\" fill=\"none\"><path d=\"M0 0h1\"/><path class=\"a\" d=\"M0 1h1\"/>\
         <path style=\"stroke:rgb(255,0,0)\" d=\"M0 2h1\"/></g><rect width=\"5\" height=\"5\"/>",
    );
    assert_eq!(layers(&colours), ["#ff0000", "#0000ff", "fill #000000"]);
    assert_eq!(colours.shapes.iter().map(|s| s.layer).collect::<Vec<_>>(), [0, 1, 0, 2]);
    assert_eq!(found(&colours, Code::OutlineTaken).layer.as_deref(), Some("fill #000000"));

    let layer = |label: &str, body: &str| {
        format!(
            "<g xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" inkscape:groupmode=\"layer\" inkscape:label=\"{label}\">{body}</g>"
        )
    };
    let (red, blue) = ("<path stroke=\"red\" d=\"M0 0h1\"/>", "<path stroke=\"blue\" d=\"M0 1h1\"/>");
    // One layer is what Inkscape makes for every drawing: its name counts only where it says more than the colour.
    assert_eq!(layers(&page(&layer("Layer 1", &[red, blue].concat()))), ["#ff0000", "#0000ff"]);
    assert_eq!(layers(&page(&layer("Cut", red))), ["Cut"]);
    let two = [layer("Cut", red), layer("Mixed", &[red, blue].concat())].concat();
    assert_eq!(layers(&page(&two)), ["Cut", "Mixed #ff0000", "Mixed #0000ff"]);
}

#[test]
fn what_is_not_cut_is_a_finding_with_its_place() {
    let drawing = page(
        "<defs><clipPath id=\"c\"><rect width=\"9\" height=\"9\"/></clipPath><pattern id=\"p\"><path d=\"M0 0h1\"/></pattern></defs>\
         <text x=\"10\" y=\"20\">A</text><image x=\"5\" y=\"5\" width=\"9\" height=\"9\"/>\
         <path id=\"clipped\" clip-path=\"url(#c)\" d=\"M1 2h3\" stroke=\"red\"/><path d=\"M4 4h9\" stroke=\"red\" fill=\"url(#p)\"/>\
         <path d=\"M0 0h1\" mask=\"url(#m)\" marker-end=\"url(#x)\" stroke=\"red\" stroke-dasharray=\"2 1\"/>\
         <path id=\"gone\" d=\"M7 8h1\" display=\"none\" stroke=\"red\"/><g visibility=\"hidden\"><path d=\"M0 0h1\" stroke=\"red\"/></g>\
         <path d=\"M0 0h1\" fill=\"none\"/><use href=\"#none\" x=\"3\"/><path id=\"bad\" d=\"M0 0h5 L7\" stroke=\"red\"/>",
    );
    let find = |words: &str| {
        let found = drawing.findings.iter().find(|f| f.message.contains(words));
        found.unwrap_or_else(|| panic!("{words}: {:#?}", drawing.findings)).clone()
    };
    let at = |words: &str| find(words).at.map(|p| p.to_array());
    assert_eq!(at("1 text left out"), Some([10.0, 30.0]));
    assert_eq!(at("1 image left out"), Some([5.0, 45.0]));
    assert_eq!(at("1 object is clipped"), Some([1.0, 48.0]));
    assert_eq!(at("filled with a pattern"), Some([4.0, 46.0]));
    assert_eq!(at("a mask"), Some([0.0, 50.0]));
    assert_eq!(at("arrowheads"), Some([0.0, 50.0]));
    assert_eq!(at("dashed"), Some([0.0, 50.0]));
    assert_eq!(
        (at("not displayed"), find("not displayed").handle.as_deref()),
        (Some([7.0, 42.0]), Some("gone"))
    );
    assert_eq!(find("switched invisible").count, 1);
    assert_eq!(find("without stroke and fill").count, 1);
    assert_eq!((find("1 copy of").code, at("1 copy of")), (Code::MissingBlock, Some([3.0, 50.0])));
    assert_eq!(
        (find("path data is damaged").handle.as_deref(), find("path data is damaged").at.is_some()),
        (Some("bad"), true)
    );
    // The damaged path is drawn up to the fault.
    close(drawing.shapes.last().unwrap().path.length(), 5.0);
    let kinds: Vec<(&str, u32, bool)> =
        drawing.entities.iter().map(|e| (e.kind.as_str(), e.count, e.supported)).collect();
    assert_eq!(kinds, [("path", 7, true), ("image", 1, false), ("text", 1, false), ("use", 1, true)]);
}

#[test]
fn copies_and_cycles() {
    let drawing = page(
        "<defs><g id=\"a\"><circle r=\"1\" stroke=\"red\" fill=\"none\"/><use href=\"#b\"/></g><g id=\"b\"><use href=\"#a\"/></g></defs>\
         <use href=\"#a\" x=\"5\" y=\"5\"/><use href=\"#a\" x=\"15\" y=\"5\"/><g id=\"self\"><use href=\"#self\"/></g>",
    );
    assert_eq!(drawing.shapes.len(), 2);
    let cycles =
        drawing.findings.iter().filter(|f| f.code == Code::CyclicBlock).map(|f| f.count).sum::<u32>();
    assert_eq!(cycles, 3, "{:#?}", drawing.findings);
}

#[test]
fn bombs_are_refused_in_one_sentence() {
    let laughs =
        "<!DOCTYPE svg [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;\">]><svg><path d=\"&b;\"/></svg>";
    let long = format!("<!DOCTYPE svg [<!ENTITY a \"{}\">]><svg><path d=\"&a;\"/></svg>", "x".repeat(5000));
    let often = format!(
        "<!DOCTYPE svg [<!ENTITY a \"{}\">]><svg>{}</svg>",
        "x".repeat(4000),
        "<path d=\"&a;&a;&a;&a;&a;\"/>".repeat(2000)
    );
    let deep = format!("<svg>{}{}</svg>", "<g>".repeat(300), "</g>".repeat(300));
    let mut copies = "<svg><g id=\"a0\"><path d=\"M0 0h1\" stroke=\"red\"/></g>".to_owned();
    for i in 1..12 {
        let inner = format!("<use href=\"#a{}\"/>", i - 1);
        copies.push_str(&format!("<g id=\"a{i}\">{}</g>", inner.repeat(10)));
    }
    copies.push_str("</svg>");
    for (text, words) in [
        (laughs, "The entity \"b\""),
        (&long, "The entity \"a\""),
        (&often, "The entities of the SVG"),
        (&deep, "nested more than 256 deep at line 1"),
        (&copies, "with all copies (use) expanded"),
    ] {
        let sentence = refused(text);
        assert!(sentence.contains(words), "{sentence}");
        assert!(svg::is_svg(text.as_bytes()));
    }
    let limits = Limits { elements: 10, ..ReadOptions::default().limits };
    let many = format!("<svg>{}</svg>", "<path/>".repeat(20));
    let error = svg::read(many.as_bytes(), &ReadOptions { limits, ..ReadOptions::default() }).unwrap_err();
    assert!(matches!(error, ReadError::Limit(_)), "{error}");
}

/// All would take minutes: quadratic in the size of the file, or a long text read again for each copy.
#[test]
fn hostile_copies_and_rules_that_take_too_long_are_refused() {
    let many = |text: &str| text.repeat(2_000);
    let chain: String = (0..6_000).map(|k| format!("<use id='u{k}' href='#u{}'/>", k + 1)).collect();
    let (deep, end) = ("<g>".repeat(200), "</g>".repeat(200));
    let style = |rule: &str| format!("<style>{}</style>", many(rule));
    let limits = Limits { bytes: 1 << 18, ..ReadOptions::default().limits };
    for (what, body) in [
        ("a chain of copies", chain),
        (
            "rules for ancestors",
            format!("{}{deep}{}{end}", style(".b .a{fill:red}"), many("<path class='a'/>")),
        ),
        ("rules for classes", format!("{}<path class='{}'/>", style(".a.b.d{fill:red}"), many("a b c "))),
        (
            "one text of many selectors",
            format!("<style>{} {{{}}}</style><path/>", vec!["path"; 2_000].join(","), many("fill:red;")),
        ),
        (
            "copies of a long style",
            format!("<g id='a' style='{}'/>{}", many("fill:red;"), many("<use href='#a'/>")),
        ),
        (
            "copies of a long choice",
            format!(
                "<switch id='a'>{}</switch>{}",
                many("<g systemLanguage='xx'/>"),
                many("<use href='#a'/>")
            ),
        ),
    ] {
        let text =
            format!("<svg xmlns='http://www.w3.org/2000/svg'>{body}<rect width='9' height='9'/></svg>");
        let error =
            svg::read(text.as_bytes(), &ReadOptions { limits, ..ReadOptions::default() }).unwrap_err();
        assert!(error.to_string().contains("take too long to work out"), "{what}: {error}");
    }
}

#[test]
fn what_cannot_be_read_is_said_in_one_sentence() {
    for (text, words) in [
        ("<svg><g></svg>", "damaged at line 1"),
        ("<svg>\n\n<path d=></svg>", "damaged at line 3"),
        ("<svg><path d='M0 0h1' stroke='red'/>", "ends in the middle"),
        ("<svg/>", "holds nothing to cut"),
        ("<svg><text>a</text></svg>", "1 without an outline"),
        ("<svg><path d='M0 0h1e12' stroke='red'/></svg>", "more than 1000 m from its origin"),
    ] {
        let sentence = refused(text);
        assert!(sentence.contains(words) && sentence.ends_with('.'), "{sentence}");
    }
}

#[test]
fn illustrator_files_with_entities_and_switches_are_read() {
    let text = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!-- Generator: Adobe Illustrator 19.0.0 -->\n\
        <!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\" [\n\
        <!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\n<!ENTITY ns_xlink \"http://www.w3.org/1999/xlink\">\n]>\n\
        <svg xmlns=\"&ns_svg;\" xmlns:xlink=\"&ns_xlink;\" viewBox=\"0 0 72 72\"><switch>\
        <foreignObject requiredExtensions=\"http://ns.adobe.com/AdobeIllustrator/10.0/\"/><g>\
        <path stroke=\"red\" d=\"M0 0h72\"/></g></switch></svg>";
    let drawing = read(text);
    close(length(&drawing), 25.4);
    assert_eq!(drawing.findings.iter().map(|f| f.code).collect::<Vec<_>>(), [Code::UnitsGuessed]);
}

#[test]
fn other_encodings_are_read() {
    let text = "<svg xmlns=\"http://www.w3.org/2000/svg\"><path id=\"ä\" d=\"M0 0h1\" stroke=\"red\"/></svg>";
    let utf_16: Vec<u8> = format!("\u{feff}{text}").encode_utf16().flat_map(u16::to_le_bytes).collect();
    let latin: Vec<u8> =
        format!("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>{text}").chars().map(|c| c as u8).collect();
    for bytes in [utf_16, latin] {
        assert!(svg::is_svg(&bytes));
        let drawing = svg::read(&bytes, &ReadOptions::default()).unwrap();
        assert_eq!(drawing.shapes[0].handle.as_deref(), Some("ä"));
    }
}

#[test]
fn a_long_comment_before_the_drawing_does_not_hide_it() {
    let comment = "licence ".repeat(12_000);
    let text = format!(
        "<?xml version=\"1.0\"?><!-- {comment} --><svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9mm\" height=\"9mm\" viewBox=\"0 0 9 9\">\
        <rect width=\"5\" height=\"5\" stroke=\"red\" fill=\"none\"/></svg>"
    );
    let job = Job::load(text.into_bytes(), "a.svg", &LoadOptions::default()).unwrap();
    assert_eq!(job.sheet().contours.len(), 1);
}

#[test]
fn a_job_knows_the_format_by_its_content() {
    let text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"60mm\" height=\"60mm\" viewBox=\"0 0 60 60\">\
        <rect x=\"5\" y=\"5\" width=\"50\" height=\"50\" stroke=\"red\" fill=\"none\"/><circle cx=\"30\" cy=\"30\" r=\"5\" stroke=\"red\" fill=\"none\"/></svg>";
    let job = Job::load(text.into(), "wrong-name.dxf", &LoadOptions::default()).unwrap();
    let report = job.report();
    assert_eq!((report.contours.len(), report.parts.len(), report.contours[1].inside), (2, 1, Some(0)));
    let both = LoadOptions { units: Some(Unit::Mm), dpi: Some(90.0), ..LoadOptions::default() };
    let error = Job::load(text.into(), "a.svg", &both).err().unwrap().to_string();
    assert!(error.contains("Choose one of them"), "{error}");
}

#[test]
fn comments_in_styles_hide_nothing_else() {
    let drawing = page(
        "<style>.cut { stroke: #f00; /* red */ fill: none; } .eng /* blue */, .b /* too */ { fill: none; stroke: #00f; /* is engraved */ }</style>\
         <rect class=\"cut\" width=\"3\" height=\"3\"/><rect class=\"eng\" width=\"4\" height=\"4\"/>\
         <rect class=\"b\" width=\"5\" height=\"5\"/><rect style=\"fill:none;/* cut */stroke:#0f0\" width=\"6\" height=\"6\"/>",
    );
    assert_eq!(layers(&drawing), ["#ff0000", "#0000ff", "#00ff00"]);
    assert_eq!(drawing.shapes.iter().map(|s| s.layer).collect::<Vec<_>>(), [0, 1, 1, 2]);
    assert!(drawing.findings.is_empty(), "{:#?}", drawing.findings);
}

#[test]
fn lengths_in_mm_keep_their_size_when_the_unit_is_chosen() {
    let body = "<rect x=\"10mm\" y=\"10mm\" width=\"30mm\" height=\"30mm\" fill=\"none\" stroke=\"#f00\"/>";
    let text =
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\">{body}</svg>");
    for unit in [None, Some(Unit::Mm), Some(Unit::Cm), Some(Unit::In), Some(Unit::Px)] {
        let options = ReadOptions { unit, ..ReadOptions::default() };
        let bounds = svg::read(text.as_bytes(), &options).unwrap().shapes[0].path.bounds();
        assert!(bounds.min.distance(DVec2::new(10.0, 60.0)) < 1e-9, "{unit:?}: {bounds:?}");
        assert!(bounds.max.distance(DVec2::new(40.0, 90.0)) < 1e-9, "{unit:?}: {bounds:?}");
    }
}

#[test]
fn fills_close_their_subpaths_and_show_nothing_of_lines() {
    let drawing = page(
        "<path d=\"M10 10 H40 V40 H10\"/><line id=\"none\" x1=\"10\" y1=\"10\" x2=\"40\" y2=\"40\"/>\
         <path id=\"half\" d=\"M60 10 h9 M70 10 h9 v9\"/><path d=\"M80 10 h9 v9\" fill=\"none\" stroke=\"red\"/>",
    );
    let shapes: Vec<(bool, f64)> =
        drawing.shapes.iter().map(|s| (s.path.closed, s.path.length().round())).collect();
    assert_eq!(shapes, [(true, 120.0), (true, 31.0), (false, 18.0)]);
    let hidden = found(&drawing, Code::HiddenEntity);
    assert_eq!((hidden.count, hidden.handle.as_deref()), (2, Some("none")));
    assert_eq!(hidden.at, Some(DVec2::new(10.0, 40.0)));
}

#[test]
fn points_that_cannot_be_read_are_a_finding() {
    for (points, length_left) in
        [("10,10 40,10 NaN,NaN 40,40", 30.0), ("10,10 40,10 40,40; 10,40", 60.0), ("10,10 40,10, ", 30.0)]
    {
        let drawing = page(&format!("<polyline points=\"{points}\" fill=\"none\" stroke=\"red\"/>"));
        close(length(&drawing), length_left);
        let faults = drawing.findings.iter().filter(|f| f.code == Code::InvalidGeometry).count();
        assert_eq!(faults, usize::from(!points.ends_with(", ")), "{points}");
    }
}

#[test]
fn transforms_are_about_their_origin() {
    let rect = |more: &str| {
        let body = format!(
            "<rect x=\"40\" y=\"20\" width=\"20\" height=\"10\" fill=\"none\" stroke=\"red\" {more}/>"
        );
        page(&body)
    };
    for more in [
        "transform=\"rotate(90)\" transform-origin=\"50 25\"",
        "style=\"transform:rotate(90deg);transform-origin:50px 25px\"",
        "style=\"transform:rotate(90deg);transform-origin:center\"",
        "style=\"transform:rotate(90deg);transform-origin:center 50% 0\"",
        "transform=\"rotate(90 50 25)\"",
        "style=\"transform:rotate(90deg);transform-box:fill-box;transform-origin:center\"",
    ] {
        let drawing = rect(more);
        let bounds = drawing.shapes[0].path.bounds();
        assert!(bounds.min.distance(DVec2::new(45.0, 15.0)) < 1e-9, "{more}: {bounds:?}");
        assert!(drawing.findings.is_empty(), "{:#?}", drawing.findings);
    }
    let top_right = rect("style=\"transform:scale(0.5);transform-origin:top right\"");
    assert!(top_right.shapes[0].path.bounds().max.distance(DVec2::new(80.0, 40.0)) < 1e-9);
    let nowhere = rect("transform=\"scale(2)\" transform-origin=\"here\"");
    assert!(found(&nowhere, Code::InvalidGeometry).message.contains("transform-origin"));
    assert!(rect("transform-origin=\"here\"").findings.is_empty());
}

/// `display: inline` after `opacity: 0` showed the shape again, and an opacity of 0 in the attribute held against the
/// style, which is stronger.
#[test]
fn what_is_transparent_is_not_shown_by_its_display() {
    for (style, drawn) in [
        ("style=\"opacity:0;display:inline\"", false),
        ("style=\"display:None;opacity:1\"", false),
        ("opacity=\"0\" style=\"opacity:1\"", true),
        ("display=\"none\" style=\"display:inline\"", true),
    ] {
        let drawing =
            page(&format!("<path d=\"M0 0h1\" stroke=\"red\"/><path d=\"M0 9h5\" stroke=\"red\" {style}/>"));
        assert_eq!(drawing.shapes.len(), 1 + usize::from(drawn), "{style}");
        let hidden = drawing.findings.iter().any(|f| f.code == Code::HiddenEntity);
        assert_eq!(hidden, !drawn, "{style}");
    }
}

/// Lines in a colour profile of Inkscape, and in colours whose function is written in capital letters, were left out as
/// invisible.
#[test]
fn no_line_is_lost_by_the_way_its_colour_is_written() {
    for (style, layer) in [
        ("style=\"fill:none;stroke:#ff0000 icc-color(sRGB, 1, 0, 0)\"", "#ff0000"),
        ("fill=\"none\" stroke=\"RGB(255, 0, 0)\"", "#ff0000"),
        ("fill=\"NONE\" stroke=\"currentColor\" color=\"blue\"", "#0000ff"),
        ("style=\"stroke:currentcolor;color:blue;fill:none\"", "#0000ff"),
    ] {
        let drawing =
            page(&format!("<g color=\"lime\" stroke=\"lime\"><rect width=\"9\" height=\"9\" {style}/></g>"));
        assert_eq!(layers(&drawing), [layer], "{style}");
    }
    // The colour of a shape, not of the group in which the stroke is said.
    let inherited = page("<g stroke=\"currentColor\"><path d=\"M0 0h9\" color=\"red\"/></g>");
    assert_eq!(layers(&inherited), ["#ff0000"]);
}

/// A basic shape as a clip path was no finding.
#[test]
fn a_clip_path_without_a_reference_is_a_finding() {
    let drawing = page("<rect width=\"20\" height=\"20\" stroke=\"red\" style=\"clip-path:circle(5px)\"/>");
    assert!(drawing.findings.iter().any(|f| f.message.starts_with("1 object is clipped")));
    let drawing = page("<rect width=\"20\" height=\"20\" stroke=\"red\" clip-path=\"none\"/>");
    assert!(drawing.findings.iter().all(|f| f.code != Code::UnsupportedEntity), "{:?}", drawing.findings);
}
