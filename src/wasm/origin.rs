//! Which preset an experiment was made from: a copy that was spread still holds the parts that it did not replace.

use js_sys::{Reflect, WeakMap};
use wasm_bindgen::prelude::*;

use super::write::{named, plain};
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

/// The plain object for an experiment; from what this is made is remembered as long as its parts are there.
pub(super) fn remembered(experiment: &Experiment, preset: Preset) -> JsValue {
    let experiment = plain(experiment);
    let parts = Experiment::KEYS.iter().map(|name| part(&experiment, name));
    for part in parts.filter(JsValue::is_object) {
        ORIGINS.with(|origins| origins.set(part.unchecked_ref(), &(preset as u32).into()));
    }
    experiment
}

/// What most parts of this one were made from, if that is known of some and no field is missing: some fields of several
/// presets have none.
pub(super) fn of(experiment: &JsValue) -> Option<Preset> {
    let mut counts = [0; Preset::ALL.len()];
    for name in Experiment::KEYS {
        let part = part(experiment, name);
        if part.is_undefined() {
            return None;
        }
        if part.is_object() {
            let place = ORIGINS.with(|origins| origins.get(part.unchecked_ref())).as_f64();
            if let Some(count) = place.and_then(|place| counts.get_mut(place as usize)) {
                *count += 1;
            }
        }
    }
    // Of as many parts the first.
    let (most, count) = counts.iter().enumerate().rev().max_by_key(|(_, count)| **count)?;
    (*count > 0).then(|| Preset::ALL[most])
}
