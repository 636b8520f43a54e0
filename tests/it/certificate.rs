//! Certificates of the lower bound: written for real drawings, verified without a search, and refused once anything in them, or
//! what they are shown with, is another.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use kerfway::drawing::TextDecoder;
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions, Proof, verify};
use kerfway::machine::{Profile, preset};
use kerfway::plan::with_paid;
use sha2::{Digest, Sha256};

/// Circles of several sizes in a grid, as many as there are places.
pub(crate) fn grid(columns: u32, rows: u32) -> Vec<u8> {
    let circle = |(x, y): (u32, u32)| {
        format!(
            "0\nCIRCLE\n8\n0\n10\n{}\n20\n{}\n40\n{}\n",
            25 + 30 * x,
            20 + 31 * y,
            4 + (3 * x + 5 * y) % 7
        )
    };
    let circles: String = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))).map(circle).collect();
    format!("0\nSECTION\n2\nENTITIES\n{circles}0\nENDSEC\n0\nEOF\n").into()
}

fn on(machine: &str) -> PlanOptions {
    PlanOptions { machine: MachineChoice::Preset(machine.into()), ..PlanOptions::default() }
}

/// Above 2^53 units, not every number of units is a floating-point number.
#[test]
#[allow(clippy::cast_possible_truncation, reason = "whole numbers")]
fn a_bound_of_very_many_units_is_not_rounded_up() {
    for proven in (1_i128 << 57)..(1 << 57) + 64 {
        let seconds = with_paid(0, proven, std::iter::empty());
        assert!(seconds as i128 <= proven && proven - (seconds as i128) < 64, "{proven} {seconds}");
        assert!(with_paid(0, 0, std::iter::once(proven as f64)) <= proven as f64);
    }
}

/// A certificate for the drawing after so much work, and the bound.
fn written(drawing: &[u8], options: &PlanOptions, work: u32) -> (String, f64) {
    let mut proof = Proof::start(drawing.to_vec(), "grid.dxf", LoadOptions::default(), options).unwrap();
    proof.improve(work);
    (proof.certificate().unwrap(), proof.seconds())
}

fn verified(text: &str, drawing: &[u8], machine: Option<&Profile>) -> Result<f64, String> {
    verify(text, drawing, machine, TextDecoder::default()).map(|v| v.seconds)
}

/// The file with another seal, which fits it: as somebody would write it who wants to be believed.
fn sealed(text: &str) -> String {
    let at = text.rfind("\"sha256\":\"").unwrap() + "\"sha256\":\"".len();
    let end = at + text[at..].find('"').unwrap();
    let empty = format!("{}{}", &text[..at], &text[end..]);
    let seal: String = Sha256::digest(&empty).iter().map(|b| format!("{b:02x}")).collect();
    format!("{}{seal}{}", &text[..at], &text[end..])
}

/// The file with another value, sealed again.
fn with(text: &str, path: &[&str], change: impl Fn(&serde_json::Value) -> serde_json::Value) -> String {
    let mut value: serde_json::Value = serde_json::from_str(text).unwrap();
    let place = path.iter().fold(&mut value, |v, step| match step.parse::<usize>() {
        Ok(index) => &mut v[index],
        Err(_) => &mut v[*step],
    });
    let (before, after) = (place.to_string(), change(place).to_string());
    assert_ne!(before, after);
    // In the text, so that the order of the fields stays: each name on the path follows the one before.
    let mut at = 0;
    for step in path {
        let Ok(index) = step.parse::<usize>() else {
            at += text[at..].find(&format!("\"{step}\":")).unwrap() + step.len() + 3;
            continue;
        };
        at += 1;
        for _ in 0..index {
            at += skipped(&text[at..]);
        }
    }
    assert_eq!(&text[at..at + before.len()], before);
    sealed(&format!("{}{after}{}", &text[..at], &text[at + before.len()..]))
}

/// Length of the first element of a list, with the comma after it.
fn skipped(text: &str) -> usize {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        match c {
            '[' | '{' => depth += 1,
            ']' | '}' => depth -= 1,
            ',' if depth == 0 => return at + 1,
            _ => {}
        }
    }
    text.len()
}

#[test]
fn a_certificate_proves_its_bound_and_no_plan_is_below_it() {
    let drawing = grid(5, 4);
    for machine in ["length", "co2-100w"] {
        let (text, seconds) = written(&drawing, &on(machine), 30_000_000);
        let proven = verified(&text, &drawing, None).unwrap();
        // What is proven without a certificate may be more.
        assert!(proven <= seconds && proven > 0.8 * seconds, "{proven} of {seconds}");
        assert_eq!(verified(&text, &drawing, preset(machine).as_ref()), Ok(proven));
        let mut job = Job::load(drawing.clone(), "grid.dxf", &LoadOptions::default()).unwrap();
        job.start(&on(machine)).unwrap();
        job.run_mut().unwrap().step(300_000);
        let total = job.plan().unwrap().summary.total_time;
        assert!(proven <= total && proven > 0.8 * total, "{proven} of {total}");
        // A bound that was proven elsewhere is that of the plan.
        job.run_mut().unwrap().raise_bound(proven);
        assert_eq!(job.plan().unwrap().summary.lower_bound.to_bits(), proven.to_bits());
    }
}

