//! Blocks that multiply or contain themselves.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and tells what it did"
)]

use super::reading::{circle, find, intake};
use crate::testkit::dxf_text::{Similarity, block, document, insert};
use kerfway::drawing::{Drawing, ReadError};
use kerfway::finding::Code;
use kerfway::geometry::DVec2;
use kerfway::sheet::Sheet;

fn array(name: &str, columns: u32, rows: u32) -> String {
    format!("0\nINSERT\n8\n0\n2\n{name}\n10\n0.0\n20\n0.0\n70\n{columns}\n71\n{rows}\n44\n1.0\n45\n1.0\n")
}

/// Blocks of `depth` levels, each with `width` inserts of the one below; the lowest contains `body`.
fn laughs(depth: usize, width: usize, body: &str) -> String {
    let mut blocks = String::new();
    block("B0", DVec2::ZERO, body, &mut blocks);
    for i in 1..depth {
        let inner = insert(&format!("B{}", i - 1), DVec2::new(1.0, 0.0), &Similarity::IDENTITY).repeat(width);
        block(&format!("B{i}"), DVec2::ZERO, &inner, &mut blocks);
    }
    let top = insert(&format!("B{}", depth - 1), DVec2::ZERO, &Similarity::IDENTITY);
    document(4, &blocks, &(top + &circle(0.0, 0.0, 5.0)))
}

fn assert_limit(result: Result<(Drawing, Sheet), ReadError>) {
    match result {
        Err(ReadError::Limit(sentence)) => assert!(sentence.len() > 20, "{sentence}"),
        Err(other) => panic!("{other:?}"),
        Ok((drawing, _)) => panic!("read as {} shapes", drawing.shapes.len()),
    }
}

#[test]
fn array_of_a_thousand_million_inserts_is_refused() {
    let mut blocks = String::new();
    block("B", DVec2::ZERO, &circle(0.0, 0.0, 0.4), &mut blocks);
    assert_limit(intake(&document(4, &blocks, &array("B", 32_767, 32_767))));
}

#[test]
fn array_of_a_thousand_million_empty_inserts_terminates() {
    for body in ["", "0\nTEXT\n8\n0\n10\n0.0\n20\n0.0\n40\n1.0\n1\nx\n"] {
        let mut blocks = String::new();
        block("B", DVec2::ZERO, body, &mut blocks);
        let text = document(4, &blocks, &(array("B", 32_767, 32_767) + &circle(0.0, 0.0, 5.0)));
        if let Err(e) = intake(&text) {
            assert!(matches!(e, ReadError::Limit(_)), "{e}");
        }
    }
}

#[test]
fn ten_levels_of_ten_inserts_are_refused() {
    assert_limit(intake(&laughs(10, 10, &circle(0.0, 0.0, 1.0))));
}

#[test]
fn ten_levels_of_ten_empty_inserts_terminate() {
    if let Err(e) = intake(&laughs(11, 10, "")) {
        assert!(matches!(e, ReadError::Limit(_)), "{e}");
    }
}

#[test]
fn ten_levels_of_single_inserts_are_read() {
    let (drawing, _) = intake(&laughs(10, 1, &circle(0.0, 0.0, 1.0))).unwrap();
    assert_eq!(drawing.shapes.len(), 2);
    // Nine inserts move by 1 mm each, the outermost by none.
    assert_eq!(drawing.shapes[0].path.start(), Some(DVec2::new(10.0, 0.0)));
}

#[test]
fn inserts_nested_past_the_limit_are_refused_or_reported() {
    match intake(&laughs(1000, 1, &circle(0.0, 0.0, 1.0))) {
        Err(e) => assert!(matches!(e, ReadError::Limit(_)), "{e}"),
        Ok((drawing, _)) => assert!(drawing.findings.iter().any(|f| f.count > 0), "silent"),
    }
}

#[test]
fn blocks_that_contain_themselves_are_reported() {
    let mut blocks = String::new();
    let at = |name: &str| insert(name, DVec2::new(3.0, 0.0), &Similarity::IDENTITY);
    block("SELF", DVec2::ZERO, &(at("SELF") + &circle(0.0, 0.0, 1.0)), &mut blocks);
    block("A", DVec2::ZERO, &(at("B") + &circle(0.0, 9.0, 1.0)), &mut blocks);
    block("B", DVec2::ZERO, &at("A"), &mut blocks);
    let (drawing, _) = intake(&document(4, &blocks, &(at("SELF") + &at("A")))).unwrap();
    assert_eq!(drawing.shapes.len(), 2);
    assert!(find(&drawing.findings, Code::CyclicBlock).is_some());
}

#[test]
fn twelve_blocks_that_all_contain_each_other_terminate() {
    let mut blocks = String::new();
    let all: String = (0..12).map(|i| insert(&format!("B{i}"), DVec2::ZERO, &Similarity::IDENTITY)).collect();
    for i in 0..12 {
        block(&format!("B{i}"), DVec2::ZERO, &all, &mut blocks);
    }
    match intake(&document(4, &blocks, &(all + &circle(0.0, 0.0, 5.0)))) {
        Err(e) => assert!(matches!(e, ReadError::Limit(_)), "{e}"),
        Ok((drawing, _)) => assert!(find(&drawing.findings, Code::CyclicBlock).is_some()),
    }
}
