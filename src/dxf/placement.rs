//! Where an INSERT puts its block.

use super::entity::Insert;
use super::ocs;
use glam::{DAffine3, DMat3, DVec3};

/// The map from the block of `insert` into the space the insert stands in, for one cell of its array.
///
/// From right to left: the base point of the block to 0, scale, turn, place and cell, plane of the extrusion. The
/// distances of the array are turned with the insert but not scaled.
pub(super) fn cell(insert: &Insert<'_>, base: DVec3, column: u32, row: u32) -> DAffine3 {
    let turn = ocs::unit_at_degrees(insert.rotation);
    let rotation = DMat3::from_cols(turn.extend(0.0), turn.perp().extend(0.0), DVec3::Z);
    let offset = DVec3::new(f64::from(column) * insert.spacing.x, f64::from(row) * insert.spacing.y, 0.0);
    let matrix3 = rotation * DMat3::from_diagonal(insert.scale);
    let in_plane = DAffine3 { matrix3, translation: insert.at + rotation * offset - matrix3 * base };
    ocs::plane(insert.normal, 0.0) * in_plane
}

/// The corners of the array: the cells that bound all others.
pub(super) fn corner_cells(insert: &Insert<'_>) -> [(u32, u32); 4] {
    let [columns, rows] = insert.counts;
    let (last_column, last_row) = (columns.saturating_sub(1), rows.saturating_sub(1));
    [(0, 0), (last_column, 0), (0, last_row), (last_column, last_row)]
}
