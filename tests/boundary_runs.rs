//! The interface to JavaScript, called as JavaScript calls it: runs and evolutions. It exists under Node only.
#![cfg(target_arch = "wasm32")]

mod common;

use common::javascript::{EP, experiment, gains, get, js, number, text};
use ep_locomotion::wasm::{Evolution, Simulation, evaluate, simulate, simulate_all};
use js_sys::{Array, Float64Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn simulate_gives_one_value_a_sample_and_the_cost_in_parts() {
    let e = experiment("velocity-limits".into()).expect("a preset");
    let run = simulate(e.clone(), gains(EP), JsValue::UNDEFINED).expect("a run");
    for name in ["time", "x", "y", "theta", "linear", "angular", "commandLinear", "commandAngular"]
    {
        let column = get(&run, name).dyn_into::<Float64Array>().expect("a Float64Array");
        assert_eq!(column.length(), 191, "{name}");
    }
    assert!((number(&run, "cost.total") - 7.93542857).abs() < 1e-6);
    let parts = ["time", "finalError", "path", "energy", "penalty"];
    let sum: f64 = parts.iter().map(|part| number(&run, &format!("cost.{part}"))).sum();
    assert!((sum - number(&run, "cost.total")).abs() < 1e-12);
    assert_eq!(get(&run, "arrived"), JsValue::TRUE);
    assert_eq!(get(&run, "outcome"), JsValue::from("arrived"));
    assert!((number(&run, "finalTime") - 1.9).abs() < 1e-9);
    let runs =
        simulate_all(e.clone(), js("[3.23673, 0.09678, 5.17891, 10, 10, 10]"), JsValue::UNDEFINED);
    let runs = Array::from(&runs.expect("runs"));
    assert_eq!(text(&runs.get(0)), text(&run));
    assert!((number(&runs.get(1), "cost.total") - 9.01560109).abs() < 1e-6);
    let costs: Float64Array =
        evaluate(e, js("[3.23673, 0.09678, 5.17891, 10, 10, 10]")).expect("costs").into();
    assert_eq!(costs.to_vec()[0], number(&run, "cost.total"));
    assert!((costs.to_vec()[1] - 9.01560109).abs() < 1e-6);
}

#[wasm_bindgen_test]
fn a_run_carries_the_reference_that_it_follows() {
    let column = |run: &JsValue, name: &str| {
        get(run, name).dyn_into::<Float64Array>().expect("a Float64Array").to_vec()
    };
    let parked = simulate(js("({})"), gains(EP), JsValue::UNDEFINED).expect("a run");
    assert!(column(&parked, "referenceX").iter().all(|x| *x == 2.0));
    let e = js(
        "({ referenceVelocity: { linear: 0.5, angular: 0 }, goal: { x: 1, y: 3, theta: 0 }, horizon: 2 })",
    );
    let run = simulate(e, gains(EP), JsValue::UNDEFINED).expect("a run");
    let [time, x, y, theta] =
        ["time", "referenceX", "referenceY", "referenceTheta"].map(|name| column(&run, name));
    assert_eq!(time.len(), 201);
    for (i, t) in time.iter().enumerate() {
        assert!((x[i] - (1.0 + 0.5 * t)).abs() < 1e-9 && (y[i] - 3.0).abs() < 1e-9, "at {t} s");
        assert_eq!(theta[i], 0.0);
    }
}

#[wasm_bindgen_test]
fn a_run_carries_its_cost_as_it_is_paid() {
    let column = |run: &JsValue, name: &str| {
        get(run, name).dyn_into::<Float64Array>().expect("a Float64Array").to_vec()
    };
    let e = js("({ weights: { velocity: [2, 0.5] } })");
    let run = simulate(e, gains(EP), JsValue::UNDEFINED).expect("a run");
    let [x, y, theta, v, w, path, energy] =
        ["x", "y", "theta", "linear", "angular", "pathCost", "energyCost"]
            .map(|name| column(&run, name));
    let dt = 0.01;
    let (mut paid, mut spent) = (0.0, 0.0);
    for i in 0..x.len() {
        assert!((path[i] - paid).abs() < 1e-9 && (energy[i] - spent).abs() < 1e-9, "sample {i}");
        let heading = theta[i] - core::f64::consts::FRAC_PI_4;
        paid += 0.5 * dt * ((x[i] - 2.0).powi(2) + (y[i] - 2.0).powi(2) + heading * heading);
        spent += 0.5 * dt * (2.0 * v[i] * v[i] + 0.5 * w[i] * w[i]);
    }
    assert_eq!(path.last(), Some(&number(&run, "cost.path")));
    assert_eq!(energy.last(), Some(&number(&run, "cost.energy")));
}

#[wasm_bindgen_test]
fn a_simulation_steps_through_the_same_run() {
    let e = experiment("acceleration-limits".into()).expect("a preset");
    let run = simulate(e.clone(), gains(EP), JsValue::UNDEFINED).expect("a run");
    let x = Float64Array::from(get(&run, "x")).to_vec();
    let mut robot = Simulation::new(e, gains(EP), 0.into()).expect("a robot");
    for x in &x {
        let sample = robot.step(JsValue::UNDEFINED).expect("a sample");
        assert_eq!(number(&sample, "posture.x"), *x);
        for name in ["command", "velocity", "reference", "error", "lyapunov", "lyapunovRate"] {
            assert!(!get(&sample, name).is_undefined(), "{name}");
        }
    }
    let last = robot.step(JsValue::UNDEFINED).expect("a sample");
    assert_eq!(
        (number(&last, "posture.x"), get(&last, "arrived")),
        (x[x.len() - 1], JsValue::TRUE)
    );
}

#[wasm_bindgen_test]
fn an_evolution_tells_its_generations() {
    let mut evolution = Evolution::new(js("{}")).expect("a run");
    for generation in 1..=5 {
        let statistics = evolution.step(JsValue::UNDEFINED).expect("a generation");
        assert_eq!(number(&statistics, "generation"), f64::from(generation));
        assert_eq!(number(&statistics, "evaluations"), f64::from(20 * (generation + 1)));
    }
    assert_eq!(evolution.generation(), 5);
    let record = evolution.record(3.into()).expect("a record");
    for (name, length) in [
        ("parents", 20),
        ("offspring", 20),
        ("mutations", 20),
        ("opponents", 40),
        ("wins", 40),
        ("ranking", 40),
        ("survivors", 20),
    ] {
        assert_eq!(Array::from(&get(&record, name)).length(), length, "{name}");
    }
    let numbers = |name| text(&get(&record, name));
    let survivors = numbers("survivors");
    assert!(numbers("ranking").starts_with(survivors.trim_end_matches(']')));
    assert_eq!(Array::from(&get(&record, "parents.0.gains")).length(), 3);
    assert_eq!(number(&record, "generation"), 3.0);
    let newest = evolution.population(JsValue::UNDEFINED).expect("a population");
    let statistics = evolution.statistics(JsValue::UNDEFINED).expect("statistics");
    assert_eq!(text(&get(&newest, "0")), text(&get(&statistics, "best")));
    assert_eq!(evolution.hash().len(), 16);
}
