//! Metamorphic tests over the whole intake, on the text of drawings: however a drawing is moved, turned, mirrored,
//! scaled, shuffled, reversed, taken apart or wrapped in blocks, it has the same contours and parts.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and tells what it did"
)]

use crate::testkit::dxf_text::{Entity, Scene, Similarity};
use crate::testkit::rng::{Rng, seeded};
use kerfway::drawing::ReadOptions;
use kerfway::dxf;
use kerfway::geometry::{DVec2, math};
use kerfway::sheet::{self, SheetOptions};
use rand::RngExt;
use rand::seq::SliceRandom;
use std::f64::consts::TAU;

/// What must not change, in mm and mm2, sorted.
#[derive(Debug)]
struct Census {
    contours: Vec<ContourRow>,
    parts: Vec<PartRow>,
}

#[derive(Debug, Clone, PartialEq)]
struct ContourRow {
    closed: bool,
    depth: u32,
    /// Length of the contour around it.
    inside: f64,
    length: f64,
    area: f64,
}

#[derive(Debug, Clone, PartialEq)]
struct PartRow {
    outer: f64,
    holes: Vec<f64>,
    inside: f64,
}

fn census(text: &str) -> Census {
    let drawing = dxf::read(text.as_bytes(), &ReadOptions::default()).unwrap();
    let sheet = sheet::build(&drawing, &SheetOptions::default());
    let length = |id: Option<u32>| id.map_or(0.0, |i| sheet.contours[i as usize].length);
    let mut contours: Vec<ContourRow> = sheet
        .contours
        .iter()
        .map(|c| ContourRow {
            closed: c.path.closed,
            depth: c.depth,
            inside: length(c.inside),
            length: c.length,
            area: c.area,
        })
        .collect();
    contours.sort_by(|a, b| a.length.total_cmp(&b.length));
    let mut parts: Vec<PartRow> = sheet
        .parts
        .iter()
        .map(|p| {
            let mut holes: Vec<f64> = p.holes.iter().map(|&h| length(Some(h))).collect();
            holes.sort_by(f64::total_cmp);
            let inside = p.inside.map(|i| sheet.parts[i as usize].outer);
            PartRow { outer: length(Some(p.outer)), holes, inside: length(inside) }
        })
        .collect();
    parts.sort_by(|a, b| a.outer.total_cmp(&b.outer));
    Census { contours, parts }
}

/// Lengths may differ by what two biarc fits within 0.005 mm of one curve differ.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 0.02 + 1e-4 * b.abs()
}

/// Asserts that `changed` is `base` scaled by `scale`.
fn assert_same(base: &Census, changed: &Census, scale: f64, what: &str) {
    assert_eq!(changed.contours.len(), base.contours.len(), "{what}: contours");
    assert_eq!(changed.parts.len(), base.parts.len(), "{what}: parts");
    for (c, b) in changed.contours.iter().zip(&base.contours) {
        let area_tolerance = 0.01 * (b.length * scale + 1.0);
        let ok = c.closed == b.closed
            && c.depth == b.depth
            && same(c.inside, b.inside * scale)
            && same(c.length, b.length * scale)
            && (c.area - b.area * scale * scale).abs() <= area_tolerance;
        assert!(ok, "{what}: {c:?} instead of {b:?} times {scale}");
    }
    for (p, b) in changed.parts.iter().zip(&base.parts) {
        let ok = same(p.outer, b.outer * scale)
            && same(p.inside, b.inside * scale)
            && p.holes.len() == b.holes.len()
            && p.holes.iter().zip(&b.holes).all(|(x, y)| same(*x, y * scale));
        assert!(ok, "{what}: {p:?} instead of {b:?} times {scale}");
    }
}

