//! Checks a value against the table of its fields.

use super::nearest::nearest;
use super::table::{Field, Kind, Range, Shape};
use super::value::{COUNTS, Value, shown};

impl Shape {
    /// Checks that a value is an object with the right fields.
    ///
    /// # Errors
    /// One sentence about the first wrong field.
    pub fn check(&self, value: &Value) -> Result<(), String> {
        self.object("", self.fields, value)
    }

    /// Checks the fields of an object. `prefix` is the path to it, including its dot.
    fn object(&self, prefix: &str, fields: &[Field], value: &Value) -> Result<(), String> {
        let Value::Object(given) = value else {
            return Err(match prefix.strip_suffix('.') {
                None => format!("{} is {value}. Give an object with named {}s.", self.owner, self.item),
                Some(path) => self.refused(path, value, "Give an object."),
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
            Some(f) => Err(format!("{} lacks the {} \"{prefix}{}\".", self.owner, self.item, f.name)),
        }
    }

    fn value(&self, path: &str, kind: &Kind, value: &Value, nullable: bool) -> Result<(), String> {
        let refused = |rule: &str| Err(self.refused(path, value, rule));
        let null = if nullable { ", or null" } else { "" };
        match (kind, value) {
            (Kind::Flag, Value::Flag(_)) | (Kind::Text | Kind::Parameters, Value::Text(_)) => Ok(()),
            (Kind::Flag, _) => refused(&format!("Give true or false{null}.")),
            (Kind::Text | Kind::Parameters, _) => refused(&format!("Give a text{null}.")),
            (Kind::Choice(words), Value::Text(word)) if words.contains(&word.as_str()) => Ok(()),
            (Kind::Choice(words), _) => refused(&format!("Choose one of: {}.", words.join(", "))),
            (Kind::Number(range), Value::Number(n)) if range.holds(*n) => Ok(()),
            (Kind::Number(range), _) => refused(&number_rule(range, false, nullable)),
            (Kind::Whole(range), Value::Number(n)) if range.holds(*n) && is_whole(*n) => Ok(()),
            (Kind::Whole(range), _) => refused(&number_rule(range, true, nullable)),
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

    fn list(&self, path: &str, kind: &Kind, list: &[Value]) -> Result<(), String> {
        (0..).zip(list).try_for_each(|(k, v): (usize, _)| self.value(&format!("{path}[{k}]"), kind, v, false))
    }

    fn refused(&self, path: &str, value: &Value, rule: &str) -> String {
        format!("{} \"{path}\" is {value}. {rule}", self.value)
    }

    fn unknown(&self, prefix: &str, name: &str, fields: &[Field]) -> String {
        let names = fields.iter().map(|f| f.name);
        let hint = match nearest(name, names.clone()) {
            Some(near) => format!("Did you mean \"{prefix}{near}\"?"),
            None => format!("There are: {}.", names.collect::<Vec<_>>().join(", ")),
        };
        format!("{} has no {} \"{prefix}{}\". {hint}", self.owner, self.item, shown(name))
    }
}

fn is_whole(n: f64) -> bool {
    n.abs() <= COUNTS && n.fract().abs() <= 0.0
}

/// The sentence for a number that is out of its range. It begins with `what`, for example `The machine's field`.
pub fn out_of_range(what: &str, name: &str, n: f64, range: &Range) -> String {
    let rule = number_rule(range, false, false);
    format!("{what} \"{name}\" is {}. {rule}", Value::Number(n))
}

/// The second half of the sentence: which numbers are allowed.
fn number_rule(range: &Range, whole: bool, nullable: bool) -> String {
    let Range { least, most, or_zero, unit, why } = *range;
    let what = if whole { "a whole number" } else { "a number" };
    let range = if least < most { format!("{what} from {least} to {most}") } else { format!("{least}") };
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let zero = if or_zero { ", or 0" } else { "" };
    let null = if nullable { ", or null" } else { "" };
    format!("Give {range}{unit}{zero}{null}: {why}.")
}
