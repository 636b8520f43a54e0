//! The tokens of Rust sources, as far as paths of names need them.

pub(super) fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
}

/// Names, `::`, and single signs; comments, strings and numbers apart.
pub(super) fn tokens(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let mut length = first.len_utf8();
        if rest.starts_with("//") {
            length = rest.find('\n').unwrap_or(rest.len());
        } else if rest.starts_with("/*") {
            length = rest.find("*/").map_or(rest.len(), |e| e + 2);
        } else if let Some(raw) = raw_string(rest) {
            length = raw;
        } else if first == '"' || rest.starts_with("b\"") {
            length = string(rest);
        } else if first == '\'' {
            length = character(rest);
        } else if first.is_ascii_alphanumeric() || first == '_' {
            length = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
            if !first.is_ascii_digit() {
                found.push(rest[..length].to_owned());
            }
        } else if rest.starts_with("::") {
            length = 2;
            found.push("::".to_owned());
        } else if !first.is_whitespace() {
            found.push(first.to_string());
        }
        rest = &rest[length..];
    }
    found
}

fn raw_string(rest: &str) -> Option<usize> {
    let start = rest.strip_prefix("br").or_else(|| rest.strip_prefix('r'))?;
    let hashes = start.len() - start.trim_start_matches('#').len();
    let body = start[hashes..].strip_prefix('"')?;
    let end = body.find(&format!("\"{}", "#".repeat(hashes)))?;
    Some(rest.len() - body.len() + end + 1 + hashes)
}

fn string(rest: &str) -> usize {
    let start = rest.find('"').unwrap_or(0) + 1;
    let mut escaped = false;
    for (k, c) in rest[start..].char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return start + k + 1,
            _ => {}
        }
    }
    rest.len()
}

/// A character in quotes, or the quote of a lifetime.
fn character(rest: &str) -> usize {
    let mut chars = rest.char_indices().skip(1);
    match (chars.next(), chars.next(), chars.next()) {
        (Some((_, '\\')), _, _) => rest[3..].find('\'').map_or(1, |k| k + 4),
        (_, Some((k, '\'')), _) => k + 1,
        _ => 1,
    }
}
