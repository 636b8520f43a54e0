//! A panic ends the instance; its message and place reach the caller.

use js_sys::Function;
use kerfway::wasm::{last_panic, start};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn a_panic_is_reported_with_its_place() {
    start();
    assert_eq!(last_panic(), None);
    let failing: Closure<dyn FnMut()> = Closure::new(|| panic!("made up for this test"));
    let function: &Function = failing.as_ref().unchecked_ref();
    let thrown = function.call0(&JsValue::NULL).unwrap_err();
    assert!(thrown.is_instance_of::<js_sys::WebAssembly::RuntimeError>());
    let said = last_panic().unwrap();
    assert!(said.contains("made up for this test") && said.contains("panics.rs"), "{said}");
    assert_eq!(last_panic(), None, "it is reported once");
    // The panic left the closure borrowed.
    failing.forget();
}
