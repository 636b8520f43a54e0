//! What each kind of entity becomes, except curves: places, lengths and findings, one test an item.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::testkit::drawings::{close, entities, found, length, one, read, shapes};
use kerfway::finding::Code;
use kerfway::geometry::{DVec2, Path, Segment};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

pub(super) fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

#[test]
fn line_keeps_its_ends_bit_for_bit() {
    let path = one("0 LINE 8 0 10 0.1 20 0.2 11 10.3 21 -4.7");
    assert_eq!(path.segments, [Segment::line(v(0.1, 0.2), v(10.3, -4.7))]);
    assert!(!path.closed);
}

#[test]
fn circle_and_arc_stay_exact() {
    let circle = one("0 CIRCLE 8 0 10 5 20 6 40 2.5");
    assert!(circle.closed);
    close(circle.length(), TAU * 2.5);
    let arc = one("0 ARC 8 0 10 0 20 0 40 10 50 270 51 90");
    assert_eq!(arc.start(), Some(v(0.0, -10.0)));
    assert_eq!(arc.end(), Some(v(0.0, 10.0)));
    let Segment::Arc(a) = arc.segments[0] else { panic!("not an arc") };
    close(a.sweep, PI);
}

#[test]
fn arc_with_angles_a_turn_apart_is_a_circle_and_with_equal_ones_nothing() {
    assert!(one("0 ARC 8 0 10 0 20 0 40 10 50 30 51 390").closed);
    let drawing = entities("0 ARC 8 0 10 0 20 0 40 10 50 30 51 30 0 LINE 8 0 10 0 20 0 11 9 21 0");
    assert_eq!(drawing.shapes.len(), 1);
    assert_eq!(found(&drawing, Code::InvalidGeometry).count, 1);
}

#[test]
fn light_polyline_bulges_also_on_the_closing_vertex() {
    // Two half circles of radius 5.
    let path = one("0 LWPOLYLINE 8 0 90 2 70 1 10 0 20 0 42 1 10 10 20 0 42 1");
    assert!(path.closed);
    close(path.length(), TAU * 5.0);
    close(path.area(), PI * 25.0);
    // Open: the bulge of the last vertex is not drawn.
    let open = one("0 LWPOLYLINE 8 0 90 2 70 0 10 0 20 0 42 1 10 10 20 0 42 1");
    close(open.length(), PI * 5.0);
}

#[test]
fn light_polyline_without_subclass_markers_is_read() {
    let bare = one("0 LWPOLYLINE 8 0 90 3 70 1 10 0 20 0 10 4 20 0 10 4 20 3");
    let marked = one(
        "0 LWPOLYLINE 5 1F 330 A 100 AcDbEntity 8 0 100 AcDbPolyline 90 3 70 1 43 0.0 10 0 20 0 10 4 20 0 10 4 20 3",
    );
    assert_eq!(bare, marked);
    close(bare.length(), 12.0);
}

#[test]
fn old_polyline_skips_the_frame_of_a_spline_fit() {
    let path = one("0 POLYLINE 8 0 66 1 70 4 0 VERTEX 8 0 10 0 20 99 70 16 0 VERTEX 8 0 10 0 20 0 70 8 \
         0 VERTEX 8 0 10 50 20 99 70 16 0 VERTEX 8 0 10 3 20 4 70 8 0 SEQEND");
    close(path.length(), 5.0);
}

#[test]
fn old_polyline_keeps_vertices_of_a_curve_fit() {
    let path = one(
        "0 POLYLINE 8 0 66 1 70 2 0 VERTEX 8 0 10 0 20 0 0 VERTEX 8 0 10 3 20 4 70 1 0 VERTEX 8 0 10 3 20 9 0 SEQEND",
    );
    close(path.length(), 10.0);
}

