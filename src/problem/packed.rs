//! A problem of a machine as numbers in a row: how it crosses from the planner to the wasm files that prove bounds and
//! hold the methods of papers.
//!
//! Only what they look at: runs along contours stay behind, and what the head does in a pierce group. They only add to what a plan takes, and the papers know none.

use super::groups::Groups;
use super::ids::NodeId;
use super::model::{Item, Node, Problem};
use super::sub_path::SubPath;
use crate::geometry::{Arc, DVec2, Path, Segment};
use crate::machine::{self, Travel};

const TRAVEL: [Travel; 3] = [Travel::Straight, Travel::Vector, Travel::PerAxis];

impl Problem {
    /// The problem as numbers, exactly; what is absent is not a number.
    pub fn packed(&self) -> Vec<f64> {
        let rapid = &self.machine.rapid;
        let accel = rapid.accel.unwrap_or([f64::NAN; 2]);
        let travel = TRAVEL.iter().take_while(|t| **t != self.machine.travel).count();
        let mut out = vec![self.home.x, self.home.y, f64::from(u8::from(self.closed)), travel as f64];
        out.extend([rapid.speed, accel].as_flattened());
        out.push(self.items.len() as f64);
        for item in &self.items {
            let nodes = &self.nodes[item.nodes.start as usize..item.nodes.end as usize];
            let before = number(&item.before);
            out.extend([nodes.len() as f64, before, item.rank.into(), item.fixed]);
            out.push(item.leave.unwrap_or(f64::NAN));
            for n in nodes {
                out.extend([n.entry.x, n.entry.y, n.exit.x, n.exit.y, n.along]);
                out.extend([f64::from(u8::from(n.reversed)), n.twin.into()]);
            }
            out.push(item.ways().len() as f64);
            out.extend(item.ways().iter().map(|p| p.seconds));
            let track = item.track.as_ref().map_or(&[][..], |t| &t.segments);
            out.push(track.len() as f64);
            for s in track {
                let (center, sweep) = match s {
                    Segment::Line(_) => (DVec2::ZERO, 0.0),
                    Segment::Arc(a) => (a.center, a.sweep),
                };
                let (a, b) = (s.start(), s.end());
                out.extend([a.x, a.y, b.x, b.y, center.x, center.y, sweep]);
            }
        }
        for list in [&self.groups.of, &self.groups.around] {
            out.push(list.len() as f64);
            out.extend(list.iter().map(number));
        }
        out
    }

    /// The problem of such numbers; `None` when they are none.
    pub fn unpacked(numbers: &[f64]) -> Option<Self> {
        let mut from = Numbers(numbers.iter());
        let [home_x, home_y, closed, travel, speed_x, speed_y, accel_x, accel_y] = from.take()?;
        let mut machine = machine::presets().into_iter().next()?;
        machine.travel = *TRAVEL.get(whole(travel)? as usize)?;
        machine.rapid.speed = [speed_x, speed_y];
        machine.rapid.accel = (!accel_x.is_nan()).then_some([accel_x, accel_y]);
        let (mut items, mut nodes): (Vec<Item>, Vec<Node>) = (Vec::new(), Vec::new());
        for id in 0..from.count()? {
            let [count, before, rank, fixed, leave] = from.take()?;
            let first = NodeId::try_from(nodes.len()).ok()?;
            for _ in 0..whole(count)? {
                let [x, y, to_x, to_y, along, reversed, twin] = from.take()?;
                let (entry, exit) = (DVec2::new(x, y), DVec2::new(to_x, to_y));
                nodes.push(Node {
                    item: id,
                    entry,
                    exit,
                    along,
                    reversed: reversed > 0.0,
                    twin: whole(twin)?,
                });
            }
            let path = |seconds| SubPath { ends: [DVec2::ZERO; 2], strokes: Vec::new(), seconds };
            let mut paths = Vec::new();
            for _ in 0..from.count()? {
                paths.push(path(from.take::<1>()?[0]));
            }
            let mut track = Vec::new();
            for _ in 0..from.count()? {
                let [x, y, to_x, to_y, center_x, center_y, sweep] = from.take()?;
                let (start, end) = (DVec2::new(x, y), DVec2::new(to_x, to_y));
                let center = DVec2::new(center_x, center_y);
                let arc = Segment::Arc(Arc { start, end, center, sweep });
                track.push(if sweep == 0.0 { Segment::line(start, end) } else { arc });
            }
            items.push(Item {
                nodes: first..NodeId::try_from(nodes.len()).ok()?,
                before: absent(before)?,
                rank: whole(rank)?,
                fixed,
                run: None,
                leave: (!leave.is_nan()).then_some(leave),
                track: (!track.is_empty()).then(|| Path::new(track, true)),
                paths,
            });
        }
        let (home, closed) = (DVec2::new(home_x, home_y), closed > 0.0);
        let groups = Groups::new(from.numbers()?, from.numbers()?);
        Some(Self { items, nodes, home, closed, machine, pairs: Vec::new(), groups, table: None })
    }
}

