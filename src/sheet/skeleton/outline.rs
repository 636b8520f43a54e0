//! The outline of the sheet.

use super::super::model::Sheet;
use super::blocked::worked;
use super::fault::SkeletonFault;
use crate::geometry::{Aabb, DVec2, Path, Segment};
use crate::machine::Profile;

/// The smallest closed outline around everything that is drawn and not cut; otherwise the bed of the machine.
pub(super) fn of(sheet: &Sheet, machine: &Profile) -> Result<Path, SkeletonFault> {
    let job = parts(sheet);
    match (drawn(sheet), machine.bed()) {
        (Some(path), _) => Ok(path.clone()),
        (None, Some(bed)) if bed.contains_box(&job) => Ok(rectangle(&bed)),
        (None, Some(_)) => Err(SkeletonFault::Beyond),
        (None, None) => Err(SkeletonFault::NoSheet),
    }
}

/// The smallest closed outline around everything that is drawn and not cut.
pub(super) fn drawn(sheet: &Sheet) -> Option<&Path> {
    let job = parts(sheet);
    let around = sheet.ignored.iter().map(|i| &i.path).filter(|p| p.closed && p.bounds().contains_box(&job));
    around.min_by(|a, b| a.area().abs().total_cmp(&b.area().abs()))
}

/// The box around everything that is worked, without skeleton cuts.
pub(super) fn parts(sheet: &Sheet) -> Aabb {
    worked(sheet).fold(Aabb::EMPTY, |all, path| all.union(path.bounds()))
}

fn rectangle(of: &Aabb) -> Path {
    let corners = [of.min, DVec2::new(of.max.x, of.min.y), of.max, DVec2::new(of.min.x, of.max.y)];
    let sides = (0..4).zip(corners).map(|(k, from)| Segment::line(from, corners[(k + 1) % 4]));
    Path::new(sides.collect(), true)
}
