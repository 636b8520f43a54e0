//! A machine that moves each axis by itself leaves the straight line between two places.

use super::{all_tip, tipping};
use crate::testkit::exact::planned;
use crate::testkit::sheets::{Builder, nested_sheet, p, rectangle};
use kerfway::machine::{Profile, Travel};
use kerfway::plan::{self, Move, Plan, Violation, Way};
use kerfway::sheet::{Pin, Sheet};

/// A square that is cut first, and two small ones: the straight move between these passes it 45 mm below, and the head first runs up
/// to its lower side.
fn sheet() -> Sheet {
    let mut b = Builder::new();
    b.cut(rectangle(p(100.0, 106.0), p(60.0, 60.0)), None);
    b.cut(rectangle(p(20.0, 20.0), p(10.0, 10.0)), None);
    b.cut(rectangle(p(320.0, 100.0), p(10.0, 10.0)), None);
    (b.sheet.contours[0].pin, b.sheet.contours[2].pin) = (Pin::First, Pin::Last);
    b.sheet
}

fn machine(travel: Travel) -> Profile {
    Profile { travel, ..tipping(0.5, all_tip()) }
}

fn tipped(sheet: &Sheet, machine: &Profile, plan: &Plan) -> Vec<(usize, u32)> {
    let found = plan::check(sheet, machine, plan).err().unwrap_or_default();
    let of = |v: Violation| {
        if let Violation::Tipped { step, contour, .. } = v { Some((step, contour)) } else { None }
    };
    found.into_iter().filter_map(of).collect()
}

#[test]
fn the_way_that_is_checked_is_the_way_that_is_moved() {
    let sheet = sheet();
    let straight = planned(&sheet, &machine(Travel::Straight));
    assert_eq!(plan::check(&sheet, &machine(Travel::Straight), &straight), Ok(()));
    // The move to the third square is straight for one machine, and passes the first one too near with the other.
    let is_last = |m: &Move| matches!(m, Move::Air { to, way: Way::Plain } if to.x >= 320.0);
    let step = straight.moves.iter().position(is_last).unwrap();
    assert_eq!(tipped(&sheet, &machine(Travel::PerAxis), &straight), [(step, 0)]);
    let per_axis = planned(&sheet, &machine(Travel::PerAxis));
    assert_eq!(plan::check(&sheet, &machine(Travel::PerAxis), &per_axis), Ok(()));
    assert_eq!(
        per_axis.summary.detours + per_axis.summary.lifts,
        straight.summary.detours + straight.summary.lifts + 1
    );
}

#[test]
fn plans_of_machines_that_move_their_axes_apart_pass() {
    for seed in 0..4 {
        let sheet = nested_sheet(25, seed);
        for (accel, speed) in [(None, [300.0, 500.0]), (Some([2000.0, 9000.0]), [900.0, 600.0])] {
            let mut machine = machine(Travel::PerAxis);
            (machine.rapid.accel, machine.rapid.speed) = (accel, speed);
            let plan = planned(&sheet, &machine);
            assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()), "{seed} {accel:?}");
        }
    }
}
