//! How long GRBL 1.1 takes to run motions from rest to rest: a simulation of its planner, block by block.
//!
//! Written from the published descriptions of `mc_arc` and of the planner (S. K. Jeon's articles on cornering, the GRBL
//! wiki on `$11` and `$12`); it shares no arithmetic with the crate. An arc is run as chords that deviate from it by at
//! most the arc tolerance. Every block has a highest entry speed, from the feed and from the angle to the block before it;
//! a pass backward makes it possible to brake, a pass forward to accelerate, and each block is run as a trapezoid. The
//! look-ahead of single contours is unlimited; that of whole programs has as many blocks as GRBL's buffer.

use super::gcode::{Event, Program};
use super::paths::Element;
use glam::DVec2;

/// Default of GRBL's `$12`, mm.
const ARC_TOLERANCE: f64 = 0.002;

/// The settings of the planner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    /// mm/s2, in every direction.
    pub(crate) accel: f64,
    /// `$11`, mm.
    pub(crate) junction_deviation: f64,
}

struct Block {
    length: f64,
    direction: DVec2,
    feed: f64,
}

/// Where the lines end that GRBL runs for an element.
fn ends(element: &Element) -> Vec<DVec2> {
    let mut ends = Vec::new();
    if let Some((center, sweep)) = element.arc {
        let r = (element.from - center).length();
        let count = (0.5 * sweep.abs() * r / (ARC_TOLERANCE * (2.0 * r - ARC_TOLERANCE)).sqrt()).floor();
        let mut k = 1.0;
        while k < count {
            let (s, c) = (sweep * k / count).sin_cos();
            let v = element.from - center;
            ends.push(center + DVec2::new(v.x * c - v.y * s, v.x * s + v.y * c));
            k += 1.0;
        }
    }
    ends.push(element.to);
    ends
}

/// Seconds for the elements, each with its feed, mm/s, joined end to end.
pub(crate) fn seconds(settings: Settings, elements: &[(Element, f64)]) -> f64 {
    let mut blocks: Vec<Block> = Vec::new();
    for (element, feed) in elements {
        let mut at = element.from;
        for end in ends(element) {
            let way = end - at;
            if way.length() > 0.0 {
                blocks.push(Block { length: way.length(), direction: way.normalize(), feed: *feed });
            }
            at = end;
        }
    }
    // Highest speeds at the starts of the blocks, and at rest at the end of the last.
    let a = settings.accel;
    let mut speed = vec![0.0; blocks.len() + 1];
    for (i, pair) in blocks.windows(2).enumerate() {
        let cos = -pair[0].direction.dot(pair[1].direction);
        let junction = if cos > 0.999_999 {
            0.0
        } else if cos < -0.999_999 {
            f64::INFINITY
        } else {
            let half = (0.5 * (1.0 - cos)).sqrt();
            (a * settings.junction_deviation * half / (1.0 - half)).sqrt()
        };
        speed[i + 1] = junction.min(pair[0].feed).min(pair[1].feed);
    }
    for (i, block) in blocks.iter().enumerate().rev() {
        let braked: f64 = speed[i + 1];
        speed[i] = speed[i].min((braked * braked + 2.0 * a * block.length).sqrt());
    }
    for (i, block) in blocks.iter().enumerate() {
        let entered: f64 = speed[i];
        speed[i + 1] = speed[i + 1].min((entered * entered + 2.0 * a * block.length).sqrt());
    }
    blocks.iter().zip(speed.windows(2)).map(|(b, v)| trapezoid(b, v[0], v[1], a)).sum()
}

fn trapezoid(block: &Block, enters: f64, leaves: f64, a: f64) -> f64 {
    let up = (block.feed * block.feed - enters * enters) / (2.0 * a);
    let down = (block.feed * block.feed - leaves * leaves) / (2.0 * a);
    if up + down <= block.length {
        return (2.0 * block.feed - enters - leaves) / a + (block.length - up - down) / block.feed;
    }
    // Where the line of acceleration from the start meets that of braking to the end.
    let up = 0.5 * (block.length + (leaves * leaves - enters * enters) / (2.0 * a));
    let peak = (enters * enters + 2.0 * a * up.max(0.0)).sqrt();
    (2.0 * peak - enters - leaves) / a
}

