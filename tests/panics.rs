//! A panic reaches JavaScript as an Error that can be read. Alone in its file: the instance is lost with it.
#![cfg(target_arch = "wasm32")]

use js_sys::{Error, Function};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn a_panic_is_an_error_with_its_message() {
    ep_locomotion::wasm::throw_panics();
    let panicking = Closure::<dyn Fn()>::new(|| panic!("the ground gave way"));
    let caught = Function::new_with_args("f", "try { f() } catch (error) { return error }")
        .call1(&JsValue::NULL, panicking.as_ref())
        .expect("caught");
    let message = String::from(caught.dyn_into::<Error>().expect("an Error").message());
    assert!(message.contains("internal error"), "{message}");
    assert!(message.contains("the ground gave way"), "{message}");
}
