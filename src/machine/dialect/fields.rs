//! The table of a dialect's fields, with the range of every number.

use super::model::Dialect;
use crate::fields::{Field, Kind, Range, Shape, Shaped};

const XY: Range =
    Range::new(2.0, 6.0, "", "fewer decimals are visible in the cut, and no controller keeps more");
const IJ: Range = Range::new(2.0, 7.0, "", "fewer decimals make the two radii of an arc differ");
const FEED: Range = Range::new(0.0, 4.0, "", "no controller keeps more");
const WAIT: Range = Range::new(0.0, 4.0, "", "no controller waits more exactly");
const POWER: Range = Range::new(0.0, 4.0, "", "no controller keeps more");
const FULL: Range = Range::new(1e-3, 1e6, "", "controllers take numbers of a few digits for full power");
const OUTPUT: Range = Range::new(0.0, 99.0, "", "controllers number their outputs from 0");
const CREEP: Range = Range::new(0.01, 10.0, "mm", "a longer way would not be pierced but cut");
const CHORD: Range =
    Range::new(0.001, 0.5, "mm", "finer chords are lost in rounding, and coarser ones are visible");
const LENGTH: Range = Range::new(70.0, 1000.0, "characters", "the longest line of a motion must fit into it");

impl Shaped for Dialect {
    const SHAPE: Shape = Shape {
        owner: "The dialect",
        item: "field",
        value: "The dialect's field",
        fields: &[
            Field::required("schema", Kind::Choice(&["kerfway.dialect/1"])),
            Field::required("name", Kind::Text),
            Field::required("title", Kind::Text),
            Field::required("controller", Kind::Text),
            Field::required("units", Kind::Choice(&["mm", "inch"])),
            Field::required("decimals", Kind::Object(DECIMALS)),
            Field::nullable("dwell", Kind::Object(DWELL)),
            Field::required("power", Kind::Object(POWERS)),
            Field::nullable("pierce", Kind::Object(PIERCE)),
            Field::required("rapids_dark", Kind::Flag),
            Field::optional("rapid_feed", Kind::Flag),
            Field::nullable("chords", Kind::Number(CHORD)),
            Field::nullable("air", Kind::Object(AIR)),
            Field::optional("z", Kind::Flag),
            Field::required("comments", Kind::Choice(&["semicolon", "parentheses", "none"])),
            Field::required("line_length", Kind::Whole(LENGTH)),
            Field::required("line_end", Kind::Choice(&["lf", "crlf"])),
            Field::required("header", Kind::List(&Kind::Text)),
            Field::required("footer", Kind::List(&Kind::Text)),
        ],
    };
}

const DECIMALS: &[Field] = &[
    Field::required("xy", Kind::Whole(XY)),
    Field::required("ij", Kind::Whole(IJ)),
    Field::required("feed", Kind::Whole(FEED)),
];

const DWELL: &[Field] = &[
    Field::required("word", Kind::Choice(&["P", "S", "X", "F"])),
    Field::required("unit", Kind::Choice(&["s", "ms"])),
    Field::required("decimals", Kind::Whole(WAIT)),
];

const POWERS: &[Field] = &[
    Field::required(
        "by",
        Kind::Choice(&[
            "laser-m4",
            "laser-m3",
            "spindle-m3",
            "output-m67",
            "inline-m3",
            "fan-m106",
            "motion",
            "macro",
        ]),
    ),
    Field::required("word", Kind::Choice(&["S", "Q"])),
    Field::nullable("full", Kind::Number(FULL)),
    Field::required("decimals", Kind::Whole(POWER)),
    Field::nullable("output", Kind::Whole(OUTPUT)),
    Field::optional("on", Kind::List(&Kind::Text)),
    Field::optional("off", Kind::List(&Kind::Text)),
];

const PIERCE: &[Field] = &[
    Field::required("by", Kind::Choice(&["dwell-m3", "dwell-m68", "dwell-standard", "creep", "macro"])),
    Field::nullable("length", Kind::Number(CREEP)),
    Field::optional("lines", Kind::List(&Kind::Text)),
];

const AIR: &[Field] = &[Field::required("on", Kind::Text), Field::required("off", Kind::Text)];