/// Seconds that the motions of a program with the beam on take, each run of them from rest to rest.
pub(crate) fn work_seconds(settings: Settings, program: &Program) -> f64 {
    let (mut sum, mut run) = (0.0, Vec::new());
    for event in &program.events {
        match event {
            Event::Motion(m) if !m.rapid => run.push((m.path, m.feed / 60.0)),
            // Where a contour is announced, one ends: marks may follow each other on the spot.
            _ => sum += seconds(settings, &std::mem::take(&mut run)),
        }
    }
    sum + seconds(settings, &run)
}

/// What the planner of a whole program is told of a machine.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Machine {
    /// `$110`, `$111`, mm/s.
    pub(crate) rapid_speed: [f64; 2],
    /// Acceleration of rapids, mm/s2.
    pub(crate) rapid_accel: [f64; 2],
    /// Acceleration of feeds in every direction, mm/s2.
    pub(crate) accel: f64,
    /// `$11`, mm.
    pub(crate) junction_deviation: f64,
    /// Number of blocks that the controller looks ahead: GRBL has a buffer of 16.
    pub(crate) blocks: usize,
    /// Whether the head stops wherever a rapid begins or ends, as plans assume. GRBL stops there only if a dwell asks for it.
    pub(crate) stops: bool,
}

/// A block with the limits of its own direction.
struct Limited {
    length: f64,
    direction: DVec2,
    nominal: f64,
    accel: f64,
}

/// Seconds of a whole program: rapids and feeds run into each other within the look-ahead, and dwells stop the head.
pub(crate) fn program_seconds(machine: Machine, program: &Program) -> f64 {
    let (mut sum, mut stretch, mut rapid) = (0.0, Vec::new(), false);
    for event in &program.events {
        match event {
            Event::Motion(m) => {
                if machine.stops && m.rapid != rapid {
                    sum += run(machine, &std::mem::take(&mut stretch));
                }
                rapid = m.rapid;
                let mut at = m.path.from;
                for end in ends(&m.path) {
                    let way = end - at;
                    at = end;
                    if way.length() > 0.0 {
                        stretch.push(limited(machine, way, m.rapid, m.feed / 60.0));
                    }
                }
            }
            Event::Dwell { seconds, .. } => sum += seconds + run(machine, &std::mem::take(&mut stretch)),
            Event::Comment(_) => {}
        }
    }
    sum + run(machine, &stretch)
}

fn limited(machine: Machine, way: DVec2, rapid: bool, feed: f64) -> Limited {
    let direction = way.normalize();
    let along = |limits: [f64; 2]| (limits[0] / direction.x.abs()).min(limits[1] / direction.y.abs());
    let (nominal, accel) =
        if rapid { (along(machine.rapid_speed), along(machine.rapid_accel)) } else { (feed, machine.accel) };
    Limited { length: way.length(), direction, nominal, accel }
}

/// Runs blocks one after the other. While one is run, the buffer holds the next ones, and the last of them ends at rest, so
/// the speed at which a block is left is what can be braked within the buffer.
fn run(machine: Machine, blocks: &[Limited]) -> f64 {
    let junction = |k: usize| {
        let (a, b) = (&blocks[k - 1], &blocks[k]);
        let cos = -a.direction.dot(b.direction);
        let limit = if cos > 0.999_999 {
            0.0
        } else if cos < -0.999_999 {
            f64::INFINITY
        } else {
            let half = (0.5 * (1.0 - cos)).sqrt();
            (b.accel * machine.junction_deviation * half / (1.0 - half)).sqrt()
        };
        limit.min(a.nominal).min(b.nominal)
    };
    let (mut entered, mut sum) = (0.0_f64, 0.0);
    for (i, block) in blocks.iter().enumerate() {
        let buffered = i + 1..blocks.len().min(i + machine.blocks);
        let allowed = buffered.rev().fold(0.0_f64, |after, k| {
            junction(k).min((after * after + 2.0 * blocks[k].accel * blocks[k].length).sqrt())
        });
        let leaves = allowed.min((entered * entered + 2.0 * block.accel * block.length).sqrt());
        let plain = Block { length: block.length, direction: block.direction, feed: block.nominal };
        sum += trapezoid(&plain, entered, leaves, block.accel);
        entered = leaves;
    }
    sum
}
