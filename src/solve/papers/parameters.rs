//! Parameters of methods, as callers give them: a JSON object. A method's parameters are the fields of its struct, so their
//! names and kinds are read off its defaults; their limits are here.

use crate::fields::{Range, Value, nearest, out_of_range};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

/// Limits of the parameters that take memory, or time before the first look at the clock. All others may be any number that
/// their field holds.
const LIMITS: &[(&str, Range)] = &[
    ("particles", POPULATION),
    ("population", POPULATION),
    ("grouping", Range::new(0.0, 1e4, "", "groups settle after some tens of rounds")),
    ("proximity_steps", Range::new(0.0, 1e9, "", "more steps take minutes before the first path")),
    ("gtsp_moves", Range::new(0.0, 1e9, "", "more moves take minutes before the next path")),
];
/// Memory is this many times the nodes of a drawing, of which large ones have some ten thousand.
const POPULATION: Range = Range::new(1.0, 1000.0, "", "the papers have at most 200, and each takes memory");
/// Limits of numbers without others: squares and products of them stay finite.
const ANY: Range = Range::new(-1e9, 1e9, "", "larger numbers say nothing to a method");

/// A method with its parameters: the defaults with what a JSON object says otherwise.
///
/// # Errors
/// One sentence that names the parameter.
pub(super) fn read<M: Default + Serialize + DeserializeOwned>(text: &str) -> Result<M, String> {
    let given = serde_json::from_str(text).map_err(|e| format!("The parameters are not JSON: {e}."))?;
    let Json::Object(given) = given else {
        return Err("The parameters are no object. Give an object with their names and values.".into());
    };
    let defaults = serde_json::to_value(M::default()).unwrap_or_default();
    for (name, value) in &given {
        let Some(default) = defaults.get(name) else { return Err(unknown(name, &defaults)) };
        check::<M>(name, value, default)?;
    }
    serde_json::from_value(Json::Object(given)).map_err(|e| format!("The parameters cannot be read: {e}."))
}

fn check<M: DeserializeOwned>(name: &str, value: &Json, default: &Json) -> Result<(), String> {
    let limits = LIMITS.iter().find(|(of, _)| *of == name).map_or(ANY, |(_, range)| *range);
    if let Some(n) = value.as_f64().filter(|n| !limits.holds(*n)) {
        return Err(out_of_range("The parameter", name, n, &limits));
    }
    // Each by itself, as the reader names no field.
    let alone = Json::Object([(name.to_owned(), value.clone())].into_iter().collect());
    let read = serde_json::from_value::<M>(alone).map(|_| ());
    let shown = shown(value);
    read.map_err(|e| format!("The parameter \"{name}\" is {shown}: {e}. Its default is {default}."))
}

fn shown(value: &Json) -> String {
    match value {
        Json::String(text) => Value::Text(text.clone()).to_string(),
        Json::Array(_) => "a list".into(),
        Json::Object(_) => "an object".into(),
        other => other.to_string(),
    }
}

fn unknown(name: &str, defaults: &Json) -> String {
    let names: Vec<&str> =
        defaults.as_object().into_iter().flat_map(|o| o.keys().map(String::as_str)).collect();
    let hint = match (nearest(name, names.iter().copied()), names.is_empty()) {
        (Some(near), _) => format!("Did you mean \"{near}\"?"),
        (None, false) => format!("There are: {}.", names.join(", ")),
        (None, true) => "It has none.".into(),
    };
    format!("The method has no parameter {}. {hint}", Value::Text(name.to_owned()))
}
