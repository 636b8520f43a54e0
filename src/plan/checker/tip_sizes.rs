//! Sizes of pieces: whether what an outline bounds drops, tips or stays, by extents of places along it.

use crate::geometry::{DVec2, Path, Segment, math};
use crate::machine::{SAME_SIZE, Tips};

/// Half of what the sizes of a piece may be off, mm.
pub(super) const SIZE_SLACK: f64 = 5e-7;

/// Whether a piece of this outline may tip: not one that drops, and not one that lies on several slats. What is as large as a
/// limit, up to a millionth of a millimetre, is not below it; `slack` moves that by less.
pub(super) fn tips_up(tips: &Tips, outline: &Path, hole: bool, slack: f64) -> bool {
    let [width, height] = [DVec2::X, DVec2::Y].map(|direction| extent(outline, direction));
    if hole && width.max(height) <= tips.cross_over + SAME_SIZE - slack {
        return false;
    }
    let [across, along] = extents(tips, outline);
    below(across, tips.tips_below, slack) && !drops(tips, [across, along], -slack)
}

/// Whether what an outline bounds lies on several slats, so that it neither drops nor tips.
pub(super) fn stays(tips: &Tips, outline: &Path, slack: f64) -> bool {
    let [across, along] = extents(tips, outline);
    !below(across, tips.tips_below, -slack) && !drops(tips, [across, along], -slack)
}

/// Whether a piece of these extents falls between the slats.
fn drops(tips: &Tips, extents: [f64; 2], slack: f64) -> bool {
    let limit = tips.drops_below.or(tips.slats.map(|s| s.pitch)).unwrap_or(50.0);
    extents.into_iter().all(|extent| below(extent, limit, slack))
}

/// How far an outline reaches in a direction of length 1, mm: to an end of an element, or to the place of an arc that looks
/// that way.
fn reach(outline: &Path, direction: DVec2) -> f64 {
    let of = |s: &Segment| {
        let ends = s.start().dot(direction).max(s.end().dot(direction));
        match s {
            Segment::Arc(arc) if arc.is_circle() || arc.fraction_of(direction).is_some() => {
                ends.max(arc.center.dot(direction) + arc.radius())
            }
            _ => ends,
        }
    };
    outline.segments.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
}

/// The extents of an outline across and along the slats; of its smaller and its larger one, where these are not known.
fn extents(tips: &Tips, outline: &Path) -> [f64; 2] {
    match tips.slats {
        None => {
            let [width, height] = [DVec2::X, DVec2::Y].map(|direction| extent(outline, direction));
            [width.min(height), width.max(height)]
        }
        Some(slats) => {
            let direction = DVec2::new(math::cos(slats.angle), math::sin(slats.angle));
            [direction.perp(), direction].map(|direction| extent(outline, direction))
        }
    }
}

fn extent(outline: &Path, direction: DVec2) -> f64 {
    reach(outline, direction) + reach(outline, -direction)
}

fn below(size: f64, limit: f64, slack: f64) -> bool {
    size < limit - SAME_SIZE + slack
}
