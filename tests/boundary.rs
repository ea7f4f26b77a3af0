//! The interface to JavaScript, called as JavaScript calls it. It exists under Node only.
#![cfg(target_arch = "wasm32")]

use ep_locomotion::wasm::{
    Evolution, Simulation, error_parts, evaluate, experiment, fares, fields, landscape, law_terms,
    paper, random_seed, remaining_errors, robustness, seed_runs, simulate, simulate_all, stability,
    starts_on_circle, starts_on_grid, wins_bout, word_fields,
};
use js_sys::{Array, Float64Array, Function, JSON, Object, Reflect, Uint8Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

/// The value of a JavaScript expression.
fn js(expression: &str) -> JsValue {
    Function::new_no_args(&format!("return ({expression})"))
        .call0(&JsValue::NULL)
        .expect(expression)
}

fn text(value: &JsValue) -> String {
    JSON::stringify(value).expect("plain").into()
}

fn get(object: &JsValue, path: &str) -> JsValue {
    path.split('.')
        .fold(object.clone(), |value, key| Reflect::get(&value, &key.into()).expect("an object"))
}

fn number(object: &JsValue, path: &str) -> f64 {
    get(object, path).as_f64().expect(path)
}

#[track_caller]
fn message<T>(result: Result<T, JsValue>) -> String {
    let error = result.err().expect("refused");
    error.dyn_into::<js_sys::Error>().expect("an Error").message().into()
}

fn gains(k: [f64; 3]) -> JsValue {
    Float64Array::from(k.as_slice()).into()
}

const EP: [f64; 3] = [3.23673, 0.09678, 5.17891];

#[wasm_bindgen_test]
fn presets_have_every_field_and_partial_experiments_are_completed() {
    let preset = experiment("velocity-limits".into()).expect("a preset");
    assert_eq!(
        text(&preset),
        "{\"law\":\"shim-kim\",\"starts\":[{\"x\":0,\"y\":0,\"theta\":0}],\
         \"goal\":{\"x\":2,\"y\":2,\"theta\":0.7853981633974483},\
         \"referenceVelocity\":{\"linear\":0,\"angular\":0},\"sampleTime\":0.01,\"horizon\":10,\
         \"limits\":{\"speed\":2,\"turnRate\":6.283185307179586,\"acceleration\":null,\
         \"turnAcceleration\":null},\"tolerance\":{\"position\":0.05,\"heading\":0.05,\"speed\":null,\"turnRate\":null},\
         \"weights\":{\"final\":[1,1,1],\"velocity\":[1,1],\"penalty\":1000},\
         \"disturbance\":{\"kind\":\"none\",\"linear\":0,\"angular\":0,\"seed\":0},\
         \"evolution\":{\"population\":20,\"opponents\":10,\"seed\":1,\
         \"initialRange\":[0.01,10],\"initialSigma\":1,\
         \"method\":\"ep\",\"step\":\"gaussian\",\"adaptation\":1,\"sigmaFloor\":0,\
         \"selection\":\"tournament\",\"crossover\":0,\"belowZero\":\"penalty\"}}"
    );
    assert_eq!(text(&experiment(js("{}")).expect("defaults")), text(&preset));
    assert_eq!(text(&experiment(preset.clone()).expect("itself")), text(&preset));
    let changed = experiment(js("{goal: {x: 1}, starts: [{y: 2}, {}], limits: {speed: null}}"));
    let changed = changed.expect("valid");
    assert_eq!(text(&get(&changed, "goal")), "{\"x\":1,\"y\":2,\"theta\":0.7853981633974483}");
    assert_eq!(text(&get(&changed, "starts.0")), "{\"x\":0,\"y\":2,\"theta\":0}");
    assert!(get(&changed, "limits.speed").is_null());
}

#[wasm_bindgen_test]
fn a_wrong_experiment_is_refused_by_name() {
    for (given, expected) in [
        ("null", "experiment must be an object, but was null"),
        ("undefined", "experiment must be an object, but was undefined"),
        ("7", "experiment must be an object, but was 7"),
        ("[]", "experiment must be an object, but was an array of 0"),
        ("{goal: null}", "goal must be an object, but was null"),
        (
            "{goal: {z: 1}}",
            "goal must be an object with no fields but x, y, theta, but was one with 'z'",
        ),
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
        (
            "{[Symbol.iterator]: 1}",
            "experiment must be an object with no fields but law, starts, goal, referenceVelocity, sampleTime, horizon, limits, tolerance, weights, disturbance, evolution, but was one with 'a symbol'",
        ),
        ("{get goal() { throw new Error('trap') }}", "trap"),
        ("new Proxy({}, {ownKeys() { throw new Error('trap') }})", "trap"),
    ] {
        assert_eq!(message(experiment(js(given))), expected, "{given}");
    }
    assert_eq!(
        message(experiment("figure-4".into())),
        "experiment must be 'velocity-limits' or 'acceleration-limits', but was 'figure-4'"
    );
    // An inherited field is nobody's wish.
    let inherited = experiment(js("Object.create({horizon: 3})")).expect("valid");
    assert_eq!(number(&inherited, "horizon"), 10.0);
}

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
        let sample = robot.step();
        assert_eq!(number(&sample, "posture.x"), *x);
        for name in ["command", "velocity", "reference", "error", "lyapunov", "lyapunovRate"] {
            assert!(!get(&sample, name).is_undefined(), "{name}");
        }
    }
    let last = robot.step();
    assert_eq!(
        (number(&last, "posture.x"), get(&last, "arrived")),
        (x[x.len() - 1], JsValue::TRUE)
    );
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
        "the number of gain triples must be at most 400000 with 1 starts and 1000 samples a run, \
         but was 1000000"
    );
}

