//! Numbers of items and nodes.

/// Index of an item; for sheets, the contour's id.
pub type ItemId = u32;
/// Index of a node.
pub type NodeId = u32;
