//! Sheets made by hand for the tests of plan and search: their nesting is known by how they are made.
#![allow(dead_code, unreachable_pub, reason = "shared by several test files, each of which uses its part")]
#![allow(clippy::unwrap_used, clippy::cast_precision_loss, reason = "test data")]

use kerfway::geometry::{Arc, DVec2, Path, Segment};
use kerfway::machine::{Profile, preset};
use kerfway::plan;
use kerfway::problem::Problem;
use kerfway::sheet::{Contour, LayerUse, Operation, Part, Pin, Sheet};
use kerfway::solve::{Search, Solution, papers};

pub fn p(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

pub fn machine(name: &str) -> Profile {
    preset(name).unwrap()
}

pub fn polygon(points: &[DVec2]) -> Path {
    let next = points.iter().cycle().skip(1);
    Path::new(points.iter().zip(next).map(|(a, b)| Segment::line(*a, *b)).collect(), true)
}

pub fn rectangle(corner: DVec2, size: DVec2) -> Path {
    polygon(&[corner, corner + p(size.x, 0.0), corner + size, corner + p(0.0, size.y)])
}

/// Two half circles of that radius joined by lines along x.
pub fn slot(center: DVec2, length: f64, radius: f64) -> Path {
    let (a, b) = (center - p(length / 2.0, 0.0), center + p(length / 2.0, 0.0));
    let down = p(0.0, -radius);
    Path::new(
        vec![
            Segment::line(a + down, b + down),
            Segment::Arc(Arc::new(b + down, b - down, b, true)),
            Segment::line(b - down, a - down),
            Segment::Arc(Arc::new(a - down, a + down, a, true)),
        ],
        true,
    )
}

pub fn circle(center: DVec2, radius: f64) -> Path {
    Path::new(vec![Segment::Arc(Arc::circle(center, radius))], true)
}

pub fn line(a: DVec2, b: DVec2) -> Path {
    Path::new(vec![Segment::line(a, b)], false)
}

/// Builds a sheet contour by contour, each with the contour around it.
pub struct Builder {
    pub sheet: Sheet,
}

impl Builder {
    pub fn new() -> Self {
        let layer = |name: &str, operation| LayerUse {
            name: name.to_owned(),
            color: 7,
            operation,
            suggestion: None,
            settings: kerfway::machine::Settings::NONE,
            rank: 0,
            contours: 0,
        };
        let layers = vec![layer("CUT", Operation::Cut), layer("MARK", Operation::Mark)];
        let bounds = kerfway::geometry::Aabb::EMPTY;
        let (contours, parts, ignored, findings) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self {
            sheet: Sheet {
                contours,
                parts,
                layers,
                ignored,
                part_by_part: false,
                groups: Vec::new(),
                pass_order: kerfway::sheet::PassOrder::Contour,
                common_cuts: kerfway::sheet::CommonCuts::Best,
                joints: Vec::new(),
                bridged: std::sync::Arc::default(),
                choices: Vec::new(),
                joined_within: 0.0,
                outline: None,
                bounds,
                findings,
            },
        }
    }

    pub fn cut(&mut self, path: Path, inside: Option<u32>) -> u32 {
        self.push(path, inside, Operation::Cut)
    }

    pub fn mark(&mut self, path: Path, inside: Option<u32>) -> u32 {
        self.push(path, inside, Operation::Mark)
    }

    fn push(&mut self, path: Path, inside: Option<u32>, operation: Operation) -> u32 {
        let id = u32::try_from(self.sheet.contours.len()).unwrap();
        let bounds = path.bounds();
        self.sheet.bounds = self.sheet.bounds.union(bounds);
        let depth = inside.map_or(0, |o| self.sheet.contours[o as usize].depth + 1);
        if path.closed && depth.is_multiple_of(2) {
            self.sheet.parts.push(Part { outer: id, holes: Vec::new(), inside: None });
        }
        self.sheet.contours.push(Contour {
            outline: None,
            drawn: None,
            layer: u32::from(operation == Operation::Mark),
            operation,
            inside,
            depth,
            length: path.length(),
            area: path.area().abs(),
            bounds,
            self_crossing: false,
            pass: 0,
            next_pass: None,
            turn: None,
            together: None,
            pin: Pin::None,
            first_shape: id,
            rest_of: None,
            skeleton: false,
            bridged: None,
            path,
        });
        id
    }
}

/// A xorshift generator of numbers for test data. Seeds of tests with literal expectations belong to it; new tests use [`rng`](super::rng).
pub struct XorShift(u64);

impl XorShift {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// A whole number below `n`.
    pub fn below(&mut self, n: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 20) % n
    }

    /// A number from `a` to `b`.
    pub fn between(&mut self, a: f64, b: f64) -> f64 {
        let k = u32::try_from(self.below(1 << 24)).unwrap();
        a + (b - a) * f64::from(k) / f64::from(1 << 24)
    }

    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in (1..list.len()).rev() {
            list.swap(i, usize::try_from(self.below(i as u64 + 1)).unwrap());
        }
    }
}

/// A nested sheet: parts in rows, with holes, slots, marks, open cuts, and parts with holes in large holes. About
/// `contours` contours, in an order as mixed as that of real files.
pub fn nested_sheet(contours: usize, seed: u64) -> Sheet {
    nest(contours, seed, false)
}

