//! Bindings to JavaScript, and nothing else: options and reports as plain objects, geometry as typed arrays.
//!
//! The types of the objects are those of `www/sdk/protocol.ts`. A panic aborts the instance and leaves it unusable;
//! whoever holds it replaces the worker it runs in.

#[cfg(feature = "lab")]
mod lab;
#[cfg(feature = "papers")]
mod papers;
#[cfg(any(feature = "papers", feature = "planner", feature = "quote"))]
mod plain;
#[cfg(feature = "planner")]
mod planner;
#[cfg(feature = "png")]
mod png;
#[cfg(feature = "quote")]
mod quote;
#[cfg(feature = "planner")]
mod text;
#[cfg(feature = "planner")]
mod values;

#[cfg(feature = "lab")]
pub use lab::*;
#[cfg(feature = "papers")]
pub use papers::*;
#[cfg(feature = "planner")]
pub use planner::*;
#[cfg(feature = "png")]
pub use png::*;
#[cfg(feature = "quote")]
pub use quote::*;
