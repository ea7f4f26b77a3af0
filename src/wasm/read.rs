//! Reads what JavaScript gives.

use js_sys::{Array, ArrayBuffer, Float64Array, Reflect};
use wasm_bindgen::prelude::*;

use super::write::named;
use crate::run::{Experiment, Preset, Setting};
use crate::schema::{Allowed, Input, InvalidInput, Keys, Place, Source, refused, shown, too_many};

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

/// The given experiment, completed with the fields of the usual one.
pub(super) fn setting(given: JsValue) -> Result<Setting, JsValue> {
    let mut experiment: Experiment = Preset::VelocityLimits.experiment();
    experiment.read(&Given(given))?;
    Ok(Setting::new(experiment)?)
}

/// A number that has a name.
pub(super) fn number(given: JsValue, name: &str) -> Result<f64, JsValue> {
    let mut number = 0.0;
    number.read(&Given(given), Place::Named(name), &Allowed::ANY)?;
    Ok(number)
}

/// The index of a start posture; 0 if it is left out.
pub(super) fn start(setting: &Setting, given: JsValue) -> Result<u32, JsValue> {
    if given.is_undefined() {
        return Ok(0);
    }
    let start = number(given, "start")?;
    setting.starts().check("start", start)?;
    Ok(start as u32)
}

/// A value of JavaScript.
pub(super) struct Given(pub(super) JsValue);

impl Source for Given {
    type Error = JsValue;

    fn is_given(&self) -> bool {
        !self.0.is_undefined()
    }

    fn is_null(&self) -> bool {
        self.0.is_null()
    }

    fn number(&self) -> Option<f64> {
        self.0.as_f64()
    }

    fn truth(&self) -> Option<bool> {
        self.0.as_bool()
    }

    fn text(&self) -> Option<String> {
        self.0.as_string()
    }

    fn column(&self, place: Place<'_>, most: usize) -> Result<Option<Vec<f64>>, JsValue> {
        if !self.0.is_instance_of::<Float64Array>() {
            return Ok(None);
        }
        let refused = |_| refused(self, place, "a Float64Array or an array of numbers");
        let copy = caught::Copy::of(&self.0).map_err(refused)?;
        let copy: &Float64Array = copy.unchecked_ref();
        let count = copy.length() as usize;
        if count > most {
            return Err(too_many(place, most, count).into());
        }
        Ok(Some(copy.to_vec()))
    }

    fn length(&self, columns: bool) -> Result<Option<usize>, JsValue> {
        let is_list = is_array(&self.0) || (columns && ArrayBuffer::is_view(&self.0));
        if !is_list {
            return Ok(None);
        }
        Ok(length(&self.0)?.as_f64().map(|length| length as usize))
    }

    fn element(&self, index: usize) -> Result<Self, JsValue> {
        Reflect::get_u32(&self.0, index as u32).map(Given)
    }

    fn keys(&self, known: &[&'static str]) -> Result<Keys, JsValue> {
        let value = &self.0;
        if !value.is_object() || is_array(value) || ArrayBuffer::is_view(value) {
            return Ok(Keys::NoObject);
        }
        // The names are read only where there are more than are known: to read them takes long.
        let keys = Reflect::own_keys(value.unchecked_ref())?;
        let mut found = 0;
        for name in known {
            found += u32::from(named(name, |name| caught::has_own(value, name))?);
        }
        if found == keys.length() {
            return Ok(Keys::Known);
        }
        Ok(unknown(&keys, known).map_or(Keys::Known, Keys::Unknown))
    }

    /// Its own field; what it inherits does not count.
    fn field(&self, name: &'static str) -> Result<Self, JsValue> {
        named(name, |name| {
            let own = caught::has_own(&self.0, name)?;
            let field = if own { Reflect::get(&self.0, name)? } else { JsValue::UNDEFINED };
            Ok(Given(field))
        })
    }

    fn description(&self) -> String {
        let value = &self.0;
        if let Some(number) = value.as_f64() {
            return shown(number);
        }
        if let Some(text) = value.as_string() {
            return quoted(&text);
        }
        if is_array(value) {
            let length = length(value).ok().and_then(|length| length.as_f64());
            return format!("an array of {}", shown(length.unwrap_or_default()));
        }
        match value.as_bool() {
            Some(truth) => truth.to_string(),
            None if value.is_null() => "null".into(),
            None if value.is_undefined() => "undefined".into(),
            None => format!("of type {}", value.js_typeof().as_string().unwrap_or_default()),
        }
    }
}

impl From<InvalidInput> for JsValue {
    fn from(error: InvalidInput) -> Self {
        js_sys::Error::new(&error.to_string()).into()
    }
}

/// The first of these keys that is not known.
fn unknown(keys: &Array, known: &[&'static str]) -> Option<String> {
    keys.iter().find_map(|key| match key.as_string() {
        Some(key) if known.contains(&key.as_str()) => None,
        Some(key) => Some(quoted(&key)),
        None => Some(quoted("a symbol")),
    })
}

/// How many elements an array says that it has.
fn length(value: &JsValue) -> Result<JsValue, JsValue> {
    named("length", |name| Reflect::get(value, name))
}

/// Whether it is an array; one of which this cannot be said is none.
fn is_array(value: &JsValue) -> bool {
    caught::is_array(value).unwrap_or(false)
}

/// The beginning of a text in quotation marks.
fn quoted(text: &str) -> String {
    let shown: String = text.chars().take(40).collect();
    if shown.len() < text.len() { format!("'{shown}…'") } else { format!("'{shown}'") }
}
