//! Data flows one way: which folder of `src` may use which, and no circles between files. CONTRIBUTING.md, "Rules", lists them.

mod sources;
mod tokens;

use sources::{Arrow, Files, arrows};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// What everything from the readers on may use, from the bottom up: each of these may use those before it.
const GROUND: &[&str] = &["order", "number", "letters", "geometry", "finding", "fields"];

/// Folders and files of `src`, from the ground up, each with those it may use in addition to itself and [`GROUND`]. The row with
/// the longest name that fits a file applies to it.
const ALLOWED: &[(&str, &[&str])] = &[
    ("order", &[]),
    ("number", &[]),
    ("letters", &[]),
    ("geometry", &[]),
    ("finding", &[]),
    ("fields", &[]),
    ("drawing", &[]),
    ("dxf", &["drawing"]),
    ("svg", &["drawing"]),
    ("machine", &[]),
    ("sheet", &["drawing", "machine"]),
    ("lead", &["machine", "sheet"]),
    ("joint", &["machine", "sheet", "lead"]),
    ("corner", &["machine", "sheet", "lead"]),
    ("tipping", &["machine"]),
    ("heat", &["machine"]),
    ("problem", &["machine", "sheet", "lead", "joint", "corner", "tipping", "heat"]),
    // Solvers know no drawing: neither `drawing` nor `sheet`.
    ("solve", &["machine", "problem", "tipping", "heat"]),
    // The plan model knows neither how a plan was found nor who checks it.
    ("plan/model", &["drawing", "machine", "sheet"]),
    ("plan/document", &["drawing", "machine", "sheet", "plan/model"]),
    (
        "plan",
        &["drawing", "machine", "sheet", "lead", "joint", "corner", "problem", "solve", "tipping", "heat"],
    ),
    // Output and quote know no solver.
    ("output", &["drawing", "machine", "sheet", "plan"]),
    ("calibration", &["machine", "sheet", "plan"]),
    ("quote", &["drawing", "machine", "sheet", "plan", "output"]),
    (
        "job",
        &[
            "drawing", "dxf", "svg", "machine", "sheet", "lead", "joint", "corner", "problem", "solve",
            "plan", "output", "quote",
        ],
    ),
    (
        "typescript",
        &["calibration", "drawing", "machine", "sheet", "plan", "output", "solve", "quote", "job"],
    ),
    (
        "wasm",
        &["calibration", "drawing", "machine", "sheet", "problem", "solve", "plan", "output", "quote", "job"],
    ),
];

/// The row of [`ALLOWED`] that a file belongs to.
fn layer(file: &str) -> Option<&'static str> {
    let is_in = |name: &str| file.strip_prefix(name).is_some_and(|rest| rest.starts_with(['/', '.']));
    ALLOWED.iter().map(|row| row.0).filter(|name| is_in(name)).max_by_key(|name| name.len())
}

fn is_allowed(from: &str, to: &str) -> bool {
    let inside =
        |name: &str, row: &str| name == row || name.strip_prefix(row).is_some_and(|r| r.starts_with('/'));
    if let Some(place) = GROUND.iter().position(|name| *name == from) {
        return GROUND[..=place].contains(&to);
    }
    let row = ALLOWED.iter().find(|row| row.0 == from).map_or(&[][..], |row| row.1);
    inside(to, from) || GROUND.contains(&to) || row.iter().any(|name| inside(to, name))
}

/// The faults of a crate's dependencies, one line each.
fn faults(files: &Files) -> Vec<String> {
    let arrows = arrows(files);
    let mut faults = Vec::new();
    for Arrow { from, to, name } in arrows.iter().filter(|a| a.from != "lib.rs") {
        match (layer(from), layer(to)) {
            (Some(a), Some(b)) if is_allowed(a, b) => {}
            (Some(a), Some(b)) => faults.push(format!("{from} uses {name}: {a} may not use {b}.")),
            (None, _) => faults.push(format!("{from} is in no row of the table of this test.")),
            (_, None) => {
                faults.push(format!("{from} uses {name}, which is in no row of the table of this test."))
            }
        }
    }
    faults.extend(circles(&arrows).into_iter().map(|c| format!("A circle of files: {}.", c.join(" -> "))));
    faults
}

