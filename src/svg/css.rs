//! Style sheets: which declarations hold for an element.
//!
//! Selectors of type, class and id, their combinations, and ancestors (`g .cut`, `g > path`) are understood, which is what
//! drawing programs write. Other rules are counted, so that a finding can report them.

use super::custom::Custom;
use super::declarations::{Declaration, declarations};
use super::steps::Steps;
use super::xml::Document;
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// Largest number of rules that are read. Illustrator writes one for each style, some hundreds at most.
const MOST_RULES: usize = 20_000;

/// One element of a selector: `path.cut#a`.
#[derive(Debug, Default, PartialEq)]
struct Compound<'s> {
    tag: Option<&'s str>,
    id: Option<&'s str>,
    classes: Vec<&'s str>,
    /// Whether it must be the parent of the compound after it, and not any ancestor.
    is_parent: bool,
    /// Whether it must be the outermost element: `:root`.
    is_root: bool,
}

impl<'s> Compound<'s> {
    /// Reads a compound; `None` if it has anything else.
    fn read(text: &'s str) -> Option<Self> {
        let mut compound = Self { is_root: text == ":root", ..Self::default() };
        if compound.is_root {
            return Some(compound);
        }
        let mut rest = text;
        let first = rest.find(['.', '#']).unwrap_or(rest.len());
        let (tag, after) = rest.split_at(first);
        if tag != "*" && !tag.is_empty() {
            compound.tag = Some(tag).filter(|t| is_name(t));
            compound.tag?;
        }
        rest = after;
        while let Some(kind) = rest.chars().next() {
            rest = rest.get(1..)?;
            let end = rest.find(['.', '#']).unwrap_or(rest.len());
            let (name, after) = rest.split_at(end);
            if !is_name(name) {
                return None;
            }
            match kind {
                '.' => compound.classes.push(name),
                _ => compound.id = Some(name),
            }
            rest = after;
        }
        Some(compound)
    }

    fn matches(&self, document: &Document<'_>, element: u32, steps: &mut Steps) -> bool {
        let class = document.attribute(element, "class").unwrap_or_default();
        let classes = || class.split_ascii_whitespace();
        steps.take(1 + class.len() * self.classes.len());
        (!self.is_root || element == 0)
            && self.tag.is_none_or(|t| document.name(element) == t)
            && self.id.is_none_or(|id| document.attribute(element, "id") == Some(id))
            && self.classes.iter().all(|c| classes().any(|own| own == *c))
    }
}

fn is_name(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'-' || b == b'_' || b >= 0x80)
}

/// A selector with its declarations.
#[derive(Debug)]
struct Rule<'s> {
    /// From the outermost ancestor to the element itself.
    compounds: Vec<Compound<'s>>,
    /// Numbers of ids, of classes and of types.
    specificity: [usize; 3],
    declarations: &'s str,
}

impl Rule<'_> {
    fn matches(&self, document: &Document<'_>, element: u32, steps: &mut Steps) -> bool {
        let Some((last, ancestors)) = self.compounds.split_last() else { return false };
        if steps.are_used_up() || !last.matches(document, element, steps) {
            return false;
        }
        let parent = |e: u32| document.get(e).and_then(|e| e.parent);
        let (mut left, mut at) = (ancestors, parent(element));
        // Where to go on if a parent does not match: above the nearest match of the last compound for any ancestor.
        let mut again = None;
        while let Some((wanted, outer)) = left.split_last() {
            let Some(here) = at else { return false };
            at = parent(here);
            if wanted.matches(document, here, steps) {
                if !wanted.is_parent {
                    again = Some((left, at));
                }
                left = outer;
            } else if wanted.is_parent {
                let Some(before) = again else { return false };
                (left, at) = before;
            }
        }
        true
    }
}

/// The rules of a file.
#[derive(Debug, Default)]
pub(super) struct StyleSheet<'s> {
    rules: Vec<Rule<'s>>,
    /// Rules by the class, id or type of the element itself: `.a`, `#a`, `path`, or empty for all elements.
    by_key: FxHashMap<&'s str, Vec<usize>>,
    /// The custom properties of all its rules.
    pub(super) custom: Custom,
    /// Number of rules that are not understood.
    pub(super) not_understood: u32,
}

impl<'s> StyleSheet<'s> {
    /// Reads the rules of a text without comments.
    pub(super) fn read(text: &'s str) -> Self {
        let mut sheet = Self::default();
        let mut rest = text;
        while let Some(start) = rest.find(['{', ';', '}']) {
            let (head, after) = rest.split_at(start);
            let head = without_marks(head);
            if !after.starts_with('{') {
                // An `@import` or a stray sign.
                sheet.not_understood += u32::from(head.starts_with('@') && !head.starts_with("@charset"));
                rest = after.get(1..).unwrap_or_default();
                continue;
            }
            let end = closing_brace(after);
            let mut body = after.get(1..end).unwrap_or_default();
            rest = after.get(end + 1..).unwrap_or_default();
            if head.starts_with('@') {
                // Fonts do not matter, and rules for media and animations do not hold on a machine.
                sheet.not_understood += u32::from(!head.starts_with("@font-face"));
                continue;
            }
            if let Some(nested) = body.find('{') {
                // A rule inside this one, whose selector comes after the last declaration before it.
                sheet.not_understood += 1;
                body = body.get(..nested).and_then(|b| b.rsplit_once(';')).map_or("", |(kept, _)| kept);
            }
            sheet.custom.add(declarations(body));
            for selector in head.split(',') {
                sheet.add(selector.trim(), body);
            }
        }
        sheet
    }

