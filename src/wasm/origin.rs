//! Which preset an experiment was made from: a copy that was spread still holds the parts that it did not replace.

use js_sys::{Reflect, WeakMap};
use wasm_bindgen::prelude::*;

use super::write::named;
use crate::run::{Experiment, Preset};
use crate::schema::Plain;

thread_local! {
    /// By its parts, the place of a preset among all.
    static ORIGINS: WeakMap = WeakMap::new();
}

/// What an experiment has under this name, unless it throws.
fn part(experiment: &JsValue, name: &'static str) -> JsValue {
    named(name, |name| Reflect::get(experiment, name)).unwrap_or_default()
}

/// Remembers from what this new experiment is made, as long as its parts are there.
pub(super) fn remember(experiment: &JsValue, preset: Preset) {
    let parts = Experiment::KEYS.iter().map(|name| part(experiment, name));
    for part in parts.filter(JsValue::is_object) {
        ORIGINS.with(|origins| origins.set(part.unchecked_ref(), &(preset as u32).into()));
    }
}

/// What this one was made from, if that is known and no field is missing: some fields of several presets have none.
pub(super) fn of(experiment: &JsValue) -> Option<Preset> {
    let mut found = None;
    for name in Experiment::KEYS {
        let part = part(experiment, name);
        if part.is_undefined() {
            return None;
        }
        if found.is_none() && part.is_object() {
            let place = ORIGINS.with(|origins| origins.get(part.unchecked_ref())).as_f64();
            found = place.and_then(|place| Preset::ALL.get(place as usize).copied());
        }
    }
    found
}
