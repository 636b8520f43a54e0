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
    /// Where the passes of the sheet follow each other: the contour of which this is a pass, the number of the pass, and of all passes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pass: Option<[u32; 3]>,
}

impl SheetFacts {
    /// What writers need of a sheet.
    pub fn of(sheet: &Sheet) -> Self {
        let layers = sheet.layers.iter().map(|layer| LayerFacts {
            name: layer.name.clone(),
            color: layer.color,
            settings: layer.settings,
        });
        let contours = (0..).zip(&sheet.contours).map(|(id, contour)| ContourFacts {
            layer: contour.layer,
            mark: contour.is_mark(),
            closed: contour.path.closed,
            length: contour.path.length(),
            pass: pass_of(sheet, id),
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

    /// What people call a contour: its number, and which of its passes it is.
    pub(super) fn called(&self, contour: u32) -> String {
        match self.contour(contour).and_then(|c| c.pass) {
            Some([of, pass, passes]) => format!("{of}, pass {pass}/{passes}"),
            None => contour.to_string(),
        }
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

/// The contour of which this is a pass, the number of the pass, and of all passes; `None` where there is one.
fn pass_of(sheet: &Sheet, id: u32) -> Option<[u32; 3]> {
    let number = |id: u32| sheet.contours.get(id as usize).map(|c| c.pass + 1);
    let last = sheet.last_pass(id);
    let (pass, passes) = (number(id)?, number(last)?);
    (passes > 1).then_some([last, pass, passes])
}
