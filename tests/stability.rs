//! Laws of the Lyapunov functions along a run: what is promised adds up, what limits and disturbance change, and why.

mod common;

use common::{EP_GAINS, Random, assert_close, valid, velocity_limits, wild};
use ep_locomotion::robot::{
    Disturbance, DisturbanceKind, ErrorPosture, Gains, Law, Limits, Posture, Velocity,
};
use ep_locomotion::run::Experiment;
use ep_locomotion::study::{Stability, StabilitySample};
use ep_locomotion::theory::{Lyapunov, PromisedRate};
use wasm_bindgen_test::wasm_bindgen_test;

const LAWS: [Law; 2] = [Law::ShimKim, Law::Kanayama];

fn run(experiment: Experiment, k: &Gains) -> Vec<StabilitySample> {
    Stability::of(&valid(experiment), k, 0).samples
}

fn sum(sample: &StabilitySample) -> f64 {
    sample.promised.expect("a promise").total()
}

/// Random gains with which both laws have a Lyapunov function; kx and kθ of either sign.
fn gains(random: &mut Random) -> Gains {
    Gains { y: random.within(0.2, 10.0), ..random.gains(-10.0, 10.0) }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_promised_parts_add_up_to_the_rate_under_the_commanded_velocity() {
    let mut random = Random::new(31);
    for _ in 0..10_000 {
        let (e, k, r) = (random.error(), gains(&mut random), random.velocity(3.0));
        for law in LAWS {
            let q = law.command(&e, &k, r);
            let function = law.lyapunov(&k).expect("a function");
            let promised = law.promised_rate(&e, &k, r).expect("a promise").total();
            // The terms that cancel are as large as the velocity times the error.
            let scale = 1.0
                + (q.linear.abs() + q.angular.abs() * (1.0 + function.heading_weight))
                    * (1.0 + function.value(&e));
            assert_close(function.rate(&e, q, r) / scale, promised / scale, 1e-14);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn along_the_commanded_motion_v_changes_as_promised() {
    let mut random = Random::new(32);
    let h = 1e-6;
    for _ in 0..2_000 {
        let (goal, r) = (random.posture(2.0), random.velocity(1.0));
        let (e, k) = (random.error(), gains(&mut random));
        let robot = e.posture(goal);
        for law in LAWS {
            let q = law.command(&e, &k, r);
            let function = law.lyapunov(&k).expect("a function");
            let v_at = |t| function.value(&robot.advance(q, t).error_to(goal.advance(r, t)));
            // So that what is left out of the difference stays small.
            if q.linear.abs() + q.angular.abs() > 100.0 {
                continue;
            }
            let slope = (v_at(h) - v_at(-h)) / (2.0 * h);
            let promised = law.promised_rate(&e, &k, r).expect("a promise").total();
            assert!((slope - promised).abs() < 1e-5 * (1.0 + promised.abs()), "{slope} {promised}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn kanayamas_rule_promises_little_to_a_robot_that_parks() {
    let k = Gains::new(3.0, 2.0, 5.0);
    // The reference stands beside the robot, which heads elsewhere: nothing of this error is in V̇.
    let beside = Posture::default().error_to(Posture { x: 0.0, y: 1.5, theta: 0.7 });
    let rate = |r| Law::Kanayama.promised_rate(&beside, &k, r).expect("a promise");
    let PromisedRate { x, y, theta } = rate(Velocity::ZERO);
    assert!([x, y, theta].iter().all(|part| part.abs() < 1e-30));
    let moving = rate(Velocity { linear: 0.4, angular: 0.0 });
    assert_close(moving.theta, -0.4 * 5.0 / 2.0 * libm::sin(0.7) * libm::sin(0.7), 1e-14);
    for ky in [0.0, -0.0, -1.0] {
        let k = Gains { y: ky, ..k };
        assert_eq!(Law::Kanayama.lyapunov(&k), None);
        assert_eq!(Law::Kanayama.promised_rate(&beside, &k, Velocity::ZERO), None);
        assert_eq!(Law::ShimKim.lyapunov(&k), Some(Lyapunov::PAPER));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_gain_below_zero_makes_its_own_part_positive_and_no_other() {
    let mut random = Random::new(33);
    for _ in 0..1_000 {
        let (e, k) = (random.error(), random.gains(-5.0, 5.0));
        let rate = Law::ShimKim.promised_rate(&e, &k, Velocity::ZERO).expect("a promise");
        for (part, gain) in [(rate.x, k.x), (rate.y, k.y), (rate.theta, k.theta)] {
            assert_eq!(part > 0.0, gain < 0.0, "{part} with {gain}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_samples_are_those_of_the_episode() {
    let mut random = Random::new(34);
    for _ in 0..300 {
        let (experiment, k) = (wild(&mut random), random.gains(-10.0, 10.0));
        let setting = valid(experiment);
        let start = random.below(2);
        let episode: Vec<_> = setting.episode(k, start).samples().collect();
        let all = Stability::of(&setting, &k, start).samples;
        assert_eq!(all.len(), episode.len());
        let law = setting.experiment().law;
        for (own, sample) in all.iter().zip(&episode) {
            assert_eq!(own.time, sample.time);
            // Bits, because what is no number equals nothing.
            assert_eq!(own.error.x.to_bits(), sample.error.x.to_bits());
            assert_eq!(own.error.theta.to_bits(), sample.error.theta.to_bits());
            if law == Law::ShimKim {
                assert_eq!(own.lyapunov.to_bits(), sample.lyapunov.to_bits());
            }
        }
        // The last one is where the episode stops, and this goes on.
        let (_, before) = all.split_last().expect("a sample");
        for (own, sample) in before.iter().zip(&episode) {
            assert_eq!(own.limited, sample.command != sample.velocity);
            let calm = setting.experiment().disturbance.kind == DisturbanceKind::None;
            if calm && law == Law::ShimKim {
                assert_eq!(own.rate.to_bits(), sample.lyapunov_rate.to_bits());
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn without_limits_the_rate_is_what_is_promised() {
    for law in LAWS {
        let experiment = Experiment { law, limits: Limits::NONE, ..velocity_limits() };
        let samples = run(experiment, &EP_GAINS);
        assert!(samples.len() > 100);
        for sample in &samples {
            assert!(!sample.limited);
            // Terms as large as the command cancel.
            assert!((sample.rate - sum(sample)).abs() < 1e-9, "at {} s", sample.time);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn where_limits_cut_the_command_the_rate_leaves_the_promise_and_only_there() {
    let samples = run(velocity_limits(), &EP_GAINS);
    let (cut, free): (Vec<&StabilitySample>, Vec<&StabilitySample>) =
        samples.iter().partition(|sample| sample.limited);
    assert!(cut.len() > 50 && free.len() > 50, "{} of {}", cut.len(), samples.len());
    assert!(cut.iter().all(|sample| (sample.rate - sum(sample)).abs() > 1e-6));
    assert!(free.iter().all(|sample| (sample.rate - sum(sample)).abs() < 1e-9));
    // At the start the law asks for 6.5 m/s and gets 2.
    let first = &samples[0];
    assert_close(first.lyapunov, 4.0 + 1.0 - 0.5f64.sqrt(), 1e-14);
    assert_close(sum(first), -3.23673 * 4.0 - 5.17891 * 0.5, 1e-14);
    assert_close(first.rate, -4.0 - 5.17891 * 0.5, 1e-14);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_rate_is_the_slope_of_v_at_the_sample() {
    // So short a sample that V is nearly straight in it.
    let sample_time = 1e-5;
    let slip = Disturbance { kind: DisturbanceKind::Slip, linear: 0.2, angular: -0.3, seed: 0 };
    let tracking = Velocity { linear: 0.5, angular: 0.3 };
    for (law, disturbance, reference_velocity) in [
        (Law::ShimKim, Disturbance::NONE, Velocity::ZERO),
        (Law::ShimKim, slip, Velocity::ZERO),
        (Law::ShimKim, slip, tracking),
        (Law::Kanayama, Disturbance::NONE, tracking),
        (Law::Kanayama, slip, tracking),
    ] {
        let given = Experiment {
            law,
            disturbance,
            reference_velocity,
            sample_time,
            horizon: 0.1,
            ..velocity_limits()
        };
        for pair in run(given, &Gains::new(3.0, 2.0, 5.0)).windows(2) {
            let slope = (pair[1].lyapunov - pair[0].lyapunov) / sample_time;
            assert!((slope - pair[0].rate).abs() < 1e-3, "{law:?}: {slope}, {}", pair[0].rate);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_disturbance_adds_to_the_rate_what_theorem_2_says() {
    let (d1, d2) = (0.3, -0.2);
    let disturbance = Disturbance { kind: DisturbanceKind::Slip, linear: d1, angular: d2, seed: 0 };
    let experiment = Experiment { limits: Limits::NONE, disturbance, ..velocity_limits() };
    for sample in run(experiment, &EP_GAINS) {
        let ErrorPosture { x, y, cos, sin, .. } = sample.error;
        let added = (y * sin - x * cos) * d1 - sin * d2;
        assert!((sample.rate - sum(&sample) - added).abs() < 1e-9, "at {} s", sample.time);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_last_sample_is_taken_as_if_the_robot_drove_on() {
    let whole = run(velocity_limits(), &EP_GAINS);
    let tolerance =
        ep_locomotion::run::Tolerance { position: 0.0, heading: 0.0, speed: None, turn_rate: None };
    let longer = run(Experiment { tolerance, ..velocity_limits() }, &EP_GAINS);
    assert!(longer.len() > whole.len());
    assert_eq!(whole.last(), longer.get(whole.len() - 1));
}

#[wasm_bindgen_test(unsupported = test)]
fn where_nothing_is_promised_v_is_the_papers() {
    let k = Gains::new(1.0, -1.0, 1.0);
    let samples = run(Experiment { law: Law::Kanayama, ..velocity_limits() }, &k);
    for sample in samples {
        assert_eq!(sample.promised, None);
        assert_eq!(sample.lyapunov, Lyapunov::PAPER.value(&sample.error));
    }
}
