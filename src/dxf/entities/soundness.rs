//! Checks whether the groups of an entity are consistent, or show that lines of the file were lost or changed.
//!
//! Only this check finds damage that leaves codes and values in sync. An entity whose start was lost merges with the
//! one before it and repeats its groups; a changed code leaves a y without its x.

use crate::dxf::record::Record;

/// Result of the check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::dxf) enum Soundness {
    /// Nothing is unusual.
    Sound,
    /// A value is missing and a likely one was assumed; the text for people says so.
    Assumed(&'static str),
    /// Lines of the entity are lost or changed.
    Broken,
}

/// Checks an entity whose outline can be cut.
pub(in crate::dxf) fn check_soundness(record: &Record<'_>) -> Soundness {
    let repeated = unique_groups(record.name).iter().any(|code| record.count(*code) > 1);
    let (orphan, lacks_y) = unpaired_coordinates(record);
    if repeated || orphan || (record.last_in_file && !is_complete(record)) {
        return Soundness::Broken;
    }
    if lacks_y {
        return Soundness::Assumed("a point of it has no y coordinate; 0 was taken");
    }
    match record.name {
        b"ARC" if record.real(50).is_none() || record.real(51).is_none() => {
            Soundness::Assumed("one of its angles is missing; 0 was taken")
        }
        // A scale of 0 would collapse the block; programs treat it as missing.
        b"INSERT" if [41, 42].iter().any(|code| record.real(*code).is_some_and(|s| s.abs() <= 0.0)) => {
            Soundness::Assumed("its scale is 0; 1 was taken")
        }
        b"LWPOLYLINE" if differs(record, 90, 10) => Soundness::Assumed(
            "it holds another number of vertices than it says; all that are there were taken",
        ),
        b"SPLINE" if differs(record, 72, 40) || differs(record, 73, 10) || differs(record, 74, 11) => {
            Soundness::Assumed(
                "it holds another number of knots or points than it says; all that are there were taken",
            )
        }
        _ => Soundness::Sound,
    }
}

/// Groups that occur at most once in an entity of this kind.
fn unique_groups(name: &[u8]) -> &'static [i32] {
    match name {
        b"LINE" => &[10, 20, 30, 11, 21, 31],
        b"CIRCLE" | b"ARC" => &[10, 20, 30, 40, 50, 51],
        b"ELLIPSE" => &[10, 20, 30, 11, 21, 31, 40, 41, 42],
        b"INSERT" => &[2, 10, 20, 30, 41, 42, 43, 44, 45, 50, 70, 71],
        b"SOLID" | b"TRACE" | b"3DFACE" => &[10, 20, 11, 21, 12, 22, 13, 23],
        b"LWPOLYLINE" => &[70, 90],
        b"SPLINE" => &[70, 71, 72, 73, 74],
        b"VERTEX" => &[10, 20, 30, 42, 70],
        b"POLYLINE" => &[30, 70],
        b"BLOCK" => &[10, 20, 30],
        _ => &[],
    }
}

/// Whether there are more y or z than x, and whether there are more x than y.
fn unpaired_coordinates(record: &Record<'_>) -> (bool, bool) {
    // Groups 10 to 18 are x, 20 to 28 y, 30 to 37 z; 38 is an elevation and 39 a thickness.
    let mut counts = [[0i32; 9]; 3];
    for tag in &record.tags {
        let (axis, point) = match tag.code {
            10..=18 => (0, tag.code - 10),
            20..=28 => (1, tag.code - 20),
            30..=37 => (2, tag.code - 30),
            _ => continue,
        };
        if let Some(n) = usize::try_from(point).ok().and_then(|p| counts[axis].get_mut(p)) {
            *n += 1;
        }
    }
    let [x, y, z] = counts;
    // The elevation of a POLYLINE is the z of a point whose x and y may be missing.
    let whole = record.name != b"POLYLINE";
    let orphan = (0..9).any(|p| y[p] > x[p] || (whole && z[p] > x[p]));
    (orphan, whole && (0..9).any(|p| x[p] > y[p]))
}

/// Whether the entity states a number in group `count_code` that differs from its number of groups `counted_code`.
fn differs(record: &Record<'_>, count_code: i32, counted_code: i32) -> bool {
    let stated = record.int(count_code).unwrap_or(0);
    stated > 0 && usize::try_from(stated).ok() != Some(record.count(counted_code))
}

/// Whether the last entity of a file without an end mark has all the groups it needs.
fn is_complete(record: &Record<'_>) -> bool {
    let has = |codes: &[i32]| codes.iter().all(|code| record.count(*code) > 0);
    match record.name {
        b"LINE" => has(&[10, 20, 11, 21]),
        b"CIRCLE" => has(&[10, 20, 40]),
        b"ARC" => has(&[10, 20, 40, 50, 51]),
        b"ELLIPSE" => has(&[10, 20, 11, 21, 40, 41, 42]),
        b"LWPOLYLINE" => !differs(record, 90, 10) && record.count(10) == record.count(20),
        b"SPLINE" => !(differs(record, 72, 40) || differs(record, 73, 10) || differs(record, 74, 11)),
        // In other kinds, the missing part may be an optional one.
        _ => false,
    }
}
