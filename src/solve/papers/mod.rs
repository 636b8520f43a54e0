//! Methods of published papers, built as published, behind the same traits as our own. They are here for comparison, and
//! for readers who know the papers. For cutting a sheet, the default method is always the better choice.
//!
//! Every parameter of a paper is a documented field whose default is the paper's value. Where a paper leaves something
//! open, or an equation is misprinted, the module of the method states what was built and why. Where a paper can be read in
//! several ways, each reading is a value of a parameter, and two presets name sets of them: "as-published" and "at-its-best"
//! (`presets.rs`). Most departures from a paper are parameters as well: `docs/methods.md` lists them with how to switch each
//! of them off, and names those that have no parameter.
//!
//! A method compares solutions by the paper's measure (`legs.rs`), not by the seconds of the whole job. The best solution
//! it reports is one it found itself, even where the nearest-neighbour tour is better; otherwise a comparison would show
//! nothing.
//!
//! The methods are compiled with the feature `research` only. The page downloads that wasm file when one of them is
//! selected.

mod dual;
mod feature_points;
mod hull;
mod keys;
mod legs;
mod local;
mod parameters;
mod piecewise;
mod presets;
mod published;
mod repair;
mod roulette;
mod swarm;
#[cfg(test)]
mod test_sheet;
mod tree;
mod unvisited;

pub use dual::DualCodingGa;
pub use feature_points::{feature_points, with_feature_points};
pub use hull::{
    Encoding, HullPso, HullSettings, MeanReward, NextAction, Ofa, OperatorRates, ReversedRun, Rlsga, Sga, Woa,
};
pub use keys::Decode;
pub use legs::{Legs, Measure};
pub use repair::Repair;
pub use swarm::{
    AcoPso, Draws, Flights, Initial, KPso, Kappa, Lpspso, Pso, Regret, Shortest, Stagnation, Step4,
    SwarmSettings, Weights,
};
pub use tree::{
    FinalEntries, GtspLk, InitialPartitions, InitialTours, PartitionTree, Pfr, Reattach, RepartitionMoves,
    TourRepair,
};

use super::{Solver, SolverInfo};
use crate::fields::{Fault, FieldError};
use published::Published;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// A method and its parameters, for lists.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "PaperMethod"))]
pub struct Card {
    /// Name and citation.
    #[serde(flatten)]
    pub info: SolverInfo,
    /// Parameters with their default values, the paper's where it gives them.
    #[cfg_attr(test, ts(type = "Record<string, unknown>"))]
    pub parameters: serde_json::Value,
    /// The parameters that each preset changes, by the name of the preset. The parameter `preset` selects one.
    #[cfg_attr(test, ts(type = "Record<string, Record<string, unknown>>"))]
    pub presets: serde_json::Value,
}

/// A method with its default parameters, and the function that makes it from given ones.
type Entry = (fn() -> Card, Make);
type Make = fn(&str) -> Result<Box<dyn Solver>, String>;

/// All methods.
const METHODS: &[Entry] = &[
    entry::<Lpspso>(),
    entry::<Pso>(),
    entry::<AcoPso>(),
    entry::<KPso>(),
    entry::<Rlsga>(),
    entry::<Sga>(),
    entry::<HullPso>(),
    entry::<Ofa>(),
    entry::<Woa>(),
    entry::<DualCodingGa>(),
    entry::<PartitionTree>(),
    entry::<Pfr>(),
    entry::<GtspLk>(),
];

/// All methods with the default values of their parameters.
pub fn cards() -> Vec<Card> {
    METHODS.iter().map(|(card, _)| card()).collect()
}

/// The names of all methods.
pub fn names() -> impl Iterator<Item = &'static str> {
    METHODS.iter().map(|(card, _)| card().info.name)
}

/// The published method of that name. `parameters` is a JSON object with the values that differ from the defaults, or
/// empty.
///
/// # Errors
/// There is no such method, or it has no such parameter or value.
pub fn method(name: &str, parameters: &str) -> Result<Box<dyn Solver>, FieldError> {
    let Some((_, make)) = METHODS.iter().find(|(card, _)| card().info.name == name) else {
        let names: Vec<_> = names().collect();
        return Err(FieldError::no_such("method", name, &names));
    };
    let parameters = if parameters.trim().is_empty() { "{}" } else { parameters };
    let made =
        make(parameters).map_err(|message| FieldError::new(Fault::Parameter, "parameters", message))?;
    Ok(Box::new(Published(made)))
}

/// The entry of [`METHODS`] for a method whose parameters are the fields of its struct.
const fn entry<M: Solver + Default + Serialize + DeserializeOwned + 'static>() -> Entry {
    (card::<M>, make::<M>)
}

fn card<M: Solver + Default + Serialize>() -> Card {
    let method = M::default();
    let info = method.info();
    let presets = presets::of(info.name);
    Card { parameters: serde_json::to_value(&method).unwrap_or_default(), presets, info }
}

fn make<M: Solver + Default + Serialize + DeserializeOwned + 'static>(
    parameters: &str,
) -> Result<Box<dyn Solver>, String> {
    let presets = presets::of(M::default().info().name);
    Ok(Box::new(parameters::read::<M>(parameters, &presets)?))
}

#[cfg(test)]
mod tests {
    use super::test_sheet::sheet;
    use super::{Lpspso, cards, method, parameters, presets};

    fn refusal(name: &str, parameters: &str) -> String {
        method(name, parameters).err().unwrap().message
    }

