//! Laws of a whole run and of its cost.

mod common;

use core::f64::consts::PI;

use common::{EP_GAINS, Random, assert_close, cost, run, valid, velocity_limits};
use ep_locomotion::number::wrap;
use ep_locomotion::robot::{Gains, Limits, Posture};
use ep_locomotion::run::{Experiment, Outcome, Preset, Sample};
use wasm_bindgen_test::wasm_bindgen_test;

/// Starts from which the paper's gains arrive, so that rounding cannot decide the outcome.
fn gentle(random: &mut Random) -> (Experiment, Gains) {
    let start = Posture {
        x: random.within(-0.5, 0.5),
        y: random.within(-0.5, 0.5),
        theta: random.within(-0.5, 0.5),
    };
    let gains =
        Gains::new(random.within(2.0, 5.0), random.within(0.01, 0.2), random.within(3.0, 6.0));
    (Experiment { starts: vec![start], ..velocity_limits() }, gains)
}

#[wasm_bindgen_test(unsupported = test)]
fn every_sample_follows_from_the_one_before_by_the_exact_arc() {
    let mut random = Random::new(1);
    for round in 0..200 {
        let gains = random.gains(0.0, 10.0);
        let mut experiment = velocity_limits();
        experiment.starts = vec![random.posture(3.0)];
        if round % 2 == 1 {
            experiment.reference_velocity = random.velocity(1.0);
        }
        // Small turns go by series, large ones by sine and arc tangent.
        experiment.sample_time = [0.01, 0.05, 0.5][round % 3];
        if round % 5 == 0 {
            experiment.limits = Limits::NONE;
        }
        let dt = experiment.sample_time;
        for pair in run(&experiment, gains).windows(2) {
            let [now, next] = [pair[0], pair[1]];
            let expected = now.posture.advance(now.velocity, dt);
            let scale = 1.0 + now.velocity.linear.abs() * dt;
            // Where nothing is limited the heading turns by up to thousands of radians in a sample, and a number of
            // that size cannot hold the angle better than this.
            let turn = 1.0 + now.posture.theta.abs() + (now.velocity.angular * dt).abs();
            let tolerance = 1e-11 * turn;
            if next.outcome == Some(Outcome::Diverged) || tolerance > 1e-6 || scale > 1e3 {
                break;
            }
            assert_close(next.posture.x / scale, expected.x / scale, tolerance);
            assert_close(next.posture.y / scale, expected.y / scale, tolerance);
            assert_close(wrap(next.posture.theta - expected.theta), 0.0, tolerance);
            let error = next.posture.error_to(next.reference);
            assert_close(error.x / scale, next.error.x / scale, tolerance);
            assert_close(error.y / scale, next.error.y / scale, tolerance);
            assert_close(wrap(error.theta - next.error.theta), 0.0, tolerance);
            assert_close(next.error.cos, next.error.theta.cos(), 1e-10);
            assert_close(next.error.sin, next.error.theta.sin(), 1e-10);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_rigid_motion_of_the_plane_changes_nothing() {
    let mut random = Random::new(2);
    let mut compared = 0;
    for _ in 0..300 {
        let (experiment, gains) = gentle(&mut random);
        let by = random.posture(5.0);
        let moved = |p: Posture| Posture {
            x: by.x + by.theta.cos() * p.x - by.theta.sin() * p.y,
            y: by.y + by.theta.sin() * p.x + by.theta.cos() * p.y,
            theta: p.theta + by.theta,
        };
        let elsewhere = Experiment {
            starts: vec![moved(experiment.starts[0])],
            goal: moved(experiment.goal),
            ..experiment.clone()
        };
        let (a, b) = (cost(&experiment, gains), cost(&elsewhere, gains));
        if a.time > 3.0 {
            continue; // it missed the goal and circles near it, where every bit of rounding counts
        }
        compared += 1;
        assert_close(a.total(), b.total(), 1e-9);
        assert_close(a.path, b.path, 1e-9);
        assert_close(a.energy, b.energy, 1e-9);
    }
    assert!(compared > 200, "{compared}");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_mirror_image_costs_the_same() {
    let mut random = Random::new(3);
    for _ in 0..300 {
        let (experiment, gains) = gentle(&mut random);
        let mirrored = |p: Posture| Posture { x: p.x, y: -p.y, theta: -p.theta };
        let mirror = Experiment {
            starts: vec![mirrored(experiment.starts[0])],
            goal: mirrored(experiment.goal),
            ..experiment.clone()
        };
        assert_close(cost(&experiment, gains).total(), cost(&mirror, gains).total(), 1e-9);
        let (a, b) = (run(&experiment, gains), run(&mirror, gains));
        assert_eq!(a.len(), b.len());
        for (a, b) in a.iter().zip(&b) {
            assert_close(a.posture.y, -b.posture.y, 1e-7);
            assert_close(a.velocity.angular, -b.velocity.angular, 1e-5);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_parts_are_the_integrals_of_the_trajectory() {
    let mut random = Random::new(4);
    for _ in 0..100 {
        let mut experiment = velocity_limits();
        experiment.starts = vec![random.posture(2.0)];
        experiment.weights.final_error = [2.0, 3.0, 5.0];
        experiment.weights.velocity = [0.5, 0.25];
        let gains = random.gains(-1.0, 8.0);
        let samples = run(&experiment, gains);
        let (last, driven) = samples.split_last().expect("a run has a sample");
        let half_dt = 0.5 * experiment.sample_time;
        let [rv, rw] = experiment.weights.velocity;
        let square = |x: f64| x * x;
        let path: f64 = driven
            .iter()
            .map(|s| square(s.error.x) + square(s.error.y) + square(s.error.theta))
            .sum();
        let energy: f64 = driven
            .iter()
            .map(|s| rv * square(s.velocity.linear) + rw * square(s.velocity.angular))
            .sum();
        let goal = experiment.goal;
        let final_error = 2.0 * square(last.posture.x - goal.x)
            + 3.0 * square(last.posture.y - goal.y)
            + 5.0 * square(wrap(last.posture.theta - goal.theta));
        let penalty: f64 =
            1000.0 * [gains.x, gains.y, gains.theta].iter().map(|k| (-k).max(0.0)).sum::<f64>();
        let parts = cost(&experiment, gains);
        assert_close(parts.time, last.time, 1e-14);
        assert_close(parts.path, half_dt * path, 1e-12);
        assert_close(parts.energy, half_dt * energy, 1e-12);
        assert_close(parts.final_error, final_error, 1e-9);
        assert_close(parts.penalty, penalty, 1e-14);
        let sum = parts.time + parts.final_error + parts.path + parts.energy + parts.penalty;
        assert_eq!(parts.total(), sum);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn gains_of_0_have_a_penalty_of_0_and_not_of_minus_0() {
    for k in [0.0, -0.0] {
        let parts = cost(&velocity_limits(), Gains::new(k, k, k));
        assert_eq!(parts.penalty.to_bits(), 0.0_f64.to_bits());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn several_starts_cost_the_mean_of_each() {
    let mut random = Random::new(6);
    let starts: Vec<Posture> = (0..7).map(|_| random.posture(2.0)).collect();
    let together = Experiment { starts: starts.clone(), ..velocity_limits() };
    let alone = starts.iter().map(|start| {
        cost(&Experiment { starts: vec![*start], ..velocity_limits() }, EP_GAINS).total()
    });
    assert_close(cost(&together, EP_GAINS).total(), alone.sum::<f64>() / 7.0, 1e-14);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_outcome_is_what_the_last_sample_shows() {
    let arrives = run(&velocity_limits(), EP_GAINS);
    let last = arrives.last().expect("a sample");
    assert_eq!(last.outcome, Some(Outcome::Arrived));
    assert!(last.error.x.hypot(last.error.y) <= 0.05 && last.error.theta.abs() <= 0.05);
    assert!(arrives.iter().rev().skip(1).all(|s| s.outcome.is_none()));

    let never = Experiment { horizon: 0.5, ..velocity_limits() };
    let last = *run(&never, EP_GAINS).last().expect("a sample");
    assert_eq!((last.outcome, last.time), (Some(Outcome::Horizon), 0.5));

    let there = Experiment { starts: vec![velocity_limits().goal], ..velocity_limits() };
    let samples = run(&there, EP_GAINS);
    assert_eq!((samples.len(), samples[0].time), (1, 0.0));
    assert_eq!(samples[0].outcome, Some(Outcome::Arrived));
    assert_eq!(cost(&there, EP_GAINS).total(), 0.0);

    let free = Experiment { limits: Limits::NONE, ..velocity_limits() };
    let diverged = cost(&free, Gains::new(1e200, 1e200, 1.0));
    assert_eq!(diverged.total(), f64::INFINITY);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_robot_that_has_to_be_slow_arrives_where_it_first_is_near_and_slow() {
    let mut experiment = Preset::AccelerationLimits.experiment();
    let anyhow = run(&experiment, EP_GAINS);
    experiment.tolerance.speed = Some(0.05);
    experiment.tolerance.turn_rate = Some(0.1);
    let slowly = run(&experiment, EP_GAINS);
    let passed = anyhow.len() - 1;
    assert!(slowly.len() > anyhow.len() && slowly[passed].time == anyhow[passed].time);
    assert!(slowly[passed - 1].velocity.linear.abs() > 0.05);
    for (n, sample) in slowly.iter().enumerate().skip(1) {
        let (error, before) = (sample.error, slowly[n - 1].velocity);
        let near = error.x.hypot(error.y) <= 0.05 && error.theta.abs() <= 0.05;
        let slow = before.linear.abs() <= 0.05 && before.angular.abs() <= 0.1;
        assert_eq!(near && slow, sample.outcome == Some(Outcome::Arrived), "sample {n}");
    }
    assert_eq!(slowly.last().expect("samples").time, cost(&experiment, EP_GAINS).time);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_that_is_not_there_is_refused() {
    let mut experiment = velocity_limits();
    experiment.starts = vec![experiment.goal; 3];
    let setting = valid(experiment);
    for start in [0.0, 2.0] {
        assert!(setting.start_indices().allows(start));
    }
    for start in [3.0, -1.0, 0.5, f64::NAN] {
        assert!(!setting.start_indices().allows(start), "{start}");
    }
    assert_eq!(setting.start_indices().expected().to_string(), "a whole number from 0 to 2");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_horizon_is_the_first_sample_that_reaches_it() {
    let mut random = Random::new(12);
    for _ in 0..10_000 {
        let mut experiment = velocity_limits();
        experiment.sample_time = random.within(1e-5, 1.0);
        experiment.horizon = experiment.sample_time * random.within(0.1, 500.0).ceil();
        let n = f64::from(experiment.samples());
        assert!(n * experiment.sample_time >= experiment.horizon);
        assert!((n - 1.0) * experiment.sample_time < experiment.horizon);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_run_that_does_not_arrive_takes_the_horizon_and_one_that_diverges_costs_infinitely() {
    let mut experiment = velocity_limits();
    // Between two samples.
    experiment.horizon = 0.105;
    let setting = valid(experiment.clone());
    let late = setting.episode(Gains::new(1.0, 1.0, 1.0), 0).finished();
    assert_eq!((late.outcome(), late.time()), (Some(Outcome::Horizon), 0.105));
    assert_eq!(late.cost().time, 0.105);

    experiment.limits = Limits::NONE;
    experiment.weights.final_error = [0.0; 3];
    experiment.goal = Posture { x: 2.0, y: 0.0, theta: 0.0 };
    let setting = valid(experiment);
    // So far away that the square is infinite, though the place is not.
    let lost = setting.episode(Gains::new(1e200, 0.0, 0.0), 0).finished();
    assert_eq!(lost.outcome(), Some(Outcome::Diverged));
    assert_eq!(lost.cost().final_error, f64::INFINITY);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_heading_points_the_robots_way_however_far_it_has_turned() {
    let mut experiment = Experiment { limits: Limits::NONE, ..velocity_limits() };
    experiment.horizon = 1.0;
    // Turns of some 10⁵ rad add up; of 10⁷ the full ones are forgotten at once.
    for turn in [1e5, 1e7] {
        let samples = run(&experiment, Gains::new(0.0, 0.0, 100.0 * turn));
        assert!(samples.len() > 90);
        assert_eq!(samples[1].posture.theta.abs() > PI, turn < 1e6);
        for Sample { posture, reference, error, .. } in samples {
            assert!(posture.theta.abs() <= 1e6, "{}", posture.theta);
            let turned = wrap(posture.theta - (reference.theta - error.theta));
            assert!(turned.abs() < 1e-6, "{turned} at {}", posture.theta);
        }
    }
}
