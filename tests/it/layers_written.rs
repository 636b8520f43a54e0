//! What a layer is set to, in every kind of file: G-code, LightBurn projects and Ruida files; and what a file cannot hold.

use kerfway::job::{Job, LayerChoice, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::dialect::DialectChoice;
use kerfway::machine::{MaterialSetting, Profile, Settings, preset};
use kerfway::sheet::{Operation, PassOrder};
use std::collections::BTreeSet;

/// A square on layer CUT and a line on layer LINE.
fn drawing() -> Vec<u8> {
    let square =
        [(10, 10), (60, 10), (60, 60), (10, 60)].map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).concat();
    let line = "0\nLINE\n8\nLINE\n10\n20\n20\n30\n11\n40\n21\n30\n";
    let header = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    format!("{header}0\nLWPOLYLINE\n8\nCUT\n90\n4\n70\n1\n{square}{line}0\nENDSEC\n0\nEOF\n").into_bytes()
}

fn machine() -> Profile {
    let setting = MaterialSetting {
        name: "3 mm birch ply".into(),
        cut: Settings { speed: Some(12.0), ..Settings::NONE },
        mark: Settings::NONE,
        pierce_time: Some(0.25),
        kerf_width: None,
    };
    Profile { materials: vec![setting], z_speed: Some(5.0), ..preset("co2-100w").unwrap() }
}

/// The square in three passes with settings of its own, the line marked.
fn planned(machine: Profile, change: impl FnOnce(&mut LayerChoice)) -> Job {
    let mut cut = LayerChoice::new("CUT", Operation::Cut);
    (cut.speed, cut.power, cut.min_power, cut.passes) = (Some(7.5), Some(0.6), Some(0.25), Some(3));
    change(&mut cut);
    let mut line = LayerChoice::new("LINE", Operation::Mark);
    (line.speed, line.power) = (Some(120.0), Some(0.125));
    let load =
        LoadOptions { layers: vec![cut, line], pass_order: PassOrder::Contour, ..LoadOptions::default() };
    let mut job = Job::load(drawing(), "layers.dxf", &load).unwrap();
    let options = PlanOptions {
        machine: MachineChoice::Profile(Box::new(machine)),
        material: Some("3 mm birch ply".into()),
        seed: 1,
        moves: Some(100),
        ..PlanOptions::default()
    };
    job.start(&options).unwrap();
    job.run_mut().unwrap().step(100);
    job
}

/// The values of a field in the layers of a LightBurn project.
fn values<'a>(project: &'a str, field: &str) -> Vec<&'a str> {
    let open = format!("<{field} Value=\"");
    project.split(&open).skip(1).map(|rest| rest.split('"').next().unwrap()).collect()
}

