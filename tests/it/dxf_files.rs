//! Files as they are: line ends, numbers, encodings, binary, missing parts, damage, other formats.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::testkit::drawings::{file, found, lines, read, shapes};
use kerfway::drawing::{Drawing, ReadError, ReadOptions};
use kerfway::finding::Code;

pub(super) const LINE: &str = "0 LINE 5 1A 8 CUT 10 0 20 0 11 30 21 40";

const CIRCLE: &str = "0 CIRCLE 5 1B 8 CUT 10 0 20 0 40 10";

fn bytes(bytes: &[u8]) -> Result<Drawing, ReadError> {
    kerfway::dxf::read(bytes, &ReadOptions::default())
}

fn codes(drawing: &Drawing) -> Vec<Code> {
    drawing.findings.iter().map(|f| f.code).collect()
}

#[test]
fn every_line_end_reads_the_same() {
    let text = file("", &format!("{LINE} {CIRCLE}"));
    let plain = read(&text).unwrap();
    assert_eq!(shapes(&plain), [("LINE", 50.0), ("CIRCLE", std::f64::consts::TAU * 10.0)]);
    for end in ["\r\n", "\r", "\r\r\n", "\n\n", "\r\n\r\n", " \n"] {
        let other = read(&text.replace('\n', end)).unwrap();
        assert_eq!(other.shapes, plain.shapes, "{end:?}");
        assert_eq!(codes(&other), codes(&plain), "{end:?}");
    }
    let marked = [b"\xEF\xBB\xBF", text.as_bytes(), b"\x1A"].concat();
    assert_eq!(bytes(&marked).unwrap().shapes, plain.shapes);
}

#[test]
fn blank_lines_and_comments_between_groups_are_skipped() {
    let text = file("", LINE)
        .replace("10\n0\n", "\n999\nmade by hand\n\n10\n0\n")
        .replace("8\nCUT\n", "8\nCUT\n\n\n");
    let drawing = read(&text).unwrap();
    assert_eq!(shapes(&drawing), [("LINE", 50.0)]);
    assert!(drawing.findings.is_empty(), "{:?}", drawing.findings);
}

/// A comment before the name of a section hid the name, and entities of unknown kinds got no finding.
#[test]
fn a_comment_before_the_name_of_a_section_does_not_hide_it() {
    let text = file("", &format!("{LINE} 0 SPECIAL 8 CUT 10 5 20 6"));
    let commented = text.replace("SECTION\n", "SECTION\n999\nmade by hand\n");
    let (plain, read) = (read(&text).unwrap(), read(&commented).unwrap());
    assert_eq!((&read.shapes, codes(&read)), (&plain.shapes, codes(&plain)));
    assert!(codes(&read).contains(&Code::UnsupportedEntity));
}

#[test]
fn empty_text_is_a_value() {
    let drawing = read(&file("", LINE).replace("8\nCUT\n", "1\n\n8\nCUT\n")).unwrap();
    assert_eq!(shapes(&drawing), [("LINE", 50.0)]);
    assert!(drawing.findings.is_empty());
}

#[test]
fn numbers_as_programs_write_them() {
    let drawing =
        read(&file("", "0 LINE 8 0 10 0,0 20 +0 11 3.0D1 21 4.0E").replace("4.0E\n", "4.0E 01\n")).unwrap();
    assert_eq!(shapes(&drawing), [("LINE", 50.0)]);
}

#[test]
fn header_sections_and_end_may_be_missing() {
    let bare = lines(LINE);
    let drawing = read(&bare).unwrap();
    assert_eq!(shapes(&drawing), [("LINE", 50.0)]);
    assert_eq!(drawing.version, None);
    assert_eq!(codes(&drawing), [Code::UnitsGuessed, Code::Truncated]);
    let no_endsec = lines(&format!("0 SECTION 2 ENTITIES {LINE} 0 EOF"));
    assert_eq!(shapes(&read(&no_endsec).unwrap()), [("LINE", 50.0)]);
    let no_eof = lines(&format!("0 SECTION 2 ENTITIES {LINE} {CIRCLE} 0 ENDSEC"));
    assert_eq!(read(&no_eof).unwrap().shapes.len(), 2);
}

#[test]
fn other_sections_are_skipped() {
    let text = lines(&format!(
        "0 SECTION 2 CLASSES 0 CLASS 1 X 0 ENDSEC 0 SECTION 2 ENTITIES {LINE} 0 ENDSEC \
         0 SECTION 2 OBJECTS 0 DICTIONARY 5 C {CIRCLE} 0 ENDSEC 0 SECTION 2 THUMBNAILIMAGE 90 5 310 0011 0 ENDSEC 0 EOF"
    ));
    assert_eq!(shapes(&read(&text).unwrap()), [("LINE", 50.0)]);
}

