//! What is at each node of a group: elements, areas, near nodes.

use super::super::net::{Net, Step};
use crate::geometry::{Aabb, Buckets};
use crate::order::{real, sort_by};

/// Nearest nodes of each node that are looked through first: all of 2,000 would take 16 MB.
const NEAREST: usize = 256;
/// Nearest nodes that an average air move is taken over. On 30 sheets of 16 to 900 parts and four machines that make pre-cuts
/// the job took 4.9 % less with 16 than with all nodes, 4.5 % less with 4 and 4.8 % less with 12 and 24 (`npm run bench -- groups`).
const AVERAGED: usize = 16;
/// Cosine of the largest angle at which an element counts as straight on.
const STRAIGHT: f64 = 0.99;

/// What is at each node.
pub(super) struct Places {
    /// Steps that end there.
    pub(super) arriving: Vec<Vec<Step>>,
    areas: Vec<Vec<u32>>,
    /// The nearest other nodes, in order.
    pub(super) near: Vec<Vec<u32>>,
    /// By step: the step that leads straight to it.
    straight: Vec<Option<Step>>,
}

impl Places {
    pub(super) fn new(net: &Net) -> Self {
        let nodes = net.nodes().count();
        let (mut arriving, mut areas) = (vec![Vec::new(); nodes], vec![Vec::new(); nodes]);
        for step in net.steps() {
            let node = net.step(step)[1] as usize;
            arriving[node].push(step);
            for f in net.faces(step) {
                if !areas[node].contains(&f) {
                    areas[node].push(f);
                }
            }
        }
        let straight = net.steps().map(|step| straight_to(net, &arriving, step)).collect();
        let mut grid = Buckets::new(net.nodes().fold(Aabb::EMPTY, |b, n| b.with(net.place(n))), nodes);
        net.nodes().for_each(|n| grid.insert(n, net.place(n)));
        let near = net.nodes().map(|n| nearest(net, &grid, n)).collect();
        Self { arriving, areas, near, straight }
    }

    /// The step that leads straight to another one.
    pub(super) fn straight_on(&self, step: Step) -> Option<Step> {
        self.straight[step as usize]
    }

    /// Seconds of an average air move from a node to one near to it.
    pub(super) fn average_way(&self, net: &Net) -> f64 {
        let ways = |n: u32| self.near[n as usize].iter().take(AVERAGED).map(move |&to| net.way(n, to));
        let (sum, count) =
            net.nodes().flat_map(ways).fold((0.0, 0_u32), |(sum, count), way| (sum + way, count + 1));
        sum / f64::from(count.max(1))
    }

    /// Areas around a node.
    pub(super) fn areas(&self, node: u32) -> &[u32] {
        &self.areas[node as usize]
    }
}

/// The step that leads straight to another one.
fn straight_to(net: &Net, arriving: &[Vec<Step>], step: Step) -> Option<Step> {
    let begin = net.travelled(step).first()?.tangent(0.0);
    let before = arriving[net.step(step)[0] as usize].iter().copied().filter(|&a| a / 2 != step / 2);
    before
        .filter_map(|a| Some((net.travelled(a).last()?.tangent(1.0).dot(begin), a)))
        .filter(|a| a.0 > STRAIGHT)
        .reduce(|best, a| if a.0 > best.0 { a } else { best })
        .map(|a| a.1)
}

/// The nodes nearest to one in seconds. Where other contours bridge ways, the net is so small that all nodes are among them.
fn nearest(net: &Net, grid: &Buckets, node: u32) -> Vec<u32> {
    let place = net.place(node);
    let mut others: Vec<(f64, u32)> = Vec::new();
    for ring in 0..grid.rings(place) {
        let least = net.air.seconds_at_least(grid.distance_of_ring(ring));
        if others.len() >= NEAREST && others.iter().filter(|o| o.0 < least).count() >= NEAREST {
            break;
        }
        others.extend(grid.ring(place, ring).filter(|&n| n != node).map(|n| (net.way(n, node), n)));
    }
    sort_by(&mut others, |o| [real(o.0), o.1.into(), 0]);
    others.truncate(NEAREST);
    others.into_iter().map(|o| o.1).collect()
}
