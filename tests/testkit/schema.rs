//! The part of JSON Schema 2020-12 that our plan schema says its structure with: types, constants, fields, items,
//! alternatives. Bounds and patterns are left to the package tests, which have a whole validator.

use serde_json::{Map, Value};

/// The first fault of `value` according to `schema` (the whole, for references), with its place; `None` if it is valid.
pub(crate) fn fault(whole: &Value, schema: &Value, value: &Value, at: &str) -> Option<String> {
    let Some(rules) = schema.as_object() else {
        return (schema == &Value::Bool(false)).then(|| format!("{at}: one too many"));
    };
    rules.iter().find_map(|(rule, says)| match rule.as_str() {
        "$ref" => fault(whole, referred(whole, says), value, at),
        "const" => (value != says).then(|| format!("{at}: {value} is not {says}")),
        "enum" => (!list(says).contains(value)).then(|| format!("{at}: {value} is none of {says}")),
        "type" => wrong_type(says, value).then(|| format!("{at}: {value} is not of type {says}")),
        "oneOf" => {
            let fitting = list(says).iter().filter(|s| fault(whole, s, value, at).is_none()).count();
            (fitting != 1).then(|| format!("{at}: {value} fits {fitting} of {} kinds", list(says).len()))
        }
        "required" => {
            let missing = list(says).iter().find(|name| value.get(name.as_str().unwrap()).is_none());
            missing.map(|name| format!("{at}: {name} is missing"))
        }
        "properties" => fields(value).iter().find_map(|(name, field)| match says.get(name) {
            Some(schema) => fault(whole, schema, field, &format!("{at}/{name}")),
            None => Some(format!("{at}: {name} is unknown")),
        }),
        "prefixItems" | "items" => {
            let skipped = rules.get("prefixItems").map_or(0, |p| list(p).len());
            let items = value.as_array().map_or(&[][..], Vec::as_slice);
            items.iter().enumerate().find_map(|(i, item)| match rule.as_str() {
                "prefixItems" => list(says).get(i).and_then(|s| fault(whole, s, item, &format!("{at}/{i}"))),
                _ if i >= skipped => fault(whole, says, item, &format!("{at}/{i}")),
                _ => None,
            })
        }
        "minItems" => {
            let few = value.as_array().is_some_and(|a| (a.len() as u64) < says.as_u64().unwrap());
            few.then(|| format!("{at}: too few"))
        }
        _ => None,
    })
}

fn referred<'a>(whole: &'a Value, reference: &Value) -> &'a Value {
    let path = reference.as_str().unwrap().strip_prefix('#').unwrap();
    whole.pointer(path).unwrap_or_else(|| panic!("{path} is not defined"))
}

fn wrong_type(says: &Value, value: &Value) -> bool {
    let is = |name: &str| match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        other => panic!("type {other}"),
    };
    match says {
        Value::Array(any) => !any.iter().any(|t| is(t.as_str().unwrap())),
        one => !is(one.as_str().unwrap()),
    }
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn fields(value: &Value) -> Map<String, Value> {
    value.as_object().cloned().unwrap_or_default()
}
