//! Blocks put in place: transforms, arrays, inheritance of layer and colour, cycles, limits; hidden layers.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::testkit::drawings::{blocks, close, entities, file, found, length, lines, read};
use kerfway::drawing::{Drawing, Limits, ReadError, ReadOptions};
use kerfway::finding::Code;
use kerfway::geometry::{DVec2, Segment};

/// A block with one line from (1, 0) to (3, 0).
const BAR: &str = "0 BLOCK 2 BAR 10 0 20 0 0 LINE 8 0 62 0 10 1 20 0 11 3 21 0 0 ENDBLK";

fn ends(drawing: &Drawing, i: usize) -> (DVec2, DVec2) {
    let path = &drawing.shapes[i].path;
    (path.start().unwrap(), path.end().unwrap())
}

fn near(a: (DVec2, DVec2), b: [f64; 4]) {
    let off = a.0.distance(DVec2::new(b[0], b[1])).max(a.1.distance(DVec2::new(b[2], b[3])));
    assert!(off < 1e-9, "{a:?} is not {b:?}");
}

#[test]
fn insert_scales_then_turns_then_moves() {
    let drawing = blocks(BAR, "0 INSERT 8 0 2 BAR 10 10 20 20 41 2 42 5 50 90");
    near(ends(&drawing, 0), [10.0, 22.0, 10.0, 26.0]);
}

#[test]
fn base_point_of_the_block_comes_to_the_place_of_the_insert() {
    let block = "0 BLOCK 2 B 10 1 20 0 0 LINE 8 0 10 1 20 0 11 3 21 0 0 ENDBLK";
    near(ends(&blocks(block, "0 INSERT 8 0 2 B 10 10 20 20 41 -1"), 0), [10.0, 20.0, 8.0, 20.0]);
}

#[test]
fn names_of_blocks_differ_by_more_than_case_and_blocks_may_follow() {
    let text = lines(&format!(
        "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 ENTITIES 0 INSERT 8 0 2 bar 10 0 20 0 0 ENDSEC 0 SECTION 2 BLOCKS {BAR} 0 ENDSEC 0 EOF"
    ));
    close(length(&read(&text).unwrap()), 2.0);
}

#[test]
fn nested_inserts_multiply() {
    let outer = format!("{BAR} 0 BLOCK 2 OUTER 10 0 20 0 0 INSERT 8 0 2 BAR 10 1 20 1 50 90 0 ENDBLK");
    // In OUTER the bar runs from (1, 2) to (1, 4); then doubled and moved by (10, 0).
    near(ends(&blocks(&outer, "0 INSERT 8 0 2 OUTER 10 10 20 0 41 2 42 2"), 0), [12.0, 4.0, 12.0, 8.0]);
}

#[test]
fn mirrored_insert_turns_arcs_and_bulges_over() {
    let block = "0 BLOCK 2 B 10 0 20 0 0 ARC 8 0 10 0 20 0 40 5 50 0 51 90 0 LWPOLYLINE 8 0 90 2 10 0 20 0 42 1 10 10 20 0 0 ENDBLK";
    let drawing = blocks(block, "0 INSERT 8 0 2 B 10 0 20 0 41 -1");
    near(ends(&drawing, 0), [-5.0, 0.0, 0.0, 5.0]);
    let Segment::Arc(arc) = drawing.shapes[0].path.segments[0] else { panic!("not an arc") };
    assert!(arc.sweep < 0.0);
    close(drawing.shapes[1].path.segments[0].at(0.5).distance(DVec2::new(-5.0, -5.0)), 0.0);
}

#[test]
fn uneven_scale_makes_ellipses_of_circles_arcs_and_bulges() {
    let block = "0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 0 10 0 20 0 40 10 0 LWPOLYLINE 8 0 90 2 70 1 10 -10 20 0 42 1 10 10 20 0 42 1 0 ENDBLK";
    let drawing = blocks(block, "0 INSERT 8 0 2 B 10 0 20 0 41 2 42 1");
    // Half axes 20 and 10: circumference 4 a E(e), area pi a b.
    for shape in &drawing.shapes {
        assert!(shape.path.closed);
        assert!((shape.path.length() - 96.884_482_205_5).abs() < 0.02, "{}", shape.path.length());
        assert!((shape.path.area().abs() - 628.318_530_7).abs() < 0.5, "{}", shape.path.area());
        assert!(shape.path.largest_gap() <= 0.0);
    }
}

