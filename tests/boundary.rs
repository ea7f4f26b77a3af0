//! The interface to JavaScript, called as JavaScript calls it: experiments, and what is refused. It exists under Node only.
#![cfg(target_arch = "wasm32")]

mod common;

use common::javascript::{experiment, get, js, message, number, text};
use common::{PRESET, Random};
use ep_locomotion::run::{Experiment, Preset};
use ep_locomotion::schema::WordField;
use ep_locomotion::wasm::{Evolution, evaluate, fields, paper, random_seed, simulate, word_fields};
use js_sys::{Array, Function, Object, Reflect};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn presets_have_every_field_and_partial_experiments_are_completed() {
    let preset = experiment("velocity-limits".into()).expect("a preset");
    assert_eq!(text(&preset), PRESET);
    assert_eq!(text(&experiment(js("{}")).expect("defaults")), text(&preset));
    assert_eq!(text(&experiment(preset.clone()).expect("itself")), text(&preset));
    let changed = experiment(js("{goal: {x: 1}, starts: [{y: 2}, {}], limits: {speed: null}}"));
    let changed = changed.expect("valid");
    assert_eq!(text(&get(&changed, "goal")), "{\"x\":1,\"y\":2,\"theta\":0.7853981633974483}");
    assert_eq!(text(&get(&changed, "starts.0")), "{\"x\":0,\"y\":2,\"theta\":0}");
    assert!(get(&changed, "limits.speed").is_null());
    let other = text(&experiment(js("'acceleration-limits'")).expect("a preset"));
    assert_eq!(
        text(
            &ep_locomotion::wasm::experiment(js("{}"), js("'acceleration-limits'"))
                .expect("a preset")
        ),
        other
    );
    assert_eq!(
        text(
            &ep_locomotion::wasm::experiment(js("'acceleration-limits'"), js("{}"))
                .expect("a preset")
        ),
        other
    );
    for (a, b) in
        [("{horizon: 5}", "'acceleration-limits'"), ("'acceleration-limits'", "{horizon: 5}")]
    {
        let changed = ep_locomotion::wasm::experiment(js(a), js(b)).expect("valid");
        assert_eq!(number(&changed, "horizon"), 5.0);
        assert_eq!(number(&changed, "limits.acceleration"), 5.0);
    }
    for (a, b, expected) in [
        (
            "{}",
            "{}",
            "preset must be 'velocity-limits' or 'acceleration-limits', but was of type object",
        ),
        (
            "{}",
            "'none'",
            "experiment must be 'velocity-limits' or 'acceleration-limits', but was 'none'",
        ),
        ("'velocity-limits'", "3", "experiment must be an object, but was 3"),
        (
            "'velocity-limits'",
            "{x: 1}",
            "experiment must be an object with no fields but law, starts, goal, referenceVelocity, sampleTime, horizon, limits, tolerance, weights, disturbance, evolution, but was one with 'x'",
        ),
    ] {
        assert_eq!(message(ep_locomotion::wasm::experiment(js(a), js(b))), expected);
    }
}

#[wasm_bindgen_test]
fn a_spread_copy_of_an_experiment_is_completed_from_the_preset_that_this_was_made_from() {
    let spread: Function = js("(whole, change) => ({...whole, ...change})").unchecked_into();
    let with = |whole: &JsValue, change: &str| {
        experiment(spread.call2(&JsValue::NULL, whole, &js(change)).expect("a copy"))
            .expect("valid")
    };
    for name in Preset::WORDS {
        let preset = experiment((*name).into()).expect("a preset");
        for change in ["{limits: {speed: 1}}", "{horizon: 5, goal: {x: 1}, limits: {}}"] {
            let changed = with(&preset, change);
            let named = ep_locomotion::wasm::experiment((*name).into(), js(change));
            assert_eq!(text(&changed), text(&named.expect("valid")));
            assert_eq!(text(&get(&with(&changed, "{limits: {}}"), "limits")), {
                text(&get(&preset, "limits"))
            });
        }
    }
    let other = experiment("acceleration-limits".into()).expect("a preset");
    let part = Object::new();
    Reflect::set(&part, &"goal".into(), &get(&other, "goal")).expect("a plain object");
    assert_eq!(text(&experiment(part.into()).expect("valid")), PRESET);
    let parsed = js_sys::JSON::parse(&text(&other)).expect("its text");
    assert!(get(&with(&parsed, "{limits: {}}"), "limits.acceleration").is_null());
}

