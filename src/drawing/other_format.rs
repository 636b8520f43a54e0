//! Recognises files that are neither DXF nor SVG: a sentence names the format and says how to get a drawing from the program
//! that usually makes it.

/// The sentence for a file of another format; `None` when it may be a drawing.
pub(crate) fn other_format(bytes: &[u8]) -> Option<&'static str> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let text = bytes.trim_ascii_start();
    if text.is_empty() {
        return Some("The file is empty. Save the drawing again as DXF or SVG.");
    }
    let is_dwg = bytes.starts_with(b"AC10") || bytes.starts_with(b"AC1.") || bytes.starts_with(b"AC2.");
    if is_dwg && bytes.get(6).is_some_and(|b| *b < 0x20) {
        return Some(
            "This is a DWG file. In AutoCAD, use Save As and choose DXF (R2000 or later, ASCII); without it, the free ODA File Converter makes a DXF.",
        );
    }
    if bytes.starts_with(b"%PDF") || bytes.starts_with(b"%!PS") {
        return Some(page(bytes));
    }
    if bytes.starts_with(b"RIFF") && bytes.get(8..11) == Some(b"CDR") {
        return Some("This is a CorelDRAW file. In CorelDRAW, use File, Export and choose SVG or DXF.");
    }
    const SIGNATURES: [(&[u8], &str); 18] = [
        (
            b"\x89PNG",
            "This is a PNG picture. A laser needs lines: trace it in a drawing program (Inkscape: Path, Trace Bitmap) and save it as SVG or DXF.",
        ),
        (
            b"\xFF\xD8\xFF",
            "This is a JPEG picture. A laser needs lines: trace it in a drawing program (Inkscape: Path, Trace Bitmap) and save it as SVG or DXF.",
        ),
        (
            b"GIF8",
            "This is a GIF picture. A laser needs lines: trace it in a drawing program (Inkscape: Path, Trace Bitmap) and save it as SVG or DXF.",
        ),
        (
            b"BM",
            "This is a BMP picture. A laser needs lines: trace it in a drawing program (Inkscape: Path, Trace Bitmap) and save it as SVG or DXF.",
        ),
        (b"RIFF", "This is a WebP picture or a recording, not a drawing. Save the drawing as DXF or SVG."),
        (
            b"PK\x03\x04",
            "This is a ZIP archive (or a document made of one). Unpack it and use the DXF or SVG file in it.",
        ),
        (
            b"\x1F\x8B",
            "This is a gzip archive, perhaps a compressed SVG (.svgz). Unpack it, or save the drawing as plain SVG.",
        ),
        (b"Rar!", "This is a RAR archive. Unpack it and use the DXF or SVG file in it."),
        (b"7z\xBC\xAF", "This is a 7z archive. Unpack it and use the DXF or SVG file in it."),
        (
            b"AutoCAD DXB",
            "This is a DXB file. In AutoCAD, use Save As and choose DXF (R2000 or later, ASCII).",
        ),
        (
            b"ISO-10303-21",
            "This is a STEP file, a solid. In the CAD program (Fusion, SolidWorks, FreeCAD), export its flat pattern or one of its faces as DXF.",
        ),
        (b"\xC5\xD0\xD3\xC6", EPS),
        (
            b"\xD0\xCF\x11\xE0",
            "This is an Office or CAD document of another program. Save the drawing as DXF or SVG.",
        ),
        (b"{\\rtf", "This is a text document. Save the drawing as DXF or SVG."),
        (
            b"solid ",
            "This is an STL file, a solid. In the CAD program, export one of its faces as DXF or SVG.",
        ),
        (b"\x7FELF", "This is a program, not a drawing."),
        (b"MZ", "This is a program, not a drawing."),
        (b"LightBurn", "This is a LightBurn project. In LightBurn, use File, Export and choose DXF or SVG."),
    ];
    if let Some((_, sentence)) = SIGNATURES.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return Some(sentence);
    }
    // Without a byte order mark, every other byte of ASCII text is zero.
    let is_unmarked = matches!(bytes, [0, a, 0, b, ..] | [a, 0, b, 0, ..] if a.is_ascii() && b.is_ascii() && *a.min(b) >= b'\t');
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") || is_unmarked {
        return Some("This is text in UTF-16. Save the drawing again as DXF (ASCII or UTF-8) or SVG.");
    }
    if text.first() == Some(&b'<') {
        return Some(markup(text));
    }
    if matches!(text.first(), Some(b'{' | b'[')) {
        return Some("This is a JSON file. Save the drawing as DXF or SVG.");
    }
    is_gcode(text).then_some(
        "This is G-code, a program for a machine. Use the drawing it was made from, as DXF or SVG.",
    )
}

fn markup(text: &[u8]) -> &'static str {
    // An XML file may start with declarations and comments; they fit in a kilobyte.
    let start = text.get(..1024).unwrap_or(text);
    let holds = |word: &[u8]| start.windows(word.len()).any(|w| w.eq_ignore_ascii_case(word));
    if holds(b"<html") || holds(b"<!doctype html") {
        "This is a web page, perhaps an error page in place of the download. Download the drawing again."
    } else if holds(b"LightBurnProject") {
        "This is a LightBurn project. In LightBurn, use File, Export and choose DXF or SVG."
    } else if holds(b"<svg") {
        "This is an SVG file, not a DXF."
    } else {
        "This is an XML file, but not an SVG. Save the drawing as DXF or SVG."
    }
}

const EPS: &str = "This is a PostScript or EPS file. Open it in Inkscape or Illustrator and save it as SVG or DXF; a CAD program exports DXF directly.";

/// A PDF, PostScript or Illustrator file. Illustrator names itself near the start of its files, which are PDF or PostScript.
fn page(bytes: &[u8]) -> &'static str {
    const HEAD: usize = 65_536;
    let start = bytes.get(..HEAD).unwrap_or(bytes);
    let holds = |word: &[u8]| start.windows(word.len()).any(|w| w == word);
    if holds(b"Adobe Illustrator") || holds(b"/Illustrator") {
        "This is an Illustrator file. In Illustrator, use File, Export As and choose SVG or DXF."
    } else if bytes.starts_with(b"%PDF") {
        "This is a PDF file. Open it in Inkscape or Illustrator and save it as SVG or DXF; a CAD program exports DXF directly."
    } else {
        EPS
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
