//! Laws of the control law, its stability and the limits.

mod common;

use common::{Random, assert_close};
use ep_locomotion::robot::{CommandTerms, ErrorPosture, Gains, Law, Limits, Velocity};
use ep_locomotion::theory::{Lyapunov, lyapunov_rate_bound, robust_gains};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn under_the_law_the_lyapunov_rate_is_the_sum_of_three_squares() {
    let mut random = Random::new(5);
    for _ in 0..10_000 {
        let e = random.error();
        let (k, r) = (random.gains(-10.0, 10.0), random.velocity(3.0));
        let q = Law::ShimKim.command(&e, &k, r);
        let rate = Law::ShimKim.promised_rate(&e, &k, r).expect("a promise");
        // The terms that cancel are as large as the velocity times the error.
        let scale = 1.0 + (q.linear.abs() + q.angular.abs()) * Lyapunov::PAPER.value(&e);
        assert_close(Lyapunov::PAPER.rate(&e, q, r) / scale, rate.total() / scale, 1e-14);
        let [x, y, theta] = [e.x * e.cos, e.y * e.y, e.sin].map(|x| x * x);
        assert_close(rate.x, -k.x * x, 1e-14);
        assert_close(rate.y, -k.y * y, 1e-14);
        assert_close(rate.theta, -k.theta * theta, 1e-14);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_terms_of_a_command_add_up_to_it_each_with_its_own_gain() {
    let mut random = Random::new(8);
    for _ in 0..10_000 {
        let e = random.error();
        let (k, r) = (random.gains(-10.0, 10.0), random.velocity(3.0));
        for law in [Law::ShimKim, Law::Kanayama] {
            for r in [r, Velocity::ZERO] {
                let CommandTerms { gains: [x, y, theta], reference } = law.terms(&e, &k, r);
                let (sum, q) = (x + y + theta + reference, law.command(&e, &k, r));
                let scale = [x, y, theta, reference]
                    .iter()
                    .fold(1.0, |most: f64, v| most.max(v.linear.abs()).max(v.angular.abs()));
                assert_close(sum.linear / scale, q.linear / scale, 1e-14);
                assert_close(sum.angular / scale, q.angular / scale, 1e-14);
            }
        }
        let terms = Law::ShimKim.terms(&e, &k, Velocity::ZERO);
        let cube = k.y * e.y.powi(3);
        let expected = [
            (k.x * e.x * e.cos, k.x * e.x * e.y * e.cos),
            (-cube / e.sin, cube * e.x * e.cos / (e.sin * e.sin)),
            (0.0, k.theta * e.sin),
        ];
        for (term, (linear, angular)) in terms.gains.iter().zip(expected) {
            assert_close(term.linear / (1.0 + linear.abs()), linear / (1.0 + linear.abs()), 1e-13);
            assert_close(
                term.angular / (1.0 + angular.abs()),
                angular / (1.0 + angular.abs()),
                1e-13,
            );
        }
        assert_eq!(terms.reference, Velocity::ZERO);
        let terms = Law::Kanayama.terms(&e, &k, r);
        assert_eq!(terms.reference, Velocity { linear: r.linear * e.cos, angular: r.angular });
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_lyapunov_rate_is_the_slope_of_the_lyapunov_function() {
    let mut random = Random::new(6);
    let h = 1e-5;
    for _ in 0..1_000 {
        let (robot, goal) = (random.posture(2.0), random.posture(2.0));
        let (q, r) = (random.velocity(2.0), random.velocity(2.0));
        let v_at = |t| Lyapunov::PAPER.value(&robot.advance(q, t).error_to(goal.advance(r, t)));
        let slope = (v_at(h) - v_at(-h)) / (2.0 * h);
        assert_close(slope, Lyapunov::PAPER.rate(&robot.error_to(goal), q, r), 1e-8);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn theorem_2_where_its_inequalities_hold_no_bounded_disturbance_lets_v_rise() {
    let mut random = Random::new(7);
    for _ in 0..10_000 {
        let e = random.error();
        let bound = Velocity { linear: random.within(0.0, 2.0), angular: random.within(0.0, 2.0) };
        let least = robust_gains(&e, bound);
        let over = |k: f64| k * 1.001 + 1e-9;
        let k = Gains::new(over(least.x), over(least.y), over(least.theta));
        let worst = lyapunov_rate_bound(&e, &k, bound);
        assert!(worst < 0.0, "{worst}");
        let delta = Velocity {
            linear: bound.linear * random.within(-1.0, 1.0),
            angular: bound.angular * random.within(-1.0, 1.0),
        };
        let r = random.velocity(1.0);
        let command = Law::ShimKim.command(&e, &k, r);
        let rate = Lyapunov::PAPER.rate(&e, command + delta, r);
        let scale =
            1.0 + (command.linear.abs() + command.angular.abs()) * Lyapunov::PAPER.value(&e);
        assert!(rate <= worst + 1e-13 * scale, "{rate} over the bound {worst}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn theorem_2_asks_for_infinite_gains_only_where_a_disturbance_meets_no_error() {
    let at_goal = ErrorPosture::new(0.0, 0.0, 0.0);
    let k = robust_gains(&at_goal, Velocity { linear: 0.1, angular: 0.1 });
    assert_eq!([k.x, k.theta], [f64::INFINITY; 2]);
    assert_eq!(robust_gains(&at_goal, Velocity::ZERO), Gains::new(0.0, 0.0, 0.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_law_is_guarded_where_it_divides_by_zero() {
    let k = Gains::new(1.0, 2.0, 3.0);
    let r = Velocity { linear: 1.0, angular: 0.0 };
    let straight = |sin| ErrorPosture { x: 1.0, y: 0.5, theta: 0.0, cos: 1.0, sin };
    let (plus, minus) = (
        Law::ShimKim.command(&straight(0.0), &k, Velocity::ZERO),
        Law::ShimKim.command(&straight(-0.0), &k, Velocity::ZERO),
    );
    assert_close(plus.linear, 1.0 - 2.0 * 0.125 / 1e-6, 1e-12);
    assert_close(minus.linear, 1.0 + 2.0 * 0.125 / 1e-6, 1e-12);
    let across = ErrorPosture { x: 1.0, y: 0.5, theta: 1.0, cos: -0.0, sin: 1.0 };
    let q = Law::ShimKim.command(&across, &k, r);
    assert_close(q.linear, -2.0 * 0.125 - 1e6, 1e-12);
    let on_line = ErrorPosture { x: 1.0, y: 0.0, theta: 0.0, cos: 1.0, sin: 0.0 };
    let q = Law::ShimKim.command(&on_line, &k, Velocity::ZERO);
    assert_eq!([q.linear, q.angular], [1.0, 0.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn kanayama_turns_only_with_a_moving_reference() {
    let mut random = Random::new(8);
    for _ in 0..1_000 {
        let (e, k) = (random.error(), random.gains(0.0, 10.0));
        let q = Law::Kanayama.command(&e, &k, Velocity::ZERO);
        assert_eq!(q.angular, 0.0);
        assert_close(q.linear, k.x * (e.cos * e.x - e.sin * e.y), 1e-14);
    }
    let e = ErrorPosture::new(0.5, -0.25, 0.4);
    let r = Velocity { linear: 0.7, angular: 0.2 };
    let q = Law::Kanayama.command(&e, &Gains::new(1.0, 2.0, 3.0), r);
    let (x, y) =
        (0.4f64.cos() * 0.5 + 0.4f64.sin() * 0.25, 0.4f64.sin() * 0.5 - 0.4f64.cos() * 0.25);
    assert_close(q.linear, 0.7 * 0.4f64.cos() + x, 1e-14);
    assert_close(q.angular, 0.2 + 0.7 * (2.0 * y + 3.0 * 0.4f64.sin()), 1e-14);
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_hold_and_applying_them_twice_changes_nothing() {
    let mut random = Random::new(9);
    let dt = 0.01;
    for _ in 0..10_000 {
        let [speed, turn_rate] = [random.within(0.1, 5.0), random.within(0.1, 5.0)];
        let [acceleration, turn_acceleration] =
            [random.within(0.1, 50.0), random.within(0.1, 50.0)];
        let limits = Limits {
            speed: Some(speed),
            turn_rate: Some(turn_rate),
            acceleration: Some(acceleration),
            turn_acceleration: Some(turn_acceleration),
        };
        let previous = Velocity {
            linear: random.within(-speed, speed),
            angular: random.within(-turn_rate, turn_rate),
        };
        let command = random.velocity(10.0);
        let q = limits.applied(command, previous, dt);
        assert_eq!(limits.applied(q, previous, dt), q);
        assert!(q.linear.abs() <= speed && q.angular.abs() <= turn_rate);
        assert!((q.linear - previous.linear).abs() <= acceleration * dt * (1.0 + 1e-12));
        assert!((q.angular - previous.angular).abs() <= turn_acceleration * dt * (1.0 + 1e-12));
        assert_eq!(Limits::NONE.applied(command, previous, dt), command);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_table() {
    let limits = Limits { speed: Some(2.0), acceleration: Some(5.0), ..Limits::NONE };
    let linear = |command, previous| {
        let velocity = |linear| Velocity { linear, angular: 9.0 };
        let q = limits.applied(velocity(command), velocity(previous), 0.1);
        assert_eq!(q.angular, 9.0);
        q.linear
    };
    // command, previous, applied: from rest, braking, clamped before the rate, huge, backwards
    for (command, previous, applied) in [
        (0.3, 0.0, 0.3),
        (1.0, 0.0, 0.5),
        (0.0, 2.0, 1.5),
        (9.0, 1.9, 2.0),
        (f64::INFINITY, 0.0, 0.5),
        (-9.0, 0.0, -0.5),
    ] {
        assert_eq!(linear(command, previous), applied, "{command} after {previous}");
    }
}
