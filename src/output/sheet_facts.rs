//! What a writer needs to know of the sheet: much less than a [`Sheet`] holds.

use crate::fields::through_value;
use crate::machine::{Process, Profile, Settings};
use crate::sheet::Sheet;
use serde::{Deserialize, Serialize};

/// The layers and contours of a sheet, as writers need them.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct SheetFacts {
    /// Layers, at the indices of the sheet.
    pub layers: Vec<LayerFacts>,
    /// Contours; the index is the contour's id.
    pub contours: Vec<ContourFacts>,
}

/// A layer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LayerFacts {
    /// Name.
    pub name: String,
    /// AutoCAD colour index.
    pub color: i16,
    /// What is set for its contours.
    #[serde(deserialize_with = "through_value")]
    pub settings: Settings,
}

/// A contour.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ContourFacts {
    /// Index of its layer.
    pub layer: u32,
    /// Whether it is marked, not cut.
    pub mark: bool,
    /// Whether its line returns to its start.
    pub closed: bool,
    /// Length of its line, mm.
    pub length: f64,
}

impl SheetFacts {
    /// What writers need of a sheet.
    pub fn of(sheet: &Sheet) -> Self {
        let layers = sheet.layers.iter().map(|layer| LayerFacts {
            name: layer.name.clone(),
            color: layer.color,
            settings: layer.settings,
        });
        let contours = sheet.contours.iter().map(|contour| ContourFacts {
            layer: contour.layer,
            mark: contour.is_mark(),
            closed: contour.path.closed,
            length: contour.path.length(),
        });
        Self { layers: layers.collect(), contours: contours.collect() }
    }

    /// The contour of this id.
    pub(super) fn contour(&self, id: u32) -> Option<&ContourFacts> {
        self.contours.get(id as usize)
    }

    fn layer(&self, contour: u32) -> Option<&LayerFacts> {
        self.contour(contour).and_then(|c| self.layers.get(c.layer as usize))
    }

    /// The name of a contour's layer; empty when the sheet does not know the contour.
    pub(super) fn layer_name(&self, contour: u32) -> &str {
        self.layer(contour).map_or("", |layer| layer.name.as_str())
    }

    /// What a machine works a contour with: the settings of its layer over the process of the machine.
    pub(super) fn process(&self, contour: u32, machine: &Profile) -> Process {
        let process = machine.process(self.contour(contour).is_some_and(|c| c.mark));
        self.layer(contour).map_or(*process, |layer| layer.settings.over(process))
    }
}
