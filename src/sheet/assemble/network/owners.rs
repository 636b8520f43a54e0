//! Which face each edge is cut with.

use super::graph::{Face, Graph};
use super::joined::{Joined, Role};
use super::shapes::{ALIKE, Fate, Known, alike};
use crate::geometry::{Aabb, BoxIndex, Path, winding};
use crate::order::sort_by;
use crate::sheet::element::ROUNDING;

/// Number of faces that are asked for an edge so that another one gets one. Real drawings need a few.
const MOST_ASKED: usize = 250;

/// The face that each edge is cut with.
pub(super) struct Owners<'a> {
    joined: &'a Joined<'a>,
    graph: &'a Graph,
    faces: &'a [Face],
    known: &'a [Known],
    /// By edge; `None` while the edge is cut as drawn.
    pub(super) of: Vec<Option<usize>>,
    /// Whether a chain is replaced by the faces at its edges.
    pub(super) replaced: Vec<bool>,
    /// The faces that become contours, in drawing order.
    pub(super) order: Vec<usize>,
    /// Whether a face becomes a contour.
    made: Vec<bool>,
    /// For each chain, the closed shape that it belongs to.
    known_of: Vec<Option<usize>>,
    /// For each face, the closed shape that it is.
    shape: Vec<Option<usize>>,
}

impl<'a> Owners<'a> {
    pub(super) fn new(joined: &'a Joined, graph: &'a Graph, faces: &'a [Face], known: &'a [Known]) -> Self {
        let mut replaced = vec![false; joined.roles.len()];
        let mut shape = vec![None; faces.len()];
        let mut known_of = vec![None; joined.roles.len()];
        for (k, known) in known.iter().enumerate() {
            known.chains.iter().for_each(|&c| known_of[c as usize] = Some(k));
            match known.fate {
                Fate::Is(face) => shape[face] = Some(k),
                Fate::Divided => known.chains.iter().for_each(|&c| replaced[c as usize] = true),
                Fate::Kept => {}
            }
        }
        let of = vec![None; graph.edges.len()];
        let made = vec![false; faces.len()];
        Self { joined, graph, faces, known, of, replaced, order: Vec::new(), made, known_of, shape }
    }

