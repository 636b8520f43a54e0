//! Recognises an SVG file by its content.

use super::text;

/// How far the root element may be from the start of a file. Before it are declarations and comments.
const HEAD: usize = 262_144;

/// Whether these bytes are an SVG file, in UTF-8 or UTF-16: markup whose first element is `svg`.
pub fn is_svg(bytes: &[u8]) -> bool {
    let head = bytes.get(..HEAD).unwrap_or(bytes);
    let ascii: Vec<u8> = match text::utf_16(head) {
        // The names of the markup are ASCII, of which UTF-16 has every other byte.
        Some(_) => head.iter().copied().filter(|b| *b != 0 && *b < 0xFE).collect(),
        None => head.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(head).to_vec(),
    };
    let mut rest = ascii.trim_ascii_start();
    loop {
        let end: &[u8] = match rest {
            _ if rest.starts_with(b"<!--") => b"-->",
            _ if rest.starts_with(b"<?") => b"?>",
            _ if rest.starts_with(b"<!") => {
                rest = after_doctype(rest).trim_ascii_start();
                continue;
            }
            _ => break,
        };
        let Some(at) = rest.windows(end.len()).position(|w| w == end) else { return false };
        rest = rest.get(at + end.len()..).unwrap_or_default().trim_ascii_start();
    }
    let Some(name) = rest.strip_prefix(b"<") else { return false };
    let length =
        name.iter().position(|b| b.is_ascii_whitespace() || matches!(b, b'>' | b'/')).unwrap_or(name.len());
    let name = name.get(..length).unwrap_or_default();
    name.rsplit(|b| *b == b':').next() == Some(b"svg")
}

/// What follows a document type declaration, whose own declarations are in square brackets.
fn after_doctype(text: &[u8]) -> &[u8] {
    let mut in_brackets = false;
    for (at, byte) in text.iter().enumerate() {
        match byte {
            b'[' => in_brackets = true,
            b']' => in_brackets = false,
            b'>' if !in_brackets => return text.get(at + 1..).unwrap_or_default(),
            _ => {}
        }
    }
    &[]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn svg_is_known_by_its_first_element() {
        let doctype = "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"x.dtd\" [ <!ENTITY a \"b>\"> ]>";
        let utf_16: Vec<u8> = "\u{feff}<svg/>".encode_utf16().flat_map(u16::to_le_bytes).collect();
        for svg in [
            "<svg/>",
            "\u{feff}<?xml version='1.0'?>\n<!-- <html> -->\n<svg xmlns='x'>",
            &format!("<?xml version='1.0'?>{doctype}<svg:svg xmlns:svg='x'/>"),
        ] {
            assert!(is_svg(svg.as_bytes()), "{svg}");
        }
        assert!(is_svg(&utf_16));
        for other in [
            "<html><svg/></html>",
            "<!-- <svg> -->",
            "svg",
            "",
            "<",
            "<!DOCTYPE html><html>",
            "<svgz/>",
            "0\nSECTION",
        ] {
            assert!(!is_svg(other.as_bytes()), "{other}");
        }
    }
}
