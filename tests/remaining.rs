//! Laws of the error that remains under a disturbance, and of the sets of Theorem 2.

mod common;

use common::{EP_GAINS, Random, assert_close, valid, velocity_limits};
use ep_locomotion::robot::{
    Disturbance, DisturbanceKind, ErrorPosture, Gains, Limits, Posture, Velocity,
};
use ep_locomotion::run::{Experiment, Tolerance};
use ep_locomotion::study::{RemainingError, error_parts, remaining_errors};
use ep_locomotion::theory::{ErrorSizes, lyapunov_rate_bound, robust_gains, theorem_2_sets};
use wasm_bindgen_test::wasm_bindgen_test;

/// The preset, in which nobody arrives.
fn unending(disturbance: Disturbance) -> Experiment {
    Experiment {
        disturbance,
        tolerance: Tolerance { position: 0.0, heading: 0.0, speed: None, turn_rate: None },
        ..velocity_limits()
    }
}

fn slip(linear: f64, angular: f64) -> Disturbance {
    Disturbance { kind: DisturbanceKind::Slip, linear, angular, seed: 0 }
}

#[track_caller]
fn remaining(experiment: Experiment, gains: &Gains, seconds: f64) -> Vec<RemainingError> {
    let setting = valid(experiment);
    remaining_errors(&setting, gains, seconds).expect("allowed seconds")
}

#[wasm_bindgen_test(unsupported = test)]
fn outside_all_three_sets_no_bounded_disturbance_lets_v_rise() {
    let mut random = Random::new(21);
    let mut outside = 0;
    for _ in 0..20_000 {
        let (e, k) = (random.error(), random.gains(0.1, 20.0));
        let bound = Velocity { linear: random.within(0.0, 1.0), angular: random.within(0.0, 1.0) };
        let (parts, sets) = (ErrorSizes::new(&e), theorem_2_sets(&k, bound, e.sin));
        if parts.x > sets.x && parts.y > sets.y && parts.theta > sets.theta {
            outside += 1;
            assert!(lyapunov_rate_bound(&e, &k, bound) < 0.0);
        }
    }
    assert!(outside > 5_000, "only {outside} were outside");
}

