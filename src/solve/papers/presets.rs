//! Two sets of parameters for each method. "as-published" is what can be defended equation by equation from the paper.
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
        // flight is undone.
        "lpspso" => (
            merged(
                &swarm,
                &json!({ "kappa": "particle", "stagnation": "step4", "flights_must_gain": false }),
            ),
            none,
        ),
        "pso" | "aco-pso" | "k-pso" => (swarm, none),
        // (6) without a scale. (9) by its sentence: as printed it would nearly always punish.
        "rlsga" => (json!({ "scaled_fitness": false }), json!({ "scaled_fitness": false })),
        // (1) knows no legs from and to home.
        "dual-coding-ga" => (json!({ "home_legs": false }), none),
        // "Only at some predefined points on the boundary": where elements meet.
        "partition-tree" | "pfr" | "gtsp-lk" => (json!({ "nodes": "element-ends" }), none),
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
