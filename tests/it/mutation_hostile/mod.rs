//! Files made to hang, exhaust or crash a reader, through reading, contours and parts: each ends soon, within the
//! stated limits, with a sentence or a finding that names what is wrong.

mod blocks;
mod reading;
mod values;
