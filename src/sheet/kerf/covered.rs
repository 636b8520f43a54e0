//! Contours whose whole line others cut get a stretch of it back.
//!
//! Of lines that coincide, one stays, so all sides of a part may go to its neighbours. But a contour of which nothing is cut
//! would bound no area: what lies inside it would come in no order, and leads and corner loops of its neighbours would be
//! made inside it. So such a contour cuts one stretch itself, and is the open rest of its line like any that shares sides.

use crate::geometry::{BoxIndex, Path, Segment};
use crate::sheet::source::Line;

/// What is left of a contour's line: its pieces, of which the first has the outline if it is open.
pub(super) type Pieces = Vec<(Path, Option<Path>)>;

/// A stretch of an element that lies on another line, shorter than this many tolerances, is only where they meet.
const MEETING: f64 = 10.0;

/// A stretch that a contour may get.
struct Stretch {
    /// Whether its owner is open already: it should be, as a closed contour has leads and joints.
    of_open: bool,
    length: f64,
    /// The line that has it, its piece, the element of that, and the fractions of the element.
    owner: usize,
    piece: usize,
    element: usize,
    part: [f64; 2],
}

/// Gives a stretch to each of the lines that has no pieces. Lines within `tolerance` mm coincide.
pub(super) fn give_back(pieces: &mut [Pieces], lines: &[Line], tolerance: f64) {
    let covered: Vec<&Line> = lines.iter().filter(|l| pieces[l.index as usize].is_empty()).collect();
    if covered.is_empty() {
        return;
    }
    let index = BoxIndex::new(lines.iter().map(|l| l.path.bounds()));
    for line in covered {
        let near = index.query(line.path.bounds().grown(tolerance));
        if let Some(best) = longest(pieces, lines, &near, line.path, tolerance) {
            let owner = &lines[best.owner];
            let given = take(&mut pieces[owner.index as usize], &best, owner.path, tolerance);
            pieces[line.index as usize].push((Path::new(vec![given], false), Some(line.path.clone())));
        }
    }
}

/// The longest stretch of the pieces of some other lines that lies on a line and leaves something to its owner, of open contours
/// first.
fn longest(
    pieces: &[Pieces],
    lines: &[Line],
    others: &[usize],
    line: &Path,
    tolerance: f64,
) -> Option<Stretch> {
    let mut best: Option<Stretch> = None;
    for &owner in others {
        let own = &pieces[lines[owner].index as usize];
        let whole: f64 = own.iter().map(|p| p.0.length()).sum();
        for (piece, (path, _)) in own.iter().enumerate() {
            for (element, segment) in path.segments.iter().enumerate() {
                let (of_open, bounds) = (!path.closed, segment.bounds().grown(tolerance));
                for on in line.segments.iter().filter(|s| s.bounds().overlaps(&bounds)) {
                    let [from, mut to] = common(segment, on, tolerance);
                    if (to - from) * segment.length() > whole - MEETING * tolerance {
                        to = 0.5 * (from + to);
                    }
                    let length = (to - from) * segment.length();
                    let longer = |b: &Stretch| {
                        of_open && !b.of_open || of_open == b.of_open && length > b.length + tolerance
                    };
                    if length > MEETING * tolerance && best.as_ref().is_none_or(longer) {
                        best = Some(Stretch { of_open, length, owner, piece, element, part: [from, to] });
                    }
                }
            }
        }
    }
    best
}

/// The fractions of an element between which it lies on another one; none lie between them if it does not.
fn common(segment: &Segment, other: &Segment, tolerance: f64) -> [f64; 2] {
    let (mut part, least) = ([1.0_f64, 0.0_f64], tolerance * tolerance);
    let mut reaches = |f: f64| part = [part[0].min(f), part[1].max(f)];
    for f in [0.0, 1.0] {
        if other.nearest(segment.at(f)).1 <= least {
            reaches(f);
        }
        let (own, off) = segment.nearest(other.at(f));
        if off <= least {
            reaches(own);
        }
    }
    let lies_on = other.nearest(segment.at(0.5 * (part[0] + part[1]))).1 <= least;
    if lies_on { part } else { [0.0; 2] }
}

/// Takes a stretch from its owner, whose whole line is known.
fn take(pieces: &mut Pieces, stretch: &Stretch, whole: &Path, tolerance: f64) -> Segment {
    let (mut path, mut outline) = pieces.remove(stretch.piece);
    let [from, to] = stretch.part;
    let mut after = path.segments.split_off(stretch.element);
    let segment = after[0];
    path.segments.push(segment.piece(0.0, from));
    after[0] = segment.piece(to, 1.0);
    if path.closed {
        after.append(&mut path.segments);
        outline = Some(whole.clone());
    }
    // What comes before the stretch is put before what comes after it.
    for mut rest in [after, path.segments] {
        rest.retain(|s| s.length() > 0.0);
        let rest = Path::new(rest, false);
        if rest.length() > tolerance {
            pieces.insert(stretch.piece, (rest, None));
        }
    }
    if let (0, Some(first)) = (stretch.piece, pieces.first_mut()) {
        first.1 = outline;
    }
    segment.piece(from, to)
}
