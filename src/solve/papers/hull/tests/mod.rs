//! Codes and operators, checked by hand and by brute force.

mod nesting;
mod operators;
mod sheets;
