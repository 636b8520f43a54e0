//! Findings: everything about a drawing that a person should know, with its place.
//!
//! Nothing is dropped in silence. Whatever a stage leaves out, changes, guesses or doubts becomes a finding with a
//! code for programs, a sentence for people, and the layer, handle and place it concerns.

mod words;

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// How much a finding matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Severity {
    /// Worth knowing; nothing to do.
    Info,
    /// Something was left out, changed or guessed: look at it.
    Warning,
    /// Something cannot be cut as drawn.
    Error,
}

/// What a finding is about. Written in kebab case in JSON (`unsupported-entity`).
///
/// A new code also needs words in `finding/words.rs`, its name in `FindingCode` of `www/sdk/protocol.ts`, and a title in
/// `www/app/core/words/en.ts`. The compilers ask for the first and the last; `tests/package/words.test.mjs` compares the two lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Code {
    // Reading
    /// An entity kind that holds no outline to cut (text, dimension, image, ...), counted by kind and layer.
    UnsupportedEntity,
    /// An entity that was read through a break in the file: left out unless asked for.
    DamagedEntity,
    /// The reader lost step and found it again.
    Resynchronised,
    /// The file ends before it should.
    Truncated,
    /// A number that is none, or not finite.
    BadNumber,
    /// An entity whose values make no geometry (radius 0, too few points, bad knots, ...).
    InvalidGeometry,
    /// A block that is inserted but not defined.
    MissingBlock,
    /// A block that contains itself.
    CyclicBlock,
    /// Entities in paper space, invisible, or on frozen or off layers: not cut.
    HiddenEntity,
    /// Units are missing from the file and were guessed, with the reason.
    UnitsGuessed,
    /// Units are given but the size speaks against them.
    UnitsDoubtful,
    /// Characters could not be decoded.
    Encoding,
    /// A three-dimensional entity was projected on the sheet.
    Projected,
    /// Filled areas and wide lines: their outline or their middle line is taken.
    OutlineTaken,
    // Contours
    /// Ends joined over a gap.
    GapClosed,
    /// Ends close to each other, but farther than the tolerance: left open.
    GapLeft,
    /// More than two ends meet.
    Branch,
    /// Exact or near copies removed, also reversed ones.
    DuplicateRemoved,
    /// Collinear or co-circular overlap removed.
    OverlapRemoved,
    /// A closed contour in which the beam fits nowhere: narrower than the kerf of the machine, or than any common beam.
    FeatureTooSmall,
    /// Contours share cuts.
    CommonCut,
    /// Elements without length dropped.
    ZeroLength,
    /// A contour crosses itself.
    SelfCrossing,
    /// Two contours cross each other.
    Crossing,
    /// A contour does not close: kept as an open path.
    OpenContour,
    /// One contour over several layers.
    SeveralLayers,
    /// A lone border around everything: probably the sheet, not a cut.
    SheetOutline,
    /// A layer that by its name is probably not to be cut.
    LayerSuggestion,
    /// A layer that is not cut, with what it holds.
    LayerIgnored,
    /// Contours left out one by one.
    ContourExcluded,
    /// An operation was asked for a layer that the drawing does not have.
    LayerUnknown,
    /// Contours that keep their drawn line on a machine with a kerf width.
    KerfNotApplied,
    /// The drawing lies farther from the origin than the controller's numbers can tell places apart.
    FarFromOrigin,
    /// A check was cut short because of the size of the drawing, with what was left unchecked.
    NotAllChecked,
    /// More findings of one code than are listed one by one.
    More,
}

/// One finding. Places in mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// For programs.
    pub code: Code,
    /// How much it matters.
    pub severity: Severity,
    /// For people: what, where, what to do. Plain words, no exception names.
    pub message: String,
    /// Layer it concerns.
    pub layer: Option<String>,
    /// Handle of the entity in the file, as written there. Never a key: handles repeat in real files.
    pub handle: Option<String>,
    /// Where on the sheet, mm.
    #[serde(serialize_with = "place")]
    pub at: Option<DVec2>,
    /// How many it stands for.
    pub count: u32,
}

impl Finding {
    /// A finding of one, without layer, handle or place.
    pub fn new(code: Code, severity: Severity, message: impl Into<String>) -> Self {
        Self { code, severity, message: message.into(), layer: None, handle: None, at: None, count: 1 }
    }

    /// With its place.
    pub fn at(mut self, p: DVec2) -> Self {
        self.at = Some(p);
        self
    }

    /// With its layer.
    pub fn on_layer(mut self, layer: impl Into<String>) -> Self {
        self.layer = Some(layer.into());
        self
    }

    /// With the handle of its entity.
    pub fn of_handle(mut self, handle: Option<impl Into<String>>) -> Self {
        self.handle = handle.map(Into::into);
        self
    }

    /// Standing for `n`.
    pub fn times(mut self, n: u32) -> Self {
        self.count = n;
        self
    }
}

/// Findings listed one by one before the rest of one code is only counted: a list people can still read, and a
/// bound on memory for files that are wrong everywhere.
const LISTED_PER_CODE: u32 = 200;

/// Collects findings; past [`LISTED_PER_CODE`] of one code the rest are counted in one finding of code `More`.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    list: Vec<Finding>,
    seen: Seen,
}

/// How many of each code are listed, and how many are only counted. A list: codes are few.
#[derive(Clone, Debug, Default)]
pub(crate) struct Seen(Vec<(Code, u32, u32)>);

impl Seen {
    /// Whether another `count` of a code are to be listed; otherwise they are counted.
    pub(crate) fn lists(&mut self, code: Code, count: u32, most: u32) -> bool {
        let at = self.0.iter().position(|(c, ..)| *c >= code).unwrap_or(self.0.len());
        if self.0.get(at).is_none_or(|(c, ..)| *c != code) {
            self.0.insert(at, (code, 0, 0));
        }
        let (_, listed, rest) = &mut self.0[at];
        let lists = *listed < most;
        *listed += u32::from(lists);
        *rest = if lists { *rest } else { rest.saturating_add(count) };
        lists
    }

    /// The codes of which some are only counted, with how many.
    pub(crate) fn rests(self) -> impl Iterator<Item = (Code, u32)> {
        self.0.into_iter().map(|(code, _, rest)| (code, rest)).filter(|&(_, rest)| rest > 0)
    }
}

impl Findings {
    /// Adds one.
    pub fn push(&mut self, f: Finding) {
        if self.seen.lists(f.code, f.count, LISTED_PER_CODE) {
            self.list.push(f);
        }
    }

    /// Takes back those that it says of.
    pub fn withdraw(&mut self, of: impl Fn(&Finding) -> bool) {
        self.list.retain(|f| !of(f));
    }

    /// The list, with a closing `More` for each code that overflowed.
    pub fn into_list(mut self) -> Vec<Finding> {
        for (code, rest) in self.seen.rests() {
            let message = format!("Not listed one by one: {}.", code.in_words(rest));
            self.list.push(Finding::new(Code::More, Severity::Info, message).times(rest));
        }
        self.list
    }
}

fn place<S: serde::Serializer>(p: &Option<DVec2>, s: S) -> Result<S::Ok, S::Error> {
    p.map(|p| [p.x, p.y]).serialize(s)
}
