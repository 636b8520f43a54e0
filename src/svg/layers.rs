//! Names the layers: by the layers of Inkscape and Illustrator, and by colours, as users of LightBurn and Glowforge know it.
//!
//! A layer of which all shapes have the same colour keeps its name. Where a drawing has several layers, one with more
//! colours is divided, and its name comes before the colour. A drawing without layers, or with one of several colours, is
//! divided by colour only, because Inkscape makes one layer for every drawing.

use super::color::Rgb;
use super::style::Paint;
use crate::drawing::{Layer, Shape};
use std::collections::{BTreeMap, BTreeSet};

/// What a shape is drawn with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Line {
    /// A stroke.
    Stroke(Paint),
    /// Only the edge of a filled area.
    Filled(Paint),
}

impl Line {
    fn paint(self) -> Paint {
        match self {
            Self::Stroke(paint) | Self::Filled(paint) => paint,
        }
    }

    fn name(self) -> String {
        let paint = match self.paint() {
            Paint::Color(rgb) => rgb.hex(),
            Paint::Pattern => "pattern".to_owned(),
            Paint::Unread => "unknown colour".to_owned(),
            Paint::Other | Paint::None | Paint::Current => "gradient".to_owned(),
        };
        match self {
            Self::Stroke(_) => paint,
            Self::Filled(_) => format!("fill {paint}"),
        }
    }

    fn color(self) -> i16 {
        match self.paint() {
            Paint::Color(rgb) => rgb.nearest_index(),
            _ => Rgb::BLACK.nearest_index(),
        }
    }
}

/// Where a shape belongs: the index of its group in the list of groups that are layers, and what it is drawn with.
pub(super) type Key = (Option<u32>, Line);

/// The layers of a drawing by key.
pub(super) type Names = BTreeMap<Key, String>;

/// Names the layers of shapes, which have the index of their key for their layer; `groups` are the labels of groups that
/// are layers.
pub(super) fn name(shapes: Vec<(Key, Shape)>, groups: &[String]) -> (Vec<Layer>, Vec<Shape>, Names) {
    let keys: BTreeSet<Key> = shapes.iter().map(|(key, _)| *key).collect();
    let mut lines_in: BTreeMap<Option<u32>, usize> = BTreeMap::new();
    for (group, _) in &keys {
        *lines_in.entry(*group).or_default() += 1;
    }
    let by_group = lines_in.len() > 1;
    let name_of = |&(group, line): &Key| {
        let label = group.and_then(|g| groups.get(g as usize)).filter(|l| !l.trim().is_empty());
        match label {
            Some(label) if lines_in.get(&group) == Some(&1) => label.trim().to_owned(),
            Some(label) if by_group => format!("{} {}", label.trim(), line.name()),
            _ => line.name(),
        }
    };
    let names: Names = keys.iter().map(|key| (*key, name_of(key))).collect();
    // In the order in which the drawing uses them.
    let mut layers: Vec<Layer> = Vec::new();
    let mut indices: BTreeMap<String, u32> = BTreeMap::new();
    let mut named = Vec::with_capacity(shapes.len());
    for (key, shape) in shapes {
        let name = names.get(&key).cloned().unwrap_or_default();
        let next = u32::try_from(layers.len()).unwrap_or(u32::MAX);
        let layer = *indices.entry(name.clone()).or_insert(next);
        if layer == next {
            layers.push(Layer { name, color: key.1.color(), visible: true });
        }
        named.push(Shape { layer, color: key.1.color(), ..shape });
    }
    (layers, named, names)
}
