//! The same drawing moved, turned, mirrored, scaled, shuffled, reversed, split, exploded gives the same contours.

use super::sketch::*;
use kerfway::geometry::{DVec2, Path, Segment, math};
use kerfway::sheet::{Sheet, SheetOptions};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

type Rng = Xoshiro256PlusPlus;

/// What must not change: for every contour whether it closes, its depth, length and area, and those of the one
/// around it; sorted. And the parts.
#[derive(Debug, PartialEq)]
struct Essence {
    contours: Vec<[f64; 6]>,
    parts: usize,
    holes: Vec<usize>,
}

fn essence(s: &Sheet, scale: f64) -> Essence {
    // A thousandth of a millimetre: turned and scaled coordinates differ by rounding.
    let round = |v: f64| (v * 1e3).round() / 1e3;
    let mut contours: Vec<[f64; 6]> = s
        .contours
        .iter()
        .map(|c| {
            let (l, a) = c.inside.map_or((0.0, 0.0), |i| {
                let o = &s.contours[i as usize];
                (o.length, o.area)
            });
            let closed = f64::from(u8::from(c.path.closed));
            let lengths = [c.length / scale, l / scale].map(round);
            let areas = [c.area, a].map(|a| round(a / (scale * scale)));
            [closed, f64::from(c.depth), lengths[0], areas[0], lengths[1], areas[1]]
        })
        .collect();
    contours.sort_by(|a, b| a.partial_cmp(b).unwrap());
    let mut holes: Vec<usize> = s.parts.iter().map(|p| p.holes.len()).collect();
    holes.sort_unstable();
    Essence { contours, parts: s.parts.len(), holes }
}

/// A drawing at random: parts in a row with holes, slots, parts in holes, open scores; some doubled, some of loose
/// elements with gaps up to twice 1.4 `gap` mm, some overlapping lines.
fn random_drawing(rng: &mut Rng, gap: f64) -> Vec<Path> {
    let mut out = Vec::new();
    for i in 0..6 {
        let (x, y) = (f64::from(i) * 130.0 + rng.random_range(0.0..5.0), rng.random_range(-20.0..20.0));
        let outer = if rng.random_bool(0.4) {
            rounded(x, y, 100.0, 80.0, rng.random_range(5.0..20.0))
        } else {
            rect(x, y, 100.0, 80.0)
        };
        let window = rounded(x + 25.0, y + 25.0, 50.0, 40.0, 5.0);
        out.push(outer.clone());
        if rng.random_bool(0.3) {
            out.push(outer.reversed());
        }
        if rng.random_bool(0.6) {
            out.extend(loose(rng, &window, gap));
            out.push(circle_from(
                x + 50.0,
                y + 45.0,
                rng.random_range(5.0..15.0),
                rng.random_range(0.0..6.0),
            ));
        } else {
            out.push(line(x + 20.0, y + 20.0, x + 60.0, y + 30.0));
            // Beyond the end of the first by half of itself.
            out.push(line(x + 40.0, y + 25.0, x + 80.0, y + 35.0));
        }
        for k in 0..rng.random_range(0..4) {
            out.push(circle(x + 10.0 + 25.0 * f64::from(k), y + 10.0, rng.random_range(1.0..4.0)));
        }
    }
    out
}

fn rounded(x: f64, y: f64, w: f64, h: f64, r: f64) -> Path {
    let corner = |x: f64, y: f64, from: f64| arc(x, y, r, from, 90.0).segments[0];
    let arcs = [
        corner(x + w - r, y + r, -90.0),
        corner(x + w - r, y + h - r, 0.0),
        corner(x + r, y + h - r, 90.0),
        corner(x + r, y + r, 180.0),
    ];
    let segments = (0..4).flat_map(|i| [arcs[i], Segment::line(arcs[i].end(), arcs[(i + 1) % 4].start())]);
    let mut segments: Vec<Segment> = segments.collect();
    if let Some(Segment::Line(last)) = segments.last_mut() {
        last.end = arcs[0].start();
    }
    Path::new(segments, true)
}

/// The elements of a path on their own, in any order and direction, ends of lines off by up to `gap` mm in x and y.
fn loose(rng: &mut Rng, path: &Path, gap: f64) -> Vec<Path> {
    let mut pieces = exploded(path);
    for piece in &mut pieces {
        let mut off = || DVec2::new(rng.random_range(-gap..=gap), rng.random_range(-gap..=gap));
        if let Segment::Line(l) = &mut piece.segments[0] {
            l.start += off();
            l.end += off();
        }
        if rng.random_bool(0.5) {
            *piece = piece.reversed();
        }
    }
    shuffle(rng, &mut pieces);
    pieces
}

fn shuffle<T>(rng: &mut Rng, v: &mut [T]) {
    for i in (1..v.len()).rev() {
        v.swap(i, rng.random_range(0..=i));
    }
}

pub(super) fn mapped(paths: &[Path], f: impl Fn(&Segment) -> Segment) -> Vec<Path> {
    paths.iter().map(|p| Path::new(p.segments.iter().map(&f).collect(), p.closed)).collect()
}

