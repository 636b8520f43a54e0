//! Checks pierce groups: every shared cut is cut once, nothing is cut after it has fallen out, and pre-cuts are where they
//! are needed.
//!
//! The beam is followed from element to element. After every element, the areas that are still held are found again from
//! the outside in: an area is held as long as a chain of uncut elements connects it to the area around the group. (The
//! planner looks at the order backwards instead.)

use super::coverage::leads;
use super::tolerance::{SAME, rounding};
use super::violation::Violation;
use crate::geometry::{DVec2, Path, Segment, winding_number};
use crate::machine::Profile;
use crate::sheet::{PierceGroup, Sheet};

/// The state of a group.
struct Work<'s> {
    group: &'s PierceGroup,
    paths: Vec<Path>,
    cut: Vec<bool>,
    /// Pre-cuts made, as contour and node.
    ahead: Vec<(u32, u32)>,
    /// For each area, the move that cut it free.
    free: Vec<Option<usize>>,
}

/// The pierce groups of a sheet and their states.
pub(super) struct Groups<'s> {
    sheet: &'s Sheet,
    work: Vec<Work<'s>>,
    /// For each contour, its group.
    of: Vec<Option<usize>>,
}

impl<'s> Groups<'s> {
    /// If the machine makes no pre-cuts there are no groups: every contour is cut by itself.
    pub(super) fn new(sheet: &'s Sheet, machine: &Profile) -> Self {
        let mut of = vec![None; sheet.contours.len()];
        let mut work = Vec::new();
        for group in sheet.cut_as_one(machine.makes_pre_cuts()) {
            for &c in &group.contours {
                if let Some(of) = of.get_mut(c as usize) {
                    *of = Some(work.len());
                }
            }
            work.push(Work {
                group,
                paths: group.elements.iter().map(|e| group.path(e)).collect(),
                cut: vec![false; group.elements.len()],
                ahead: Vec::new(),
                free: vec![None; group.faces as usize],
            });
        }
        Self { sheet, work, of }
    }

    /// Whether a contour is cut with its group.
    pub(super) fn holds(&self, contour: u32) -> bool {
        self.of.get(contour as usize).is_some_and(Option::is_some)
    }

    /// Whether two contours belong to the same group.
    pub(super) fn same(&self, a: u32, b: u32) -> bool {
        self.holds(a) && self.of.get(a as usize) == self.of.get(b as usize)
    }

    /// Follows a pre-cut. Returns whether an uncut element of the contour begins where the head is.
    pub(super) fn pre_cut(&mut self, contour: u32, head: DVec2, ahead: &[Segment]) -> bool {
        let Some(work) = self.of.get(contour as usize).copied().flatten().and_then(|g| self.work.get_mut(g))
        else {
            return false;
        };
        let Some(node) = work.node(head) else { return false };
        let ahead = Path::new(ahead.to_vec(), false);
        let left = work.group.elements.iter().zip(&work.paths).zip(&work.cut).filter(|(_, cut)| !**cut);
        let fits = left.map(|(e, _)| e).any(|(e, path)| {
            let [from, to] = e.ends;
            e.contour == contour
                && ((from == node && leads(path, &ahead)) || (to == node && leads(&path.reversed(), &ahead)))
        });
        work.ahead.push((contour, node));
        fits
    }

    /// Follows a cut. `ready` means that it was pierced, or continues where the beam just was.
    pub(super) fn cut(
        &mut self,
        step: usize,
        contours: &[u32],
        path: &[Segment],
        ready: bool,
        found: &mut Vec<Violation>,
    ) {
        let Some(&contour) = contours.first() else { return };
        let Some(work) = self.of.get(contour as usize).copied().flatten().and_then(|g| self.work.get_mut(g))
        else {
            return;
        };
        let run = Path::new(path.to_vec(), false);
        let (length, mut gone, mut first) = (run.length(), 0.0, true);
        let mut named: Vec<u32> = Vec::new();
        while gone < length - SAME {
            let Some((e, node, to)) = work.next(&run, gone) else {
                let at = run.at(gone).unwrap_or_default();
                found.push(if work.repeats(&run, gone) {
                    Violation::Again { step, contour }
                } else {
                    Violation::Strays { step, contour, at }
                });
                return;
            };
            let own = work.group.elements[e].contour;
            if !named.contains(&own) {
                named.push(own);
            }
            let pre_cut = |node: u32, work: &Work| work.ahead.contains(&(own, node));
            if (first && !ready && !pre_cut(node, work)) || (work.is_loose(to) && !pre_cut(to, work)) {
                found.push(Violation::NoPreCut { step, contour: own });
            }
            if !work.is_held(e) {
                found.push(Violation::Fallen { step, contour: own });
            }
            work.take(e, step);
            gone += work.paths[e].length();
            first = false;
        }
        if named != contours {
            found.push(Violation::Beam { step, what: "runs along other contours than it names" });
        }
    }