#[test]
fn names_are_decoded_by_code_page_or_as_utf8() {
    let named = |version: &str, page: &str, name: &[u8]| {
        let head = lines(&format!(
            "0 SECTION 2 HEADER 9 $ACADVER 1 {version} 9 $DWGCODEPAGE 3 {page} 0 ENDSEC 0 SECTION 2 ENTITIES"
        ));
        let mut text = head.into_bytes();
        text.extend(b"0\nLINE\n8\n");
        text.extend(name);
        text.extend(b"\n10\n0\n20\n0\n11\n300\n21\n0\n0\nENDSEC\n0\nEOF\n");
        let drawing = bytes(&text).unwrap();
        drawing.layers[drawing.shapes[0].layer as usize].name.clone()
    };
    assert_eq!(named("AC1015", "ANSI_1252", b"Fl\xE4che"), "Fläche");
    assert_eq!(named("AC1009", "dos437", b"Fl\x84che"), "Fläche");
    assert_eq!(named("AC1009", "DOS850", b"\x9Cber"), "£ber");
    assert_eq!(named("AC1015", "ANSI_1251", b"\xD0\xE5\xE7"), "Рез");
    assert_eq!(named("AC1015", "ANSI_932", b"\x83J\x83b\x83g"), "カット");
    assert_eq!(named("AC1018", "ANSI_936", b"\xC7\xD0\xB8\xEE"), "切割");
    assert_eq!(named("AC1021", "ANSI_1252", "Fläche".as_bytes()), "Fläche");
    // Said to be Western, written in UTF-8.
    assert_eq!(named("AC1009", "ANSI_1252", "Рез".as_bytes()), "Рез");
    assert_eq!(named("AC1015", "ANSI_1252", b"\\U+30AB\\U+30C3"), "カッ");
    assert_eq!(named("AC1015", "ANSI_1252", b"\\M+1834A"), "カ");
    assert_eq!(named("AC1015", "ANSI_1252", b"a\\U+12"), "a\\U+12");
}

#[test]
fn text_that_is_not_in_its_encoding_is_a_finding() {
    let mut text =
        lines("0 SECTION 2 HEADER 9 $ACADVER 1 AC1027 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 ENTITIES")
            .into_bytes();
    text.extend(b"0\nLINE\n8\nFl\xE4che\n10\n0\n20\n0\n11\n300\n21\n0\n0\nENDSEC\n0\nEOF\n");
    let drawing = bytes(&text).unwrap();
    assert_eq!(drawing.layers[drawing.shapes[0].layer as usize].name, "Fläche");
    assert_eq!(codes(&drawing), [Code::Encoding]);
}

/// The groups of a file in binary, with codes of one or two bytes.
fn binary(words: &str, wide: bool) -> Vec<u8> {
    let mut out = b"AutoCAD Binary DXF\r\n\x1A\0".to_vec();
    let words: Vec<&str> = words.split_whitespace().collect();
    for pair in words.chunks(2) {
        let code: u16 = pair[0].parse().unwrap();
        match (wide, u8::try_from(code)) {
            (false, Ok(short)) if short < 255 => out.push(short),
            (false, _) => {
                out.push(255);
                out.extend(code.to_le_bytes());
            }
            (true, _) => out.extend(code.to_le_bytes()),
        }
        match code {
            10..=59 | 210..=239 | 1010..=1059 => out.extend(pair[1].parse::<f64>().unwrap().to_le_bytes()),
            60..=79 | 1070 => out.extend(pair[1].parse::<i16>().unwrap().to_le_bytes()),
            90..=99 | 1071 => out.extend(pair[1].parse::<i32>().unwrap().to_le_bytes()),
            _ => {
                out.extend(pair[1].bytes());
                out.push(0);
            }
        }
    }
    out
}

#[test]
fn binary_with_short_and_long_group_codes() {
    let words = format!(
        "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 ENTITIES {LINE} 1001 ACAD 1071 70000 \
         0 LWPOLYLINE 8 0 90 2 70 1 10 0 20 0 42 1 10 10 20 0 42 1 0 ENDSEC 0 EOF"
    );
    let text = read(&lines(&words)).unwrap();
    for wide in [false, true] {
        let drawing = bytes(&binary(&words, wide)).unwrap();
        assert_eq!(drawing.shapes, text.shapes, "wide: {wide}");
        assert!(drawing.findings.is_empty(), "{:?}", drawing.findings);
    }
}

