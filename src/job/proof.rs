//! Proofs of the lower bound: certificate files (`kerfway.certificate/1`) and their verification.
//!
//! A certificate file names the drawing by its hash and holds everything that decides what a plan takes: how the drawing is
//! read, the machine, the setting and the place on the bed. From these the problem is made again, and the numbers of the
//! [`FlowCertificate`], of the [`Certificate`] by shares, of the [`WalkCertificate`] or of the [`StopCertificate`] are added up again in whole numbers. How they were found does not matter, and no search is needed.

use super::optimum::{Optimum, TURN};
use super::{Job, JobError, LoadOptions, MachineChoice, Place, PlanOptions, WarmPath, warm_path};
use crate::drawing::TextDecoder;
use crate::machine::{Profile, Start};
use crate::output::{json_text, sha256};
use crate::plan::{
    Certificate, Certified, FlowBound, FlowCertificate, ShareBound, StopBound, StopCertificate,
    WalkCertificate, with_paid,
};
use crate::problem::{Item, Problem};
use serde::{Deserialize, Serialize};

/// The name and version of the format.
pub const CERTIFICATE_SCHEMA: &str = "kerfway.certificate/1";

/// Numbers of the bound by walks for one of that by flows, which takes twice as long.
const WALKS_PER_FLOW: u32 = 2;
/// While walks have proven more than flows, which is usual up to a hundred contours, flows get every fourth turn only: with half of the time for
/// them, 46 contours took 1.75 times as long.
const BEHIND: u64 = 4;

/// A certificate file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    /// Name and version of the format: [`CERTIFICATE_SCHEMA`].
    schema: String,
    /// No plan takes less, s.
    seconds: f64,
    drawing: Drawing,
    /// How the drawing is read.
    reading: LoadOptions,
    machine: Profile,
    /// SHA-256 of the machine's JSON.
    machine_sha256: String,
    material: Option<String>,
    place: Option<Place>,
    start: Start,
    /// The numbers that prove the least travel.
    travel: Travel,
    /// SHA-256 of the file with this field empty, so that damage is noticed.
    sha256: String,
}

/// The kinds of certificates, which have different fields.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
enum Travel {
    /// For up to 2,200 contours.
    Flows(FlowCertificate),
    /// For more contours.
    Shares(Certificate),
    /// For up to 220 contours, where it proves more.
    Walks(WalkCertificate),
    /// Where contours may be left unfinished or are cut as one.
    Stops(StopCertificate),
}

impl Travel {
    fn certified(&self) -> &dyn Certified {
        match self {
            Self::Flows(certificate) => certificate,
            Self::Shares(certificate) => certificate,
            Self::Walks(certificate) => certificate,
            Self::Stops(certificate) => certificate,
        }
    }

    /// The least seconds of the whole job, rounded down: a proven travel in units, and what every plan pays.
    fn whole_job(&self, proven: i128, problem: &Problem) -> f64 {
        with_paid(self.certified().stated().1, proven, problem.items.iter().map(Item::least))
    }
}

/// The bound that has a certificate.
enum Bound {
    Flows(Box<FlowBound>),
    Shares(Box<ShareBound>),
    Stops(Box<StopBound>),
}

impl Bound {
    fn new(problem: &Problem) -> Option<Self> {
        let of_stops = StopBound::new(problem).map(|bound| Self::Stops(Box::new(bound)));
        let of_flows = || FlowBound::new(problem).map(|bound| Self::Flows(Box::new(bound)));
        of_stops
            .or_else(of_flows)
            .or_else(|| ShareBound::new(problem).map(|bound| Self::Shares(Box::new(bound))))
    }

    fn improve(&mut self, work: u32) -> bool {
        match self {
            Self::Flows(bound) => bound.improve(work),
            Self::Shares(bound) => bound.improve(work),
            Self::Stops(bound) => bound.improve(work),
        }
    }

    fn value(&self) -> f64 {
        match self {
            Self::Flows(bound) => bound.value(),
            Self::Shares(bound) => bound.value(),
            Self::Stops(bound) => bound.value(),
        }
    }

    fn travel(&self) -> Option<Travel> {
        match self {
            Self::Flows(bound) => bound.certificate().map(Travel::Flows),
            Self::Shares(bound) => bound.certificate().cloned().map(Travel::Shares),
            Self::Stops(bound) => bound.certificate().cloned().map(Travel::Stops),
        }
    }
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Drawing {
    name: String,
    sha256: String,
}

/// Works on the bound of a job and writes its certificate. A job of few contours is proven optimal where that is possible.
pub struct Proof {
    file: File,
    problem: Problem,
    paid: f64,
    bound: Option<Bound>,
    optimum: Option<Optimum>,
    /// Work that is granted and not yet done: less than a turn.
    left: u64,
    /// Turns so far.
    turns: u64,
    /// The cost of the path that was told last, s.
    told: f64,
}

impl Proof {
    /// Reads a drawing and starts with a weak bound. Of the options of the search, only the path to begin with is used, if it fits.
    ///
    /// # Errors
    /// As for a plan of the drawing.
    pub fn start(
        bytes: Vec<u8>,
        name: &str,
        reading: LoadOptions,
        options: &PlanOptions,
    ) -> Result<Self, JobError> {
        let PlanOptions { material, place, start, .. } = options.clone();
        let machine = options.machine.profile()?;
        let problem = problem(&bytes, name, &reading, &machine, (material.clone(), place, start))?;
        let bound = Bound::new(&problem);
        let file = File {
            schema: CERTIFICATE_SCHEMA.to_owned(),
            seconds: 0.0,
            drawing: Drawing { name: name.to_owned(), sha256: sha256(&bytes) },
            reading,
            machine_sha256: sha256(json_text(&machine)),
            machine,
            material,
            place,
            start,
            travel: Travel::Shares(Certificate::default()),
            sha256: String::new(),
        };
        let paid = problem.paid();
        let of_tours = matches!(bound, Some(Bound::Flows(_) | Bound::Shares(_)));
        let warm = options.warm.as_ref().and_then(|path| warm_path::solution(path, &problem).ok());
        let optimum = if of_tours { Optimum::new(&problem, warm.as_ref()) } else { None };
        Ok(Self { file, problem, paid, bound, optimum, left: 0, turns: 0, told: f64::INFINITY })
    }

