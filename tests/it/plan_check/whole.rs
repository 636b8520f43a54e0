//! Plans that cut every contour without interruption.
#![allow(clippy::unwrap_used, clippy::panic, clippy::type_complexity, reason = "helpers of tests")]

use super::planted::{after, cut_of, path_of, planned, sheet, take_out};
use crate::testkit::sheets::{Builder, circle, machine, p, rectangle};
use kerfway::geometry::{Arc, DVec2, Path, Segment};
use kerfway::machine::presets;
use kerfway::plan::{self, Move, Violation};

#[test]
fn good_plans_pass_on_every_machine() {
    for mut machine in presets() {
        for return_home in [true, false] {
            machine.return_home = return_home;
            assert_eq!(plan::check(&sheet(), &machine, &planned(&sheet(), &machine)), Ok(()));
        }
    }
}

#[test]
fn a_contour_is_missing() {
    assert_eq!(after(|m| drop(take_out(m, 1))), [Violation::Missing { contour: 1 }]);
}

#[test]
fn a_contour_is_cut_twice() {
    let found = after(|m| {
        let again = m[cut_of(m, 5)].clone();
        let at = cut_of(m, 5) + 1;
        m.splice(at..at, [Move::Pierce, again]);
    });
    assert!(matches!(found[..], [Violation::Again { contour: 5, .. }]), "{found:?}");
}

#[test]
fn a_contour_is_not_in_the_sheet() {
    let found = after(|m| {
        let at = cut_of(m, 1);
        if let Move::Cut { contour, .. } = &mut m[at] {
            *contour = 77;
        }
    });
    assert!(matches!(found[..], [Violation::Unknown { contour: 77, .. }, Violation::Missing { contour: 1 }]));
}

#[test]
fn half_a_contour() {
    let found = after(|m| {
        path_of(m, 0).pop();
        let at = cut_of(m, 0);
        // The head goes on from where the cut now ends.
        if !matches!(m.get(at + 1), Some(Move::Air { .. })) {
            m.insert(at + 1, Move::air(DVec2::ZERO));
        }
    });
    assert!(
        matches!(found[..], [Violation::Partly { contour: 0, worked, length, .. }] if worked < length),
        "{found:?}"
    );
}

#[test]
fn a_contour_is_cut_on_another_path() {
    // A corner is cut off, and the summary states the true length.
    let found = after(|m| {
        let path = path_of(m, 0);
        let (a, b) = (path[1].at(0.5), path[2].at(0.5));
        path.splice(1..3, [path[1].piece(0.0, 0.5), Segment::line(a, b), path[2].piece(0.5, 1.0)]);
    });
    assert!(matches!(found[..], [Violation::Strays { contour: 0, .. }]), "{found:?}");
    // One contour's path under another's name.
    let found = after(|m| {
        let (one, two) = (path_of(m, 1).clone(), path_of(m, 6).clone());
        *path_of(m, 1) = two;
        *path_of(m, 6) = one;
    });
    for id in [1, 6] {
        assert!(found.iter().any(|v| matches!(v, Violation::Strays { contour, .. } if *contour == id)));
    }
}

#[test]
fn an_outer_contour_before_its_hole() {
    let found = after(|m| {
        let hole = take_out(m, 1);
        let at = cut_of(m, 0) + 1;
        m.splice(at..at, hole);
    });
    assert!(found.contains(&Violation::CutFree { outer: 0, inner: 1 }), "{found:?}");
    // Over two levels: the part inside the hole after the hole and after the ring.
    let found = after(|m| {
        let inner = take_out(m, 7);
        let at = cut_of(m, 5) + 1;
        m.splice(at..at, inner);
    });
    assert!(found.contains(&Violation::CutFree { outer: 5, inner: 7 }), "{found:?}");
    assert!(found.contains(&Violation::CutFree { outer: 6, inner: 7 }), "{found:?}");
}

#[test]
fn a_mark_after_the_first_cut() {
    let found = after(|m| {
        let at = cut_of(m, 3);
        let mark: Vec<Move> = m.drain(at - 1..=at).collect();
        let at = cut_of(m, 1) + 1;
        m.splice(at..at, mark);
    });
    assert!(found.contains(&Violation::Rank { earlier: 1, later: 3 }), "{found:?}");
}

#[test]
fn layers_in_their_order() {
    let machine = machine("co2-100w");
    let mut sheet = sheet();
    // Cuts by layer before marks: the mark's layer comes last, so the plate waits for it; the ring does not.
    sheet.layers[1].rank = 1;
    let plan = planned(&sheet, &machine);
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
    let order: Vec<usize> = (0..8).map(|id| cut_of(&plan.moves, id)).collect();
    assert!(order[1].max(order[2]).max(order[4]).max(order[5]) < order[3] && order[3] < order[0]);
    sheet.layers.swap(0, 1);
    assert!(plan::check(&sheet, &machine, &plan).is_err());
}

