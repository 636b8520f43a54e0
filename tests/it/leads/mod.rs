//! Leads: found, priced by the search, checked, written.

mod attach;
mod checker;
mod drawings;
mod graze;
mod ladder;
mod replay;
mod search;
