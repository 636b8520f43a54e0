//! Parts from networks of lines: the faces that lines enclose together.
//!
//! Three squares side by side are three parts, whether they are drawn as three closed polylines or as ten lines. Joining
//! ends gives each line one neighbour at each end, which is not enough where lines serve two parts: at a branch, where
//! an end meets the middle of another line, and where lines cross. This stage finds the faces of the planar arrangement
//! of such lines, and makes each face a closed contour.
//!
//! 1. **Contacts** ([`contacts`]). Chains that are still open or that pass a branch after joining are *candidates*. The
//!    places where they meet each other, and where they end on closed shapes, become nodes.
//! 2. **Graph** ([`graph`]). The chains are divided at the nodes, and the faces are traced. Lines with the same face on both
//!    sides lead nowhere: they stay open cuts, as they are drawn.
//! 3. **Shapes** ([`shapes`]). A closed shape that is one face stays as it is drawn. A shape that lines divide, or along
//!    whose sides another shape lies from inside, is replaced by its faces.
//! 4. **Contours** ([`contours`]). The first face at a line, in drawing order, gets it. The other one becomes the
//!    rest of its outline, as with closed shapes that share a side.
//!
//! A closed shape all of whose sides are shared with earlier ones has lost everything in cleaning. If it is a face, it
//! gets one of these sides back, so that its part is not lost.
//!
//! A drawing in which every end meets exactly one other end has no candidates and costs nothing. The number of
//! comparisons is bounded; beyond it, lines stay as the joining left them, and a finding reports that.

mod contacts;
mod contours;
mod graph;
mod joined;
mod owners;
mod shapes;

use crate::sheet::element::Chains;
use contacts::Net;

pub(super) use contacts::TooMany;
pub(super) use joined::{Joined, Role};

/// What the network came to.
pub(super) enum Outcome {
    /// No lines enclose anything that is not a contour already.
    Unchanged,
    /// The chains with a closed contour for each face.
    Faces(Chains),
    /// So many lines lie over each other that the faces were not looked for.
    TooMany(TooMany),
}

/// Finds the faces of the networks among joined chains.
pub(super) fn resolve(joined: &Joined) -> Outcome {
    let covered = shapes::covered(joined);
    let open = |role: &Role| matches!(role, Role::Candidate | Role::Rest(_));
    if covered.is_empty() && !joined.roles.iter().any(open) {
        return Outcome::Unchanged;
    }
    let net = match Net::new(joined, &covered) {
        Ok(net) => net,
        Err(too_many) => return Outcome::TooMany(too_many),
    };
    let graph = graph::Graph::new(joined, &net);
    let faces = graph.faces(joined.tolerance);
    let known = shapes::known(joined, &graph, &faces);
    match contours::made(joined, &graph, &faces, &known, &covered) {
        Some(chains) => Outcome::Faces(chains),
        None => Outcome::Unchanged,
    }
}
