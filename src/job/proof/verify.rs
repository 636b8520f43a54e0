//! Verifies certificate files, without a search.

use super::file::File;
use super::problem;
use crate::drawing::TextDecoder;
use crate::job::LoadOptions;
use crate::machine::{Profile, preset};
use crate::output::{json_text, sha256};
use serde::Serialize;
use serde_json::to_value;

/// What a certificate file proves.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Verified {
    /// No plan takes less, s.
    pub seconds: f64,
    /// Of these, what every plan pays for piercing, cutting and marking, s.
    pub paid: f64,
    /// Name of the drawing's file when the certificate was written.
    pub drawing: String,
    /// Name of the machine.
    pub machine: String,
    /// Whether that is the preset of this name, or the machine that was asked for: others may call themselves as they like.
    pub known_machine: bool,
    /// What it was planned with other than the defaults: options of reading, material, place and start, as a JSON object.
    pub settings: String,
}

/// Verifies a certificate file for a drawing. `machine`: the machine that it should be for; `None`: that of the file. `decoder`:
/// as in [`LoadOptions`](crate::job::LoadOptions).
///
/// # Errors
/// One sentence: why it proves nothing about this drawing and machine.
pub fn verify(
    text: &str,
    drawing: &[u8],
    machine: Option<&Profile>,
    decoder: TextDecoder,
) -> Result<Verified, String> {
    let mut file = File::read(text)?;
    file.reading.decoder = decoder;
    if file.sha256 != file.seal() {
        return Err("The certificate was changed after it was written: its own hash does not fit it.".into());
    }
    if sha256(json_text(&file.machine)) != file.machine_sha256 {
        return Err("The machine in the certificate is not the one that its hash names.".into());
    }
    if machine.is_some_and(|m| sha256(json_text(m)) != file.machine_sha256) {
        let (this, other) = (&file.machine.name, machine.map_or("", |m| m.name.as_str()));
        return Err(if this == other {
            format!("The certificate is for a machine {this} with other settings.")
        } else {
            format!("The certificate is for the machine {this}, not for {other}.")
        });
    }
    if sha256(drawing) != file.drawing.sha256 {
        return Err(format!(
            "The certificate is for another drawing: {} with the SHA-256 {}.",
            file.drawing.name, file.drawing.sha256
        ));
    }
    let given = (file.material.clone(), file.place, file.start);
    let problem = problem(drawing, &file.drawing.name, &file.reading, &file.machine, given)
        .map_err(|e| format!("The certificate's drawing cannot be planned as it says: {e}"))?;
    let proven = file.travel.certified().adds_up_to(&problem).map_err(|e| e.to_string())?;
    let seconds = file.travel.whole_job(proven, &problem);
    let stated = i128::from(file.travel.certified().stated().0);
    // Nothing that is stated may be above what is proven: neither the travel nor the whole.
    if stated > proven || file.seconds > seconds {
        return Err(format!(
            "The certificate states that no plan takes less than {} s, but its numbers prove only {seconds} s.",
            file.seconds.max(file.travel.whole_job(stated, &problem))
        ));
    }
    let is_preset = preset(&file.machine.name).is_some_and(|p| sha256(json_text(&p)) == file.machine_sha256);
    Ok(Verified {
        seconds: file.seconds,
        paid: problem.paid(),
        known_machine: machine.is_some() || is_preset,
        settings: other_than_usual(&file),
        drawing: file.drawing.name,
        machine: file.machine.name,
    })
}

/// What differs from the defaults in a certificate file, as a JSON object.
fn other_than_usual(file: &File) -> String {
    let reading = |options: &LoadOptions| to_value(options).ok().and_then(|v| v.as_object().cloned());
    let usual = reading(&LoadOptions::default()).unwrap_or_default();
    let mut all = reading(&file.reading).unwrap_or_default();
    all.retain(|name, value| usual.get(name) != Some(value));
    let others = [
        ("material", to_value(&file.material)),
        ("place", to_value(file.place)),
        ("start", to_value(Some(file.start).filter(|start| !start.is_absolute()))),
    ];
    let given = others.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value.ok()?)));
    all.extend(given.filter(|(_, value)| !value.is_null()));
    json_text(&all)
}
