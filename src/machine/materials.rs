//! The library of materials of a machine.

use super::profile::Profile;
use super::settings::MaterialSetting;
use crate::fields::{Fault, FieldError, shown};
use crate::letters::same_name;

impl Profile {
    /// The setting for a material. Names are compared without case and without spaces at their ends.
    pub fn material(&self, name: &str) -> Option<&MaterialSetting> {
        self.materials.iter().find(|m| same_name(&m.name, name))
    }

    /// The machine with a material of its library on it.
    ///
    /// # Errors
    /// The machine has no setting for it.
    pub fn with_material(self, name: &str) -> Result<Self, FieldError> {
        let Some(material) = self.material(name).cloned() else { return Err(self.lacks(name)) };
        Ok(Self {
            cut: material.cut.over(&self.cut),
            mark: material.mark.over(&self.mark),
            pierce_time: material.pierce_time.unwrap_or(self.pierce_time),
            kerf_width: material.kerf_width.unwrap_or(self.kerf_width),
            ..self
        })
    }

    /// The error for a material that the machine has no setting for.
    pub fn lacks(&self, name: &str) -> FieldError {
        let names: Vec<&str> = self.materials.iter().map(|m| m.name.as_str()).collect();
        let known = if names.is_empty() {
            "Its library is empty: add a setting to the machine.".to_owned()
        } else {
            format!("It has: {}.", names.iter().map(|n| shown(n)).collect::<Vec<_>>().join(", "))
        };
        let (machine, wanted) = (shown(&self.name), shown(name.trim()));
        let message = format!("The machine {machine} has no setting for the material \"{wanted}\". {known}");
        let choices = names.into_iter().map(str::to_owned).collect();
        FieldError::new(Fault::NotAChoice(choices), "material", message)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Process, Settings, preset};

    #[test]
    fn a_layer_is_over_the_material_and_the_material_over_the_machine() {
        let machine = Process { min_power: Some(0.5), ..Process::new(10.0, Some(100.0), 0.9) };
        let material = Settings { speed: Some(20.0), passes: Some(3), ..Settings::NONE };
        let layer = Settings { speed: Some(5.0), power: Some(0.3), air: Some(true), ..Settings::NONE };
        let process = layer.over(&material.over(&machine));
        let expected =
            Process { min_power: Some(0.3), passes: 3, air: true, ..Process::new(5.0, Some(100.0), 0.3) };
        assert_eq!(process, expected);
        assert_eq!(Settings::NONE.over(&machine), machine);
    }

    #[test]
    fn a_material_is_found_by_its_name_and_a_missing_one_is_said() {
        let ply = MaterialSetting {
            name: "3 mm Birch ply".into(),
            cut: Settings { speed: Some(7.0), ..Settings::NONE },
            mark: Settings::NONE,
            pierce_time: Some(0.25),
            kerf_width: Some(0.15),
        };
        let machine = Profile { materials: vec![ply], ..preset("diode-hobby").unwrap() };
        let with = machine.clone().with_material(" 3 mm birch PLY ").unwrap();
        assert_eq!((with.cut.speed, with.pierce_time, with.kerf_width), (7.0, 0.25, 0.15));
        assert_eq!(with.mark, machine.mark);
        assert!(!machine.lacks("\u{1b}[2J").message.contains(char::is_control), "a terminal would act on it");
        assert_eq!(
            machine.with_material("12 mm steel").unwrap_err().message,
            "The machine diode-hobby has no setting for the material \"12 mm steel\". It has: 3 mm Birch ply."
        );
    }
}