    /// After the last move: everything is cut, and what lies inside an area was cut before the area was cut free. `ends`
    /// gives the move at which a contour was last cut.
    pub(super) fn finish(&self, ends: impl Fn(u32) -> Option<usize>, found: &mut Vec<Violation>) {
        for work in &self.work {
            for (e, path) in
                work.group.elements.iter().zip(&work.paths).zip(&work.cut).filter(|c| !*c.1).map(|c| c.0)
            {
                found.push(Violation::Partly {
                    step: ends(e.contour).unwrap_or(0),
                    contour: e.contour,
                    worked: 0.0,
                    length: path.length(),
                });
            }
            for (inner, contour) in (0..).zip(&self.sheet.contours) {
                if work.group.contours.contains(&inner) {
                    continue;
                }
                // The middle is used because the ends may lie on the outline.
                let (Some(at), Some(end)) = (contour.path.at(0.5 * contour.path.length()), ends(inner))
                else {
                    continue;
                };
                for face in 1..work.group.faces {
                    let late = work.free.get(face as usize).copied().flatten().is_some_and(|free| free < end);
                    if late && work.holds(face, at) {
                        let outer = work.group.contours.first().copied().unwrap_or(0);
                        found.push(Violation::CutFree { outer, inner });
                    }
                }
            }
        }
    }
}

impl Work<'_> {
    fn node(&self, at: DVec2) -> Option<u32> {
        (0..).zip(&self.group.nodes).find(|n| n.1.distance(at) <= SAME).map(|n| n.0)
    }

    /// The uncut element that a run follows from the position `gone` on, and the nodes from which and to which it leads.
    fn next(&self, run: &Path, gone: f64) -> Option<(usize, u32, u32)> {
        (0..self.paths.len())
            .filter(|&e| !self.cut[e])
            .find_map(|e| self.follows(run, gone, e).map(|n| (e, n[0], n[1])))
    }

    fn repeats(&self, run: &Path, gone: f64) -> bool {
        (0..self.paths.len()).any(|e| self.cut[e] && self.follows(run, gone, e).is_some())
    }

    fn follows(&self, run: &Path, gone: f64, e: usize) -> Option<[u32; 2]> {
        let path = &self.paths[e];
        let length = path.length();
        let slack = SAME + path.segments.iter().map(rounding).sum::<f64>();
        let [a, b] = self.group.elements[e].ends;
        [(false, [a, b]), (true, [b, a])].into_iter().find_map(|(back, ends)| {
            let along = |t: f64| if back { (1.0 - t) * length } else { t * length };
            let fits = [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().all(|t| {
                let (Some(p), Some(q)) = (run.at(gone + t * length), path.at(along(t))) else { return false };
                p.distance(q) <= slack
            });
            (fits && gone + length <= run.length() + slack).then_some(ends)
        })
    }

    /// The areas that uncut elements connect to the sheet.
    fn held(&self) -> Vec<bool> {
        let mut held = vec![false; self.group.faces as usize];
        let mut queue = vec![0_u32];
        while let Some(f) = queue.pop() {
            if !std::mem::replace(&mut held[f as usize], true) {
                let left = self
                    .group
                    .elements
                    .iter()
                    .zip(&self.cut)
                    .filter(|(e, cut)| !**cut && e.faces.contains(&f));
                queue.extend(left.flat_map(|(e, _)| e.faces));
            }
        }
        held
    }

    /// Whether one of the areas beside an element is still held.
    fn is_held(&self, e: usize) -> bool {
        self.group.elements[e].faces.iter().any(|&f| self.free[f as usize].is_none())
    }

    /// Whether an area at a node has been cut free.
    fn is_loose(&self, node: u32) -> bool {
        let mut elements = self.group.elements.iter().filter(|e| e.ends.contains(&node));
        elements.any(|e| e.faces.iter().any(|&f| self.free[f as usize].is_some()))
    }

    fn take(&mut self, e: usize, step: usize) {
        self.cut[e] = true;
        let held = self.held();
        for (free, held) in self.free.iter_mut().zip(held) {
            if !held && free.is_none() {
                *free = Some(step);
            }
        }
    }

    /// Whether a point lies inside an area and not on its outline.
    fn holds(&self, face: u32, at: DVec2) -> bool {
        let boundary = self.boundary(face);
        winding_number(&boundary, at) != 0 && boundary.iter().all(|s| s.nearest(at).1 > SAME * SAME)
    }

    /// The elements around an area, with the area on their left, in no particular order.
    fn boundary(&self, face: u32) -> Vec<Segment> {
        let mut segments = Vec::new();
        for (e, path) in self.group.elements.iter().zip(&self.paths) {
            if e.faces[0] == face && e.faces[1] != face {
                segments.extend_from_slice(&path.segments);
            } else if e.faces[1] == face && e.faces[0] != face {
                segments.extend(path.reversed().segments);
            }
        }
        segments
    }
}