#[test]
fn lightburn_layers_carry_speed_powers_air_and_height() {
    let job = planned(machine(), |l| (l.z_step, l.air) = (Some(0.8), Some(true)));
    let project = job.output(OutputKind::Lbrn2).unwrap();
    // The mark, and three passes at three heights.
    let (speeds, shapes) = (values(&project, "speed"), project.matches("<Shape ").count());
    assert_eq!((speeds.len(), shapes), (4, 4), "{project}");
    let layers: BTreeSet<[&str; 5]> = ["speed", "minPower", "maxPower", "runBlower", "zOffset"]
        .map(|field| values(&project, field))
        .iter()
        .fold(vec![Vec::new(); 4], |mut rows, column| {
            rows.iter_mut().zip(column).for_each(|(row, value)| row.push(*value));
            rows
        })
        .into_iter()
        .map(|row| row.try_into().unwrap())
        .collect();
    let pass = |z| ["7.5", "25", "60", "1", z];
    assert_eq!(
        layers,
        BTreeSet::from([["120", "12.5", "12.5", "0", "0"], pass("0"), pass("0.8"), pass("1.6")])
    );
    assert_eq!(values(&project, "numPasses"), ["1"; 4]);
    // Shapes point to the layer of their pass, and passes follow each other.
    let order: Vec<&str> =
        project.split("CutIndex=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    let heights: Vec<&str> =
        order.iter().map(|index| values(&project, "zOffset")[index.parse::<usize>().unwrap()]).collect();
    assert!(heights.ends_with(&["0", "0.8", "1.6"]), "{heights:?}");
}

#[test]
fn lightburn_shows_what_the_project_does_not_hold() {
    let project = planned(machine(), |_| {}).output(OutputKind::Lbrn2).unwrap();
    // 0.25 s of the material and 5 ms of the beam.
    assert!(
        project.contains("<Notes ShowOnLoad=\"1\" Notes=\"Piercing is not in this project: set the start pause time of the cutting layers to 0.255 s.\"/>"),
        "{project}"
    );
    let mut quick = machine();
    (quick.materials[0].pierce_time, quick.beam_on_delay) = (Some(0.0), 0.0);
    let project = planned(quick, |_| {}).output(OutputKind::Lbrn2).unwrap();
    assert!(project.contains("<Notes ShowOnLoad=\"0\" Notes=\"\"/>"), "{project}");
}

/// The commands of a Ruida file, unscrambled.
fn commands(bytes: &[u8]) -> Vec<Vec<u8>> {
    let plain = bytes.iter().map(|b| {
        let byte = b.wrapping_sub(1) ^ 0x88;
        (byte & 0x7E) | (byte >> 7) | (byte << 7)
    });
    let mut commands: Vec<Vec<u8>> = Vec::new();
    for byte in plain {
        match commands.last_mut().filter(|_| byte < 0x80) {
            Some(command) => command.push(byte),
            None => commands.push(vec![byte]),
        }
    }
    commands
}

/// A number of bytes with seven bits each.
fn number(bytes: &[u8]) -> f64 {
    f64::from(bytes.iter().fold(0_u32, |n, b| (n << 7) | u32::from(*b)))
}

#[test]
fn ruida_parts_carry_speed_powers_and_air_and_every_pass_is_cut() {
    let job = planned(machine(), |l| l.air = Some(true));
    let commands = commands(&job.output_bytes(OutputKind::Rd).unwrap());
    // Of every cut: speed in mm/s, least and largest power in per cent, air.
    let (mut speed, mut least, mut most, mut air) = (0.0, 0.0, 0.0, false);
    let mut cuts = Vec::new();
    let percent = |bytes: &[u8]| (number(bytes) / 163.83 * 10.0).round() / 10.0;
    for command in &commands {
        match command.as_slice() {
            [0xC9, 0x02, rest @ ..] => speed = number(rest) / 1000.0,
            [0xC6, 0x01, rest @ ..] => least = percent(rest),
            [0xC6, 0x02, rest @ ..] => most = percent(rest),
            [0xCA, 0x01, flag @ (0x12 | 0x13)] => air = *flag == 0x13,
            [0x88, ..] => cuts.push((speed, least, most, air)),
            _ => {}
        }
    }
    assert_eq!(
        cuts,
        [
            (120.0, 12.5, 12.5, false),
            (7.5, 25.0, 60.0, true),
            (7.5, 25.0, 60.0, true),
            (7.5, 25.0, 60.0, true)
        ]
    );
}

#[test]
fn ruida_files_refuse_passes_that_lower_the_head() {
    let job = planned(machine(), |l| l.z_step = Some(0.8));
    assert_eq!(
        job.output_bytes(OutputKind::Rd).unwrap_err().to_string(),
        "Ruida files of Kerfway do not lower the head: set the z step of the passes to 0, or write a LightBurn project."
    );
}

#[test]
fn programs_switch_the_air_and_lower_the_head_as_the_layer_says_and_name_the_material() {
    let code = |dialect: &str, change: fn(&mut LayerChoice)| {
        let machine = Profile { dialect: DialectChoice::named(dialect), ..machine() };
        planned(machine, change).output(OutputKind::Gcode).map_err(|e| e.to_string())
    };
    for dialect in ["grbl-m4", "fluidnc", "linuxcnc-m67"] {
        let text = code(dialect, |l| (l.z_step, l.air) = (Some(0.8), Some(true))).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let place = |wanted: &str| lines.iter().position(|l| *l == wanted).unwrap();
        assert!(text.contains("material 3 mm birch ply"), "{dialect}: {text}");
        // Marked without air; the passes are at 0, -0.8 and -1.6 mm, and the head comes up at the end.
        assert!(
            place("G0 Z-0.8") < place("G0 Z-1.6") && place("G0 Z-1.6") < place("G0 Z0"),
            "{dialect}: {text}"
        );
        assert!(place("M8") < place("G0 Z-0.8") && place("M9") > place("G0 Z-1.6"), "{dialect}: {text}");
    }
    let refused = |dialect: &str, change: fn(&mut LayerChoice)| code(dialect, change).unwrap_err();
    assert!(
        refused("smoothie", |l| l.air = Some(true))
            .contains("has no command for air: switch the air off in the layers")
    );
    assert!(
        refused("template", |l| l.z_step = Some(0.8))
            .contains("has no Z axis: set the z step of the passes to 0")
    );
}

#[test]
fn a_least_power_is_said_to_be_left_out_of_g_code() {
    let said = |job: &Job| job.run().unwrap().findings.iter().map(|f| f.message.clone()).collect::<Vec<_>>();
    assert_eq!(
        said(&planned(machine(), |_| {})),
        [
            "Layer CUT has a least power, for which G-code has no word: only LightBurn projects and Ruida files carry it."
        ]
    );
    assert!(said(&planned(machine(), |l| l.min_power = None)).is_empty());
}
