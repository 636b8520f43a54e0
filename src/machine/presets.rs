//! Presets: machines with a material, as data. The figures are typical for a class of machines, not for one product.
//! They are good enough to compare paths and for rough quotes, and users replace them by their own.
//!
//! Sources: GRBL 1.1 settings `$110`/`$111` (top rates), `$120`/`$121` (accelerations), `$11` (junction deviation,
//! 0.010 mm by default) and `$30` (full power, 1000) in the GRBL wiki; data sheets and cutting tables published by
//! makers of such machines. The reason for each figure stands beside it.

use super::dialect::DialectChoice;
use super::levers::Levers;
use super::process::Process;
use super::profile::{Axes, Profile, Takes, Travel};
use super::profile_fields::VERSION;
use super::sharp_corner::SharpCorner;
use std::f64::consts::PI;

/// All presets, starting with the default.
pub fn presets() -> Vec<Profile> {
    vec![
        co2_100w(),
        diode_hobby(),
        fibre_3kw_thin(),
        fibre_6kw_thick(),
        fibre_6kw_plate(),
        co2_ruida(),
        k40(),
        co2_fluidnc(),
        co2_linuxcnc(),
        length("length", "Length only: air moves in mm along straight lines", Travel::Vector),
        length("length-chebyshev", "Length only: air moves in mm of the longer axis", Travel::PerAxis),
        Profile {
            pre_cut_time: Some(0.0),
            ..length("length-partial", "Length only, contours may be left unfinished", Travel::Vector)
        },
    ]
}

/// The preset with this name.
pub fn preset(name: &str) -> Option<Profile> {
    presets().into_iter().find(|p| p.name == name)
}

/// A gantry CO2 laser of 1600 x 1000 mm with a GRBL controller, 3 mm acrylic.
fn co2_100w() -> Profile {
    Profile {
        name: "co2-100w".to_owned(),
        title: "CO2 laser, 100 W, GRBL, 3 mm acrylic".to_owned(),
        // The format that makers call 1610.
        bed: Some([0.0, 0.0, 1600.0, 1000.0]),
        // GRBL runs rapids as straight lines, each axis within its own limit.
        travel: Travel::Straight,
        rapid: Axes {
            // Belt-driven optics head: 24 m/min for the light x, 18 m/min for the whole gantry in y.
            speed: [400.0, 300.0],
            // A third of g for the head, less for the gantry; belts still hold 0.1 mm at this.
            accel: Some([3000.0, 2000.0]),
        },
        // Published tables give 30 to 45 mm/s for a clean edge in 3 mm acrylic at 100 W.
        cut: Process::new(35.0, Some(2000.0), 0.85),
        // Vector engraving, far from cutting through.
        mark: Process::new(200.0, Some(2000.0), 0.15),
        // GRBL's default.
        junction_deviation: Some(0.01),
        // Acrylic is pierced while the tube reaches its power.
        pierce_time: 0.1,
        // A high-voltage CO2 supply rises and falls within a few ms.
        beam_on_delay: 0.005,
        beam_off_delay: 0.005,
        ..plain()
    }
}

/// An open-frame diode laser, 3 mm plywood.
fn diode_hobby() -> Profile {
    Profile {
        name: "diode-hobby".to_owned(),
        title: "Diode laser, 10 W, GRBL, 3 mm plywood".to_owned(),
        // The usual size of open frames.
        bed: Some([0.0, 0.0, 400.0, 400.0]),
        travel: Travel::Straight,
        rapid: Axes {
            // 10,000 mm/min in x and y, the usual `$110` and `$111` of such machines.
            speed: [10_000.0 / 60.0, 10_000.0 / 60.0],
            // Such machines are shipped with 500 to 1,000 mm/s2.
            accel: Some([800.0, 800.0]),
        },
        // 3 mm plywood is cut in one pass at 10 W optical power and about 300 mm/min.
        cut: Process::new(5.0, Some(800.0), 1.0),
        // Line engraving at 3,000 mm/min.
        mark: Process::new(50.0, Some(800.0), 0.4),
        junction_deviation: Some(0.01),
        // With M4 the head starts at once; at 5 mm/s the beam pierces while moving.
        pierce_time: 0.0,
        ..plain()
    }
}

/// A 3 kW fibre laser on thin sheet: 1 mm stainless steel with nitrogen.
fn fibre_3kw_thin() -> Profile {
    Profile {
        name: "fibre-3kw-thin".to_owned(),
        title: "Fibre laser, 3 kW, 1 mm stainless steel, nitrogen".to_owned(),
        // The common sheet size of 3 x 1.5 m.
        bed: Some([0.0, 0.0, 3000.0, 1500.0]),
        // Positioning moves each drive at its own limit ("simultaneous" speeds in data sheets are sqrt 2 higher).
        travel: Travel::PerAxis,
        rapid: Axes {
            // 100 m/min per axis, the common class of rack-and-pinion tables.
            speed: [100_000.0 / 60.0, 100_000.0 / 60.0],
            // 1 g.
            accel: Some([9810.0, 9810.0]),
        },
        // Cutting tables give 24 to 30 m/min for 1 mm at 3 kW.
        cut: Process::new(400.0, Some(5000.0), 1.0),
        // Marking with the same beam at low power.
        mark: Process::new(500.0, Some(5000.0), 0.1),
        // Such controllers round corners within a few hundredths of a millimetre.
        junction_deviation: Some(0.02),
        // Thin sheet is pierced in one pulse.
        pierce_time: 0.1,
        // The gas and the height control need time to settle.
        beam_on_delay: 0.05,
        beam_off_delay: 0.02,
        // CypCut and its like: contours come as DXF, and technology tables hold speeds and powers.
        takes: Takes::Dxf,
        ..plain()
    }
}

