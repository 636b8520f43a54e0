//! Sheets of contours that may be left at no cost.

use super::super::model::Model;
use crate::problem::Problem;
use crate::solve::papers::{Legs, Measure, test_sheet};
use crate::solve::rng::{Draw, Rng};

/// Closed contours with these corners, which may be left at no cost; a closed path returns to (0, 0).
pub(super) fn sheet(contours: &[&[[f64; 2]]], closed: bool) -> Problem {
    Problem { closed, ..test_sheet::sheet(contours, Some(0.0), "length-partial") }
}

pub(super) fn random_sheet(contours: usize, closed: bool, rng: &mut Rng) -> Problem {
    let mut place = || [rng.uniform() * 100.0, rng.uniform() * 100.0];
    let corners: Vec<Vec<[f64; 2]>> =
        (0..contours).map(|c| (0..2 + c % 5).map(|_| place()).collect()).collect();
    sheet(&corners.iter().map(Vec::as_slice).collect::<Vec<_>>(), closed)
}

pub(super) fn model(problem: &Problem) -> Model<'_> {
    Model::new(Legs::new(problem, Measure::Euclidean), false)
}
