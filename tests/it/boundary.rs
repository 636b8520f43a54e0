//! What callers hand over: every value is either taken or refused with one sentence that names the field.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]

use kerfway::fields::{self, Field, Kind, Shaped, Value};
use kerfway::job::{Job, JobError, LoadOptions, PlanOptions};
use kerfway::machine::{Profile, presets};
use kerfway::quote::{Limits, Material, Terms};
use kerfway::solve::papers;
use serde_json::{Value as Json, json};
use std::fmt::Write as _;

fn machine(change: impl Fn(&mut Json)) -> Json {
    let mut machine = serde_json::to_value(&presets()[0]).unwrap();
    change(&mut machine);
    machine
}

fn refused<T: Shaped + std::fmt::Debug>(value: &Json) -> String {
    fields::from_json::<T>(&value.to_string()).unwrap_err().message
}

#[test]
fn a_misspelt_field_of_a_machine_is_refused_with_the_nearest_name() {
    assert_eq!(
        refused::<Profile>(&machine(|m| m["kerf_witdh"] = json!(0.2))),
        "The machine has no field \"kerf_witdh\". Did you mean \"kerf_width\"?"
    );
    assert_eq!(
        refused::<Profile>(&machine(|m| m["cut"]["sped"] = json!(1))),
        "The machine has no field \"cut.sped\". Did you mean \"cut.speed\"?"
    );
    assert_eq!(
        refused::<PlanOptions>(&json!({ "machine": machine(|m| m["rapid"]["acel"] = json!(1)) })),
        "The machine has no field \"rapid.acel\". Did you mean \"rapid.accel\"?"
    );
    assert_eq!(
        refused::<Profile>(&machine(|m| m["cut"] = json!({ "power": 1 }))),
        "The machine lacks the field \"cut.speed\"."
    );
    // Serde alone refuses them, too, for callers in Rust.
    assert!(serde_json::from_value::<Profile>(machine(|m| m["kerf_witdh"] = json!(0.2))).is_err());
}

#[test]
fn misspelt_options_materials_and_parameters_are_refused_with_the_nearest_name() {
    assert_eq!(
        refused::<LoadOptions>(&json!({ "tolerence": 1 })),
        "Reading has no option \"tolerence\". Did you mean \"tolerance\"?"
    );
    assert_eq!(
        refused::<LoadOptions>(&json!({ "layers": [{ "name": "0", "operation": "cut", "rnak": 1 }] })),
        "Reading has no option \"layers[0].rnak\". There are: name, operation, speed, power, minPower, passes, zStep, air."
    );
    assert_eq!(
        refused::<PlanOptions>(&json!({ "second": 1 })),
        "Planning has no option \"second\". Did you mean \"seconds\"?"
    );
    assert_eq!(
        refused::<Material>(&json!({ "thicknes": 1 })),
        "The material has no field \"thicknes\". Did you mean \"thickness\"?"
    );
    let says = |name, parameters| papers::method(name, parameters).err().unwrap().message;
    assert_eq!(
        says("rlsga", r#"{"popluation":12}"#),
        "The method has no parameter \"popluation\". Did you mean \"population\"?"
    );
    assert!(says("rlsag", "").contains("Did you mean \"rlsga\"?"));
}

#[test]
fn every_number_of_a_machine_has_a_range_with_its_reason() {
    let mut seen = 0;
    for_numbers("", Profile::SHAPE.fields, &mut |path, range| {
        seen += 1;
        assert!(range.least <= range.most && range.least.is_finite() && range.most.is_finite(), "{path}");
        assert!(!range.why.is_empty(), "{path} has no reason");
    });
    assert!(seen >= 18, "{seen}");
    let says = refused::<Profile>(&machine(|m| m["max_s"] = json!(1e300)));
    assert!(
        says.starts_with("The machine's field \"max_s\" is 1e300. Give a number from 1 to 1000000: "),
        "{says}"
    );
}

fn for_numbers(prefix: &str, fields: &[Field], see: &mut dyn FnMut(&str, &fields::Range)) {
    for f in fields {
        let path = format!("{prefix}{}", f.name);
        match &f.kind {
            Kind::Number(range) | Kind::Whole(range) => see(&path, range),
            Kind::Pair(Kind::Number(range)) => see(&path, range),
            Kind::Object(fields) => for_numbers(&format!("{path}."), fields, see),
            _ => {}
        }
    }
}

#[test]
fn values_that_are_not_numbers_are_refused() {
    for n in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 1e300] {
        let given = |name: &str| Value::Object(vec![(name.to_owned(), Value::Number(n))]);
        for name in ["seconds", "moves", "seed", "workers", "member"] {
            let says = fields::read::<PlanOptions>(given(name)).unwrap_err().message;
            assert!(says.starts_with(&format!("The option \"{name}\" is ")), "{says}");
        }
        let says = fields::read::<Material>(given("thickness")).unwrap_err().message;
        assert!(says.starts_with("The material's field \"thickness\" is "), "{says}");
        // A caller in Rust fills the struct itself.
        let mut job = Job::load(square(), "square.dxf", &LoadOptions::default()).unwrap();
        let says = job.start(&PlanOptions { seconds: Some(n), ..PlanOptions::default() }).err().unwrap();
        assert!(matches!(says, JobError::Options(_)), "{says}");
    }
    let null = Value::Object(vec![("seconds".into(), Value::Null)]);
    assert!(
        fields::read::<PlanOptions>(null)
            .unwrap_err()
            .message
            .starts_with("The option \"seconds\" is null. Give a number")
    );
}

