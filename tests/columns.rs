//! What is told of many things has one number of each, in their order.

mod common;

use common::json::written;
use common::{EP_GAINS, valid, velocity_limits};
use ep_locomotion::robot::{Disturbance, DisturbanceKind, Gains, Law};
use ep_locomotion::run::{Experiment, Outcome, Setting};
use ep_locomotion::schema::Columns;
use ep_locomotion::study::{Stability, StabilitySample, error_parts, fares, remaining_errors};
use ep_locomotion::theory::PromisedRate;
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

fn setting(law: Law) -> Setting {
    let disturbance =
        Disturbance { kind: DisturbanceKind::Slip, linear: 0.1, angular: -0.05, seed: 0 };
    let mut experiment = Experiment { law, disturbance, ..velocity_limits() };
    experiment.starts.push(experiment.goal);
    experiment.horizon = 1.5;
    valid(experiment)
}

/// Asserts that what is told has this column.
#[track_caller]
fn assert_column<T, N: Into<Value>>(told: &Value, path: &str, all: &[T], number: impl Fn(&T) -> N) {
    let column = told.pointer(path).unwrap_or_else(|| panic!("there is no {path}"));
    assert_eq!(*column, Value::from_iter(all.iter().map(number)), "{path}");
}

#[wasm_bindgen_test(unsupported = test)]
fn of_runs_their_cost_time_and_whether_they_arrived() {
    let ends = fares(&setting(Law::ShimKim), EP_GAINS);
    let arrived: Vec<_> = ends.iter().map(|end| end.outcome == Outcome::Arrived).collect();
    assert_eq!(arrived, [false, true], "both cases");
    let told = written(&Columns(ends.clone()));
    assert_column(&told, "/cost", &ends, |end| end.cost.total());
    assert_column(&told, "/finalTime", &ends, |end| end.cost.time);
    assert_column(&told, "/arrived", &ends, |end| u8::from(end.outcome == Outcome::Arrived));
}

#[wasm_bindgen_test(unsupported = test)]
fn of_a_run_its_samples_and_how_it_ended() {
    let setting = setting(Law::ShimKim);
    for start in [0, 1] {
        let samples: Vec<_> = setting.episode(EP_GAINS, start).samples().collect();
        let told = written(&setting.run(EP_GAINS, start));
        assert_column(&told, "/time", &samples, |sample| sample.time);
        assert_column(&told, "/x", &samples, |sample| sample.posture.x);
        assert_column(&told, "/y", &samples, |sample| sample.posture.y);
        assert_column(&told, "/theta", &samples, |sample| sample.posture.theta);
        assert_column(&told, "/linear", &samples, |sample| sample.velocity.linear);
        assert_column(&told, "/angular", &samples, |sample| sample.velocity.angular);
        assert_column(&told, "/commandLinear", &samples, |sample| sample.command.linear);
        assert_column(&told, "/commandAngular", &samples, |sample| sample.command.angular);
        assert_column(&told, "/referenceX", &samples, |sample| sample.reference.x);
        assert_column(&told, "/referenceY", &samples, |sample| sample.reference.y);
        assert_column(&told, "/referenceTheta", &samples, |sample| sample.reference.theta);
        let last = samples.last().expect("a sample");
        assert_eq!(told["arrived"], json!(last.outcome == Some(Outcome::Arrived)));
        assert_eq!(told["finalTime"], json!(last.time));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_an_error_its_parts_and_the_sets_of_theorem_2() {
    let setting = setting(Law::ShimKim);
    let samples = error_parts(&setting, &EP_GAINS, 0);
    let parts = written(&Columns(samples.clone()));
    assert_column(&parts, "/time", &samples, |sample| sample.time);
    assert_column(&parts, "/x", &samples, |sample| sample.error.x);
    assert_column(&parts, "/y", &samples, |sample| sample.error.y);
    assert_column(&parts, "/theta", &samples, |sample| sample.error.theta);
    assert_column(&parts, "/ySet", &samples, |sample| sample.sets.y);

    let all = remaining_errors(&setting, &EP_GAINS, 1.0).expect("errors");
    let remaining = written(&Columns(all.clone()));
    assert_column(&remaining, "/error/x", &all, |one| one.error.x);
    assert_column(&remaining, "/error/y", &all, |one| one.error.y);
    assert_column(&remaining, "/error/theta", &all, |one| one.error.theta);
    assert_column(&remaining, "/sets/x", &all, |one| one.sets.x);
    assert_column(&remaining, "/sets/y", &all, |one| one.sets.y);
    assert_column(&remaining, "/sets/theta", &all, |one| one.sets.theta);
}

#[wasm_bindgen_test(unsupported = test)]
fn of_stability_what_is_promised_and_what_becomes_of_it() {
    for (law, gains) in [
        (Law::ShimKim, EP_GAINS),
        (Law::Kanayama, EP_GAINS),
        (Law::Kanayama, Gains::new(1.0, -1.0, 1.0)),
    ] {
        let stability = Stability::of(&setting(law), &gains, 0);
        let (all, told) = (&stability.samples, written(&stability));
        let part = |part: fn(PromisedRate) -> f64| {
            move |sample: &StabilitySample| sample.promised.map_or(f64::NAN, part)
        };
        assert_column(&told, "/time", all, |sample| sample.time);
        assert_column(&told, "/errorX", all, |sample| sample.error.x);
        assert_column(&told, "/errorY", all, |sample| sample.error.y);
        assert_column(&told, "/errorTheta", all, |sample| sample.error.theta);
        assert_column(&told, "/lyapunov", all, |sample| sample.lyapunov);
        assert_column(&told, "/promisedX", all, part(|rate| rate.x));
        assert_column(&told, "/promisedY", all, part(|rate| rate.y));
        assert_column(&told, "/promisedTheta", all, part(|rate| rate.theta));
        assert_column(&told, "/rate", all, |sample| sample.rate);
        assert_column(&told, "/limited", all, |sample| u8::from(sample.limited));
        let weight = stability.function.map(|function| function.heading_weight);
        assert_eq!(told["headingWeight"], json!(weight));
    }
}
