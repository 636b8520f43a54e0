//! The planner for JavaScript: one drawing through the whole flow, see [`crate::job`].

use super::arrays::{bytes, geometry, handed, object, path};
use super::failure::Failure;
use super::plain::plain;
use super::text::decode;
use super::values::{options, text};
use crate::drawing::TextDecoder;
use crate::job::{self, BestPath, Budget, LoadOptions, PlanOptions};
use crate::output::json_text;
use crate::{machine, solve};
use js_sys::Uint32Array;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = "import type {
  Baselines, Beam, BestPath, Budget, Dialect, Finding, Geometry, Insight, Loaded, LoadOptions, MachineProfile, MethodInfo, Slice, StartOptions, Summary, WarmPath,
} from '../protocol.js';
import type { Quote, QuoteTerms } from '../quote.js';";

/// All methods, the default first.
#[wasm_bindgen(unchecked_return_type = "MethodInfo[]")]
pub fn methods() -> Result<JsValue, JsError> {
    plain(&solve::methods().iter().map(|m| m.info()).collect::<Vec<_>>())
}

/// All preset machines.
#[wasm_bindgen(unchecked_return_type = "MachineProfile[]")]
pub fn machines() -> Result<JsValue, JsError> {
    plain(&machine::presets())
}

/// All shipped dialects of G-code, the default first.
#[wasm_bindgen(unchecked_return_type = "Dialect[]")]
pub fn dialects() -> Result<JsValue, JsError> {
    plain(&machine::dialect::dialects())
}

/// The profile of the machine of these options, checked, as JSON: for the file that checks programs.
#[wasm_bindgen(js_name = checkedMachine)]
pub fn checked_machine(
    #[wasm_bindgen(unchecked_param_type = "StartOptions")] plan_options: JsValue,
) -> Result<String, Failure> {
    Ok(json_text(&options::<PlanOptions>(&plan_options)?.machine.profile()?))
}

/// The work order of a small program for a machine, which shows what its dialect looks like.
#[wasm_bindgen(js_name = sampleOrder)]
pub fn sample_order(
    #[wasm_bindgen(unchecked_param_type = "StartOptions")] plan_options: JsValue,
) -> Result<String, Failure> {
    Ok(json_text(&job::sample_order(options::<PlanOptions>(&plan_options)?.machine)?))
}

/// A seed for callers who give none, from the platform's random numbers. It is part of the result, so that the plan can be
/// computed again.
#[wasm_bindgen(js_name = randomSeed)]
pub fn random_seed() -> Result<u32, JsError> {
    getrandom::u32()
        .map_err(|e| JsError::new(&format!("This platform gives no random numbers: {e}. Give a seed.")))
}

/// The paths of the beam if they differ from the drawing, and the common cuts.
fn lines(job: &job::Job) -> Result<[JsValue; 2], JsError> {
    let beam = job
        .beam_paths()
        .map(|(contours, lines)| object(&[("contours", plain(&contours)?), ("geometry", geometry(&lines)?)]));
    Ok([beam.transpose()?.unwrap_or(JsValue::NULL), geometry(&job.common_cuts())?])
}

/// Whether a file is SVG, by its first 256 kB.
#[wasm_bindgen(js_name = isSvg)]
pub fn is_svg(head: &[u8]) -> bool {
    job::is_svg(head)
}

/// The options for reading, with the platform's text decoder.
pub(super) fn load_options_of(value: &JsValue) -> Result<LoadOptions, Failure> {
    let given: LoadOptions = options(value)?;
    Ok(LoadOptions { decoder: TextDecoder(decode), ..given })
}

/// One drawing through the whole flow.
#[wasm_bindgen]
pub struct Job(job::Job);

