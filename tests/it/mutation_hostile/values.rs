//! Numbers, counts and curves that no sheet has, and drawings too crowded for slow methods.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and tells what it did"
)]

use super::reading::{circle, intake, line};
use crate::testkit::dxf_text::{block, document};
use kerfway::drawing::ReadError;
use kerfway::finding::Code;
use kerfway::geometry::DVec2;
use std::fmt::Write;
use std::time::Instant;

#[test]
fn values_that_are_not_numbers_are_reported_and_never_drawn() {
    for bad in ["NaN", "nan", "inf", "-inf", "1e999", "1.#QNAN", "1.0E+400"] {
        let broken = circle(0.0, 0.0, 5.0).replace("40\n5.0", &format!("40\n{bad}"));
        let (drawing, sheet) = intake(&document(4, "", &(broken + &circle(50.0, 0.0, 5.0)))).unwrap();
        assert_eq!(drawing.shapes.len(), 1, "{bad}");
        assert_eq!(sheet.contours.len(), 1, "{bad}");
        let told = drawing.findings.iter().any(|f| matches!(f.code, Code::BadNumber | Code::DamagedEntity));
        assert!(told, "{bad}: {:?}", drawing.findings);
    }
}

#[test]
fn huge_coordinates_are_refused_or_reported() {
    for huge in ["1e308", "-1e308", "1e200", "1e100", "1e30", "1e12"] {
        for entity in [
            circle(0.0, 0.0, 5.0).replace("40\n5.0", &format!("40\n{huge}")),
            circle(0.0, 0.0, 5.0).replace("10\n0.0", &format!("10\n{huge}")),
            line(0.0, 0.0, 1.0, 1.0).replace("11\n1.0", &format!("11\n{huge}")),
            format!("0\nLWPOLYLINE\n8\n0\n90\n2\n70\n1\n10\n0.0\n20\n0.0\n42\n{huge}\n10\n5.0\n20\n0.0\n"),
            format!("0\nELLIPSE\n8\n0\n10\n0.0\n20\n0.0\n11\n{huge}\n21\n0.0\n40\n0.5\n41\n0.0\n42\n6.283\n"),
            format!("0\nELLIPSE\n8\n0\n10\n0.0\n20\n0.0\n11\n5.0\n21\n0.0\n40\n{huge}\n41\n0.0\n42\n6.283\n"),
            format!("0\nELLIPSE\n8\n0\n10\n0.0\n20\n0.0\n11\n5.0\n21\n0.0\n40\n0.5\n41\n0.0\n42\n{huge}\n"),
            format!("0\nARC\n8\n0\n10\n0.0\n20\n0.0\n40\n5.0\n50\n{huge}\n51\n90.0\n"),
            format!(
                "0\nSPLINE\n8\n0\n70\n8\n71\n3\n72\n8\n73\n4\n74\n0\n40\n0.0\n40\n0.0\n40\n0.0\n40\n0.0\n40\n1.0\n40\n1.0\n\
                 40\n1.0\n40\n{huge}\n10\n0.0\n20\n0.0\n10\n{huge}\n20\n5.0\n10\n10.0\n20\n0.0\n10\n20.0\n20\n5.0\n"
            ),
        ] {
            let text = document(4, "", &(entity + &circle(50.0, 0.0, 5.0)));
            match intake(&text) {
                Err(e) => assert!(matches!(e, ReadError::Limit(_)), "{huge}: {e}"),
                Ok((drawing, sheet)) => {
                    let finite = |p: DVec2| p.is_finite() && p.abs().max_element() <= 1.1e6;
                    for c in &sheet.contours {
                        assert!(finite(c.bounds.min) && finite(c.bounds.max), "{huge}: {:?}", c.bounds);
                        assert!(c.length.is_finite() && c.area.is_finite());
                    }
                    assert!(!drawing.shapes.is_empty(), "the sound circle is lost");
                }
            }
        }
    }
}

#[test]
fn extreme_transforms_are_refused_or_reported() {
    for (scale, nest) in [("1e200", 2), ("0.0", 1), ("1e-300", 3), ("NaN", 1)] {
        let at =
            |name: &str| format!("0\nINSERT\n8\n0\n2\n{name}\n10\n0.0\n20\n0.0\n41\n{scale}\n42\n{scale}\n");
        let mut blocks = String::new();
        block("B0", DVec2::ZERO, &(circle(1.0, 1.0, 5.0) + &line(0.0, 0.0, 3.0, 1.0)), &mut blocks);
        for i in 1..=nest {
            block(&format!("B{i}"), DVec2::ZERO, &at(&format!("B{}", i - 1)), &mut blocks);
        }
        let text = document(4, &blocks, &(at(&format!("B{nest}")) + &circle(0.0, 0.0, 5.0)));
        match intake(&text) {
            Err(e) => assert!(matches!(e, ReadError::Limit(_)), "{scale}: {e}"),
            Ok((drawing, sheet)) => {
                assert!(sheet.contours.iter().all(|c| c.length.is_finite() && c.length > 0.0), "{scale}");
                assert!(!drawing.findings.is_empty(), "{scale}: silent");
            }
        }
    }
}