/// Beside the certificate, jobs of few contours are proven optimal, however the work is sliced.
#[test]
fn a_proof_of_few_contours_reaches_the_optimum() {
    let drawing = grid(4, 3);
    let proven = |slice: u32| {
        let mut proof =
            Proof::start(drawing.clone(), "grid.dxf", LoadOptions::default(), &on("length")).unwrap();
        (0..2_000_000_000 / slice).for_each(|_| {
            proof.improve(slice);
        });
        proof.seconds()
    };
    let mut job = Job::load(drawing.clone(), "grid.dxf", &LoadOptions::default()).unwrap();
    job.start(&on("length")).unwrap();
    job.run_mut().unwrap().step(1_000_000);
    let total = job.plan().unwrap().summary.total_time;
    let bound = proven(2_000_000);
    assert!(bound <= total && bound >= total * (1.0 - 1e-6), "{bound} of {total}");
    assert_eq!(bound.to_bits(), proven(500_000).to_bits());
}

#[test]
fn another_drawing_another_machine_and_damage_are_refused() {
    let drawing = grid(4, 3);
    let (text, _) = written(&drawing, &on("co2-100w"), 2_000_000);
    let refused =
        |text: &str, drawing: &[u8], machine: Option<&Profile>| verified(text, drawing, machine).unwrap_err();
    let other = refused(&text, &grid(4, 4), None);
    assert!(
        other.starts_with("The certificate is for another drawing: grid.dxf with the SHA-256 "),
        "{other}"
    );
    let length = preset("length").unwrap();
    assert_eq!(
        refused(&text, &drawing, Some(&length)),
        "The certificate is for the machine co2-100w, not for length."
    );
    let preset_machine = preset("co2-100w").unwrap();
    let elsewhere = Profile { home: [1.0, 0.0], ..preset_machine };
    assert_eq!(
        refused(&text, &drawing, Some(&elsewhere)),
        "The certificate is for a machine co2-100w with other settings."
    );
    // Also when it is written into the certificate.
    let written_in = with(&text, &["machine", "pierce_time"], |v| (2.0 * v.as_f64().unwrap()).into());
    assert_eq!(
        refused(&written_in, &drawing, None),
        "The machine in the certificate is not the one that its hash names."
    );
    let damaged = text.replacen("\"unit\":-", "\"unit\":-1", 1);
    assert_ne!(damaged, text);
    assert_eq!(
        refused(&damaged, &drawing, None),
        "The certificate was changed after it was written: its own hash does not fit it."
    );
    assert!(refused("{}", &drawing, None).contains("it has no text \"schema\""));
    assert!(refused("{\"schema\":\"kerfway.plan/1\"}", &drawing, None).contains("kind kerfway.plan/1"));
    assert!(refused("no JSON", &drawing, None).contains("line 1, column"));
    assert!(
        refused(&text.replacen("\"travel\"", "\"travels\"", 1), &drawing, None)
            .contains("does not fit the format")
    );
}

#[test]
fn a_bound_above_what_the_numbers_prove_is_refused() {
    let drawing = grid(4, 3);
    let (text, _) = written(&drawing, &on("length"), 2_000_000);
    let proven = verified(&text, &drawing, None).unwrap();
    let above = with(&text, &["seconds"], |v| (v.as_f64().unwrap() + 1e-6).into());
    let why = verified(&above, &drawing, None).unwrap_err();
    assert!(why.starts_with("The certificate states that no plan takes less than "), "{why}");
    let above = with(&text, &["travel", "bound"], |v| (v.as_i64().unwrap() + 1).into());
    assert!(verified(&above, &drawing, None).unwrap_err().contains("prove only"));
    // Less than what is proven is true as well.
    let below = with(&text, &["seconds"], |v| (v.as_f64().unwrap() - 1.0).into());
    assert_eq!(verified(&below, &drawing, None), Ok(proven - 1.0));
}

/// A certificate that was written before there were any by walks, sealed and all.
fn by_shares() -> String {
    include_str!("../fixtures/certificates/shares.json").trim_end().to_owned()
}