/// What is given, and what is said of it.
#[track_caller]
fn assert_refused(cases: &[(&str, &str)]) {
    for (given, expected) in cases {
        assert_eq!(message(experiment(js(given))), *expected, "{given}");
    }
}

#[wasm_bindgen_test]
fn a_wrong_field_is_refused_by_name() {
    assert_refused(&[
        ("{goal: {x: '1'}}", "goal.x must be a number from -1000 to 1000 m, but was '1'"),
        ("{goal: {x: NaN}}", "goal.x must be a number from -1000 to 1000 m, but was NaN"),
        ("{goal: {x: null}}", "goal.x must be a number from -1000 to 1000 m, but was null"),
        ("{goal: {x: 1n}}", "goal.x must be a number from -1000 to 1000 m, but was of type bigint"),
        (
            "{goal: {x: Symbol()}}",
            "goal.x must be a number from -1000 to 1000 m, but was of type symbol",
        ),
        (
            "{goal: {x: new Number(1)}}",
            "goal.x must be a number from -1000 to 1000 m, but was of type object",
        ),
        ("{law: 'none'}", "law must be 'shim-kim' or 'kanayama', but was 'none'"),
        ("{law: 1}", "law must be 'shim-kim' or 'kanayama', but was 1"),
        ("{starts: {}}", "starts must be an array of 1 to 10000, but was of type object"),
        ("{starts: []}", "starts must be a list of 1 to 10000 postures, but was a list of 0"),
        (
            "{starts: new Array(1e7)}",
            "starts must be an array of 1 to 10000, but was an array of 10000000",
        ),
        (
            "{starts: [{}, {x: 1e9}]}",
            "starts[1].x must be a number from -1000 to 1000 m, but was 1000000000",
        ),
        ("{weights: {final: [1]}}", "weights.final must be an array of 3, but was an array of 1"),
        (
            "{weights: {final: [1, 2, -1]}}",
            "weights.final[2] must be a number from 0 to 1000000, but was -1",
        ),
        (
            "{limits: {speed: 'fast'}}",
            "limits.speed must be a number from 0 to 1000000 m/s, or null for no limit, but was 'fast'",
        ),
        (
            "{limits: {speed: Infinity}}",
            "limits.speed must be a number from 0 to 1000000 m/s, or null for no limit, but was Infinity",
        ),
        (
            "{evolution: {population: 2.5}}",
            "evolution.population must be a whole number from 1 to 2000, but was 2.5",
        ),
        (
            "{evolution: {seed: -1}}",
            "evolution.seed must be a whole number from 0 to 4294967295, but was -1",
        ),
        (
            "{disturbance: {kind: 'wind'}}",
            "disturbance.kind must be 'none' or 'random' or 'slip', but was 'wind'",
        ),
    ]);
}

#[wasm_bindgen_test]
fn what_is_no_experiment_is_refused_by_name() {
    assert_refused(&[
        ("null", "experiment must be an object, but was null"),
        ("undefined", "experiment must be an object, but was undefined"),
        ("7", "experiment must be an object, but was 7"),
        ("[]", "experiment must be an object, but was an array of 0"),
        ("{goal: null}", "goal must be an object, but was null"),
        (
            "{goal: {z: 1}}",
            "goal must be an object with no fields but x, y, theta, but was one with 'z'",
        ),
        (
            "{[Symbol.iterator]: 1}",
            "experiment must be an object with no fields but law, starts, goal, referenceVelocity, sampleTime, horizon, limits, tolerance, weights, disturbance, evolution, but was one with 'a symbol'",
        ),
        (
            "{get goal() { throw new Error('trap') }}",
            "goal must be an object, but was one that cannot be read",
        ),
        (
            "new Proxy({}, {ownKeys() { throw new Error('trap') }})",
            "experiment must be an object, but was one that cannot be read",
        ),
        // What has its fields elsewhere would be the usual experiment.
        ("Promise.resolve({})", "experiment must be a plain object, but was of type Promise"),
        ("new Map([['horizon', 3]])", "experiment must be a plain object, but was of type Map"),
        ("{limits: new Map([['speed', 1]])}", "limits must be a plain object, but was of type Map"),
        (
            "{goal: new (class Pose { get x() { return 1 } })}",
            "goal must be a plain object, but was of type Pose",
        ),
        (
            "new (class Task { __wbg_ptr = 1 })",
            "experiment must be a plain object, but was of type Task",
        ),
        (
            "{goal: {constructor: {}}}",
            "goal must be an object with no fields but x, y, theta, but was one with 'constructor'",
        ),
    ]);
    assert_eq!(
        message(experiment("figure-4".into())),
        "experiment must be 'velocity-limits' or 'acceleration-limits', but was 'figure-4'"
    );
    // An inherited field is nobody's wish.
    let inherited = experiment(js("Object.create({horizon: 3})")).expect("valid");
    assert_eq!(number(&inherited, "horizon"), 10.0);
}

