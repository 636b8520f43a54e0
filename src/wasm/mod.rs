//! Bindings to JavaScript, and nothing else: options and reports as plain objects, geometry as typed arrays.
//!
//! The types of the objects are those of `www/sdk/protocol.ts`. A panic aborts the instance and leaves it unusable;
//! whoever holds it asks [`last_panic`] for the reason and replaces the worker it runs in.

mod panic;
#[cfg(feature = "planner")]
mod plain;
#[cfg(feature = "planner")]
mod planner;
#[cfg(feature = "png")]
mod png;
#[cfg(feature = "planner")]
mod quote;
#[cfg(feature = "research")]
mod research;
#[cfg(feature = "planner")]
mod text;
#[cfg(feature = "planner")]
mod values;

pub use panic::*;
#[cfg(feature = "planner")]
pub use planner::*;
#[cfg(feature = "png")]
pub use png::*;
#[cfg(feature = "planner")]
pub use quote::*;
#[cfg(feature = "research")]
pub use research::*;
