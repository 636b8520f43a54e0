//! The fields of the options, as callers write them. `options.rs` and `plan_options.rs` have the structs, and `ranges.rs` the ranges of numbers.

use super::options::LoadOptions;
use super::plan_options::{Budget, PlanOptions};
use super::ranges::{
    ALONG, COPY_TOLERANCE, COUNT, DPI, ID, JOIN_TOLERANCE, MEMBER, PLACE, REVERSED, SECONDS, SHARE,
    TOLERANCE, TURN, WORKERS,
};
use crate::fields::{Field, Kind, Shape, Shaped};
use crate::machine::{Anchor, CORNER_KINDS, JOINT_COUNT, LAYER_SETTINGS, LEAD_KINDS, Profile};

const IDS: Kind = Kind::List(&Kind::Whole(ID));
const LENGTHS: Kind = Kind::List(&Kind::Number(ALONG));
const BUDGET: [Field; 2] =
    [Field::optional("seconds", Kind::Number(SECONDS)), Field::optional("moves", Kind::Whole(COUNT))];

impl Shaped for LoadOptions {
    const SHAPE: Shape = Shape {
        owner: "Reading",
        item: "option",
        value: "The option",
        fields: &[
            Field::optional(
                "units",
                Kind::Choice(&["mm", "cm", "dm", "m", "um", "in", "ft", "yd", "mil", "microinch", "px"]),
            ),
            Field::optional("dpi", Kind::Number(DPI)),
            Field::optional("tolerance", Kind::Number(TOLERANCE)),
            Field::optional("keepDamaged", Kind::Flag),
            Field::optional("turn", Kind::Whole(TURN)),
            Field::optional("joinTolerance", Kind::Number(JOIN_TOLERANCE)),
            Field::optional("copyTolerance", Kind::Number(COPY_TOLERANCE)),
            Field::optional("layers", Kind::List(&Kind::Object(LAYER_SETTINGS))),
            Field::optional("orderByLayer", Kind::Flag),
            Field::optional("passOrder", Kind::Choice(&["contour", "sheet"])),
            Field::optional("ignoreOutline", Kind::Flag),
            Field::optional("keepBorder", Kind::Flag),
            Field::optional("groups", Kind::List(&Kind::Object(GROUP))),
            Field::optional("partByPart", Kind::Flag),
            Field::optional("commonCuts", Kind::Choice(&["best", "insertion", "off"])),
            Field::optional("first", IDS),
            Field::optional("last", IDS),
            Field::optional("mark", IDS),
            Field::optional("sequences", Kind::List(&IDS)),
            Field::optional("exclude", IDS),
            Field::optional("together", Kind::List(&IDS)),
            Field::optional("joints", Kind::List(&Kind::Object(JOINT))),
            Field::optional("contours", Kind::List(&Kind::Object(CONTOUR))),
        ],
    };
}

const JOINT: &[Field] =
    &[Field::required("contour", Kind::Whole(ID)), Field::required("at", Kind::Number(SHARE))];

const CONTOUR: &[Field] = &[
    Field::required("contour", Kind::Whole(ID)),
    Field::nullable("joints", Kind::Whole(JOINT_COUNT)),
    Field::nullable("lead", Kind::Choice(LEAD_KINDS)),
    Field::nullable("corners", Kind::Choice(CORNER_KINDS)),
];

const GROUP: &[Field] = &[
    Field::required("name", Kind::Choice(&["lettering", "leaders"])),
    Field::required("operation", Kind::Choice(&["cut", "mark", "ignore"])),
];

impl Shaped for PlanOptions {
    const SHAPE: Shape = Shape {
        owner: "Planning",
        item: "option",
        value: "The option",
        fields: &[
            Field::optional("machine", Kind::NameOr(&Profile::SHAPE)),
            Field::optional("material", Kind::Text),
            Field::optional("place", Kind::Object(PLACING)),
            Field::optional("start", Kind::Choice(&["absolute", "current"])),
            Field::optional("allowOffBed", Kind::Flag),
            Field::optional("method", Kind::Text),
            Field::optional("parameters", Kind::Parameters),
            Field::optional("seed", Kind::Whole(COUNT)),
            Field::optional("warm", Kind::Object(WARM)),
            Field::optional("workers", Kind::Whole(WORKERS)),
            Field::optional("member", Kind::Whole(MEMBER)),
            Field::optional("seconds", Kind::Number(SECONDS)),
            Field::optional("moves", Kind::Whole(COUNT)),
        ],
    };
}

const PLACING: &[Field] = &[
    Field::optional("point", Kind::Choice(Anchor::NAMES)),
    Field::optional("from", Kind::Pair(&Kind::Number(PLACE))),
    Field::required("at", Kind::Pair(&Kind::Number(PLACE))),
];

/// A path to start from. A path taken from a plan has more fields, which a search does not need.
const WARM: &[Field] = &[
    Field::required("contours", IDS),
    Field::required("along", LENGTHS),
    Field::optional("until", LENGTHS),
    Field::required("reversed", Kind::List(&Kind::Whole(REVERSED))),
    Field::optional("points", LENGTHS),
    Field::optional("times", LENGTHS),
    Field::optional("leads", LENGTHS),
    Field::optional("leadOffsets", IDS),
    Field::optional("joints", LENGTHS),
    Field::optional("jointOffsets", IDS),
    Field::optional("preCuts", LENGTHS),
    Field::optional("pauses", LENGTHS),
    Field::optional("ways", IDS),
    Field::optional("via", LENGTHS),
    Field::optional("viaOf", IDS),
    Field::optional("tips", IDS),
    Field::optional("freedBy", IDS),
    Field::optional("waits", LENGTHS),
    Field::optional("loops", LENGTHS),
    Field::optional("loopOffsets", IDS),
];

impl Shaped for Budget {
    const SHAPE: Shape = Shape { owner: "A budget", item: "option", value: "The option", fields: &BUDGET };
}
