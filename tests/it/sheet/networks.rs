//! Parts from networks of lines: the same parts, whatever kind of entity draws them.

use super::sketch::*;
use kerfway::finding::Code;
use kerfway::geometry::Path;
use kerfway::sheet::Sheet;

/// Areas of the contours that bound an area, sorted.
fn areas(s: &Sheet) -> Vec<f64> {
    let mut areas: Vec<f64> = s.contours.iter().filter(|c| c.bounds_area()).map(|c| c.area).collect();
    areas.sort_by(f64::total_cmp);
    areas
}

fn lines(outlines: &[Path]) -> Vec<Path> {
    outlines.iter().flat_map(exploded).collect()
}

#[track_caller]
fn has_areas(s: &Sheet, wanted: &[f64]) {
    let found = areas(s);
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (a, b) in found.iter().zip(wanted) {
        close(*a, *b);
    }
}

/// Of the issue: drawn as LINEs they were one part with three holes and two open dividers.
#[test]
fn three_squares_with_coincident_sides() {
    let squares = [rect(0.0, 0.0, 10.0, 10.0), rect(10.0, 0.0, 10.0, 10.0), rect(20.0, 0.0, 10.0, 10.0)];
    let holes = [5.0, 15.0, 25.0].map(|x| circle(x, 5.0, 2.0));
    let mut backwards = lines(&squares);
    backwards.reverse();
    let once = [
        line(0.0, 0.0, 30.0, 0.0),
        line(0.0, 10.0, 30.0, 10.0),
        line(0.0, 0.0, 0.0, 10.0),
        line(10.0, 10.0, 10.0, 0.0),
        line(20.0, 0.0, 20.0, 10.0),
        line(30.0, 0.0, 30.0, 10.0),
    ];
    for drawn in [squares.to_vec(), lines(&squares), backwards, once.to_vec()] {
        let s = sheet(drawn.into_iter().chain(holes.clone()));
        assert_eq!((s.parts.len(), s.groups.len()), (3, 1));
        assert!(s.parts.iter().all(|p| p.holes.len() == 1), "each has its hole");
        close(s.parts.iter().map(|p| s.contours[p.outer as usize].area).sum(), 300.0);
        close(total_length(&s), 100.0 + 3.0 * 4.0 * std::f64::consts::PI);
        assert!(findings(&s, Code::OpenContour).is_empty() && findings(&s, Code::Branch).is_empty());
    }
}

#[test]
fn a_frame_with_dividers() {
    let dividers = [line(10.0, 0.0, 10.0, 20.0), line(20.0, 0.0, 20.0, 20.0), line(0.0, 10.0, 30.0, 10.0)];
    for frame in [vec![rect(0.0, 0.0, 30.0, 20.0)], exploded(&rect(0.0, 0.0, 30.0, 20.0))] {
        let s = sheet(frame.iter().cloned().chain(dividers.clone()).chain([circle(5.0, 5.0, 2.0)]));
        assert_eq!(s.parts.len(), 6);
        let with_hole: Vec<_> = s
            .parts
            .iter()
            .filter(|p| s.contours[p.outer as usize].bounds.contains(kerfway::geometry::DVec2::new(5.0, 5.0)))
            .collect();
        assert_eq!((with_hole.len(), with_hole[0].holes.len()), (1, 1), "the hole keeps its parent");
        close(total_length(&s), 100.0 + 70.0 + 4.0 * std::f64::consts::PI);
        assert!(findings(&s, Code::OpenContour).is_empty());
    }
}

#[test]
fn a_ring_that_shares_an_arc_with_its_neighbour() {
    let neighbour = [
        line(10.0, 0.0, 30.0, 0.0),
        line(30.0, 0.0, 30.0, 20.0),
        line(30.0, 20.0, 0.0, 20.0),
        line(0.0, 20.0, 0.0, 10.0),
    ];
    let disc = 100.0 * std::f64::consts::PI;
    for ring in [
        vec![circle(0.0, 0.0, 10.0)],
        vec![arc(0.0, 0.0, 10.0, 0.0, 180.0), arc(0.0, 0.0, 10.0, 180.0, 180.0)],
    ] {
        let s = sheet(ring.into_iter().chain([circle(0.0, 0.0, 5.0)]).chain(neighbour.clone()));
        has_areas(&s, &[disc / 4.0, disc, 600.0 - disc / 4.0]);
        assert_eq!((s.parts.len(), s.parts[0].holes.len()), (2, 1), "the ring has its hole");
        assert_eq!(s.groups.len(), 1);
    }
}

#[test]
fn shared_parts_of_sides() {
    let bricks = [
        rect(0.0, 0.0, 20.0, 10.0),
        rect(20.0, 0.0, 20.0, 10.0),
        rect(10.0, 10.0, 20.0, 10.0),
        rect(20.0, 20.0, 9.0, 10.0),
    ];
    for drawn in [bricks.to_vec(), lines(&bricks)] {
        let s = sheet(drawn);
        has_areas(&s, &[90.0, 200.0, 200.0, 200.0]);
        assert_eq!((s.parts.len(), s.groups.len()), (4, 1));
        close(total_length(&s), 60.0 * 3.0 + 38.0 - 10.0 - 20.0 - 9.0);
    }
}