#[test]
fn binary_resynchronises_and_reports_the_position() {
    let mut file = binary(&format!("0 SECTION 2 ENTITIES {LINE} {CIRCLE} 0 ENDSEC 0 EOF"), true);
    // The code of the x of the circle becomes one that does not exist.
    let at = file.windows(7).position(|w| w == b"CIRCLE\0").unwrap();
    let x = file.windows(2).skip(at).position(|w| w == [10, 0]).unwrap() + at;
    file[x] = 200;
    file.extend(b"");
    let drawing = bytes(&file).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(shapes(&drawing), [("LINE", 50.0)]);
    assert!(found(&drawing, Code::Resynchronised).message.contains(&format!("byte {x}")));
    assert_eq!(found(&drawing, Code::DamagedEntity).handle.as_deref(), Some("1B"));
}

#[test]
fn damaged_entities_are_marked_and_skipped_by_default() {
    let text = file("", &format!("{LINE} {CIRCLE} 0 LINE 8 CUT 10 0 20 0 11 7 21 0"));
    // Each of these harms the circle, and nothing but the circle.
    for (from, to) in [
        ("1B\n8\nCUT\n10\n0\n20\n", "1B\n8\nCUT\n10\n0\n"),
        ("1B\n8\nCUT\n10\n", "1B\n8\nCUT\n10\n10\n"),
        ("1B\n8\nCUT\n10\n0\n", "1B\n8\nCUT\n0\n10\n"),
        ("40\n10\n", "40\n1O\n"),
        ("40\n10\n", "40\nNaN\n"),
        ("40\n10\n", "40\n10\nstray words here\n"),
        ("40\n10\n", "40\n10\n<<<<<<< HEAD\n40\n11\n=======\n40\n12\n>>>>>>> theirs\n"),
    ] {
        let broken = text.replacen(from, to, 1);
        assert_ne!(broken, text);
        let drawing = read(&broken).unwrap();
        assert_eq!(shapes(&drawing), [("LINE", 50.0), ("LINE", 7.0)], "{to:?}: {:#?}", drawing.findings);
        let damaged = found(&drawing, Code::DamagedEntity);
        assert_eq!(
            (damaged.handle.as_deref(), damaged.layer.as_deref(), damaged.count),
            (Some("1B"), Some("CUT"), 1)
        );
    }
    let broken = text.replacen("40\n10\n", "40\n10\nstray words here\n", 1);
    let keep = ReadOptions { keep_damaged: true, ..ReadOptions::default() };
    let kept = kerfway::dxf::read(broken.as_bytes(), &keep).unwrap();
    assert_eq!(kept.shapes.iter().map(|s| s.damaged).collect::<Vec<_>>(), [false, true, false]);
}

#[test]
fn lost_step_names_the_line() {
    let text = file("", &format!("{LINE} {CIRCLE}"));
    // The group code of the circle's y is lost: its value is where a group code should be.
    let broken = text.replacen("20\n0\n40", "0\n40", 1);
    // CIRCLE is line i + 1; after it 5, 1B, 8, CUT, 10, 0 and the lone value.
    let line = broken.lines().position(|l| l == "CIRCLE").unwrap() + 8;
    let drawing = read(&broken).unwrap();
    assert_eq!(shapes(&drawing), [("LINE", 50.0)]);
    let message = &found(&drawing, Code::Resynchronised).message;
    assert!(message.contains(&format!("near line {line}:")), "{line}: {message}");
}

#[test]
fn a_lost_start_of_an_entity_changes_no_other_one_silently() {
    let text = file("", &format!("{LINE} {CIRCLE} 0 LINE 8 CUT 10 0 20 0 11 7 21 0"));
    // "0 CIRCLE" is lost altogether: the line runs on into the circle's groups.
    let drawing = read(&text.replacen("0\nCIRCLE\n", "", 1)).unwrap();
    assert_eq!(shapes(&drawing), [("LINE", 7.0)]);
    assert_eq!(found(&drawing, Code::DamagedEntity).handle.as_deref(), Some("1A"));
}

#[test]
fn merge_conflict_between_entities_changes_neither() {
    let text = file("", &format!("{LINE} {CIRCLE}"));
    let broken = text.replacen("0\nCIRCLE\n", "<<<<<<< HEAD\n0\nCIRCLE\n", 1);
    let drawing = read(&broken).unwrap();
    assert_eq!(drawing.shapes.len(), 2);
    assert!(found(&drawing, Code::Resynchronised).message.contains("merge conflict"));
}

