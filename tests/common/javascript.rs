//! Values of JavaScript, for the tests of the boundary.

use js_sys::{Float64Array, Function, JSON, Reflect};
use wasm_bindgen::prelude::*;

/// The value of a JavaScript expression.
pub fn js(expression: &str) -> JsValue {
    Function::new_no_args(&format!("return ({expression})"))
        .call0(&JsValue::NULL)
        .expect(expression)
}

pub fn text(value: &JsValue) -> String {
    JSON::stringify(value).expect("plain").into()
}

pub fn get(object: &JsValue, path: &str) -> JsValue {
    path.split('.')
        .fold(object.clone(), |value, key| Reflect::get(&value, &key.into()).expect("an object"))
}

pub fn number(object: &JsValue, path: &str) -> f64 {
    get(object, path).as_f64().expect(path)
}

#[track_caller]
pub fn message<T>(result: Result<T, JsValue>) -> String {
    let error = result.err().expect("refused");
    error.dyn_into::<js_sys::Error>().expect("an Error").message().into()
}

pub fn gains(k: [f64; 3]) -> JsValue {
    Float64Array::from(k.as_slice()).into()
}

pub const EP: [f64; 3] = [3.23673, 0.09678, 5.17891];

/// The experiment that is given, with nothing beside it.
pub fn experiment(given: JsValue) -> Result<JsValue, JsValue> {
    ep_locomotion::wasm::experiment(given, JsValue::UNDEFINED)
}
