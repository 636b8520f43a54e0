//! Bridges: parts stay connected by strips of material, so that several outlines are one contour, which is pierced once.
//!
//! Programs for waterjets and lasers do so for small parts ([IGEMS, "Bridges"]): the outline of a part is opened on the width of a strip,
//! and the beam goes on along one side of the strip to the neighbour, around that, and back along the other side.
//!
//! 1. **Sides** ([`side`]): what an outline has along one line or one circle.
//! 2. **Candidates** ([`strip`]): strips between sides of neighbours that face each other.
//! 3. **Price** ([`price`]): the seconds of the piercing and of the move that a strip saves, less those of cutting its sides.
//! 4. **Choice**: the strips that save most come first. Each connects two pieces that were apart, lies in waste ([`room`]), keeps its
//!    distance from other strips, and saves something. If no strips are in each other's way, no other choice of strips saves more: it is
//!    a maximum spanning forest, by the algorithm of Kruskal (1956, doi:10.1090/S0002-9939-1956-0078686-7).
//! 5. **The path** ([`joined`]): once around every tree of parts.
//! 6. **Cuts through bridges** ([`later`]), if the machine separates the parts itself: across each strip, along the outlines of both parts. If it also
//!    minds what drops and what tips, they are made in pieces that stay ([`held`]), and strips that no such piece holds are not left.
//!
//! What comes after this knows one contour around several parts: leads, kerf, chains, micro-joints, skeleton cuts and all searches
//! take it as the outline of one piece, which it is.
//!
//! [IGEMS, "Bridges"]: https://igems.zendesk.com/hc/en-us/articles/22394892034076-Bridges

mod held;
mod joined;
mod later;
mod price;
mod room;
mod side;
mod strip;

use super::model::{Bridged, Contour, Operation, Pin, Sheet, Strip};
use crate::geometry::{BoxIndex, Path, Union};
use crate::machine::{Bridges, Profile};
use crate::order::{real, sort_by};
use price::Prices;
use room::{Room, bounds};
use side::Side;
use std::sync::Arc;
use strip::Candidate;

/// Least distance between the ends of a strip, and from it to everything else, in kerf widths: less, and the kerfs on both sides meet.
const KERFS: f64 = 1.5;
/// The same without a kerf width, mm.
const LEAST: f64 = 0.05;
/// Savings that differ by less are equal, s.
const SAME: f64 = 1e-9;

impl Sheet {
    /// The sheet with the bridges that a machine asks for; `None` if it asks for none, or none saves time.
    pub(crate) fn with_bridges(&self, machine: &Profile) -> Option<Self> {
        let bridges = machine.levers.bridges.as_ref()?;
        let strips = self.strips(bridges, machine);
        if strips.is_empty() {
            return None;
        }
        let mut trees = Union::new(self.contours.len());
        for Candidate { strip: Strip { contours: [a, b], .. }, .. } in &strips {
            trees.join(*a, *b);
        }
        // By contour: the strips of the tree of which it is the root.
        let mut of: Vec<Vec<Candidate>> = vec![Vec::new(); self.contours.len()];
        for candidate in strips {
            of[trees.root(candidate.strip.contours[0]) as usize].push(candidate);
        }
        let mut outlines: Vec<Vec<(u32, Path)>> = vec![Vec::new(); self.contours.len()];
        for (id, contour) in (0..).zip(&self.contours) {
            let root = trees.root(id) as usize;
            if !of[root].is_empty() {
                outlines[root].push((id, contour.path.clone()));
            }
        }
        let mut sheet = self.clone();
        let mut all: Vec<Bridged> = Vec::new();
        for ((root, own), outlines) in (0..).zip(of).zip(outlines).filter(|((_, own), _)| !own.is_empty()) {
            let path = joined::around(&outlines, &own);
            let strips: Vec<Strip> = own.into_iter().map(|c| c.strip).collect();
            let tips = held::tips(bridges, machine);
            all.push(Bridged {
                contour: root,
                holders: tips.map_or_else(Vec::new, |tips| held::holders(tips, &outlines, &strips)),
                outlines,
                strips,
                within: Vec::new(),
                cuts: Vec::new(),
            });
            if let Some(contour) = sheet.contours.get_mut(root as usize) {
                (contour.length, contour.bounds, contour.area) =
                    (path.length(), path.bounds(), path.area().abs());
                contour.path = path;
            }
        }
        let members = all.iter().flat_map(|b| b.outlines.iter().map(|o| (o.0, b.contour)));
        for (id, root) in members.collect::<Vec<_>>() {
            if let Some(contour) = sheet.contours.get_mut(id as usize) {
                contour.bridged = Some(root);
                if id != root {
                    contour.operation = Operation::Ignore;
                }
            }
        }
        for (id, contour) in (0..).zip(&self.contours) {
            let Some(outline) = contour.inside else { continue };
            let Some(root) = sheet.contours.get(outline as usize).and_then(|c| c.bridged) else { continue };
            sheet.contours[id as usize].inside = Some(root);
            let group = all.binary_search_by_key(&root, |b| b.contour);
            if let Some(bridged) = group.ok().and_then(|k| all.get_mut(k)) {
                bridged.within.push((id, outline));
            }
        }
        sheet.bridged = Arc::new(all);
        Some(sheet)
    }

