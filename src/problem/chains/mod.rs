//! Chains (`levers.chains` of the machine): which contours may be joined by a cut through waste, where, and what that takes.
//!
//! A chain goes straight from the end of one contour to the entry of the next, with the beam on. So it takes the place of the
//! beam's delays, an air move and a piercing. The contours that may be joined are closed cuts of one layer that bound the same
//! piece of waste: outlines of parts that lie side by side, and the hole around them. Each may be entered where contours usually
//! are, and opposite its neighbours; every pair of such places is tried, and a chain that keeps its distances and takes less than
//! what it stands for becomes a link of the problem, so that the search chooses between both in the price of every move.
//!
//! An *edge start* is the same cut from another place on the kerf of the contour that was cut last, to which the head moves with the
//! beam off. It saves the piercing, but neither the move nor the delays. The places are those of that contour, and the nearest
//! one to the entry. Starts on the kerfs of other contours that were cut before are places of entry (`kerf_starts.rs`).
//!
//! Here is which contours may be joined and where they are entered; `links.rs` prices the cuts between these places.

mod links;

use super::entries::entries;
use super::leads::Planners;
use crate::geometry::{BoxIndex, DVec2, Path};
use crate::lead::Scrap;
use crate::machine::{Chains, PLANS_ALL_LEVERS, Profile};
use crate::order::{real, sort_by};
use crate::sheet::{Contour, Operation, Sheet};

/// Most places of a contour that are opposite a neighbour: with those that it has anyway they are about as many as the gates of
/// the search.
const OPPOSITE: usize = 8;
/// Places nearer to each other than this are one, mm.
const SAME: f64 = 1e-3;

/// A contour that may be joined to others.
struct Joined {
    contour: u32,
    /// The piece of waste that it bounds: the contour around it, or the hole itself.
    waste: Option<u32>,
    /// Places where it may be entered, by arc length, mm; none if it has leads, which have their own.
    places: Vec<(f64, DVec2)>,
}

/// A contour that another one may be joined to.
pub(super) struct Neighbour<'s, 'c> {
    pub(super) contour: u32,
    pub(super) path: &'s Path,
    /// Places where it may be entered, by arc length, mm.
    pub(super) places: &'c [(f64, DVec2)],
}

/// The contours of a sheet that may be joined.
pub(super) struct Candidates<'s> {
    sheet: &'s Sheet,
    machine: &'s Profile,
    lever: Chains,
    all: Vec<Joined>,
    /// By contour: its number among them.
    of: Vec<Option<u32>>,
    boxes: BoxIndex,
    scrap: Scrap<'s>,
}

impl<'s> Candidates<'s> {
    /// Those of a sheet on a machine with chains; `is_alone` says which contours are not cut with others as one.
    pub(super) fn new(
        sheet: &'s Sheet,
        machine: &'s Profile,
        planners: &Planners,
        is_alone: impl Fn(u32) -> bool,
    ) -> Option<Self> {
        let lever = machine.levers.chains.filter(|_| PLANS_ALL_LEVERS)?;
        let may = |id: u32, c: &Contour| {
            let once = sheet.process_of(c, machine).passes == 1 && c.pass == 0 && c.next_pass.is_none();
            c.path.closed
                && c.operation == Operation::Cut
                && once
                && c.length > 0.0
                && !c.self_crossing
                && planners.joints(id).is_none()
                && is_alone(id)
        };
        let bed = machine.bed().filter(|bed| bed.contains_box(&sheet.bounds));
        let mut new = Self {
            sheet,
            machine,
            lever,
            all: Vec::new(),
            of: vec![None; sheet.contours.len()],
            boxes: BoxIndex::new([]),
            scrap: Scrap::new(&sheet.contours, lever.clearance, machine.kerf_width, bed),
        };
        let ids = (0..).zip(&sheet.contours).filter(|(id, c)| may(*id, c));
        for (id, contour) in ids {
            let waste = if contour.depth % 2 == 1 { Some(id) } else { contour.inside };
            if let Some(of) = new.of.get_mut(id as usize) {
                *of = u32::try_from(new.all.len()).ok();
            }
            new.all.push(Joined { contour: id, waste, places: Vec::new() });
        }
        new.boxes = BoxIndex::new(new.all.iter().filter_map(|j| new.contour(j)).map(|c| c.bounds));
        let pairs = new.pairs();
        new.find_places(&pairs);
        Some(new)
    }