    fn add(&mut self, selector: &'s str, declarations: &'s str) {
        let mut compounds: Vec<Compound<'s>> = Vec::new();
        let mut understood = self.rules.len() < MOST_RULES;
        for word in selector.split_ascii_whitespace().flat_map(|w| w.split_inclusive('>')) {
            let (name, is_parent) = word.strip_suffix('>').map_or((word, false), |n| (n, true));
            if !name.is_empty() {
                match Compound::read(name) {
                    Some(compound) => compounds.push(compound),
                    None => understood = false,
                }
            }
            if let (true, Some(last)) = (is_parent, compounds.last_mut()) {
                last.is_parent = true;
            }
        }
        if !understood || compounds.is_empty() {
            self.not_understood += 1;
            return;
        }
        let sum = |f: fn(&Compound<'_>) -> usize| compounds.iter().map(f).sum::<usize>();
        let specificity = [
            sum(|c| usize::from(c.id.is_some())),
            sum(|c| c.classes.len() + usize::from(c.is_root)),
            sum(|c| usize::from(c.tag.is_some())),
        ];
        let last = compounds.last();
        let key = last.and_then(|c| c.id.or(c.classes.first().copied()).or(c.tag)).unwrap_or_default();
        self.by_key.entry(key).or_default().push(self.rules.len());
        self.rules.push(Rule { compounds, specificity, declarations });
    }

    /// The declarations for an element, from the weakest rule to the strongest. Some are missing, or
    /// all, when there are no steps left.
    pub(super) fn matching(
        &self,
        document: &Document<'_>,
        element: u32,
        steps: &mut Steps,
    ) -> Vec<Declaration<'s>> {
        if self.rules.is_empty() {
            return Vec::new();
        }
        let attribute = |name: &str| document.attribute(element, name).unwrap_or_default();
        let keys =
            attribute("class").split_ascii_whitespace().chain([attribute("id"), document.name(element), ""]);
        let keys: BTreeSet<&str> = keys.collect();
        let mut found: Vec<usize> = Vec::new();
        for rules in keys.into_iter().filter_map(|k| self.by_key.get(k)) {
            found.extend(rules.iter().filter(|&&r| self.rules[r].matches(document, element, steps)));
        }
        found.sort_unstable_by_key(|&r| (self.rules[r].specificity, r));
        found.dedup();
        steps.take(found.iter().map(|&r| self.rules[r].declarations.len()).sum());
        // One long text may belong to thousands of selectors.
        if steps.are_used_up() {
            return Vec::new();
        }
        found.into_iter().flat_map(|r| declarations(self.rules[r].declarations)).collect()
    }
}

/// A selector without the signs around a style sheet that hid it from old browsers.
fn without_marks(text: &str) -> &str {
    text.trim().trim_start_matches("<!--").trim_start_matches("-->").trim()
}

/// Position of the brace that closes the one at the start of the text, or the end of the text.
fn closing_brace(text: &str) -> usize {
    let mut depth = 0_usize;
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'{' => depth += 1,
            b'}' if depth == 1 => return at,
            b'}' => depth -= 1,
            _ => {}
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::ReadOptions;
    use crate::svg::xml;

    fn strokes(css: &str, body: &str, id: &str) -> Vec<String> {
        let text = format!("<svg>{body}</svg>");
        let document = xml::read(&text, &ReadOptions::default().limits).unwrap();
        let sheet = StyleSheet::read(css);
        let element = document.by_id(id).unwrap();
        sheet
            .matching(&document, element, &mut Steps::new(text.len()))
            .iter()
            .map(|d| format!("{}={}", d.name, d.value))
            .collect()
    }

    #[test]
    fn stronger_selectors_come_later() {
        let css =
            "#a{stroke:red} .c, .d {stroke:green;fill : none} path{stroke:blue} *{x:1} path.c{stroke:gray}";
        let found = strokes(css, "<path id='a' class='b c'/>", "a");
        assert_eq!(found, ["x=1", "stroke=blue", "stroke=green", "fill=none", "stroke=gray", "stroke=red"]);
    }

    #[test]
    fn ancestors_and_parents() {
        let body = "<g class='cut'><g><path id='a'/></g><path id='b'/></g><path id='c'/>";
        assert_eq!(strokes(".cut path{s:1}", body, "a"), ["s=1"]);
        assert_eq!(strokes(".cut>path{s:1}", body, "a"), [""; 0]);
        assert_eq!(strokes(".cut > path{s:1}", body, "b"), ["s=1"]);
        assert_eq!(strokes("svg g path{s:1}", body, "c"), [""; 0]);
    }

    #[test]
    fn rules_that_are_not_understood_are_counted() {
        let sheet = StyleSheet::read(
            "@import url(a.css); @media print{path{stroke:red}} a:hover{x:1} [id]{x:1} .a{x:1}",
        );
        assert_eq!((sheet.rules.len(), sheet.not_understood), (1, 4));
        let nested = StyleSheet::read("g{stroke:red; path{fill:none} x:1} path{y:1}");
        assert_eq!((nested.rules.len(), nested.not_understood), (2, 1));
        assert_eq!(nested.rules[0].declarations, "stroke:red");
        for text in ["{", "}", "a{", "{}", "a{b", ",{x:1}", ";;", "@", "/*", "a>{x:1}"] {
            StyleSheet::read(text);
        }
    }
}
