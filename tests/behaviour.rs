//! What the laws, the limits and a disturbance make of a run.

mod common;

use common::{EP_GAINS, Random, assert_close, cost, run, velocity_limits};
use ep_locomotion::robot::{Disturbance, DisturbanceKind, Gains, Law, Limits, Posture, Velocity};
use ep_locomotion::run::{Experiment, Outcome, PAPER_RESULTS, Preset, Sample};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn the_first_limited_sample_respects_the_rest_at_the_start() {
    let samples = run(&Preset::AccelerationLimits.experiment(), Gains::new(30.0, 30.0, 30.0));
    assert_close(samples[0].velocity.linear, 0.05, 1e-14);
    assert_close(samples[0].velocity.angular, 0.05 * core::f64::consts::PI, 1e-14);
    for pair in samples.windows(2) {
        let change = (pair[1].velocity.linear - pair[0].velocity.linear).abs();
        assert!(change <= 0.05 + 1e-12);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn without_limits_and_with_ky_0_v_never_rises() {
    let mut random = Random::new(7);
    let mut experiment = Experiment { limits: Limits::NONE, ..velocity_limits() };
    experiment.sample_time = 1e-4;
    experiment.horizon = 1.0;
    for _ in 0..20 {
        experiment.starts = vec![random.posture(1.0)];
        let gains = Gains::new(random.within(1.0, 5.0), 0.0, random.within(1.0, 5.0));
        for pair in run(&experiment, gains).windows(2) {
            assert!(pair[1].lyapunov <= pair[0].lyapunov + 1e-9);
            assert!(pair[0].lyapunov_rate <= 1e-9);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn kanayama_cannot_park_but_tracks() {
    let mut experiment = Experiment { law: Law::Kanayama, ..velocity_limits() };
    experiment.limits = Limits::NONE;
    let parked = run(&experiment, Gains::new(1.0, 1.0, 1.0));
    assert!(parked.iter().all(|s| s.posture.theta == 0.0), "it never turns");
    let last = parked.last().expect("a sample");
    assert_eq!(last.outcome, Some(Outcome::Horizon));
    assert_close(last.posture.y, 0.0, 1e-12);

    experiment.reference_velocity = Velocity { linear: 0.5, angular: 0.2 };
    experiment.starts = vec![Posture { x: 1.6, y: 2.2, theta: 0.6 }];
    let tracked = run(&experiment, Gains::new(4.0, 16.0, 8.0));
    let last = tracked.last().expect("a sample");
    assert_eq!(last.time, experiment.horizon);
    assert!(last.error.x.hypot(last.error.y) < 1e-3 && last.error.theta.abs() < 1e-3);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_papers_law_tracks_a_moving_reference_too() {
    let mut experiment = velocity_limits();
    experiment.reference_velocity = Velocity { linear: 0.5, angular: 0.2 };
    experiment.starts = vec![Posture { x: 1.0, y: 1.5, theta: 0.3 }];
    let samples = run(&experiment, Gains::new(3.0, 5.0, 5.0));
    let last = samples.last().expect("a sample");
    assert_eq!(last.outcome, Some(Outcome::Horizon));
    assert!(last.lyapunov < 0.1 * samples[0].lyapunov);
    let travelled = experiment.goal.advance(experiment.reference_velocity, experiment.horizon);
    assert_eq!(last.reference, travelled);
}

#[wasm_bindgen_test(unsupported = test)]
fn disturbances_stay_in_their_bounds_and_follow_their_seed() {
    let disturbance = |kind, seed| Disturbance { kind, linear: 0.3, angular: 0.2, seed };
    let with = |disturbance| Experiment { disturbance, ..velocity_limits() };
    // What the robot did beyond what it applied, from its postures.
    let excess = |samples: &[Sample]| -> Vec<Velocity> {
        let between = samples.windows(2);
        between
            .map(|pair| {
                let [a, b] = [pair[0], pair[1]];
                let turn = b.posture.theta - a.posture.theta;
                let chord = (b.posture.x - a.posture.x).hypot(b.posture.y - a.posture.y);
                let direction = a.posture.theta + 0.5 * turn;
                let forwards = direction.cos() * (b.posture.x - a.posture.x)
                    + direction.sin() * (b.posture.y - a.posture.y);
                let speed = chord.copysign(forwards) / 0.01 / ((0.5 * turn).sin() / (0.5 * turn));
                Velocity {
                    linear: speed - a.velocity.linear,
                    angular: turn / 0.01 - a.velocity.angular,
                }
            })
            .collect()
    };
    let random = run(&with(disturbance(DisturbanceKind::Random, 1)), EP_GAINS);
    let deltas = excess(&random);
    assert!(deltas.iter().all(|d| d.linear.abs() <= 0.3 + 1e-9 && d.angular.abs() <= 0.2 + 1e-9));
    assert!(deltas.iter().any(|d| d.linear > 0.25) && deltas.iter().any(|d| d.linear < -0.25));
    assert_eq!(random, run(&with(disturbance(DisturbanceKind::Random, 1)), EP_GAINS));
    assert_ne!(random, run(&with(disturbance(DisturbanceKind::Random, 2)), EP_GAINS));
    let slip = excess(&run(&with(disturbance(DisturbanceKind::Slip, 0)), EP_GAINS));
    for delta in slip {
        assert_close(delta.linear, 0.3, 1e-9);
        assert_close(delta.angular, 0.2, 1e-9);
    }
    let none = with(disturbance(DisturbanceKind::None, 5));
    assert_eq!(run(&none, EP_GAINS), run(&velocity_limits(), EP_GAINS));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_papers_ordering_holds_here() {
    for preset in [Preset::VelocityLimits, Preset::AccelerationLimits] {
        let costs: Vec<f64> = PAPER_RESULTS
            .iter()
            .filter(|row| row.preset == preset)
            .map(|row| cost(&preset.experiment(), row.gains).total())
            .collect();
        assert!(costs[0] < costs[1], "{costs:?}");
    }
}
