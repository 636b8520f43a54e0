//! Skeleton cuts and the remainder of the sheet: values by hand, what the checker says of wrong plans, and a replay by Shapely.
#![allow(clippy::unwrap_used, reason = "tests stop where they cannot go on")]

mod checker;
mod replay;
mod starts;
mod values;

use kerfway::job::{Job, LayerChoice, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::{Profile, Skeleton, preset};
use kerfway::plan::{Move, Plan};
use kerfway::sheet::Operation;

fn rectangle(layer: &str, [x0, y0, x1, y1]: [f64; 4]) -> String {
    let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)];
    let points: String = corners.iter().map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).collect();
    format!("0\nLWPOLYLINE\n8\n{layer}\n90\n4\n70\n1\n{points}")
}

fn circle([x, y, r]: [f64; 3]) -> String {
    format!("0\nCIRCLE\n8\nCUT\n10\n{x}\n20\n{y}\n40\n{r}\n")
}

fn drawing(entities: &[String]) -> Vec<u8> {
    let entities = entities.concat();
    format!("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n")
        .into_bytes()
}

/// A square with a hole, and a disk, on a sheet of 300 x 200 mm whose outline is drawn.
fn square_and_disk() -> Vec<u8> {
    let square = [rectangle("CUT", [20.0, 20.0, 80.0, 80.0]), circle([50.0, 50.0, 20.0])];
    let sheet = rectangle("PLATE", [0.0, 0.0, 300.0, 200.0]);
    drawing(&[square.concat(), circle([150.0, 100.0, 30.0]), sheet])
}

fn grid(x: f64, y: f64) -> Skeleton {
    Skeleton { spacing_x: Some(x), spacing_y: Some(y), ..Skeleton::default() }
}

fn with(skeleton: Skeleton) -> Profile {
    Profile { skeleton: Some(skeleton), bed: None, ..preset("fibre-3kw-thin").unwrap() }
}

/// A job of a drawing whose layer PLATE is not cut, or why it cannot be planned.
fn started(bytes: Vec<u8>, machine: Profile) -> Result<Job, String> {
    let load =
        LoadOptions { layers: vec![LayerChoice::new("PLATE", Operation::Ignore)], ..LoadOptions::default() };
    let mut job = Job::load(bytes, "sheet.dxf", &load).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, seed: 1, moves: Some(20_000), ..PlanOptions::default() })
        .map_err(|e| e.to_string())?;
    job.run_mut().unwrap().step(20_000);
    Ok(job)
}

/// The skeleton cuts of a plan in their order: x and y of both ends.
fn cuts(job: &Job, plan: &Plan) -> Vec<[f64; 4]> {
    let ends = plan.moves.iter().filter_map(|m| {
        let Move::Cut { contour, path, .. } = m else { return None };
        let is_skeleton = job.beam_sheet().contours[*contour as usize].skeleton;
        let (a, b) = (path.first()?.start(), path.last()?.end());
        is_skeleton.then_some([a.x, a.y, b.x, b.y])
    });
    ends.collect()
}

/// The same cuts, each from its lower or left end, sorted.
fn lines(job: &Job, plan: &Plan) -> Vec<[f64; 4]> {
    let forwards = |[a, b, c, d]: [f64; 4]| if (a, b) <= (c, d) { [a, b, c, d] } else { [c, d, a, b] };
    let mut lines: Vec<_> = cuts(job, plan).into_iter().map(forwards).collect();
    lines.sort_by(|a, b| a.partial_cmp(b).unwrap());
    lines
}

#[track_caller]
fn assert_lines(found: &[[f64; 4]], asked: &[[f64; 4]]) {
    let near = |(a, b): (&[f64; 4], &[f64; 4])| a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-4);
    assert!(found.len() == asked.len() && found.iter().zip(asked).all(near), "{found:?} is not {asked:?}");
}
