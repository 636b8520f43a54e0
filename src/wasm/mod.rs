//! Bindings to JavaScript and nothing else: options and reports are plain objects, geometry is typed arrays.
//!
//! The types of the objects are in `www/sdk/protocol.ts`. A panic aborts the instance and leaves it unusable. The worker
//! that runs it then reads the reason from [`last_panic`] and is replaced.

#[cfg(feature = "planner")]
mod arrays;
#[cfg(any(feature = "planner", feature = "outputs"))]
mod failure;
#[cfg(feature = "outputs")]
mod outputs;
mod panic;
#[cfg(any(feature = "planner", feature = "outputs"))]
mod plain;
#[cfg(feature = "planner")]
mod planner;
#[cfg(feature = "png")]
mod png;
#[cfg(feature = "research")]
mod research;
#[cfg(feature = "planner")]
mod text;
#[cfg(feature = "planner")]
mod values;

#[cfg(feature = "outputs")]
pub use outputs::*;
pub use panic::*;
#[cfg(feature = "planner")]
pub use planner::*;
#[cfg(feature = "png")]
pub use png::*;
#[cfg(feature = "research")]
pub use research::*;
