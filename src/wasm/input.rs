//! Reads what came from JavaScript, and refuses what is wrong by its name.

use js_sys::{Array, ArrayBuffer, Float64Array, Object, Reflect};
use wasm_bindgen::prelude::*;

/// What js-sys has too, but there an exception would leave the core in the middle of a function: each time, what that
/// has on the stack would be lost. Proxies and getters can throw everywhere.
mod caught {
    use wasm_bindgen::prelude::*;

    #[wasm_bindgen]
    extern "C" {
        #[wasm_bindgen(catch, js_namespace = Array, js_name = isArray)]
        pub fn is_array(value: &JsValue) -> Result<bool, JsValue>;

        #[wasm_bindgen(catch, js_namespace = Object, js_name = hasOwn)]
        pub fn has_own(value: &JsValue, key: &str) -> Result<bool, JsValue>;

        #[wasm_bindgen(js_name = Float64Array)]
        pub type Copy;

        /// Of as many numbers as there are, whatever `length` says.
        #[wasm_bindgen(catch, constructor, js_class = "Float64Array")]
        pub fn of(numbers: &JsValue) -> Result<Copy, JsValue>;
    }
}

use super::Result;
use crate::experiment::MAX_STARTS;
use crate::fields::{InvalidInput, WORD_FIELDS, field_at, shown};

/// kx, ky or kθ, and of which robot if it is not the first.
pub(super) fn gain_name(index: usize) -> String {
    let name = ["kx", "ky", "kθ"][index % 3];
    if index < 3 { name.into() } else { format!("{name} (gains[{index}])") }
}

/// Most gain triples in one call: what they take of the memory stays taken.
const MAX_TRIPLES: u32 = 1_000_000;

/// A value that came from JavaScript, and where it stood.
pub(super) struct Input {
    pub(super) value: JsValue,
    pub(super) path: String,
}

impl Input {
    pub(super) fn refused(&self, expected: impl Into<String>) -> InvalidInput {
        let path = if self.path.is_empty() { "experiment" } else { &self.path };
        InvalidInput::new(path, expected, description(&self.value))
    }

    /// The object's own field; what it inherits does not count.
    pub(super) fn get(&self, key: &str) -> Result<Input> {
        let path =
            if self.path.is_empty() { key.to_string() } else { format!("{}.{key}", self.path) };
        let own = caught::has_own(&self.value, key)?;
        let value = if own { Reflect::get(&self.value, &key.into())? } else { JsValue::UNDEFINED };
        Ok(Input { value, path })
    }

    /// Refuses anything but an object that has no other keys than these.
    pub(super) fn keys(&self, known: &[&str]) -> Result<()> {
        let value = &self.value;
        if !value.is_object() || is_array(value) || ArrayBuffer::is_view(value) {
            return Err(self.refused("an object").into());
        }
        for key in Reflect::own_keys(value.unchecked_ref())? {
            let key = key.as_string().unwrap_or_else(|| "a symbol".into());
            if !known.contains(&key.as_str()) {
                let path = if self.path.is_empty() { "experiment" } else { &self.path };
                let expected = format!("an object with no fields but {}", known.join(", "));
                let found = format!("one with {}", quoted(&key));
                return Err(InvalidInput::new(path, expected, found).into());
            }
        }
        Ok(())
    }

    /// The elements of an array, which must have this length if one is given.
    pub(super) fn array(&self, length: Option<u32>) -> Result<impl Iterator<Item = Input>> {
        let expected = || match length {
            Some(length) => format!("an array of {length}"),
            None => format!("an array of 1 to {MAX_STARTS}"),
        };
        if !is_array(&self.value) {
            return Err(self.refused(expected()).into());
        }
        let found = self.length()?;
        if length.is_some_and(|length| length != found) || found as usize > MAX_STARTS {
            return Err(self.refused(expected()).into());
        }
        let elements: Result<Vec<Input>> = (0..found)
            .map(|i| Ok(Input { value: self.element(i)?, path: format!("{}[{i}]", self.path) }))
            .collect();
        Ok(elements?.into_iter())
    }

    /// The numbers of an array of gains.
    pub(super) fn numbers(&self) -> Result<Vec<f64>> {
        const MOST: u32 = 3 * MAX_TRIPLES;
        let refused = || self.refused("a Float64Array or an array of numbers");
        let check = |count: u32| match count {
            0..=MOST => Ok(count),
            _ => {
                let expected = format!("at most {MOST} numbers");
                Err(InvalidInput::new(&self.path, expected, format!("{count} numbers")))
            }
        };
        if self.value.is_instance_of::<Float64Array>() {
            let copy = caught::Copy::of(&self.value).map_err(|_| refused())?;
            let copy: &Float64Array = copy.unchecked_ref();
            check(copy.length())?;
            return Ok(copy.to_vec());
        }
        if !is_array(&self.value) && !ArrayBuffer::is_view(&self.value) {
            return Err(refused().into());
        }
        (0..check(self.length()?)?)
            .map(|i| Input { value: self.element(i)?, path: gain_name(i as usize) }.number())
            .collect()
    }