    #[test]
    fn a_misspelt_shared_parameter_is_refused_with_the_nearest_name() {
        for name in ["pso", "aco-pso", "k-pso", "lpspso"] {
            let says = "The method has no parameter \"particels\". Did you mean \"particles\"?";
            assert_eq!(refusal(name, r#"{"particels":12}"#), says, "{name}");
        }
        for name in ["rlsga", "sga", "hull-pso", "ofa", "woa"] {
            let says = "The method has no parameter \"generation\". Did you mean \"generations\"?";
            assert_eq!(refusal(name, r#"{"generation":12}"#), says, "{name}");
        }
        assert_eq!(
            refusal("woa", r#"{"settings":{}}"#),
            "The method has no parameter \"settings\". There are: a, a_min, b, c, encoding, generations, measure, population."
        );
    }

    #[test]
    fn every_preset_of_every_method_can_be_selected_and_changed() {
        for card in cards() {
            let presets = card.presets.as_object().unwrap();
            assert_eq!(
                presets.keys().collect::<Vec<_>>(),
                ["as-published", "at-its-best"],
                "{}",
                card.info.name
            );
            for name in presets.keys() {
                method(card.info.name, &format!(r#"{{"preset":"{name}"}}"#)).unwrap();
            }
        }
        let read = |text| parameters::read::<Lpspso>(text, &presets::of("lpspso"));
        let published = read(r#"{"preset":"as-published"}"#).unwrap();
        assert!(!published.settings.local_search && !published.flights_must_gain);
        // Permutations are shorter than random keys for two of the three comparators of RLSGA.
        let best = |method: &str| presets::of(method)["at-its-best"]["encoding"].clone();
        assert_eq!(
            ["hull-pso", "woa", "ofa"].map(best),
            ["permutation".into(), "permutation".into(), serde_json::Value::Null]
        );
        // A parameter given beside a preset wins, in either order.
        for text in [
            r#"{"preset":"as-published","local_search":true}"#,
            r#"{"local_search":true,"preset":"as-published"}"#,
        ] {
            let changed = read(text).unwrap();
            assert!(changed.settings.local_search && !changed.flights_must_gain, "{text}");
        }
        assert_eq!(
            refusal("lpspso", r#"{"preset":"as-publishd"}"#),
            "There is no preset named \"as-publishd\". Did you mean \"as-published\"? Choose one of: as-published, at-its-best."
        );
        assert!(refusal("lpspso", r#"{"preset":1}"#).starts_with("The preset is 1: "));
    }

    /// A negative largest velocity panicked.
    #[test]
    fn no_number_that_is_taken_for_a_parameter_panics() {
        let corners: Vec<Vec<[f64; 2]>> = (0..6)
            .map(|k| {
                let (x, y) = (f64::from(k % 3) * 20.0, f64::from(k / 3) * 20.0);
                vec![[x, y], [x + 9.0, y], [x + 9.0, y + 9.0], [x, y + 9.0]]
            })
            .collect();
        let problem =
            sheet(&corners.iter().map(Vec::as_slice).collect::<Vec<_>>(), Some(0.5), "length-partial");
        let (mut taken, mut refused) = (0, 0);
        for card in cards() {
            let defaults = card.parameters.as_object().unwrap();
            for (name, _) in defaults.iter().filter(|(_, value)| value.is_number()) {
                for number in ["-1000000000", "-1", "0", "0.3", "3", "1000000000"] {
                    let mut given = serde_json::Map::new();
                    // A few members, so that there are many rounds.
                    for (few, count) in [("particles", 4), ("population", 4), ("gtsp_moves", 50)] {
                        if defaults.contains_key(few) {
                            given.insert(few.into(), count.into());
                        }
                    }
                    given.insert(name.clone(), serde_json::from_str(number).unwrap());
                    let text = serde_json::Value::from(given).to_string();
                    let Ok(made) = method(card.info.name, &text) else {
                        refused += 1;
                        continue;
                    };
                    let mut search = made.start(&problem, 1, None);
                    for _ in 0..40 {
                        search.step(500);
                    }
                    assert!(search.best().cost.is_finite(), "{} {text}", card.info.name);
                    taken += 1;
                }
            }
        }
        assert!(taken > 300 && refused > 100, "{taken} {refused}");
        let negative = refusal("pso", r#"{"fastest":-1}"#);
        assert_eq!(
            negative,
            "The parameter \"fastest\" is -1. Give a number from 0 to 1000000000: a velocity is limited in both directions."
        );
    }

    #[test]
    fn shared_parameters_are_flat_and_keep_the_defaults_of_their_method() {
        let default = |name: &str, parameter: &str| {
            let card = cards().into_iter().find(|c| c.info.name == name).unwrap();
            assert!(card.parameters.as_object().unwrap().values().all(|v| !v.is_object()), "{name}");
            card.parameters[parameter].clone()
        };
        assert_eq!((default("pso", "fastest"), default("lpspso", "fastest")), (0.2.into(), 0.05.into()));
        assert_eq!((default("woa", "population"), default("sga", "crossover")), (200.into(), 0.6.into()));
        // Giving one shared parameter leaves the others at the defaults of the method.
        let path = parameters::read::<Lpspso>(r#"{"particles":7}"#, &presets::of("lpspso")).unwrap();
        assert_eq!((path.settings.particles, path.settings.fastest), (7, 0.05));
    }
}