#[test]
fn arrays_are_turned_but_their_distances_not_scaled() {
    let drawing = blocks(BAR, "0 INSERT 8 0 2 BAR 10 0 20 0 41 2 42 2 50 90 70 3 71 2 44 10 45 100");
    assert_eq!(drawing.shapes.len(), 6);
    // Last cell: two columns of 10 and one row of 100, turned by 90 degrees.
    near(ends(&drawing, 5), [-100.0, 22.0, -100.0, 26.0]);
}

#[test]
fn insert_below_mirrors_at_the_y_axis() {
    near(ends(&blocks(BAR, "0 INSERT 8 0 2 BAR 10 10 20 5 210 0 220 0 230 -1"), 0), [-11.0, 5.0, -13.0, 5.0]);
}

#[test]
fn array_of_holes_in_a_real_drawing_is_read_whole() {
    // Its insert is flat (z scale 0), at which other readers give up: 14 holes in a row, 6 lines, 3 arcs.
    let bytes = include_bytes!("../fixtures/dxf-dev/skymakerolof_dxf__arrayed-holes.dxf");
    let drawing = kerfway::dxf::read(bytes, &ReadOptions::default()).unwrap();
    let circles: Vec<_> = drawing.shapes.iter().filter(|s| s.kind == "CIRCLE").collect();
    assert_eq!((circles.len(), drawing.shapes.len()), (14, 23));
}

#[test]
fn layer_0_takes_the_layer_of_the_insert_and_by_block_its_colour() {
    let block = "0 BLOCK 2 B 10 0 20 0 0 LINE 8 0 62 0 10 0 20 0 11 1 21 0 0 LINE 8 OWN 10 0 20 0 11 1 21 0 0 LINE 8 0 10 0 20 0 11 1 21 0 0 ENDBLK";
    let text = lines(&format!(
        "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 PLACED 70 0 62 3 0 LAYER 2 OWN 70 0 62 5 0 ENDTAB 0 ENDSEC \
         0 SECTION 2 BLOCKS {block} 0 ENDSEC 0 SECTION 2 ENTITIES 0 INSERT 8 PLACED 62 1 2 B 10 0 20 0 0 ENDSEC 0 EOF"
    ));
    let drawing = read(&text).unwrap();
    let seen: Vec<_> =
        drawing.shapes.iter().map(|s| (drawing.layers[s.layer as usize].name.as_str(), s.color)).collect();
    assert_eq!(seen, [("PLACED", 1), ("OWN", 5), ("PLACED", 3)]);
}

#[test]
fn missing_and_external_blocks_are_named_with_their_place() {
    let drawing = blocks(
        "0 BLOCK 2 XREF 70 4 1 other.dxf 10 0 20 0 0 ENDBLK",
        "0 INSERT 5 C1 8 L 2 GONE 10 4 20 5 0 INSERT 8 L 2 XREF 10 4 20 5 0 LINE 8 0 10 0 20 0 11 1 21 0",
    );
    let missing: Vec<_> = drawing.findings.iter().filter(|f| f.code == Code::MissingBlock).collect();
    assert_eq!(missing.len(), 2);
    assert!(missing[0].message.contains("GONE"), "{}", missing[0].message);
    assert_eq!((missing[0].handle.as_deref(), missing[0].at), (Some("C1"), Some(DVec2::new(4.0, 5.0))));
    assert!(missing[1].message.contains("XREF"), "{}", missing[1].message);
}

