//! The order of parts that share sides: what is left of an outline encloses what lies in it, for the planner and for the checker.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::sheets::assert_feasible;
use kerfway::job::{Job, LayerChoice, LoadOptions, MachineChoice, PlanOptions, problem_of};
use kerfway::machine::{Heat, Levers, Lift, Profile, RiskyMoves, SharedCuts, SmallHoles, Tips, preset};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::{Operation, PassOrder, Sheet};
use kerfway::solve::{Solution, Stop};
use std::fmt::Write;

/// A shape on a layer, mm.
#[derive(Clone, Copy)]
enum Shape {
    /// Left, bottom, width, height.
    Rectangle(&'static str, [f64; 4]),
    /// Corners.
    Polygon(&'static str, &'static [[f64; 2]]),
    /// Centre and radius.
    Circle(&'static str, [f64; 3]),
}
use Shape::{Circle, Polygon, Rectangle};

fn polygon(text: &mut String, layer: &str, corners: &[[f64; 2]]) {
    let _ = write!(text, "0\nLWPOLYLINE\n8\n{layer}\n90\n{}\n70\n1\n", corners.len());
    for [x, y] in corners {
        let _ = write!(text, "10\n{x}\n20\n{y}\n");
    }
}

fn drawing(shapes: &[Shape]) -> Vec<u8> {
    let mut text =
        String::from("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
    for shape in shapes {
        match shape {
            Rectangle(layer, [x, y, w, h]) => {
                polygon(&mut text, layer, &[[*x, *y], [x + w, *y], [x + w, y + h], [*x, y + h]]);
            }
            Polygon(layer, corners) => polygon(&mut text, layer, corners),
            Circle(layer, [x, y, r]) => {
                let _ = write!(text, "0\nCIRCLE\n8\n{layer}\n10\n{x}\n20\n{y}\n40\n{r}\n");
            }
        }
    }
    text.push_str("0\nENDSEC\n0\nEOF\n");
    text.into_bytes()
}

/// Two squares of 40 mm edge to edge.
const SQUARES: [Shape; 2] =
    [Rectangle("OUT", [10.0, 10.0, 40.0, 40.0]), Rectangle("OUT", [50.0, 10.0, 40.0, 40.0])];
/// A part whose box has a corner outside it.
const ELL: [[f64; 2]; 6] = [[0.0, 0.0], [60.0, 0.0], [60.0, 20.0], [20.0, 20.0], [20.0, 60.0], [0.0, 60.0]];
const IN_FIRST: Shape = Circle("HOLES", [30.0, 30.0, 5.0]);
const IN_SECOND: Shape = Circle("HOLES", [70.0, 30.0, 5.0]);

fn with(holes: &[Shape]) -> Vec<Shape> {
    SQUARES.iter().chain(holes).copied().collect()
}

/// `HOLES` after `OUT` if the order is by layer.
fn layers(by_layer: bool, holes: LayerChoice) -> LoadOptions {
    LoadOptions {
        order_by_layer: by_layer,
        layers: vec![LayerChoice::new("OUT", Operation::Cut), holes],
        ..LoadOptions::default()
    }
}

fn cut() -> LayerChoice {
    LayerChoice::new("HOLES", Operation::Cut)
}

/// The sheet and its plan, which has passed its check.
fn planned(shapes: &[Shape], load: &LoadOptions, machine: &Profile) -> (Sheet, Plan) {
    let mut job = Job::load(drawing(shapes), "shared.dxf", load).unwrap();
    let choice = MachineChoice::Profile(Box::new(machine.clone()));
    job.start(&PlanOptions { machine: choice, allow_off_bed: true, seed: 1, ..PlanOptions::default() })
        .unwrap();
    job.run_mut().unwrap().step(2_000);
    let plan = job.plan().unwrap_or_else(|e| panic!("{}: {e}", machine.name));
    (job.sheet().clone(), plan)
}

/// A machine that cuts every contour by itself, two that make pre-cuts, and one that cuts as one what shares cuts.
fn machines() -> Vec<Profile> {
    let mut common = preset("co2-100w").unwrap();
    common.levers = Levers { common_cuts: Some(SharedCuts::default()), ..Levers::default() };
    let mut all: Vec<Profile> =
        ["co2-100w", "fibre-6kw-plate", "fibre-6kw-thick"].iter().map(|name| preset(name).unwrap()).collect();
    all.push(common);
    all
}

/// The order in which contours are cut.
fn order(plan: &Plan) -> Vec<u32> {
    let contours = |m: &Move| match m {
        Move::Cut { contour, with, .. } => std::iter::once(*contour).chain(with.iter().copied()).collect(),
        _ => Vec::new(),
    };
    plan.moves.iter().flat_map(contours).collect()
}

/// Plans of drawings with holes on a later layer were refused: what is left of the second square did not count as around its hole,
/// and what shares cuts with a square did not come as late as that.
#[test]
fn holes_on_a_later_layer_in_squares_that_share_a_side() {
    for machine in machines() {
        for holes in [&[IN_FIRST, IN_SECOND][..], &[IN_FIRST], &[IN_SECOND]] {
            for by_layer in [false, true] {
                planned(&with(holes), &layers(by_layer, cut()), &machine);
            }
        }
    }
}

#[test]
fn a_later_mark_in_squares_that_share_a_side() {
    for machine in machines() {
        for mark in [IN_FIRST, IN_SECOND] {
            planned(&with(&[mark]), &layers(true, LayerChoice::new("HOLES", Operation::Mark)), &machine);
        }
    }
}

#[test]
fn a_hole_that_comes_last_in_squares_that_share_a_side() {
    for machine in machines() {
        for last in [2, 3] {
            let load = LoadOptions { last: vec![last], ..layers(false, cut()) };
            let (_, plan) = planned(&with(&[IN_FIRST, IN_SECOND]), &load, &machine);
            let order = order(&plan);
            let place = |c: u32| order.iter().position(|&o| o == c).unwrap();
            // The square around it comes after it, and the other hole is free to come before.
            assert!(place(5 - last) < place(last), "{order:?}");
        }
    }
}

#[test]
fn two_passes_over_the_holes_of_squares_that_share_a_side() {
    for machine in machines() {
        let holes = LayerChoice { passes: Some(2), ..cut() };
        let load = LoadOptions { pass_order: PassOrder::Sheet, ..layers(false, holes) };
        planned(&with(&[IN_FIRST, IN_SECOND]), &load, &machine);
    }
}

#[test]
fn small_holes_first_in_parts_that_share_a_side() {
    let shapes = [
        Rectangle("OUT", [0.0, 0.0, 100.0, 100.0]),
        Rectangle("OUT", [20.0, 20.0, 8.0, 8.0]),
        Rectangle("OUT", [28.0, 10.0, 30.0, 30.0]),
    ];
    // Machines that cut as one what shares cuts have no rule for heat.
    for mut machine in machines().into_iter().filter(|m| !m.cuts_as_one()) {
        let small_holes = Some(SmallHoles { thickness: 10.0, ratio: 1.0 });
        machine.levers.heat = Some(Heat { distance: 0.0, seconds: 0.0, charge: None, small_holes });
        planned(&shapes, &LoadOptions::default(), &machine);
    }
}

/// A hole that breaks through an edge lies in no outline, but comes before it whatever its layer: the edge waits for it.
#[test]
fn a_hole_on_a_later_layer_that_breaks_through_an_edge() {
    for machine in machines() {
        let shapes = [Polygon("OUT", &ELL), Circle("HOLES", [20.0, 40.0, 5.0])];
        let (sheet, plan) = planned(&shapes, &layers(true, cut()), &machine);
        assert_eq!(sheet.contours[1].inside, Some(0));
        assert_eq!(order(&plan), [1, 0]);
    }
}

/// What was cut out of the hole of such a part counted as a part, which the head must not cross.
#[test]
fn small_holes_are_crossed_in_parts_that_share_a_side() {
    let mut machine = preset("fibre-6kw-thick").unwrap();
    machine.z_speed = Some(100.0);
    let mut shapes =
        vec![Rectangle("OUT", [10.0, 10.0, 120.0, 60.0]), Rectangle("OUT", [130.0, 10.0, 120.0, 60.0])];
    for x in [150.0, 170.0, 190.0, 210.0] {
        shapes.extend([25.0, 45.0].map(|y| Circle("HOLES", [x, y, 6.0])));
    }
    for risky_moves in [RiskyMoves::Avoid, RiskyMoves::Ignore] {
        let tips = Tips {
            risky_moves,
            nozzle_radius: 3.0,
            margin: 2.0,
            tips_below: 100.0,
            drops_below: Some(1.0),
            cross_over: 20.0,
            ..Tips::default()
        };
        let lift = Some(Lift { height: 10.0, stay_down: 1000.0, at_rest: false });
        machine.levers = Levers { lift, tips: Some(tips), ..Levers::default() };
        planned(&shapes, &LoadOptions::default(), &machine);
    }
}

/// The open rest of an outline encloses what lies in it: nothing said so when its hole came too late.
#[test]
fn a_hole_after_what_is_left_of_the_outline_around_it_is_found() {
    let machine = preset("co2-100w").unwrap();
    let (sheet, plan) = planned(&with(&[IN_FIRST, IN_SECOND]), &layers(false, cut()), &machine);
    let rest = (0..4).find(|&c| sheet.contours[c as usize].rest_of.is_some()).unwrap();
    assert!(!sheet.contours[rest as usize].path.closed);
    let hole = (0..4).find(|&c| sheet.contours[c as usize].inside == Some(rest)).unwrap();
    let [other_square, other_hole] = [1 - rest, 5 - hole];
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));

    let problem = problem_of(&sheet, &machine);
    let in_order = |order: [u32; 4]| {
        let stops = order.map(|c| Stop::at(&problem, problem.items[c as usize].nodes.start)).to_vec();
        let solution = Solution::new(&problem, stops);
        (plan::from_solution(&sheet, &problem, &solution), solution)
    };
    let (good, solution) = in_order([other_hole, other_square, hole, rest]);
    assert_feasible(&problem, &solution);
    assert_eq!(plan::check(&sheet, &machine, &good), Ok(()));
    let (late, _) = in_order([other_hole, other_square, rest, hole]);
    let found = plan::check(&sheet, &machine, &late).unwrap_err();
    assert_eq!(found, [Violation::CutFree { outer: rest, inner: hole }]);
}