#[test]
fn old_polyline_shares_its_handle_with_a_vertex_and_lacks_its_end() {
    // Handles repeat in real files, and SEQEND may be missing: nothing is looked up by handle.
    let drawing = entities(
        "0 POLYLINE 5 2A 8 0 66 1 70 1 0 VERTEX 5 2A 8 0 10 0 20 0 0 VERTEX 5 2A 8 0 10 4 20 0 0 VERTEX 5 2A 8 0 10 4 20 3 \
         0 LINE 5 2A 8 0 10 0 20 0 11 1 21 0",
    );
    let kinds: Vec<_> = drawing.shapes.iter().map(|s| (s.kind, s.path.length())).collect();
    assert_eq!(kinds, [("POLYLINE", 12.0), ("LINE", 1.0)]);
}

#[test]
fn spatial_polyline_is_projected_and_reported() {
    let drawing = entities(
        "0 POLYLINE 8 0 66 1 70 8 0 VERTEX 8 0 10 0 20 0 30 0 70 32 0 VERTEX 8 0 10 3 20 4 30 12 70 32 0 SEQEND",
    );
    close(drawing.shapes[0].path.length(), 5.0);
    assert_eq!(found(&drawing, Code::Projected).count, 1);
}

#[test]
fn meshes_are_counted_with_their_place() {
    let mesh = "0 POLYLINE 8 M 66 1 70 16 71 2 72 2 0 VERTEX 8 M 10 7 20 8 70 64 0 VERTEX 8 M 10 1 20 0 70 64 0 SEQEND";
    let drawing = entities(&format!("{mesh} {mesh} 0 LINE 8 0 10 0 20 0 11 1 21 0"));
    let finding = found(&drawing, Code::UnsupportedEntity);
    assert_eq!((finding.count, finding.at, finding.layer.as_deref()), (2, Some(v(7.0, 8.0)), Some("M")));
}

#[test]
fn solid_corners_are_stored_crosswise() {
    let drawing = entities("0 SOLID 8 0 10 0 20 0 11 4 21 0 12 0 22 3 13 4 23 3");
    let path = &drawing.shapes[0].path;
    assert!(path.closed);
    close(path.length(), 14.0);
    close(path.area().abs(), 12.0);
    assert_eq!(found(&drawing, Code::OutlineTaken).count, 1);
}

#[test]
fn triangle_repeats_a_corner() {
    let path = one("0 SOLID 8 0 10 0 20 0 11 4 21 0 12 4 22 3 13 4 23 3");
    close(path.length(), 12.0);
    assert_eq!(path.segments.len(), 3);
}

#[test]
fn face_leaves_out_its_hidden_edges() {
    // Bit 2: the edge from the second corner on.
    let drawing = entities("0 3DFACE 8 0 10 0 20 0 11 4 21 0 12 4 22 3 13 0 23 3 70 2");
    assert_eq!(drawing.shapes.len(), 1);
    let path = &drawing.shapes[0].path;
    assert!(!path.closed);
    close(path.length(), 11.0);
    let two = entities("0 3DFACE 8 0 10 0 20 0 11 4 21 0 12 4 22 3 13 0 23 3 70 5");
    close(length(&two), 6.0);
    assert_eq!(two.shapes.len(), 2);
}

/// Such a face said that its outline is taken, at no place, although nothing of it is.
#[test]
fn a_face_with_no_visible_edge_is_not_said_to_be_taken() {
    let face = "0 3DFACE 8 0 10 1 20 2 11 4 21 0 12 4 22 3 13 0 23 3 70 15";
    let drawing = entities(&format!("{face} 0 LINE 8 0 10 0 20 0 11 9 21 0"));
    assert!(drawing.findings.iter().all(|f| f.code != Code::OutlineTaken), "{:?}", drawing.findings);
    let invalid = found(&drawing, Code::InvalidGeometry);
    assert_eq!(invalid.message, "3DFACE cannot be cut: all its edges are invisible.");
    assert_eq!(invalid.at, Some(DVec2::new(1.0, 2.0)));
}

