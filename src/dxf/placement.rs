//! The position of a block that an INSERT places.

use super::entity::Insert;
use super::ocs;
use glam::{DAffine3, DMat3, DVec3};

/// The map from the coordinates of the block to those of the insert, for one cell of the insert's array.
///
/// From right to left: move the base point to 0, scale, rotate, move to the insertion point and cell, and map to the
/// plane of the extrusion. The spacing of the array is rotated with the insert but not scaled.
pub(super) fn cell(insert: &Insert<'_>, base: DVec3, column: u32, row: u32) -> DAffine3 {
    let turn = ocs::unit_at_degrees(insert.rotation);
    let rotation = DMat3::from_cols(turn.extend(0.0), turn.perp().extend(0.0), DVec3::Z);
    let offset = DVec3::new(f64::from(column) * insert.spacing.x, f64::from(row) * insert.spacing.y, 0.0);
    let matrix3 = rotation * DMat3::from_diagonal(insert.scale);
    let in_plane = DAffine3 { matrix3, translation: insert.at + rotation * offset - matrix3 * base };
    ocs::plane(insert.normal, 0.0) * in_plane
}

/// The corner cells of the array, which bound all others.
pub(super) fn corner_cells(insert: &Insert<'_>) -> [(u32, u32); 4] {
    let [columns, rows] = insert.counts;
    let (last_column, last_row) = (columns.saturating_sub(1), rows.saturating_sub(1));
    [(0, 0), (last_column, 0), (0, last_row), (last_column, last_row)]
}
