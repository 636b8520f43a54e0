//! Checks pierce groups: every shared cut is cut once, nothing is cut after it has fallen out, and pre-cuts are where they
//! are needed. On a machine without pre-cuts, the beam begins again where a stretch of the group was cut before.
//!
//! The beam is followed from element to element. An area is held as long as a chain of uncut elements connects it to the area
//! around the group. So after every element, such a chain is looked for between the two areas that the element connected. (The
//! planner looks at the order backwards instead.)

use super::coverage::leads;
use super::group_work::{NEAR, Work};
use super::tolerance::{SAME, slack};
use super::violation::Violation;
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Move, Plan};
use crate::sheet::{PierceGroup, Sheet};

/// For each contour, whether it is cut in one go, with no other, and does not begin in the kerf of another one, unpierced after a
/// move with the beam off. A pause in a sharp corner does not interrupt it.
fn cut_alone(sheet: &Sheet, plan: &Plan) -> Vec<bool> {
    let mut starts = vec![0_u32; sheet.contours.len()];
    let mut alone = vec![true; sheet.contours.len()];
    let (mut paused, mut in_kerf) = (false, false);
    for step in &plan.moves {
        if let Move::Cut { contour, with, .. } = step {
            if let Some(alone) = alone.get_mut(*contour as usize).filter(|_| in_kerf) {
                *alone = false;
            }
            if let Some(starts) = starts.get_mut(*contour as usize).filter(|_| !paused) {
                *starts += 1;
            }
            for &c in std::iter::once(contour).chain(with).filter(|_| !with.is_empty()) {
                alone.get_mut(c as usize).into_iter().for_each(|alone| *alone = false);
            }
        }
        paused = matches!(step, Move::Macro { .. });
        in_kerf = matches!(step, Move::Air { .. })
            || in_kerf && matches!(step, Move::Wait { .. } | Move::Height { .. });
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
            work.push(Work::new(group));
        }
        Self { sheet, pre_cuts, work, of }
    }

    /// The groups that the plan cuts as one.
    pub(super) fn each(&self) -> impl Iterator<Item = &PierceGroup> {
        self.work.iter().map(|work| work.group)
    }

    /// The path of each contour; where the plan cuts a group as one, its path in the group.
    pub(super) fn paths(&self) -> Vec<&Path> {
        let mut paths: Vec<&Path> = self.sheet.contours.iter().map(|c| &c.path).collect();
        for group in self.each() {
            for (&contour, joined) in group.contours.iter().zip(&group.paths) {
                if let Some(path) = paths.get_mut(contour as usize) {
                    *path = joined;
                }
            }
        }
        paths
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
        let fits = work.ending_near(head, NEAR).into_iter().filter(|&e| !work.cut[e]).any(|e| {
            let (e, path) = (&work.group.elements[e], &work.paths[e]);
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
        // Arcs whose ends lie beside their circle have another length backwards.
        let same = SAME + path.iter().map(slack).sum::<f64>();
        while gone < length - same {
            let Some((e, node, to)) = work.next(&run, gone, same, contours) else {
                let at = run.at(gone).unwrap_or_default();
                found.push(if work.repeats(&run, gone, same) {
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
        if self.work.is_empty() {
            return;
        }
        // The middle is used because the ends may lie on the outline.
        let middle = |path: &Path| path.at(0.5 * path.length()).map_or(Aabb::EMPTY, Aabb::of);
        let middles: Vec<Aabb> = self.sheet.contours.iter().map(|c| middle(&c.path)).collect();
        let index = BoxIndex::new(middles.iter().copied());
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
            let bounds = |beside: &Vec<usize>| {
                beside.iter().fold(Aabb::EMPTY, |b, &e| b.union(work.paths[e].bounds()))
            };
            let faces: Vec<Aabb> = work.beside.iter().map(bounds).collect();
            let all = faces.iter().fold(Aabb::EMPTY, |all, b| all.union(*b));
            let index_of_faces = BoxIndex::new(faces);
            for (inner, place) in
                index.query(all).into_iter().filter_map(|k| Some((u32::try_from(k).ok()?, middles[k])))
            {
                let Some(end) = ends(inner).filter(|_| work.group.contours.binary_search(&inner).is_err())
                else {
                    continue;
                };
                for face in index_of_faces.query(place).into_iter().filter(|face| *face > 0) {
                    let late = work.free[face].is_some_and(|free| free < end);
                    if late && work.holds(face, place.min) {
                        let outer = work.group.contours.first().copied().unwrap_or(0);
                        found.push(Violation::CutFree { outer, inner });
                    }
                }
            }
        }
    }
}