    /// The strips that are left standing.
    fn strips(&self, bridges: &Bridges, machine: &Profile) -> Vec<Candidate> {
        let kerf = machine.kerf_width;
        let room = Room::new(self, (bridges.clearance + kerf).max(LEAST));
        let least = (KERFS * kerf).max(LEAST);
        let mut shared = vec![false; self.contours.len()];
        for &id in self.groups.iter().flat_map(|g| &g.contours) {
            shared[id as usize] = true;
        }
        let mut sides = Vec::new();
        for (id, contour) in (0..).zip(&self.contours) {
            let free = !shared[id as usize] && self.may_be_bridged(id, contour);
            if free && room.is_alone(id, &contour.path.segments, least) {
                sides.extend(Side::all(id, &contour.path));
            }
        }
        sides.retain(|side| side.shape.length() > bridges.width);
        let mut candidates = self.candidates(&sides, bridges, machine, least);
        // Savings that differ by rounding alone are equal.
        sort_by(&mut candidates, |(saved, c)| {
            [real(-(saved / SAME).round()), c.of[0] as u64, c.of[1] as u64]
        });
        let tips = held::tips(bridges, machine);
        let stays = |c: &u32| {
            let contour = self.contours.get(*c as usize);
            tips.is_none_or(|tips| contour.is_some_and(|c| held::stays(tips, &c.path)))
        };
        if tips.is_some() && bridges.most.is_some() {
            // Strips to parts that stay come first: others may fill a piece that has none.
            candidates.sort_by_key(|(_, c)| !c.strip.contours.iter().any(stays));
        }
        let mut trees = Union::new(self.contours.len());
        let mut parts = vec![1_u32; self.contours.len()];
        let index = BoxIndex::new(candidates.iter().map(|(_, c)| bounds(&c.strip)));
        let mut is_taken = vec![false; candidates.len()];
        for (k, (_, candidate)) in candidates.iter().enumerate() {
            let [a, b] = candidate.strip.contours.map(|c| trees.root(c));
            let together = parts[a as usize] + parts[b as usize];
            let is_apart = || {
                let mut apart = true;
                index.visit(room.around(&candidate.strip), |other| {
                    apart = !is_taken[other] || room.apart(&candidate.strip, &candidates[other].1.strip);
                    apart
                });
                apart
            };
            if a == b
                || bridges.most.is_some_and(|most| f64::from(together) > most)
                || !room.holds(candidate, &sides)
                || !is_apart()
            {
                continue;
            }
            trees.join(a, b);
            parts[trees.root(a) as usize] = together;
            is_taken[k] = true;
        }
        let taken = candidates.into_iter().zip(is_taken).filter(|(_, taken)| *taken);
        let mut strips: Vec<Candidate> = taken.map(|((_, candidate), _)| candidate).collect();
        if tips.is_some() {
            let mut held = vec![false; self.contours.len()];
            for c in strips.iter().flat_map(|c| c.strip.contours).filter(stays) {
                held[trees.root(c) as usize] = true;
            }
            strips.retain(|c| held[trees.root(c.strip.contours[0]) as usize]);
        }
        strips
    }

    /// The strips between sides of neighbours that save time, with the seconds that each saves.
    fn candidates(
        &self,
        sides: &[Side],
        bridges: &Bridges,
        machine: &Profile,
        least: f64,
    ) -> Vec<(f64, Candidate)> {
        let prices = Prices::new(machine);
        let index = BoxIndex::new(sides.iter().map(|s| s.shape.bounds()));
        let contour = |side: &Side| self.contours.get(side.contour as usize);
        let mut found = Vec::new();
        for (k, side) in sides.iter().enumerate() {
            let Some(own) = contour(side) else { continue };
            for other in index.query(side.shape.bounds().grown(bridges.reach)) {
                let Some((far, neighbour)) = sides.get(other).and_then(|far| Some((far, contour(far)?)))
                else {
                    continue;
                };
                let alike = own.layer == neighbour.layer && own.inside == neighbour.inside;
                if side.contour >= far.contour || !alike {
                    continue;
                }
                let process = self.process_of(own, machine);
                for candidate in
                    strip::between([side, far], [k, other], bridges.width, [least, bridges.reach])
                {
                    let outlines = [&own.path, &neighbour.path];
                    let saved = prices.saved(&candidate, outlines, &process, process.passes);
                    if saved > 0.0 {
                        found.push((saved, candidate));
                    }
                }
            }
        }
        found
    }

    /// Whether a contour is the outline of a part that a strip may end on: a person has said nothing else of it.
    fn may_be_bridged(&self, id: u32, contour: &Contour) -> bool {
        let plain = contour.pin == Pin::None && contour.together.is_none() && !self.has_turn(contour);
        let chosen =
            self.choices.iter().any(|c| c.contour == id) || self.joints.iter().any(|j| j.contour == id);
        contour.operation == Operation::Cut
            && contour.path.closed
            && contour.depth.is_multiple_of(2)
            && !contour.self_crossing
            && plain
            && !chosen
            && self.outline != Some(id)
    }
}
