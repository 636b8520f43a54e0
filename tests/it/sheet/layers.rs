//! Operations, order, suggestions, the border.

use super::sketch::*;
use kerfway::drawing::Drawing;
use kerfway::finding::{Code, Severity};
use kerfway::sheet::{Operation, Sheet, SheetOptions};

fn two_layers() -> Drawing {
    drawing([
        ("Cut", rect(0.0, 0.0, 50.0, 50.0)),
        ("Gravur", line(10.0, 10.0, 40.0, 10.0)),
        ("Cut", circle(25.0, 30.0, 5.0)),
        ("Hilfslinien", line(-10.0, 25.0, 60.0, 25.0)),
    ])
}

fn with(drawing: &Drawing, layers: &[(&str, Operation)], order_by_layer: bool) -> Sheet {
    let layers = layers.iter().map(|(n, o)| ((*n).to_owned(), Some(*o))).collect();
    built(drawing, &SheetOptions { layers, order_by_layer, ..SheetOptions::default() })
}

#[test]
fn everything_is_cut_until_the_person_says_otherwise() {
    let s = with(&two_layers(), &[], false);
    assert!(s.contours.iter().all(|c| c.operation == Operation::Cut));
    assert_eq!(
        s.layers.iter().map(|l| l.suggestion).collect::<Vec<_>>(),
        [None, Some(Operation::Mark), None]
    );
    let told = findings(&s, Code::LayerSuggestion);
    assert_eq!((told.len(), told[0].layer.as_deref(), told[0].count), (1, Some("Gravur"), 1));
    assert_eq!(s.layers.iter().map(|l| l.rank).collect::<Vec<_>>(), [1, 1, 1]);
    assert_eq!(s.layers.iter().map(|l| l.contours).collect::<Vec<_>>(), [2, 1, 1]);
}

#[test]
fn operations_are_given_by_name_whatever_the_case() {
    let s = with(&two_layers(), &[("GRAVUR", Operation::Mark), ("hilfslinien", Operation::Ignore)], false);
    assert_eq!(
        s.layers.iter().map(|l| l.operation).collect::<Vec<_>>(),
        [Operation::Cut, Operation::Mark, Operation::Ignore]
    );
    assert_eq!(s.layers.iter().map(|l| l.suggestion).collect::<Vec<_>>(), [None, None, None]);
    assert_eq!(
        s.contours.iter().map(|c| c.operation).collect::<Vec<_>>(),
        [Operation::Cut, Operation::Mark, Operation::Cut]
    );
    assert_eq!(s.contours.iter().map(|c| c.inside).collect::<Vec<_>>(), [None, Some(0), Some(0)]);
    assert_eq!(s.parts[0].holes, [1, 2], "what is marked on a part belongs to it");
    assert_eq!((s.ignored.len(), s.ignored[0].layer), (1, 2));
    assert_eq!(s.layers.iter().map(|l| l.rank).collect::<Vec<_>>(), [1, 0, 0], "marks come first");
    let told = findings(&s, Code::LayerIgnored);
    assert_eq!((told.len(), told[0].layer.as_deref(), told[0].count), (1, Some("Hilfslinien"), 1));
    assert!(findings(&s, Code::OpenContour).is_empty(), "a mark may be open");
    assert_eq!(s.bounds.max, p(50.0, 50.0), "what is left out does not count");
}

#[test]
fn order_by_layer_is_the_given_order_then_that_of_the_file() {
    let s = with(&two_layers(), &[("Hilfslinien", Operation::Cut), ("Gravur", Operation::Mark)], true);
    assert_eq!(s.layers.iter().map(|l| l.rank).collect::<Vec<_>>(), [2, 1, 0]);
}

#[test]
fn the_last_choice_for_a_layer_counts() {
    let s = with(&two_layers(), &[("cut", Operation::Ignore), ("CUT", Operation::Mark)], false);
    assert_eq!(s.layers[0].operation, Operation::Mark);
}

#[test]
fn an_unknown_layer_is_reported() {
    let s = with(&two_layers(), &[("Engrave", Operation::Mark)], false);
    let told = findings(&s, Code::LayerUnknown);
    assert_eq!(
        (told.len(), told[0].layer.as_deref(), told[0].severity),
        (1, Some("Engrave"), Severity::Warning)
    );
}

#[test]
fn defpoints_are_skipped_by_default() {
    let d = drawing([("0", rect(0.0, 0.0, 9.0, 9.0)), ("DEFPOINTS", line(0.0, 0.0, 5.0, 5.0))]);
    let s = with(&d, &[], false);
    assert_eq!((s.contours.len(), s.ignored.len()), (1, 1));
    assert_eq!(findings(&s, Code::LayerIgnored)[0].layer.as_deref(), Some("DEFPOINTS"));
    assert_eq!(with(&d, &[("Defpoints", Operation::Cut)], false).contours.len(), 2);
}

#[test]
fn marks_and_cuts_neither_join_nor_replace_each_other() {
    let d = drawing([
        ("A", rect(0.0, 0.0, 20.0, 10.0)),
        ("B", rect(0.0, 0.0, 20.0, 10.0)),
        ("A", line(50.0, 0.0, 60.0, 0.0)),
        ("B", line(60.0, 0.0, 70.0, 0.0)),
    ]);
    let s = with(&d, &[("B", Operation::Mark)], false);
    assert_eq!(s.contours.len(), 4);
    assert!(findings(&s, Code::DuplicateRemoved).is_empty());
    assert_eq!(s.contours[1].inside, None, "a mark as large as its contour is not inside it");
}

