//! Conversion of an order of elements to strokes of the head.
//!
//! Elements without an air move in between are one run of the beam. A pre-cut is made where the beam stops anyway, if nothing
//! that ends there is finished yet; if the beam does not stop in time, a run is interrupted.
//!
//! The path may be left for other items between two elements: where it makes an air move anyway, and at a node at which
//! nothing has come loose yet, with a pre-cut of the next element.

use super::net::{Net, Step};
use crate::geometry::{DVec2, Segment};
use crate::machine::process_time;
use crate::problem::{LeavePoint, Span, Stroke, SubPath};

/// The path of an order. The seconds of its leave points do not contain the stop of the beam yet; see [`priced`].
pub(super) fn sub_path(net: &Net, order: &[Step]) -> SubPath {
    let mut steps = Vec::with_capacity(order.len());
    // The pre-cuts, each with the number of steps done and the node.
    let mut made: Vec<(u32, u32, Stroke)> = Vec::new();
    net.follow(order, |at| {
        let [from, to] = net.step(at.step);
        for (node, begins, done) in [(from, true, at.ahead[0]), (to, false, at.ahead[1])] {
            made.extend(done.map(|done| (done, node, pre_cut(net, at.step, begins))));
        }
        steps.push((at.step, at.begins, at.pierced, at.loose));
    });
    let mut strokes = Vec::new();
    let mut open: (Vec<Span>, Vec<Segment>) = Default::default();
    let mut head = None;
    let mut leave_points = Vec::new();
    // The length cut before each step, and that of all.
    let mut along = vec![0.0];
    for (done, (step, begins, pierced, loose)) in (0..).zip(steps) {
        let [from, to] = net.step(step);
        let mut leave = |head: u32, strokes: usize, spans: usize, seconds: f64, pre_cut: Option<Stroke>| {
            leave_points.push(LeavePoint {
                along: along[along.len() - 1],
                node: head,
                ends: [net.place(head), net.place(from)],
                seconds,
                strokes,
                spans,
                pre_cut,
            });
        };
        let pre_cuts =
            |node: u32| made.iter().filter(move |m| m.0 == done && m.1 == node).map(|m| m.2.clone());
        if begins {
            close(&mut open, &mut strokes);
            if let Some(head) = head {
                strokes.extend(pre_cuts(head));
                leave(head, strokes.len(), 0, -net.way(head, from), None);
                strokes.push(Stroke::Air(net.place(from)));
            }
            if pierced {
                strokes.push(Stroke::Pierce);
            }
        } else if pre_cuts(from).next().is_some() {
            close(&mut open, &mut strokes);
        }
        strokes.extend(pre_cuts(from));
        if !begins && !loose && !net.starts_on_kerfs() {
            leave(from, strokes.len(), open.0.len(), net.pre_cut(), Some(pre_cut(net, step, true)));
        }
        let (span, path) = span(net, step);
        along.push(along[along.len() - 1] + span.length);
        open.0.push(span);
        open.1.extend(path);
        head = Some(to);
    }
    close(&mut open, &mut strokes);
    let ends = net.ends(order).map(|n| net.place(n));
    let seconds = seconds(net, ends[0], &strokes);
    // A group that is the only item is left for nothing.
    if net.is_all {
        return SubPath {
            ends,
            lead_in: None,
            strokes,
            seconds,
            leave_points: Vec::new(),
            falls: Vec::new(),
        };
    }
    SubPath { ends, lead_in: None, strokes, seconds, leave_points, falls: falls(net, order, &along) }
}

/// By area, the place on the path at which it has fallen out; `along` gives the place before each step. The order is
/// followed backwards: an area holds from the step on by whose element it is connected to what holds already.
fn falls(net: &Net, order: &[Step], along: &[f64]) -> Vec<f64> {
    let mut falls = vec![f64::INFINITY; net.sides.len()];
    let mut held = net.held();
    for (&step, &after) in order.iter().zip(along.iter().skip(1)).rev() {
        for area in net.faces(step).map(|f| f as usize) {
            if !held[area] {
                falls[area] = after;
            }
        }
        net.put_back(&mut held, step);
    }
    falls
}

/// The path with the exact seconds of its leave points: within a run, leaving takes one more start of the beam, and the
/// head stops.
pub(super) fn priced(net: &Net, mut path: SubPath) -> SubPath {
    let seconds = |path: &[Segment]| process_time(net.machine, &net.machine.cut, false, path);
    for point in path.leave_points.iter_mut().filter(|p| p.spans > 0) {
        let Some(Stroke::Cut { spans, path: run, .. }) = path.strokes.get(point.strokes) else { continue };
        let elements = spans.iter().take(point.spans).map(|s| s.elements).sum::<usize>();
        let (before, after) = run.split_at(elements.min(run.len()));
        point.seconds += net.start() + seconds(before) + seconds(after) - seconds(run);
    }
    path
}

/// The pre-cut of a step, from its beginning or, backwards, from its end.
fn pre_cut(net: &Net, step: Step, begins: bool) -> Stroke {
    let element = &net.group.elements[step as usize / 2];
    let forwards = begins == step.is_multiple_of(2);
    let ahead = if forwards {
        net.machine.cut_ahead(&element.path)
    } else {
        net.machine.cut_ahead(&element.path.reversed())
    };
    Stroke::PreCut { contour: element.contour, ahead }
}

fn close(open: &mut (Vec<Span>, Vec<Segment>), strokes: &mut Vec<Stroke>) {
    let (spans, path) = std::mem::take(open);
    if !path.is_empty() {
        strokes.push(Stroke::Cut { spans, path, overcut: 0 });
    }
}

fn span(net: &Net, step: Step) -> (Span, Vec<Segment>) {
    let (element, path) = (&net.group.elements[step as usize / 2], net.travelled(step));
    let (reversed, contour, length) = (step % 2 == 1, element.contour, element.path.length());
    let (along, until) = if reversed { (element.to, element.from) } else { (element.from, element.to) };
    (Span { contour, along, until, reversed, length, elements: path.len() }, path)
}

/// The seconds of all strokes.
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
            // Groups are not cut on the run.
            Stroke::MovingStart | Stroke::Fly(_) => {}
            Stroke::Cut { path, .. } => {
                sum += process_time(net.machine, &net.machine.cut, false, path) + net.start();
                head = path.last().map_or(head, Segment::end);
            }
        }
    }
    sum
}