/// Every element in two pieces.
fn split(paths: &[Path]) -> Vec<Path> {
    let halves = |s: &Segment| [s.piece(0.0, 0.37), s.piece(0.37, 1.0)];
    paths.iter().map(|p| Path::new(p.segments.iter().flat_map(halves).collect(), p.closed)).collect()
}

/// Ends off by this, mm: gaps well above rounding and well below the joining tolerance.
const GAP: f64 = 0.007;

fn for_all_seeds(name: &str, scale: f64, change: impl Fn(&mut Rng, &[Path]) -> Vec<Path>) {
    for_all_seeds_with(GAP, name, scale, change);
}

/// Without gaps: a gap is closed by moving the ends of lines, and half a line turns by another angle than a whole one.
fn for_all_seeds_without_gaps(name: &str, change: impl Fn(&mut Rng, &[Path]) -> Vec<Path>) {
    for_all_seeds_with(0.0, name, 1.0, change);
}

fn for_all_seeds_with(gap: f64, name: &str, scale: f64, change: impl Fn(&mut Rng, &[Path]) -> Vec<Path>) {
    for seed in 0..12 {
        let mut rng = Rng::seed_from_u64(seed);
        let paths = random_drawing(&mut rng, gap);
        let plain = essence(&sheet(paths.clone()), 1.0);
        assert!(plain.contours.iter().filter(|c| c[0] > 0.0).count() >= 6 && plain.parts >= 6);
        let base = SheetOptions::default();
        let options = SheetOptions {
            join_tolerance: base.join_tolerance * scale,
            copy_tolerance: base.copy_tolerance * scale,
            ..base
        };
        let changed = essence(&sheet_with(change(&mut rng, &paths), &options), scale);
        assert_eq!(changed, plain, "{name}, seed {seed}");
    }
}

/// The map `p -> scale * R(angle) (mirrored?) p + offset` of an element.
pub(super) fn similar(s: &Segment, scale: f64, angle: f64, mirrored: bool, offset: DVec2) -> Segment {
    let map = |p: DVec2| {
        let q = if mirrored { DVec2::new(-p.x, p.y) } else { p };
        math::rotate(q, angle) * scale + offset
    };
    match *s {
        Segment::Line(l) => Segment::line(map(l.start), map(l.end)),
        Segment::Arc(mut a) => {
            (a.start, a.end, a.center) = (map(a.start), map(a.end), map(a.center));
            if mirrored {
                a.sweep = -a.sweep;
            }
            Segment::Arc(a)
        }
    }
}

#[test]
fn moved() {
    for_all_seeds("moved", 1.0, |rng, p| {
        let by = DVec2::new(rng.random_range(-5e3..5e3), rng.random_range(-5e3..5e3));
        mapped(p, |s| similar(s, 1.0, 0.0, false, by))
    });
}

#[test]
fn turned() {
    for_all_seeds("turned", 1.0, |rng, p| {
        let angle = rng.random_range(0.0..6.0);
        mapped(p, |s| similar(s, 1.0, angle, false, DVec2::ZERO))
    });
}

#[test]
fn mirrored() {
    for_all_seeds("mirrored", 1.0, |rng, p| {
        let angle = rng.random_range(0.0..6.0);
        mapped(p, |s| similar(s, 1.0, angle, true, DVec2::ZERO))
    });
}

#[test]
fn scaled() {
    for factor in [0.1, 25.4] {
        for_all_seeds("scaled", factor, |_, p| mapped(p, |s| similar(s, factor, 0.0, false, DVec2::ZERO)));
    }
}

#[test]
fn shuffled() {
    for_all_seeds("shuffled", 1.0, |rng, p| {
        let mut p = p.to_vec();
        shuffle(rng, &mut p);
        p
    });
}

#[test]
fn reversed() {
    for_all_seeds("reversed", 1.0, |_, p| p.iter().map(Path::reversed).collect());
}

#[test]
fn split_elements() {
    for_all_seeds_without_gaps("split", |_, p| split(p));
}

#[test]
fn exploded_and_shuffled() {
    for_all_seeds("exploded", 1.0, |rng, p| {
        let mut p: Vec<Path> = p.iter().flat_map(exploded).collect();
        shuffle(rng, &mut p);
        p
    });
}

#[test]
fn split_exploded_reversed_and_shuffled() {
    for_all_seeds_without_gaps("all of it", |rng, p| {
        let mut p: Vec<Path> = split(p).iter().flat_map(exploded).map(|p| p.reversed()).collect();
        shuffle(rng, &mut p);
        p
    });
}

#[test]
fn the_same_drawing_twice_gives_the_same_bytes() {
    let paths = random_drawing(&mut Rng::seed_from_u64(99), GAP);
    let (a, b) = (sheet(paths.clone()), sheet(paths));
    assert_eq!(a.contours, b.contours);
    assert_eq!(a.findings, b.findings);
}
