//! Parameters of the published methods, which callers give as a JSON object. The parameters of a method are the fields of
//! its struct, so their names and types come from its default value. Their limits are in this file.

use crate::fields::{Range, Value, nearest, no_such, out_of_range};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value as Json};

/// Limits of the parameters that cost memory, or time before the search can be interrupted. All other parameters accept any
/// number of their field's type within [`ANY`].
const LIMITS: &[(&str, Range)] = &[
    ("particles", POPULATION),
    ("population", POPULATION),
    ("fastest", Range::new(0.0, 1e9, "", "a velocity is limited in both directions")),
    ("neighbours", Range::new(1.0, 1000.0, "", "each contour has a list of so many, which takes memory")),
    ("grouping", Range::new(0.0, 1e4, "", "groups settle after some tens of rounds")),
    ("proximity_steps", Range::new(0.0, 1e9, "", "more steps take minutes before the first path")),
    ("gtsp_moves", Range::new(0.0, 1e9, "", "more moves take minutes before the next path")),
];
/// A population takes memory in proportion to the nodes of a drawing, and large drawings have some ten thousand.
const POPULATION: Range = Range::new(1.0, 1000.0, "", "the papers have at most 200, and each takes memory");
/// Limits of all other numbers: squares and products of them stay finite.
const ANY: Range = Range::new(-1e9, 1e9, "", "larger numbers say nothing to a method");

/// A method with its default parameters, except for those that a JSON object gives. Its parameter `preset` names one of
/// `presets`; parameters given beside it win.
///
/// serde cannot refuse unknown names in structs with flattened fields. Therefore names are compared with those of the
/// default value here.
///
/// # Errors
/// One sentence that names the parameter.
pub(super) fn read<M: Default + Serialize + DeserializeOwned>(
    text: &str,
    presets: &Json,
) -> Result<M, String> {
    let given = serde_json::from_str(text)
        .map_err(|e| format!("The parameters are not JSON: see line {}, column {}.", e.line(), e.column()))?;
    let Json::Object(mut given) = given else {
        return Err("The parameters are no object. Give an object with their names and values.".into());
    };
    let Ok(Json::Object(defaults)) = serde_json::to_value(M::default()) else {
        return Err("The method has no parameters.".into());
    };
    let mut parameters = defaults.clone();
    if let Some(name) = given.remove("preset") {
        parameters.extend(preset(&name, presets)?);
    }
    for (name, value) in given {
        let Some(default) = defaults.get(&name) else { return Err(unknown(&name, &defaults)) };
        check_range(&name, &value)?;
        // Each value is tried by itself, because serde's errors do not name the field.
        let mut alone = defaults.clone();
        alone.insert(name.clone(), value.clone());
        if serde_json::from_value::<M>(Json::Object(alone)).is_err() {
            let value = shown(&value);
            return Err(format!(
                "The parameter \"{name}\" is {value}. Give a value like its default, {default}."
            ));
        }
        parameters.insert(name, value);
    }
    serde_json::from_value(Json::Object(parameters))
        .map_err(|_| "The parameters cannot be used together.".to_owned())
}

/// The parameters of a preset.
fn preset(name: &Json, presets: &Json) -> Result<Map<String, Json>, String> {
    let Json::String(text) = name else {
        return Err(format!("The preset is {}: give its name in quotes.", shown(name)));
    };
    match presets.get(text) {
        Some(Json::Object(parameters)) => Ok(parameters.clone()),
        _ => {
            let names: Vec<&str> =
                presets.as_object().into_iter().flat_map(Map::keys).map(String::as_str).collect();
            Err(no_such("preset", text, &names))
        }
    }
}

fn check_range(name: &str, value: &Json) -> Result<(), String> {
    let limits = LIMITS.iter().find(|(of, _)| *of == name).map_or(ANY, |(_, range)| *range);
    match value.as_f64().filter(|n| !limits.holds(*n)) {
        Some(n) => Err(out_of_range("The parameter", name, n, &limits)),
        None => Ok(()),
    }
}

fn shown(value: &Json) -> String {
    match value {
        Json::String(text) => Value::Text(text.clone()).to_string(),
        Json::Array(_) => "a list".into(),
        Json::Object(_) => "an object".into(),
        other => other.to_string(),
    }
}

fn unknown(name: &str, defaults: &Map<String, Json>) -> String {
    let names: Vec<&str> = defaults.keys().map(String::as_str).collect();
    let hint = match (nearest(name, names.iter().copied()), names.is_empty()) {
        (Some(near), _) => format!("Did you mean \"{near}\"?"),
        (None, false) => format!("There are: {}.", names.join(", ")),
        (None, true) => "It has none.".into(),
    };
    format!("The method has no parameter {}. {hint}", Value::Text(name.to_owned()))
}
