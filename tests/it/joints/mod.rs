//! Micro-joints: found, priced by the search, checked, written.

mod checker;
mod drawings;
mod held;
mod machines;
mod places;
mod search;