    fn edges(&self, face: usize) -> impl Iterator<Item = usize> + use<'a> {
        self.faces[face].around.iter().map(|h| h / 2)
    }

    /// Gives every edge of a candidate or of a divided shape to the first face beside it.
    pub(super) fn take_free(&mut self) {
        let free = |e: usize| {
            let chain = self.graph.edges[e].chain as usize;
            self.joined.roles.get(chain) == Some(&Role::Candidate) || self.replaced[chain]
        };
        let mut order: Vec<usize> =
            (0..self.faces.len()).filter(|&f| self.shape[f].is_none() && self.edges(f).any(free)).collect();
        sort_by(&mut order, |&f| self.drawn(f));
        let mut of = std::mem::take(&mut self.of);
        for &f in &order {
            for e in self.edges(f).filter(|&e| free(e)) {
                of[e].get_or_insert(f);
            }
        }
        self.of = of;
        // What a divided shape leaves to closed shapes inside it goes back to them.
        let left: Vec<bool> = (0..self.of.len()).map(|e| free(e) && self.of[e].is_none()).collect();
        for f in 0..self.faces.len() {
            let Some(k) = self.shape[f] else { continue };
            let beside: Vec<usize> = self.edges(f).filter(|&e| left[e] && self.of[e].is_none()).collect();
            if !beside.is_empty() {
                self.replace(k, f);
                beside.into_iter().for_each(|e| self.of[e] = Some(f));
            }
        }
        for &f in &order {
            if !self.edges(f).any(|e| self.of[e] == Some(f)) {
                self.take_back(f);
            }
        }
        order.into_iter().for_each(|f| self.make(f));
    }

    /// Makes a face a contour.
    fn make(&mut self, face: usize) {
        self.made[face] = true;
        self.order.push(face);
    }

    /// Makes the face that a closed shape is a contour of the network.
    fn replace(&mut self, shape: usize, face: usize) {
        let known = self.known;
        if let Some(Known { chains, edges, .. }) = known.get(shape)
            && !self.made[face]
        {
            edges.iter().for_each(|&e| self.of[e] = Some(face));
            chains.iter().for_each(|&c| self.replaced[c as usize] = true);
            self.make(face);
        }
    }

    /// The first three shapes that a face is drawn with, for the drawing order.
    fn drawn(&self, face: usize) -> [u64; 3] {
        let mut shapes: Vec<u32> =
            self.edges(face).flat_map(|e| self.graph.edges[e].elements.iter().map(|e| e.shape)).collect();
        sort_by(&mut shapes, |&s| [s.into(), 0, 0]);
        shapes.dedup();
        [0, 1, 2].map(|k: usize| shapes.get(k).map_or(u64::MAX, |&s| s.into()))
    }

    /// Gives an edge back to faces that are drawn as closed shapes of which cleaning left nothing.
    pub(super) fn restore(&mut self, covered: &[Path], tolerance: f64) {
        if covered.is_empty() {
            return;
        }
        let tolerance = tolerance.max(ROUNDING);
        let around = |f: usize| {
            let elements = self.edges(f).flat_map(|e| &self.graph.edges[e].elements);
            elements.fold(Aabb::EMPTY, |b, e| b.union(e.segment.bounds()))
        };
        let bounds: Vec<Aabb> = (0..self.faces.len()).map(around).collect();
        let corners = BoxIndex::new(bounds.iter().map(|b| Aabb::of(b.min)));
        for outline in covered {
            let drawn = (outline.bounds(), outline.area().abs());
            let same = |f: &usize| {
                let inner = || self.graph.inner_point(&self.faces[*f]);
                alike((bounds[*f], self.faces[*f].area), drawn, outline.length(), tolerance)
                    && inner().is_none_or(|p| winding(outline, p).is_inside())
            };
            let near = Aabb::of(drawn.0.min).grown(ALIKE * tolerance);
            let found = corners.query(near).into_iter().find(same);
            if let Some(f) = found.filter(|f| self.shape[*f].is_none() && !self.made[*f])
                && self.take_back(f)
            {
                self.make(f);
            }
        }
    }

    /// Gives a face its longest edge from a neighbour that keeps at least one other. If every neighbour has only one,
    /// they get another one from theirs first. This is an augmenting path, as in a bipartite matching of faces and edges.
    fn take_back(&mut self, face: usize) -> bool {
        // Faces that lack an edge if the one before them gets one: the position of that one, and the edge.
        let mut asked = vec![Asked { face, by: 0, edge: 0 }];
        let mut at = 0;
        while let Some(&Asked { face, .. }) = asked.get(at).filter(|_| at < MOST_ASKED) {
            let mut edges: Vec<usize> = self.edges(face).collect();
            sort_by(&mut edges, |&e| [!crate::order::real(self.graph.edges[e].length), e as u64, 0]);
            for edge in edges {
                let Some(owner) = self.owner(edge) else { continue };
                if asked.iter().any(|a| a.face == owner) {
                    continue;
                }
                asked.push(Asked { face: owner, by: at, edge });
                if self.edges(owner).filter(|&e| self.owner(e) == Some(owner)).count() > 1 {
                    self.pass_on(&asked);
                    return true;
                }
            }
            at += 1;
        }
        false
    }

    /// The face that an edge is cut with, also if that is a closed shape as drawn.
    fn owner(&self, edge: usize) -> Option<usize> {
        self.of[edge].or_else(|| {
            let known = self.known_of[self.graph.edges[edge].chain as usize]?;
            if let Fate::Is(face) = self.known[known].fate { Some(face) } else { None }
        })
    }

    /// Passes an edge of the last face on to the one that asked for it, and so on to the first.
    fn pass_on(&mut self, asked: &[Asked]) {
        let mut passed = Vec::new();
        let mut at = asked.len() - 1;
        while at > 0 {
            let Asked { face, by, edge } = asked[at];
            if let Some(shape) = self.shape[face] {
                self.replace(shape, face);
            }
            passed.push((edge, asked[by].face));
            at = by;
        }
        passed.into_iter().for_each(|(edge, taker)| self.of[edge] = Some(taker));
    }
}

/// A face that is asked for an edge, see [`Owners::take_back`].
#[derive(Clone, Copy)]
struct Asked {
    face: usize,
    by: usize,
    edge: usize,
}
