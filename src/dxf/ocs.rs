//! Planes in space: object coordinate systems, and the way back to the sheet.
//!
//! Circles, arcs, two-dimensional polylines, inserts and hatches are given in the plane of their extrusion
//! direction; the "arbitrary axis algorithm" of the DXF reference says where its x axis lies. Direction
//! (0, 0, -1), written by programs that mirror, turns x over. The sheet is the xy plane of the world: whatever is
//! tilted against it is projected straight down, and said.

use crate::geometry::{Affine, math};
use glam::{DAffine3, DMat3, DVec2, DVec3};

/// The axes of the object coordinate system of extrusion direction `normal`, as columns.
pub(super) fn axes(normal: DVec3) -> DMat3 {
    let Some(z) = normal.try_normalize() else { return DMat3::IDENTITY };
    // "Close to the world z axis": 1/64 is the value all programs share, by definition of the format.
    let near_z = z.x.abs() < 1.0 / 64.0 && z.y.abs() < 1.0 / 64.0;
    let x = if near_z { DVec3::Y.cross(z) } else { DVec3::Z.cross(z) }.normalize_or_zero();
    DMat3::from_cols(x, z.cross(x), z)
}

/// The plane at `elevation` along `normal`, as a map from (x, y, 0) of the plane into the world.
pub(super) fn plane(normal: DVec3, elevation: f64) -> DAffine3 {
    let axes = axes(normal);
    DAffine3 { matrix3: axes, translation: axes.z_axis * elevation }
}

/// What is left of a map of space when its x and y axes are seen on the sheet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    /// The map of the plane z = 0 onto the sheet.
    pub(super) map: Affine,
    /// The plane is tilted against the sheet.
    pub(super) tilted: bool,
}

/// The map of the plane z = 0 under `to_sheet`, seen on the sheet.
pub(super) fn project(to_sheet: &DAffine3) -> Projection {
    let m = to_sheet.matrix3;
    let map =
        Affine { x: m.x_axis.truncate(), y: m.y_axis.truncate(), origin: to_sheet.translation.truncate() };
    // Programs write directions with 6 digits or more: below that a tilt is noise.
    let tilted = m.x_axis.z.abs() > 1e-6 * m.x_axis.length() || m.y_axis.z.abs() > 1e-6 * m.y_axis.length();
    Projection { map, tilted }
}

/// An angle of an arc, degrees. Of one that is many turns away the whole turns are taken off: in differences and sums
/// with another angle that one's digits would be lost, and the sweep would not fit the ends.
pub(super) fn few_turns(degrees: f64) -> f64 {
    const MANY: f64 = 3600.0;
    if degrees.abs() > MANY { degrees % 360.0 } else { degrees }
}

/// The unit vector at `degrees`, exact at multiples of a right angle, where most arcs and turns in drawings are.
pub(super) fn unit_at_degrees(degrees: f64) -> DVec2 {
    let turn = degrees % 360.0;
    let turn = if turn < 0.0 { turn + 360.0 } else { turn };
    let quarters =
        [(0.0, DVec2::X), (90.0, DVec2::Y), (180.0, DVec2::NEG_X), (270.0, DVec2::NEG_Y), (360.0, DVec2::X)];
    // Exact multiples only, but for the rounding of sums of angles.
    const ROUNDING: f64 = 1e-13;
    if let Some((_, unit)) = quarters.into_iter().find(|(q, _)| (turn - q).abs() < ROUNDING) {
        return unit;
    }
    math::unit(turn.to_radians())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn upwards_is_the_world() {
        assert_eq!(axes(DVec3::Z), DMat3::IDENTITY);
        assert_eq!(axes(DVec3::ZERO), DMat3::IDENTITY, "a direction of no length is none");
    }

    #[test]
    fn downwards_turns_x_over() {
        let a = axes(DVec3::NEG_Z);
        assert_eq!(a.x_axis, DVec3::NEG_X);
        assert_eq!(a.y_axis, DVec3::Y);
    }

    #[test]
    fn sideways_takes_x_from_the_horizon() {
        // Extrusion along +x: the plane's x axis is world y, its y axis world z.
        let a = axes(DVec3::X);
        assert_eq!(a.x_axis, DVec3::Y);
        assert_eq!(a.y_axis, DVec3::Z);
    }

    #[test]
    fn right_angles_are_exact() {
        assert_eq!(unit_at_degrees(-90.0), DVec2::NEG_Y);
        assert_eq!(unit_at_degrees(450.0), DVec2::Y);
        assert!((unit_at_degrees(45.0).x - 0.5f64.sqrt()).abs() < 1e-15);
    }
}
