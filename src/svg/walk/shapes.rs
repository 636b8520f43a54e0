//! Shapes and elements that cannot be cut, as the walk meets them.

use super::super::layers::{Key, Line};
use super::super::length::Axis;
use super::super::outline::{Chain, Piece};
use super::super::own::Own;
use super::super::style::Paint;
use super::super::subject::{Hidden, Subject};
use super::super::{shape, trace};
use super::{Place, Walker};
use crate::drawing::Shape;
use crate::geometry::DVec2;

/// Width of a stroke in mm above which a finding says that its middle is cut. Lines for people to see are thinner.
/// The millimetre itself is not, nor is one that a turn with rounded numbers has made longer.
const WIDE: f64 = 1.0001;

impl Walker<'_, '_> {
    /// Adds what is cut of a shape, and reports what its style asks for beyond that.
    pub(super) fn shape(&mut self, element: u32, kind: &'static str, own: &Own, place: &Place) {
        let mut outline = shape::outline(self.document, element, kind, own, &self.lengths(place));
        let style = &place.style;
        let (stroke, fill) = (style.visible_stroke(), style.visible_fill());
        let line = if stroke == Paint::None { Line::Filled(fill) } else { Line::Stroke(stroke) };
        let key = (place.group, line);
        let id = self.id(element);
        let at = outline.chains.first().map(|c| place.map.point(c.start));
        if let Some(at) = at {
            self.walked.report.place(at);
        }
        let mut invisible_lines = false;
        let mut unpainted = stroke == Paint::None && fill == Paint::None;
        if stroke == Paint::None && !outline.chains.is_empty() {
            // A fill closes every subpath, and shows nothing of a single straight line.
            outline.chains.iter_mut().for_each(|chain| chain.closed = true);
            let all = outline.chains.len();
            outline.chains.retain(|chain| !matches!(chain.pieces.as_slice(), [Piece::Line(_)]));
            unpainted |= outline.chains.is_empty();
            invisible_lines = outline.chains.len() < all;
        }
        let hidden = place.hidden.or(match style.visible {
            false => Some(Hidden::Invisible),
            true if unpainted => Some(Hidden::Unpainted),
            true => None,
        });
        if let Some(why) = hidden {
            self.walked.report.count(Subject::Hidden(why), None, id, at);
            return;
        }
        if invisible_lines {
            self.walked.report.count(Subject::Hidden(Hidden::Unpainted), None, id, at);
        }
        if let Some(fault) = outline.fault {
            self.walked.report.invalid(format!("{}: {fault}.", named(kind, id)), key, id, at);
        }
        let mut drawn = 0_usize;
        for chain in &outline.chains {
            drawn += usize::from(self.chain(chain, kind, key, element, place));
        }
        if drawn == 0 {
            return;
        }
        let width = style.width * place.map.determinant().abs().sqrt();
        for (is_so, subject) in [
            (matches!(line, Line::Filled(_)), Subject::Filled(kind)),
            (fill == Paint::Pattern, Subject::Patterned),
            (line == Line::Stroke(Paint::Unread) || line == Line::Filled(Paint::Unread), Subject::Color),
            (stroke != Paint::None && width > WIDE, Subject::Wide),
            (stroke != Paint::None && style.width <= 0.0, Subject::Thin),
            (stroke != Paint::None && style.dashed, Subject::Dashed),
        ] {
            if is_so {
                self.walked.report.count(subject, Some(key), id, at);
            }
        }
    }

    /// Adds a chain of a shape; returns whether there is anything of it.
    fn chain(&mut self, chain: &Chain, kind: &'static str, key: Key, element: u32, place: &Place) -> bool {
        let limits = &self.options.limits;
        let id = self.id(element);
        let path = trace::path(chain, &place.map, self.options.tolerance);
        let near = path.filter(|p| {
            let bounds = p.bounds();
            p.segments.is_empty() || (limits.is_near(bounds.min) && limits.is_near(bounds.max))
        });
        let Some(path) = near else {
            self.far += 1;
            let message = format!(
                "{} cannot be cut: it reaches farther than {} m from the origin.",
                named(kind, id),
                limits.coordinate / 1000.0
            );
            self.walked.report.invalid(message, key, id, None);
            return false;
        };
        if path.segments.is_empty() {
            let message = format!("{} cannot be cut: it has no length.", named(kind, id));
            self.walked.report.invalid(message, key, id, Some(place.map.point(chain.start)));
            return false;
        }
        self.elements += path.segments.len();
        let handle = id.map(str::to_owned);
        self.walked.shapes.push((key, Shape { path, layer: 0, color: 0, handle, kind, damaged: false }));
        true
    }

    /// Reports an element that is drawn and cannot be cut.
    pub(super) fn unsupported(&mut self, element: u32, name: &str, place: &Place) {
        // Elements of other languages (metadata, settings of programs) are never drawn.
        if name.is_empty() {
            return;
        }
        let first = |e: u32, name: &str| {
            let lengths = self.lengths(place);
            let word = self.document.attribute(e, name)?.split([' ', ',']).next()?;
            lengths.read(word, if name == "x" { Axis::Width } else { Axis::Height })
        };
        let nearest = |name: &str| {
            first(element, name)
                .or_else(|| self.document.children(element).find_map(|c| first(c, name)))
                .unwrap_or(0.0)
        };
        let hidden = place.hidden.or((!place.style.visible).then_some(Hidden::Invisible));
        let subject = match hidden {
            Some(why) => Subject::Hidden(why),
            None => Subject::Unsupported(name.chars().take(40).collect()),
        };
        // Only the first place is kept, and to look for that of every copy may take minutes.
        let at = (!self.walked.report.has(subject.clone()))
            .then(|| place.map.point(DVec2::new(nearest("x"), nearest("y"))));
        self.walked.report.count(subject, None, self.id(element), at);
    }
}

fn named(kind: &str, id: Option<&str>) -> String {
    id.map_or_else(|| format!("A {kind}"), |id| format!("{kind} \"{id}\""))
}
