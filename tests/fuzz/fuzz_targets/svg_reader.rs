//! Any bytes through the SVG reader.

#![no_main]

#[allow(dead_code, reason = "each target asks for its own part")]
#[path = "../../testkit/promises.rs"]
mod promises;

libfuzzer_sys::fuzz_target!(|data: &[u8]| promises::of_the_svg_reader(data));
