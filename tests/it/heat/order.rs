//! Small holes come first in thick plate.

use super::{heated, waiting};
use crate::testkit::exact::planned;
use crate::testkit::sheets::{Builder, circle, p, rectangle};
use kerfway::machine::{Heat, SmallHoles};
use kerfway::plan::{self, Move, Violation};
use kerfway::sheet::Sheet;

/// Two plates with holes of 4, 6 and 12 mm, and a mark on the first.
fn plates() -> Sheet {
    let mut b = Builder::new();
    for x in [0.0, 200.0] {
        let plate = b.cut(rectangle(p(20.0 + x, 20.0), p(100.0, 60.0)), None);
        for (k, diameter) in [4.0, 6.0, 12.0].into_iter().enumerate() {
            b.cut(circle(p(40.0 + x + 25.0 * k as f64, 50.0), diameter / 2.0), Some(plate));
        }
        if x == 0.0 {
            b.mark(circle(p(100.0, 30.0), 2.0), Some(plate));
        }
    }
    // Something as small that is no hole.
    b.cut(circle(p(160.0, 50.0), 2.0), None);
    b.sheet
}

#[test]
fn holes_up_to_a_share_of_the_thickness_are_cut_before_all_other_cuts() {
    let sheet = plates();
    let thick =
        |thickness, ratio| Heat { small_holes: Some(SmallHoles { thickness, ratio }), ..waiting(0.0, 0.0) };
    for (thickness, ratio, first) in [
        (3.0, 1.0, vec![]),
        (4.0, 1.0, vec![1, 6]),
        (6.0, 1.0, vec![1, 2, 6, 7]),
        (4.0, 2.9, vec![1, 2, 6, 7]),
    ] {
        let machine = heated(thick(thickness, ratio));
        let plan = planned(&sheet, &machine);
        assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
        let cuts: Vec<u32> = plan
            .moves
            .iter()
            .filter_map(|m| if let Move::Cut { contour, .. } = m { Some(*contour) } else { None })
            .collect();
        assert_eq!(cuts[0], 4, "the mark comes before all cuts");
        let mut begin = cuts[1..=first.len()].to_vec();
        begin.sort_unstable();
        assert_eq!(begin, first, "{thickness} {ratio}: {cuts:?}");
        // A plan that does not know of them breaks the rule where there are some.
        let plain = planned(&sheet, &heated(waiting(0.0, 0.0)));
        let faults = plan::check(&sheet, &machine, &plain).err().unwrap_or_default();
        assert_eq!(faults.is_empty(), first.is_empty(), "{faults:?}");
        assert!(faults.iter().all(|v| matches!(v, Violation::Rank { .. })));
    }
}
