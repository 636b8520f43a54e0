//! Checks pierce groups: every shared cut is cut once, nothing is cut after it has fallen out, and pre-cuts are where they
//! are needed. On a machine without pre-cuts, the beam begins again where a stretch of the group was cut before.
//!
//! The beam is followed from element to element. After every element, the areas that are still held are found again from
//! the outside in: an area is held as long as a chain of uncut elements connects it to the area around the group. (The
//! planner looks at the order backwards instead.)

use super::coverage::leads;
use super::tolerance::{SAME, rounding};
use super::violation::Violation;
use crate::geometry::{DVec2, Path, Segment, winding_number};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Move, Plan};
use crate::sheet::{PierceGroup, Sheet};

/// An element that a run follows begins or ends nearer to it than this, mm: far more than [`SAME`] and any rounding.
const NEAR: f64 = 1.0;

/// The state of a group.
struct Work<'s> {
    group: &'s PierceGroup,
    paths: Vec<Path>,
    /// For each area, the elements beside it.
    beside: Vec<Vec<usize>>,
    cut: Vec<bool>,
    /// Pre-cuts made, as contour and node.
    ahead: Vec<(u32, u32)>,
    /// For each area, the move that cut it free.
    free: Vec<Option<usize>>,
}

/// For each area of a group, the elements that have it on one side or on both, in order.
fn beside(group: &PierceGroup) -> Vec<Vec<usize>> {
    let mut beside = vec![Vec::new(); group.faces as usize];
    for (e, element) in group.elements.iter().enumerate() {
        let [left, right] = element.faces.map(|f| f as usize);
        beside[left].push(e);
        if left != right {
            beside[right].push(e);
        }
    }
    beside
}

/// For each contour, whether it is cut in one go, with no other. A pause in a sharp corner does not interrupt it.
fn cut_alone(sheet: &Sheet, plan: &Plan) -> Vec<bool> {
    let mut starts = vec![0_u32; sheet.contours.len()];
    let mut alone = vec![true; sheet.contours.len()];
    let mut paused = false;
    for step in &plan.moves {
        if let Move::Cut { contour, with, .. } = step {
            if let Some(starts) = starts.get_mut(*contour as usize).filter(|_| !paused) {
                *starts += 1;
            }
            for &c in std::iter::once(contour).chain(with).filter(|_| !with.is_empty()) {
                alone.get_mut(c as usize).into_iter().for_each(|alone| *alone = false);
            }
        }
        paused = matches!(step, Move::Macro { .. });
    }
    alone.into_iter().zip(starts).map(|(alone, starts)| alone && starts == 1).collect()
}

/// The pierce groups of a sheet and their states.
pub(super) struct Groups<'s> {
    pub(super) sheet: &'s Sheet,
    pre_cuts: bool,
    work: Vec<Work<'s>>,
    /// For each contour, its group.
    of: Vec<Option<usize>>,
}

impl<'s> Groups<'s> {
    /// Those that the plan cuts as one: all of them on a machine with pre-cuts, none on one that cuts every contour by itself, and
    /// otherwise those of which some contour is not cut whole by itself.
    pub(super) fn new(sheet: &'s Sheet, machine: &Profile, plan: &Plan) -> Self {
        // Builds without the lever refuse machines with it.
        let pre_cuts = !PLANS_ALL_LEVERS || machine.makes_pre_cuts();
        let mut of = vec![None; sheet.contours.len()];
        let mut work = Vec::new();
        let alone = if pre_cuts { Vec::new() } else { cut_alone(sheet, plan) };
        let is_alone = |c: &u32| alone.get(*c as usize).is_some_and(|alone| *alone);
        for group in sheet.cut_as_one(machine.cuts_as_one()) {
            if group.contours.iter().all(is_alone) {
                continue;
            }
            for &c in &group.contours {
                if let Some(of) = of.get_mut(c as usize) {
                    *of = Some(work.len());
                }
            }
            work.push(Work {
                group,
                paths: group.elements.iter().map(|e| group.path(e)).collect(),
                beside: beside(group),
                cut: vec![false; group.elements.len()],
                ahead: Vec::new(),
                free: vec![None; group.faces as usize],
            });
        }
        Self { sheet, pre_cuts, work, of }
    }

    /// The groups that the plan cuts as one.
    pub(super) fn each(&self) -> impl Iterator<Item = &PierceGroup> {
        self.work.iter().map(|work| work.group)
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

    /// Follows a cut. `ready`: it was pierced, or continues where the beam just was. Without pre-cuts, a move with the beam off between
    /// two cuts is made to a kerf.
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
        let pre_cuts = self.pre_cuts;
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
            let begins =
                first && !ready && !if pre_cuts { pre_cut(node, work) } else { work.is_on_kerf(node) };
            if begins || (pre_cuts && work.is_loose(to) && !pre_cut(to, work)) {
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
        let at = run.at(gone)?;
        let is_near = |end: Option<DVec2>| end.is_some_and(|end| end.distance(at) < NEAR);
        // Few elements end where the run is, which is found out before the whole run is walked through for each.
        (0..self.paths.len())
            .filter(|&e| !self.cut[e] && (is_near(self.paths[e].start()) || is_near(self.paths[e].end())))
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
                let left = self.beside[f as usize].iter().filter(|&&e| !self.cut[e]);
                queue.extend(left.flat_map(|&e| self.group.elements[e].faces));
            }
        }
        held
    }

    /// Whether one of the areas beside an element is still held.
    fn is_held(&self, e: usize) -> bool {
        self.group.elements[e].faces.iter().any(|&f| self.free[f as usize].is_none())
    }

    /// Whether a stretch that ends at a node has been cut.
    fn is_on_kerf(&self, node: u32) -> bool {
        let place = self.group.nodes.get(node as usize);
        let ends = |path: &Path| [path.start(), path.end()];
        let cut = self.paths.iter().zip(&self.cut).filter(|(_, cut)| **cut);
        let mut places = cut.flat_map(|(path, _)| ends(path)).flatten();
        place.is_some_and(|node| places.any(|end| end.distance(*node) <= SAME))
    }

    /// Whether an area at a node has been cut free.
    fn is_loose(&self, node: u32) -> bool {
        let mut elements = self.group.elements.iter().filter(|e| e.ends.contains(&node));
        elements.any(|e| e.faces.iter().any(|&f| self.free[f as usize].is_some()))
    }

    fn take(&mut self, e: usize, step: usize) {
        self.cut[e] = true;
        let [left, right] = self.group.elements[e].faces;
        // It connected nothing if it has the same area on both sides, and nothing that is still held if one of its areas is free.
        if left == right || [left, right].iter().any(|&f| self.free[f as usize].is_some()) {
            return;
        }
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
        let beside = self.beside.get(face as usize).into_iter().flatten();
        for (e, path) in beside.map(|&e| (&self.group.elements[e], &self.paths[e])) {
            if e.faces[0] == face && e.faces[1] != face {
                segments.extend_from_slice(&path.segments);
            } else if e.faces[1] == face && e.faces[0] != face {
                segments.extend(path.reversed().segments);
            }
        }
        segments
    }
}