/// Certificates by shares are still written for thousands of contours, and old ones are still good.
#[test]
fn a_certificate_by_shares_is_verified() {
    assert_eq!(verified(&by_shares(), &grid(4, 3), None), Ok(822.265_142_492_95));
    let drawing = grid(48, 47);
    let (text, seconds) = written(&drawing, &on("length"), 3_000_000);
    assert!(text.contains("\"shares\":") && fits_the_schema(&text));
    let proven = verified(&text, &drawing, None).unwrap();
    assert!(proven <= seconds && proven >= seconds * (1.0 - 1e-9), "{proven} of {seconds}");
}

fn fits_the_schema(text: &str) -> bool {
    let schema = serde_json::from_str(include_str!("../../www/sdk/certificate.schema.json")).unwrap();
    let fault = crate::testkit::schema::fault(&schema, &schema, &serde_json::from_str(text).unwrap(), "");
    assert_eq!(fault, None);
    true
}

/// A file of a megabyte may ask for a thousand million legs.
#[test]
fn certificates_that_would_take_hours_to_check_are_refused() {
    let drawing = grid(2, 1);
    let (text, _) = written(&drawing, &on("length"), 1_000_000);
    let (at, end) = (text.rfind("\"travel\":{").unwrap(), text.rfind(",\"sha256\":").unwrap());
    let refused = |n: usize| {
        // Written as the file is, or its seal would not fit.
        let knots: Vec<String> = (0..n).map(|k| (1.0 + k as f64 / 16_384.0).to_string()).collect();
        let (knots, shares) = (format!("[{}]", knots.join(",")), serde_json::json!(vec![0; n]));
        let legs = format!(
            r#"[{{"items":[0,1],"shares":[[0],{shares}]}},{{"items":[0,2],"shares":[[0],{shares}]}},{{"items":[1,2],"shares":[{shares},{shares}]}}]"#
        );
        let travel = format!(
            r#"{{"unit":-31,"knots":[[],{knots},{knots}],"legs":{legs},"far":[0,0,0],"cuts":[],"bound":0}}"#
        );
        let text = format!("{}\"travel\":{travel}{}", &text[..at], &text[end..]);
        verified(&sealed(&text), &drawing, None).map_err(|e| e.split(" than").next().unwrap().to_owned())
    };
    // Zeros prove nothing, which is below the travel that the file states.
    assert_eq!(refused(100).unwrap_err(), "The certificate states that no plan takes less");
    assert_eq!(refused(20_000).unwrap_err(), "The certificate has more legs between knots");
    assert_eq!(refused(200_001).unwrap_err(), "The certificate has more knots");
}

/// Where walks prove no more, the certificate is that by flows.
#[test]
fn a_certificate_by_flows_is_verified() {
    let drawing = grid(16, 14);
    let (text, seconds) = written(&drawing, &on("length"), 200_000_000);
    assert!(text.contains("\"near\":") && text.contains("\"potentials\":") && fits_the_schema(&text));
    let proven = verified(&text, &drawing, None).unwrap();
    assert!(proven <= seconds && proven >= seconds * (1.0 - 1e-9), "{proven} of {seconds}");
}

/// Up to 220 contours, walks may prove more than flows. Their certificate is in the file then.
#[test]
fn a_certificate_by_walks_is_verified() {
    let drawing = grid(4, 3);
    // On the second machine the search goes first, for three turns.
    for (machine, work) in [("length", 3_000_000), ("co2-100w", 6_000_000)] {
        let (text, seconds) = written(&drawing, &on(machine), work);
        assert!(text.contains("\"company\":") && !text.contains("all_orders") && fits_the_schema(&text));
        let proven = verified(&text, &drawing, None).unwrap();
        assert!(proven <= seconds && proven > 0.99 * seconds, "{proven} of {seconds}");
        let value: serde_json::Value = serde_json::from_str(&text).unwrap();
        let charges = value["travel"]["charges"].as_array().unwrap().len();
        let mut refused = 0;
        for k in 1..charges {
            let index = k.to_string();
            for by in [-100_000_000_000_i64, 100_000_000_000] {
                let changed =
                    with(&text, &["travel", "charges", &index], |v| (v.as_i64().unwrap() + by).into());
                match verified(&changed, &drawing, None) {
                    Ok(seconds) => assert_eq!(seconds.to_bits(), proven.to_bits()),
                    Err(why) => {
                        assert!(why.contains("prove only"), "{why}");
                        refused += 1;
                    }
                }
            }
        }
        assert!(refused > charges, "{refused} of {charges}");
        let forgets = with(&text, &["travel", "company"], |v| {
            v.as_array().unwrap().iter().map(|_| serde_json::json!([])).collect()
        });
        assert!(verified(&forgets, &drawing, None).unwrap_err().contains("prove only"));
        let above = with(&text, &["travel", "bound"], |v| (v.as_i64().unwrap() + 1).into());
        assert!(verified(&above, &drawing, None).unwrap_err().contains("prove only"));
        let far = with(&text, &["travel", "knots", "1", "0"], |v| (v.as_f64().unwrap() - 0.5).into());
        assert_eq!(
            verified(&far, &drawing, None).unwrap_err(),
            "The knots of the certificate do not fit the problem."
        );
        let home = with(&text, &["travel", "charges", "0"], |v| (v.as_i64().unwrap() + 1).into());
        assert_eq!(
            verified(&home, &drawing, None).unwrap_err(),
            "The charges of the certificate do not fit the problem."
        );
        let unit = with(&text, &["travel", "unit"], |v| (v.as_i64().unwrap() + 1).into());
        assert!(verified(&unit, &drawing, None).unwrap_err().starts_with("The units of the certificate"));
        assert!(verified(&text, &grid(4, 4), None).is_err());
    }
}

