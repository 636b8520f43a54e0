//! All native integration tests in one binary, a module for each subject; what they share is in `tests/testkit`.
#![cfg(not(target_arch = "wasm32"))]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "../testkit/mod.rs"]
mod testkit;

mod bed;
mod boundary;
mod boundary_any;
mod calibration;
mod common_cuts;
mod common_cuts_exact;
mod common_cuts_grids;
mod dialects;
mod dxf_blocks;
mod dxf_curves;
mod dxf_entities;
mod dxf_files;
mod dxf_units;
mod exclude;
mod features_too_small;
mod geometry_curves;
mod geometry_meet;
mod geometry_shapes;
mod golden;
mod groups_left;
mod inspect_dev;
mod inspect_promises;
mod instance_read;
mod instance_solve;
mod joints;
mod kerf;
mod kerf_drawings;
mod layering;
mod layers_written;
mod leads;
mod lower_bound;
mod machine_time;
mod metamorphic_intake;
mod moving_pierce;
mod mutation_dxf;
mod mutation_hostile;
mod oracle_ezdxf;
mod order_options;
mod output_dxf;
mod output_far;
mod output_gcode;
mod output_json;
mod output_png;
mod output_svg;
mod papers_hull;
mod papers_qu_du;
mod papers_tree;
mod papers_yang;
mod passes;
mod plan_check;
mod plate_drawings;
mod quote;
mod recorded;
mod sharp_corners;
mod sheet;
mod solve_exact;
mod solve_partial;
mod solve_search;
mod svg_files;
mod svg_oracle;
mod units_evidence;
