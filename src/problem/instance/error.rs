//! Errors of instance files.

/// Why a file is not a usable instance: one sentence, with the line if there is one.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}{what}", line.map_or(String::new(), |l| format!("Line {l}: ")))]
pub struct InstanceError {
    /// Line in the file, from 1.
    pub line: Option<usize>,
    /// What is wrong.
    pub what: String,
}

impl InstanceError {
    pub(super) fn at(line: usize, what: String) -> Self {
        Self { line: Some(line), what }
    }

    pub(super) fn whole(what: String) -> Self {
        Self { line: None, what }
    }
}