#[test]
fn t_junctions_with_small_gaps() {
    // The divider stops 0.03 mm short of the one side and 0.03 mm beyond the other.
    let mut drawn = exploded(&rect(0.0, 0.0, 30.0, 20.0));
    drawn.push(line(10.0, 0.03, 10.0, 20.03));
    let s = sheet(drawn);
    let found = areas(&s);
    assert_eq!((s.parts.len(), found.len()), (2, 2));
    assert!((found[0] - 200.0).abs() < 1.0 && (found[1] - 400.0).abs() < 1.0, "{found:?}");
}

#[test]
fn a_line_that_is_open_inside_a_part_stays_open() {
    let inside = [line(5.0, 0.0, 5.0, 5.0), line(2.0, 2.0, 4.0, 4.0)];
    for square in [vec![rect(0.0, 0.0, 10.0, 10.0)], exploded(&rect(0.0, 0.0, 10.0, 10.0))] {
        let s = sheet(square.into_iter().chain(inside.clone()));
        assert_eq!((s.parts.len(), counts(&s)), (1, (1, 2)));
        assert_eq!(findings(&s, Code::OpenContour).len(), 2);
        close(s.contours[s.parts[0].outer as usize].area, 100.0);
    }
}

/// The middle of nine squares shares all its sides. Drawn last it vanished, and its part with it.
#[test]
fn a_part_that_shares_all_its_sides_is_kept() {
    let square = |k: u8| rect(f64::from(k % 3) * 10.0, f64::from(k / 3) * 10.0, 10.0, 10.0);
    let squares: Vec<Path> = [0, 1, 2, 3, 5, 6, 7, 8, 4, 4].map(square).to_vec();
    for drawn in [squares.clone(), lines(&squares)] {
        let s = sheet(drawn);
        has_areas(&s, &[100.0; 9]);
        assert_eq!((s.parts.len(), s.groups.len()), (9, 1));
        close(total_length(&s), 240.0);
    }
}

#[test]
fn a_shape_flush_in_the_corner_of_another_one_is_a_part_beside_the_rest() {
    let both = [rect(0.0, 0.0, 30.0, 30.0), rect(0.0, 0.0, 10.0, 10.0)];
    for drawn in [both.to_vec(), lines(&both)] {
        let s = sheet(drawn);
        has_areas(&s, &[100.0, 800.0]);
        assert_eq!(s.parts.len(), 2);
        close(total_length(&s), 140.0);
    }
}

#[test]
fn squares_that_touch_in_a_corner_are_two() {
    let both = [rect(0.0, 0.0, 10.0, 10.0), rect(10.0, 10.0, 10.0, 10.0)];
    for drawn in [both.to_vec(), lines(&both)] {
        let s = sheet(drawn);
        assert_eq!((counts(&s), s.parts.len()), ((2, 0), 2));
        assert!(findings(&s, Code::Branch).is_empty());
    }
}

/// Rails that interlock as drawn (Opentrons 1011) overlap where teeth cross: each outline stays one part.
#[test]
fn outlines_of_lines_that_share_sides_and_cross_stay_as_drawn() {
    let both = [
        rect(0.0, 0.0, 30.0, 10.0),
        polyline(
            &[
                (5.0, 10.0),
                (5.0, 30.0),
                (25.0, 30.0),
                (25.0, 10.0),
                (16.0, 10.0),
                (16.0, 8.0),
                (14.0, 8.0),
                (14.0, 10.0),
            ],
            true,
        ),
    ];
    let [of_polylines, of_lines] = [both.to_vec(), lines(&both)].map(sheet);
    assert_eq!(areas(&of_polylines), areas(&of_lines));
    assert_eq!(of_lines.parts.len(), of_polylines.parts.len());
}

/// A grid of this many lines each way.
fn grid(count: u32) -> Vec<Path> {
    let size = f64::from(count - 1);
    let lines = (0..count).map(f64::from).flat_map(|at| [line(0.0, at, size, at), line(at, 0.0, at, size)]);
    lines.collect()
}

/// More than 50,000 crossings were not searched: 500 open lines, each said to free no part.
#[test]
fn a_grid_of_250_lines_each_way_is_all_parts() {
    let s = sheet(grid(250));
    assert_eq!((s.parts.len(), s.groups.len()), (249 * 249, 1));
    close(s.parts.iter().map(|p| s.contours[p.outer as usize].area).sum(), 249.0 * 249.0);
    assert!((total_length(&s) - 500.0 * 249.0).abs() < 1e-3, "every line is cut once");
    assert!(s.findings.is_empty(), "{:?}", s.findings);
}

