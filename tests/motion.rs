//! Laws of numbers, of the motion and of the error posture.

mod common;

use common::{Random, assert_close};
use ep_locomotion::number::{Real, SMALL_TURN, wrap};
use ep_locomotion::robot::{Posture, Velocity};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn wrapped_angles_point_the_same_way() {
    use core::f64::consts::PI;
    let mut random = Random::new(1);
    for _ in 0..10_000 {
        let angle = random.within(-100.0, 100.0);
        let wrapped = wrap(angle);
        assert!(wrapped > -PI && wrapped <= PI);
        assert_close(wrapped.sin(), angle.sin(), 1e-13);
        assert_close(wrapped.cos(), angle.cos(), 1e-13);
    }
    for (angle, expected) in [(PI, PI), (-PI, PI), (0.5, 0.5), (-3.0, -3.0), (3.0 * PI, PI)] {
        assert_close(wrap(angle), expected, 1e-15);
    }
    // Rounding must not leave an angle outside, however near to the edge it is.
    for half_turns in (-1001..=1001).step_by(2) {
        let edge = f64::from(half_turns) * PI;
        let (mut below, mut above) = (edge, edge);
        for _ in 0..5 {
            for angle in [below, above] {
                let wrapped = wrap(angle);
                assert!(wrapped > -PI && wrapped <= PI, "{angle:e} as {wrapped:e}");
            }
            (below, above) = (below.next_down(), above.next_up());
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_within_a_bound_stays_as_it_is() {
    for (value, bound) in [(0.0, -0.0), (-0.0, 0.0), (f64::NAN, 1.0)] {
        assert_eq!(value.at_most(bound).to_bits(), value.to_bits());
        assert_eq!(value.at_least(bound).to_bits(), value.to_bits());
    }
    assert_eq!([2.0.at_most(1.0), 1.0.at_most(2.0)], [1.0, 1.0]);
    assert_eq!([2.0.at_least(1.0), 1.0.at_least(2.0)], [2.0, 2.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn two_half_steps_of_an_arc_are_one_whole_step() {
    let mut random = Random::new(2);
    for _ in 0..10_000 {
        let (start, q) = (random.posture(3.0), random.velocity(10.0));
        let dt = random.within(0.0, 2.0);
        let halves = start.advance(q, 0.5 * dt).advance(q, 0.5 * dt);
        let whole = start.advance(q, dt);
        assert_close(halves.x, whole.x, 1e-12);
        assert_close(halves.y, whole.y, 1e-12);
        assert_close(halves.theta, whole.theta, 1e-12);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_small_arc_is_as_exact_as_a_large_one() {
    let mut random = Random::new(11);
    for _ in 0..100_000 {
        let (turn, dt) = (random.within(-SMALL_TURN, SMALL_TURN), random.within(1e-3, 1.0));
        let (ahead, aside) = (turn / dt).along_arc(dt);
        // 1 − cos t = 2 sin² (t / 2)
        let half = libm::sin(0.5 * turn);
        assert_close(ahead / (dt * libm::sin(turn) / turn), 1.0, 6e-16);
        assert_close(aside / (dt * 2.0 * half * half / turn), 1.0, 1.5e-15);
    }
    for omega in [0.0, -0.0] {
        assert_eq!(omega.along_arc(0.5), (0.5, 0.0));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_full_circle_returns_and_no_turn_is_a_straight_line() {
    let q = Velocity { linear: 1.5, angular: 2.0 };
    let start = Posture { x: 1.0, y: -2.0, theta: 0.3 };
    let back = start.advance(q, core::f64::consts::PI);
    assert_close(back.x, start.x, 1e-14);
    assert_close(back.y, start.y, 1e-14);
    let straight = start.advance(Velocity { linear: 1.5, angular: 0.0 }, 2.0);
    assert_close(straight.x, 1.0 + 3.0 * 0.3f64.cos(), 1e-15);
    assert_close(straight.y, -2.0 + 3.0 * 0.3f64.sin(), 1e-15);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_error_posture_and_its_inverse_agree_and_ignore_the_frame() {
    let mut random = Random::new(3);
    for _ in 0..10_000 {
        let (robot, goal) = (random.posture(3.0), random.posture(3.0));
        let error = robot.error_to(goal);
        let back = error.posture(goal);
        assert_close(back.x, robot.x, 1e-14);
        assert_close(back.y, robot.y, 1e-14);
        assert_close(wrap(back.theta - robot.theta), 0.0, 1e-14);
        let (shift, turn) = ([random.within(-5.0, 5.0), 2.0], random.within(-3.0, 3.0));
        let moved = |p: Posture| Posture {
            x: shift[0] + turn.cos() * p.x - turn.sin() * p.y,
            y: shift[1] + turn.sin() * p.x + turn.cos() * p.y,
            theta: p.theta + turn,
        };
        let same = moved(robot).error_to(moved(goal));
        assert_close(same.x, error.x, 1e-13);
        assert_close(same.y, error.y, 1e-13);
        assert_close(same.theta, error.theta, 1e-13);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn lemma_1_gives_the_rate_of_the_error_posture() {
    let mut random = Random::new(4);
    let h = 1e-5;
    for _ in 0..10_000 {
        let (robot, goal) = (random.posture(3.0), random.posture(3.0));
        let (q, r) = (random.velocity(3.0), random.velocity(3.0));
        let error_at = |t| robot.advance(q, t).error_to(goal.advance(r, t));
        let (before, after) = (error_at(-h), error_at(h));
        if (after.theta - before.theta).abs() > 1.0 {
            continue; // θ_e passed from π to −π
        }
        let rate = robot.error_to(goal).rate(q, r);
        assert_close((after.x - before.x) / (2.0 * h), rate[0], 1e-8);
        assert_close((after.y - before.y) / (2.0 * h), rate[1], 1e-8);
        assert_close((after.theta - before.theta) / (2.0 * h), rate[2], 1e-8);
    }
}
