//! Tables of the fields that an object may have. They are data, so that TypeScript has the same tables.

use serde::Serialize;

/// The fields of an object, with the words for messages about them.
#[derive(Debug, Serialize)]
pub struct Shape {
    /// Begins messages about missing and unknown fields, for example `The machine`.
    pub owner: &'static str,
    /// The word for a field: `field` or `option`.
    pub item: &'static str,
    /// Begins messages about values, for example `The machine's field`.
    pub value: &'static str,
    /// The fields.
    pub fields: &'static [Field],
}

/// One field.
#[derive(Debug, Serialize)]
pub struct Field {
    /// Its name.
    pub name: &'static str,
    /// The type of its value.
    pub kind: Kind,
    /// Whether it must be given.
    pub required: bool,
    /// Whether it may be null.
    pub nullable: bool,
}

/// The type of a value.
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
    /// A list of two values.
    Pair(&'static Kind),
    /// A list of four values.
    Four(&'static Kind),
    /// A list of any length.
    List(&'static Kind),
    /// An object with these fields.
    Object(&'static [Field]),
    /// The name of something, or the object itself.
    NameOr(&'static Shape),
    /// Parameters of a method, which the method checks: a JSON text in the core, and an object of numbers, texts and flags
    /// in JavaScript.
    Parameters,
}

/// The numbers that a field accepts, with the reason for the limits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Range {
    /// Smallest number.
    pub least: f64,
    /// Largest number.
    pub most: f64,
    /// Whether zero is accepted as well.
    pub or_zero: bool,
    /// The unit as shown to people; empty if there is none.
    pub unit: &'static str,
    /// The reason for the limits, as it follows a colon.
    pub why: &'static str,
}

impl Range {
    /// A range with its unit and reason.
    pub const fn new(least: f64, most: f64, unit: &'static str, why: &'static str) -> Self {
        Self { least, most, or_zero: false, unit, why }
    }

    /// The same range, which accepts zero as well.
    pub const fn or_zero(self) -> Self {
        Self { or_zero: true, ..self }
    }

    /// Whether a number is accepted. NaN and infinity never are.
    pub fn holds(&self, n: f64) -> bool {
        (self.least..=self.most).contains(&n) || (self.or_zero && n.abs().total_cmp(&0.0).is_eq())
    }
}

impl Field {
    /// A field that may be omitted.
    pub const fn optional(name: &'static str, kind: Kind) -> Self {
        Self { name, kind, required: false, nullable: false }
    }

    /// A field that must be given.
    pub const fn required(name: &'static str, kind: Kind) -> Self {
        Self { name, kind, required: true, nullable: false }
    }

    /// A field that may be omitted or null, which mean the same.
    pub const fn nullable(name: &'static str, kind: Kind) -> Self {
        Self { name, kind, required: false, nullable: true }
    }
}