#[test]
fn truncated_in_the_middle_keeps_what_came_before() {
    let text = file("", &format!("{LINE} {CIRCLE}"));
    let cut = text.find("40\n10\n").unwrap();
    let drawing = read(&text[..cut]).unwrap();
    assert_eq!(shapes(&drawing), [("LINE", 50.0)]);
    assert_eq!(found(&drawing, Code::DamagedEntity).handle.as_deref(), Some("1B"));
    assert_eq!(found(&drawing, Code::Truncated).count, 1);
    let nothing = read(&text[..40]).unwrap_err();
    assert!(
        matches!(nothing, ReadError::Empty(_)) && nothing.to_string().contains("not copied whole"),
        "{nothing}"
    );
}

#[test]
fn other_formats_are_named_with_advice() {
    for (start, name) in [
        (&b"AC1032\0\0\0\0\0"[..], "DWG"),
        (b"%PDF-1.7\n", "PDF"),
        (b"\x89PNG\r\n\x1A\n", "PNG"),
        (b"\xFF\xD8\xFF\xE0", "JPEG"),
        (b"<?xml version=\"1.0\"?>\n<!-- x -->\n<svg xmlns=\"http://www.w3.org/2000/svg\"/>", "SVG"),
        (b"<!DOCTYPE html><html>", "web page"),
        (b"PK\x03\x04", "ZIP"),
        (b"ISO-10303-21;\nHEADER;", "STEP"),
        (b"; made by x\nG21\nG90\nM4 S0\nG0 X1 Y2\n", "G-code"),
        (b"%!PS-Adobe-3.0", "PostScript"),
        (b"\xFF\xFE0\0\n\0", "UTF-16"),
        (b"0\0\r\0\n\0S\0E\0", "UTF-16"),
        (b"\0 \0 \x000\0\n\0S\0E", "UTF-16"),
        (b"solid part\nfacet normal", "STL"),
        (b"", "empty"),
        (b" \r\n\r\n", "empty"),
        (b"Dear reader,\nthis is a letter.\nYours\n", "neither a DXF"),
        (b"0\n", "neither a DXF"),
        (b"\0\0\0\0\0\0\0\0", "neither a DXF"),
    ] {
        match bytes(start) {
            Err(ReadError::NotADrawing(sentence)) => {
                assert!(sentence.contains(name), "{sentence}");
                assert!(sentence.ends_with('.'));
            }
            other => panic!("{name}: {other:?}"),
        }
    }
}

#[test]
fn a_misspelt_section_is_read_and_reported() {
    let text =
        file("0 BLOCK 2 B 10 0 20 0 0 LINE 8 0 10 0 20 0 11 300 21 400 0 ENDBLK", "0 INSERT 2 B 10 0 20 0");
    let sound = read(&text).unwrap();
    assert_eq!(shapes(&sound), [("LINE", 500.0)]);
    for (name, right) in [("HEADER", 1), ("BLOCKS", 2), ("ENTITIES", 3)] {
        let wrong = text.replace(&format!("SECTION\n2\n{name}"), &format!("SUCTION\n2\n{name}"));
        let drawing = read(&wrong).unwrap();
        assert_eq!((shapes(&drawing), &drawing.units), (shapes(&sound), &sound.units), "section {right}");
        let [finding] = &drawing.findings[..] else { panic!("{:?}", drawing.findings) };
        assert_eq!(finding.code, Code::Resynchronised);
        assert!(finding.message.starts_with("The word SUCTION is in the place of SECTION"), "{finding:?}");
    }
}

#[test]
fn junk_is_refused_by_its_first_megabyte_and_long_comments_before_a_drawing_are_not_junk() {
    const MEGABYTE: usize = 1 << 20;
    for junk in ["a", "0\nJUNK\n", "999\nno drawing\n"] {
        match bytes(&junk.as_bytes().repeat(3 * MEGABYTE / junk.len())) {
            Err(ReadError::NotADrawing(sentence)) => {
                assert!(sentence.starts_with("This is neither"), "{sentence}")
            }
            other => panic!("{junk}: {other:?}"),
        }
    }
    let text = file("", LINE);
    let comment = "999\na line of a long comment\n";
    let commented = comment.repeat(MEGABYTE / 2 / comment.len()) + &text;
    assert_eq!(shapes(&read(&commented).unwrap()), [("LINE", 50.0)]);
    let long = text.clone() + &comment.repeat(2 * MEGABYTE / comment.len());
    assert_eq!(shapes(&read(&long).unwrap()), [("LINE", 50.0)], "a large file is read whole");
}
