//! Kerf width: the beam follows outlines offset by half the kerf, and lines one kerf apart are cut once.
#![allow(clippy::unwrap_used, clippy::panic, unreachable_pub, reason = "a test fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "sheets of a few contours; the product's arithmetic is not to judge itself"
)]

mod crossed;
mod followed;
mod kept;
mod made;
mod of_all_kinds;
mod on_lines;
mod one_kerf_apart;
mod outlines_alone;
mod shift_choice;
mod shifted;
mod surrounded;
mod together;
mod with_levers;
