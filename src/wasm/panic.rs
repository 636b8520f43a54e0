//! The message of a panic, for the console and for the caller's error.

use std::cell::RefCell;
use wasm_bindgen::prelude::*;

thread_local! {
    static LAST: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Adds the hook to the one there is when the instance starts.
#[wasm_bindgen(start)]
pub fn start() {
    let before = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        before(panic);
        console_error_panic_hook::hook(panic);
        LAST.set(Some(panic.to_string()));
    }));
}

/// The message and location of the panic that ended this instance, if there was one.
#[wasm_bindgen(js_name = lastPanic)]
pub fn last_panic() -> Option<String> {
    LAST.take()
}
