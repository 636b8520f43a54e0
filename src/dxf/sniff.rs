//! Recognises files that are not DXF: a sentence names the format and says what to do.

/// The sentence for a file of another format; `None` when it may be a DXF.
pub(super) fn other_format(bytes: &[u8]) -> Option<&'static str> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let text = bytes.trim_ascii_start();
    if text.is_empty() {
        return Some("The file is empty. Save the drawing again as DXF.");
    }
    let is_dwg = bytes.starts_with(b"AC10") || bytes.starts_with(b"AC1.") || bytes.starts_with(b"AC2.");
    if is_dwg && bytes.get(6).is_some_and(|b| *b < 0x20) {
        return Some("This is a DWG file. Save it as DXF (R2000 or later, ASCII).");
    }
    const SIGNATURES: [(&[u8], &str); 19] = [
        (b"%PDF", "This is a PDF file. Open it in a drawing program and save it as DXF."),
        (
            b"\x89PNG",
            "This is a PNG picture. A laser needs lines: trace it in a drawing program and save it as DXF.",
        ),
        (
            b"\xFF\xD8\xFF",
            "This is a JPEG picture. A laser needs lines: trace it in a drawing program and save it as DXF.",
        ),
        (
            b"GIF8",
            "This is a GIF picture. A laser needs lines: trace it in a drawing program and save it as DXF.",
        ),
        (
            b"BM",
            "This is a BMP picture. A laser needs lines: trace it in a drawing program and save it as DXF.",
        ),
        (b"RIFF", "This is a WebP picture or a recording, not a drawing. Save the drawing as DXF."),
        (
            b"PK\x03\x04",
            "This is a ZIP archive (or a document made of one). Unpack it and use the DXF file in it.",
        ),
        (b"\x1F\x8B", "This is a gzip archive. Unpack it and use the DXF file in it."),
        (b"Rar!", "This is a RAR archive. Unpack it and use the DXF file in it."),
        (b"7z\xBC\xAF", "This is a 7z archive. Unpack it and use the DXF file in it."),
        (b"AutoCAD DXB", "This is a DXB file. Save it as DXF (R2000 or later, ASCII)."),
        (b"ISO-10303-21", "This is a STEP file, a solid. Save the flat outline (flat pattern) as DXF."),
        (b"%!PS", "This is a PostScript, EPS or Illustrator file. Save it as DXF."),
        (
            b"\xD0\xCF\x11\xE0",
            "This is an Office or CAD document of another program. Save the drawing as DXF.",
        ),
        (b"{\\rtf", "This is a text document. Save the drawing as DXF."),
        (b"solid ", "This is an STL file, a solid. Save the flat outline as DXF."),
        (b"\x7FELF", "This is a program, not a drawing."),
        (b"MZ", "This is a program, not a drawing."),
        (b"LightBurn", "This is a LightBurn project. Export it as DXF."),
    ];
    if let Some((_, sentence)) = SIGNATURES.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return Some(sentence);
    }
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        return Some("This is text in UTF-16. Save the drawing again as DXF (ASCII or UTF-8).");
    }
    if text.first() == Some(&b'<') {
        return Some(markup(text));
    }
    if matches!(text.first(), Some(b'{' | b'[')) {
        return Some("This is a JSON file. Save the drawing as DXF.");
    }
    is_gcode(text)
        .then_some("This is G-code, a program for a machine. Use the drawing it was made from, as DXF.")
}

fn markup(text: &[u8]) -> &'static str {
    // An XML file may start with declarations and comments; they fit in a kilobyte.
    let start = text.get(..1024).unwrap_or(text);
    let holds = |word: &[u8]| start.windows(word.len()).any(|w| w.eq_ignore_ascii_case(word));
    if holds(b"<svg") {
        "This is an SVG file. Open it in a drawing program and save it as DXF."
    } else if holds(b"<html") || holds(b"<!doctype html") {
        "This is a web page, perhaps an error page in place of the download. Download the DXF file again."
    } else if holds(b"LightBurnProject") {
        "This is a LightBurn project. Export it as DXF."
    } else {
        "This is an XML file. Save the drawing as DXF."
    }
}

/// Whether the first lines that are not comments consist of words such as `G21`, `M3 S1000`, `N10 G0 X0`.
fn is_gcode(text: &[u8]) -> bool {
    let lines = text.split(|b| matches!(b, b'\n' | b'\r')).map(<[u8]>::trim_ascii);
    let mut words = 0;
    for line in lines.filter(|l| !matches!(l.first(), None | Some(b';' | b'(' | b'%'))).take(4) {
        let digit = line.get(1).is_some_and(u8::is_ascii_digit);
        if !(digit && line.first().is_some_and(|b| b"GMNTFSgmntfs".contains(b))) {
            return false;
        }
        words += 1;
    }
    words > 0
}
