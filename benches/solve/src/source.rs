//! The instances that the benches solve: those of the TSPLIB family, the variants of Qu & Du's 43 contours, and sheets.

use kerfway::geometry::DVec2;
use kerfway::job::{Job, LoadOptions, problem_of};
use kerfway::machine::{self, Profile};
use kerfway::problem::{self, Instance, Item, Node, Problem};
use kerfway::solve::Solution;
use kerfway::solve::papers::{self, Legs, Measure};
use kerfway::{plan, sheet::Sheet, solve};
use serde_json::Value;
use std::path::Path;

/// The machine of the seconds beside lengths: the papers' own are not given.
const MACHINE: &str = "co2-100w";

/// An instance, with the best known value.
pub struct Source {
    /// Name of the instance.
    pub name: String,
    /// The problem to solve.
    pub problem: Problem,
    /// Best value known.
    pub known: Option<f64>,
    /// Seconds of everything but air moves on [`MACHINE`], where the contours are known.
    pub cut_seconds: Option<f64>,
    kind: Kind,
}

enum Kind {
    Instance(Box<Instance>),
    Points,
    Sheet(Box<Sheet>),
}

impl Source {
    /// The instances in a file, with the best known values from the lists beside it.
    pub fn read(file: &str) -> Result<Vec<Self>, String> {
        let path = Path::new(file);
        let bytes = std::fs::read(path).map_err(|_| format!("{file} cannot be read."))?;
        let mut sources = Self::of(file, bytes)?;
        for source in &mut sources {
            source.known = source.known.or_else(|| known(path, &source.name));
            if let Kind::Points = source.kind {
                source.cut_seconds = cut_seconds(&path.with_extension("dxf"));
            }
        }
        Ok(sources)
    }

    /// The instances in the bytes of a file.
    pub fn of(file: &str, bytes: Vec<u8>) -> Result<Vec<Self>, String> {
        let path = Path::new(file);
        match path.extension().and_then(|e| e.to_str()) {
            Some("json") => variants(&serde_json::from_slice(&bytes).map_err(|e| e.to_string())?),
            Some("dxf") => {
                let sheet = sheet(path, bytes)?;
                let ruled = sheet.by_feature_points().into_iter();
                // The sheet is the first: benches name it by its index.
                Ok(std::iter::once(sheet).chain(ruled).collect())
            }
            _ => {
                let instance = problem::instance(&bytes).map_err(|e| format!("{file}: {e}"))?;
                let (name, problem) = (stem(path), instance.problem.clone());
                Ok(vec![Self {
                    name,
                    problem,
                    known: None,
                    cut_seconds: None,
                    kind: Kind::Instance(Box::new(instance)),
                }])
            }
        }
    }

    /// A sheet whose nodes are the feature points of Qu & Du, and whose path does not return.
    fn by_feature_points(&self) -> Option<Self> {
        let Kind::Sheet(_) = &self.kind else { return None };
        let mut problem = papers::with_feature_points(&self.problem);
        problem.closed = false;
        problem.items.iter_mut().for_each(|i| i.before = None);
        let name = format!("{}, feature points of the paper", self.name);
        Some(Self { name, problem, known: None, cut_seconds: None, kind: Kind::Points })
    }

    /// Plans a sheet for another machine; no value is known then. `at_ends`: contours are entered and left only where their
    /// elements end.
    pub fn on(&mut self, machine: &str, at_ends: bool) -> Result<(), String> {
        let Kind::Sheet(sheet) = &self.kind else {
            return Err(format!("{}: only drawings have a machine.", self.name));
        };
        self.problem = problem_of(sheet, &preset(machine)?);
        if at_ends {
            let ends = |contour: &kerfway::sheet::Contour| {
                let along = contour.path.segments.iter().scan(0.0, |s, e| {
                    *s += e.length();
                    Some((*s - e.length(), e.start()))
                });
                along.collect::<Vec<_>>()
            };
            self.problem.nodes.clear();
            for ((item, contour), id) in self.problem.items.iter_mut().zip(&sheet.contours).zip(0..) {
                let first = u32::try_from(self.problem.nodes.len()).map_err(|e| e.to_string())?;
                for ((along, entry), twin) in ends(contour).into_iter().zip(first..) {
                    self.problem.nodes.push(Node {
                        item: id,
                        entry,
                        exit: entry,
                        along,
                        reversed: false,
                        twin,
                    });
                }
                item.nodes = first..u32::try_from(self.problem.nodes.len()).map_err(|e| e.to_string())?;
                item.track = None;
            }
        }
        self.known = None;
        Ok(())
    }