/// The shortest circle through each file that is on one, each circle once.
fn circles(arrows: &[Arrow]) -> BTreeSet<Vec<&str>> {
    let mut next: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for a in arrows {
        next.entry(&a.from).or_default().insert(&a.to);
    }
    let none = BTreeSet::new();
    let back_to = |start| {
        let mut from: BTreeMap<&str, &str> = BTreeMap::new();
        let mut wave = vec![start];
        while !wave.is_empty() && !from.contains_key(start) {
            let ahead: Vec<(&str, &str)> = wave
                .iter()
                .flat_map(|&f| next.get(f).unwrap_or(&none).iter().map(move |&t| (f, t)))
                .collect();
            wave.clear();
            for (f, t) in ahead {
                from.entry(t).or_insert_with(|| {
                    wave.push(t);
                    f
                });
            }
        }
        let mut circle = vec![*from.get(start)?];
        while circle[0] != start {
            circle.insert(0, from[circle[0]]);
        }
        let least = (0..circle.len()).min_by_key(|&k| circle[k])?;
        circle.rotate_left(least);
        Some(circle)
    };
    next.keys().filter_map(|&start| back_to(start)).collect()
}

fn read_all(folder: &Path, root: &Path, files: &mut Files) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            read_all(&path, root, files);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let name = path.strip_prefix(root).unwrap().to_str().unwrap().replace('\\', "/");
            files.insert(name, std::fs::read_to_string(&path).unwrap());
        }
    }
}

#[test]
fn every_dependency_points_down_and_there_are_no_cycles() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Files::new();
    read_all(&root, &root, &mut files);
    assert!(files.len() > 200, "{} files", files.len());
    let found = faults(&files);
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}

/// The faults of a made-up crate.
fn faults_of(files: &[(&str, &str)]) -> Vec<String> {
    faults(&files.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect())
}

const SHEET: (&str, &str) = ("sheet/mod.rs", "mod model;\npub use model::Sheet;");
const MODEL: (&str, &str) = ("sheet/model.rs", "pub struct Sheet;");
const LIB: (&str, &str) =
    ("lib.rs", "pub mod sheet;\npub mod solve;\npub mod output;\npub mod geometry;\npub mod machine;");

#[test]
fn a_solver_that_uses_the_drawing_is_found() {
    let wrong = [
        "use crate::sheet::Sheet;",
        "use crate::{sheet::Sheet as Drawing};",
        "fn f(_: &crate::sheet::Sheet) {}",
        "use super::sheet;\nfn f(_: &sheet::Sheet) {}",
        "mod inner { use super::super::sheet::*; }",
        "#[cfg(test)]\nmod tests { use crate::sheet::Sheet; }",
    ];
    for text in wrong {
        let found = faults_of(&[LIB, SHEET, MODEL, ("solve.rs", text)]);
        assert!(!found.is_empty(), "{text}");
        for fault in found {
            assert!(fault.starts_with("solve.rs uses sheet"), "{fault}");
            assert!(fault.ends_with("solve may not use sheet."), "{fault}");
        }
    }
}

#[test]
fn text_that_is_no_dependency_is_not_found() {
    let right = [
        "// crate::sheet::Sheet",
        "/// [`Sheet`](crate::sheet::Sheet)\nfn f() {}",
        "const A: &str = \"use crate::sheet::Sheet;\";",
        "const A: &str = r#\"a \" crate::sheet::Sheet\"#;\nconst B: char = '\"';\nfn f<'a>(_: &'a str) {}",
        "pub(in crate::solve) fn f() {}\nuse std::collections::BTreeMap;",
        "use crate::machine::Profile;",
    ];
    for text in right {
        let machine = ("machine.rs", "pub struct Profile;");
        assert_eq!(faults_of(&[LIB, SHEET, MODEL, machine, ("solve.rs", text)]), [""; 0], "{text}");
    }
    let solver = ("solve.rs", "pub struct Solution;");
    let found = faults_of(&[LIB, solver, ("output.rs", "use crate::solve::Solution;")]);
    assert_eq!(found, ["output.rs uses solve::Solution: output may not use solve."]);
    let machine = ("machine.rs", "pub struct Profile;");
    let found = faults_of(&[LIB, machine, ("geometry.rs", "use crate::machine::Profile;")]);
    assert_eq!(found, ["geometry.rs uses machine::Profile: geometry may not use machine."]);
}

#[test]
fn a_circle_between_files_is_found() {
    let a = ("sheet/a.rs", "use super::b::B;\npub struct A;");
    let b = ("sheet/b.rs", "use super::A;\npub struct B;");
    let facade = ("sheet/mod.rs", "mod a;\nmod b;\npub use a::A;");
    let found = faults_of(&[LIB, facade, a, b]);
    assert_eq!(found, ["A circle of files: sheet/a.rs -> sheet/b.rs."]);
    // The facade only names what others define.
    let third = ("sheet/b.rs", "pub struct B;");
    assert_eq!(faults_of(&[LIB, facade, a, third]), [""; 0]);
}
