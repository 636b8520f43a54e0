//! Object coordinate systems: planes in space, and their projection on the sheet.
//!
//! Circles, arcs, two-dimensional polylines, inserts and hatches are given in the plane of their extrusion direction.
//! The "arbitrary axis algorithm" of the DXF reference defines the direction of its x axis. Direction (0, 0, -1),
//! written by programs that mirror, reverses x. The sheet is the xy plane of the world; an entity tilted against it is
//! projected along z, and a finding reports it.

use crate::geometry::{Affine, math};
use glam::{DAffine3, DMat3, DVec2, DVec3};

/// The axes of the object coordinate system of extrusion direction `normal`, as columns.
pub(super) fn axes(normal: DVec3) -> DMat3 {
    let Some(z) = normal.try_normalize() else { return DMat3::IDENTITY };
    // The reference says "close to the world z axis". 1/64 is part of the definition, so all programs use it.
    let near_z = z.x.abs() < 1.0 / 64.0 && z.y.abs() < 1.0 / 64.0;
    let x = if near_z { DVec3::Y.cross(z) } else { DVec3::Z.cross(z) }.normalize_or_zero();
    DMat3::from_cols(x, z.cross(x), z)
}

/// The plane at `elevation` along `normal`, as a map from (x, y, 0) in the plane to world coordinates.
pub(super) fn plane(normal: DVec3, elevation: f64) -> DAffine3 {
    let axes = axes(normal);
    DAffine3 { matrix3: axes, translation: axes.z_axis * elevation }
}

/// The projection of a plane in space on the sheet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    /// The map of the plane z = 0 onto the sheet.
    pub(super) map: Affine,
    /// Whether the plane is tilted against the sheet.
    pub(super) tilted: bool,
}

/// Projects the plane z = 0 under `to_sheet` on the sheet.
pub(super) fn project(to_sheet: &DAffine3) -> Projection {
    let m = to_sheet.matrix3;
    let map =
        Affine { x: m.x_axis.truncate(), y: m.y_axis.truncate(), origin: to_sheet.translation.truncate() };
    // Programs write directions with 6 digits or more, so a smaller tilt is rounding.
    let tilted = m.x_axis.z.abs() > 1e-6 * m.x_axis.length() || m.y_axis.z.abs() > 1e-6 * m.y_axis.length();
    Projection { map, tilted }
}

/// An angle of an arc in degrees, without whole turns if there are many. A large angle would lose the digits of the
/// other angle in sums and differences, and the sweep would not match the ends.
pub(super) fn without_whole_turns(degrees: f64) -> f64 {
    const MANY: f64 = 3600.0;
    if degrees.abs() > MANY { degrees % 360.0 } else { degrees }
}

/// The unit vector at `degrees`. It is exact at multiples of a right angle, where most arcs and rotations in drawings
/// are.
pub(super) fn unit_at_degrees(degrees: f64) -> DVec2 {
    let turn = degrees % 360.0;
    let turn = if turn < 0.0 { turn + 360.0 } else { turn };
    let quarters =
        [(0.0, DVec2::X), (90.0, DVec2::Y), (180.0, DVec2::NEG_X), (270.0, DVec2::NEG_Y), (360.0, DVec2::X)];
    // Allows for rounding in sums of angles; anything farther from a multiple is not rounded to it.
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
    fn z_normal_gives_the_world_axes() {
        assert_eq!(axes(DVec3::Z), DMat3::IDENTITY);
        assert_eq!(axes(DVec3::ZERO), DMat3::IDENTITY, "a direction of no length is none");
    }

    #[test]
    fn negative_z_normal_reverses_x() {
        let a = axes(DVec3::NEG_Z);
        assert_eq!(a.x_axis, DVec3::NEG_X);
        assert_eq!(a.y_axis, DVec3::Y);
    }

    #[test]
    fn horizontal_normal_has_a_horizontal_x_axis() {
        // For an extrusion along +x, the plane's x axis is world y and its y axis is world z.
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
