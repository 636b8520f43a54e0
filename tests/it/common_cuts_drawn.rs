//! Pieces of drawings found in public repositories, whose groups of contours were planned wrongly or refused by the check.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::testkit::dxf_text::document;
use crate::testkit::plates::{thick, together};
use kerfway::geometry::DVec2;
use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::Profile;
use kerfway::plan::{Move, Plan};
use kerfway::sheet::CommonCuts;

fn line([a, b]: [[f64; 2]; 2]) -> String {
    format!("0\nLINE\n8\n0\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", a[0], a[1], b[0], b[1])
}

fn outline(corners: &[[f64; 2]]) -> String {
    let vertices = corners.iter().map(|[x, y]| format!("10\n{x}\n20\n{y}\n"));
    format!("0\nLWPOLYLINE\n8\n0\n90\n{}\n70\n1\n", corners.len()) + &vertices.collect::<String>()
}

fn circle([x, y]: [f64; 2], radius: f64) -> String {
    format!("0\nCIRCLE\n8\n0\n10\n{x}\n20\n{y}\n40\n{radius}\n")
}

/// A drawing in the file's unit, which is millimetres (4) or inches (1).
fn load(unit: u32, entities: &str) -> Job {
    let options = LoadOptions { common_cuts: CommonCuts::Best, ..LoadOptions::default() };
    Job::load(document(unit, "", entities).into_bytes(), "drawn.dxf", &options).unwrap()
}

/// A plan that passes its check, on a machine that leaves contours unfinished and on one that does not. Its program is written.
fn plans(entities: &str) -> [Plan; 2] {
    planned(|| load(4, entities))
}

fn planned(load: impl Fn() -> Job) -> [Plan; 2] {
    [thick(), together()].map(|machine: Profile| {
        let mut job = load();
        let machine = MachineChoice::Profile(Box::new(machine));
        job.start(&PlanOptions { machine, allow_off_bed: true, seed: 1, ..PlanOptions::default() }).unwrap();
        job.run_mut().unwrap().step(3_000);
        job.output(OutputKind::Gcode).unwrap();
        job.plan().unwrap()
    })
}

/// Both of its ends were one node of the group, and nothing between them was cut.
#[test]
fn an_open_cut_shorter_than_the_joining_tolerance_is_cut() {
    let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
    let square: String = (0..4).map(|k| line([corners[k], corners[(k + 1) % 4]])).collect();
    let [start, end] = [[10.0, 5.0], [10.0056, 5.0001]];
    for plan in plans(&(square + &line([start, end]))) {
        let cuts = plan.moves.iter().filter_map(|m| match m {
            Move::Cut { path, .. } => Some(path),
            _ => None,
        });
        let stub = DVec2::from(end);
        let reaches = |at: DVec2| at.distance(stub) < 1e-9;
        assert!(cuts.flatten().any(|s| reaches(s.start()) || reaches(s.end())));
    }
}

/// The ends of two chords lie a millionth of a millimetre beside the circle, so the arcs between them are longer on the way back.
#[test]
fn chords_that_end_a_hair_beside_their_circle_are_followed() {
    let center = [161.458_295_966_950_9, 131.788_174_786_933_7];
    let chords = [
        [[155.269_516_619_572, 132.114_352_066_933_7], [167.647_073_864_653_3, 132.114_352_066_933_7]],
        [[155.696_855_970_867_7, 129.504_933_826_933_6], [167.219_734_513_357_5, 129.504_933_826_933_6]],
    ];
    let drawn = circle(center, 6.197_368_32) + &chords.map(line).concat();
    for plan in plans(&drawn) {
        assert_eq!(plan.summary.contours, 3);
    }
}

/// A line that lies along a bend of another: each is cut in one go, and the second one begins in the kerf of the first.
#[test]
fn a_contour_that_begins_in_the_kerf_of_another_needs_no_piercing() {
    let bent = [[84.968_43, 13.856_257], [83.488_128, 18.716_265], [76.229_416, 43.084_302]];
    let straight = line([[81.819_025, 24.311_273], [84.810_33, 14.374_258]]);
    let [_, plan] = plans(&(line([bent[0], bent[1]]) + &line([bent[1], bent[2]]) + &straight));
    assert_eq!((plan.summary.contours, plan.summary.pierces), (2, 1));
}