    /// How many elements an array says that it has.
    fn length(&self) -> Result<u32> {
        let length = Reflect::get(&self.value, &"length".into())?.as_f64();
        length.map(|length| length as u32).ok_or_else(|| self.refused("an array of numbers").into())
    }

    fn element(&self, index: u32) -> Result<JsValue> {
        Reflect::get_u32(&self.value, index)
    }

    /// A part [first, end) of `count`; all if it is left out.
    pub(super) fn part(&self, count: u32) -> Result<[u32; 2]> {
        if self.value.is_undefined() {
            return Ok([0, count]);
        }
        let ends = self.array(Some(2))?.map(|end| end.whole_number(count));
        match ends.collect::<Result<Vec<_>>>()?[..] {
            [first, end] => Ok([first, end]),
            _ => Err(self.refused("an array of 2").into()),
        }
    }

    pub(super) fn number(&self) -> Result<f64> {
        self.value.as_f64().ok_or_else(|| self.refused("a number").into())
    }

    pub(super) fn finite_number(&self) -> Result<f64> {
        let number = self.value.as_f64().filter(|number| number.is_finite());
        number.ok_or_else(|| self.refused("a finite number").into())
    }

    pub(super) fn whole_number(&self, largest: u32) -> Result<u32> {
        let refused = || self.refused(format!("a whole number from 0 to {largest}"));
        let number = self.value.as_f64().ok_or_else(refused)?;
        if number.fract() == 0.0 && (0.0..=f64::from(largest)).contains(&number) {
            Ok(number as u32)
        } else {
            Err(refused().into())
        }
    }

    /// This value where it is given and allowed, the template's where it is left out.
    pub(super) fn completed(&self, template: &JsValue) -> Result<JsValue> {
        if self.value.is_undefined() && !self.path.is_empty() {
            return Ok(template.clone());
        }
        if let Some(field) = field_at(&self.path) {
            let allowed = match self.value.as_f64() {
                Some(number) => field.allows(number),
                None => self.value.is_null() && field.nullable,
            };
            if !allowed {
                return Err(self.refused(field.expected()).into());
            }
            return Ok(self.value.clone());
        }
        if let Some(field) = WORD_FIELDS.iter().find(|field| field.path == self.path) {
            let word = self.value.as_string();
            if !word.is_some_and(|word| field.words.contains(&word.as_str())) {
                let expected: Vec<String> =
                    field.words.iter().map(|word| format!("'{word}'")).collect();
                return Err(self.refused(expected.join(" or ")).into());
            }
            return Ok(self.value.clone());
        }
        if Array::is_array(template) {
            let template: &Array = template.unchecked_ref();
            let any_length = self.path == "starts";
            let array = Array::new();
            for (i, element) in self.array((!any_length).then(|| template.length()))?.enumerate() {
                let template = template.get(if any_length { 0 } else { i as u32 });
                array.push(&element.completed(&template)?);
            }
            return Ok(array.into());
        }
        let names: Vec<String> = Object::keys(template.unchecked_ref::<Object>())
            .into_iter()
            .filter_map(|key| key.as_string())
            .collect();
        self.keys(&names.iter().map(String::as_str).collect::<Vec<_>>())?;
        let object = Object::new();
        for name in &names {
            let template = Reflect::get(template, &name.into())?;
            let value = self.get(name)?.completed(&template)?;
            Reflect::set(&object, &name.into(), &value)?;
        }
        Ok(object.into())
    }
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

/// A value in words for a message.
fn description(value: &JsValue) -> String {
    if let Some(number) = value.as_f64() {
        return shown(number);
    }
    if let Some(text) = value.as_string() {
        return quoted(&text);
    }
    if is_array(value) {
        let length = Reflect::get(value, &"length".into()).ok().and_then(|length| length.as_f64());
        return format!("an array of {}", shown(length.unwrap_or_default()));
    }
    match value.as_bool() {
        Some(truth) => truth.to_string(),
        None if value.is_null() => "null".into(),
        None if value.is_undefined() => "undefined".into(),
        None => format!("of type {}", value.js_typeof().as_string().unwrap_or_default()),
    }
}