#[test]
fn parameters_that_would_use_all_memory_are_refused() {
    let says = |name, parameters| papers::method(name, parameters).err().unwrap().message;
    let many = says("lpspso", r#"{"particles":1000000000}"#);
    assert!(
        many.starts_with("The parameter \"particles\" is 1000000000. Give a number from 1 to 1000: "),
        "{many}"
    );
    assert!(says("rlsga", r#"{"alpha":null}"#).starts_with("The parameter \"alpha\" is null. "));
    assert!(says("rlsga", r#"{"measure":"miles"}"#).starts_with("The parameter \"measure\" is \"miles\". "));
    assert!(says("rlsga", "[]").starts_with("The parameters are "));
}

#[test]
fn written_files_are_accepted() {
    for profile in presets() {
        assert_eq!(fields::from_json::<Profile>(&serde_json::to_string(&profile).unwrap()).unwrap(), profile);
    }
    let load = LoadOptions::default();
    let mut json = serde_json::to_value(&load).unwrap();
    // What was not chosen is written as null.
    for name in ["units", "dpi"] {
        json.as_object_mut().unwrap().remove(name);
    }
    assert_eq!(fields::from_json::<LoadOptions>(&json.to_string()).unwrap(), load);
    for card in papers::cards() {
        let given = card.parameters.to_string();
        assert!(papers::method(card.info.name, &given).is_ok(), "{} {given}", card.info.name);
    }
}

#[test]
fn an_unknown_layer_is_a_finding_with_the_nearest_name() {
    let options =
        fields::from_json::<LoadOptions>(r#"{"layers":[{"name":"CTU","operation":"mark"}]}"#).unwrap();
    let job = Job::load(square(), "square.dxf", &options).unwrap();
    let report = serde_json::to_value(job.report()).unwrap();
    let finding =
        report["findings"].as_array().unwrap().iter().find(|f| f["code"] == "layer-unknown").unwrap();
    assert_eq!(finding["severity"], "warning");
    assert_eq!(finding["layer"], "CTU");
    assert_eq!(
        finding["message"],
        "The drawing has no layer \"CTU\", so the choice for it does nothing. Did you mean \"CUT\"?"
    );
}

pub(super) fn square() -> Vec<u8> {
    let corners = [(0, 0), (50, 0), (50, 50), (0, 50)];
    let mut text = "0\nSECTION\n2\nENTITIES\n".to_owned();
    for (k, (x, y)) in corners.iter().enumerate() {
        let (u, v) = corners[(k + 1) % 4];
        write!(text, "0\nLINE\n8\nCUT\n10\n{x}\n20\n{y}\n11\n{u}\n21\n{v}\n").unwrap();
    }
    text.push_str("0\nENDSEC\n0\nEOF\n");
    text.into_bytes()
}

/// TypeScript checks options by the same tables.
#[test]
fn the_tables_of_typescript_are_those_of_rust() {
    let tables = json!({
        "reading": LoadOptions::SHAPE, "planning": PlanOptions::SHAPE, "material": Material::SHAPE,
        "limits": Limits::SHAPE, "terms": Terms::SHAPE,
    });
    let text = format!(
        "/** The fields of options, machines and materials: written by the test `the_tables_of_typescript_are_those_of_rust`. */\n\n\
         import type {{ Shape }} from './check.js';\n\n\
         export const SHAPES: Readonly<Record<'reading' | 'planning' | 'material' | 'limits' | 'terms', Shape>> = {};\n",
        serde_json::to_string_pretty(&tables).unwrap()
    );
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/www/sdk/fields.ts");
    if std::env::var_os("KERFWAY_BLESS").is_some() {
        std::fs::write(file, &text).unwrap();
    }
    assert!(std::fs::read_to_string(file).unwrap() == text, "write it again with KERFWAY_BLESS=1");
}
