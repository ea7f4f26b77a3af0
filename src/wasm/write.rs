//! Writes plain objects of JavaScript.

use core::cell::RefCell;

use js_sys::{Array, Float64Array, JsString, Object, Reflect, Uint8Array};
use wasm_bindgen::prelude::*;

use crate::schema::{Plain, Writer};

/// The plain object for a value.
pub(super) fn plain(value: &impl Plain) -> JsValue {
    value.write(&Values)
}

/// Values of JavaScript.
struct Values;

impl Writer for Values {
    type Value = JsValue;

    fn null(&self) -> JsValue {
        JsValue::NULL
    }

    fn number(&self, number: f64) -> JsValue {
        number.into()
    }

    fn truth(&self, truth: bool) -> JsValue {
        truth.into()
    }

    fn text(&self, text: &str) -> JsValue {
        text.into()
    }

    fn column(&self, numbers: &[f64]) -> JsValue {
        Float64Array::from(numbers).into()
    }

    fn flags(&self, flags: &[u8]) -> JsValue {
        Uint8Array::from(flags).into()
    }

    fn list(&self, elements: impl Iterator<Item = JsValue>) -> JsValue {
        elements.collect::<Array>().into()
    }

    fn object<const N: usize>(&self, fields: [(&'static str, JsValue); N]) -> JsValue {
        object(&fields)
    }
}

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_name = String)]
    fn string(number: f64) -> JsString;
}

/// A number in a message, as Rust has it. To let Rust write it would make the module 20 kB larger.
pub(super) fn digits(number: f64) -> String {
    if number == 0.0 && number.is_sign_negative() {
        return "-0".into();
    }
    string(number).replace("e+", "e").into()
}

/// Not once for each number of fields.
fn object(fields: &[(&'static str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (name, value) in fields {
        // It cannot fail: the object is new and plain.
        let _ = named(name, |name| Reflect::set(&object, name, value));
    }
    object.into()
}

thread_local! {
    /// The names of fields as JavaScript has them, by where they are in the memory: to make one takes longer than to set it.
    static NAMES: RefCell<Vec<(*const u8, usize, JsValue)>> = const { RefCell::new(Vec::new()) };
}

/// Calls with the name of a field as JavaScript has it.
pub(super) fn named<T>(name: &'static str, call: impl FnOnce(&JsValue) -> T) -> T {
    let value = NAMES.with_borrow_mut(|names| {
        let known = |(start, length, _): &(*const u8, usize, JsValue)| {
            (*start, *length).cmp(&(name.as_ptr(), name.len()))
        };
        let place = names.binary_search_by(known).unwrap_or_else(|place| {
            names.insert(place, (name.as_ptr(), name.len(), name.into()));
            place
        });
        names[place].2.clone()
    });
    call(&value)
}
