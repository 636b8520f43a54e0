//! What the checker says of plans in which one thing is wrong with a bridge.

use super::{bridging, nest, p, planned};
use crate::testkit::dxf_text::Entity;
use kerfway::geometry::{DVec2, Path, Segment};
use kerfway::machine::Profile;
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::{Bridged, Sheet};

struct Case {
    sheet: Sheet,
    machine: Profile,
    plan: Plan,
}

/// Three squares in a row, and a fourth one above the first.
fn case() -> Case {
    let mut drawing = nest(3, 1, p(20.0, 20.0), 8.0);
    drawing.push(super::rectangle(p(10.0, 38.0), p(20.0, 20.0)));
    made(&drawing, bridging(3.0, 10.0))
}

fn made(drawing: &[Entity], machine: Profile) -> Case {
    let job = planned(drawing, machine.clone());
    let plan = job.plan().unwrap();
    assert_eq!(plan.summary.bridges, 3);
    Case { sheet: job.beam_sheet().clone(), machine, plan }
}

impl Case {
    fn group(&mut self) -> &mut Bridged {
        &mut std::sync::Arc::make_mut(&mut self.sheet.bridged)[0]
    }

    /// What the checker says, as text.
    fn found(&self) -> String {
        let found = plan::check(&self.sheet, &self.machine, &self.plan).err().unwrap_or_default();
        found.iter().map(|v| format!("{v}\n")).collect()
    }

    /// Another path around the parts, which the beam follows.
    fn follow(&mut self, path: Path) {
        for step in &mut self.plan.moves {
            match step {
                Move::Cut { path: cut, .. } => cut.clone_from(&path.segments),
                Move::Air { to, .. } if *to != self.machine.home() => *to = path.start().unwrap(),
                _ => {}
            }
        }
        self.sheet.contours[0].path = path;
        let before = self.plan.summary.clone();
        self.plan.summary = plan::evaluate(&self.plan.moves, &self.sheet, &self.machine);
        (self.plan.summary.parts, self.plan.summary.bridges) = (before.parts, before.bridges);
    }

    /// Moves the corners of the strip between the first two squares, in the path and on the sheet.
    fn strip(&mut self, change: impl Fn(DVec2) -> DVec2) {
        let old = self.group().strips.iter().find(|s| s.contours == [0, 1]).unwrap().sides;
        let at = |q: DVec2| if old.as_flattened().contains(&q) { change(q) } else { q };
        let path =
            self.sheet.contours[0].path.segments.iter().map(|s| Segment::line(at(s.start()), at(s.end())));
        let path = Path::new(path.collect(), true);
        for strip in self.group().strips.iter_mut().filter(|s| s.contours == [0, 1]) {
            strip.sides = strip.sides.map(|side| side.map(&change));
        }
        let strips = self.group().strips.clone();
        self.plan.bridges = strips;
        self.follow(path);
    }
}

#[track_caller]
fn says(case: &Case, what: &str) {
    let found = case.found();
    assert!(found.contains(what), "{found}");
}

#[test]
fn the_plan_is_right_as_it_is() {
    let mut case = case();
    assert_eq!(case.found(), "");
    let path = case.sheet.contours[0].path.clone();
    case.follow(path);
    assert_eq!(case.found(), "");
    // A strip elsewhere on the same sides is as good.
    case.strip(|q| q + p(0.0, 2.0));
    assert_eq!(case.found(), "");
}

#[test]
fn bridges_that_nobody_asks_for_are_found() {
    let mut case = case();
    case.machine.levers.bridges = None;
    says(&case, "is connected, which the machine does not ask for");
}

#[test]
fn other_bridges_in_the_plan_than_on_the_sheet_are_found() {
    let mut one = case();
    one.plan.bridges.pop();
    says(&one, "has other bridges in the plan than on the sheet");
    let mut two = case();
    two.plan.summary.bridges = 2;
    says(&two, "has other bridges in the plan than on the sheet");
}

#[test]
fn wrong_widths_lengths_and_places_are_found() {
    let mut wide = case();
    wide.strip(|q| if q.y > 20.0 { q + p(0.0, 0.5) } else { q });
    says(&wide, "has a bridge of another width than asked for");
    let mut slanted = case();
    slanted.strip(|q| if q.x > 34.0 { q + p(0.0, 1.5) } else { q });
    says(&slanted, "has a bridge of another width than asked for");
    let mut long = case();
    long.machine.levers.bridges.as_mut().unwrap().reach = 7.9;
    says(&long, "has a bridge that is longer than asked for");
    let mut near = case();
    near.strip(|q| q + p(0.0, 7.6));
    says(&near, "has a bridge too near to a corner");
    let mut off = case();
    off.strip(|q| if q.x > 34.0 { q - p(1.0, 0.0) } else { q });
    says(&off, "has a bridge that does not end on an outline");
}

