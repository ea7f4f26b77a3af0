//! The allowed range of every number of an experiment: the table, and that validation keeps to it.

mod common;

use common::json::{Given, written};
use common::{PRESET, WORDS, velocity_limits};
use ep_locomotion::run::{Experiment, Setting};
use ep_locomotion::schema::Field;
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

/// What a field is besides a range.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Real,
    Whole,
    /// A number, or null for no limit.
    Limit,
}

use Kind::{Limit, Real, Whole};

/// Path, smallest and largest value, unit.
const RANGES: [(&str, f64, f64, &str, Kind); 32] = [
    ("starts[].x", -1000.0, 1000.0, "m", Real),
    ("starts[].y", -1000.0, 1000.0, "m", Real),
    ("starts[].theta", -100.0, 100.0, "rad", Real),
    ("goal.x", -1000.0, 1000.0, "m", Real),
    ("goal.y", -1000.0, 1000.0, "m", Real),
    ("goal.theta", -100.0, 100.0, "rad", Real),
    ("referenceVelocity.linear", -100.0, 100.0, "m/s", Real),
    ("referenceVelocity.angular", -100.0, 100.0, "rad/s", Real),
    ("sampleTime", 1e-5, 10.0, "s", Real),
    ("horizon", 1e-5, 1e5, "s", Real),
    ("limits.speed", 0.0, 1e6, "m/s", Limit),
    ("limits.turnRate", 0.0, 1e6, "rad/s", Limit),
    ("limits.acceleration", 0.0, 1e6, "m/s²", Limit),
    ("limits.turnAcceleration", 0.0, 1e6, "rad/s²", Limit),
    ("tolerance.position", 0.0, 1000.0, "m", Real),
    ("tolerance.heading", 0.0, 100.0, "rad", Real),
    ("tolerance.speed", 0.0, 1e6, "m/s", Limit),
    ("tolerance.turnRate", 0.0, 1e6, "rad/s", Limit),
    ("weights.final[]", 0.0, 1e6, "", Real),
    ("weights.velocity[]", 0.0, 1e6, "", Real),
    ("weights.penalty", 0.0, 1e6, "", Real),
    ("disturbance.linear", -100.0, 100.0, "m/s", Real),
    ("disturbance.angular", -100.0, 100.0, "rad/s", Real),
    ("disturbance.seed", 0.0, 4_294_967_295.0, "", Whole),
    ("evolution.population", 1.0, 2000.0, "", Whole),
    ("evolution.opponents", 1.0, 1000.0, "", Whole),
    ("evolution.seed", 0.0, 4_294_967_295.0, "", Whole),
    ("evolution.initialRange[]", -1e6, 1e6, "", Real),
    ("evolution.initialSigma", 0.0, 1e6, "", Real),
    ("evolution.adaptation", 0.0, 10.0, "", Real),
    ("evolution.sigmaFloor", 0.0, 1e6, "", Real),
    ("evolution.crossover", 0.0, 1.0, "", Real),
];

/// What an experiment with this value in the last of these fields is told.
fn verdict(path: &str, value: &Value) -> Result<(), String> {
    let mut preset = velocity_limits();
    preset.starts = vec![preset.starts[0]; 2];
    let mut experiment = written(&preset);
    let place =
        path.replace("[]", ".[]").split('.').fold(&mut experiment, |place, name| match name {
            "[]" => place.as_array_mut().and_then(|list| list.last_mut()).expect("a list"),
            name => place.get_mut(name).expect("a field"),
        });
    *place = value.clone();
    let read = preset.read(&Given(Some(&experiment))).and_then(|()| Setting::new(preset));
    read.map(|_| ()).map_err(|error| error.to_string())
}

#[wasm_bindgen_test(unsupported = test)]
fn the_table_of_ranges_is_this_one() {
    let fields = Experiment::fields().numbers;
    let row = |field: &Field| {
        let kind = match (field.integer, field.nullable) {
            (false, false) => Real,
            (true, false) => Whole,
            (false, true) => Limit,
            (true, true) => panic!("{} is two things", field.path),
        };
        (field.path.clone(), field.min, field.max, field.unit, kind)
    };
    for (field, (path, min, max, unit, kind)) in fields.iter().zip(RANGES) {
        assert_eq!(
            row(field),
            (path.into(), min, max, unit, kind),
            "RANGES of this file, in the order of the fields"
        );
    }
    assert_eq!(fields.len(), RANGES.len(), "RANGES of this file");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_table_of_words_is_this_one() {
    let fields = Experiment::fields().words;
    for (field, (path, words)) in fields.iter().zip(WORDS) {
        assert_eq!(
            (field.path.as_str(), field.words),
            (path, words),
            "WORDS of tests/common/mod.rs, in the order of the fields"
        );
    }
    assert_eq!(fields.len(), WORDS.len(), "WORDS of tests/common/mod.rs");
}

/// Links and files rest on it.
#[wasm_bindgen_test(unsupported = test)]
fn the_usual_experiment_is_this_one() {
    let known: Value = serde_json::from_str(PRESET).expect("JSON");
    let preset = written(&velocity_limits());
    // JSON has one kind of zero, and writes whole numbers as such.
    let numbers = |value: &Value| {
        value.to_string().replace(".0,", ",").replace(".0}", "}").replace(".0]", "]")
    };
    assert_eq!(numbers(&preset), numbers(&known), "PRESET of tests/common/mod.rs");
}

#[wasm_bindgen_test(unsupported = test)]
fn an_experiment_is_refused_just_outside_of_every_range_and_not_inside() {
    for (path, min, max, unit, kind) in RANGES {
        let number = |value: f64| match kind {
            Whole => json!(value as i64),
            Real | Limit => json!(value),
        };
        let refused_for_its_range = |value: Value| {
            // Of several starts or gains the last is wrong.
            let message = verdict(path, &value).err().unwrap_or_default();
            let name = message.split(" must be ").next().unwrap_or_default();
            let general: String = name.chars().filter(|c| !c.is_ascii_digit()).collect();
            general == path && message.contains(" from ") && message.contains(unit)
        };
        for inside in [min, max] {
            assert!(!refused_for_its_range(number(inside)), "{path} of {inside}");
        }
        let outside = match kind {
            Whole => [min - 1.0, max + 1.0],
            Real | Limit => [min.next_down(), max.next_up()],
        };
        for value in outside {
            assert!(refused_for_its_range(number(value)), "{path} of {value}");
        }
        let null = verdict(path, &Value::Null).is_ok();
        assert_eq!(null, kind == Limit, "{path} of null");
    }
}
