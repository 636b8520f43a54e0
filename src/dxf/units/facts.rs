//! What a drawing shows about its unit, in drawing units.

use crate::dxf::entity::{Entity, Geometry, Hidden};
use crate::dxf::file::File;

/// Most values of a kind that are looked at. Thousands say no more than hundreds.
const MOST: usize = 2_000;
/// Values that differ by less than this fraction are the same, drawn with other digits.
const SAME: f64 = 1e-5;

/// Facts about a drawing, without its paper layouts.
#[derive(Debug, Default)]
pub(super) struct Facts {
    /// The larger extent; 0 when unknown.
    pub(super) extent: f64,
    /// Distinct diameters of circles, ascending.
    pub(super) diameters: Vec<f64>,
    /// Distinct lengths of straight sides, ascending.
    pub(super) lengths: Vec<f64>,
    /// Heights of texts.
    pub(super) text_heights: Vec<f64>,
    /// Names of layers that hold something.
    pub(super) layers: Vec<String>,
}

impl Facts {
    /// The facts of a file whose larger extent is `extent`.
    pub(super) fn of(file: &File<'_>, extent: f64) -> Self {
        let mut facts = Self { extent, text_heights: file.text_heights.clone(), ..Self::default() };
        let mut used = vec![false; file.layers.list().len()];
        let entities = file.model.iter().chain(file.blocks.iter().flat_map(|b| &b.entities));
        for entity in entities.filter(|e| e.hidden != Some(Hidden::Paper)) {
            facts.take(entity);
            if let Some(used) = used.get_mut(entity.layer as usize) {
                *used = true;
            }
        }
        let names = file.layers.list().iter().zip(used).filter(|(_, used)| *used);
        facts.layers = names.map(|(l, _)| String::from_utf8_lossy(l.name).into_owned()).take(MOST).collect();
        distinct(&mut facts.diameters);
        distinct(&mut facts.lengths);
        facts
    }

    fn take(&mut self, entity: &Entity<'_>) {
        match &entity.geometry {
            Geometry::Arc { radius, end: None, .. } => push(&mut self.diameters, 2.0 * radius),
            Geometry::Line(a, b) => push(&mut self.lengths, a.distance(*b)),
            Geometry::Polyline { vertices, .. } => {
                for pair in vertices.windows(2) {
                    if let [a, b] = pair
                        && a.bulge.abs() <= 0.0
                    {
                        push(&mut self.lengths, a.at.distance(b.at));
                    }
                }
            }
            _ => {}
        }
    }
}

fn push(list: &mut Vec<f64>, value: f64) {
    if list.len() < 4 * MOST && value.is_finite() && value > 0.0 {
        list.push(value);
    }
}

fn distinct(list: &mut Vec<f64>) {
    crate::order::sort_by(list, |&v| [crate::order::real(v), 0, 0]);
    list.dedup_by(|b, a| (*b - *a).abs() <= SAME * *a);
    list.truncate(MOST);
}