/// A 6 kW fibre laser on plate: 12 mm mild steel with oxygen.
fn fibre_6kw_thick() -> Profile {
    Profile {
        name: "fibre-6kw-thick".to_owned(),
        title: "Fibre laser, 6 kW, 12 mm mild steel, oxygen".to_owned(),
        // Cutting tables give about 2 m/min for 12 mm; the oxygen limits the speed, not the power.
        cut: Process::new(33.0, Some(3000.0), 0.7),
        mark: Process::new(250.0, Some(3000.0), 0.1),
        // Staged piercing of 12 mm takes half a second to a second.
        pierce_time: 0.8,
        // The oxygen pressure is built up and released.
        beam_on_delay: 0.2,
        beam_off_delay: 0.1,
        ..fibre_3kw_thin()
    }
}

/// A 6 kW fibre laser on thick plate: 20 mm mild steel with oxygen. Piercing is so expensive that partial cuts of
/// contours pay off, and sharp corners burn.
fn fibre_6kw_plate() -> Profile {
    Profile {
        name: "fibre-6kw-plate".to_owned(),
        title: "Fibre laser, 6 kW, 20 mm mild steel, oxygen".to_owned(),
        // Cutting tables give about 0.9 m/min for 20 mm.
        cut: Process::new(15.0, Some(3000.0), 0.9),
        // Staged piercing of 20 mm takes two to three seconds.
        pierce_time: 2.5,
        // 4 mm at cutting speed, back with the beam off, and the delays of the beam.
        pre_cut_time: Some(0.6),
        pre_cut_length: 4.0,
        // Corners of less than 75 degrees burn off in plate; one second lets them cool.
        sharp_corner: Some(SharpCorner { angle: 75.0 * PI / 180.0, time: 1.0 }),
        ..fibre_6kw_thick()
    }
}

/// A CO2 laser with a Ruida controller, 1000 x 600 mm, 3 mm acrylic. Its own program or LightBurn reads the DXF.
fn co2_ruida() -> Profile {
    Profile {
        name: "co2-ruida".to_owned(),
        title: "CO2 laser, 80 W, Ruida, 3 mm acrylic".to_owned(),
        // The format that makers call 1060.
        bed: Some([0.0, 0.0, 1000.0, 600.0]),
        rapid: Axes {
            // The factory setting of the idle speed of such machines.
            speed: [200.0, 200.0],
            // Factory settings of x and y: the gantry is heavier.
            accel: Some([8000.0, 3000.0]),
        },
        // Published tables give 15 to 25 mm/s for 3 mm acrylic at 80 W.
        cut: Process::new(20.0, Some(3000.0), 0.7),
        mark: Process::new(200.0, Some(3000.0), 0.15),
        takes: Takes::Dxf,
        ..co2_100w()
    }
}

/// A K40: 40 W, 300 x 200 mm, with the board it is sold with, 3 mm plywood. MeerK40t and K40 Whisperer read SVG.
fn k40() -> Profile {
    Profile {
        name: "k40".to_owned(),
        title: "K40, CO2, 40 W, 3 mm plywood".to_owned(),
        bed: Some([0.0, 0.0, 300.0, 200.0]),
        // The board moves both axes at its one rapid speed.
        travel: Travel::Vector,
        rapid: Axes { speed: [150.0, 150.0], accel: Some([1500.0, 1500.0]) },
        // 3 mm plywood is cut in one pass at about 8 mm/s; the tube should not be run at full current.
        cut: Process::new(8.0, Some(1000.0), 0.6),
        mark: Process::new(100.0, Some(1000.0), 0.15),
        takes: Takes::Svg,
        ..co2_100w()
    }
}

/// A desktop CO2 laser of 500 x 300 mm with a FluidNC board, 3 mm plywood: the usual conversion of machines of 50 W.
fn co2_fluidnc() -> Profile {
    Profile {
        name: "co2-fluidnc".to_owned(),
        title: "CO2 laser, 50 W, FluidNC, 3 mm plywood".to_owned(),
        // The format that makers call 5030.
        bed: Some([0.0, 0.0, 500.0, 300.0]),
        // 18 m/min: `max_rate_mm_per_min` of converted machines; the heavier y axis accelerates less.
        rapid: Axes { speed: [300.0, 300.0], accel: Some([2500.0, 1500.0]) },
        // Published tables give 12 to 18 mm/s for 3 mm plywood at 50 W.
        cut: Process::new(15.0, Some(1500.0), 0.8),
        mark: Process::new(150.0, Some(1500.0), 0.15),
        // Plywood is pierced at once.
        pierce_time: 0.05,
        dialect: DialectChoice::named("fluidnc"),
        ..co2_100w()
    }
}

