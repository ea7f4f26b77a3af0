//! The interface to JavaScript, called as JavaScript calls it: studies. It exists under Node only.
#![cfg(target_arch = "wasm32")]

mod common;

use common::javascript::{EP, experiment, gains, get, js, message, number, text};
use ep_locomotion::wasm::{
    error_parts, evaluate, fares, landscape, law_terms, remaining_errors, robustness, seed_runs,
    simulate, stability, starts_on_circle, starts_on_grid, wins_bout,
};
use js_sys::{Array, Float64Array, Object, Reflect, Uint8Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

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
        "circle.radius must be a number from 0 to 1000 m, but was NaN"
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
