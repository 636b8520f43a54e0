//! What a solver of pierce groups sees: the net of each group, and the machine that cuts it.
//!
//! It is to `solve::pierce_group` what [`Problem`](super::Problem) is to the other solvers. Building the problem of a
//! sheet takes both steps: [`group_problems`] makes these, the solver finds the paths through each group, and
//! [`from_sheet`](super::from_sheet) takes the paths.

use super::beside::{Beside, beside};
use crate::geometry::{DVec2, Path};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::sheet::{CommonCuts, PierceGroup, Sheet};

/// The pierce groups of a sheet that a machine cuts as one.
#[derive(Clone, Debug)]
pub struct GroupProblems<'m> {
    /// The machine whose seconds count.
    pub machine: &'m Profile,
    /// How the paths are to be found.
    pub method: GroupMethod,
    /// There is one group and nothing else to cut: the head comes from home and goes back there.
    pub is_all: bool,
    /// The paths begin beside the area around the group, if they can: there is room for a lead.
    pub from_outside: bool,
    /// The groups.
    pub groups: Vec<GroupProblem>,
}

/// How the paths through groups are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroupMethod {
    /// The best paths we can find.
    Best,
    /// The element insertion heuristic of Dewil et al., and the best paths where it finds none.
    Insertion,
}

/// One pierce group as a planar net: nodes, the elements between them, and the areas that the elements separate.
#[derive(Clone, Debug)]
pub struct GroupProblem {
    /// Where elements end, mm.
    pub nodes: Vec<DVec2>,
    /// The stretches of contours that are cut, each once.
    pub elements: Vec<Element>,
    /// Number of areas; area 0 is the one around the group.
    pub faces: u32,
    /// Contours near the group for which it may be left.
    pub beside: Vec<Beside>,
}

/// A stretch of a contour between two nodes.
#[derive(Clone, Debug)]
pub struct Element {
    /// The contour it is a stretch of.
    pub contour: u32,
    /// Arc length on the contour's path in the group where the stretch begins, mm.
    pub from: f64,
    /// Arc length on the contour's path in the group where the stretch ends, mm.
    pub to: f64,
    /// The nodes at which it begins and ends.
    pub ends: [u32; 2],
    /// The areas to its left and right.
    pub faces: [u32; 2],
    /// Its geometry from beginning to end.
    pub path: Path,
}

/// The groups of a sheet as a solver of groups sees them: none for a machine that makes no pre-cuts, as it cuts every
/// contour by itself.
pub fn group_problems<'m>(sheet: &Sheet, machine: &'m Profile) -> GroupProblems<'m> {
    let groups = sheet.cut_as_one(machine.cuts_as_one());
    let worked = sheet.contours.iter().filter(|c| c.is_processed()).count();
    let beside = beside(sheet, machine, groups);
    GroupProblems {
        machine,
        method: match sheet.common_cuts {
            CommonCuts::Insertion => GroupMethod::Insertion,
            CommonCuts::Best | CommonCuts::Off => GroupMethod::Best,
        },
        from_outside: PLANS_ALL_LEVERS && !machine.makes_pre_cuts() && sheet.asks_for_leads(machine),
        is_all: matches!(groups, [only] if only.contours.len() == worked),
        groups: groups.iter().zip(beside).map(|(g, beside)| group_problem(g, beside)).collect(),
    }
}

fn group_problem(group: &PierceGroup, beside: Vec<Beside>) -> GroupProblem {
    let elements = group.elements.iter().map(|e| Element {
        contour: e.contour,
        from: e.from,
        to: e.to,
        ends: e.ends,
        faces: e.faces,
        path: group.path(e),
    });
    GroupProblem { nodes: group.nodes.clone(), elements: elements.collect(), faces: group.faces, beside }
}
