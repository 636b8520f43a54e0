//! Closed shapes in a network: which of them stay as drawn, and which consist of several faces.

use super::graph::{Face, Graph};
use super::joined::{Joined, Role};
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, interior_point, winding};
use crate::sheet::cluster::cluster;
use crate::sheet::element::{Element, ROUNDING};

/// What becomes of a closed shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fate {
    /// It is this face.
    Is(usize),
    /// It consists of several faces, which replace it.
    Divided,
    /// It stays as it is drawn, because the faces inside it do not fill it: something crosses it.
    Kept,
}

/// A closed shape whose chains are part of the network.
pub(super) struct Known {
    pub(super) chains: Vec<u32>,
    pub(super) edges: Vec<usize>,
    pub(super) fate: Fate,
}

/// The closed shapes in the network.
pub(super) fn known(joined: &Joined, graph: &Graph, faces: &[Face]) -> Vec<Known> {
    let mut side = vec![usize::MAX; 2 * graph.edges.len()];
    for (f, face) in faces.iter().enumerate() {
        face.around.iter().for_each(|&h| side[h] = f);
    }
    let mut chains_of: Vec<(Role, Vec<u32>)> = Vec::new();
    let (mut rests, mut loops) = (vec![usize::MAX; joined.chains.outlines.len()], Vec::new());
    for (chain, &role) in (0_u32..).zip(&joined.roles) {
        if graph.of(chain).is_empty() {
            continue;
        }
        let slot = match role {
            Role::Candidate => continue,
            Role::Closed => {
                chains_of.push((role, vec![chain]));
                continue;
            }
            Role::Rest(of) => &mut rests[of as usize],
            Role::Loop(of) => {
                let of = of as usize;
                if loops.len() <= of {
                    loops.resize(of + 1, usize::MAX);
                }
                &mut loops[of]
            }
        };
        match chains_of.get_mut(*slot) {
            Some((_, chains)) => chains.push(chain),
            None => {
                *slot = chains_of.len();
                chains_of.push((role, vec![chain]));
            }
        }
    }
    let mut inner: Option<InnerPoints> = None;
    let mut known = |(role, chains): (Role, Vec<u32>)| {
        let edges: Vec<usize> = chains.iter().flat_map(|&c| graph.of(c)).collect();
        let outline = outline(joined, role, &chains);
        let slack = joined.tolerance.max(ROUNDING) * outline.length();
        let fate = match face_of(graph, faces, &side, &edges, &outline, slack) {
            Some(face) => Fate::Is(face),
            None => {
                let inner = inner.get_or_insert_with(|| InnerPoints::new(graph, faces));
                if is_filled(graph, faces, inner, &edges, &outline, slack) {
                    Fate::Divided
                } else {
                    Fate::Kept
                }
            }
        };
        Known { chains, edges, fate }
    };
    chains_of.into_iter().map(&mut known).collect()
}

/// The face that an outline with these edges bounds alone. Its area and edges do not suffice: all that is left of a
/// square can lie between it and a neighbour of the same size. A point in the face decides on which side it is.
fn face_of(
    graph: &Graph,
    faces: &[Face],
    side: &[usize],
    edges: &[usize],
    outline: &Path,
    slack: f64,
) -> Option<usize> {
    let area = outline.area().abs();
    let is = |f: usize| {
        faces.get(f).is_some_and(|face| {
            (face.area - area).abs() <= slack
                && edges.iter().all(|&e| side[2 * e] == f || side[2 * e + 1] == f)
                && graph.inner_point(face).is_none_or(|p| winding(outline, p).is_inside())
        })
    };
    let &first = edges.first()?;
    [side[2 * first], side[2 * first + 1]].into_iter().find(|&f| is(f))
}

/// A point well inside each face, where there is one.
struct InnerPoints {
    points: Vec<Option<DVec2>>,
    index: BoxIndex,
}

impl InnerPoints {
    fn new(graph: &Graph, faces: &[Face]) -> Self {
        let points: Vec<Option<DVec2>> = faces.iter().map(|face| graph.inner_point(face)).collect();
        let index = BoxIndex::new(points.iter().map(|p| p.map_or(Aabb::EMPTY, Aabb::of)));
        Self { points, index }
    }

    /// The faces inside an outline, in order.
    fn inside(&self, outline: &Path) -> impl Iterator<Item = usize> {
        let near = self.index.query(outline.bounds()).into_iter();
        near.filter(|f| self.points[*f].is_some_and(|p| winding(outline, p).is_inside()))
    }
}

