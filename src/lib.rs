//! Kerfway plans the path of a laser cutter: it reads a DXF or SVG drawing and finds the order, entry points and directions
//! in which the machine cuts the sheet in the least time.
//!
//! # The flow
//!
//! ```text
//! bytes -> drawing -> contours, parts -> problem -> search -> plan -> output, quote
//!          dxf, svg   sheet              problem    solve     plan    output  quote
//! ```
//!
//! 1. [`dxf`] or [`svg`] reads a file into a [`drawing`]: lines and arcs in millimetres. Everything unusual in the file
//!    becomes a [`finding`].
//! 2. [`sheet`] joins the elements to contours, removes duplicates, finds which contour lies inside which, and offsets the
//!    cuts by half the kerf.
//! 3. [`problem`] states what a search works on: items with entry nodes, travel times on a [`machine`], and precedence.
//! 4. [`solve`] searches for the fastest path. Every method implements [`solve::Solver`].
//! 5. [`plan`] converts a path to moves with times, and checks them with code that is independent of the search.
//! 6. [`output`] writes programs for machines, drawings and the plan itself; [`quote`] reports what a price depends on.
//!
//! Before the problem is stated, [`lead`], [`joint`], [`corner`], [`tipping`] and [`heat`] decide about single contours and pieces, and
//! [`calibration`] fits a machine to times that were measured.
//!
//! [`job`] runs one drawing through the whole flow, and the WebAssembly bindings are a thin layer over it. Data flows in
//! this direction only: [`geometry`] knows no machine, searches know no drawing, and writers know no search.
//!
//! # Units
//!
//! Lengths are in millimetres, areas in mm², times in seconds and angles in radians, counter-clockwise positive. Speeds and
//! accelerations are in mm/s and mm/s².
//!
//! # Reproducible by design
//!
//! A search is run in slices of *moves* (candidate changes that it prices), and the same drawing, options, seed and number
//! of moves give the same bytes natively and in every browser, however the moves are sliced. The crate reads no clock and
//! draws no numbers from the system: callers decide how long to search.
//!
//! # Example: from a drawing to G-code
//!
//! ```
//! use kerfway::job::{Job, LoadOptions, OutputKind, PlanOptions, SliceEnd};
//!
//! // A circle with a diameter of 20 mm, and a slot next to it.
//! let dxf = "0\nSECTION\n2\nENTITIES\n\
//!            0\nCIRCLE\n8\nCUT\n10\n15\n20\n15\n40\n10\n\
//!            0\nLWPOLYLINE\n8\nCUT\n90\n4\n70\n1\n10\n40\n20\n5\n10\n60\n20\n5\n10\n60\n20\n25\n10\n40\n20\n25\n\
//!            0\nENDSEC\n0\nEOF\n";
//!
//! let mut job = Job::load(dxf.into(), "two.dxf", &LoadOptions::default())?;
//! // Without a machine in the options, the first CO2 preset is used.
//! job.start(&PlanOptions { seed: 1, moves: Some(20_000), ..PlanOptions::default() })?;
//! while job.run_mut()?.step(5_000).end == SliceEnd::Running {
//!     // Report the progress here, or stop at any time: there is always a plan.
//! }
//! let gcode = job.output(OutputKind::Gcode)?;
//! assert!(gcode.contains("G1"));
//! # Ok::<(), kerfway::job::JobError>(())
//! ```
//!
//! # Example: what a drawing contains and how long it takes
//!
//! ```
//! use kerfway::job::{Job, LoadOptions, PlanOptions};
//!
//! // A square with a side of 50 mm and a hole in its middle; the file does not state its units.
//! let dxf = "0\nSECTION\n2\nENTITIES\n\
//!            0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n50\n20\n0\n10\n50\n20\n50\n10\n0\n20\n50\n\
//!            0\nCIRCLE\n8\n0\n10\n25\n20\n25\n40\n5\n\
//!            0\nENDSEC\n0\nEOF\n";
//!
//! let mut job = Job::load(dxf.into(), "plate.dxf", &LoadOptions::default())?;
//! let report = job.report();
//! assert_eq!((report.contours.len(), report.parts.len()), (2, 1));
//! assert_eq!(report.contours[1].inside, Some(0));
//! assert!(report.findings.iter().any(|f| f.message.contains("units")));
//!
//! job.start(&PlanOptions { moves: Some(10_000), ..PlanOptions::default() })?;
//! job.run_mut()?.step(10_000);
//! let summary = job.plan()?.summary;
//! assert_eq!(summary.pierces, 2);
//! assert!((summary.cut_length - (200.0 + 10.0 * std::f64::consts::PI)).abs() < 1e-6);
//! # Ok::<(), kerfway::job::JobError>(())
//! ```
//!
//! # Features
//!
//! * `planner` (default): the WebAssembly bindings of everything that planning a job needs.
//! * `outputs`: those of the writers of programs and drawings and of the preflight. They are a WebAssembly file of their own, because
//!   nobody needs them before there is a plan.
//! * `svg` (default, part of `research`): the reader of SVG ([`svg`]).
//! * `research` (default): the methods of published papers ([`solve::papers`]), benchmark instances of the TSPLIB family,
//!   proofs of the bound, and the levers that few jobs need. The page downloads a second WebAssembly file with this
//!   feature, and with the reader of SVG, only when one of them is asked for or an SVG file is opened.
//! * `png`: the PNG renderer, which depends on tiny-skia. It is a WebAssembly file of its own, because most jobs never
//!   need it.

pub mod calibration;
pub mod corner;
pub mod geometry;

pub mod drawing;
pub mod dxf;
pub mod fields;
pub mod finding;
pub mod heat;
pub mod job;
pub mod joint;
pub mod lead;
mod letters;
pub mod machine;
mod number;
mod order;
pub mod output;
pub mod plan;
pub mod problem;
pub mod quote;
pub mod sheet;
pub mod solve;
pub mod svg;
pub mod tipping;
#[cfg(all(test, not(target_arch = "wasm32")))]
mod typescript;

#[cfg(target_arch = "wasm32")]
pub mod wasm;
