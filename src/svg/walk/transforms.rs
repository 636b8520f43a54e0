//! The transforms that an element has itself: `translate`, `rotate`, `scale` and `transform`, about their origin.

use super::super::length::Lengths;
use super::super::own::{Own, Reference};
use super::super::subject::Subject;
use super::super::{shape, trace, transform};
use super::{Place, Walker};
use crate::geometry::{Aabb, Affine, DVec2};

impl Walker<'_, '_> {
    /// The map of the transforms of an element, in the units of the place around it. What cannot be read is counted.
    pub(super) fn transforms(&mut self, element: u32, own: &Own, place: &Place) -> Affine {
        if !own.is_transformed() {
            return Affine::IDENTITY;
        }
        let lengths = self.lengths(place);
        let in_box = match own.reference {
            Reference::View => Some((DVec2::ZERO, lengths)),
            Reference::Fill => self.fill_box(element, own, place).map(|b| {
                let of_box = Lengths { viewport: b.size(), ..lengths };
                (b.min, of_box)
            }),
            Reference::Stroke => None,
        };
        let map = listed(own).and_then(|list| transform::read(&list, &in_box.map_or(lengths, |b| b.1)));
        let (id, at) = (self.id(element), Some(place.map.point(DVec2::ZERO)));
        let Some(map) = map else {
            self.walked.report.count(Subject::Transform, None, id, at);
            return Affine::IDENTITY;
        };
        let origin = in_box.and_then(|(corner, lengths)| {
            let origin = own.origin.as_deref().map_or(Some(DVec2::ZERO), |o| transform::origin(o, &lengths));
            origin.map(|o| corner + o)
        });
        // A move is the same about every point.
        if origin.is_none() && (map.x, map.y) != (DVec2::X, DVec2::Y) {
            self.walked.report.count(Subject::Origin, None, id, at);
        }
        let origin = origin.unwrap_or_default();
        Affine::translation(-origin).then(&map).then(&Affine::translation(origin))
    }

    /// The box of a shape in user units; `None` for other elements.
    fn fill_box(&self, element: u32, own: &Own, place: &Place) -> Option<Aabb> {
        let kind = shape::kind(self.document.name(element))?;
        let outline = shape::outline(self.document, element, kind, own, &self.lengths(place));
        let scale = place.map.determinant().abs().sqrt();
        let tolerance = if scale > 0.0 { self.options.tolerance / scale } else { self.options.tolerance };
        let mut bounds = Aabb::EMPTY;
        for chain in &outline.chains {
            let path = trace::path(chain, &Affine::IDENTITY, tolerance)?;
            bounds = bounds.with(chain.start).union(path.bounds());
        }
        Some(bounds).filter(|b| !b.is_empty())
    }
}

/// All transforms as one list; `None` if one of the properties is of another kind, such as a turn about an axis.
fn listed(own: &Own) -> Option<String> {
    let mut list = String::new();
    for (function, value) in ["translate", "rotate", "scale"].into_iter().zip(&own.moves) {
        if let Some(value) = value {
            let words: Vec<&str> = value.split_ascii_whitespace().collect();
            let most = if function == "rotate" { 1 } else { 2 };
            if words.len() > most {
                return None;
            }
            list += &format!("{function}({}) ", words.join(","));
        }
    }
    Some(list + own.transform.as_deref().unwrap_or_default())
}
