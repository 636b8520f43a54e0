//! An order of elements as what the head does.
//!
//! Elements that follow each other without an air move are one run of the beam. A pre-cut is made when the head is first
//! at its node, before anything that ends there is finished; where that is in the middle of a run, the run is
//! interrupted.

use super::SubPath;
use super::net::{Net, Step};
use crate::geometry::{DVec2, Segment};
use crate::machine::work_time;

/// One thing the head does in a group.
#[derive(Clone, Debug, PartialEq)]
pub enum Stroke {
    /// Air move, mm.
    Air(DVec2),
    /// Piercing.
    Pierce,
    /// A bit cut ahead from where the head is.
    PreCut {
        /// Into which contour.
        contour: u32,
        /// What is cut; empty where pre-cuts have no length.
        ahead: Vec<Segment>,
    },
    /// Along elements.
    Cut {
        /// Which, in order.
        spans: Vec<Span>,
        /// All of them, in the direction of travel.
        path: Vec<Segment>,
    },
}

/// A stretch of a contour in the direction of travel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Its contour.
    pub contour: u32,
    /// Arc length from the contour's stored start to where it is entered, mm.
    pub along: f64,
    /// The same to where it is left.
    pub until: f64,
    /// Against the contour's stored direction.
    pub reversed: bool,
    /// mm.
    pub length: f64,
    /// Elements of the path.
    pub elements: usize,
}

/// The path of an order.
pub(super) fn sub_path(net: &Net, order: &[Step]) -> SubPath {
    let mut steps = Vec::with_capacity(order.len());
    // Pre-cuts of each node still to be made.
    let mut due: Vec<Vec<Stroke>> = vec![Vec::new(); net.group.nodes.len()];
    net.follow(order, |at| {
        let ends = net.step(at.step);
        for (&node, _) in ends.iter().zip(at.ahead).filter(|e| e.1) {
            due[node as usize].push(pre_cut(net, at.step, node == ends[0]));
        }
        steps.push((at.step, at.begins, at.pierced));
    });
    let mut strokes = Vec::new();
    let mut open: (Vec<Span>, Vec<Segment>) = Default::default();
    let mut head = None;
    for (step, begins, pierced) in steps {
        let [from, to] = net.step(step);
        if begins {
            close(&mut open, &mut strokes);
            if head.is_some() {
                strokes.push(Stroke::Air(net.place(from)));
            }
            if pierced {
                strokes.push(Stroke::Pierce);
            }
            strokes.append(&mut due[from as usize]);
        }
        let (span, path) = span(net, step);
        open.0.push(span);
        open.1.extend(path);
        head = Some(to);
        if !due[to as usize].is_empty() {
            close(&mut open, &mut strokes);
            strokes.append(&mut due[to as usize]);
        }
    }
    close(&mut open, &mut strokes);
    let ends = net.ends(order).map(|n| net.place(n));
    let seconds = seconds(net, ends[0], &strokes);
    SubPath { ends, strokes, seconds }
}

/// What is cut ahead of a step from where it begins, or back from where it ends: half of it at most.
fn pre_cut(net: &Net, step: Step, begins: bool) -> Stroke {
    let (element, path) = (&net.group.elements[step as usize / 2], &net.paths[step as usize / 2]);
    let (contour, length) = (element.contour, net.machine.pre_cut_length.min(0.5 * path.length()));
    let ahead = match (length > 0.0, begins == step.is_multiple_of(2)) {
        (false, _) => Vec::new(),
        (true, true) => path.between(0.0, length),
        (true, false) => path.reversed().between(0.0, length),
    };
    Stroke::PreCut { contour, ahead }
}

fn close(open: &mut (Vec<Span>, Vec<Segment>), strokes: &mut Vec<Stroke>) {
    let (spans, path) = std::mem::take(open);
    if !path.is_empty() {
        strokes.push(Stroke::Cut { spans, path });
    }
}

fn span(net: &Net, step: Step) -> (Span, Vec<Segment>) {
    let (element, path) = (&net.group.elements[step as usize / 2], &net.paths[step as usize / 2]);
    let (reversed, contour, length) = (step % 2 == 1, element.contour, path.length());
    let (along, until, elements) = (element.from, element.to, path.segments.len());
    if reversed {
        let span = Span { contour, along: until, until: along, reversed, length, elements };
        return (span, path.reversed().segments);
    }
    (Span { contour, along, until, reversed, length, elements }, path.segments.clone())
}

/// All seconds of these strokes.
fn seconds(net: &Net, start: DVec2, strokes: &[Stroke]) -> f64 {
    let mut head = start;
    let mut sum = 0.0;
    for stroke in strokes {
        match stroke {
            Stroke::Air(to) => {
                sum += net.air.seconds(head, *to);
                head = *to;
            }
            Stroke::Pierce => sum += net.machine.pierce_time,
            Stroke::PreCut { .. } => sum += net.pre_cut(),
            Stroke::Cut { path, .. } => {
                sum += work_time(net.machine, false, path) + net.start();
                head = path.last().map_or(head, Segment::end);
            }
        }
    }
    sum
}