/// Nine parts with outlines of every kind, holes, parts in holes and open cuts; also the counts they must give.
fn scene(seed: u64) -> (Scene, usize, usize) {
    let mut rng = seeded(seed);
    let mut entities = Vec::new();
    let (mut contours, mut parts) = (0, 0);
    for cell in 0..9 {
        let center = DVec2::new((cell % 3) as f64 * 150.0, (cell / 3) as f64 * 150.0);
        let radius = rng.random_range(45.0..60.0);
        outline(&mut rng, cell, center, radius, &mut entities);
        (contours, parts) = (contours + 1, parts + 1);
        let hole = rng.random_range(14.0..17.0);
        let kind = rng.random_range(0..6);
        outline(&mut rng, kind, center, hole, &mut entities);
        contours += 1;
        if rng.random_bool(0.5) {
            // A part in the hole, with a hole.
            outline(&mut rng, 0, center, hole * 0.5, &mut entities);
            entities.push(Entity::Circle(center, rng.random_range(2.0..4.0)));
            (contours, parts) = (contours + 2, parts + 1);
        }
        let at = center + DVec2::new(radius * 0.45, 0.0);
        let tip = at + math::rotate(DVec2::new(rng.random_range(2.0..3.0), 0.0), rng.random_range(0.0..TAU));
        entities.push(Entity::Line(at, tip));
        contours += 1;
    }
    let on_layers =
        entities.into_iter().enumerate().map(|(i, e)| (e, if i % 2 == 0 { "A" } else { "B" }.to_owned()));
    (Scene { entities: on_layers.collect(), units: 4 }, contours, parts)
}

/// A closed outline around `c`, all of it within `r` and beyond 0.55 `r`.
fn outline(rng: &mut Rng, kind: usize, c: DVec2, r: f64, out: &mut Vec<Entity>) {
    let turn = rng.random_range(0.0..TAU);
    let ring = |n: usize, i: usize, r: f64| c + r * math::unit(turn + TAU * i as f64 / n as f64);
    match kind % 6 {
        0 => {
            let n = 4 + rng.random_range(0..4);
            out.extend((0..n).map(|i| Entity::Line(ring(n, i, r), ring(n, i + 1, r))));
        }
        1 => {
            let n = 4 + rng.random_range(0..5);
            let vertex = |i| (ring(n, i, r * 0.9), rng.random_range(-0.1..0.2));
            out.push(Entity::Polyline((0..n).map(vertex).collect(), true));
        }
        2 => {
            // A slot: two lines, two half circles.
            let (along, across) = (math::unit(turn) * r * 0.4, math::unit(turn).perp() * r * 0.58);
            out.push(Entity::Line(c - along - across, c + along - across));
            out.push(Entity::Arc(c + along, r * 0.58, turn - TAU / 4.0, turn + TAU / 4.0));
            out.push(Entity::Line(c + along + across, c - along + across));
            out.push(Entity::Arc(c - along, r * 0.58, turn + TAU / 4.0, turn + TAU * 0.75));
        }
        3 => out.push(Entity::Ellipse(c, math::unit(turn) * r, rng.random_range(0.6..0.95), 0.0, TAU)),
        4 => out.push(Entity::Circle(c, r * 0.95)),
        _ => {
            // A spline around most of the ring, closed by two lines.
            let p: Vec<DVec2> = (0..8).map(|i| ring(10, i, r * rng.random_range(0.85..0.98))).collect();
            let (a, b) = (p[7], p[0]);
            let middle = ring(10, 8, r * 0.8) * 0.5 + ring(10, 9, r * 0.8) * 0.5;
            out.push(Entity::Spline(p));
            out.push(Entity::Line(a, middle));
            out.push(Entity::Line(middle, b));
        }
    }
}

const SEEDS: std::ops::Range<u64> = 0..8;

fn similarity(rng: &mut Rng) -> Similarity {
    Similarity {
        mirror: rng.random_bool(0.5),
        turn: rng.random_range(0.0..TAU),
        scale: 1.0,
        shift: DVec2::new(rng.random_range(-2000.0..2000.0), rng.random_range(-2000.0..2000.0)),
    }
}

#[test]
fn a_scene_has_the_contours_and_parts_it_was_made_of() {
    for seed in SEEDS {
        let (scene, contours, parts) = scene(seed);
        let census = census(&scene.dxf());
        assert_eq!((census.contours.len(), census.parts.len()), (contours, parts), "seed {seed}");
    }
}

