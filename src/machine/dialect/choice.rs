//! The dialect of a machine: the name of a shipped one, or a whole document.

use super::model::Dialect;
use super::shipped::{dialect, dialects};
use crate::fields::no_such;
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// The name of a shipped dialect, or a dialect of one's own.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum DialectChoice {
    /// Name of a shipped dialect.
    Name(String),
    /// A document.
    Document(Box<Dialect>),
}

impl DialectChoice {
    /// The shipped dialect of this name.
    pub fn named(name: &str) -> Self {
        Self::Name(name.to_owned())
    }

    /// The name of the dialect.
    pub fn name(&self) -> &str {
        match self {
            Self::Name(name) => name,
            Self::Document(document) => &document.name,
        }
    }

    /// The document.
    ///
    /// # Errors
    /// One sentence: there is no dialect of this name, or the document contradicts itself.
    pub fn document(&self) -> Result<Dialect, String> {
        match self {
            Self::Document(document) => document.validate().map(|()| (**document).clone()),
            Self::Name(name) => dialect(name).ok_or_else(|| {
                let all = dialects();
                let names: Vec<&str> = all.iter().map(|d| d.name.as_str()).collect();
                no_such("dialect", name, &names)
            }),
        }
    }
}

// Written by hand, because serde buffers the values of untagged enums, which adds 5 kB gzip of wasm.
impl<'de> Deserialize<'de> for DialectChoice {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Choice;
        impl<'de> Visitor<'de> for Choice {
            type Value = DialectChoice;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a dialect or a dialect document")
            }

            fn visit_str<E>(self, name: &str) -> Result<DialectChoice, E> {
                Ok(DialectChoice::named(name))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<DialectChoice, A::Error> {
                Dialect::deserialize(MapAccessDeserializer::new(map))
                    .map(|d| DialectChoice::Document(Box::new(d)))
            }
        }
        deserializer.deserialize_any(Choice)
    }
}
