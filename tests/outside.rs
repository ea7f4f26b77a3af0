//! What is asked from outside is what the rooms answer, and what is given is read by name.

mod common;

use common::evolved;
use common::json::{Given, written};
use ep_locomotion::outside;
use ep_locomotion::robot::Gains;
use ep_locomotion::run::{Preset, Setting};
use ep_locomotion::schema::{Column, Columns, InvalidInput, Plain};
use ep_locomotion::study;
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

const NOTHING: Given = Given(None);

fn told(answer: Result<impl Plain, InvalidInput>) -> Result<Value, String> {
    answer.map(|value| written(&value)).map_err(|error| error.to_string())
}

fn whole(given: Value, other: Value) -> Result<Value, String> {
    let other = Given(Some(&other).filter(|other| !other.is_null()));
    let setting = outside::experiment(&Given(Some(&given)), &other);
    told(setting.map(|setting| setting.experiment().clone()))
}

#[wasm_bindgen_test(unsupported = test)]
fn an_experiment_is_a_preset_with_changes_in_either_order() {
    let of = |preset: Preset, horizon: f64| {
        let mut experiment = preset.experiment();
        experiment.horizon = horizon;
        Ok(written(&experiment))
    };
    let [name, changes] = [json!("acceleration-limits"), json!({ "horizon": 5 })];
    assert_eq!(whole(name.clone(), Value::Null), of(Preset::AccelerationLimits, 10.0));
    assert_eq!(whole(changes.clone(), Value::Null), of(Preset::VelocityLimits, 5.0));
    assert_eq!(whole(name.clone(), changes.clone()), of(Preset::AccelerationLimits, 5.0));
    assert_eq!(whole(changes, name), of(Preset::AccelerationLimits, 5.0));
    for (given, other, expected) in [
        (
            json!({}),
            json!(1),
            "preset must be 'velocity-limits' or 'acceleration-limits', but was 1",
        ),
        (
            json!("no"),
            Value::Null,
            "experiment must be 'velocity-limits' or 'acceleration-limits', but was 'no'",
        ),
        (
            json!({ "horizon": 0 }),
            Value::Null,
            "horizon must be a number from 0.00001 to 100000 s, but was 0",
        ),
        (
            json!({ "horizon": true }),
            Value::Null,
            "horizon must be a number from 0.00001 to 100000 s, but was true",
        ),
        (json!({ "goal": [1] }), Value::Null, "goal must be an object, but was an array of 1"),
        (
            json!({ "law": "x".repeat(41) }),
            Value::Null,
            "law must be 'shim-kim' or 'kanayama', but was 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx…'",
        ),
        (
            json!({ "law": "x".repeat(40) }),
            Value::Null,
            "law must be 'shim-kim' or 'kanayama', but was 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx'",
        ),
    ] {
        assert_eq!(whole(given, other), Err(expected.into()));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_call_is_what_its_room_answers() {
    let mut experiment = Preset::VelocityLimits.experiment();
    experiment.starts.push(experiment.goal);
    let setting = Setting::new(experiment).expect("valid");
    let (gains, k) = (json!([3, 0.1, 5]), Gains::new(3.0, 0.1, 5.0));
    let two = json!([3, 0.1, 5, 3, 0.1, 5]);
    let (one, two) = (Given(Some(&gains)), Given(Some(&two)));
    let costs = setting.evaluate(&[k]).expect("a cost");
    assert_eq!(told(outside::evaluate(&setting, &one)), Ok(written(&Column(costs))));
    let second = json!(1);
    let second = Given(Some(&second));
    for (start, from) in [(NOTHING, 0), (second, 1)] {
        let run = written(&setting.run(k, from));
        assert_eq!(told(outside::simulate(&setting, &one, &start)), Ok(run.clone()));
        assert_eq!(told(outside::simulate_all(&setting, &two, &start)), Ok(json!([run, run])));
        let stability = written(&study::Stability::of(&setting, &k, from));
        assert_eq!(told(outside::stability(&setting, &one, &start)), Ok(stability));
    }
    let fares = written(&Columns(study::fares(&setting, k)));
    assert_eq!(told(outside::fares(&setting, &one)), Ok(fares));
    let parts = [0, 1].map(|start| written(&Columns(study::error_parts(&setting, &k, start))));
    assert_eq!(told(outside::error_parts(&setting, &one)), Ok(json!(parts)));
    for (start, expected) in [
        (2.0, "start must be a whole number from 0 to 1, but was 2"),
        (0.5, "start must be a whole number from 0 to 1, but was 0.5"),
    ] {
        let start = json!(start);
        assert_eq!(
            told(outside::simulate(&setting, &one, &Given(Some(&start)))),
            Err(expected.into())
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_generation_is_given_by_its_number_or_the_newest() {
    let evolution = evolved(Preset::VelocityLimits.experiment(), 2);
    let number =
        |given: Given| outside::generation(&evolution, &given).map_err(|error| error.to_string());
    assert_eq!(number(NOTHING), Ok(2));
    for n in 0..=2_u32 {
        assert_eq!(number(Given(Some(&json!(n)))), Ok(n));
    }
    for (given, found) in [(json!(3), "3"), (json!(0.5), "0.5"), (json!(-1), "-1")] {
        let expected =
            format!("generation must be a whole number from 0 to 2, the newest, but was {found}");
        assert_eq!(number(Given(Some(&given))), Err(expected));
    }
    assert_eq!(
        number(Given(Some(&json!("1")))),
        Err("generation must be a number, but was '1'".into())
    );
}