struct Numbers<'a>(std::slice::Iter<'a, f64>);

impl Numbers<'_> {
    fn take<const N: usize>(&mut self) -> Option<[f64; N]> {
        let (taken, rest) = self.0.as_slice().split_first_chunk::<N>()?;
        self.0 = rest.iter();
        Some(*taken)
    }

    fn count(&mut self) -> Option<u32> {
        whole(self.take::<1>()?[0])
    }

    fn numbers(&mut self) -> Option<Vec<Option<u32>>> {
        (0..self.count()?).map(|_| absent(self.take::<1>()?[0])).collect()
    }
}

/// Not a number where there is none.
fn number(n: &Option<u32>) -> f64 {
    n.map_or(f64::NAN, f64::from)
}

/// The same, read.
fn absent(x: f64) -> Option<Option<u32>> {
    if x.is_nan() { Some(None) } else { whole(x).map(Some) }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast from float saturates")]
fn whole(x: f64) -> Option<u32> {
    (x >= 0.0 && x.fract() == 0.0 && x < f64::from(u32::MAX)).then_some(x as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::math::unit;

    #[test]
    fn what_crosses_is_the_same_to_the_bit() {
        let corners = (0..5).map(|k| unit(f64::from(k) * 1.3) * 7.1).collect::<Vec<_>>();
        let lines = (0..5).map(|k| Segment::line(corners[k], corners[(k + 1) % 5]));
        let circle = Path::new(vec![Segment::Arc(Arc::circle(DVec2::new(30.0, -4.5), 2.0))], true);
        let tracks = [Some(Path::new(lines.collect(), true)), Some(circle), None];
        let (mut items, mut nodes) = (Vec::new(), Vec::new());
        for (track, id) in tracks.into_iter().zip(0..) {
            for k in 0..2 {
                let entry = DVec2::new(f64::from(id) / 3.0, 0.1);
                let (along, reversed) = (f64::from(k), k == 1);
                nodes.push(Node { item: id, entry, exit: -entry, along, reversed, twin: 2 * id + 1 - k });
            }
            let (before, leave) = ((id == 0).then_some(2), (id == 1).then_some(0.25));
            let (rank, fixed) = (id, 1.0 / 3.0);
            items.push(Item {
                nodes: 2 * id..2 * id + 2,
                before,
                rank,
                fixed,
                run: None,
                leave,
                track,
                paths: Vec::new(),
            });
        }
        for machine in machine::presets() {
            let (home, closed) = (DVec2::new(-1.0, 0.3), machine.return_home);
            let (items, nodes) = (items.clone(), nodes.clone());
            let groups = Groups::new(vec![Some(1), None, Some(0)], vec![None, Some(0)]);
            let problem = Problem { items, nodes, home, closed, machine, pairs: vec![], groups, table: None };
            let numbers = problem.packed();
            let back = Problem::unpacked(&numbers).unwrap();
            assert_eq!((&back.items, &back.nodes), (&problem.items, &problem.nodes));
            assert_eq!(back.groups, problem.groups);
            assert_eq!((back.home, back.closed), (problem.home, problem.closed));
            assert_eq!(back.machine.travel, problem.machine.travel);
            assert_eq!(back.machine.rapid, problem.machine.rapid);
            assert!(Problem::unpacked(&numbers[..numbers.len() - 1]).is_none(), "one number too few");
        }
    }
}
