//! Parts that are connected by bridges.

use crate::geometry::{DVec2, Path};
use serde::{Deserialize, Serialize};

/// Parts that bridges connect. The path of one contour goes around all of them; the contours of the others stay in the list with
/// [`Operation::Ignore`](crate::sheet::Operation::Ignore) and name that one.
#[derive(Clone, Debug, PartialEq)]
pub struct Bridged {
    /// The contour that goes around the parts and the strips between them: the one of least id.
    pub contour: u32,
    /// The outlines of the parts as drawn, with their contours, by id.
    pub outlines: Vec<(u32, Path)>,
    /// The strips between them, one fewer than there are parts.
    pub strips: Vec<Strip>,
    /// The contours directly inside these outlines, each with its outline. As [`Contour::inside`](crate::sheet::Contour::inside) they have the one that goes around all.
    pub within: Vec<(u32, u32)>,
    /// Where the machine cuts the bridges later and minds what drops and what tips: the contours of the parts that do not stay by themselves, each
    /// with the strip that holds it until last, as its place in the list.
    pub holders: Vec<(u32, usize)>,
    /// The cuts through the bridges, if the machine makes them.
    pub cuts: Vec<BridgeCut>,
}

/// A cut across one end of a strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BridgeCut {
    /// Its contour.
    pub contour: u32,
    /// The contour of the part whose outline it completes.
    pub outline: u32,
    /// The strip, as its place in the list.
    pub strip: usize,
}

/// A bridge: a straight strip of material through the waste, which keeps two parts connected.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Strip {
    /// The contours of the two parts.
    pub contours: [u32; 2],
    /// Its two sides, mm: the first from where the outline of the first part is opened to where that of the second part goes on, the second
    /// back.
    pub sides: [[DVec2; 2]; 2],
}
