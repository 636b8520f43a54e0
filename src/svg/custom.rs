//! Custom properties of CSS (`--name: value`), and values that take them (`var(--name, otherwise)`).
//!
//! Each is taken to have one value in the whole file, which is what drawing programs write. Where a file gives one several
//! values, it depends on the element which of them holds, and what takes it counts as not readable.

use super::declarations::Declaration;
use super::steps::Steps;
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// Most values that are put into one another. Themes name a colour by another name, two or three deep.
const MOST: usize = 16;
/// Longest text that a value may become, in bytes: a path with some hundred curves.
const LONGEST: usize = 10_000;

/// The custom properties of a file by name. `None`: one has several values.
#[derive(Debug, Default)]
pub(super) struct Custom {
    values: FxHashMap<String, Option<String>>,
}

impl Custom {
    /// Adds those among some declarations.
    pub(super) fn add<'d>(&mut self, declarations: impl Iterator<Item = Declaration<'d>>) {
        for d in declarations.filter(|d| d.name.starts_with("--")) {
            self.values
                .entry(d.name.to_owned())
                .and_modify(|known| {
                    if known.as_deref() != Some(d.value) {
                        *known = None;
                    }
                })
                .or_insert_with(|| Some(d.value.to_owned()));
        }
    }

    /// A value with the custom properties in it replaced; `None` if one of them is not known.
    pub(super) fn replaced<'v>(&self, value: &'v str, steps: &mut Steps) -> Option<Cow<'v, str>> {
        let mut text = Cow::Borrowed(value);
        for _ in 0..MOST {
            let Some((before, after)) = text.split_once("var(") else { return Some(text) };
            steps.take(text.len());
            let end = closing_bracket(after)?;
            let (inside, after) = (after.get(..end)?, after.get(end + 1..)?);
            let (name, otherwise) =
                inside.split_once(',').map_or((inside, None), |(name, other)| (name, Some(other)));
            let known = match self.values.get(name.trim()) {
                Some(known) => known.as_deref(),
                None => otherwise.map(str::trim),
            };
            let replaced = format!("{before}{}{after}", known?);
            if replaced.len() > LONGEST {
                return None;
            }
            text = Cow::Owned(replaced);
        }
        None
    }
}

/// Position of the bracket that closes one before the text.
fn closing_bracket(text: &str) -> Option<usize> {
    let mut depth = 1_usize;
    text.bytes().position(|byte| {
        match byte {
            b'(' => depth += 1,
            b')' => depth -= 1,
            _ => {}
        }
        depth == 0
    })
}

#[cfg(test)]
mod tests {
    use super::super::declarations::declarations;
    use super::*;

    #[test]
    fn values_are_put_in_place_of_their_names() {
        let mut custom = Custom::default();
        custom
            .add(declarations("--a: red; --b:var(--a); --twice: 1; --twice: 2; --same: 3; --same: 3; x: 4"));
        custom.add(declarations("--loop: var(--loop); --long: var(--long)var(--long)x"));
        let mut steps = Steps::new(1000);
        for (value, replaced) in [
            ("blue", Some("blue")),
            ("var(--a)", Some("red")),
            ("var(--b)", Some("red")),
            ("var(--c, var(--b))", Some("red")),
            ("var( --c , rgb(1, 2, 3) )", Some("rgb(1, 2, 3)")),
            ("rotate(var(--same)deg)", Some("rotate(3deg)")),
            ("var(--c)", None),
            ("var(--twice, 5)", None),
            ("var(--loop)", None),
            ("var(--long)", None),
            ("var(--a", None),
        ] {
            assert_eq!(custom.replaced(value, &mut steps).as_deref(), replaced, "{value}");
        }
        assert!(!steps.are_used_up());
    }
}
