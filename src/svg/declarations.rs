//! Declarations of CSS, in rules and in `style` attributes, and what are no declarations: comments.

use std::borrow::Cow;

/// A declaration such as `stroke: red`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Declaration<'s> {
    pub(super) name: &'s str,
    pub(super) value: &'s str,
    pub(super) important: bool,
}

/// The text of a style sheet or of a `style` attribute without its comments. Those in quotes are none.
pub(super) fn without_comments(text: &str) -> Cow<'_, str> {
    if !text.contains("/*") {
        return Cow::Borrowed(text);
    }
    let mut kept = String::with_capacity(text.len());
    let mut quote = None;
    let mut rest = text;
    while let Some(next) = rest.chars().next() {
        if let (None, Some(comment)) = (quote, rest.strip_prefix("/*")) {
            // A comment that does not end goes on to the end of the text.
            rest = comment.split_once("*/").map_or("", |(_, after)| after);
            continue;
        }
        quote = match (quote, next) {
            (None, '"' | '\'') => Some(next),
            // A line break ends a text in quotes, as in browsers.
            (Some(_), '\n') => None,
            (Some(open), _) if open == next => None,
            (open, _) => open,
        };
        kept.push(next);
        rest = rest.get(next.len_utf8()..).unwrap_or_default();
    }
    Cow::Owned(kept)
}

/// The declarations of a text without braces and comments, in order.
pub(super) fn declarations(text: &str) -> impl Iterator<Item = Declaration<'_>> {
    text.split(';').filter_map(|part| {
        let (name, value) = part.split_once(':')?;
        let value = value.trim();
        let (value, important) = match value.rsplit_once('!') {
            Some((before, word)) if word.trim().eq_ignore_ascii_case("important") => {
                (before.trim_end(), true)
            }
            _ => (value, false),
        };
        Some(Declaration { name: name.trim(), value, important })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A comment took away all that came before it.
    #[test]
    fn comments_take_nothing_else_away() {
        for (text, kept) in [
            ("a{x:1;/* b */y:2}", "a{x:1;y:2}"),
            (".a /* b */, .c /* d */{x:1}", ".a , .c {x:1}"),
            ("/* a{b:c} */ .a{x:1}", " .a{x:1}"),
            ("/***/a/*/b*/c", "ac"),
            ("a{x:'/*'; y:\"*/\"}", "a{x:'/*'; y:\"*/\"}"),
            ("a /* b", "a "),
            ("\u{e4}/*\u{f6}*/\u{fc}", "\u{e4}\u{fc}"),
        ] {
            assert_eq!(without_comments(text), kept, "{text}");
        }
    }

    #[test]
    fn declarations_with_importance() {
        let found: Vec<_> = declarations("stroke:red; fill: #00F !important;;bad; x:")
            .map(|d| (d.name, d.value, d.important))
            .collect();
        assert_eq!(found, [("stroke", "red", false), ("fill", "#00F", true), ("x", "", false)]);
    }
}