#[wasm_bindgen]
impl Job {
    /// Reads a drawing and arranges its contours.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Uint8Array")] file: JsValue,
        #[wasm_bindgen(unchecked_param_type = "string")] name: JsValue,
        #[wasm_bindgen(unchecked_param_type = "LoadOptions")] load_options: JsValue,
    ) -> Result<Job, Failure> {
        let (file, name) = (bytes(&file)?, text("file's name", &name)?);
        Ok(Job(job::Job::load(file, &name, &load_options_of(&load_options)?)?))
    }

    /// Applies other options to the same file.
    pub fn reload(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "LoadOptions")] load_options: JsValue,
    ) -> Result<(), Failure> {
        Ok(self.0.reload(&load_options_of(&load_options)?)?)
    }

    /// The bytes of the file.
    pub fn bytes(&self) -> Vec<u8> {
        self.0.bytes().to_vec()
    }

    /// A report on the content of the drawing.
    #[wasm_bindgen(unchecked_return_type = "Omit<Loaded, 'geometry' | 'ignored'>")]
    pub fn report(&self) -> Result<JsValue, Failure> {
        Ok(plain(&self.0.report())?)
    }

    /// The geometry of the contours, by id.
    #[wasm_bindgen(unchecked_return_type = "Geometry")]
    pub fn geometry(&self) -> Result<JsValue, Failure> {
        Ok(geometry(&self.0.geometry())?)
    }

    /// The geometry of what is shown but not cut, with the layer of each path.
    #[wasm_bindgen(unchecked_return_type = "Loaded['ignored']")]
    pub fn ignored(&self) -> Result<JsValue, Failure> {
        let layers: Vec<u32> = self.0.sheet().ignored.iter().map(|i| i.layer).collect();
        Ok(object(&[
            ("geometry", geometry(&self.0.ignored())?),
            ("layers", Uint32Array::from(layers.as_slice()).into()),
        ])?)
    }

    /// Starts a plan. The current one is dropped.
    #[wasm_bindgen(
        unchecked_return_type = "{ seed: number; method: string; baselines: Baselines; findings: Finding[]; beam: Beam | null; common: Geometry | null; shift: [number, number] }"
    )]
    pub fn start(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "StartOptions")] plan_options: JsValue,
    ) -> Result<JsValue, Failure> {
        self.0.start(&options(&plan_options)?)?;
        let [beam, common] = lines(&self.0)?;
        let run = self.0.run()?;
        Ok(object(&[
            ("seed", plain(&run.seed)?),
            ("method", run.method.as_str().into()),
            ("baselines", plain(&run.baselines)?),
            ("findings", plain(&run.findings)?),
            ("beam", beam),
            ("common", common),
            ("shift", plain(&run.placed.shift.to_array())?),
        ])?)
    }

    /// Does at most `work` moves, and never more than the budget.
    #[wasm_bindgen(unchecked_return_type = "Slice")]
    pub fn step(&mut self, work: u32) -> Result<JsValue, Failure> {
        Ok(plain(&self.0.run_mut()?.step(work.into()))?)
    }

    /// Grants another budget in addition to what is done.
    pub fn extend(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Budget")] more: JsValue,
    ) -> Result<(), Failure> {
        self.0.run_mut()?.extend(options::<Budget>(&more)?);
        Ok(())
    }

    /// Takes over a path of another search that belongs to the same plan, if it is better. Returns whether it did.
    pub fn offer(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "WarmPath")] path: JsValue,
    ) -> Result<bool, Failure> {
        Ok(self.0.run_mut()?.offer(&handed(&path)?)?)
    }

    /// Takes over a path from elsewhere if it is better. Returns whether it did.
    #[wasm_bindgen(js_name = takeOver)]
    pub fn take_over(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "WarmPath")] path: JsValue,
    ) -> Result<bool, Failure> {
        Ok(self.0.run_mut()?.take_over(&handed(&path)?)?)
    }

    /// Takes over a lower bound of every plan in seconds, which was proven elsewhere.
    #[wasm_bindgen(js_name = raiseBound)]
    pub fn raise_bound(&mut self, seconds: f64) -> Result<(), Failure> {
        self.0.run_mut()?.raise_bound(seconds);
        Ok(())
    }

    /// Insight into a published method; `null` for other methods.
    #[wasm_bindgen(unchecked_return_type = "Insight | null")]
    pub fn insight(&self) -> Result<JsValue, Failure> {
        Ok(self.0.run()?.insight().map_or(Ok(JsValue::NULL), |insight| plain(&insight))?)
    }

    /// Moves done so far.
    pub fn moves(&self) -> Result<f64, Failure> {
        Ok(self.0.run()?.moves as f64)
    }

    /// The best path so far and its summary.
    #[wasm_bindgen(unchecked_return_type = "{ path: BestPath; summary: Summary }")]
    pub fn best(&self) -> Result<JsValue, Failure> {
        let (best, plan) = BestPath::of(self.0.run()?, self.0.beam_sheet());
        Ok(object(&[("path", path(&best)?), ("summary", plain(&plan.summary)?)])?)
    }

    /// The plan document of the best plan so far, checked.
    pub fn document(&self) -> Result<String, Failure> {
        Ok(json_text(&self.0.document()?))
    }

    /// The best plan so far, checked, as a work order for the file that writes outputs.
    #[wasm_bindgen(js_name = workOrder)]
    pub fn work_order(
        &self,
        #[wasm_bindgen(unchecked_param_type = "string")] kind: JsValue,
    ) -> Result<String, Failure> {
        Ok(json_text(&self.0.work_order(text("kind of output", &kind)?.parse()?)?))
    }

    /// What a price needs of the best plan so far, which is checked first.
    #[wasm_bindgen(unchecked_return_type = "Quote")]
    pub fn quote(
        &self,
        #[wasm_bindgen(unchecked_param_type = "QuoteTerms")] terms: JsValue,
    ) -> Result<JsValue, Failure> {
        Ok(plain(&self.0.quote(&options(&terms)?)?)?)
    }
}