    /// Why nothing can be proven in this way; `None` if it can.
    pub fn hindrance(&self) -> Option<&'static str> {
        self.bound.is_none().then_some("Certificates are not written for fewer than two contours.")
    }

    /// Looks at about `work` more numbers, in turns of the same size however it is sliced. Returns whether more work may help.
    pub fn improve(&mut self, work: u32) -> bool {
        let Some(bound) = &mut self.bound else { return false };
        let Some(optimum) = &mut self.optimum else { return bound.improve(work) };
        self.left += u64::from(work);
        let mut more = true;
        while more && self.left >= u64::from(TURN) {
            self.left -= u64::from(TURN);
            self.turns += 1;
            more = optimum.turn();
            if !more || self.turns.is_multiple_of(BEHIND) || optimum.value() < bound.value() {
                more |= bound.improve(TURN / WALKS_PER_FLOW);
            }
            more &= !optimum.is_proven();
        }
        more
    }

    /// No plan takes less, s. 0 if nothing can be proven in this way.
    pub fn seconds(&self) -> f64 {
        let optimum = self.optimum.as_ref().map_or(0.0, Optimum::value);
        self.bound.as_ref().map_or(0.0, |bound| self.paid + bound.value().max(optimum))
    }

    /// The best path that it has found, if that is better than the one that was told before. `None` above 220 contours, and where contours may be left
    /// unfinished or are cut as one.
    pub fn better_path(&mut self) -> Option<WarmPath> {
        let optimum = self
            .optimum
            .as_ref()
            .filter(|optimum| optimum.cost() < self.told * (1.0 - warm_path::SAME_PATH))?;
        self.told = optimum.cost();
        optimum.path()
    }

    /// The certificate file of the bound by flows, by shares, by walks or by stops that proves most; `None` if nothing is proven yet.
    pub fn certificate(&self) -> Option<String> {
        let above = self.bound.as_ref()?.value();
        let walks = self.optimum.as_ref().and_then(|optimum| optimum.certificate(above));
        let travel = walks.map(Travel::Walks).or_else(|| self.bound.as_ref()?.travel())?;
        let seconds = travel.whole_job(travel.certified().stated().0.into(), &self.problem);
        let file = File { seconds, travel, ..self.file.clone() };
        Some(json_text(&File { sha256: file.seal(), ..file }))
    }
}

impl File {
    /// The seal that the file should have.
    fn seal(&self) -> String {
        sha256(json_text(&Self { sha256: String::new(), ..self.clone() }))
    }
}

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
/// as in [`LoadOptions`].
///
/// # Errors
/// One sentence: why it proves nothing about this drawing and machine.
pub fn verify(
    text: &str,
    drawing: &[u8],
    machine: Option<&Profile>,
    decoder: TextDecoder,
) -> Result<Verified, String> {
    let mut file = read(text)?;
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

/// Reads a certificate file. Its kind comes first: a document of another kind has other fields, which would hide what is wrong.
fn read(text: &str) -> Result<File, String> {
    #[derive(Deserialize)]
    struct Kind {
        schema: String,
    }
    let not_one = |why: String| format!("This is not a certificate ({CERTIFICATE_SCHEMA}): {why}.");
    match serde_json::from_str(text) {
        Ok(Kind { schema }) if schema == CERTIFICATE_SCHEMA => {}
        Ok(Kind { schema }) => {
            return Err(format!("This is a document of the kind {schema}, not {CERTIFICATE_SCHEMA}."));
        }
        Err(e) if e.is_data() => return Err(not_one("it has no text \"schema\"".into())),
        Err(e) => return Err(not_one(format!("line {}, column {} is no JSON", e.line(), e.column()))),
    }
    serde_json::from_str(text)
        .map_err(|e| not_one(format!("line {}, column {} does not fit the format", e.line(), e.column())))
}

/// The problem that a plan of this drawing solves.
fn problem(
    bytes: &[u8],
    name: &str,
    reading: &LoadOptions,
    machine: &Profile,
    (material, place, start): (Option<String>, Option<Place>, Start),
) -> Result<Problem, JobError> {
    let mut job = Job::load(bytes.to_vec(), name, reading)?;
    let machine = MachineChoice::Profile(Box::new(machine.clone()));
    let options =
        PlanOptions { machine, material, place, start, allow_off_bed: true, ..PlanOptions::default() };
    Ok(job.start(&options)?.problem().clone())
}
