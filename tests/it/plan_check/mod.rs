//! The checker against planted faults: each kind is caught, and said to be what it is.

mod interrupted;
mod nested;
mod planted;
mod whole;
