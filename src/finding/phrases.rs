//! Finding codes as phrases, for sentences that sum up many findings of one code.

use super::Code;

impl Code {
    /// A sentence without its full stop that says what `n` findings of this kind report: "45 gaps were closed".
    pub fn in_words(self, n: u32) -> String {
        match self.clauses() {
            Clauses::Whole(sentence) => sentence.to_owned(),
            Clauses::Counted(one, _) if n == 1 => format!("1 {one}"),
            Clauses::Counted(_, many) => format!("{n} {many}"),
        }
    }

    fn clauses(self) -> Clauses {
        use Clauses::{Counted, Whole};
        match self {
            Self::UnsupportedEntity => Counted(
                "text or other object without an outline was skipped",
                "texts or other objects without an outline were skipped",
            ),
            Self::DamagedEntity => Counted(
                "entity is damaged by a break in the file",
                "entities are damaged by breaks in the file",
            ),
            Self::Resynchronised => Counted("break in the file was found", "breaks in the file were found"),
            Self::Truncated => Whole("The file ends too early"),
            Self::BadNumber => Counted("number could not be read", "numbers could not be read"),
            Self::InvalidGeometry => Counted(
                "entity has values that make no geometry",
                "entities have values that make no geometry",
            ),
            Self::MissingBlock => Counted(
                "inserted block is missing from the file",
                "inserted blocks are missing from the file",
            ),
            Self::CyclicBlock => {
                Counted("inserted block contains itself", "inserted blocks contain themselves")
            }
            Self::HiddenEntity => Counted("hidden entity is not cut", "hidden entities are not cut"),
            Self::UnitsGuessed => Whole("The units were guessed"),
            Self::UnitsDoubtful => Whole("The units do not fit the size of the drawing"),
            Self::Encoding => Counted("character could not be decoded", "characters could not be decoded"),
            Self::Projected => {
                Counted("three-dimensional entity was flattened", "three-dimensional entities were flattened")
            }
            Self::OutlineTaken => Counted(
                "filled area or wide line was replaced by a thin line",
                "filled areas or wide lines were replaced by thin lines",
            ),
            Self::GapClosed => Counted("gap was closed", "gaps were closed"),
            Self::GapLeft => Counted("gap was left open", "gaps were left open"),
            Self::Branch => {
                Counted("place joins more than two line ends", "places join more than two line ends each")
            }
            Self::DuplicateRemoved => Counted("duplicate line was removed", "duplicate lines were removed"),
            Self::NearCopy => Counted("contour lies near another one", "contours lie near others"),
            Self::OverlapRemoved => Counted("overlap was removed", "overlaps were removed"),
            Self::FeatureTooSmall => {
                Counted("contour is too small for the beam", "contours are too small for the beam")
            }
            Self::CommonCut => Counted("group of contours shares cuts", "groups of contours share cuts"),
            Self::Bridges => Counted("bridge connects parts", "bridges connect parts"),
            Self::PartShift => Counted(
                "part is or could be shifted to a neighbour",
                "parts are or could be shifted to a neighbour",
            ),
            Self::ZeroLength => {
                Counted("element without length was removed", "elements without length were removed")
            }
            Self::SelfCrossing => Counted(
                "place was found where a contour crosses itself",
                "places were found where a contour crosses itself",
            ),
            Self::Crossing => Counted(
                "place was found where two contours cross",
                "places were found where two contours cross",
            ),
            Self::OpenContour => Counted("contour does not close", "contours do not close"),
            Self::SeveralLayers => {
                Counted("contour lies on several layers", "contours lie on several layers")
            }
            Self::SliverCollapsed => Counted("sliver is cut as one line", "slivers are cut as one line each"),
            Self::Lettering => {
                Counted("small stroke looks like lettering", "small strokes look like lettering")
            }
            Self::Leaders => Counted("open line leads to lettering", "open lines lead to lettering"),
            Self::SheetOutline => Whole("The border around everything may be the sheet"),
            Self::LayerSuggestion => Counted(
                "shape is on a layer whose name suggests another operation",
                "shapes are on layers whose names suggest another operation",
            ),
            Self::LayerIgnored => {
                Counted("shape is on a layer that is not cut", "shapes are on layers that are not cut")
            }
            Self::ContourExcluded => Counted("contour is excluded", "contours are excluded"),
            Self::LayerUnknown => Counted(
                "layer of the options is not in the drawing",
                "layers of the options are not in the drawing",
            ),
            Self::KerfNotApplied => Counted(
                "contour is cut along its drawn line, without kerf compensation",
                "contours are cut along their drawn lines, without kerf compensation",
            ),
            Self::LeadAdjusted => {
                Counted("contour has another lead than wanted", "contours have other leads than wanted")
            }
            Self::LeadMissing => Counted("contour has no lead", "contours have no lead"),
            Self::JointAdjusted => Counted(
                "contour has other micro-joints than wanted",
                "contours have other micro-joints than wanted",
            ),
            Self::JointMissing => Counted("micro-joint is missing", "micro-joints are missing"),
            Self::CornerStopped => Counted("corner is turned in as drawn", "corners are turned in as drawn"),
            Self::FarFromOrigin => Whole("The drawing lies too far from the origin to be cut"),
            Self::OffBed => Whole("The job does not lie on the bed"),
            Self::HotPairs => Whole("Cuts near each other follow each other too soon"),
            Self::RiskyMoves => Whole("Moves cross pieces that may have tipped, with the head down"),
            Self::LayerTooFast => Whole("A layer is faster than the machine moves"),
            Self::LeastPowerLeftOut => Whole("The least power of a layer is not part of G-code"),
            Self::NotAllChecked => Counted(
                "check was cut short because of the size of the drawing",
                "checks were cut short because of the size of the drawing",
            ),
            Self::More => Counted("more finding is not listed", "more findings are not listed"),
        }
    }
}

/// How the summary of a code is phrased.
enum Clauses {
    /// The text after the number 1, and the text after any other number.
    Counted(&'static str, &'static str),
    /// A sentence about the whole drawing, which needs no number.
    Whole(&'static str),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn singular_plural_and_the_whole_drawing() {
        assert_eq!(
            Code::UnsupportedEntity.in_words(45),
            "45 texts or other objects without an outline were skipped"
        );
        assert_eq!(Code::OpenContour.in_words(1), "1 contour does not close");
        assert_eq!(Code::UnitsDoubtful.in_words(3), "The units do not fit the size of the drawing");
    }
}