#[test]
fn bridges_near_other_things_are_found() {
    // The waste between the squares is free; with another clearance the parts beside the strips are too near.
    let mut drawing = nest(3, 1, p(20.0, 20.0), 8.0);
    drawing.push(super::rectangle(p(10.0, 38.0), p(20.0, 20.0)));
    drawing.push(Entity::Line(p(34.0, 1.0), p(34.0, 15.0)));
    let mut near = made(&drawing, bridging(3.0, 10.0));
    near.machine.levers.bridges.as_mut().unwrap().clearance = 4.0;
    says(&near, "has a bridge too near to something else");
    // The strips on the top and on the right of the first square are 8.5 mm from its corner each.
    let mut both = case();
    both.machine.levers.bridges.as_mut().unwrap().clearance = 12.1;
    says(&both, "has two bridges too near to each other");
}

#[test]
fn outlines_that_are_not_cut_wholly_or_not_once_are_found() {
    // The path leaves out a corner of the first square.
    let mut less = case();
    let corner = p(10.0, 10.0);
    let path = less.sheet.contours[0].path.segments.clone();
    let at = path.iter().position(|s| s.end() == corner).unwrap();
    let (a, b) = (path[at], path[(at + 1) % path.len()]);
    let mut cut: Vec<Segment> = path.clone();
    cut[at] = Segment::line(a.start(), a.at(0.9));
    cut[(at + 1) % path.len()] = Segment::line(b.at(0.1), b.end());
    cut.insert(at + 1, Segment::line(a.at(0.9), b.at(0.1)));
    less.follow(Path::new(cut, true));
    says(&less, "leaves the outlines of its parts elsewhere than along its bridges");
    // The strip is narrower than its opening: the beam crosses from one side to the other on the first square only.
    let mut open = case();
    let sides = open.group().strips.iter().find(|s| s.contours == [0, 1]).unwrap().sides;
    let strip = open.group().strips.iter_mut().find(|s| s.contours == [0, 1]).unwrap();
    strip.sides[1] = [sides[1][0], sides[1][1] + p(0.0, 1.0)];
    open.plan.bridges = open.group().strips.clone();
    says(&open, "leaves the outlines of its parts elsewhere than along its bridges");
    // The outline of the second square is closed again where the strip ends.
    let mut twice = case();
    let path = twice.sheet.contours[0].path.segments.clone();
    let at = path.iter().position(|s| s.start() == sides[0][0] && s.end() == sides[0][1]).unwrap();
    let mut cut = path.clone();
    cut.insert(at + 1, Segment::line(sides[0][1], sides[1][0]));
    cut.insert(at + 2, Segment::line(sides[1][0], sides[0][1]));
    twice.follow(Path::new(cut, true));
    says(&twice, "cuts an outline where a bridge ends on it");
    // A stretch of an outline is left out without anything in its place.
    let mut gap = case();
    let mut cut = gap.sheet.contours[0].path.clone();
    cut.segments.remove(0);
    gap.sheet.contours[0].path = cut;
    says(&gap, "goes around parts in a path that is not closed");
}

#[test]
fn parts_that_are_not_connected_as_said_are_found() {
    let mut fewer = case();
    fewer.group().strips.pop();
    fewer.plan.bridges = fewer.group().strips.clone();
    fewer.plan.summary.bridges = 2;
    says(&fewer, "goes around another number of parts than its bridges connect");
    let mut most = case();
    most.machine.levers.bridges.as_mut().unwrap().most = Some(3.0);
    says(&most, "goes around another number of parts than its bridges connect");
    let mut circle = case();
    circle.group().strips[2].contours = circle.group().strips[0].contours;
    circle.plan.bridges = circle.group().strips.clone();
    says(&circle, "has bridges that leave a part unconnected");
    let mut free = case();
    free.sheet.contours[1].bridged = None;
    says(&free, "goes around a part that is not left to it");
    let mut moved = case();
    moved.group().outlines[1].1 = moved.sheet.contours[2].path.clone();
    says(&moved, "goes around a part that is not left to it");
}

#[test]
fn cuts_have_to_name_the_parts_that_they_go_around() {
    let mut unnamed = case();
    for step in &mut unnamed.plan.moves {
        if let Move::Cut { with, .. } = step {
            with.pop();
        }
    }
    says(&unnamed, "is cut without naming the parts connected to it");
    let mut again = case();
    let square = again.group().outlines[1].1.clone();
    let cut = Move::Cut {
        contour: 1,
        with: Vec::new(),
        path: square.segments.clone(),
        mark: false,
        leads: plan::Leads::default(),
        turns: Vec::new(),
    };
    let last = again.plan.moves.len() - 1;
    again.plan.moves.splice(last..last, [Move::air(square.start().unwrap()), Move::Pierce, cut]);
    says(&again, "is cut around parts, one of which is cut by itself as well");
    let found = plan::check(&again.sheet, &again.machine, &again.plan).unwrap_err();
    assert!(found.iter().any(|v| matches!(v, Violation::Operation { contour: 1, .. })), "{found:?}");
}

#[test]
fn a_bridge_through_a_part_is_found() {
    // From the left side of the first square, through it.
    let mut through = case();
    through.strip(|q| if q.x < 34.0 { q - p(20.0, 0.0) } else { q });
    through.machine.levers.bridges.as_mut().unwrap().reach = 40.0;
    says(&through, "has a bridge in a part");
}