/// Between the contours whose orders are all looked at and those for which only shares are left, there are walks as well.
#[test]
fn more_than_128_contours_have_certificates_by_walks() {
    let drawing = grid(13, 10);
    let (text, seconds) = written(&drawing, &on("length"), 400_000_000);
    assert!(text.contains("\"company\":") && fits_the_schema(&text));
    let proven = verified(&text, &drawing, None).unwrap();
    assert!(proven <= seconds && proven >= seconds * (1.0 - 1e-6), "{proven} of {seconds}");
    let mut job = Job::load(drawing, "grid.dxf", &LoadOptions::default()).unwrap();
    job.start(&on("length")).unwrap();
    job.run_mut().unwrap().step(300_000);
    let total = job.plan().unwrap().summary.total_time;
    assert!(proven <= total && proven > 0.8 * total, "{proven} of {total}");
}

/// Whoever changes a number and seals the file again gets no more than the numbers prove.
#[test]
fn a_changed_number_proves_no_more() {
    let drawing = grid(4, 3);
    let text = by_shares();
    let proven = verified(&text, &drawing, None).unwrap();
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    let legs = value["travel"]["legs"].as_array().unwrap().len();
    let mut refused = 0;
    for k in 0..legs {
        let index = k.to_string();
        for by in [-1_000_000_000_i64, 1_000_000_000] {
            let changed = with(&text, &["travel", "legs", &index, "shares", "0", "0"], |v| {
                (v.as_i64().unwrap() + by).into()
            });
            match verified(&changed, &drawing, None) {
                Ok(seconds) => assert_eq!(seconds.to_bits(), proven.to_bits()),
                Err(why) => {
                    assert!(why.contains("prove only"), "{why}");
                    refused += 1;
                }
            }
        }
    }
    assert!(refused > legs / 4, "{refused} of {legs}");
    let far = with(&text, &["travel", "knots", "1", "0"], |v| (v.as_f64().unwrap() + 0.5).into());
    assert!(verified(&far, &drawing, None).is_err());
    let unit = with(&text, &["travel", "unit"], |v| (v.as_i64().unwrap() + 1).into());
    assert_eq!(
        verified(&unit, &drawing, None).unwrap_err(),
        "The units of the certificate do not fit the problem."
    );
}

/// Contours that may be left unfinished have certificates of another kind, under the same rules.
#[test]
fn contours_that_may_be_left_have_certificates() {
    let drawing = grid(5, 4);
    let leaving = Profile { pre_cut_time: Some(0.3), ..preset("co2-100w").unwrap() };
    let options =
        PlanOptions { machine: MachineChoice::Profile(Box::new(leaving)), ..PlanOptions::default() };
    for options in [on("length-partial"), options] {
        let (text, seconds) = written(&drawing, &options, 30_000_000);
        assert!(text.contains("\"potentials\":"));
        let proven = verified(&text, &drawing, None).unwrap();
        assert!(proven <= seconds && proven >= seconds * (1.0 - 1e-9), "{proven} of {seconds}");
        let mut job = Job::load(drawing.clone(), "grid.dxf", &LoadOptions::default()).unwrap();
        job.start(&options).unwrap();
        job.run_mut().unwrap().step(300_000);
        let total = job.plan().unwrap().summary.total_time;
        assert!(proven <= total && proven > 0.8 * total, "{proven} of {total}");
        assert!(verified(&text, &grid(4, 4), None).is_err());
        let above = with(&text, &["travel", "bound"], |v| (v.as_i64().unwrap() + 1).into());
        assert!(verified(&above, &drawing, None).unwrap_err().contains("prove only"));
        let changed = with(&text, &["travel", "potentials", "3", "0"], |v| {
            (v.as_i64().unwrap() + 1_000_000_000_000).into()
        });
        assert_eq!(
            verified(&changed, &drawing, None).unwrap_err(),
            "In the certificate, a leg costs less than it pays."
        );
    }
}
