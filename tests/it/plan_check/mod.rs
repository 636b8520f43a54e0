//! The checker against planted faults: each kind is caught, and said to be what it is.

mod interrupted;
mod planted;
mod whole;