/// The same with gaps between all contours, some of which overlap there.
pub fn nested_sheet_with_gaps(contours: usize, seed: u64) -> Sheet {
    nest(contours, seed, true)
}

fn nest(contours: usize, seed: u64, gaps: bool) -> Sheet {
    let width = if gaps { 80.0 } else { 60.0 };
    let mut rng = XorShift::new(seed);
    let mut b = Builder::new();
    let columns = u32::try_from(contours / 5).unwrap().isqrt().max(1);
    let mut cell = 0;
    while b.sheet.contours.len() < contours {
        let at = p(f64::from(cell % columns) * width, f64::from(cell / columns) * 45.0);
        cell += 1;
        let size = p(rng.between(30.0, 55.0), rng.between(25.0, 40.0));
        let jitter = p(rng.between(0.0, 4.0), rng.between(0.0, 4.0));
        let (corner, middle) = (at + jitter, at + jitter + size / 2.0);
        match rng.below(4) {
            0 => {
                let outer = b.cut(rectangle(corner, size), None);
                let mut holes: Vec<(DVec2, f64)> = Vec::new();
                for _ in 0..1 + rng.below(6) {
                    let where_to = corner + p(rng.between(4.0, size.x - 4.0), rng.between(4.0, size.y - 4.0));
                    let radius = rng.between(0.5, 1.5);
                    let is_clear = |&(other, r): &(DVec2, f64)| other.distance(where_to) > r + radius + 0.5;
                    if !gaps || holes.iter().all(is_clear) {
                        holes.push((where_to, radius));
                        b.cut(circle(where_to, radius), Some(outer));
                    }
                }
                b.mark(line(corner + p(3.0, 1.0), corner + p(20.0, 1.5)), Some(outer));
            }
            1 => {
                let outer = b.cut(slot(middle, size.x - size.y / 2.0, size.y / 2.0), None);
                b.cut(slot(middle, size.x / 3.0, size.y / 6.0), Some(outer));
            }
            2 => {
                let outer = b.cut(circle(middle, size.y / 2.0), None);
                let hole = b.cut(circle(middle, size.y / 2.0 - 3.0), Some(outer));
                let island = b.cut(rectangle(middle - p(6.0, 5.0), p(12.0, 10.0)), Some(hole));
                b.cut(circle(middle + p(1.0, 0.0), 2.0), Some(island));
            }
            _ => {
                let corners = 3 + rng.below(9);
                let points: Vec<DVec2> = (0..corners)
                    .map(|k| {
                        let turn =
                            (k as f64 + rng.between(0.0, 0.8)) * std::f64::consts::TAU / corners as f64;
                        middle + rng.between(8.0, 12.0) * kerfway::geometry::math::unit(turn)
                    })
                    .collect();
                b.cut(polygon(&points), None);
                b.cut(line(corner, corner + p(rng.between(1.0, 6.0), 2.0)), None);
            }
        }
    }
    b.sheet
}

/// A search by a method of a paper. It does not need the method it comes from.
pub fn paper<'p>(name: &str, parameters: &str, problem: &'p Problem, seed: u64) -> Box<dyn Search + 'p> {
    papers::method(name, parameters).unwrap().start(problem, seed, None)
}

/// What a search has found is a plan that passes the checker.
pub fn assert_passes(sheet: &Sheet, machine: &Profile, problem: &Problem, best: &Solution) {
    assert_feasible(problem, best);
    let plan = plan::from_solution(sheet, problem, best);
    assert_eq!(plan::check(sheet, machine, &plan), Ok(()), "{}", machine.name);
}

/// Whether a solution does every item once round, in one go or left unfinished where that is allowed, visits nested, inner
/// finished before outer, by rank.
pub fn assert_feasible(problem: &Problem, solution: &Solution) {
    let mut finished = vec![None; problem.items.len()];
    // Items left unfinished: first place and the one they were left at.
    let mut open: Vec<(usize, u64, u64)> = Vec::new();
    let mut rank = 0;
    for (k, stop) in solution.stops.iter().enumerate() {
        let item = problem.nodes[stop.node as usize].item as usize;
        let (along, until) = (stop.along.to_bits(), stop.until.to_bits());
        let first = match open.last() {
            Some(&(inner, first, left)) if inner == item => {
                assert_eq!(left, along, "item {item} resumed elsewhere");
                open.pop();
                first
            }
            _ => along,
        };
        assert!(open.iter().all(|o| o.0 != item), "visits of item {item} cross others");
        assert!(finished[item].is_none(), "item {item} twice");
        if until == first {
            finished[item] = Some(k);
        } else {
            assert!(problem.items[item].leave.is_some(), "item {item} left");
            open.push((item, first, until));
        }
        assert!(problem.items[item].rank >= rank, "rank of item {item}");
        rank = problem.items[item].rank;
    }
    assert!(open.is_empty(), "left unfinished for good: {open:?}");
    for (item, at) in problem.items.iter().zip(&finished) {
        // A contour that is ignored has no nodes.
        assert!(at.is_some() || item.nodes.is_empty(), "left out");
        if let Some(outer) = item.before {
            assert!(*at < finished[outer as usize], "item {outer} before what is inside it");
        }
    }
    let again = Solution::new(problem, solution.stops.clone());
    assert_eq!(again.cost.to_bits(), solution.cost.to_bits());
}