/// Whether the faces of the same set inside an outline fill it.
fn is_filled(
    graph: &Graph,
    faces: &[Face],
    inner: &InnerPoints,
    edges: &[usize],
    outline: &Path,
    slack: f64,
) -> bool {
    let set = edges.first().map(|&e| graph.edges[e].set);
    let of_set = |face: &&Face| face.around.first().map(|h| graph.edges[h / 2].set) == set;
    let filled: f64 = inner.inside(outline).map(|f| &faces[f]).filter(of_set).map(|face| face.area).sum();
    (filled - outline.area().abs()).abs() <= slack
}

/// The outline of a closed shape. The chains of a loop follow each other as their ends are joined.
fn outline(joined: &Joined, role: Role, chains: &[u32]) -> Path {
    let elements = |c: u32| joined.chain(c).map_or(&[][..], |c| joined.chains.of(c));
    if let Role::Rest(of) = role {
        return joined.chains.outlines.get(of as usize).cloned().unwrap_or_default();
    }
    let mut segments: Vec<Segment> = Vec::new();
    let start = 2 * chains.first().copied().unwrap_or(0);
    let mut end = start;
    for _ in chains {
        let of = elements(end / 2).iter().map(|e| e.segment);
        if end % 2 == 0 {
            segments.extend(of);
        } else {
            segments.extend(of.rev().map(|s| s.reversed()));
        }
        end = joined.mates.get((end ^ 1) as usize).copied().unwrap_or(start);
    }
    // Gaps up to the tolerance are closed by lines, so that the area is that of a closed path.
    let mut out: Vec<Segment> = Vec::with_capacity(segments.len());
    let n = segments.len();
    for (k, s) in segments.iter().enumerate() {
        out.push(*s);
        let next = segments[(k + 1) % n].start();
        if next != s.end() {
            out.push(Segment::line(s.end(), next));
        }
    }
    Path::new(out, true)
}

/// Outlines of closed shapes that lost everything to others and are not copies of one closed shape.
pub(super) fn covered(joined: &Joined) -> Vec<Path> {
    let covered = &joined.chains.covered;
    if covered.is_empty() {
        return Vec::new();
    }
    let path = |elements: &[Element]| Path::new(elements.iter().map(|e| e.segment).collect(), true);
    let whole: Vec<Path> = joined
        .chains
        .chains
        .iter()
        .filter(|c| c.closed)
        .map(|c| path(joined.chains.of(c)))
        .chain(joined.chains.outlines.iter().cloned())
        .collect();
    let tolerance = joined.tolerance.max(ROUNDING);
    let lost: Vec<Path> = covered.iter().map(|e| path(e)).collect();
    let all: Vec<&Path> = whole.iter().chain(&lost).collect();
    let corners: Vec<DVec2> = all.iter().map(|p| p.bounds().min).collect();
    let at = cluster(&corners, 2.0 * tolerance);
    let mut seen: rustc_hash::FxHashMap<i64, Vec<&Path>> = rustc_hash::FxHashMap::default();
    let mut out = Vec::new();
    for (k, p) in all.into_iter().enumerate() {
        let size = (p.bounds(), p.area().abs());
        let here = seen.entry(at[k].into()).or_default();
        // The two triangles of a halved square have the same box and area, so a point inside tells them apart.
        let same = |q: &&Path| {
            alike((q.bounds(), q.area().abs()), size, p.length(), tolerance)
                && interior_point(q).is_none_or(|inner| winding(p, inner).is_inside())
        };
        let known = here.iter().any(same);
        if !known {
            here.push(p);
        }
        if !known && k >= corners.len() - covered.len() {
            out.push(p.clone());
        }
    }
    out
}

/// Largest distance between corners of the boxes of two outlines that are alike, in tolerances.
pub(super) const ALIKE: f64 = 2.0;

/// Whether two outlines have the same box and area within the tolerance.
pub(super) fn alike(a: (Aabb, f64), b: (Aabb, f64), length: f64, tolerance: f64) -> bool {
    let near = |p: DVec2, q: DVec2| p.distance(q) <= ALIKE * tolerance;
    near(a.0.min, b.0.min) && near(a.0.max, b.0.max) && (a.1 - b.1).abs() <= tolerance * length
}
