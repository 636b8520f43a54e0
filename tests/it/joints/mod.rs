//! Micro-joints: found, priced by the search, checked, written.

mod checker;
mod drawings;
mod places;
mod search;