/// Lines that cross make two parts side by side, of which one keeps the upper half of its outline. A line in its lower half touches a line
/// outside: they were a group, and the part was cut out before the line in it.
#[test]
fn a_line_that_ends_on_the_side_of_an_outline_that_a_neighbour_cuts_is_in_no_group() {
    let crossing = [
        [[274.0, -110.0], [24.0, -110.0]],
        [[244.0, 0.0], [244.0, -130.0]],
        [[189.0, 0.0], [189.0, -130.0]],
        [[199.0, -112.0], [174.0, -112.0]],
        [[199.0, -112.0], [199.0, -100.0]],
        [[174.0, -75.0], [199.0, -75.0]],
        [[274.0, -50.0], [24.0, -50.0]],
    ];
    let triangle = |x: f64| outline(&[[x, -90.0], [x + 20.0, -90.0], [x, -87.0]]);
    let drawn = crossing.map(line).concat() + &triangle(189.0) + &triangle(244.0);
    assert!(load(4, &drawn).sheet().groups.is_empty());
    for plan in plans(&drawn) {
        assert_eq!(plan.summary.contours, 12);
    }
}

/// Of six contours that touch, each is cut by itself: the circle as it was drawn, not through the end of a line 9 nm beside it.
#[test]
fn a_circle_that_a_line_ends_beside_is_as_large_as_drawn() {
    let lines = [
        [[4.977_520_694_2, 4.432_520_881_42], [5.477_520_694_2, 3.566_494_881_42]],
        [[0.897_393_694_198, 1.499_507_881_42], [5.897_393_694_2, 1.499_507_881_42]],
        [[0.897_393_694_198, 1.499_507_881_42], [3.397_393_694_2, 5.829_634_881_42]],
        [[0.897_393_694_198, 1.499_507_881_42], [5.227_520_694_2, 3.999_507_881_42]],
        [[2.964_381_694_2, 6.079_634_881_42], [3.830_406_694_2, 5.579_634_881_42]],
        [[5.897_393_694_2, 1.999_507_881_42], [5.897_393_694_2, 0.999_507_881_422]],
    ];
    let center = [0.031_368_694_197_8, 0.999_507_881_422];
    let drawn = lines.map(line).concat() + &circle(center, 1.0);
    for plan in planned(|| load(1, &drawn)) {
        assert!(
            (plan.summary.bounds[0] - 25.4 * (center[0] - 1.0)).abs() < 1e-4,
            "{:?}",
            plan.summary.bounds
        );
    }
}

/// Directions at a node were taken at a share of the length of each element: an arc that leaves a circle along its tangent came on
/// the wrong side of it, so the group had wrong areas, and nothing of it was between two parts.
#[test]
fn an_arc_that_leaves_a_circle_along_its_tangent_is_in_order_at_the_node() {
    let arc = "0\nLWPOLYLINE\n8\n0\n90\n3\n70\n0\n10\n0\n20\n0\n42\n0.414213562373095\n10\n10\n20\n10\n10\n10\n20\n98.98979485566356\n";
    let chord = [[9.396_926_207_859, 6.579_798_566_743], [-50.0, 50.0]];
    let drawn = circle([0.0, 50.0], 50.0) + arc + &line(chord);
    let job = load(4, &drawn);
    let [group] = &job.sheet().groups[..] else { panic!("{} groups", job.sheet().groups.len()) };
    let shared: f64 = group.between_parts().map(|e| group.path(e).length()).sum();
    assert!(shared > 100.0, "{shared} mm are between two parts");
    let lines = std::f64::consts::PI * (100.0 + 5.0) + 88.9898 + 73.5747;
    assert!(plans(&drawn).iter().all(|plan| (plan.summary.cut_length - lines).abs() < 0.01));
}
