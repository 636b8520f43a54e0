//! What a program should do: what the plan says, or what the header of the file itself says.

use super::super::super::cuts::cuts;
use super::words::number;
use crate::geometry::Segment;
use crate::plan::{Move, Plan};

/// What a program should do. A figure that is not known is not compared.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Expected {
    /// Whether Kerfway wrote the program, and so keeps its own stricter rules: power 0 on every rapid, no cut without
    /// power, no waits but those of the machine.
    pub(super) by_kerfway: bool,
    /// Whether it may leave the bed: that of a plan has been decided before.
    pub(super) may_leave_bed: bool,
    /// Number of contours, as the header counts them.
    pub(super) contours: Option<u32>,
    /// Number of stretches that are cut, each with its own comment.
    pub(super) stretches: Option<u32>,
    /// Number of piercings.
    pub(super) pierces: Option<u32>,
    /// Number of moves with the head lifted.
    pub(super) lifts: Option<u32>,
    /// Length of cuts, mm.
    pub(super) cut_length: Option<f64>,
    /// Length that flying joints leave dark, and that between cuts on the run, mm.
    pub(super) dark_length: f64,
    /// Box of everything cut: xmin, ymin, xmax, ymax, mm.
    pub(super) bounds: Option<[f64; 4]>,
    /// Seconds of the whole job.
    pub(super) seconds: Option<f64>,
    /// Seconds among them that are charged for pre-cuts.
    pub(super) pre_cut_seconds: Option<f64>,
    /// Number of cuts through waste.
    pub(super) chains: u32,
    /// How exactly lengths are given, mm.
    pub(super) precision: f64,
}

impl Expected {
    /// What a plan says.
    pub(super) fn of_plan(plan: &Plan) -> Self {
        let ahead: f64 = plan
            .moves
            .iter()
            .map(|m| match m {
                Move::PreCut { ahead, .. } => ahead.iter().map(Segment::length).sum(),
                _ => 0.0,
            })
            .sum();
        let flying = |m: &Move| match m {
            Move::Joint { path, flying: true, .. } | Move::Fly { path } => {
                path.iter().map(Segment::length).sum()
            }
            _ => 0.0,
        };
        let sums = &plan.summary;
        Self {
            by_kerfway: true,
            may_leave_bed: true,
            contours: Some(sums.contours),
            stretches: Some(count_of(plan)),
            pierces: Some(sums.pierces),
            lifts: Some(sums.lifts),
            cut_length: Some(sums.cut_length + ahead),
            dark_length: plan.moves.iter().map(flying).sum(),
            bounds: (sums.contours > 0).then_some(sums.bounds),
            // What is cut in advance takes its own time, and the plan charges a time of the profile instead.
            seconds: (ahead <= 0.0).then_some(sums.total_time),
            pre_cut_seconds: Some(sums.pre_cut_time),
            chains: sums.chains,
            precision: 0.0,
        }
    }

    /// What the comments of a file say. Lines that are not Kerfway's say nothing.
    pub(super) fn of_comments(comments: &[String]) -> Self {
        let mut e = Self { precision: 0.05, ..Self::default() };
        e.by_kerfway = comments.first().is_some_and(|c| c.starts_with("Kerfway "));
        if !e.by_kerfway {
            return e;
        }
        for comment in comments {
            let numbers = numbers(comment);
            if DARK.iter().any(|dark| comment.starts_with(dark)) {
                e.dark_length += numbers.last().unwrap_or(&0.0);
                continue;
            }
            e.chains += u32::from(WASTE.iter().any(|waste| comment.starts_with(waste)));
            match (words(comment).as_slice(), numbers.as_slice()) {
                (["contours", "pierces"], &[contours, pierces]) => {
                    (e.contours, e.pierces) = (Some(count(contours)), Some(count(pierces)));
                }
                (["cut", "mm", "air", "mm"], &[cut, _]) => e.cut_length = Some(cut),
                (["time", "about", "s"], &[seconds]) => e.seconds = Some(seconds),
                (["x", "to", "y", "to"] | ["x", "to", "y", "to", "mm"], &[x0, x1, y0, y1]) => {
                    e.bounds = Some([x0, y0, x1, y1]);
                }
                (_, &[_, all, ..]) if announces(comment) => e.stretches = Some(count(all)),
                _ => {}
            }
        }
        // What is cut in advance for a pre-cut is not in the header, neither its length nor its time.
        let ahead = comments.iter().filter(|c| c.starts_with("pre-cut ")).count();
        if ahead > 0 {
            (e.cut_length, e.seconds) = (None, None);
            e.stretches = e.stretches.map(|n| n.saturating_add(u32::try_from(ahead).unwrap_or(u32::MAX)));
        }
        e
    }
}

/// How the comments at a flying joint and between two cuts on the run begin.
const DARK: [&str; 2] = ["flying joint ", "on the run: "];

/// How the comments at a cut through waste begin: after a cut, and after a move with the beam off.
const WASTE: [&str; 2] = ["through waste for ", "from a kerf or an edge through waste for "];

/// Number of cuts of a plan, those ahead of a pre-cut included.
fn count_of(plan: &Plan) -> u32 {
    let ahead = plan.moves.iter().filter(|m| m.cuts_ahead()).count();
    u32::try_from(cuts(plan).len() + ahead).unwrap_or(u32::MAX)
}

/// Whether a comment is `3 of 7: cut contour 5, layer 0`.
fn announces(comment: &str) -> bool {
    let before = comment.split_once(" contour ").and_then(|(before, _)| before.split_once(" of "));
    before.is_some_and(|(n, _)| n.parse::<u32>().is_ok())
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn count(n: f64) -> u32 {
    n as u32
}

/// The words of a comment without its numbers and punctuation.
fn words(comment: &str) -> Vec<&str> {
    let trimmed = comment.split(' ').map(|w| w.trim_matches([',', ':']));
    trimmed.filter(|w| !w.is_empty() && number(w).is_none()).collect()
}

fn numbers(comment: &str) -> Vec<f64> {
    comment.split(' ').filter_map(|w| number(w.trim_matches([',', ':']))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_header_of_a_file_says_what_it_should_do() {
        let lines = [
            "Kerfway 0.1.0, plate.dxf",
            "3 contours, 2 pierces",
            "cut 195.7 mm, air 70.7 mm",
            "time: about 12.5 s",
            "unit: mm",
            "x 10 to 50, y -1.5 to 40",
            "1 of 3: mark contour 0, layer 5 of 9",
        ];
        let lines = lines.map(str::to_owned);
        let e = Expected::of_comments(&lines);
        assert_eq!((e.contours, e.pierces, e.stretches), (Some(3), Some(2), Some(3)));
        assert_eq!((e.cut_length, e.seconds), (Some(195.7), Some(12.5)));
        assert_eq!(e.bounds, Some([10.0, -1.5, 50.0, 40.0]));
        assert_eq!(Expected::of_comments(&["LightBurn 1.4".to_owned()]).contours, None);
    }
}