#[test]
fn hatch_boundaries_of_both_kinds() {
    let polyline = "0 HATCH 8 0 10 0 20 0 30 0 210 0 220 0 230 1 2 SOLID 70 1 71 0 91 1 92 7 72 1 73 1 93 2 10 0 20 0 42 1 10 10 20 0 42 1 97 0 75 0 76 1 98 1 10 5 20 5";
    close(length(&entities(polyline)), TAU * 5.0);
    // A half disc: an arc clockwise and a line, then seed points that are no part of it.
    let edges = "0 HATCH 8 0 10 0 20 0 30 0 2 SOLID 70 1 71 0 91 1 92 1 93 2 72 2 10 0 20 0 40 5 50 180 51 360 73 0 72 1 10 5 20 0 11 -5 21 0 97 0 75 0 76 1 98 1 10 77 20 77";
    let drawing = entities(edges);
    close(length(&drawing), PI * 5.0 + 10.0);
    let arc = &drawing.shapes[0].path;
    // Clockwise from 180 degrees mirrored at the x axis: over the upper half.
    close(arc.segments[0].at(0.5).distance(v(0.0, 5.0)), 0.0);
    assert_eq!(found(&drawing, Code::OutlineTaken).count, 1);
}

#[test]
fn text_points_and_dimensions_are_counted_by_kind_and_layer() {
    let drawing = entities(
        "0 TEXT 5 A1 8 T 10 3 20 4 1 hello 0 TEXT 8 T 10 9 20 9 1 x 0 TEXT 8 U 10 1 20 1 1 y 0 POINT 8 T 10 1 20 2 \
         0 DIMENSION 8 D 10 1 20 1 0 ACAD_PROXY_ENTITY 8 D 0 WEIRD_THING 8 D 0 LINE 8 0 10 0 20 0 11 1 21 0",
    );
    let list: Vec<_> = drawing.findings.iter().filter(|f| f.code == Code::UnsupportedEntity).collect();
    assert_eq!(list.len(), 6, "{list:#?}");
    let text = list.iter().find(|f| f.message.contains("TEXT") && f.layer.as_deref() == Some("T")).unwrap();
    assert_eq!((text.count, text.at, text.handle.as_deref()), (2, Some(v(3.0, 4.0)), Some("A1")));
    let kinds: Vec<_> = drawing.entities.iter().map(|e| (e.kind.as_str(), e.count, e.supported)).collect();
    assert_eq!(kinds[0], ("TEXT", 3, false));
    assert!(kinds.contains(&("LINE", 1, true)));
}

#[test]
fn extended_data_embedded_objects_and_application_groups_are_no_geometry() {
    let path = one(
        "0 LINE 5 1A 102 {ACAD_REACTORS 330 1B 10 99 102 } 8 0 10 0 20 0 11 3 21 4 1001 ACAD 1010 500 1020 500 1070 5",
    );
    close(path.length(), 5.0);
    let embedded = one("0 CIRCLE 8 0 10 0 20 0 40 1 101 Embedded_Object 70 1 10 55 20 66 40 99");
    close(embedded.length(), TAU);
}

#[test]
fn extrusion_below_mirrors_arcs_and_bulges() {
    // In its own plane: centre (10, 0), from 0 to 90 degrees. Seen from above x is turned over.
    let arc = one("0 ARC 8 0 10 10 20 0 40 5 50 0 51 90 210 0 220 0 230 -1");
    close(arc.start().unwrap().distance(v(-15.0, 0.0)), 0.0);
    close(arc.end().unwrap().distance(v(-10.0, 5.0)), 0.0);
    let Segment::Arc(a) = arc.segments[0] else { panic!("not an arc") };
    close(a.sweep, -FRAC_PI_2);
    let bulge = one("0 LWPOLYLINE 8 0 90 2 70 0 10 0 20 0 42 1 10 10 20 0 210 0 220 0 230 -1");
    close(bulge.segments[0].at(0.5).distance(v(-5.0, -5.0)), 0.0);
}

