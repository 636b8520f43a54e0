//! What the checker says of moves past parts that were cut off at their bridges, and of bridges that are cut where nothing holds.

use super::tipping::{across, row, tipping};
use super::{p, planned, rectangle, with};
use kerfway::geometry::DVec2;
use kerfway::job::problem_of;
use kerfway::machine::Profile;
use kerfway::plan::{self, Move, Plan, Violation, Way};
use kerfway::sheet::Sheet;
use kerfway::solve::{Solution, Stop};
use serde_json::json;

/// The plate (0) with a square (1) at a bridge, a square above the plate (2), and one to the right (3), which both stay: the move from the third contour
/// to the fourth runs over the second.
struct Case {
    sheet: Sheet,
    machine: Profile,
    /// The cuts through the bridge: at the square, and at the plate.
    cuts: [u32; 2],
}

fn case(machine: Profile) -> Case {
    let mut drawing = row(1);
    drawing.extend([rectangle(p(10.0, 90.0), p(42.0, 42.0)), rectangle(p(150.0, -25.0), p(42.0, 42.0))]);
    let sheet = planned(&drawing, machine.clone()).beam_sheet().clone();
    let id = |ends: [u32; 2]| across(&sheet).iter().find(|cut| cut.1 == ends).unwrap().0;
    let cuts = [id([1, 0]), id([0, 1])];
    Case { sheet, machine, cuts }
}

impl Case {
    /// The plan with the contours in this order. The two squares are entered at their corners towards each other.
    fn plan(&self, order: &[u32]) -> Plan {
        let problem = problem_of(&self.sheet, &self.machine);
        let towards = |item: u32| match item {
            2 => p(52.0, 90.0),
            3 => p(150.0, 17.0),
            _ => p(0.0, 0.0),
        };
        let nearest = |item: &u32| {
            let off = |n: &u32| problem.nodes[*n as usize].entry.distance(towards(*item));
            let node = problem.items[*item as usize].nodes.clone().min_by(|a, b| off(a).total_cmp(&off(b)));
            Stop::at(&problem, node.unwrap())
        };
        plan::from_solution(
            &self.sheet,
            &problem,
            &Solution::new(&problem, order.iter().map(nearest).collect()),
        )
    }

    /// The violations other than sums.
    fn found(&self, plan: &Plan) -> Vec<Violation> {
        let all = plan::check(&self.sheet, &self.machine, plan).err().unwrap_or_default();
        all.into_iter().filter(|v| !matches!(v, Violation::Sum { .. })).collect()
    }
}

/// The move from the square above to the one on the right.
fn over(plan: &Plan) -> usize {
    let mut head = DVec2::ZERO;
    let from_to = |m: &Move| {
        let from = head;
        head = m.end().unwrap_or(head);
        matches!(m, Move::Air { to, .. } if from == p(52.0, 90.0) && *to == p(150.0, 17.0))
    };
    plan.moves.iter().position(from_to).unwrap()
}

#[test]
fn a_move_over_a_part_is_wrong_after_its_bridge_is_cut_and_not_before() {
    let case = case(tipping(0.01));
    let [square, plate] = case.cuts;
    let before = case.plan(&[0, 2, 3, square, plate]);
    assert_eq!(case.found(&before), []);
    let at = over(&before);
    assert_eq!(before.moves[at], Move::air(p(150.0, 17.0)));
    for order in [[0, square, 2, 3, plate], [0, square, plate, 2, 3]] {
        let mut after = case.plan(&order);
        assert_eq!(case.found(&after), []);
        let at = over(&after);
        assert!(matches!(after.moves[at], Move::Air { way: Way::Lifted, .. }));
        after.moves[at] = Move::air(p(150.0, 17.0));
        let found = case.found(&after);
        assert!(
            matches!(found[..], [Violation::Tipped { step, contour: 1, what: "is down over a piece that may have tipped", .. }] if step == at),
            "{found:?}"
        );
    }
}

#[test]
fn crossings_are_marked_after_the_bridge_is_cut_and_not_before() {
    let ignore = json!({ "levers": { "lift": null, "tips": { "risky_moves": "ignore" } } });
    let case = case(with(&tipping(0.01), &ignore));
    let [square, plate] = case.cuts;
    for (order, way) in [([0, 2, 3, square, plate], Way::Plain), ([0, square, plate, 2, 3], Way::Crosses)] {
        let mut plan = case.plan(&order);
        assert_eq!(case.found(&plan), []);
        let at = over(&plan);
        let to = p(150.0, 17.0);
        assert_eq!(plan.moves[at], Move::Air { to, way });
        let other = if way == Way::Plain { Way::Crosses } else { Way::Plain };
        plan.moves[at] = Move::Air { to, way: other };
        let found = case.found(&plan);
        assert!(matches!(found[..], [Violation::Tipped { step, .. }] if step == at), "{found:?}");
    }
}

#[test]
fn bridges_of_what_may_have_tipped_are_not_cut() {
    let case = case(tipping(0.01));
    let [square, plate] = case.cuts;
    let what = "cuts through a bridge of what may have dropped or tipped";
    let wrong = |case: &Case, plan: &Plan| -> Vec<u32> {
        let found = case.found(plan);
        let own = |v: &Violation| match v {
            Violation::Tipped { contour, what: said, .. } if *said == what => Some(*contour),
            _ => None,
        };
        assert!(found.iter().all(|v| own(v).is_some()), "{found:?}");
        found.iter().filter_map(own).collect()
    };
    // At the plate first: the square has come off with the strip when its own end is cut.
    assert_eq!(wrong(&case, &case.plan(&[0, plate, square, 2, 3])), [1]);
    assert_eq!(wrong(&case, &case.plan(&[0, square, plate, 2, 3])), [0; 0]);
    // If the plate does not stay either, neither may be cut.
    let tips = json!({ "levers": { "tips": { "tips_below": 61.0, "nozzle_radius": 0.0, "margin": 0.0 } } });
    let plan = case.plan(&[2, 3, 0, square, plate]);
    let small = Case { machine: with(&case.machine, &tips), ..case };
    let found: Vec<Violation> = small
        .found(&plan)
        .into_iter()
        .filter(|v| matches!(v, Violation::Tipped { what: said, .. } if *said == what))
        .collect();
    assert_eq!(found.len(), 2, "{found:?}");
}
