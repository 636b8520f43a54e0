//! Why a sheet has no skeleton cuts.

/// Most pieces in one direction: a limit against slips, since each line is compared with every contour.
pub(super) const MOST: u32 = 1000;

/// Why there are no skeleton cuts, as the end of a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub(crate) enum SkeletonFault {
    /// Nothing says how large the sheet is.
    #[error(
        "the size of the sheet is not known. Draw its outline as a closed line on a layer that is ignored, or give the machine's bed and a program in machine coordinates"
    )]
    NoSheet,
    /// Parts lie on the edge of the sheet or beyond it.
    #[error(
        "the job reaches beyond the sheet, for which the machine's bed is taken. Draw the outline of the sheet, or place the job on the bed"
    )]
    Beyond,
    /// The spacing is that of a sieve.
    #[error("the sheet would be divided more than {} times in one direction. Give a larger spacing", MOST)]
    TooMany,
}
