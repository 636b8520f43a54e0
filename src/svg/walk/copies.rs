//! Copies (`use`): the element that each copies, unless that is inside itself.

use super::super::length::Axis;
use super::super::own::Own;
use super::super::subject::Subject;
use super::super::xml::Space;
use super::{Copy, Frame, Place, Walker};
use crate::geometry::{Affine, DVec2};

impl Walker<'_, '_> {
    /// Visits the element that a `use` copies.
    pub(super) fn copy(&mut self, element: u32, own: &Own, mut place: Place) {
        let lengths = self.lengths(&place);
        let length = |name: &str, axis| own.length(self.document, element, name, axis, &lengths);
        let offset =
            DVec2::new(length("x", Axis::Width).unwrap_or(0.0), length("y", Axis::Height).unwrap_or(0.0));
        let size = [length("width", Axis::Width), length("height", Axis::Height)];
        place.map = Affine::translation(offset).then(&place.map);
        let href = self.document.attribute(element, "href");
        let href =
            href.or(self.document.attribute_in(element, Space::Xlink, "href")).unwrap_or_default().trim();
        let short = || href.chars().take(60).collect::<String>();
        let (id, at) = (self.id(element), Some(place.map.point(DVec2::ZERO)));
        let Some(target) = href.strip_prefix('#').and_then(|id| self.document.by_id(id)) else {
            self.walked.report.count(Subject::Missing(short()), None, id, at);
            return;
        };
        let mut around = place.copy;
        while let Some(copy) = around.and_then(|c| self.copies.get(c as usize)) {
            self.steps.take(1);
            if copy.target == target {
                self.walked.report.count(Subject::Cyclic(short()), None, id, at);
                return;
            }
            around = copy.outer;
        }
        let mut above = Some(element);
        while let Some(e) = above {
            self.steps.take(1);
            if e == target {
                self.walked.report.count(Subject::Cyclic(short()), None, id, at);
                return;
            }
            above = self.document.get(e).and_then(|e| e.parent);
        }
        let this = u32::try_from(self.copies.len()).ok();
        self.copies.push(Copy { target, outer: place.copy });
        place.copy = this;
        let end = self.document.get(target).map_or(0, |e| e.end);
        self.open.push(Frame { next: target, end, place, instance: Some(size) });
    }
}