#[test]
fn counts_larger_than_the_file_are_not_trusted() {
    for count in ["2147483647", "-1", "99999999999", "70000"] {
        let lw = format!(
            "0\nLWPOLYLINE\n8\n0\n90\n{count}\n70\n1\n10\n0.0\n20\n0.0\n10\n9.0\n20\n0.0\n10\n9.0\n20\n9.0\n"
        );
        let hatch = format!(
            "0\nHATCH\n8\n0\n2\nSOLID\n70\n1\n91\n{count}\n92\n2\n72\n0\n73\n1\n93\n{count}\n10\n0.0\n20\n0.0\n"
        );
        let spline = format!(
            "0\nSPLINE\n8\n0\n70\n8\n71\n{count}\n72\n{count}\n73\n{count}\n74\n0\n40\n0.0\n10\n0.0\n20\n0.0\n"
        );
        let (drawing, _) =
            intake(&document(4, "", &(lw + &hatch + &spline + &circle(50.0, 0.0, 5.0)))).unwrap();
        assert!(drawing.shapes.iter().any(|s| s.kind == "CIRCLE"), "{count}");
        assert!(!drawing.findings.is_empty(), "{count}: silent");
    }
}

#[test]
fn endless_filler_is_read_in_one_pass() {
    let body = circle(0.0, 0.0, 5.0);
    for filler in [
        "\n".repeat(400_000),
        "garbage\n".to_owned() + &"\n".repeat(400_000) + "garbage\n",
        "x\n\n".repeat(200_000),
        "=======\n".repeat(200_000),
        "10\n\n".repeat(150_000),
        "10\n".repeat(300_001),
        "0\n".repeat(300_001),
        "9999\nx\n".repeat(150_000),
        "x".repeat(4_000_000) + "\n",
        "999\ncomment\n".repeat(150_000),
        "0\nSECTION\n".repeat(150_000),
        "0\nPOLYLINE\n".repeat(150_000),
        "102\n{A\n".repeat(150_000),
        "\u{0}".repeat(2_000_000) + "\n",
        "\r".repeat(1_000_000),
    ] {
        let text = document(4, "", &(body.clone() + &filler + &body.replace("10\n0.0", "10\n40.0")));
        let shown: String = filler.chars().take(12).collect();
        let start = Instant::now();
        let result = intake(&text);
        println!("{shown:?}: {:?}", start.elapsed());
        match result {
            Ok((drawing, _)) => assert!(!drawing.shapes.is_empty(), "{shown:?}: nothing read"),
            Err(e) => assert!(e.to_string().len() > 20, "{shown:?}"),
        }
    }
}

#[test]
fn findings_by_the_hundred_thousand_are_counted() {
    let mut body = circle(0.0, 0.0, 5.0);
    for i in 0..100_000 {
        let _ = write!(
            body,
            "0\nTEXT\n8\nL{i}\n10\n0.0\n20\n0.0\n40\n1.0\n1\nx\n0\nCIRCLE\n8\n0\n10\n0.0\n20\n0.0\n40\n0.0\n"
        );
    }
    let (drawing, _) = intake(&document(4, "", &body)).unwrap();
    assert!(drawing.findings.len() < 2_000, "{} findings listed", drawing.findings.len());
    let texts = drawing.entities.iter().find(|e| e.kind == "TEXT").map(|e| e.count);
    assert_eq!(texts, Some(100_000));
}

