//! A value from a caller before its type is known. Unlike JSON it can hold NaN, so that the message can name it.

use serde::de::value::{MapDeserializer, SeqDeserializer, StringDeserializer};
use serde::de::{DeserializeSeed, Deserializer, EnumAccess, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, forward_to_deserialize_any};
use std::fmt;

/// A value from a caller.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Null.
    Null,
    /// True or false.
    Flag(bool),
    /// A number, finite or not.
    Number(f64),
    /// Text.
    Text(String),
    /// A list.
    List(Vec<Value>),
    /// Fields, in the order given.
    Object(Vec<(String, Value)>),
    /// Something that is not data, described by its kind: `a function`.
    Other(&'static str),
}

/// Largest whole number that `f64` counts to without gaps, 2^53 - 1.
pub(super) const COUNTS: f64 = 9_007_199_254_740_991.0;

/// Number of characters of a text shown in a message: enough to recognise it.
const SHOWN: usize = 40;

/// A caller's text for a message, shortened and without control characters, which a terminal might act on.
pub fn shown(text: &str) -> String {
    let clean = |c: char| if c.is_control() { '\u{fffd}' } else { c };
    let mut short: String = text.chars().take(SHOWN).map(clean).collect();
    if text.chars().nth(SHOWN).is_some() {
        short.push('…');
    }
    short
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Null => f.write_str("null"),
            Self::Flag(flag) => write!(f, "{flag}"),
            Self::Number(n) if n.is_infinite() => {
                f.write_str(if *n > 0.0 { "Infinity" } else { "-Infinity" })
            }
            // Like JavaScript, uses powers of ten for very large and very small numbers.
            Self::Number(n) if n.abs() >= 1e21 || (n.abs() < 1e-6 && *n != 0.0) => write!(f, "{n:e}"),
            Self::Number(n) => write!(f, "{n}"),
            Self::Text(text) => write!(f, "\"{}\"", shown(text)),
            Self::List(_) => f.write_str("a list"),
            Self::Object(_) => f.write_str("an object"),
            Self::Other(kind) => f.write_str(kind),
        }
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Any;
        impl<'de> Visitor<'de> for Any {
            type Value = Value;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value")
            }

            fn visit_unit<E>(self) -> Result<Value, E> {
                Ok(Value::Null)
            }

            fn visit_bool<E>(self, flag: bool) -> Result<Value, E> {
                Ok(Value::Flag(flag))
            }

            fn visit_i64<E>(self, n: i64) -> Result<Value, E> {
                Ok(Value::Number(n as f64))
            }

            fn visit_u64<E>(self, n: u64) -> Result<Value, E> {
                Ok(Value::Number(n as f64))
            }

            fn visit_f64<E>(self, n: f64) -> Result<Value, E> {
                Ok(Value::Number(n))
            }

            fn visit_str<E>(self, text: &str) -> Result<Value, E> {
                Ok(Value::Text(text.to_owned()))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Value, A::Error> {
                let mut list = Vec::new();
                while let Some(value) = seq.next_element()? {
                    list.push(value);
                }
                Ok(Value::List(list))
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
                let mut fields = Vec::new();
                while let Some(field) = map.next_entry()? {
                    fields.push(field);
                }
                Ok(Value::Object(fields))
            }
        }
        deserializer.deserialize_any(Any)
    }
}

/// What serde says of a value that does not fit. It names nothing: the tables refuse such a value before, in a sentence.
/// An error without a text keeps the formatting of serde's own messages out of the wasm file.
#[derive(Debug)]
pub struct Unfit;

impl fmt::Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value does not fit its field")
    }
}

impl std::error::Error for Unfit {}

impl serde::de::Error for Unfit {
    fn custom<T: fmt::Display>(_: T) -> Self {
        Self
    }
}

impl Value {
    /// The number as a whole one, if it is a whole number from 0 to 2^53 - 1.
    fn whole(&self) -> Option<u64> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number in range"
        )]
        match self {
            Self::Number(n) if (0.0..=COUNTS).contains(n) && n.fract() <= 0.0 => Some(*n as u64),
            _ => None,
        }
    }
}

/// Methods of a [`Deserializer`] that accept whole numbers only.
macro_rules! deserialize_whole {
    ($($name:ident)*) => {$(
        fn $name<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
            self.whole().ok_or(Unfit).and_then(|n| visitor.visit_u64(n))
        }
    )*};
}

/// Each type accepts one kind of value, so that the code for all others is not compiled for every struct and field.
impl<'de> Deserializer<'de> for Value {
    type Error = Unfit;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
        match (self.whole(), self) {
            (Some(n), _) => visitor.visit_u64(n),
            (None, Self::Null) => visitor.visit_unit(),
            (None, Self::Flag(flag)) => visitor.visit_bool(flag),
            (None, Self::Number(n)) => visitor.visit_f64(n),
            (None, Self::Text(text)) => visitor.visit_string(text),
            (None, list @ Self::List(_)) => list.deserialize_seq(visitor),
            (None, object @ Self::Object(_)) => object.deserialize_map(visitor),
            (None, Self::Other(_)) => Err(Unfit),
        }
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
        if let Self::Flag(flag) = self { visitor.visit_bool(flag) } else { Err(Unfit) }
    }

    deserialize_whole! { deserialize_u8 deserialize_u16 deserialize_u32 deserialize_u64 }

    // Keeps the sign of zero, which a whole number loses.
    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
        if let Self::Number(n) = self { visitor.visit_f64(n) } else { Err(Unfit) }
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
        if let Self::Text(text) = self { visitor.visit_string(text) } else { Err(Unfit) }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
        match self {
            Self::Null => visitor.visit_none(),
            some => visitor.visit_some(some),
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
        let Self::List(list) = self else { return Err(Unfit) };
        visitor.visit_seq(SeqDeserializer::new(list.into_iter()))
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, Unfit> {
        self.deserialize_seq(visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
        let Self::Object(fields) = self else { return Err(Unfit) };
        visitor.visit_map(MapDeserializer::new(fields.into_iter()))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Unfit> {
        self.deserialize_map(visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Unfit> {
        if let Self::Text(word) = self { visitor.visit_enum(Word(word)) } else { Err(Unfit) }
    }

    forward_to_deserialize_any! {
        i8 i16 i32 i64 f32 char str bytes byte_buf unit unit_struct newtype_struct tuple_struct identifier ignored_any
    }
}

impl IntoDeserializer<'_, Unfit> for Value {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

/// A variant without data.
struct Word(String);

impl<'de> EnumAccess<'de> for Word {
    type Error = Unfit;
    type Variant = <StringDeserializer<Unfit> as EnumAccess<'de>>::Variant;

    fn variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<(S::Value, Self::Variant), Unfit> {
        IntoDeserializer::<Unfit>::into_deserializer(self.0).variant_seed(seed)
    }
}
