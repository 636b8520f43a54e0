//! Lays out the places of all items when a search begins.

use super::super::boxes::{ARCS, BoundingBox, arcs};
use super::super::index::index;
use super::super::leave_places::LeavePlaces;
use super::super::ring::{GATES, Ring};
use super::super::travel::Travel;
use super::{Kind, Space};
use crate::geometry::{Aabb, DVec2};
use crate::problem::{Item, Node, NodeId, Problem};
use crate::solve::precedence::Precedence;

impl<'p> Space<'p> {
    pub(in crate::solve::tour_tree) fn new(problem: &'p Problem) -> Self {
        let n = problem.items.len();
        let mut s = Self {
            problem,
            travel: Travel::new(problem),
            home: problem.start().unwrap_or(index(n)),
            first: vec![0],
            point: Vec::new(),
            left: Vec::new(),
            along: Vec::new(),
            extra: Vec::new(),
            corner_first: vec![0],
            corner: Vec::new(),
            gate_first: vec![0],
            kind: Vec::with_capacity(n + 1),
            spacing: Vec::with_capacity(n + 1),
            arcs: Vec::with_capacity(n + 1),
            leave_places: LeavePlaces::new(problem),
            direction_dependent: (0..)
                .zip(&problem.items)
                .filter(|(_, i)| i.is_pierce_group())
                .map(|(id, _)| id)
                .collect(),
            whole: Vec::with_capacity(n + 1),
            most_saved: Vec::new(),
            rank: problem.items.iter().map(|i| i.rank).collect(),
            precedence: Precedence::new(problem),
        };
        let directed = problem.items.iter().any(|i| i.leads.is_some());
        s.travel.symmetric &= !directed;
        let charged = problem.items.iter().any(Item::is_uneven);
        let rings: Vec<_> = problem.items.iter().map(Ring::new).collect();
        // Reserved at once: growing the list took longer than everything else here.
        let count =
            |(ring, item): (&Option<Ring>, &Item)| ring.as_ref().map_or(item.nodes.len(), |r| r.count);
        s.point.reserve_exact(rings.iter().zip(&problem.items).map(count).sum::<usize>() + 1);
        for (item, ring) in problem.items.iter().zip(rings) {
            let (kind, spacing) = match ring {
                Some(ring) => (s.add_ring(&ring, charged), ring.spacing),
                None => (s.add_nodes(item, charged), 0.0),
            };
            s.close_item(kind, spacing, charged);
        }
        if problem.table().is_none() {
            s.point.push(problem.home);
            s.close_item(Kind::Loose, 0.0, charged);
            s.rank.push(0);
        }
        s.note_links();
        s
    }

    /// Appends the places of a ring. `charged`: with extra seconds.
    fn add_ring(&mut self, ring: &Ring, charged: bool) -> Kind {
        let prices = charged.then(|| ring.prices());
        self.point.extend(ring.points(prices.as_ref()));
        if let Some(prices) = prices {
            self.along.extend(prices.along);
            self.extra.extend(prices.extra);
            self.corner.extend(prices.corners);
        }
        Kind::Ring
    }

    /// Appends the nodes of an item without a track as its places. `charged`: with extra seconds.
    fn add_nodes(&mut self, item: &Item, charged: bool) -> Kind {
        let nodes = &self.problem.nodes[item.nodes.start as usize..item.nodes.end as usize];
        debug_assert!(
            !self.travel.by_table() || nodes.is_empty() || self.point.len() == item.nodes.start as usize,
            "a place of a table without its node's number"
        );
        self.point.extend(nodes.iter().map(|n| n.entry));
        if charged {
            let ids = item.nodes.clone();
            self.extra.extend(nodes.iter().zip(ids).map(|(n, id)| item.extra(id, n.along)));
        }
        if item.leads.is_some() {
            self.left.resize(self.point.len() - nodes.len(), DVec2::ZERO);
            self.left.extend(nodes.iter().map(|n| n.exit));
            return Kind::Directed;
        }
        let is_pair = |n: &[Node], id: NodeId| matches!(n, [a, b] if a.twin == id + 1 && b.twin == id);
        let mut pairs = nodes.chunks(2).zip((item.nodes.start..).step_by(2));
        let ends = !nodes.is_empty() && pairs.all(|(n, id)| is_pair(n, id));
        if ends { Kind::Open } else { Kind::Loose }
    }

    /// Notes the links of the problem by place.
    fn note_links(&mut self) {
        let Self { problem, .. } = *self;
        if problem.links.is_empty() {
            return;
        }
        self.travel.symmetric &= problem.links.are_symmetric();
        self.most_saved = vec![0.0; problem.items.len() + 1];
        self.travel.links = vec![Vec::new(); self.point.len()];
        let place = |node: NodeId| {
            let item = problem.nodes[node as usize].item;
            self.first[item as usize] + node - problem.items[item as usize].nodes.start
        };
        for (from, known) in (0..).zip(&problem.nodes) {
            for link in problem.links.from(from) {
                self.travel.links[place(from) as usize].push((place(link.to), link.seconds));
                for item in [known.item, problem.nodes[link.to as usize].item] {
                    let most = &mut self.most_saved[item as usize];
                    *most = link.saved.max(*most);
                }
            }
        }
    }

    /// Finishes an item whose places have been appended.
    fn close_item(&mut self, kind: Kind, spacing: f64, charged: bool) {
        let from = self.first[self.first.len() - 1] as usize;
        let places = &self.point[from..];
        let left = self.left.get(from..).unwrap_or_default();
        let b = places.iter().chain(left).fold(Aabb::EMPTY, |b, p| b.with(*p));
        let whole = BoundingBox::new(b);
        self.whole.push(whole);
        self.arcs.push(if kind == Kind::Ring { arcs(places) } else { [whole; ARCS] });
        let gates = if self.travel.by_table() { places.len() } else { places.len().min(GATES) };
        self.gate_first.push(self.gate_first[self.gate_first.len() - 1] + index(gates));
        self.first.push(index(self.point.len()));
        self.corner_first.push(index(self.corner.len()));
        if charged {
            self.along.resize(self.point.len(), 0.0);
            self.extra.resize(self.point.len(), 0.0);
        }
        self.kind.push(kind);
        self.spacing.push(spacing);
    }
}