#[test]
fn the_beam_on_where_it_should_not_be() {
    // A jump with the beam on: the air move to a cut is dropped.
    let found = after(|m| {
        let at = cut_of(m, 4);
        m.remove(at - 2);
    });
    assert!(matches!(found[0], Violation::NotJoined { gap, .. } if gap > 1.0), "{found:?}");
    // A gap within a cut.
    let found = after(|m| {
        let path = path_of(m, 0);
        path[1] = Segment::line(path[1].start() + DVec2::new(0.0, 1e-7), path[1].end());
    });
    assert!(matches!(found[0], Violation::NotJoined { gap, .. } if (gap - 1e-7).abs() < 1e-9), "{found:?}");
    let beam = |found: &[Violation], words: &str| {
        assert!(
            found.iter().any(|v| matches!(v, Violation::Beam { what, .. } if *what == words)),
            "{found:?}"
        );
    };
    beam(&after(|m| drop(m.remove(cut_of(m, 2) - 1))), "cuts without piercing");
    beam(&after(|m| m.insert(cut_of(m, 2), Move::Pierce)), "pierces twice");
    beam(&after(|m| m.insert(cut_of(m, 3), Move::Pierce)), "pierces for a mark");
    beam(&after(|m| path_of(m, 2).clear()), "cuts nothing");
    let found = after(|m| {
        let at = cut_of(m, 2);
        m.swap(at - 1, at - 2);
    });
    beam(&found, "moves away from where it pierced");
}

#[test]
fn the_end_is_not_home_or_not_finite() {
    assert!(matches!(after(|m| drop(m.pop()))[..], [Violation::NotHome { left }] if left > 1.0));
    let found = after(|m| m[0] = Move::air(DVec2::NAN));
    assert!(found.contains(&Violation::NotFinite { step: 0 }), "{found:?}");
}

#[test]
fn wrong_totals() {
    let (sheet, machine) = (sheet(), machine("co2-100w"));
    let good = planned(&sheet, &machine);
    let changes: [(&str, fn(&mut plan::Summary)); 12] = [
        ("the number of contours", |s| s.contours += 1),
        ("the number of open contours", |s| s.open_contours = 0),
        ("the number of parts", |s| s.parts += 1),
        ("the number of piercings", |s| s.pierces -= 1),
        ("the length of air moves", |s| s.air_length *= 1.0001),
        ("the length of cuts", |s| s.cut_length -= 0.001),
        ("the time of air moves", |s| s.air_time *= 0.999),
        ("the time of cuts", |s| s.cut_time += 0.001),
        ("the time of piercing", |s| s.pierce_time = f64::NAN),
        ("the total time", |s| s.total_time -= 0.001),
        ("the greatest x", |s| s.bounds[2] += 0.01),
        ("the lower bound", |s| {
            s.lower_bound = s.total_time + 1.0;
            s.gap = Some(-1.0 / s.lower_bound);
        }),
    ];
    for (name, change) in changes {
        let mut plan = good.clone();
        change(&mut plan.summary);
        let found = plan::check(&sheet, &machine, &plan).unwrap_err();
        assert!(matches!(found[0], Violation::Sum { what, .. } if what == name), "{name}: {found:?}");
    }
}

#[test]
fn sound_plans_at_large_coordinates_pass_and_faults_are_found() {
    let mut b = Builder::new();
    let corner = p(6e5, -5.9e5);
    let plate = b.cut(rectangle(corner, p(900.0, 700.0)), None);
    // A lens of two arcs of radius 8e9 mm, a hair inside the plate's edge.
    let (from, to) = (corner + p(0.1, 350.0), corner + p(899.9, 350.0));
    let arc = |a, b| Segment::Arc(Arc::from_bulge(a, b, 5.7e-8).unwrap());
    let lens = b.cut(Path::new(vec![arc(from, to), arc(to, from)], true), Some(plate));
    b.cut(circle(corner + p(30.0, 30.0), 4.0), Some(plate));
    let sheet = b.sheet;
    for machine in presets() {
        let good = planned(&sheet, &machine);
        assert_eq!(plan::check(&sheet, &machine, &good), Ok(()), "{}", machine.name);
        let mut bad = good.clone();
        let hole = take_out(&mut bad.moves, 2);
        let at = cut_of(&bad.moves, plate) + 1;
        bad.moves.splice(at..at, hole);
        bad.summary = plan::evaluate(&bad.moves, &sheet, &machine);
        bad.summary.parts = good.summary.parts;
        let found = plan::check(&sheet, &machine, &bad).unwrap_err();
        assert_eq!(found, [Violation::CutFree { outer: plate, inner: 2 }], "{}", machine.name);
        let mut bad = good;
        path_of(&mut bad.moves, lens).pop();
        let found = plan::check(&sheet, &machine, &bad).unwrap_err();
        assert!(found.iter().any(|v| matches!(v, Violation::Partly { contour, .. } if *contour == lens)));
    }
}
