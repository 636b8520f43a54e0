//! The ranges of the numbers in options, with their reasons.

use super::JobError;
use crate::fields::{FieldError, Range};

/// Largest whole number that JavaScript represents exactly.
pub(super) const COUNT: Range = Range::new(0.0, 9_007_199_254_740_991.0, "", "JavaScript counts no further");
pub(super) const TOLERANCE: Range = Range::new(
    1e-6,
    1.0,
    "mm",
    "below, numbers have no digits left for it, and above, a curve is no longer the curve that was drawn",
);
pub(super) const PLACE: Range = Range::new(-1e6, 1e6, "mm", "no table reaches further than 1 km");
pub(super) const TURN: Range = Range::new(0.0, 270.0, "degrees", "quarter turns are 0, 90, 180 or 270");
pub(super) const DPI: Range = Range::new(1.0, 100_000.0, "", "no program draws in larger or smaller pixels");
pub(super) const JOIN_TOLERANCE: Range =
    Range::new(0.0, 5.0, "mm", "a larger one would join what was drawn apart");
pub(super) const COPY_TOLERANCE: Range =
    Range::new(0.0, 1.0, "mm", "a larger one would merge lines that are drawn side by side");
pub(super) const SECONDS: Range =
    Range::new(0.0, 604_800.0, "s", "a search is over long before a week has passed");
pub(super) const WORKERS: Range =
    Range::new(1.0, 64.0, "", "more searches than processors find nothing sooner");
pub(super) const MEMBER: Range = Range::new(0.0, 63.0, "", "there are at most 64 searches side by side");
pub(super) const ID: Range = Range::new(0.0, 4_294_967_295.0, "", "contours are counted from 0");
pub(super) const SHARE: Range = Range::new(0.0, 1.0, "", "it is a fraction of the contour's length");
pub(super) const ALONG: Range = Range::new(-1e9, 1e9, "mm", "no contour is longer than 1,000 km");
pub(super) const REVERSED: Range =
    Range::new(0.0, 1.0, "", "1 says that the stop runs against the stored direction");

/// Checks that the number of an option is in its range.
pub(super) fn within(name: &str, n: f64, range: &Range) -> Result<(), JobError> {
    if range.holds(n) {
        return Ok(());
    }
    Err(FieldError::out_of_range("The option", name, n, range).into())
}