#[test]
fn block_within_itself_is_reported_and_the_rest_is_read() {
    let cycle = "0 BLOCK 2 A 10 0 20 0 0 LINE 8 0 10 0 20 0 11 1 21 0 0 INSERT 8 0 2 B 10 0 20 0 0 ENDBLK 0 BLOCK 2 B 10 0 20 0 0 INSERT 8 0 2 A 10 0 20 0 0 ENDBLK";
    let drawing = blocks(cycle, "0 INSERT 8 0 2 A 10 0 20 0");
    assert_eq!(drawing.shapes.len(), 1);
    assert!(found(&drawing, Code::CyclicBlock).message.contains("\"A\""));
}

#[test]
fn billion_laughs_and_giant_arrays_are_refused_by_name() {
    let mut laughs = "0 BLOCK 2 B0 10 0 20 0 0 CIRCLE 8 0 10 0 20 0 40 1 0 ENDBLK".to_owned();
    for i in 1..10 {
        let ten = format!(" 0 INSERT 8 0 2 B{} 10 1 20 0", i - 1).repeat(10);
        laughs += &format!(" 0 BLOCK 2 B{i} 10 0 20 0{ten} 0 ENDBLK");
    }
    let refused = |text: &str| match read(text) {
        Err(ReadError::Limit(sentence)) => sentence,
        other => panic!("{other:?}"),
    };
    assert!(refused(&file(&laughs, "0 INSERT 8 0 2 B9 10 0 20 0")).contains("2000000"));
    let array = refused(&file(BAR, "0 INSERT 8 0 2 BAR 10 0 20 0 70 32767 71 32767 44 1 45 1"));
    assert!(array.contains("\"BAR\", inserted 32767 x 32767 times, makes 1073676289"), "{array}");
}

#[test]
fn nesting_is_limited_and_the_limit_is_settable() {
    let nest = |depth: usize| {
        let mut text = BAR.replace("BAR", "B1");
        for i in 2..=depth {
            text += &format!(" 0 BLOCK 2 B{i} 10 0 20 0 0 INSERT 8 0 2 B{} 10 0 20 0 0 ENDBLK", i - 1);
        }
        file(&text, &format!("0 INSERT 8 0 2 B{depth} 10 0 20 0"))
    };
    assert_eq!(read(&nest(16)).unwrap().shapes.len(), 1);
    let sentence = read(&nest(17)).unwrap_err().to_string();
    assert!(sentence.contains("more than 16 deep"), "{sentence}");
    let limits = Limits { depth: 20, ..ReadOptions::default().limits };
    let options = ReadOptions { limits, ..ReadOptions::default() };
    assert!(kerfway::dxf::read(nest(17).as_bytes(), &options).is_ok());
}

#[test]
fn limits_of_bytes_elements_and_coordinates_are_sentences() {
    let text = file("", "0 LINE 8 0 10 0 20 0 11 1 21 0 0 LINE 8 0 10 0 20 0 11 1 21 9");
    let with = |limits: Limits| {
        kerfway::dxf::read(text.as_bytes(), &ReadOptions { limits, ..ReadOptions::default() })
    };
    let stated = ReadOptions::default().limits;
    assert!(matches!(with(Limits { bytes: 100, ..stated }), Err(ReadError::Limit(_))));
    assert!(matches!(with(Limits { elements: 1, ..stated }), Err(ReadError::Limit(_))));
    let far = with(Limits { coordinate: 0.5, ..stated }).unwrap_err().to_string();
    assert!(far.contains("from its origin"), "{far}");
    // One of two: the other is a finding.
    let drawing = with(Limits { coordinate: 5.0, ..stated }).unwrap();
    assert_eq!(drawing.shapes.len(), 1);
    assert_eq!(found(&drawing, Code::InvalidGeometry).at, Some(DVec2::ZERO));
}

#[test]
fn the_package_refuses_files_by_the_limit_of_the_reader() {
    let package = include_str!("../../www/sdk/size.ts");
    let limits = ReadOptions::default().limits;
    let number = format!("MAX_BYTES = {} * 2 ** 20;", limits.bytes >> 20);
    assert!(package.contains(&number), "www/sdk/size.ts must say {number}");
    assert_eq!(limits.bytes % (1 << 20), 0, "the limit is a whole number of MB");

    let few = ReadOptions { limits: Limits { bytes: 1, ..limits }, ..ReadOptions::default() };
    let sentence = kerfway::dxf::read(b"two", &few).unwrap_err().to_string();
    assert_eq!(
        sentence,
        "The file has 1 MB; up to 0 MB can be read. Delete what is not to be cut, or split the drawing."
    );
    let (_, advice) = sentence.split_once("up to 0").unwrap();
    assert!(package.contains(advice), "www/sdk/size.ts must give the same advice");
}

