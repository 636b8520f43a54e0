//! What fields an object may have: tables as data, which TypeScript has, too.

use serde::Serialize;

/// The fields of an object, with the words for its sentences.
#[derive(Debug, Serialize)]
pub struct Shape {
    /// Begins the sentences about missing and unknown fields: `The machine`.
    pub owner: &'static str,
    /// What a field is called: `field` or `option`.
    pub item: &'static str,
    /// Begins the sentences about values: `The machine's field`.
    pub value: &'static str,
    /// The fields.
    pub fields: &'static [Field],
}

/// One field.
#[derive(Debug, Serialize)]
pub struct Field {
    /// Its name.
    pub name: &'static str,
    /// What it may hold.
    pub kind: Kind,
    /// It must be given.
    pub required: bool,
    /// It may be null.
    pub nullable: bool,
}

/// What a value may be.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub enum Kind {
    /// True or false.
    Flag,
    /// Any text.
    Text,
    /// One of these words.
    Choice(&'static [&'static str]),
    /// A finite number.
    Number(Range),
    /// A whole number.
    Whole(Range),
    /// Two values in a list.
    Pair(&'static Kind),
    /// Any number of values in a list.
    List(&'static Kind),
    /// An object with these fields.
    Object(&'static [Field]),
    /// The name of something, or the thing itself.
    NameOr(&'static Shape),
    /// Parameters of a method: the method checks them. A JSON text in the core; an object of numbers, texts and flags in
    /// JavaScript.
    Parameters,
}

/// The numbers a field may hold, with the reason for the limits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Range {
    /// The smallest.
    pub least: f64,
    /// The largest.
    pub most: f64,
    /// Zero is allowed besides.
    pub or_zero: bool,
    /// Unit for people; empty: none.
    pub unit: &'static str,
    /// Why it has these limits, to follow a colon.
    pub why: &'static str,
}

impl Range {
    /// A range with its unit and reason.
    pub const fn new(least: f64, most: f64, unit: &'static str, why: &'static str) -> Self {
        Self { least, most, or_zero: false, unit, why }
    }

    /// The same with zero.
    pub const fn or_zero(self) -> Self {
        Self { or_zero: true, ..self }
    }

    /// Whether a number is within. NaN and the infinities never are.
    pub fn holds(&self, n: f64) -> bool {
        (self.least..=self.most).contains(&n) || (self.or_zero && n.abs().total_cmp(&0.0).is_eq())
    }
}

impl Field {
    /// A field that may be left out.
    pub const fn optional(name: &'static str, kind: Kind) -> Self {
        Self { name, kind, required: false, nullable: false }
    }

    /// A field that must be given.
    pub const fn required(name: &'static str, kind: Kind) -> Self {
        Self { name, kind, required: true, nullable: false }
    }

    /// A field that may be left out or null: both mean none.
    pub const fn nullable(name: &'static str, kind: Kind) -> Self {
        Self { name, kind, required: false, nullable: true }
    }
}
