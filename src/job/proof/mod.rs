//! Proofs of the lower bound: the work on it, certificate files (`kerfway.certificate/1`, `file.rs`) and their verification (`verify.rs`).

mod file;
mod verify;

pub use file::CERTIFICATE_SCHEMA;
pub use verify::{Verified, verify};

use super::optimum::{Optimum, TURN};
use super::{Job, JobError, LoadOptions, MachineChoice, Place, PlanOptions, WarmPath, warm_path};
use crate::machine::{Profile, Start};
use crate::output::{json_text, sha256};
use crate::plan::{Certificate, FlowBound, ShareBound, StopBound};
use crate::problem::Problem;
use file::{Drawing, File, Travel};

/// Numbers of the bound by walks for one of that by flows, which takes twice as long.
const WALKS_PER_FLOW: u32 = 2;
/// While walks have proven more than flows, which is usual up to a hundred contours, flows get every fourth turn only: with half of the time for
/// them, 46 contours took 1.75 times as long.
const BEHIND: u64 = 4;

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
    /// The cost of the last path that `better_path` returned, s.
    reported: f64,
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
        Ok(Self { file, problem, paid, bound, optimum, left: 0, turns: 0, reported: f64::INFINITY })
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

    /// The best path that it has found, if that is better than the last one that this returned. `None` above 220 contours, and where contours may be left
    /// unfinished or are cut as one.
    pub fn better_path(&mut self) -> Option<WarmPath> {
        let optimum =
            self.optimum.as_ref().filter(|optimum| warm_path::is_better(optimum.cost(), self.reported))?;
        self.reported = optimum.cost();
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
