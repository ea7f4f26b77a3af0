//! What is asked from outside is what the rooms answer, and what is given is read by name.

mod common;

use common::json::{Given, written};
use common::{evolved, valid, velocity_limits};
use ep_locomotion::outside;
use ep_locomotion::robot::{ErrorPosture, Gains, Law, Velocity};
use ep_locomotion::run::Preset;
use ep_locomotion::schema::{Column, Columns, InvalidInput, Plain};
use ep_locomotion::study::{self, Axis, Circle, Gain, Grid, Landscape, Range};
use ep_locomotion::theory::LawTerms;
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

const NOTHING: Given = Given(None);

fn told(answer: Result<impl Plain, InvalidInput>) -> Result<Value, String> {
    answer.map(|value| written(&value)).map_err(|error| error.to_string())
}

fn whole(given: Value, other: Value) -> Result<Value, String> {
    let other = Given(Some(&other).filter(|other| !other.is_null()));
    let setting = outside::experiment(&Given(Some(&given)), &other);
    told(setting.map(|(setting, _)| setting.experiment().clone()))
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
    let mut experiment = velocity_limits();
    experiment.starts.push(experiment.goal);
    let setting = valid(experiment);
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
fn numbers_side_by_side_are_what_they_would_be_in_lists() {
    let starts = |starts| whole(json!({ "starts": starts }), Value::Null);
    let listed = json!([{ "x": 1, "y": 2, "theta": 3 }, { "x": -1, "y": 0, "theta": 0.5 }]);
    let column = starts(json!({ "column": [1, 2, 3, -1, 0, 0.5] }));
    assert_eq!(column, starts(listed));
    assert!(column.is_ok());
    for (column, expected) in [
        (vec![0; 4], "starts must be three numbers (x, y, θ) for each posture, but was 4 numbers"),
        (vec![], "starts must be a list of 1 to 10000 postures, but was a list of 0"),
        (vec![0; 30_001], "starts must be at most 30000 numbers, but was a list of 30001"),
    ] {
        assert_eq!(starts(json!({ "column": column })), Err(expected.into()));
    }
    assert!(starts(json!({ "column": vec![0; 30_000] })).is_ok());

    let setting = valid(velocity_limits());
    let evaluated = |gains: Value| told(outside::evaluate(&setting, &Given(Some(&gains))));
    let both = [3.0, 0.1, 5.0, 10.0, 10.0, 10.0];
    assert_eq!(evaluated(json!({ "column": both })), evaluated(json!(both)));
    assert!(evaluated(json!(both)).is_ok());
    for (gains, expected) in [
        (json!([1, 2, "x"]), "kθ must be a number, but was 'x'"),
        (json!([1, 2, 3, true, 5, 6]), "kx (gains[3]) must be a number, but was true"),
        (json!([1, 2, 3, 4]), "gains must be three numbers for each robot, but was 4 numbers"),
        (json!({}), "gains must be a Float64Array or an array of numbers, but was of type object"),
    ] {
        assert_eq!(evaluated(gains), Err(expected.into()));
    }
    // As many as there may be are looked at, one more is not.
    let most = evaluated(Value::Array(vec![Value::Null; 3_000_000]));
    assert_eq!(most, Err("kx must be a number, but was null".into()));
    let expected = "gains must be at most 3000000 numbers, but was 3000001 numbers";
    let more = evaluated(Value::Array(vec![Value::Null; 3_000_001]));
    assert_eq!(more, Err(expected.into()));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_survey_is_what_its_room_answers() {
    let setting = valid(velocity_limits());
    let k = Gains::new(3.0, 0.1, 5.0);
    let given = json!({
        "x": { "gain": "kx", "from": 1, "to": 4, "count": 3, "log": true },
        "y": { "gain": "kθ", "from": 2, "to": 3, "count": 2 },
        "gains": [3, 0.1, 5],
        "rows": [1, 2],
    });
    let landscape = Landscape {
        x: Axis { gain: Gain::X, from: 1.0, to: 4.0, count: 3, log: true },
        y: Axis { gain: Gain::Theta, from: 2.0, to: 3.0, count: 2, log: false },
        gains: k,
    };
    let costs = written(&Column(landscape.costs(&setting, [1, 2]).expect("costs")));
    assert_eq!(told(outside::landscape(&setting, &Given(Some(&given)))), Ok(costs));

    let mut given = json!({
        "x": { "from": -1, "to": 1, "count": 2 },
        "y": { "from": 0, "to": 3, "count": 3 },
        "headings": 4,
        "part": [1, 20],
    });
    let range = |from, to, count| Range { from, to, count };
    let grid = Grid { x: range(-1.0, 1.0, 2), y: range(0.0, 3.0, 3), headings: 4 };
    let starts = Grid::read(&Given(Some(&given))).and_then(|(grid, part)| grid.starts(part));
    assert_eq!(starts, grid.starts([1, 20]));
    given["gains"] = json!([3, 0.1, 5]);
    let ends = written(&Columns(study::robustness(&setting, k, &grid, [1, 20]).expect("ends")));
    assert_eq!(told(outside::robustness(&setting, &Given(Some(&given)))), Ok(ends));

    let given = json!({ "x": 1, "y": 2, "radius": 3, "count": 4, "seed": 5 });
    let starts = Circle::read(&Given(Some(&given))).and_then(|circle| circle.starts());
    assert_eq!(starts, Circle { x: 1.0, y: 2.0, radius: 3.0, count: 4, seed: 5 }.starts());
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_asked_of_the_law_and_of_many_seeds_is_what_its_room_answers() {
    let mut experiment = velocity_limits();
    experiment.evolution.population = 6;
    let setting = valid(experiment);
    let (gains, k) = (json!([3, 0.1, 5]), Gains::new(3.0, 0.1, 5.0));
    let (one, error) = (Given(Some(&gains)), json!({ "x": -1, "y": 0.5, "theta": 0.3 }));
    let terms = LawTerms::new(Law::ShimKim, &ErrorPosture::new(-1.0, 0.5, 0.3), &k, Velocity::ZERO);
    assert_eq!(told(outside::law_terms(&setting, &one, &Given(Some(&error)))), Ok(written(&terms)));

    let remaining = study::remaining_errors(&setting, &k, 0.5).expect("errors");
    let seconds = json!(0.5);
    let found = outside::remaining_errors(&setting, &one, &Given(Some(&seconds)));
    assert_eq!(told(found), Ok(written(&Columns(remaining))));

    let given = json!({ "seeds": [3, 5], "generations": 4 });
    let runs = written(&study::seed_runs(&setting, [3, 5], 4).expect("runs"));
    assert_eq!(told(outside::seed_runs(&setting, &Given(Some(&given)))), Ok(runs));
    let given = json!({ "seeds": [3, 5], "drives": 40 });
    let trials = written(&study::trials(&setting, [3, 5], 40).expect("trials"));
    assert_eq!(told(outside::trials(&setting, &Given(Some(&given)))), Ok(trials));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_generation_is_given_by_its_number_or_the_newest() {
    let evolution = evolved(velocity_limits(), 2);
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
