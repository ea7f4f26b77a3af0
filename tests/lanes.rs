//! Many runs in one call cost what each costs alone, to the bit.

mod common;
// Nobody outside of the core can name its lanes.
#[allow(dead_code)]
#[path = "../src/number/real.rs"]
mod real;
#[allow(dead_code)]
#[path = "../src/number/lanes.rs"]
mod side_by_side;

use core::hint::black_box; // the machine shall choose, not the compiler

use common::{Random, bits, valid, velocity_limits, wild};
use ep_locomotion::number::SMALL_TURN;
use ep_locomotion::robot::Gains;
use ep_locomotion::run::{Cost, Experiment, Preset, Setting};
use real::Real;
use side_by_side::Lanes;
use wasm_bindgen_test::wasm_bindgen_test;

/// Each run by itself, sample by sample, without lanes.
fn one_by_one(setting: &Setting, gains: &[Gains]) -> Vec<[u64; 6]> {
    let starts = setting.experiment().starts.len() as u32;
    let cost = |k: &Gains| {
        Cost::mean((0..starts).map(|start| setting.episode(*k, start).finished().cost()))
    };
    gains.iter().map(|k| bits(&cost(k))).collect()
}

fn assert_same(experiment: Experiment, gains: &[Gains]) {
    let setting = valid(experiment);
    let together: Vec<_> = setting.costs(gains).iter().map(bits).collect();
    assert_eq!(together, one_by_one(&setting, gains), "{:?}", setting.experiment());
}

#[wasm_bindgen_test(unsupported = test)]
fn lanes_give_the_bits_of_single_runs() {
    let mut random = Random::new(1);
    for round in 0..60 {
        let preset = [Preset::VelocityLimits, Preset::AccelerationLimits][round % 2];
        let mut experiment = preset.experiment();
        experiment.starts = (0..1 + round % 5).map(|_| random.posture(3.0)).collect();
        experiment.goal = random.posture(3.0);
        experiment.horizon = random.within(0.5, 6.0);
        // More runs than lanes, fewer, and none.
        let gains: Vec<_> = (0..round).map(|_| random.gains(-0.5, 12.0)).collect();
        assert_same(experiment, &gains);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn lanes_give_the_bits_of_single_runs_whatever_the_numbers() {
    let mut random = Random::new(2);
    for _ in 0..5_000 {
        let gains: Vec<_> = (0..5)
            .map(|_| Gains::new(random.hostile(), random.hostile(), random.hostile()))
            .collect();
        assert_same(wild(&mut random), &gains);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_robot_that_starts_at_the_goal_is_there() {
    let mut experiment = velocity_limits();
    experiment.starts = vec![experiment.goal, experiment.starts[0], experiment.goal];
    assert_same(experiment, &[Gains::new(3.0, 0.1, 5.0); 20]);
}

#[wasm_bindgen_test(unsupported = test)]
fn robots_that_turn_just_as_far_as_lanes_can_have_the_same_bits_too() {
    let mut experiment = velocity_limits();
    // A power of 2, so that the product is exact.
    experiment.sample_time = 0.0625;
    for turn in [SMALL_TURN.next_down(), SMALL_TURN, SMALL_TURN.next_up(), -SMALL_TURN] {
        experiment.limits.turn_rate = Some(turn.abs() / experiment.sample_time);
        experiment.goal.y = 2f64.copysign(turn);
        assert_same(experiment.clone(), &[Gains::new(3.0, 2.0, 50.0), Gains::new(1.0, 9.0, 9.0)]);
    }
}

/// Everything that a comparison may stumble over: both zeros, both infinities, NaN with either sign.
const NUMBERS: [f64; 10] =
    [0.0, -0.0, 1.5, -1.5, 5e-324, f64::MAX, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -f64::NAN];

#[wasm_bindgen_test(unsupported = test)]
fn the_smaller_and_the_larger_of_two_numbers_in_lanes_are_those_of_single_robots() {
    let bits = |value: f64| if value.is_nan() { None } else { Some(value.to_bits()) };
    for value in NUMBERS {
        for bound in NUMBERS {
            // The other lane has other numbers.
            let pair = |value, other| {
                let mut lanes = Lanes::splat(black_box(value));
                lanes.set(1, other);
                lanes
            };
            let (values, bounds) = (pair(value, bound), pair(bound, value));
            for (lanes, single) in [
                (values.at_most(bounds), f64::at_most as fn(f64, f64) -> f64),
                (values.at_least(bounds), f64::at_least),
            ] {
                let expected = [single(value, bound), single(bound, value)].map(bits);
                let found = [lanes.lane(0), lanes.lane(1)].map(bits);
                assert_eq!(found, expected, "{value} and {bound}");
            }
        }
    }
}