    fn contour(&self, joined: &Joined) -> Option<&'s Contour> {
        self.sheet.contours.get(joined.contour as usize)
    }

    /// The contours that bound one piece of waste, on one layer, and are near enough to each other, in pairs.
    fn pairs(&self) -> Vec<(usize, usize)> {
        let mut pairs = Vec::new();
        for (k, joined) in self.all.iter().enumerate() {
            let Some(contour) = self.contour(joined) else { continue };
            let near = self.boxes.query(contour.bounds.grown(self.lever.reach));
            pairs.extend(near.into_iter().filter(|&n| n > k && self.are_alike(k, n)).map(|n| (k, n)));
        }
        pairs
    }

    /// Whether two contours bound one piece of waste, on one layer.
    fn are_alike(&self, a: usize, b: usize) -> bool {
        let known = |k: usize| self.all.get(k).and_then(|j| Some((j.waste, self.contour(j)?.layer)));
        known(a).is_some_and(|a| Some(a) == known(b))
    }

    /// Notes where the contours of pairs may be entered: their entries, and before these the places opposite their neighbours,
    /// the nearest first.
    fn find_places(&mut self, pairs: &[(usize, usize)]) {
        let mut opposite: Vec<Vec<(f64, f64, DVec2)>> = vec![Vec::new(); self.all.len()];
        let mut usual: Vec<Option<Vec<(f64, DVec2)>>> = vec![None; self.all.len()];
        for &(a, b) in pairs {
            for (k, other) in [(a, b), (b, a)] {
                let path = |k: usize| self.all.get(k).and_then(|j| self.contour(j)).map(|c| &c.path);
                let (Some(from), Some(to)) = (path(k), path(other)) else { continue };
                let Some(places) = usual.get_mut(k) else { continue };
                let places = places.get_or_insert_with(|| entries(from));
                let near = |&(_, p): &(f64, DVec2)| to.nearest(p).map(|(along, q)| (p.distance(q), along, q));
                let nearest = places.iter().filter_map(near).min_by(|a, b| a.0.total_cmp(&b.0));
                if let (Some(found), Some(list)) = (nearest, opposite.get_mut(other)) {
                    list.push(found);
                }
            }
        }
        for ((joined, mut opposite), usual) in self.all.iter_mut().zip(opposite).zip(usual) {
            let Some(usual) = usual else { continue };
            sort_by(&mut opposite, |o| [real(o.0), real(o.1), 0]);
            let mut places: Vec<(f64, DVec2)> = Vec::new();
            let mut add = |along: f64, p: DVec2, most: usize| {
                if places.len() < most && places.iter().all(|q| q.1.distance(p) >= SAME) {
                    places.push((along, p));
                }
            };
            opposite.into_iter().for_each(|(_, along, p)| add(along, p, OPPOSITE));
            usual.into_iter().for_each(|(along, p)| add(along, p, usize::MAX));
            joined.places = places;
        }
    }

    /// The places where a contour may be entered, if it is near another that it may be joined to.
    pub(super) fn places(&self, contour: u32) -> Option<&[(f64, DVec2)]> {
        let joined = self.all.get(self.of.get(contour as usize).copied().flatten()? as usize)?;
        Some(&joined.places).filter(|p| !p.is_empty()).map(Vec::as_slice)
    }

    pub(super) fn lever(&self) -> Chains {
        self.lever
    }

    pub(super) fn scrap(&self) -> &Scrap<'s> {
        &self.scrap
    }

    /// Whether a contour may be joined to others.
    pub(super) fn holds(&self, contour: u32) -> bool {
        self.of.get(contour as usize).is_some_and(Option::is_some)
    }

    /// The contours that a contour may be joined to.
    pub(super) fn beside(&self, contour: u32) -> Vec<Neighbour<'s, '_>> {
        let own = self.of.get(contour as usize).copied().flatten();
        let own = own.and_then(|k| Some((k as usize, self.all.get(k as usize)?)));
        let Some((k, known)) = own.and_then(|(k, joined)| Some((k, self.contour(joined)?))) else {
            return Vec::new();
        };
        let near = self.boxes.query(known.bounds.grown(self.lever.reach));
        let alike = near.into_iter().filter(|&n| n != k && self.are_alike(k, n)).filter_map(|n| {
            let joined = self.all.get(n)?;
            Some(Neighbour {
                contour: joined.contour,
                path: &self.contour(joined)?.path,
                places: &joined.places,
            })
        });
        alike.collect()
    }
}
