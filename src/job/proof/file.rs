//! Certificate files.
//!
//! A certificate file names the drawing by its hash and holds everything that decides what a plan takes: how the drawing is
//! read, the machine, the setting and the place on the bed. From these the problem is made again, and the numbers of the
//! [`FlowCertificate`], of the [`Certificate`] by shares, of the [`WalkCertificate`] or of the [`StopCertificate`] are added up
//! again in whole numbers. How they were found does not matter, and no search is needed.

use crate::job::{LoadOptions, Place};
use crate::machine::{Profile, Start};
use crate::output::{json_text, sha256};
use crate::plan::{Certificate, Certified, FlowCertificate, StopCertificate, WalkCertificate, with_paid};
use crate::problem::Problem;
use serde::{Deserialize, Serialize};

/// The name and version of the format.
pub const CERTIFICATE_SCHEMA: &str = "kerfway.certificate/1";

/// A certificate file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    /// Name and version of the format: [`CERTIFICATE_SCHEMA`].
    pub(super) schema: String,
    /// No plan takes less, s.
    pub(super) seconds: f64,
    pub(super) drawing: Drawing,
    /// How the drawing is read.
    pub(super) reading: LoadOptions,
    pub(super) machine: Profile,
    /// SHA-256 of the machine's JSON.
    pub(super) machine_sha256: String,
    pub(super) material: Option<String>,
    pub(super) place: Option<Place>,
    pub(super) start: Start,
    /// The numbers that prove the least travel.
    pub(super) travel: Travel,
    /// SHA-256 of the file with this field empty, so that damage is noticed.
    pub(super) sha256: String,
}

/// The kinds of certificates, which have different fields.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub(super) enum Travel {
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
    pub(super) fn certified(&self) -> &dyn Certified {
        match self {
            Self::Flows(certificate) => certificate,
            Self::Shares(certificate) => certificate,
            Self::Walks(certificate) => certificate,
            Self::Stops(certificate) => certificate,
        }
    }

    /// The least seconds of the whole job, rounded down: a proven travel in units, and what every plan pays.
    pub(super) fn whole_job(&self, proven: i128, problem: &Problem) -> f64 {
        with_paid(self.certified().stated().1, proven, problem.payments())
    }
}

/// The drawing that a certificate is for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Drawing {
    /// The name of its file when the certificate was written.
    pub(super) name: String,
    /// SHA-256 of its bytes.
    pub(super) sha256: String,
}

impl File {
    /// The seal that the file should have.
    pub(super) fn seal(&self) -> String {
        sha256(json_text(&Self { sha256: String::new(), ..self.clone() }))
    }

    /// Reads a file. Its kind comes first: a document of another kind has other fields, which would hide what is wrong.
    pub(super) fn read(text: &str) -> Result<Self, String> {
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
}
