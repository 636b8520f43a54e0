//! Verifies certificate files, without a search.

use super::file::File;
use super::problem;
use crate::drawing::TextDecoder;
use crate::machine::Profile;
use crate::output::{json_text, sha256};
use serde::Serialize;

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
    let settings = (file.material.clone(), file.place, file.start);
    let problem = problem(drawing, &file.drawing.name, &file.reading, &file.machine, settings)
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
    let paid = problem.paid();
    Ok(Verified { seconds: file.seconds, paid, drawing: file.drawing.name, machine: file.machine.name })
}
