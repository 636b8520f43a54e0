//! Sharp corners of thick plate: a pause in each that is cut through, saved where a cut begins or ends; pre-cuts with a
//! length.

mod corners;
mod groups;
mod single;
