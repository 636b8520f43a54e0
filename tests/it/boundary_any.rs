//! Any value that a caller may hand over, made at random from the tables of fields, is accepted or refused in a sentence.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]

use super::boundary::square;
use super::testkit::rng::{Rng, seeded};
use kerfway::fields::{self, Field, Kind, Shaped, Value};
use kerfway::job::{Job, LoadOptions, PlanOptions};
use kerfway::machine::{Profile, ProfileError};
use kerfway::quote::{Material, Terms};
use rand::RngExt;

/// Any value at all, often near what a field takes.
fn junk(rng: &mut Rng, deep: u32) -> Value {
    const NUMBERS: [f64; 14] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.5,
        3.0,
        1e-300,
        1e300,
        1e9,
        4e9,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        9e15,
    ];
    const TEXTS: [&str; 9] =
        ["", "mm", "cut", "co2-100w", "best", "straight", "grbl-m4", "\u{1b}[2J", "__proto__"];
    match rng.random_range(0..if deep == 0 { 5 } else { 7 }) {
        0 => Value::Null,
        1 => Value::Flag(rng.random_bool(0.5)),
        2 | 3 => Value::Number(NUMBERS[rng.random_range(0..NUMBERS.len())]),
        4 => Value::Text(TEXTS[rng.random_range(0..TEXTS.len())].to_owned()),
        5 => Value::List((0..rng.random_range(0..4)).map(|_| junk(rng, deep - 1)).collect()),
        _ => Value::Object(
            (0..rng.random_range(0..4))
                .map(|k| (format!("{}{k}", TEXTS[rng.random_range(0..9)]), junk(rng, deep - 1)))
                .collect(),
        ),
    }
}

/// A value that a field takes, at times spoilt.
fn near(rng: &mut Rng, kind: &Kind) -> Value {
    if rng.random_range(0..45) == 0 {
        return junk(rng, 3);
    }
    match kind {
        Kind::Flag => Value::Flag(rng.random_bool(0.5)),
        Kind::Text | Kind::NameOr(_) if rng.random_bool(0.5) => Value::Text("co2-100w".into()),
        Kind::Text | Kind::Parameters => Value::Text("{}".into()),
        Kind::Choice(words) => Value::Text(words[rng.random_range(0..words.len())].to_owned()),
        Kind::Number(r) | Kind::Whole(r) => {
            Value::Number([r.least, r.most, r.least + 1.0][rng.random_range(0..3)])
        }
        Kind::Pair(kind) => Value::List(vec![near(rng, kind), near(rng, kind)]),
        Kind::Four(kind) => Value::List((0..4).map(|_| near(rng, kind)).collect()),
        Kind::List(kind) => Value::List((0..rng.random_range(0..3)).map(|_| near(rng, kind)).collect()),
        Kind::Object(fields) => object(rng, fields),
        Kind::NameOr(shape) => object(rng, shape.fields),
    }
}

fn object(rng: &mut Rng, fields: &[Field]) -> Value {
    let mut given = Vec::new();
    for f in fields {
        if f.required && rng.random_range(0..60) > 0 || rng.random_range(0..3) == 0 {
            let name = if rng.random_range(0..60) == 0 { format!("{}s", f.name) } else { f.name.to_owned() };
            given.push((name, near(rng, &f.kind)));
        }
    }
    Value::Object(given)
}

fn taken_or_refused<T: Shaped>(rng: &mut Rng, use_it: impl Fn(T)) -> [u32; 2] {
    let mut counts = [0; 2];
    for _ in 0..4_000 {
        let value = if rng.random_range(0..8) == 0 { junk(rng, 4) } else { object(rng, T::SHAPE.fields) };
        match fields::read::<T>(value.clone()) {
            Ok(taken) => {
                counts[0] += 1;
                use_it(taken);
            }
            Err(error) => {
                counts[1] += 1;
                let says = error.message;
                let whole = says.starts_with(&format!("{} is ", T::SHAPE.owner));
                assert_eq!(error.field.is_empty(), whole, "{says}");
                let names = says.contains('"') || says.starts_with(T::SHAPE.owner);
                let one = !says.contains('\n') && !says.contains('\u{1b}') && says.len() < 400;
                assert!(names && one && says.ends_with(['.', '?']), "{says}\nof {value:?}");
                assert!(
                    !says.contains("cannot be read"),
                    "serde refuses what the table takes: {says}\nof {value:?}"
                );
            }
        }
    }
    counts
}

#[test]
fn any_value_is_accepted_or_refused_in_a_sentence() {
    let mut rng = seeded(22);
    let file = square();
    let loads = taken_or_refused::<LoadOptions>(&mut rng, |options| {
        let _ = Job::load(file.clone(), "square.dxf", &options)
            .map(|job| serde_json::to_string(&job.report()).unwrap());
    });
    let plans = taken_or_refused::<PlanOptions>(&mut rng, |options| {
        let mut job = Job::load(file.clone(), "square.dxf", &LoadOptions::default()).unwrap();
        if let Ok(run) = job.start(&options).map(|_| ()).and_then(|()| job.run_mut()) {
            run.step(500);
            // A home far from the origin is refused there, in a sentence.
            if let Ok(gcode) = job.output(kerfway::job::OutputKind::Gcode) {
                assert!(gcode.lines().all(|line| line.len() <= 256), "{options:?}");
            }
        }
    });
    let machines = taken_or_refused::<Profile>(&mut rng, |profile| {
        // Values may contradict each other although each is valid: a bed without an area, moving starts with pre-cuts.
        let sound = matches!(
            profile.validate(),
            Ok(())
                | Err(ProfileError::Bed(..)
                    | ProfileError::Dialect(_)
                    | ProfileError::Materials(_)
                    | ProfileError::MovingPreCuts
                    | ProfileError::FlyPreCuts
                    | ProfileError::ChainsWith(_)
                    | ProfileError::CommonCutsWith(_)
                    | ProfileError::LiftWithoutZ
                    | ProfileError::TipsWithoutLift
                    | ProfileError::TipsWithPreCuts
                    | ProfileError::HeatWithFly
                    | ProfileError::HeatWithPreCuts)
        );
        assert!(sound, "{profile:?}");
    });
    let materials = taken_or_refused::<Material>(&mut rng, |_| ());
    let terms = taken_or_refused::<Terms>(&mut rng, |_| ());
    for [taken, refused] in [loads, plans, machines, materials, terms] {
        assert!(taken > 200 && refused > 200, "{taken} taken, {refused} refused");
    }
}