#[test]
fn entities_without_geometry_in_their_values_are_findings() {
    for broken in [
        "0 CIRCLE 5 7 8 0 10 1 20 2 40 0",
        "0 CIRCLE 5 7 8 0 10 1 20 2",
        "0 LINE 5 7 8 0 10 1 20 2",
        "0 LWPOLYLINE 5 7 8 0 90 1 70 0 10 1 20 2",
        "0 SPLINE 5 7 8 0 70 8 71 3",
        "0 ELLIPSE 5 7 8 0 10 1 20 2 11 0 21 0 40 1",
        "0 HATCH 5 7 8 0 10 1 20 2 30 0 91 0 75 0",
        "0 INSERT 5 7 8 0 10 1 20 2",
        "0 3DFACE 5 7 8 0 10 1 20 2 11 1 21 2 12 1 22 2 13 1 23 2",
        "0 POLYLINE 5 7 8 0 66 1 0 VERTEX 8 0 10 1 20 2 0 SEQEND",
    ] {
        let drawing = entities(&format!("{broken} 0 LINE 8 0 10 0 20 0 11 1 21 0"));
        assert_eq!(drawing.shapes.len(), 1, "{broken}");
        let finding = found(&drawing, Code::InvalidGeometry);
        assert_eq!(finding.handle.as_deref(), Some("7"), "{broken}");
    }
}

#[test]
fn a_missing_y_is_0_and_reported() {
    let drawing = entities("0 LINE 8 0 10 3 11 7 21 0");
    assert_eq!(shapes(&drawing), [("LINE", 4.0)]);
    assert!(found(&drawing, Code::InvalidGeometry).message.contains("no y"));
}

#[test]
fn a_file_without_anything_to_cut_says_why() {
    let text = crate::testkit::drawings::file("", "0 TEXT 8 0 10 0 20 0 1 x");
    let sentence = read(&text).unwrap_err().to_string();
    assert!(sentence.contains("1 without an outline"), "{sentence}");
}

#[test]
fn wide_polylines_are_read_along_their_middle_and_counted() {
    let points = "10 0 20 0 10 30 20 0 10 30 20 40";
    let light = |width: &str| entities(&format!("0 LWPOLYLINE 8 CUT 90 3 70 0 {width} {points}"));
    assert_eq!(shapes(&light("43 0")), [("LWPOLYLINE", 70.0)]);
    assert!(light("43 0").findings.is_empty());
    let heavy = |head: &str, vertex: &str| {
        entities(&format!(
            "0 POLYLINE 8 CUT 66 1 70 0 {head} 0 VERTEX 8 CUT 10 0 20 0 0 VERTEX 8 CUT 10 30 20 0 {vertex} 0 SEQEND"
        ))
    };
    let varying = entities("0 LWPOLYLINE 8 CUT 90 2 70 0 10 0 20 0 40 0 41 1.5 10 70 20 0");
    for (drawing, kind, length) in [
        (light("43 2.5"), "LWPOLYLINE", 70.0),
        (varying, "LWPOLYLINE", 70.0),
        (heavy("40 1 41 1", ""), "POLYLINE", 30.0),
        (heavy("", "41 0.5"), "POLYLINE", 30.0),
    ] {
        assert_eq!(shapes(&drawing), [(kind, length)]);
        let finding = found(&drawing, Code::OutlineTaken);
        assert_eq!((finding.count, finding.layer.as_deref()), (1, Some("CUT")));
        assert!(finding.message.contains("drawn with a width"), "{finding:?}");
    }
    assert!(heavy("40 0 41 0", "40 0").findings.is_empty());
}

/// The sweep of an arc from 200 degrees to an angle of 1e42 did not fit its ends.
#[test]
fn angles_many_turns_away_still_fit_the_ends() {
    for (start, end) in
        [("200", "-4.878288012178574e42"), ("1e17", "90"), ("36000000030", "7e15"), ("720", "810")]
    {
        let path = one(&format!("0 ARC 8 0 10 0 20 0 40 9 50 {start} 51 {end}"));
        let Segment::Arc(a) = path.segments[0] else { panic!("not an arc") };
        let there = a.center + kerfway::geometry::math::rotate(a.start - a.center, a.sweep);
        assert!(there.distance(a.end) < 1e-9, "{start} {end}: {there} is not {}", a.end);
    }
}

