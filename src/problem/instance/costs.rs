//! The costs between the nodes of an instance: explicit weights in any of the formats, or distances of coordinates with
//! TSPLIB's rounding, so that lengths agree with the literature.

use super::error::InstanceError;
use super::file::File;
use crate::geometry::math;

/// Costs from every node to every node, row by row, for nodes in the order of `numbers` (from 1). Each of the
/// `fixed` edges earns `lowered`.
pub(super) fn costs(
    file: &File,
    numbers: &[u32],
    fixed: &[[u32; 2]],
    lowered: f64,
) -> Result<Vec<f64>, InstanceError> {
    let source = Source::of(file, numbers.len())?;
    let mut costs = Vec::with_capacity(numbers.len() * numbers.len());
    for &a in numbers {
        costs.extend(numbers.iter().map(|&b| source.cost(a as usize - 1, b as usize - 1)));
    }
    for &[a, b] in fixed {
        let place = |number: u32| numbers.iter().position(|&n| n == number).unwrap_or(0);
        let (a, b) = (place(a), place(b));
        costs[a * numbers.len() + b] = -lowered;
        costs[b * numbers.len() + a] = -lowered;
    }
    Ok(costs)
}

/// More than an exchange of two edges for two others can save: twice the difference of the dearest and the cheapest,
/// and one; 0 where no edge is fixed.
pub(super) fn span(file: &File, nodes: usize) -> Result<f64, InstanceError> {
    if file.part("FIXED_EDGES_SECTION").is_none() {
        return Ok(0.0);
    }
    let source = Source::of(file, nodes)?;
    let pairs = (0..nodes).flat_map(|a| (0..nodes).map(move |b| (a, b)));
    let (low, high) = pairs
        .map(|(a, b)| source.cost(a, b))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| (c.min(low), c.max(high)));
    Ok(2.0 * (high - low) + 1.0)
}

/// The source of the costs.
enum Source<'f> {
    /// All pairs, row by row.
    Full { weights: &'f [f64], nodes: usize },
    /// Half of the pairs, row by row, with or without the diagonal.
    Half { weights: &'f [f64], nodes: usize, upper: bool, diagonal: usize },
    /// Distances of coordinates.
    Plane(Plane),
}

/// Coordinates, and the distance of two of them, rounded as the file's kind of weights says.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    pub(super) at: Vec<[f64; 2]>,
    distance: fn([f64; 2], [f64; 2]) -> f64,
}

impl Plane {
    /// From a node to another, both from 0.
    pub(super) fn cost(&self, a: usize, b: usize) -> f64 {
        (self.distance)(self.at[a], self.at[b])
    }
}

/// The coordinates of a file's nodes.
pub(super) fn plane(file: &File, nodes: usize) -> Result<Plane, InstanceError> {
    match Source::of(file, nodes)? {
        Source::Plane(plane) => Ok(plane),
        _ => Err(InstanceError::whole("The nodes have no coordinates.".into())),
    }
}

impl<'f> Source<'f> {
    fn of(file: &'f File, nodes: usize) -> Result<Self, InstanceError> {
        let distance: fn([f64; 2], [f64; 2]) -> f64 = match file.word("EDGE_WEIGHT_TYPE").as_deref() {
            Some("EXPLICIT") => return Self::explicit(file, nodes),
            Some("EUC_2D") => |a, b| nearest(length(a, b)),
            Some("CEIL_2D") => |a, b| length(a, b).ceil(),
            Some("ATT") => pseudo_euclidean,
            Some("GEO") => geographical,
            _ => {
                let part = file.wanted("EDGE_WEIGHT_TYPE")?;
                let what = "EDGE_WEIGHT_TYPE has to be EXPLICIT, EUC_2D, CEIL_2D, ATT or GEO.";
                return Err(InstanceError::at(part.line, what.into()));
            }
        };
        let part = file.wanted("NODE_COORD_SECTION")?;
        let numbers = part.exactly(3 * nodes)?;
        let mut at = vec![None; nodes];
        for (k, row) in numbers.chunks_exact(3).enumerate() {
            let n = part.ordinal(3 * k, nodes)?;
            if at[n].replace([row[1], row[2]]).is_some() {
                let what = format!("Node {} has coordinates already.", n + 1);
                return Err(InstanceError::at(part.line_of(3 * k), what));
            }
        }
        Ok(Self::Plane(Plane { at: at.into_iter().flatten().collect(), distance }))
    }