#[test]
fn crowded_drawings_take_no_quadratic_time() {
    let star: String =
        (0..20_000).map(|i| line(0.0, 0.0, 100.0 + f64::from(i), f64::from(i % 997))).collect();
    let stacked = line(0.0, 0.0, 100.0, 0.0).repeat(20_000);
    let overlapping: String = (0..20_000).map(|i| line(f64::from(i) * 0.01, 0.0, 300.0, 0.0)).collect();
    let copies = circle(10.0, 10.0, 5.0).repeat(20_000);
    let nested: String = (1..=5_000).map(|i| circle(0.0, 0.0, f64::from(i) * 0.1)).collect();
    let crossing: String = (0..1_000)
        .map(|i| f64::from(i) * 0.5)
        .map(|d| line(d, 0.0, d, 500.0) + &line(0.0, d, 500.0, d))
        .collect();
    let dots = line(1.0, 1.0, 1.0, 1.0).repeat(50_000);
    let close: String =
        (0..20_000).map(|i| line(f64::from(i) * 1e-6, 0.0, f64::from(i) * 1e-6, 50.0)).collect();
    for (name, body) in [
        ("star", star),
        ("stacked", stacked),
        ("overlapping", overlapping),
        ("copies", copies),
        ("nested", nested),
        ("crossing", crossing),
        ("dots", dots),
        ("close", close),
    ] {
        let start = Instant::now();
        let (_, sheet) = intake(&document(4, "", &body)).unwrap_or_else(|e| panic!("{name}: {e}"));
        println!(
            "{name}: {} contours, {} findings, {:?}",
            sheet.contours.len(),
            sheet.findings.len(),
            start.elapsed()
        );
        assert!(sheet.findings.len() < 5_000, "{name}: {} findings listed", sheet.findings.len());
    }
}

#[test]
fn hostile_splines_terminate() {
    let spline = |degree: usize, points: &[(f64, f64)], knots: &[f64]| {
        let mut out = format!(
            "0\nSPLINE\n8\n0\n70\n8\n71\n{degree}\n72\n{}\n73\n{}\n74\n0\n",
            knots.len(),
            points.len()
        );
        knots.iter().for_each(|k| out += &format!("40\n{k:?}\n"));
        points.iter().for_each(|p| out += &format!("10\n{:?}\n20\n{:?}\n", p.0, p.1));
        out
    };
    let clamped = |degree: usize, n: usize| -> Vec<f64> {
        (0..n + degree + 1).map(|i| i.clamp(degree, n) as f64).collect()
    };
    let zigzag = |n: usize, height: f64| -> Vec<(f64, f64)> {
        (0..n).map(|i| (i as f64 * 1e-3, if i % 2 == 0 { height } else { -height })).collect()
    };
    for body in [
        spline(3, &zigzag(20_000, 1e5), &clamped(3, 20_000)),
        spline(15, &zigzag(2_000, 1e5), &clamped(15, 2_000)),
        spline(40, &zigzag(60, 10.0), &clamped(40, 60)),
        spline(3, &zigzag(8, 10.0), &[0.0; 12]),
        spline(3, &zigzag(8, 10.0), &[5.0, 4.0, 3.0, 2.0, 1.0, 0.0, -1.0, -2.0, -3.0, -4.0, -5.0, -6.0]),
        spline(3, &[(1.0, 1.0); 8], &clamped(3, 8)),
        spline(0, &zigzag(8, 10.0), &clamped(0, 8)),
        spline(3, &zigzag(3, 10.0), &clamped(3, 3)),
    ] {
        match intake(&document(4, "", &(body + &circle(50.0, 0.0, 5.0)))) {
            Err(e) => assert!(matches!(e, ReadError::Limit(_)), "{e}"),
            Ok((drawing, _)) => assert!(drawing.shapes.len() == 2 || !drawing.findings.is_empty(), "silent"),
        }
    }
}

/// A tenth of a second each, before: they were fitted first and found too far away then.
#[test]
fn curves_from_beyond_any_sheet_are_refused_at_once() {
    let mut body = circle(0.0, 0.0, 5.0);
    for i in 0..1_000 {
        let _ = write!(
            body,
            "0\nSPLINE\n8\n0\n70\n8\n71\n3\n72\n8\n73\n4\n74\n0\n40\n0.0\n40\n0.0\n40\n0.0\n40\n0.0\n40\n1.0\n40\n\
             1.0\n40\n1.0\n40\n1.0\n10\n{i}.0\n20\n0.0\n10\n3.7e20\n20\n5.0\n10\n10.0\n20\n0.0\n10\n20.0\n20\n5.0\n\
             0\nELLIPSE\n8\n0\n10\n{i}.0\n20\n0.0\n11\n1e20\n21\n3e19\n40\n0.5\n41\n0.0\n42\n3.0\n"
        );
    }
    let (drawing, _) = intake(&document(4, "", &body)).unwrap();
    assert_eq!(drawing.shapes.len(), 1);
    let told = drawing.findings.iter().filter(|f| f.message.contains("reaches farther than")).count();
    assert!(told >= 100, "{told} of 2,000 told one by one");
}
