//! The bindings under Node, by wasm-bindgen's own test runner: what crosses into JavaScript, and that wasm computes
//! the same bytes as the native build.
#![cfg(target_arch = "wasm32")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "counts are exact")]

mod drawings;
mod golden;
#[allow(unreachable_pub, reason = "the same file is a module of the native test kit, where it is public")]
#[path = "../testkit/methods.rs"]
mod methods;
mod options;
mod panics;
mod planning;
mod research;
mod values;
