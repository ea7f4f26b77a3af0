//! Reads what JavaScript gives.

use core::cell::Cell;

use js_sys::{Array, ArrayBuffer, Float64Array, Reflect, Symbol};
use wasm_bindgen::prelude::*;

use super::origin;
use super::write::named;
use crate::run::Preset;
use crate::schema::{Keys, Kind, Place, Result, Source, refused, too_many};

/// What js-sys has too, but there an exception would leave the core in the middle of a function: each time, what that
/// has on the stack would be lost. Proxies and getters can throw everywhere.
mod caught {
    use wasm_bindgen::prelude::*;

    #[wasm_bindgen]
    extern "C" {
        #[wasm_bindgen(catch, js_namespace = Array, js_name = isArray)]
        pub fn is_array(value: &JsValue) -> Result<bool, JsValue>;

        #[wasm_bindgen(catch, js_namespace = Object, js_name = hasOwn)]
        pub fn has_own(value: &JsValue, key: &JsValue) -> Result<bool, JsValue>;

        #[wasm_bindgen(js_name = Float64Array)]
        pub type Copy;

        /// Of as many numbers as there are, whatever `length` says.
        #[wasm_bindgen(catch, constructor, js_class = "Float64Array")]
        pub fn of(numbers: &JsValue) -> Result<Copy, JsValue>;
    }
}

/// A value of JavaScript.
pub(super) struct Given {
    /// None where its owner throws when it is looked at.
    value: Option<JsValue>,
    /// Whether all the fields that it may have were seen to be its own: each needs not be asked again.
    is_whole: Cell<bool>,
}

impl Given {
    pub(super) fn of(value: JsValue) -> Self {
        Self::seen(Some(value))
    }

    fn seen(value: Option<JsValue>) -> Self {
        Self { value, is_whole: Cell::new(false) }
    }
}

impl Source for Given {
    fn kind(&self) -> Kind {
        let Some(value) = &self.value else { return Kind::Unreadable };
        // What most values are comes first.
        if let Some(number) = value.as_f64() {
            return Kind::Number(number);
        }
        if value.is_null() {
            return Kind::Null;
        }
        if let Some(text) = value.as_string() {
            return Kind::Text(text);
        }
        if let Some(truth) = value.as_bool() {
            return Kind::Truth(truth);
        }
        match value {
            value if value.is_undefined() => Kind::Missing,
            value if is_list(value, false) => Kind::List(self.length(false)),
            value => Kind::Other(value.js_typeof().as_string().unwrap_or_default()),
        }
    }

    fn origin(&self) -> Option<&'static str> {
        origin::of(self.value.as_ref()?).map(Preset::word)
    }

    // Quicker than by its kind.
    fn is_given(&self) -> bool {
        self.value.as_ref().is_none_or(|value| !value.is_undefined())
    }

    fn column(&self, place: Place<'_>, most: usize) -> Result<Option<Vec<f64>>> {
        let Some(value) = self.value.as_ref().filter(|value| is_column(value)) else {
            return Ok(None);
        };
        let refused = |_| refused(self, place, "a Float64Array or an array of numbers");
        let copy = caught::Copy::of(value).map_err(refused)?;
        let copy: &Float64Array = copy.unchecked_ref();
        let count = copy.length() as usize;
        if count > most {
            return Err(too_many(place, most, count));
        }
        Ok(Some(copy.to_vec()))
    }

    fn length(&self, columns: bool) -> Option<usize> {
        let list = self.value.as_ref().filter(|value| is_list(value, columns))?;
        let length = named("length", |name| Reflect::get(list, name)).ok()?;
        length.as_f64().map(|length| length as usize)
    }

    fn element(&self, index: usize) -> Self {
        let element = |list| Reflect::get_u32(list, index as u32).ok();
        Self::seen(self.value.as_ref().and_then(element))
    }

    fn keys(&self, known: &[&'static str]) -> Keys {
        let Some(value) = self.value.as_ref().filter(|value| value.is_object()) else {
            return Keys::NoObject;
        };
        if is_list(value, true) {
            return Keys::NoObject;
        }
        let Ok(keys) = Reflect::own_keys(value.unchecked_ref()) else { return Keys::Unreadable };
        // Most objects have all fields, in their order. To read the names, or to ask for each, takes long.
        let count = keys.length() as usize;
        let is_next = |(i, name)| named(name, |name| keys.get(i) == *name);
        if count == known.len() && (0..).zip(known.iter().copied()).all(is_next) {
            self.is_whole.set(true);
            return Keys::Known;
        }
        let own =
            |name: &&'static str| named(name, |name| caught::has_own(value, name)).unwrap_or(false);
        if known.iter().copied().filter(own).count() == count {
            return if count == 0 { instance(value).unwrap_or(Keys::Known) } else { Keys::Known };
        }
        let unknown = || unknown(&keys, known).map_or(Keys::Known, Keys::Unknown);
        instance(value).unwrap_or_else(unknown)
    }

    /// Its own field; what it inherits does not count.
    fn field(&self, name: &'static str) -> Self {
        let Some(value) = &self.value else { return Self::seen(None) };
        let field =
            named(name, |name| match self.is_whole.get() || caught::has_own(value, name)? {
                true => Reflect::get(value, name),
                false => Ok(JsValue::UNDEFINED),
            });
        Self::seen(field.ok())
    }
}

/// Where it is of a class: a promise, for instance, that nobody awaited, or a map, has no field at all.
fn instance(value: &JsValue) -> Option<Keys> {
    let constructor = named("constructor", |name| Reflect::get(value, name)).ok()?;
    let class = named("name", |name| Reflect::get(&constructor, name)).ok()?.as_string()?;
    (class != "Object").then(|| Keys::Instance(class.chars().take(40).collect()))
}

/// The first of these keys that is not known.
fn unknown(keys: &Array, known: &[&'static str]) -> Option<String> {
    let names = keys.iter().map(|key| key.as_string().unwrap_or_else(|| "a symbol".into()));
    names.into_iter().find(|name| !known.contains(&name.as_str()))
}

/// Whether it is a Float64Array, also one of another frame, whose class is not the one here.
fn is_column(value: &JsValue) -> bool {
    let tag = || Reflect::get(value, &Symbol::to_string_tag());
    ArrayBuffer::is_view(value) && tag().is_ok_and(|tag| tag == "Float64Array")
}

/// Whether it is an array, or numbers side by side, if those may be; one of which this cannot be said is none.
fn is_list(value: &JsValue, columns: bool) -> bool {
    caught::is_array(value).unwrap_or(false) || (columns && ArrayBuffer::is_view(value))
}
