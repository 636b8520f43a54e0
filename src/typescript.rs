//! The TypeScript types of what crosses to JavaScript, generated from the Rust types: `www/sdk/generated/types.ts`.
//!
//! `www/sdk/protocol.ts` and `www/sdk/quote.ts` export them. What no Rust type describes is written there by hand: messages
//! to and from workers, and geometry, which travels as typed arrays. After a change of a Rust type,
//! `KERFWAY_BLESS=1 cargo test --lib typescript` writes the file again.

use crate::{calibration, drawing, finding, job, machine, output, plan, quote, sheet, solve};
use std::path::Path;
use ts_rs::{Config, TS};

/// The generated file, relative to the top of the repository.
const FILE: &str = "www/sdk/generated/types.ts";

const HEAD: &str = "\
/**
 * Generated from the Rust types by `KERFWAY_BLESS=1 cargo test --lib typescript`: do not edit.
 * Units: mm, mm2, s, rad.
 */

import type { WarmPath } from '../protocol.js';
";

/// The declaration of one type with its documentation.
fn declared<T: TS>(config: &Config) -> String {
    let (docs, alias) = (T::docs().unwrap_or_default(), T::decl(config));
    // Objects are interfaces, which compilers name in their messages and TypeDoc shows as tables.
    let object = alias.strip_suffix("};").and_then(|a| a.strip_prefix("type ")?.split_once(" = {"));
    let declaration =
        object.map_or_else(|| alias.clone(), |(name, fields)| format!("interface {name} {{{fields}}}"));
    laid_out(&for_javascript(&format!("\n{docs}export {declaration}\n")))
}

/// Indents the fields of a declaration and writes short comments in one line.
fn laid_out(declaration: &str) -> String {
    let mut text = String::new();
    for part in declaration.replace(", }", ",\n}").split_inclusive("/**\n * ") {
        let (comment, rest) = part.split_once("\n */\n").unwrap_or(("", part));
        if !comment.is_empty() && !comment.contains('\n') {
            text.truncate(text.len() - "\n * ".len());
            text += &format!(" {comment} */\n{rest}");
        } else {
            text += part;
        }
    }
    let mut depth: usize = 0;
    let mut lines = String::new();
    for line in text.lines().map(str::trim_end) {
        depth = depth.saturating_sub(usize::from(line.starts_with('}')));
        lines += &format!("{}{line}\n", "  ".repeat(depth));
        depth += usize::from(line.ends_with('{'));
    }
    lines
}

/// Replaces Rust's `None` by JavaScript's `null`, and links to other items by their bare names.
fn for_javascript(text: &str) -> String {
    let mut parts = text.split("[`");
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (path, rest) = part.split_once("`]").unwrap_or((part, ""));
        let name = path.rsplit("::").next().unwrap_or(path);
        plain += &format!("`{name}`{rest}");
    }
    plain.replace("`None`", "`null`")
}

/// The declarations of several types in order.
macro_rules! declarations {
    ($config:expr, $($kind:ty),+ $(,)?) => { [$(declared::<$kind>($config)),+].concat() };
}

fn generated() -> String {
    let config = &Config::new().with_large_int("number");
    let declarations = declarations!(
        config,
        drawing::Unit,
        drawing::UnitsSource,
        drawing::Units,
        drawing::EntityKindCount,
        finding::Severity,
        finding::Code,
        finding::Finding,
        sheet::Operation,
        sheet::CommonCuts,
        sheet::Group,
        sheet::HandJoint,
        sheet::ContourChoice,
        sheet::PassOrder,
        machine::Settings,
        sheet::LayerUse,
        sheet::Part,
        machine::Anchor,
        machine::Start,
        machine::Travel,
        machine::Axes,
        machine::Process,
        machine::SharpCorner,
        machine::MaterialSetting,
        machine::Takes,
        machine::LeadSide,
        machine::LeadPosition,
        machine::CornerKind,
        machine::LeadKind,
        machine::LeadShape,
        machine::LeadRule,
        machine::Leads,
        machine::Levers,
        machine::Fly,
        machine::Bridges,
        machine::Chains,
        machine::SharedCuts,
        machine::Lift,
        machine::MovingPierce,
        machine::RiskyMoves,
        machine::Slats,
        machine::Tips,
        machine::SmallHoles,
        machine::Heat,
        machine::Corners,
        machine::SizeTest,
        machine::JointKind,
        machine::JointRule,
        machine::Joints,
        machine::Skeleton,
        machine::dialect::FileUnit,
        machine::dialect::Decimals,
        machine::dialect::DwellUnit,
        machine::dialect::Dwell,
        machine::dialect::PowerBy,
        machine::dialect::Power,
        machine::dialect::PierceBy,
        machine::dialect::Pierce,
        machine::dialect::Air,
        machine::dialect::Comments,
        machine::dialect::LineEnd,
        machine::dialect::Dialect,
        machine::dialect::DialectChoice,
        machine::Profile,
        job::ErrorCode,
        job::ErrorReport,
        job::LayerChoice,
        job::GroupChoice,
        job::LoadOptions,
        job::MachineChoice,
        job::Budget,
        job::Place,
        job::PlanOptions,
        job::ContourInfo<'static>,
        job::Loaded<'static>,
        output::CheckCode,
        output::CheckProblem,
        output::Check,
        plan::Summary,
        job::Baselines,
        job::SliceEnd,
        job::Slice,
        job::Verified,
        solve::SolverInfo,
        solve::papers::Card,
        solve::Curve,
        solve::Grid,
        solve::Parent,
        solve::Partitions,
        solve::Insight,
        calibration::CalibratedJob,
        calibration::Calibration,
        quote::Material,
        quote::Limits,
        quote::Terms,
        quote::Times,
        quote::LayerUse,
        quote::PartItem,
        quote::PartGroup,
        quote::Smallest,
        quote::Narrowest,
        quote::Defect,
        quote::Level,
        quote::ReasonCode,
        quote::Reason,
        quote::Confidence,
        quote::CheckCode,
        quote::Exceeded,
        quote::Checks,
        quote::Quote,
    );
    format!("{HEAD}{declarations}")
}

#[test]
fn types_of_the_package_are_those_of_the_core() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(FILE);
    let types = generated();
    if std::env::var_os("KERFWAY_BLESS").is_some() {
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(&file, &types).unwrap();
    }
    let written = std::fs::read_to_string(&file).unwrap_or_default();
    let first = written.lines().zip(types.lines()).find(|(old, new)| old != new);
    assert!(
        written == types,
        "{FILE} is not what the Rust types say, first at {first:?}. \
         Run KERFWAY_BLESS=1 cargo test --lib typescript."
    );
}