#[test]
fn a_network_too_dense_to_search_is_reported_and_stays_as_drawn() {
    let s = sheet(grid(330));
    assert_eq!(counts(&s), (1, 656), "the four lines around the others close");
    let told = findings(&s, Code::NotAllChecked);
    let told = told.into_iter().find(|f| f.message.contains("enclose together")).unwrap();
    assert!(
        told.message.starts_with("More than 100000 pairs of lines lie over each other"),
        "{}",
        told.message
    );
    let at = told.at.unwrap();
    assert_eq!(told.severity, kerfway::finding::Severity::Warning);
    assert!((at - at.round()).abs().min_element() < 1e-6, "{at} is on a line");
    assert!((0.0..=329.0).contains(&at.x) && (0.0..=329.0).contains(&at.y), "{at}");
    assert!(findings(&s, Code::OpenContour).is_empty(), "whether they free parts is not known");
}

#[test]
fn a_closed_polyline_a_few_micrometres_wide_is_cut_once() {
    let sliver = [rect(100.0, 0.0, 50.0, 0.004), rect(0.0, 0.0, 20.0, 20.0)];
    for drawn in [sliver.to_vec(), lines(&sliver)] {
        let s = sheet(drawn);
        assert_eq!((counts(&s), s.parts.len()), ((1, 1), 1));
        assert!((total_length(&s) - 130.0).abs() < 0.01, "{}", total_length(&s));
    }
    let s = sheet(sliver);
    let told = findings(&s, Code::SliverCollapsed);
    assert_eq!((told.len(), told[0].handle.as_deref(), told[0].at), (1, Some("100"), Some(p(100.0, 0.0))));
}

/// Items in an order that depends on a seed.
fn shuffled<T>(mut items: Vec<T>, seed: u64) -> Vec<T> {
    let mut state = seed;
    for k in (1..items.len()).rev() {
        state = state.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(0x1405_7B7E_F767_814F);
        items.swap(k, usize::try_from(state >> 33).unwrap() % (k + 1));
    }
    items
}

/// Whatever a tile has left when its neighbours are drawn first, it is not taken for a neighbour of the same size.
#[test]
fn equal_tiles_in_any_order_are_all_parts_with_their_holes() {
    let squares: Vec<(Path, (f64, f64))> = (0..64)
        .map(|k| (10.0 * f64::from(k % 8), 10.0 * f64::from(k / 8)))
        .map(|(x, y)| (rect(x, y, 10.0, 10.0), (x + 5.0, y + 5.0)))
        .collect();
    let triangles: Vec<(Path, (f64, f64))> = (0..30)
        .map(|k| (12.0 * f64::from(k % 6), 12.0 * f64::from(k / 6)))
        .flat_map(|(x, y)| {
            let (a, b, c, d) = ((x, y), (x + 12.0, y), (x + 12.0, y + 12.0), (x, y + 12.0));
            [
                (polyline(&[a, b, c], true), (x + 8.0, y + 4.0)),
                (polyline(&[a, c, d], true), (x + 4.0, y + 8.0)),
            ]
        })
        .collect();
    let half = 5.0 * 3_f64.sqrt() / 2.0;
    let hexagons: Vec<(Path, (f64, f64))> = (0..64)
        .map(|k| (k % 8, k / 8))
        .map(|(i, j)| (half * f64::from(2 * i + j % 2), 7.5 * f64::from(j)))
        .map(|(x, y)| {
            let corners = [(0.0, -5.0), (half, -2.5), (half, 2.5), (0.0, 5.0), (-half, 2.5), (-half, -2.5)];
            (polyline(&corners.map(|(a, b)| (x + a, y + b)), true), (x, y))
        })
        .collect();
    for (name, tiles) in [("squares", squares), ("triangles", triangles), ("hexagons", hexagons)] {
        let area = tiles[0].0.area().abs();
        let holes: Vec<Path> = tiles.iter().map(|(_, (x, y))| circle(*x, *y, 1.0)).collect();
        let outlines: Vec<Path> = tiles.iter().map(|(outline, _)| outline.clone()).collect();
        for seed in 0..12 {
            let s = sheet(shuffled(outlines.clone(), seed).into_iter().chain(holes.clone()));
            assert_eq!(s.parts.len(), tiles.len(), "{name}, seed {seed}");
            assert!(s.parts.iter().all(|p| p.holes.len() == 1), "{name}, seed {seed}");
            for part in &s.parts {
                let own = s.contours[part.outer as usize].area;
                assert!((own - area).abs() < 1e-6, "{name}, seed {seed}: {own} is not {area}");
            }
        }
    }
}

/// The squares lie around the last one. What is left of one of them borders a neighbour of the same size.
#[test]
fn a_square_with_one_side_left_is_a_part() {
    let corners = [(70, 60), (60, 50), (50, 60), (60, 60), (50, 70), (70, 70), (60, 80), (60, 70)];
    let squares = corners.map(|(x, y)| rect(f64::from(x), f64::from(y), 10.0, 10.0));
    has_areas(&sheet(squares), &[100.0; 8]);
}
