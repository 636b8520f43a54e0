//! Conversion of an order of elements to strokes of the head.
//!
//! Elements without an air move in between are one run of the beam. A pre-cut is made where the beam stops anyway, if nothing
//! that ends there is finished yet; if the beam does not stop in time, a run is interrupted.

use super::net::{Net, Step};
use crate::geometry::{DVec2, Segment};
use crate::machine::process_time;
use crate::problem::{Span, Stroke, SubPath};

/// The path of an order.
pub(super) fn sub_path(net: &Net, order: &[Step]) -> SubPath {
    let mut steps = Vec::with_capacity(order.len());
    // The pre-cuts, each with the number of steps done and the node.
    let mut made: Vec<(u32, u32, Stroke)> = Vec::new();
    net.follow(order, |at| {
        let [from, to] = net.step(at.step);
        for (node, begins, done) in [(from, true, at.ahead[0]), (to, false, at.ahead[1])] {
            made.extend(done.map(|done| (done, node, pre_cut(net, at.step, begins))));
        }
        steps.push((at.step, at.begins, at.pierced));
    });
    let mut strokes = Vec::new();
    let mut open: (Vec<Span>, Vec<Segment>) = Default::default();
    let mut head = None;
    for (done, (step, begins, pierced)) in (0..).zip(steps) {
        let [from, to] = net.step(step);
        let pre_cuts =
            |node: u32| made.iter().filter(move |m| m.0 == done && m.1 == node).map(|m| m.2.clone());
        if begins {
            close(&mut open, &mut strokes);
            if let Some(head) = head {
                strokes.extend(pre_cuts(head));
                strokes.push(Stroke::Air(net.place(from)));
            }
            if pierced {
                strokes.push(Stroke::Pierce);
            }
        } else if pre_cuts(from).next().is_some() {
            close(&mut open, &mut strokes);
        }
        strokes.extend(pre_cuts(from));
        let (span, path) = span(net, step);
        open.0.push(span);
        open.1.extend(path);
        head = Some(to);
    }
    close(&mut open, &mut strokes);
    let ends = net.ends(order).map(|n| net.place(n));
    let seconds = seconds(net, ends[0], &strokes);
    SubPath { ends, strokes, seconds }
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
        strokes.push(Stroke::Cut { spans, path });
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
            Stroke::Cut { path, .. } => {
                sum += process_time(net.machine, false, path) + net.start();
                head = path.last().map_or(head, Segment::end);
            }
        }
    }
    sum
}
