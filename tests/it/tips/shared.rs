//! Pieces that share sides with others: they are free once these have cut the sides, too.

use super::{all_tip, tipping};
use crate::testkit::plates;
use kerfway::job::problem_of;
use kerfway::plan::{self, Move, Plan, Violation, Way};
use kerfway::problem::Problem;
use kerfway::sheet::{CommonCuts, Sheet};
use kerfway::solve::{Solution, Stop};

/// The contour that holds the middle of a square at a height of 70 mm, by its outline.
fn around(sheet: &Sheet, x: f64) -> u32 {
    let holds = |(_, c): &(u32, &kerfway::sheet::Contour)| {
        let bounds = c.boundary().unwrap().bounds();
        bounds.min.x < x && x < bounds.max.x
    };
    (0..).zip(&sheet.contours).find(holds).unwrap().0
}

/// The contours cut in this order, each from its first node.
fn in_order(sheet: &Sheet, problem: &Problem, order: [u32; 4]) -> Plan {
    let stops = order.map(|c| Stop::at(problem, problem.items[c as usize].nodes.start)).to_vec();
    plan::from_solution(sheet, problem, &Solution::new(problem, stops))
}

/// The index of the move after the cut of a contour.
fn after(plan: &Plan, contour: u32) -> usize {
    let cuts = |m: &Move| matches!(m, Move::Cut { contour: c, .. } if *c == contour);
    let cut = plan.moves.iter().rposition(cuts).unwrap();
    cut + plan.moves[cut..].iter().position(|m| matches!(m, Move::Air { .. })).unwrap()
}

/// What was left of an outline counted as all of it, although the neighbour had not cut the side that both share yet.
#[test]
fn a_piece_is_free_once_its_neighbour_has_cut_the_side_they_share() {
    // Two squares of 60 mm side by side, and one of 20 mm on either side of them, to which moves lead over one of the first two.
    let outlines = [[100.0, 40.0, 60.0], [160.0, 40.0, 60.0], [40.0, 60.0, 20.0], [260.0, 60.0, 20.0]];
    let outlines = outlines.map(|[x, y, side]| plates::rectangle([x, y, side, side]));
    let sheet = plates::job(&outlines, CommonCuts::Off, plates::thick(), None).sheet().clone();
    let [left, right, before, behind] = [130.0, 190.0, 50.0, 270.0].map(|x| around(&sheet, x));
    let left_is_rest = sheet.contours[left as usize].rest_of.is_some();
    let [rest, whole] = if left_is_rest { [left, right] } else { [right, left] };
    let [near, far] = if left_is_rest { [before, behind] } else { [behind, before] };
    assert!(sheet.contours[rest as usize].rest_of.is_some() && sheet.contours[whole as usize].path.closed);

    // Lifting is quicker than any way around.
    let machine = tipping(0.02, all_tip());
    let problem = problem_of(&sheet, &machine);
    let pieces = problem.zones.as_ref().unwrap().pieces();
    assert_eq!(pieces.len(), 4);
    assert!(pieces.iter().any(|p| p.cut_by == [rest, whole]) && pieces.iter().any(|p| p.cut_by == [whole]));

    // Its neighbour still holds it: the head may stay down over it.
    let plan = in_order(&sheet, &problem, [rest, near, far, whole]);
    assert!(matches!(plan.moves[after(&plan, rest)], Move::Air { way: Way::Plain, .. }));
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
    // Its neighbour has been cut: the head may not.
    let plan = in_order(&sheet, &problem, [whole, rest, near, far]);
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
    let mut down = plan.clone();
    let risky = after(&down, rest);
    assert!(matches!(down.moves[risky], Move::Air { way: Way::Lifted, .. }), "{:?}", down.moves[risky]);
    down.moves[risky] = Move::air(down.moves[risky].end().unwrap());
    let found = plan::check(&sheet, &machine, &down).unwrap_err();
    assert!(
        found.iter().any(|v| matches!(v, Violation::Tipped { contour, .. } if *contour == rest)),
        "{found:?}"
    );
}
