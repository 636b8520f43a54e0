//! Findings: everything about a drawing that a person should know, with the place it concerns.
//!
//! No stage drops anything silently. Whatever it skips, changes, guesses or doubts becomes a finding with a code for
//! programs, a sentence for people, and the layer, the entity's handle and the place it concerns.

mod phrases;

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// How much a finding matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Severity {
    /// For information; nothing needs to be done.
    Info,
    /// Something was skipped, changed or guessed; the person should check it.
    Warning,
    /// Something cannot be cut as drawn.
    Error,
}

/// The kind of a finding. Written in kebab case in JSON (`unsupported-entity`). Later versions may add codes.
// A new code also needs a phrase in `finding/phrases.rs` and a title in `www/app/core/words/en.ts`; the compilers report a
// missing one. `FindingCode` of the package is generated: see `typescript.rs`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "FindingCode"))]
pub enum Code {
    // Reading
    /// An entity kind that holds no outline to cut (text, dimension, image, ...), counted by kind and layer.
    UnsupportedEntity,
    /// An entity that was read across a break in the file. It is skipped unless the options keep damaged entities.
    DamagedEntity,
    /// Group codes and values were out of step; the reader found a place to resume.
    Resynchronised,
    /// The file ends before its end mark.
    Truncated,
    /// A value that should be a number is not one, or is not finite.
    BadNumber,
    /// An entity whose values describe no geometry (radius 0, too few points, bad knots, ...).
    InvalidGeometry,
    /// A block that is inserted but not defined.
    MissingBlock,
    /// A block that contains itself.
    CyclicBlock,
    /// Entities in paper space, invisible, or on frozen or off layers: not cut.
    HiddenEntity,
    /// The file names no units; they were guessed, and the message gives the reason.
    UnitsGuessed,
    /// The file names units, but the size of the drawing makes them unlikely.
    UnitsDoubtful,
    /// Characters could not be decoded.
    Encoding,
    /// A three-dimensional entity was projected on the sheet.
    Projected,
    /// A filled area or a wide line was replaced by its outline or its centre line.
    OutlineTaken,
    // Contours
    /// Ends joined over a gap.
    GapClosed,
    /// Ends that lie close to each other, but farther apart than the tolerance, so they were left open.
    GapLeft,
    /// More than two ends meet.
    Branch,
    /// Exact or near copies were removed, including reversed ones.
    DuplicateRemoved,
    /// Contours near others, farther than the copy tolerance, that would be cut twice.
    NearCopy,
    /// Collinear or co-circular overlaps were removed.
    OverlapRemoved,
    /// A closed contour in which the beam fits nowhere: narrower than the kerf of the machine, or than any common beam.
    FeatureTooSmall,
    /// Contours share cuts.
    CommonCut,
    /// Parts that bridges connect.
    Bridges,
    /// A part that is moved to stand one kerf from a neighbour, or that could be.
    PartShift,
    /// Elements without length were dropped.
    ZeroLength,
    /// A closed shape narrower than the copy tolerance is cut as one line.
    SliverCollapsed,
    /// A contour crosses itself.
    SelfCrossing,
    /// Two contours cross each other.
    Crossing,
    /// A contour does not close: kept as an open path.
    OpenContour,
    /// One contour runs over several layers.
    SeveralLayers,
    /// A single border around everything, which shows the sheet and is not a cut, or may be one.
    SheetOutline,
    /// Many small open strokes close together: single-line lettering, with what is done with it.
    Lettering,
    /// Open lines that lead to lettering.
    Leaders,
    /// A layer whose name suggests that it is not meant to be cut.
    LayerSuggestion,
    /// A layer that is not cut, with the number of shapes it holds.
    LayerIgnored,
    /// Contours that the person excluded one by one.
    ContourExcluded,
    /// An operation was asked for a layer that the drawing does not have.
    LayerUnknown,
    /// Contours that are cut along their drawn line although the machine has a kerf width.
    KerfNotApplied,
    /// A lead of a contour is not as the rule says: turned, moved, shortened or a line, because the wanted one does not fit.
    LeadAdjusted,
    /// There is no room for the lead of a contour, or contours that share cuts have none.
    LeadMissing,
    /// The micro-joints of a contour are fewer or at other places than asked for.
    JointAdjusted,
    /// There is no room for a micro-joint, or a contour cannot have any.
    JointMissing,
    /// There is no room for a loop at a corner, or a corner cannot be rounded.
    CornerStopped,
    /// The drawing lies so far from the origin that the controller's single-precision numbers cannot resolve its
    /// details.
    FarFromOrigin,
    /// The job does not lie on the machine's bed.
    OffBed,
    /// A layer is worked faster than the machine moves.
    LayerTooFast,
    /// A layer has a least power, which G-code cannot say.
    LeastPowerLeftOut,
    /// Moves with the head down over pieces that may have tipped.
    RiskyMoves,
    /// Cuts near each other follow each other sooner than the machine asks for.
    HotPairs,
    /// A check was stopped early because of the size of the drawing; the message says what remains unchecked.
    NotAllChecked,
    /// More findings of one code than are listed individually.
    More,
}

