//! Published methods, benchmark instances and proofs of the lower bound for JavaScript, which only the research build contains.

use super::arrays::{bytes, warm_path};
use super::failure::Failure;
use super::plain::plain;
use super::planner::load_options_of;
use super::text::decode;
use super::values::{options, text};
use crate::drawing::TextDecoder;
use crate::job::{self, MachineChoice, PlanOptions};
use crate::solve::papers;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str =
    "import type { LoadOptions, PaperMethod, StartOptions, Verified, WarmPath } from '../protocol.js';";

/// The methods of published papers, with their parameters.
#[wasm_bindgen(js_name = paperMethods, unchecked_return_type = "PaperMethod[]")]
pub fn paper_methods() -> Result<JsValue, JsError> {
    plain(&papers::cards())
}

/// The default method on an instance of the TSPLIB family.
#[wasm_bindgen]
pub struct Solving(job::Solving);

#[wasm_bindgen]
impl Solving {
    /// Reads an instance and starts the search.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8], seed: f64) -> Result<Solving, JsError> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a seed is a whole number"
        )]
        Ok(Solving(job::Solving::start(bytes, seed as u64)?))
    }

    /// The name of the instance, as given in the file.
    pub fn name(&self) -> String {
        self.0.name().to_owned()
    }

    /// Does at most `work` moves. Returns false when nothing can be improved any more.
    pub fn step(&mut self, work: u32) -> bool {
        self.0.step(work.into())
    }

    /// Lower bound of the length of every tour, if there is one.
    #[wasm_bindgen(js_name = lowerBound)]
    pub fn lower_bound(&self) -> Option<f64> {
        self.0.lower_bound()
    }

    /// Moves done so far.
    pub fn moves(&self) -> f64 {
        self.0.moves() as f64
    }

    /// The best tour so far, by the numbers of the file.
    pub fn tour(&self) -> Vec<u32> {
        self.0.tour()
    }

    /// The length of the best tour, computed again after the tour has passed its check.
    pub fn length(&self) -> Result<f64, JsError> {
        Ok(self.0.length()?)
    }
}

/// Work on the lower bound of a job, and its certificate.
#[wasm_bindgen]
pub struct Proof(job::Proof);

#[wasm_bindgen]
impl Proof {
    /// Reads a drawing and starts with a weak bound.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Uint8Array")] file: JsValue,
        #[wasm_bindgen(unchecked_param_type = "string")] name: JsValue,
        #[wasm_bindgen(unchecked_param_type = "LoadOptions")] load_options: JsValue,
        #[wasm_bindgen(unchecked_param_type = "StartOptions")] plan_options: JsValue,
    ) -> Result<Proof, Failure> {
        let (file, name) = (bytes(&file)?, text("file's name", &name)?);
        let planning: PlanOptions = options(&plan_options)?;
        Ok(Proof(job::Proof::start(file, &name, load_options_of(&load_options)?, &planning)?))
    }

    /// Why nothing can be proven in this way, in a sentence, if so.
    pub fn hindrance(&self) -> Option<String> {
        self.0.hindrance().map(str::to_owned)
    }

    /// Looks at about `work` more numbers. Returns whether more work may help.
    pub fn improve(&mut self, work: u32) -> bool {
        self.0.improve(work)
    }

    /// No plan takes less, s.
    pub fn seconds(&self) -> f64 {
        self.0.seconds()
    }

    /// The best path that it has found, if that is better than the one that was told before.
    #[wasm_bindgen(js_name = betterPath, unchecked_return_type = "WarmPath | null")]
    pub fn better_path(&mut self) -> Result<JsValue, JsError> {
        self.0.better_path().map_or(Ok(JsValue::NULL), |path| warm_path(&path))
    }

    /// The certificate file of the bound, if anything is proven.
    pub fn certificate(&self) -> Option<String> {
        self.0.certificate()
    }
}

/// Verifies a certificate file for a drawing, and for a machine if one is given.
#[wasm_bindgen(js_name = verifyCertificate, unchecked_return_type = "Verified")]
pub fn verify_certificate(
    #[wasm_bindgen(unchecked_param_type = "string")] certificate: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Uint8Array")] drawing: JsValue,
    #[wasm_bindgen(unchecked_param_type = "StartOptions")] plan_options: JsValue,
) -> Result<JsValue, Failure> {
    let machine = match options::<PlanOptions>(&plan_options)?.machine {
        MachineChoice::Profile(profile) => Some(profile),
        MachineChoice::Preset(_) => None,
    };
    let certificate = text("certificate", &certificate)?;
    let verified = job::verify(&certificate, &bytes(&drawing)?, machine.as_deref(), TextDecoder(decode))
        .map_err(|e| JsError::new(&e))?;
    Ok(plain(&verified)?)
}