/// JavaScript writes the numbers of its messages itself.
#[wasm_bindgen_test]
fn a_number_in_a_message_is_the_same_text_as_natively() {
    let mut random = Random::new(1);
    let special = [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e21, 1e-6, 9e-7, 1e6];
    for number in special.into_iter().chain((0..2000).map(|_| random.hostile())) {
        let horizon = -number;
        let refused = Experiment { horizon, ..Preset::VelocityLimits.experiment() }.validate();
        let Err(natively) = refused else { continue };
        let given = Object::new();
        Reflect::set(&given, &"horizon".into(), &horizon.into()).expect("set");
        assert_eq!(message(experiment(given.into())), natively.to_string());
    }
}

#[wasm_bindgen_test]
fn wrong_arguments_are_refused_by_name() {
    let e = || experiment("velocity-limits".into()).expect("a preset");
    let run = |gains: &str, start: &str| message(simulate(e(), js(gains), js(start)));
    for (given, start, expected) in [
        (
            "undefined",
            "0",
            "gains must be a Float64Array or an array of numbers, but was undefined",
        ),
        ("'123'", "0", "gains must be a Float64Array or an array of numbers, but was '123'"),
        ("[1, 2]", "0", "gains must be three numbers for each robot, but was 2 numbers"),
        ("[1, 2, 3, 4, 5, 6]", "0", "gains must be three numbers (kx, ky, kθ), but was 6 numbers"),
        ("[1, 2, 'x']", "0", "kθ must be a number, but was 'x'"),
        ("[1, NaN, 3]", "0", "ky must be a finite number, but was NaN"),
        ("[1, 2, 3]", "1", "start must be a whole number from 0 to 0, but was 1"),
        ("[1, 2, 3]", "0.5", "start must be a whole number from 0 to 0, but was 0.5"),
        ("[1, 2, 3]", "'0'", "start must be a number, but was '0'"),
    ] {
        assert_eq!(run(given, start), expected);
    }
    let evolution = Evolution::new(e()).expect("a run");
    assert_eq!(
        message(evolution.record(1.into())),
        "generation must be a whole number from 0 to 0, the newest, but was 1"
    );
    let many = format!("new Float64Array({})", 3_000_000);
    assert_eq!(
        message(evaluate(e(), js(&many))),
        "the number of gain triples must be at most 400000 with 1 start and 1000 samples a run, \
         but was 1000000"
    );
}

#[wasm_bindgen_test]
fn the_tables_are_complete() {
    assert_eq!(Array::from(&paper()).length(), 4);
    let fields = Array::from(&fields().expect("rows"));
    let preset = experiment("velocity-limits".into()).expect("a preset");
    for field in fields.iter() {
        let path = get(&field, "path").as_string().expect("a path").replace("[]", ".0");
        assert!(!get(&preset, &path).is_undefined(), "{path}");
    }
    assert_eq!(fields.length() as usize, Experiment::fields().numbers.len());
    assert_eq!(Object::keys(fields.get(0).unchecked_ref::<Object>()).length(), 6);
    let words: Vec<String> =
        Array::from(&word_fields().expect("rows")).iter().map(|field| text(&field)).collect();
    let expected = Experiment::fields().words.into_iter().map(|WordField { path, words }| {
        let words: Vec<_> = words.iter().map(|word| format!("\"{word}\"")).collect();
        format!("{{\"path\":\"{path}\",\"words\":[{}]}}", words.join(","))
    });
    assert_eq!(words, expected.collect::<Vec<_>>());
    let seeds = [random_seed(), random_seed(), random_seed()].map(|seed| seed.expect("a seed"));
    assert!(seeds[0] != seeds[1] || seeds[1] != seeds[2]);
}