#[test]
fn paper_invisible_frozen_and_off_are_findings_and_no_shapes() {
    let text = lines(
        "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC \
         0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 ICE 70 1 62 7 0 LAYER 2 DARK 70 0 62 -3 0 ENDTAB 0 ENDSEC \
         0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 0 LINE 8 0 10 0 20 0 11 1 21 0 0 LINE 8 SEEN 10 0 20 0 11 2 21 0 0 ENDBLK 0 ENDSEC \
         0 SECTION 2 ENTITIES 0 LINE 8 P 67 1 10 0 20 0 11 5 21 0 0 LINE 8 I 60 1 10 0 20 0 11 5 21 0 0 LINE 8 ICE 10 0 20 0 11 5 21 0 \
         0 LINE 8 DARK 10 0 20 0 11 5 21 0 0 INSERT 8 ICE 2 B 10 0 20 0 0 INSERT 8 DARK 2 B 10 0 20 0 0 ENDSEC 0 EOF",
    );
    let drawing = read(&text).unwrap();
    // Of an insert on a layer that is off, entities on other layers are visible.
    assert_eq!(crate::testkit::drawings::shapes(&drawing), [("LINE", 2.0)]);
    let mut hidden: Vec<_> = drawing
        .findings
        .iter()
        .filter(|f| f.code == Code::HiddenEntity)
        .map(|f| (f.layer.clone().unwrap(), f.count))
        .collect();
    hidden.sort();
    let expected = [("DARK", 2), ("I", 1), ("ICE", 2), ("P", 1)].map(|(l, n)| (l.to_owned(), n));
    assert_eq!(hidden, expected);
    let visible: Vec<_> = drawing.layers.iter().filter(|l| !l.visible).map(|l| l.name.as_str()).collect();
    assert_eq!(visible, ["ICE", "DARK"]);
}

#[test]
fn attributes_after_an_insert_are_text() {
    let drawing = blocks(
        BAR,
        "0 INSERT 8 0 66 1 2 BAR 10 0 20 0 0 ATTRIB 8 0 10 0 20 0 1 x 2 TAG 0 SEQEND 8 0 0 LINE 8 0 10 0 20 0 11 1 21 0",
    );
    assert_eq!(drawing.shapes.len(), 2);
    assert_eq!(found(&drawing, Code::UnsupportedEntity).count, 1);
}

#[test]
fn scale_of_0_becomes_1_and_is_reported() {
    let drawing = blocks(BAR, "0 INSERT 8 0 2 BAR 10 0 20 0 41 0 42 1 43 0");
    close(length(&drawing), 2.0);
    assert!(found(&drawing, Code::InvalidGeometry).message.contains("scale"));
}

#[test]
fn model_space_given_as_a_block_is_the_model() {
    let drawing = blocks("0 BLOCK 2 *Model_Space 10 0 20 0 0 LINE 8 0 10 0 20 0 11 4 21 0 0 ENDBLK", "");
    close(length(&drawing), 4.0);
    assert!(
        entities("0 LINE 8 0 10 0 20 0 11 1 21 0").findings.iter().all(|f| f.code == Code::UnitsDoubtful)
    );
}