    fn explicit(file: &'f File, nodes: usize) -> Result<Self, InstanceError> {
        let part = file.wanted("EDGE_WEIGHT_SECTION")?;
        let (upper, diagonal) = match file.word("EDGE_WEIGHT_FORMAT").as_deref() {
            Some("FULL_MATRIX") => {
                return Ok(Self::Full { weights: part.exactly(nodes * nodes)?, nodes });
            }
            // Columns of one half are the rows of the other.
            Some("UPPER_ROW" | "LOWER_COL") => (true, 0),
            Some("LOWER_ROW" | "UPPER_COL") => (false, 0),
            Some("UPPER_DIAG_ROW" | "LOWER_DIAG_COL") => (true, 1),
            Some("LOWER_DIAG_ROW" | "UPPER_DIAG_COL") => (false, 1),
            _ => {
                let format = file.wanted("EDGE_WEIGHT_FORMAT")?;
                let what = "EDGE_WEIGHT_FORMAT has to be FULL_MATRIX or one of UPPER_ROW, LOWER_ROW, \
                            UPPER_DIAG_ROW, LOWER_DIAG_ROW and their columns.";
                return Err(InstanceError::at(format.line, what.into()));
            }
        };
        let weights = part.exactly(nodes * (nodes - 1) / 2 + diagonal * nodes)?;
        Ok(Self::Half { weights, nodes, upper, diagonal })
    }

    /// From a node to another, both from 0.
    fn cost(&self, a: usize, b: usize) -> f64 {
        if a == b {
            return 0.0;
        }
        match self {
            Self::Full { weights, nodes } => weights[a * nodes + b],
            Self::Half { weights, nodes, upper, diagonal } => {
                let (low, high) = (a.min(b), a.max(b));
                weights[if *upper {
                    // Rows before this one are shorter by one each.
                    low * (nodes - 1 + diagonal) - low * low.saturating_sub(1) / 2 + high - low - 1 + diagonal
                } else {
                    high * (high - 1) / 2 + diagonal * high + low
                }]
            }
            Self::Plane(plane) => plane.cost(a, b),
        }
    }
}

fn length(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    (x * x + y * y).sqrt()
}

/// TSPLIB's nint: halves go up.
fn nearest(x: f64) -> f64 {
    (x + 0.5).floor()
}

/// ATT: the length over the root of ten, never rounded down.
fn pseudo_euclidean(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    let exact = ((x * x + y * y) / 10.0).sqrt();
    let near = nearest(exact);
    if near < exact { near + 1.0 } else { near }
}

/// GEO: coordinates are degrees and minutes, `DDD.MM`; kilometres on TSPLIB's sphere, with its value of pi.
fn geographical(a: [f64; 2], b: [f64; 2]) -> f64 {
    #[expect(clippy::approx_constant, reason = "TSPLIB's: with a better one lengths are not those published")]
    let radians = |x: f64| 3.141_592 * (x.trunc() + 5.0 * x.fract() / 3.0) / 180.0;
    let ([lat_a, lon_a], [lat_b, lon_b]) = (a.map(radians), b.map(radians));
    let (q1, q2, q3) = (math::cos(lon_a - lon_b), math::cos(lat_a - lat_b), math::cos(lat_a + lat_b));
    (6378.388 * math::acos(0.5 * ((1.0 + q1) * q2 - (1.0 - q1) * q3)) + 1.0).floor()
}