#[test]
fn hatch_ellipse_edges_state_angles_and_not_parameters() {
    // Half axes of 40 and 10: the point of the ellipse in the direction of 30 degrees from its centre.
    let y1 = 40.0 / 19_f64.sqrt();
    let x1 = 3_f64.sqrt() * y1;
    let hatch = |angles: &str, from: f64, to: f64| {
        format!(
            "0 HATCH 8 0 10 0 20 0 30 0 2 SOLID 70 1 71 0 91 1 92 1 93 2 72 3 10 50 20 50 11 40 21 0 40 0.25 {angles} \
             72 1 10 {} 20 {} 11 {} 21 {} 97 0 75 0 76 1 98 0",
            50.0 + from,
            50.0 + y1,
            50.0 + to,
            50.0 + y1
        )
    };
    for (angles, from, to) in [
        ("50 30 51 150 73 1", -x1, x1),
        ("50 390 51 510 73 1", -x1, x1),
        // Clockwise edges have their angles mirrored: from 150 to 30.
        ("50 210 51 330 73 0", x1, -x1),
    ] {
        let drawing = entities(&hatch(angles, from, to));
        let [ellipse, line] = [0, 1].map(|k| drawing.shapes[k].path.clone());
        let ends = |path: &Path| [path.start().unwrap(), path.end().unwrap()];
        let ([a, b], [c, d]) = (ends(&ellipse), ends(&line));
        assert!(a.distance(d) < 1e-9 && b.distance(c) < 1e-9, "{angles}: {a} to {b}, {c} to {d}");
        assert!((ellipse.bounds().max.y - 60.0).abs() < 0.01, "{angles}: {:?}", ellipse.bounds());
    }
}

#[test]
fn a_hatch_whose_edge_lacks_a_value_says_so() {
    let drawing = entities(
        "0 HATCH 5 A1 8 0 10 0 20 0 30 0 2 SOLID 70 1 71 0 91 1 92 1 93 4 72 1 10 0 20 0 11 40 21 0 \
         72 1 10 40 20 0 11 40 21 40 72 2 10 20 20 40 50 0 51 180 73 1 72 1 10 0 20 40 11 0 21 0 97 0 75 0 76 1 98 0",
    );
    close(length(&drawing), 120.0);
    let finding = found(&drawing, Code::InvalidGeometry);
    assert_eq!((finding.handle.as_deref(), finding.at), (Some("A1"), Some(v(0.0, 0.0))));
}

#[test]
fn findings_are_where_the_entity_is_seen_from_above() {
    let drawing = entities(
        "0 LINE 8 0 10 0 20 0 11 9 21 0 0 TEXT 5 B1 8 0 10 100 20 50 40 5 1 HELLO 210 0 220 0 230 -1 \
         0 INSERT 5 B2 8 0 2 NOPE 10 100 20 50 210 0 220 0 230 -1 \
         0 CIRCLE 5 B3 8 0 10 100 20 50 40 0 210 0 220 0 230 -1 \
         0 SPLINE 5 B4 8 0 70 8 71 3 72 8 73 4 74 0 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 \
         10 30 20 40 30 0 10 30 20 40 30 0 10 30 20 40 30 0 10 30 20 40 30 0",
    );
    let at = |handle: &str| {
        let finding = drawing.findings.iter().find(|f| f.handle.as_deref() == Some(handle));
        finding.and_then(|f| f.at)
    };
    assert_eq!(["B1", "B2", "B3"].map(at), [Some(v(-100.0, 50.0)); 3], "{:#?}", drawing.findings);
    assert_eq!(at("B4"), Some(v(30.0, 40.0)));
}
