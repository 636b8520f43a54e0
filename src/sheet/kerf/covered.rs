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
    /// The contour that has it, its piece, the element of that, and the fractions of the element.
    owner: usize,
    piece: usize,
    element: usize,
    part: [f64; 2],
}

/// Gives a stretch to each of the lines that has no pieces. Lines within `tolerance` mm coincide.
pub(super) fn give_back(pieces: &mut [Pieces], lines: &[Line], tolerance: f64) {
    let index = BoxIndex::new(lines.iter().map(|l| l.path.bounds()));
    for line in lines {
        if pieces.get(line.index as usize).is_none_or(|own| !own.is_empty()) {
            continue;
        }
        let mut best: Option<Stretch> = None;
        for other in index.query(line.path.bounds().grown(tolerance)) {
            let Some(owner) = lines.get(other).map(|l| l.index as usize) else { continue };
            for found in
                pieces.get(owner).into_iter().flat_map(|of| stretches(owner, of, line.path, tolerance))
            {
                if best
                    .as_ref()
                    .is_none_or(|b| (found.of_open, found.length) > (b.of_open, b.length + tolerance))
                {
                    best = Some(found);
                }
            }
        }
        let whole = best.as_ref().and_then(|b| lines.iter().find(|l| l.index as usize == b.owner));
        if let (Some(best), Some(whole)) = (best, whole) {
            let given = taken(&mut pieces[best.owner], &best, whole.path, tolerance);
            pieces[line.index as usize] = vec![(Path::new(vec![given], false), Some(line.path.clone()))];
        }
    }
}

/// The stretches of an owner's pieces that lie on a line and leave something to the owner.
fn stretches(owner: usize, pieces: &Pieces, line: &Path, tolerance: f64) -> Vec<Stretch> {
    let whole: f64 = pieces.iter().map(|p| p.0.length()).sum();
    let mut found = Vec::new();
    for (piece, (path, _)) in pieces.iter().enumerate() {
        for (element, segment) in path.segments.iter().enumerate() {
            for on in line.segments.iter().filter(|s| s.bounds().grown(tolerance).overlaps(&segment.bounds()))
            {
                let Some([from, mut to]) = common(segment, on, tolerance) else { continue };
                if (to - from) * segment.length() > whole - MEETING * tolerance {
                    to = 0.5 * (from + to);
                }
                let length = (to - from) * segment.length();
                if length > MEETING * tolerance {
                    let of_open = !path.closed;
                    found.push(Stretch { of_open, length, owner, piece, element, part: [from, to] });
                }
            }
        }
    }
    found
}

/// The fractions of an element between which it lies on another one.
fn common(segment: &Segment, other: &Segment, tolerance: f64) -> Option<[f64; 2]> {
    let near = |s: &Segment, p| Some(s.nearest(p)).filter(|n| n.1 <= tolerance * tolerance).map(|n| n.0);
    let own = [(0.0, segment.start()), (1.0, segment.end())];
    let own = own.into_iter().filter_map(|(f, p)| near(other, p).map(|_| f));
    let ends = own.chain([other.start(), other.end()].into_iter().filter_map(|p| near(segment, p)));
    let [from, to] = ends.fold([1.0_f64, 0.0], |[from, to], f| [from.min(f), to.max(f)]);
    near(other, segment.at(0.5 * (from + to))).filter(|_| from < to).map(|_| [from, to])
}

/// Takes a stretch from its owner, whose whole line is known.
fn taken(pieces: &mut Pieces, stretch: &Stretch, whole: &Path, tolerance: f64) -> Segment {
    let (path, outline) = pieces.remove(stretch.piece);
    let (before, after) = path.segments.split_at(stretch.element);
    let segment = after[0];
    let [from, to] = stretch.part;
    let before = before.iter().copied().chain([segment.piece(0.0, from)]);
    let after = [segment.piece(to, 1.0)].into_iter().chain(after[1..].iter().copied());
    let rests = if path.closed {
        vec![after.chain(before).collect()]
    } else {
        vec![before.collect(), after.collect()]
    };
    let long = |path: &Path| path.length() > tolerance;
    let rests = rests
        .into_iter()
        .map(|rest: Vec<Segment>| Path::new(rest.into_iter().filter(|s| s.length() > 0.0).collect(), false));
    let rests: Vec<_> = rests.filter(long).map(|rest| (rest, None)).collect();
    pieces.splice(stretch.piece..stretch.piece, rests);
    if let Some(first) = pieces.first_mut().filter(|_| stretch.piece == 0) {
        first.1 = outline.or_else(|| path.closed.then(|| whole.clone()));
    }
    segment.piece(from, to)
}