#[wasm_bindgen_test(unsupported = test)]
fn at_the_edge_of_a_set_the_gains_are_those_that_theorem_2_asks_for() {
    let mut random = Random::new(22);
    for _ in 0..10_000 {
        let k = random.gains(0.1, 20.0);
        let bound =
            Velocity { linear: random.within(0.01, 1.0), angular: random.within(0.01, 0.09) };
        let sets = theorem_2_sets(&k, bound, bound.angular / k.theta);
        let theta = sets.theta.asin();
        let edge = ErrorPosture::new(sets.x / theta.cos(), sets.y, theta);
        let least = robust_gains(&edge, bound);
        for (least, gain) in [(least.x, k.x), (least.y, k.y), (least.theta, k.theta)] {
            assert_close(least / gain, 1.0, 1e-9);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_sets_grow_with_the_disturbance_and_shrink_with_the_gains() {
    let mut random = Random::new(23);
    for _ in 0..1_000 {
        let (k, sin) = (random.gains(0.1, 20.0), random.within(-1.0, 1.0));
        let (bound, factor) = (random.velocity(1.0), random.within(0.1, 10.0));
        let sets = theorem_2_sets(&k, bound, sin);
        let pushed = Velocity { linear: factor * bound.linear, angular: factor * bound.angular };
        let pushed = theorem_2_sets(&k, pushed, sin);
        let firm = Gains::new(factor * k.x, factor * k.y, factor * k.theta);
        let firm = theorem_2_sets(&firm, bound, sin);
        for (pushed, firm, set, law) in [
            (pushed.x, firm.x, sets.x, factor),
            (pushed.y, firm.y, sets.y, factor.cbrt()),
            (pushed.theta, firm.theta, sets.theta, factor),
        ] {
            assert_close(pushed, law * set, 1e-13);
            assert_close(law * firm, set, 1e-13);
        }
    }
    assert_eq!(
        theorem_2_sets(&Gains::new(1.0, 1.0, 1.0), Velocity::ZERO, 0.5),
        ErrorSizes { x: 0.0, y: 0.0, theta: 0.0 }
    );
    let endless = theorem_2_sets(&Gains::new(0.0, -1.0, -0.0), Velocity::ZERO, 0.0);
    assert_eq!([endless.x, endless.y, endless.theta], [f64::INFINITY; 3]);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_bound_is_that_of_the_kind() {
    for (kind, expected) in [
        (DisturbanceKind::None, Velocity::ZERO),
        (DisturbanceKind::Random, Velocity { linear: 0.3, angular: 0.2 }),
        (DisturbanceKind::Slip, Velocity { linear: 0.3, angular: 0.2 }),
    ] {
        let disturbance = Disturbance { kind, linear: 0.3, angular: -0.2, seed: 1 };
        assert_eq!(disturbance.bound(), expected);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn without_a_disturbance_the_parts_go_to_zero() {
    for gains in [Gains::new(10.0, 10.0, 10.0), Gains::new(3.0, 5.0, 8.0)] {
        let [one] = remaining(unending(Disturbance::NONE), &gains, 1.0)[..] else {
            panic!("one start")
        };
        assert_eq!(one.sets, ErrorSizes { x: 0.0, y: 0.0, theta: 0.0 });
        assert!(one.error.x < 0.01 && one.error.y < 0.01 && one.error.theta < 0.02, "{one:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_slip_holds_the_robot_at_the_edge_of_the_set_of_x() {
    let gains = EP_GAINS;
    for linear in [-0.3, -0.1, 0.1] {
        let [one] = remaining(unending(slip(linear, 0.0)), &gains, 2.0)[..] else {
            panic!("one start")
        };
        assert_close(one.sets.x, linear.abs() / gains.x, 1e-14);
        assert!((one.error.x / one.sets.x - 1.0).abs() < 0.01, "{one:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_remains_is_the_largest_of_the_last_samples_from_each_start() {
    let mut random = Random::new(24);
    for _ in 0..20 {
        let disturbance = Disturbance {
            kind: DisturbanceKind::Random,
            linear: random.within(0.0, 0.5),
            angular: random.within(0.0, 1.0),
            seed: random.below(1000),
        };
        let starts: Vec<Posture> = (0..5).map(|_| random.posture(3.0)).collect();
        let experiment = Experiment { starts, horizon: 3.0, ..unending(disturbance) };
        let (gains, seconds) = (random.gains(0.5, 10.0), 0.5);
        let setting = valid(experiment.clone());
        let all = remaining_errors(&setting, &gains, seconds).expect("allowed seconds");
        assert_eq!(all.len(), 5);
        for (start, one) in (0..).zip(all) {
            let run = error_parts(&setting, &gains, start);
            assert_eq!(run.len(), 301);
            let last = &run[250..];
            for sample in last {
                assert!(sample.error.x <= one.error.x && sample.error.y <= one.error.y);
                assert!(sample.error.theta <= one.error.theta && sample.sets.y <= one.sets.y);
            }
            assert!(last.iter().any(|sample| sample.error.y == one.error.y));
            assert!(last.iter().any(|sample| sample.error.theta == one.error.theta));
            assert!(last.iter().any(|sample| sample.sets.y == one.sets.y));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_robot_that_leaves_the_finite_numbers_has_an_infinite_error() {
    let experiment = Experiment { limits: Limits::NONE, ..unending(Disturbance::NONE) };
    let [one] = remaining(experiment, &Gains::new(-1e300, 1e300, 1e300), 1.0)[..] else {
        panic!("one start")
    };
    assert_eq!([one.error.x, one.error.y, one.error.theta], [f64::INFINITY; 3]);
}

#[wasm_bindgen_test(unsupported = test)]
fn seconds_beyond_the_run_are_refused_by_name() {
    let setting = valid(unending(slip(0.1, 0.1)));
    for seconds in [-0.1, 10.1, f64::NAN, f64::INFINITY] {
        let error = remaining_errors(&setting, &Gains::new(1.0, 1.0, 1.0), seconds);
        let message = error.expect_err("refused").to_string();
        let expected = "seconds must be a number from 0 to the horizon of 10 s, but was ";
        assert!(message.starts_with(expected), "{message}");
    }
    for seconds in [0.0, 10.0] {
        assert!(remaining_errors(&setting, &Gains::new(1.0, 1.0, 1.0), seconds).is_ok());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn along_a_run_the_reach_of_7_is_that_of_the_heading() {
    let setting = valid(unending(slip(0.1, 0.2)));
    let gains = Gains::new(3.0, 2.0, 5.0);
    let parts = error_parts(&setting, &gains, 0);
    let samples: Vec<_> = setting.episode(gains, 0).samples().collect();
    assert_eq!(parts.len(), samples.len());
    for (part, sample) in parts.iter().zip(&samples) {
        assert_eq!(part.error, ErrorSizes::new(&sample.error));
        assert_close(part.sets.y.powi(3) * gains.y, 0.1 * sample.error.sin.abs(), 1e-9);
    }
}
