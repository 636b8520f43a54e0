//! Two sets of parameters for each method. "as-published" takes the paper's reading of every equation and step, except for
//! misprints. It keeps the limits that only save time (`neighbourhood`, `proximity_steps`).
//! "at-its-best" is the set that reached the shortest paths in our measurements (`docs/papers`).

use serde_json::{Value, json};

/// The presets of a method, by name: the parameters that differ from the defaults.
pub(super) fn of(method: &str) -> Value {
    // One velocity limit and one rule for drawing random numbers for all four swarms: the paper gives no other. The order
    // comes from the particle, and the entry from the proximity rule, as in its published sequences.
    let swarm = json!({
        "local_search": false, "decode": "order-nearest", "draws": "equation", "fastest": 0.2,
    });
    let none = json!({});
    let (published, best) = match method {
        // (16) to (27), steps 5 and 7 as printed: kappa has an index of the particle, step 7 goes back to step 4, and no
        // flight is undone. Step 5 of the proximity method compares D of (2).
        "lpspso" => (
            merged(
                &swarm,
                &json!({
                    "kappa": "particle", "stagnation": "step4", "flights_must_gain": false, "shortest": "between",
                }),
            ),
            none,
        ),
        "pso" | "aco-pso" | "k-pso" => (swarm, none),
        // (6) without a scale. (9) by its sentence: as printed it would nearly always punish.
        "rlsga" => (json!({ "scaled_fitness": false }), json!({ "scaled_fitness": false })),
        // On both sheets shorter than on random keys (`docs/papers/hull-parts-2023.md`).
        "hull-pso" | "woa" => (none, json!({ "encoding": "permutation" })),
        // Eq. (1) has no legs from and to home.
        "dual-coding-ga" => (json!({ "home_legs": false }), none),
        // "Only at some predefined points on the boundary": where elements meet. "Simply the reattachment" (4.5), and "new
        // entry/exit nodes of the moved pierce groups" (4.6).
        "partition-tree" => {
            (json!({ "nodes": "element-ends", "reattach": "as-it-is", "entries": "moved" }), none)
        }
        "pfr" => (json!({ "nodes": "element-ends" }), none),
        // The outer contour is shifted behind what is inside it (4.6).
        "gtsp-lk" => (json!({ "nodes": "element-ends", "repair": "outer-back" }), none),
        // The defaults are the paper's.
        _ => (json!({}), none),
    };
    json!({ "as-published": published, "at-its-best": best })
}

/// The parameters of both objects.
fn merged(a: &Value, b: &Value) -> Value {
    let fields = [a, b].into_iter().filter_map(Value::as_object).flatten();
    Value::Object(fields.map(|(name, value)| (name.clone(), value.clone())).collect())
}
