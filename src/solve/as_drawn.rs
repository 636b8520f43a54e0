//! The path "as drawn": contours in the order of the file, each from its first point. What a controller without
//! any planning does, for comparison; it may cut a part free before its holes and marks.

use super::traits::{Solution, Stop};
use crate::order::sort_by;
use crate::problem::Problem;
use crate::sheet::Sheet;

/// Contours in drawing order, each from its first node. A baseline: it heeds neither precedence nor rank.
pub fn drawing_order(sheet: &Sheet, problem: &Problem) -> Solution {
    let mut order: Vec<_> = sheet.contours.iter().zip(&problem.items).collect();
    sort_by(&mut order, |(contour, _)| [contour.first_shape.into(), 0, 0]);
    Solution::new(
        problem,
        order
            .into_iter()
            .filter_map(|(_, item)| Some(Stop::at(problem, item.nodes.clone().next()?)))
            .collect(),
    )
}
