//! Checks a value against the table of its fields.

use super::error::{Fault, FieldError};
use super::nearest::nearest;
use super::rule::number_rule;
use super::table::{Field, Kind, Range, Shape};
use super::value::{COUNTS, Value, shown};

impl Shape {
    /// Checks that a value is an object with the right fields.
    ///
    /// # Errors
    /// What is wrong with the first wrong field.
    pub fn check(&self, value: &Value) -> Result<(), FieldError> {
        self.object("", self.fields, value)
    }

    /// Checks the fields of an object. `prefix` is the path to it, including its dot.
    fn object(&self, prefix: &str, fields: &[Field], value: &Value) -> Result<(), FieldError> {
        let Value::Object(given) = value else {
            return Err(match prefix.strip_suffix('.') {
                None => {
                    let sentence =
                        format!("{} is {value}. Give an object with named {}s.", self.owner, self.item);
                    FieldError::new(Fault::WrongType, "", sentence).of(value)
                }
                Some(path) => self.refused(Fault::WrongType, path, value, "Give an object."),
            });
        };
        for (name, value) in given {
            let Some(field) = fields.iter().find(|f| f.name == name) else {
                return Err(self.unknown(prefix, name, fields));
            };
            if !(field.nullable && *value == Value::Null) {
                self.value(&format!("{prefix}{name}"), &field.kind, value, field.nullable)?;
            }
        }
        let missing = fields.iter().find(|f| f.required && !given.iter().any(|(name, _)| name == f.name));
        match missing {
            None => Ok(()),
            Some(f) => {
                let sentence = format!("{} lacks the {} \"{prefix}{}\".", self.owner, self.item, f.name);
                Err(FieldError::new(Fault::Missing, format!("{prefix}{}", f.name), sentence))
            }
        }
    }

    fn value(&self, path: &str, kind: &Kind, value: &Value, nullable: bool) -> Result<(), FieldError> {
        let refused = |rule: &str| Err(self.refused(Fault::WrongType, path, value, rule));
        let number = |range: &Range, whole: bool| {
            let is_number = matches!(value, Value::Number(_));
            let fault = if is_number { Fault::OutOfRange(Box::new(*range)) } else { Fault::WrongType };
            Err(self.refused(fault, path, value, &number_rule(range, whole, nullable)))
        };
        let null = if nullable { ", or null" } else { "" };
        match (kind, value) {
            (Kind::Flag, Value::Flag(_)) | (Kind::Text | Kind::Parameters, Value::Text(_)) => Ok(()),
            (Kind::Flag, _) => refused(&format!("Give true or false{null}.")),
            (Kind::Text | Kind::Parameters, _) => refused(&format!("Give a text{null}.")),
            (Kind::Choice(words), Value::Text(word)) if words.contains(&word.as_str()) => Ok(()),
            (Kind::Choice(words), _) => {
                let fault = Fault::NotAChoice(words.iter().map(|&word| word.to_owned()).collect());
                Err(self.refused(fault, path, value, &format!("Choose one of: {}.", words.join(", "))))
            }
            (Kind::Number(range), Value::Number(n)) if range.holds(*n) => Ok(()),
            (Kind::Number(range), _) => number(range, false),
            (Kind::Whole(range), Value::Number(n)) if range.holds(*n) && is_whole(*n) => Ok(()),
            (Kind::Whole(range), _) => number(range, true),
            (Kind::Pair(kind), Value::List(list)) if list.len() == 2 => self.list(path, kind, list),
            (Kind::Pair(_), _) => refused(&format!("Give a list of two{null}.")),
            (Kind::Four(kind), Value::List(list)) if list.len() == 4 => self.list(path, kind, list),
            (Kind::Four(_), _) => refused(&format!("Give a list of four{null}.")),
            (Kind::List(kind), Value::List(list)) => self.list(path, kind, list),
            (Kind::List(_), _) => refused(&format!("Give a list{null}.")),
            (Kind::Object(fields), _) => self.object(&format!("{path}."), fields, value),
            (Kind::NameOr(_), Value::Text(_)) => Ok(()),
            (Kind::NameOr(shape), Value::Object(_)) => shape.check(value),
            (Kind::NameOr(_), _) => refused("Give a name or an object."),
        }
    }

    fn list(&self, path: &str, kind: &Kind, list: &[Value]) -> Result<(), FieldError> {
        (0..).zip(list).try_for_each(|(k, v): (usize, _)| self.value(&format!("{path}[{k}]"), kind, v, false))
    }

    fn refused(&self, fault: Fault, path: &str, value: &Value, rule: &str) -> FieldError {
        FieldError::new(fault, path, format!("{} \"{path}\" is {value}. {rule}", self.value)).of(value)
    }

    fn unknown(&self, prefix: &str, name: &str, fields: &[Field]) -> FieldError {
        let names = fields.iter().map(|f| f.name);
        let near = nearest(name, names.clone()).map(|near| format!("{prefix}{near}"));
        let hint = match &near {
            Some(near) => format!("Did you mean \"{near}\"?"),
            None => format!("There are: {}.", names.collect::<Vec<_>>().join(", ")),
        };
        let path = format!("{prefix}{}", shown(name));
        let message = format!("{} has no {} \"{path}\". {hint}", self.owner, self.item);
        FieldError { near, ..FieldError::new(Fault::Unknown, path, message) }
    }
}

fn is_whole(n: f64) -> bool {
    n.abs() <= COUNTS && n.fract().abs() <= 0.0
}