fn sheet_of_parts(border: &'static str, parts: &'static str) -> Drawing {
    drawing([
        (border, rect(0.0, 0.0, 300.0, 200.0)),
        (parts, rect(10.0, 10.0, 100.0, 100.0)),
        (parts, circle(60.0, 60.0, 20.0)),
        (parts, rect(150.0, 10.0, 100.0, 100.0)),
        (parts, circle(200.0, 60.0, 20.0)),
    ])
}

#[test]
fn a_lone_border_is_recognised_by_the_parts_in_it() {
    let keep = SheetOptions { keep_border: true, ..SheetOptions::default() };
    let s = built(&sheet_of_parts("0", "0"), &keep);
    assert_eq!(s.outline, Some(0));
    let told = findings(&s, Code::SheetOutline);
    assert_eq!((told.len(), told[0].handle.as_deref()), (1, Some("100")));
    assert_eq!(told[0].severity, Severity::Info, "the person has decided");
    assert_eq!(s.parts.len(), 3);
    let s = arranged(&sheet_of_parts("0", "0"));
    let told = findings(&s, Code::SheetOutline);
    assert_eq!((told.len(), told[0].severity, told[0].at), (1, Severity::Info, Some(p(0.0, 0.0))));
    assert!(told[0].message.contains("2 parts lie inside it, and sheets of 300 x 200 mm are sold"));
    assert_eq!((s.outline, s.ignored.len(), s.contours.len(), s.parts.len()), (None, 1, 5, 2));
    assert_eq!(s.contours.iter().map(|c| c.depth).collect::<Vec<_>>(), [0, 0, 1, 0, 1]);
    close(s.bounds.size().x, 240.0);
}

#[test]
fn a_plate_with_holes_is_no_sheet() {
    let s = sheet([
        rect(0.0, 0.0, 300.0, 200.0),
        circle(50.0, 50.0, 9.0),
        circle(250.0, 50.0, 9.0),
        rect(100.0, 100.0, 50.0, 50.0),
    ]);
    assert_eq!((s.outline, findings(&s, Code::SheetOutline).len()), (None, 0));
    let round = sheet([circle(0.0, 0.0, 300.0), circle(50.0, 50.0, 90.0), circle(50.0, 50.0, 9.0)]);
    assert_eq!(round.outline, None, "a disc is no sheet");
}

#[test]
fn a_border_on_a_layer_with_that_name_needs_no_parts_with_holes() {
    let plates = |layer: &'static str| {
        drawing([
            (layer, rect(0.0, 0.0, 300.0, 200.0)),
            ("0", rect(10.0, 10.0, 50.0, 50.0)),
            ("0", circle(200.0, 50.0, 30.0)),
        ])
    };
    let framed = arranged(&plates("Rahmen"));
    assert_eq!((framed.outline, framed.ignored.len(), framed.parts.len()), (None, 1, 2));
    assert!(findings(&framed, Code::LayerSuggestion).is_empty(), "one finding about the border is enough");
    let plate = arranged(&plates("0"));
    assert_eq!(
        (plate.outline, plate.ignored.len(), findings(&plate, Code::SheetOutline).len()),
        (None, 0, 0)
    );
}

#[test]
fn a_frame_that_may_be_a_part_is_asked_about_and_cut_until_then() {
    // A picture frame with a part in its opening, of no size in which sheets are sold.
    let frame = |layer: &'static str| {
        drawing([
            (layer, rect(0.0, 0.0, 310.0, 215.0)),
            ("0", rect(20.0, 20.0, 270.0, 175.0)),
            ("0", circle(100.0, 100.0, 20.0)),
        ])
    };
    let s = arranged(&frame("0"));
    let told = findings(&s, Code::SheetOutline);
    assert_eq!((s.outline, told.len(), told[0].severity), (Some(0), 1, Severity::Warning));
    assert_eq!(s.parts.len(), 2);
    let ignored = built(&frame("0"), &SheetOptions { ignore_outline: true, ..SheetOptions::default() });
    assert_eq!((ignored.outline, ignored.parts.len()), (None, 1));
    for layer in ["part_boundary", "outline", "CUT"] {
        let s = arranged(&frame(layer));
        assert_eq!((s.outline, findings(&s, Code::SheetOutline).len()), (None, 0), "{layer}");
    }
}

#[test]
fn countersunk_holes_are_no_parts_on_a_sheet() {
    let mut paths = vec![rect(0.0, 0.0, 300.0, 200.0)];
    for x in [30.0, 150.0, 270.0] {
        paths.extend([circle(x, 100.0, 8.0), circle(x, 100.0, 4.0)]);
    }
    let s = sheet(paths);
    assert_eq!((s.outline, findings(&s, Code::SheetOutline).len()), (None, 0));
}

#[test]
fn something_outside_the_border_means_it_is_none() {
    let mut d = sheet_of_parts("0", "0");
    d.shapes.push(drawing([("0", circle(500.0, 0.0, 5.0))]).shapes.remove(0));
    assert_eq!(arranged(&d).outline, None);
}

/// Only the spellings without accents were known.
#[test]
fn accented_names_of_layers_suggest_what_the_plain_ones_do() {
    for (name, suggestion) in [
        ("CADRE DÉCOUPE FRAME", None),
        ("découpe-frame", None),
        ("RÉFÉRENCE", Some(Operation::Ignore)),
        ("Dimensión", Some(Operation::Ignore)),
        ("ÉTIQUETTE", None),
    ] {
        let s =
            with(&drawing([("A", rect(0.0, 0.0, 9.0, 9.0)), (name, line(1.0, 1.0, 8.0, 1.0))]), &[], false);
        assert_eq!(s.layers[1].suggestion, suggestion, "{name}");
    }
}