    /// Seconds of the air moves of a solution on [`MACHINE`]; none where a table of costs is given.
    pub fn air_seconds(&self, solution: &Solution) -> Option<f64> {
        if self.problem.table().is_some() {
            return None;
        }
        let machine = Profile { return_home: self.problem.closed, ..machine::preset(MACHINE)? };
        let problem = Problem { machine, ..self.problem.clone() };
        let nodes: Vec<u32> = solution.stops.iter().map(|s| s.node).collect();
        Some(Legs::new(&problem, Measure::Seconds).tour_length(&nodes))
    }

    /// The tour of a solution in the node numbers of its file; none where there is no such file.
    pub fn tour(&self, solution: &Solution) -> Option<Vec<u32>> {
        let Kind::Instance(instance) = &self.kind else { return None };
        Some(instance.tour(solution.stops.iter().map(|s| s.node)))
    }

    /// The length of a solution, checked by code that shares nothing with the search.
    pub fn checked(&self, solution: &Solution) -> Result<f64, String> {
        match &self.kind {
            Kind::Instance(instance) => {
                let tour = instance.tour(solution.stops.iter().map(|s| s.node));
                problem::check(instance, &tour).map_err(|fault| fault.to_string())
            }
            Kind::Points => points_checked(&self.problem, solution),
            Kind::Sheet(sheet) => {
                let plan = plan::from_solution(sheet, &self.problem, solution);
                plan::check(sheet, &self.problem.machine, &plan).map_err(|v| format!("{v:?}"))?;
                Ok(plan.summary.air_length)
            }
        }
    }
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or(String::new(), |s| s.to_string_lossy().into_owned())
}

/// The best value known, from the list beside the file; PCGLNS's where that is lower than the list's best.
fn known(path: &Path, name: &str) -> Option<f64> {
    let beside = |list: &str| {
        let text = std::fs::read(path.parent()?.join(list)).ok()?;
        serde_json::from_slice::<Value>(&text).ok()
    };
    if let Some(list) = beside("best_known.json") {
        return list[name]["best"].as_f64();
    }
    let table = beside("../tsplib_table.json")?;
    table["instances"].as_array()?.iter().find(|row| row["name"] == name)?["optimal"].as_f64()
}

fn sheet(path: &Path, bytes: Vec<u8>) -> Result<Source, String> {
    let ignored =
        r#"{"layers":[{"name":"SHEET","operation":"ignore"},{"name":"MARK","operation":"ignore"}]}"#;
    let options: LoadOptions = serde_json::from_str(ignored).map_err(|e| e.to_string())?;
    let job = Job::load(bytes, "sheet", &options).map_err(|e| e.to_string())?;
    let sheet = Box::new(job.sheet().clone());
    let problem = problem_of(&sheet, &preset("length")?);
    let name = stem(path);
    let best = [
        ("sheet_100", 2737.496),
        ("sheet_500", 11814.876),
        ("sheet_2000", 35614.349),
        ("sheet_10000", 83950.522),
    ];
    let known = best.iter().find(|b| b.0 == name).map(|b| b.1);
    Ok(Source { name, problem, known, cut_seconds: None, kind: Kind::Sheet(sheet) })
}

fn preset(name: &str) -> Result<Profile, String> {
    machine::preset(name).ok_or_else(|| format!("There is no machine {name}."))
}