/// A gantry with a CO2 tube of 150 W, 1300 x 900 mm, run by LinuxCNC with the power on an analog output, 6 mm plywood.
fn co2_linuxcnc() -> Profile {
    Profile {
        name: "co2-linuxcnc".to_owned(),
        title: "CO2 gantry, 150 W, LinuxCNC, 6 mm plywood".to_owned(),
        // The format that makers call 1390.
        bed: Some([0.0, 0.0, 1300.0, 900.0]),
        // Ball screws or racks with servos: 30 m/min, a quarter of g.
        rapid: Axes { speed: [500.0, 500.0], accel: Some([2500.0, 2500.0]) },
        // Published tables give 15 to 20 mm/s for 6 mm plywood at 150 W.
        cut: Process::new(17.0, Some(2500.0), 0.85),
        mark: Process::new(200.0, Some(2500.0), 0.12),
        // `G64 P` of a few hundredths of a millimetre is usual for lasers.
        junction_deviation: Some(0.02),
        pierce_time: 0.2,
        // A gantry with a driven head, at 15 mm/s.
        z_speed: Some(15.0),
        dialect: DialectChoice::named("linuxcnc-m67"),
        ..co2_100w()
    }
}

/// Unit speed without acceleration and charges, so that seconds are millimetres of air move, as in published
/// comparisons.
fn length(name: &str, title: &str, travel: Travel) -> Profile {
    Profile { name: name.to_owned(), title: title.to_owned(), travel, ..plain() }
}

/// What the presets have in common: from the origin and back, with G-code for GRBL, and without anything that only some machines do.
/// It has unit speed and charges nothing.
fn plain() -> Profile {
    Profile {
        version: VERSION,
        name: String::new(),
        title: String::new(),
        home: [0.0, 0.0],
        bed: None,
        return_home: true,
        travel: Travel::Straight,
        rapid: Axes { speed: [1.0, 1.0], accel: None },
        cut: Process::new(1.0, None, 1.0),
        mark: Process::new(1.0, None, 0.1),
        junction_deviation: None,
        pierce_time: 0.0,
        pre_cut_time: None,
        pre_cut_length: 0.0,
        sharp_corner: None,
        kerf_width: 0.0,
        z_speed: None,
        materials: Vec::new(),
        leads: None,
        levers: Levers::default(),
        joints: None,
        skeleton: None,
        beam_on_delay: 0.0,
        beam_off_delay: 0.0,
        takes: Takes::Gcode,
        dialect: DialectChoice::named("grbl-m4"),
        max_s: 1000.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presets_are_valid_and_found_by_unique_names() {
        let all = presets();
        assert_eq!(all[0].name, "co2-100w");
        for p in &all {
            p.validate().unwrap();
            assert_eq!(all.iter().filter(|q| q.name == p.name).count(), 1);
            assert_eq!(preset(&p.name).as_ref(), Some(p));
        }
        assert_eq!(preset("abacus"), None);
    }

    #[test]
    fn errors_name_the_field() {
        let message = |change: fn(&mut Profile)| {
            let mut p = co2_100w();
            change(&mut p);
            p.validate().unwrap_err().to_string()
        };
        assert_eq!(
            message(|p| p.mark.power = 1.5),
            "The machine's field \"mark.power\" is 1.5. Give a number from 0 to 1: it is a fraction of full power."
        );
        assert!(
            message(|p| p.rapid.speed[1] = 0.0)
                .starts_with("The machine's field \"rapid.speed[1]\" is 0. Give")
        );
        assert!(message(|p| p.cut.accel = Some(f64::NAN)).contains("\"cut.accel\" is NaN. Give"));
        assert!(message(|p| p.home[0] = f64::INFINITY).contains("\"home[0]\" is Infinity. Give"));
        assert!(message(|p| p.pierce_time = -0.1).contains("\"pierce_time\" is -0.1. Give"));
        assert!(message(|p| p.pre_cut_time = Some(-1.0)).contains("\"pre_cut_time\" is -1. Give"));
        assert!(message(|p| p.max_s = 1e300).contains("\"max_s\" is 1e300. Give"));
        assert!(message(|p| p.version = 2).contains("\"version\" is 2. Give 1: this Kerfway reads"));
    }

    #[test]
    fn profiles_without_pre_cut_fields_cut_in_one_go() {
        let text = serde_json::to_string(&co2_100w()).unwrap().replace("\"pre_cut_time\":null,", "");
        assert!(!text.contains("pre_cut"));
        assert_eq!(serde_json::from_str::<Profile>(&text).unwrap(), co2_100w());
    }

    #[test]
    fn profiles_round_trip_through_json() {
        for p in presets() {
            let text = serde_json::to_string(&p).unwrap();
            assert_eq!(serde_json::from_str::<Profile>(&text).unwrap(), p);
        }
    }
}
