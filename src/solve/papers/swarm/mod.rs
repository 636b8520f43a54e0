//! LPSPSO of Qu & Du and the three swarms it is compared with.

mod flock;
mod lpspso;
mod prospect;
mod proximity;
mod rules;
mod run;
mod worth;

pub use lpspso::Lpspso;