/// One finding.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Finding {
    /// Code for programs.
    pub code: Code,
    /// Severity.
    pub severity: Severity,
    /// Sentence for people that says what, where and what to do, without technical error names.
    pub message: String,
    /// Name of the layer it concerns.
    pub layer: Option<String>,
    /// Handle of the entity, as written in the file. It is not a key, because handles repeat in real files.
    pub handle: Option<String>,
    /// Place on the sheet, mm.
    #[serde(with = "place")]
    #[cfg_attr(test, ts(as = "Option<[f64; 2]>"))]
    pub at: Option<DVec2>,
    /// Number of entities or places the finding covers.
    pub count: u32,
}

impl Finding {
    /// A finding that covers one place, without layer, handle or position.
    pub fn new(code: Code, severity: Severity, message: impl Into<String>) -> Self {
        Self { code, severity, message: message.into(), layer: None, handle: None, at: None, count: 1 }
    }

    /// Sets the place.
    pub fn at(mut self, p: DVec2) -> Self {
        self.at = Some(p);
        self
    }

    /// Moves its place by `shift`, mm.
    pub fn moved(mut self, shift: DVec2) -> Self {
        self.at = self.at.map(|at| at + shift);
        self
    }

    /// Sets the layer.
    pub fn on_layer(mut self, layer: impl Into<String>) -> Self {
        self.layer = Some(layer.into());
        self
    }

    /// Sets the handle of the entity.
    pub fn of_handle(mut self, handle: Option<impl Into<String>>) -> Self {
        self.handle = handle.map(Into::into);
        self
    }

    /// Sets the number of entities or places it covers.
    pub fn times(mut self, n: u32) -> Self {
        self.count = n;
        self
    }
}

/// Findings of one code that are listed individually; the rest is only counted. The list stays readable, and memory
/// stays bounded for files that are wrong everywhere.
const LISTED_PER_CODE: u32 = 200;

/// Collects findings. Beyond [`LISTED_PER_CODE`] findings of one code, the rest is counted in one finding of code
/// `More`.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    list: Vec<Finding>,
    seen: Seen,
}

/// For each code, the number of listed findings and the number of those only counted, sorted by code. A vector serves
/// because there are few codes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Seen(Vec<(Code, u32, u32)>);

impl Seen {
    /// Records a finding that covers `count` places. Returns whether to list it; after `most` listed findings of a code
    /// it is only counted.
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

    /// The codes with findings that were only counted, each with that count.
    pub(crate) fn rests(self) -> impl Iterator<Item = (Code, u32)> {
        self.0.into_iter().map(|(code, _, rest)| (code, rest)).filter(|&(_, rest)| rest > 0)
    }
}

impl Findings {
    /// Adds a finding.
    pub fn push(&mut self, f: Finding) {
        if self.seen.lists(f.code, f.count, LISTED_PER_CODE) {
            self.list.push(f);
        }
    }

    /// Removes the findings for which `of` returns true.
    pub fn withdraw(&mut self, of: impl Fn(&Finding) -> bool) {
        self.list.retain(|f| !of(f));
    }

    /// The list of findings, closed by one finding of code `More` for each code that overflowed.
    pub fn into_list(mut self) -> Vec<Finding> {
        for (code, rest) in self.seen.rests() {
            let message = format!("Not listed one by one: {}.", code.in_words(rest));
            self.list.push(Finding::new(Code::More, Severity::Info, message).times(rest));
        }
        self.list
    }
}

/// A place as `[x, y]`.
mod place {
    use glam::DVec2;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer>(p: &Option<DVec2>, s: S) -> Result<S::Ok, S::Error> {
        p.map(|p| p.to_array()).serialize(s)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(d: D) -> Result<Option<DVec2>, D::Error> {
        Ok(Option::<[f64; 2]>::deserialize(d)?.map(DVec2::from))
    }
}
