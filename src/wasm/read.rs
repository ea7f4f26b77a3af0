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
pub(super) fn setting(given: JsValue) -> Result<Setting, InvalidInput> {
    let mut experiment: Experiment = Preset::VelocityLimits.experiment();
    experiment.read(&Given::of(given))?;
    Setting::new(experiment)
}

/// The preset with a name.
pub(super) fn preset(given: JsValue) -> Result<Preset, InvalidInput> {
    match given.as_string() {
        Some(name) => Preset::find(&name),
        None => Err(refused(&Given::of(given), Place::Named("preset"), Preset::expected())),
    }
}

/// A number that has a name.
pub(super) fn number(given: JsValue, name: &str) -> Result<f64, InvalidInput> {
    let mut number = 0.0;
    number.read(&Given::of(given), Place::Named(name), &Allowed::ANY)?;
    Ok(number)
}

/// The index of a start posture; 0 if it is left out.
pub(super) fn start(setting: &Setting, given: JsValue) -> Result<u32, InvalidInput> {
    if given.is_undefined() {
        return Ok(0);
    }
    let start = number(given, "start")?;
    setting.starts().check("start", start)?;
    Ok(start as u32)
}

/// A value of JavaScript; none where its owner throws when it is looked at.
pub(super) struct Given(Option<JsValue>);

impl Given {
    pub(super) fn of(value: JsValue) -> Self {
        Self(Some(value))
    }
}

impl Source for Given {
    fn is_given(&self) -> bool {
        self.0.as_ref().is_none_or(|value| !value.is_undefined())
    }

    fn is_null(&self) -> bool {
        self.0.as_ref().is_some_and(JsValue::is_null)
    }

    fn number(&self) -> Option<f64> {
        self.0.as_ref()?.as_f64()
    }

    fn truth(&self) -> Option<bool> {
        self.0.as_ref()?.as_bool()
    }

    fn text(&self) -> Option<String> {
        self.0.as_ref()?.as_string()
    }

    fn column(&self, place: Place<'_>, most: usize) -> Result<Option<Vec<f64>>, InvalidInput> {
        let Some(value) = self.0.as_ref().filter(|value| value.is_instance_of::<Float64Array>())
        else {
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
        let list = self.0.as_ref().filter(|value| is_list(value, columns))?;
        let length = named("length", |name| Reflect::get(list, name)).ok()?;
        length.as_f64().map(|length| length as usize)
    }

    fn element(&self, index: usize) -> Self {
        Self(self.0.as_ref().and_then(|list| Reflect::get_u32(list, index as u32).ok()))
    }

    fn keys(&self, known: &[&'static str]) -> Keys {
        let Some(value) = self.0.as_ref().filter(|value| value.is_object()) else {
            return Keys::NoObject;
        };
        if is_list(value, true) {
            return Keys::NoObject;
        }
        let Ok(keys) = Reflect::own_keys(value.unchecked_ref()) else { return Keys::Unreadable };
        // The names are read only where there are more than are known: to read them takes long.
        let own =
            |name: &&'static str| named(name, |name| caught::has_own(value, name)).unwrap_or(false);
        if known.iter().copied().filter(own).count() == keys.length() as usize {
            return Keys::Known;
        }
        unknown(&keys, known).map_or(Keys::Known, Keys::Unknown)
    }

    /// Its own field; what it inherits does not count.
    fn field(&self, name: &'static str) -> Self {
        let Some(value) = &self.0 else { return Self(None) };
        let field = named(name, |name| match caught::has_own(value, name)? {
            true => Reflect::get(value, name),
            false => Ok(JsValue::UNDEFINED),
        });
        Self(field.ok())
    }

    fn description(&self) -> String {
        let Some(value) = &self.0 else { return "one that cannot be read".into() };
        if let Some(number) = value.as_f64() {
            return shown(number);
        }
        if let Some(text) = value.as_string() {
            return quoted(&text);
        }
        if is_list(value, false) {
            let length = self.length(false).map_or("elements".into(), |length| length.to_string());
            return format!("an array of {length}");
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

/// Whether it is an array, or numbers side by side, if those may be; one of which this cannot be said is none.
fn is_list(value: &JsValue, columns: bool) -> bool {
    caught::is_array(value).unwrap_or(false) || (columns && ArrayBuffer::is_view(value))
}

/// The beginning of a text in quotation marks.
fn quoted(text: &str) -> String {
    let shown: String = text.chars().take(40).collect();
    if shown.len() < text.len() { format!("'{shown}…'") } else { format!("'{shown}'") }
}