/// Lengths of the 43 contours of Qu & Du (`benches/data/README.md`, table of optima), by machine, whether the tour is closed,
/// and whether cuts start on the boundary only and holes come first.
const QU_DU: [(&str, bool, bool, f64); 8] = [
    ("length", false, false, 2545.445),
    ("length", true, false, 2819.222),
    ("length", false, true, 2550.624),
    ("length", true, true, 2821.939),
    ("length-chebyshev", false, false, 2205.600),
    ("length-chebyshev", true, false, 2448.600),
    ("length-chebyshev", false, true, 2214.500),
    ("length-chebyshev", true, true, 2460.600),
];

fn variants(data: &Value) -> Result<Vec<Source>, String> {
    QU_DU
        .iter()
        .map(|&(machine, closed, boundary, value)| {
            let mut profile = preset(machine)?;
            profile.return_home = closed;
            let problem = points(data, profile, boundary).ok_or("The contours are not as expected.")?;
            let way = if closed { "closed" } else { "open" };
            let which = if boundary { "boundary" } else { "paper" };
            let name =
                format!("qu-du {} {way} {which}", if machine == "length" { "euclid" } else { "chebyshev" });
            // The table gives three decimals.
            Ok(Source { name, problem, known: Some(value + 0.0005), cut_seconds: None, kind: Kind::Points })
        })
        .collect()
}

/// Seconds of everything but air moves of a drawing on [`MACHINE`]; they are the same for every path.
fn cut_seconds(drawing: &Path) -> Option<f64> {
    let job = Job::load(std::fs::read(drawing).ok()?, "drawing", &LoadOptions::default()).ok()?;
    let machine = machine::preset(MACHINE)?;
    let problem = problem_of(job.sheet(), &machine);
    let greedy = solve::method("greedy")?.start(&problem, 1, None);
    let summary = plan::from_solution(job.sheet(), &problem, greedy.best()).summary;
    Some(summary.total_time - summary.air_time)
}

/// Contours entered at their feature points only.
fn points(data: &Value, machine: Profile, boundary: bool) -> Option<Problem> {
    let contours = data["contours"].as_array()?;
    let (mut items, mut nodes): (Vec<Item>, Vec<Node>) = (Vec::new(), Vec::new());
    for (contour, item) in contours.iter().zip(0..) {
        let first = u32::try_from(nodes.len()).ok()?;
        for point in contour["points"].as_array()? {
            if boundary && point["on_boundary"] == false {
                continue;
            }
            let entry = DVec2::new(point["x"].as_f64()?, point["y"].as_f64()?);
            let twin = u32::try_from(nodes.len()).ok()?;
            nodes.push(Node { item, entry, exit: entry, along: 0.0, reversed: false, twin });
        }
        let outer = contours.iter().position(|c| c["id"] == contour["parent"]).filter(|_| boundary);
        let before = outer.and_then(|o| u32::try_from(o).ok());
        items.push(Item { nodes: first..u32::try_from(nodes.len()).ok()?, before, ..Item::default() });
    }
    let (home, closed) = (DVec2::ZERO, machine.return_home);
    Some(Problem { items, nodes, home, closed, ..Problem::empty(machine) })
}

fn points_checked(problem: &Problem, solution: &Solution) -> Result<f64, String> {
    let nodes: Vec<&Node> = solution.stops.iter().map(|s| &problem.nodes[s.node as usize]).collect();
    let place = |item: u32| nodes.iter().position(|n| n.item == item);
    for (item, id) in problem.items.iter().zip(0..) {
        let late = item.before.is_some_and(|outer| place(outer) < place(id));
        if late || nodes.iter().filter(|n| n.item == id).count() != 1 {
            return Err(format!("Contour {} is cut too late or not once.", id + 1));
        }
    }
    let end = problem.closed.then_some(problem.home);
    let way: Vec<DVec2> =
        [problem.home].into_iter().chain(nodes.iter().map(|n| n.entry)).chain(end).collect();
    let chebyshev = problem.machine.name == "length-chebyshev";
    Ok(way
        .windows(2)
        .map(|w| (w[1] - w[0]).abs())
        .map(|d| if chebyshev { d.max_element() } else { d.length() })
        .sum())
}