#[wasm_bindgen_test]
fn an_evolution_tells_its_generations() {
    let mut evolution = Evolution::new(js("{}")).expect("a run");
    for generation in 1..=5 {
        let statistics = evolution.step();
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

#[wasm_bindgen_test]
fn a_landscape_is_the_same_in_one_piece_or_in_rows() {
    let spec = |rows: &str| {
        let text = format!(
            "{{x: {{gain: 'kx', from: 1, to: 9, count: 5}}, y: {{gain: 'ktheta', from: 1, to: 10, \
             count: 4, log: true}}, gains: [0, 0.1, 0]{rows}}}"
        );
        landscape(js("{}"), js(&text)).map(|costs| Float64Array::from(costs).to_vec())
    };
    let whole = spec("").expect("costs");
    assert_eq!(whole.len(), 20);
    let rows = [spec(", rows: [0, 1]").expect("costs"), spec(", rows: [1, 4]").expect("costs")];
    assert_eq!(rows.concat(), whole);
    // kx = 3, kθ = 10 is the second of the last row.
    let alone =
        Float64Array::from(evaluate(js("{}"), js("[3, 0.1, 10]")).expect("a cost")).to_vec();
    assert!((alone[0] - whole[16]).abs() < 1e-9);
    assert_eq!(
        message(spec(", rows: [0, 5]")),
        "landscape.rows[1] must be a whole number from 0 to 4, but was 5"
    );
    assert_eq!(
        message(landscape(js("{}"), js("{}"))),
        "landscape.x must be an object, but was undefined"
    );
}

#[wasm_bindgen_test]
fn surveys_give_arrays_and_refuse_by_name() {
    let map = robustness(
        js("{}"),
        js(
            "{gains: [3, 2, 5], x: {from: 0, to: 1, count: 3}, y: {from: 0, to: 1, count: 2}, headings: 4}",
        ),
    );
    let map = map.expect("a map");
    for name in ["cost", "finalTime", "arrived"] {
        assert_eq!(number(&get(&map, name), "length"), 24.0, "{name}");
    }
    let circle = starts_on_circle(js("{x: 2, y: 2, radius: 2.83, count: 32, seed: 1}"));
    let starts = Array::from(&circle.expect("starts"));
    assert_eq!(starts.length(), 32);
    let many = Object::new();
    Reflect::set(&many, &"starts".into(), &starts).expect("set");
    let completed = experiment(many.clone().into()).expect("valid");
    assert_eq!(Array::from(&get(&completed, "starts")).length(), 32);
    let each = fares(many.into(), gains(EP)).expect("32 runs");
    for name in ["cost", "finalTime", "arrived"] {
        assert_eq!(number(&get(&each, name), "length"), 32.0, "{name}");
    }
    assert_eq!(
        message(fares(js("{}"), js("[1, 2]"))),
        "gains must be three numbers for each robot, but was 2 numbers"
    );
    let runs = seed_runs(js("{}"), js("{seeds: [1, 3], generations: 5}"));
    let runs = Array::from(&runs.expect("runs"));
    assert_eq!(runs.length(), 2);
    assert_eq!(number(&get(&runs.get(1), "random"), "length"), 6.0);
    assert_eq!(
        number(&runs.get(0), "champion.cost"),
        Float64Array::from(get(&runs.get(0), "best")).to_vec()[5]
    );
    assert_eq!(
        message(seed_runs(js("{}"), js("{seeds: [1, 3], generations: -1}"))),
        "seeds.generations must be a whole number from 0 to 536870911, but was -1"
    );
    assert_eq!(
        message(starts_on_circle(js("{x: 2, y: 2, radius: NaN, count: 32, seed: 1}"))),
        "radius must be a number from -1000 to 1000 m, but was NaN"
    );
    assert_eq!(
        message(robustness(js("{}"), js("{gains: [1, 2, 3], x: 5}"))),
        "grid.x must be an object, but was 5"
    );
}

#[wasm_bindgen_test]
fn errors_that_remain_are_told_beside_the_sets_of_theorem_2() {
    let given = js("{starts: [{}, {x: 4}], tolerance: {position: 0}, horizon: 5, \
                     disturbance: {kind: 'slip', linear: -0.1, angular: 0.2}}");
    let runs = Array::from(&error_parts(given.clone(), gains(EP)).expect("two runs"));
    assert_eq!(runs.length(), 2);
    for name in ["time", "x", "y", "theta", "ySet"] {
        assert_eq!(number(&runs.get(1), &format!("{name}.length")), 501.0, "{name}");
    }
    let remaining = remaining_errors(given, gains(EP), 2.into()).expect("errors");
    for name in ["error.x", "error.y", "error.theta", "sets.x", "sets.y", "sets.theta"] {
        assert_eq!(number(&remaining, &format!("{name}.length")), 2.0, "{name}");
    }
    assert_eq!(number(&remaining, "sets.x.0"), 0.1 / EP[0]);
    assert_eq!(number(&remaining, "sets.theta.1"), 0.2 / EP[2]);
    for (result, expected) in [
        (remaining_errors(js("{}"), gains(EP), js("'2'")), "seconds must be a number, but was '2'"),
        (
            remaining_errors(js("{}"), gains(EP), 11.into()),
            "seconds must be a number from 0 to the horizon of 10 s, but was 11",
        ),
        (
            remaining_errors(js("{}"), js("[1, 2]"), 1.into()),
            "gains must be three numbers for each robot, but was 2 numbers",
        ),
        (
            remaining_errors(js("{disturbance: {angular: 101}}"), gains(EP), 1.into()),
            "disturbance.angular must be a number from -100 to 100 rad/s, but was 101",
        ),
        (
            error_parts(js("{disturbance: {kind: 'random', linear: -1}}"), gains(EP)),
            "disturbance.linear must be 0 or more for a random disturbance, but was -1",
        ),
    ] {
        assert_eq!(message(result), expected);
    }
}

#[wasm_bindgen_test]
fn the_lyapunov_function_of_a_run_has_one_value_a_sample() {
    let column = |object: &JsValue, name: &str| {
        get(object, name).dyn_into::<Float64Array>().expect("a Float64Array").to_vec()
    };
    let run = simulate(js("{}"), gains(EP), JsValue::UNDEFINED).expect("a run");
    let of_run = stability(js("{}"), gains(EP), JsValue::UNDEFINED).expect("its V");
    assert_eq!(column(&of_run, "time"), column(&run, "time"));
    assert_eq!(number(&of_run, "headingWeight"), 1.0);
    let limited = get(&of_run, "limited").dyn_into::<Uint8Array>().expect("a Uint8Array").to_vec();
    let [errors, promised] =
        [["errorX", "errorY", "errorTheta"], ["promisedX", "promisedY", "promisedTheta"]]
            .map(|names| names.map(|name| column(&of_run, name)));
    let (v, rate) = (column(&of_run, "lyapunov"), column(&of_run, "rate"));
    for i in 0..column(&run, "time").len() {
        let [x, y, theta] = [0, 1, 2].map(|part| errors[part][i]);
        assert!((v[i] - (0.5 * x * x + 0.5 * y * y + 1.0 - theta.cos())).abs() < 1e-12);
        let expected = [(x * theta.cos()).powi(2), y.powi(4), theta.sin().powi(2)];
        for part in 0..3 {
            assert!((promised[part][i] + EP[part] * expected[part]).abs() < 1e-9);
        }
        let sum: f64 = promised.iter().map(|values| values[i]).sum();
        assert_eq!((rate[i] - sum).abs() > 1e-9, limited[i] == 1, "sample {i}");
    }
    let unproved = stability(js("{law: 'kanayama'}"), js("[1, 0, 1]"), 0.into()).expect("its V");
    assert!(get(&unproved, "headingWeight").is_null());
    assert!(column(&unproved, "promisedY").iter().all(|part| part.is_nan()));
    for (result, expected) in [
        (
            stability(js("{}"), js("[1, 2]"), JsValue::UNDEFINED),
            "gains must be three numbers for each robot, but was 2 numbers",
        ),
        (
            stability(js("{}"), gains(EP), 1.into()),
            "start must be a whole number from 0 to 0, but was 1",
        ),
    ] {
        assert_eq!(message(result), expected);
    }
}

#[wasm_bindgen_test]
fn the_law_at_an_error_posture_is_told_in_its_terms() {
    let error = "{x: 1, y: -2, theta: 0.5}";
    let terms = law_terms(js("{}"), gains(EP), js(error)).expect("terms");
    let (sin, cos) = (0.5_f64.sin(), 0.5_f64.cos());
    for (path, expected) in [
        ("command.kx.linear", EP[0] * cos),
        ("command.kx.angular", -2.0 * EP[0] * cos),
        ("command.ky.linear", 8.0 * EP[1] / sin),
        ("command.ky.angular", -8.0 * EP[1] * cos / (sin * sin)),
        ("command.ktheta.linear", 0.0),
        ("command.ktheta.angular", EP[2] * sin),
        ("command.reference.linear", 0.0),
        ("command.reference.angular", 0.0),
        ("promised.x", -EP[0] * cos * cos),
        ("promised.y", -EP[1] * 16.0),
        ("promised.theta", -EP[2] * sin * sin),
    ] {
        assert!((number(&terms, path) - expected).abs() < 1e-12, "{path}");
    }
    let other = js("{law: 'kanayama', referenceVelocity: {linear: 2, angular: 1}}");
    let terms = law_terms(other, js("[1, 0, 1]"), js(error)).expect("terms");
    assert!((number(&terms, "command.reference.linear") - 2.0 * cos).abs() < 1e-12);
    assert_eq!(number(&terms, "command.reference.angular"), 1.0);
    assert!(get(&terms, "promised").is_null());
    for (given, expected) in [
        ("{x: 1, y: 1}", "error.theta must be a finite number, but was undefined"),
        ("{x: 1, y: Infinity, theta: 0}", "error.y must be a finite number, but was Infinity"),
        ("[1, 1, 0]", "error must be an object, but was an array of 3"),
    ] {
        assert_eq!(message(law_terms(js("{}"), gains(EP), js(given))), expected);
    }
}

#[wasm_bindgen_test]
fn the_starts_of_a_map_and_the_bouts_of_a_tournament_are_told() {
    let grid = "x: {from: -1, to: 1, count: 2}, y: {from: 0, to: 1, count: 2}, headings: 2";
    let starts = |rest: &str| starts_on_grid(js(&format!("{{{grid}{rest}}}")));
    let all = Array::from(&starts("").expect("starts"));
    assert_eq!(all.length(), 8);
    assert_eq!(text(&all.get(2)), "{\"x\":1,\"y\":0,\"theta\":0}");
    assert_eq!(text(&all.get(7)), "{\"x\":1,\"y\":1,\"theta\":3.141592653589793}");
    let part = Array::from(&starts(", part: [2, 3]").expect("starts"));
    assert_eq!((part.length(), text(&part.get(0))), (1, text(&all.get(2))));
    for (rest, expected) in [
        (", part: [0, 9]", "grid.part[1] must be a whole number from 0 to 8, but was 9"),
        (
            ", gains: [1, 2, 3]",
            "grid must be an object with no fields but x, y, headings, part, but was one with 'gains'",
        ),
    ] {
        assert_eq!(message(starts(rest)), expected);
    }
    for (cost, opponent, wins) in [
        ("1", "2", true),
        ("2", "2", true),
        ("2", "1", false),
        ("Infinity", "Infinity", false),
        ("1", "Infinity", true),
    ] {
        assert_eq!(wins_bout(js(cost), js(opponent)), Ok(wins), "{cost} against {opponent}");
    }
    assert_eq!(message(wins_bout(js("1"), js("'2'"))), "opponent must be a number, but was '2'");
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
    assert_eq!(fields.length(), 30);
    assert_eq!(Object::keys(fields.get(0).unchecked_ref::<Object>()).length(), 6);
    let words: Vec<String> =
        Array::from(&word_fields().expect("rows")).iter().map(|field| text(&field)).collect();
    assert_eq!(
        words,
        [
            "{\"path\":\"law\",\"words\":[\"shim-kim\",\"kanayama\"]}",
            "{\"path\":\"disturbance.kind\",\"words\":[\"none\",\"random\",\"slip\"]}",
            "{\"path\":\"evolution.method\",\"words\":[\"ep\",\"random\",\"de\",\"cma-es\",\
             \"one-plus-one-es\",\"nelder-mead\",\"one-at-a-time\",\"finite-differences\"]}",
            "{\"path\":\"evolution.step\",\"words\":[\"gaussian\",\"cauchy\"]}",
            "{\"path\":\"evolution.selection\",\"words\":[\"tournament\",\"truncation\",\"parent\"]}",
            "{\"path\":\"evolution.belowZero\",\"words\":[\"penalty\",\"mirror\",\"clamp\"]}",
        ]
    );
    let seeds = [random_seed(), random_seed(), random_seed()].map(|seed| seed.expect("a seed"));
    assert!(seeds[0] != seeds[1] || seeds[1] != seeds[2]);
}
