//! Shared by the integration tests of the intake: where fixtures are, distances between curves, seeded numbers, and
//! a small DXF writer that knows nothing of the reader.
#![allow(dead_code, reason = "a test may need less than the kit has")]
#![allow(
    unreachable_pub,
    clippy::unwrap_used,
    clippy::panic,
    reason = "part of test binaries, which fail by panicking"
)]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "small sheets, and arithmetic that is independent of the crate it judges"
)]

pub mod beam_machine;
pub mod by_hand;
pub mod compare;
pub mod dialects;
pub mod drawings;
pub mod dxf_text;
pub mod exact;
pub mod gcode;
pub mod grbl_arc;
pub mod grbl_planner;
pub mod jobs;
pub mod joints;
pub mod leads;
pub mod linuxcnc_planner;
pub mod methods;
pub mod multi_search;
pub mod mutate;
pub mod outlines;
pub mod paths;
pub mod plans;
pub mod plates;
pub mod promises;
pub mod random_plans;
pub mod replayed;
pub mod rng;
pub mod schema;
pub mod searches;
pub mod sheets;
pub mod svg_text;

use std::path::{Path, PathBuf};

/// `tests/fixtures`.
pub fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures")
}

/// Files of a folder whose name ends in `.ext` in any case, sorted by name.
pub fn files(folder: &Path, ext: &str) -> Vec<PathBuf> {
    let mut out: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        .map(|f| f.unwrap().path())
        .filter(|p| p.extension().is_some_and(|x| x.eq_ignore_ascii_case(ext)))
        .collect();
    out.sort();
    out
}

/// The name of a file, for messages.
pub fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}