#[test]
fn moved_turned_and_mirrored() {
    for seed in SEEDS {
        let (scene, ..) = scene(seed);
        let base = census(&scene.dxf());
        let mut rng = seeded(seed + 100);
        for _ in 0..4 {
            let t = similarity(&mut rng);
            assert_same(&base, &census(&scene.transformed(&t).dxf()), 1.0, &format!("seed {seed}, {t:?}"));
        }
    }
}

#[test]
fn scaled_by_coordinates_and_by_units() {
    for seed in SEEDS {
        let (scene, ..) = scene(seed);
        let base = census(&scene.dxf());
        for scale in [0.25, 3.0] {
            let t = Similarity { scale, ..Similarity::IDENTITY };
            assert_same(
                &base,
                &census(&scene.transformed(&t).dxf()),
                scale,
                &format!("seed {seed}, times {scale}"),
            );
        }
        // $INSUNITS and mm per unit: the numbers change, the size does not.
        for (units, mm) in
            [(1, 25.4), (2, 304.8), (5, 10.0), (6, 1000.0), (9, 0.0254), (10, 914.4), (14, 100.0)]
        {
            let t = Similarity { scale: 1.0 / mm, ..Similarity::IDENTITY };
            let same_size = Scene { units, ..scene.transformed(&t) };
            assert_same(&base, &census(&same_size.dxf()), 1.0, &format!("seed {seed}, $INSUNITS {units}"));
        }
    }
}

#[test]
fn entities_shuffled_reversed_and_taken_apart() {
    for seed in SEEDS {
        let (scene, ..) = scene(seed);
        let base = census(&scene.dxf());
        let mut rng = seeded(seed + 200);
        let mut shuffled = scene.clone();
        shuffled.entities.shuffle(&mut rng);
        assert_same(&base, &census(&shuffled.dxf()), 1.0, &format!("seed {seed}, shuffled"));
        let reversed = scene.map(|e| vec![e.reversed()]);
        assert_same(&base, &census(&reversed.dxf()), 1.0, &format!("seed {seed}, reversed"));
        let mut exploded = scene.map(Entity::exploded);
        assert_same(&base, &census(&exploded.dxf()), 1.0, &format!("seed {seed}, exploded"));
        exploded.entities.shuffle(&mut rng);
        assert_same(&base, &census(&exploded.dxf()), 1.0, &format!("seed {seed}, exploded and shuffled"));
    }
}

#[test]
fn wrapped_in_blocks() {
    for seed in SEEDS {
        let (scene, ..) = scene(seed);
        let base = census(&scene.dxf());
        let mut rng = seeded(seed + 300);
        for depth in 1..=4 {
            let t = similarity(&mut rng);
            let corner = DVec2::new(rng.random_range(-50.0..50.0), rng.random_range(-50.0..50.0));
            let text = scene.dxf_in_block(&t, corner, depth);
            assert_same(&base, &census(&text), 1.0, &format!("seed {seed}, {depth} deep, {t:?}"));
        }
    }
}

#[test]
fn a_hole_in_a_bow_tie_is_inside_it() {
    let at = DVec2::new;
    let corners = [at(0.0, 0.0), at(100.0, 50.0), at(100.0, 0.0), at(0.0, 50.0)];
    let bow_tie = Entity::Polyline(corners.iter().map(|p| (*p, 0.0)).collect(), true);
    let entities = vec![(bow_tie, "0".to_owned()), (Entity::Circle(at(85.0, 25.0), 5.0), "0".to_owned())];
    let census = census(&Scene { entities, units: 4 }.dxf());
    assert_eq!(
        census.contours.iter().map(|c| c.depth).collect::<Vec<_>>(),
        [1, 0],
        "the circle is the shorter one"
    );
}

#[test]
fn every_entity_twice_is_every_entity_once() {
    for seed in SEEDS {
        let (scene, ..) = scene(seed);
        let base = census(&scene.dxf());
        let twice = scene.map(|e| vec![e.clone(), e.clone()]);
        assert_same(&base, &census(&twice.dxf()), 1.0, &format!("seed {seed}, twice"));
        let back = scene.map(|e| vec![e.clone(), e.reversed()]);
        assert_same(&base, &census(&back.dxf()), 1.0, &format!("seed {seed}, there and back"));
    }
}