#[test]
fn clipped_inserts_are_a_finding() {
    let file = |enabled: u32, owner: &str| {
        lines(&format!(
            "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 BLOCKS {BAR} 0 ENDSEC \
             0 SECTION 2 ENTITIES 0 INSERT 5 34 102 {{ACAD_XDICTIONARY 360 36 102 }} 330 17 8 0 2 BAR 10 5 20 7 0 ENDSEC \
             0 SECTION 2 OBJECTS 0 DICTIONARY 5 36 330 {owner} 3 ACAD_FILTER 350 37 0 DICTIONARY 5 37 330 36 3 SPATIAL 350 38 \
             0 SPATIAL_FILTER 5 38 102 {{ACAD_REACTORS 330 37 102 }} 330 37 70 2 10 0 20 0 10 2 20 2 71 {enabled} 0 ENDSEC 0 EOF"
        ))
    };
    let drawing = read(&file(1, "34")).unwrap();
    let clipped = found(&drawing, Code::UnsupportedEntity);
    assert_eq!((clipped.handle.as_deref(), clipped.at), (Some("34"), Some(DVec2::new(5.0, 7.0))));
    assert!(clipped.message.starts_with("The block \"BAR\" is clipped"), "{}", clipped.message);
    let unknown = read(&file(1, "99")).unwrap();
    assert_eq!(found(&unknown, Code::UnsupportedEntity).count, 1);
    assert!(read(&file(0, "34")).unwrap().findings.iter().all(|f| f.code != Code::UnsupportedEntity));
}

#[test]
fn entities_of_inactive_layouts_are_counted_as_hidden() {
    let layout =
        "0 BLOCK 2 *Paper_Space0 10 0 20 0 0 CIRCLE 8 0 10 5 20 5 40 3 0 VIEWPORT 8 0 10 0 20 0 0 ENDBLK";
    let drawing = blocks(layout, "0 LINE 8 0 10 0 20 0 11 9 21 0");
    let hidden = found(&drawing, Code::HiddenEntity);
    assert_eq!((hidden.count, drawing.shapes.len()), (1, 1));
    assert!(hidden.message.contains("paper layout"), "{}", hidden.message);
}

/// Layers of which ICE is frozen and DARK is off, a block with a circle on layer A, and these entities.
fn on_hidden_layers(entities: &str) -> String {
    lines(&format!(
        "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC \
         0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 ICE 70 1 62 7 0 LAYER 2 DARK 70 0 62 -3 0 ENDTAB 0 ENDSEC \
         0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 A 10 0 20 0 40 50 0 LINE 8 0 10 0 20 0 11 900000 21 0 0 ENDBLK \
         0 BLOCK 2 C 10 0 20 0 0 INSERT 8 0 2 B 10 0 20 0 0 ENDBLK 0 ENDSEC \
         0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF"
    ))
}

/// The drawing was said to be 0 mm large. The line on layer 0 is hidden with the insert and does not count.
#[test]
fn an_insert_on_a_layer_that_is_off_counts_for_the_size_as_far_as_it_is_drawn() {
    for block in ["B", "C"] {
        let insert = format!("0 INSERT 8 DARK 2 {block} 10 100 20 100");
        let drawing = read(&on_hidden_layers(&insert)).unwrap();
        assert_eq!(crate::testkit::drawings::shapes(&drawing).len(), 1);
        assert!(!drawing.units.doubtful, "{}", drawing.units.reason);
    }
}

/// Inserts that are never expanded counted as if they were.
#[test]
fn an_insert_on_a_frozen_layer_does_not_count_for_the_limit() {
    let frozen = "0 INSERT 8 ICE 2 B 10 0 20 0 70 30000 71 30000 0 CIRCLE 8 A 10 0 20 0 40 50";
    assert_eq!(read(&on_hidden_layers(frozen)).unwrap().shapes.len(), 1);
    let off = frozen.replace("ICE", "DARK");
    assert!(matches!(read(&on_hidden_layers(&off)), Err(ReadError::Limit(_))));
}

/// The message held two braces for the name.
#[test]
fn a_block_without_a_name_is_reported_without_braces() {
    // `lines` drops empty values.
    let text = file("", "0 LINE 8 0 10 0 20 0 11 100 21 0 0 INSERT 8 A 2 NAME 10 0 20 0").replace("NAME", "");
    let drawing = read(&text).unwrap();
    let missing = found(&drawing, Code::MissingBlock);
    assert!(missing.message.starts_with("The block \"?\" is inserted (1)"), "{}", missing.message);
}
