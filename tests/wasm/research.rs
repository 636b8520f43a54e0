//! The research build: published methods with their parameters, and benchmark instances.

use crate::methods::DRAWING;
use crate::values::{get, js, load, number, sentence};
use js_sys::Array;
use kerfway::wasm::{Solving, paper_methods};
use wasm_bindgen_test::wasm_bindgen_test;

/// Four points in a square of side 10, in two sets of two.
const INSTANCE: &[u8] =
    b"NAME: square\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n\
1 0 0\n2 10 10\n3 10 0\n4 0 10\nEOF\n";

#[wasm_bindgen_test]
fn published_methods_are_listed_with_their_parameters() {
    let cards = Array::from(&paper_methods().ok().unwrap());
    let names: Vec<String> = cards.iter().map(|c| get(&c, "name").as_string().unwrap()).collect();
    assert_eq!(names.len(), 13);
    let lpspso = cards.get(0);
    assert_eq!(names[0], "lpspso");
    assert!(number(&get(&lpspso, "parameters"), "particles") > 0.0);
}

#[wasm_bindgen_test]
fn a_published_method_plans_and_shows_what_is_special_about_it() {
    let mut job = load(DRAWING, "{}").ok().unwrap();
    let options = r#"{"method":"lpspso","parameters":"{\"particles\":10}","seed":1,"moves":5000}"#;
    assert!(job.start(js(options)).is_ok());
    assert!(job.step(5000).is_ok());
    let insight = job.insight().ok().unwrap();
    assert!(number(&insight, "round") >= 0.0);
    assert!(Array::from(&get(&insight, "curves")).length() > 0);
    assert!(job.document().ok().unwrap().contains("\"method\":\"lpspso\""));
    let wrong = r#"{"method":"lpspso","parameters":"{\"particels\":10}"}"#;
    assert!(sentence(job.start(js(wrong))).contains("particles"));
}

#[wasm_bindgen_test]
fn an_instance_is_solved_to_its_optimum() {
    let mut solving = Solving::new(INSTANCE, 1.0).ok().unwrap();
    assert_eq!(solving.name(), "square");
    for _ in 0..50 {
        if !solving.step(20_000) {
            break;
        }
    }
    assert_eq!(solving.length().ok().unwrap(), 40.0);
    assert_eq!(solving.tour().len(), 4);
    assert!(solving.lower_bound().is_some_and(|bound| bound <= 40.0));
    assert!(solving.moves() > 0.0);
    assert!(sentence(Solving::new(b"nothing", 1.0).map(|_| ())).ends_with('.'));
}
