//! What must hold between runs, seeds and starts, though every run by itself would look right without it.

mod common;

use common::{Random, assert_close, evolved, records, searched_by, valid, velocity_limits};
use core::f64::consts::PI;
use ep_locomotion::number::SMALL_TURN;
use ep_locomotion::robot::{Disturbance, DisturbanceKind, Gains, Law, Posture, Velocity};
use ep_locomotion::run::Experiment;
use ep_locomotion::search::{EvolutionSettings, Method};
use ep_locomotion::study::{Evolution, SeedRun, fares, seed_runs};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{RngExt, SeedableRng};
use wasm_bindgen_test::wasm_bindgen_test;

/// The paper's first experiment with few robots.
fn small(population: u32, seed: u32) -> Experiment {
    searched_by(|e| (e.population, e.seed) = (population, seed))
}

/// Evolution and random search with the experiment's own seed.
fn searched(experiment: &Experiment, generations: u32) -> SeedRun {
    let seed = experiment.evolution.seed;
    seed_runs(&valid(experiment.clone()), [seed, seed + 1], generations).expect("valid").remove(0)
}

/// What random search tries in a generation: gains uniform in the initial range, from the stream of that generation.
fn tried(e: &EvolutionSettings, generation: u32) -> Vec<Gains> {
    let mut rng =
        Xoshiro256PlusPlus::seed_from_u64(u64::from(e.seed) | u64::from(generation) << 35);
    let [low, high] = e.initial_range;
    let mut gain = || low + (high - low) * rng.random::<f64>();
    (0..e.population).map(|_| Gains::new(gain(), gain(), gain())).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn random_search_tries_new_gains_in_every_generation_and_keeps_its_best() {
    let experiment = small(5, 3);
    let mut lowest = f64::INFINITY;
    let expected: Vec<f64> = (0..=40)
        .map(|generation| {
            let gains = tried(&experiment.evolution, generation);
            let costs = valid(experiment.clone()).evaluate(&gains).expect("valid");
            lowest = costs.into_iter().fold(lowest, f64::min);
            lowest
        })
        .collect();
    assert_eq!(searched(&experiment, 40).random.0, expected);
    let mut distinct = expected;
    distinct.dedup();
    assert!(distinct.len() > 3, "{distinct:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn random_search_knows_nothing_of_evolution() {
    let experiment = small(5, 3);
    let mut other = experiment.clone();
    other.evolution.initial_sigma = 0.1;
    other.evolution.opponents = 2;
    let [a, b] = [experiment, other].map(|experiment| searched(&experiment, 40));
    assert_ne!(a.best, b.best);
    assert_eq!(a.random, b.random);
    assert!(a.best[40] < a.random[40], "evolution has found what random search has not");
}

/// Robots that are given no command, at the same posture, in noise of 1 m/s and 1 rad/s.
fn drifting(starts: usize) -> Experiment {
    let mut experiment = velocity_limits();
    experiment.starts = vec![Posture::default(); starts];
    experiment.horizon = 0.05;
    experiment.disturbance =
        Disturbance { kind: DisturbanceKind::Random, linear: 1.0, angular: 1.0, seed: 7 };
    experiment
}

const AT_REST: Gains = Gains::new(0.0, 0.0, 0.0);

#[wasm_bindgen_test(unsupported = test)]
fn every_start_meets_noise_of_its_own() {
    let setting = valid(drifting(50));
    let mut paths: Vec<_> = fares(&setting, AT_REST).iter().map(|end| end.cost.path).collect();
    paths.sort_by(f64::total_cmp);
    paths.dedup();
    assert_eq!(paths.len(), 50);
}

/// (x, θ) after one sample: links made today must give the same noise tomorrow.
#[wasm_bindgen_test(unsupported = test)]
fn the_first_noise_of_every_start_is_known() {
    let setting = valid(drifting(3));
    let moved = [0, 1, 2].map(|start| {
        let mut episode = setting.episode(AT_REST, start);
        let posture = episode.samples().nth(1).expect("a second sample").posture;
        [posture.x, posture.theta]
    });
    let known = [
        [0.008670421623516278, -0.007354431341966061],
        [-0.002731777047061179, -0.0011375370853716604],
        [-0.0028337099051882753, -0.008941631311129294],
    ];
    assert_eq!(moved, known);
}

#[wasm_bindgen_test(unsupported = test)]
fn an_evaluation_is_one_run_of_one_solution_from_one_start() {
    for (population, starts) in [(4, 1), (4, 3), (7, 5)] {
        let mut experiment = small(population, 1);
        experiment.starts = vec![Posture::default(); starts];
        experiment.horizon = 0.1;
        let mut evolution = Evolution::new(valid(experiment));
        let each = f64::from(population) * starts as f64;
        assert_eq!(evolution.newest().evaluations, each);
        assert_eq!(evolution.step().evaluations, 2.0 * each);
        assert_eq!(evolution.step().evaluations, 3.0 * each);
    }
}

/// Lanes do not wrap a heading error; so nobody may come past ±π in them, though the robot turns one way and the
/// reference the other, each nearly as far in a sample as lanes allow.
#[wasm_bindgen_test(unsupported = test)]
fn a_robot_and_its_reference_may_turn_apart_as_fast_as_they_can() {
    let mut random = Random::new(1);
    for side in [1.0, -1.0] {
        let mut experiment = velocity_limits();
        let rate = side * 0.99 * SMALL_TURN / experiment.sample_time;
        experiment.law = Law::Kanayama;
        experiment.horizon = 0.64;
        experiment.limits.turn_rate = Some(0.0);
        experiment.reference_velocity = Velocity { linear: 0.0, angular: rate };
        experiment.disturbance =
            Disturbance { kind: DisturbanceKind::Slip, linear: 0.0, angular: -rate, seed: 1 };
        experiment.starts = (0..300)
            .map(|_| Posture { theta: random.within(-PI, PI), ..experiment.goal })
            .collect();
        let setting = valid(experiment.clone());
        let alone = (0..300).map(|start| setting.episode(AT_REST, start).finished().cost());
        let together = fares(&setting, AT_REST).into_iter().map(|end| end.cost);
        for (start, (together, alone)) in together.zip(alone).enumerate() {
            assert_eq!(together, alone, "{:?}", experiment.starts[start]);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn beside_each_method_random_search_has_as_many_drives_and_leaves_out_no_draw() {
    for &method in Method::ALL {
        let mut experiment = small(6, 7);
        (experiment.horizon, experiment.evolution.method) = (0.5, method);
        let run = searched(&experiment, 30);
        let evolution = evolved(experiment.clone(), 30);
        let draws: Vec<_> = (0..31).flat_map(|g| tried(&experiment.evolution, g)).collect();
        let costs = evolution.setting().evaluate(&draws).expect("few");
        let mut count = 0;
        for (generation, record) in records(&evolution).iter().enumerate() {
            count += record.tried().len();
            let lowest = costs[..count].iter().copied().fold(f64::INFINITY, f64::min);
            let best = evolution.statistics(generation as u32).expect("a generation").best.cost;
            let told = (run.random.get(generation), run.best.get(generation));
            assert_eq!(told, (Some(&lowest), Some(&best)), "{method:?}, generation {generation}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_told_of_a_generation_is_that_of_its_population() {
    let evolution = evolved(small(20, 4), 30);
    for generation in 0..=30 {
        let population = evolution.population(generation).expect("a generation");
        let mut costs: Vec<f64> = population.iter().map(|one| one.cost).collect();
        costs.sort_by(f64::total_cmp);
        let told = evolution.statistics(generation).expect("a generation");
        assert_eq!([told.median, told.worst], [0.5 * (costs[9] + costs[10]), costs[19]]);
        for (j, mean) in told.mean_sigmas.into_iter().enumerate() {
            let sum: f64 = population.iter().map(|one| one.sigmas[j]).sum();
            assert_close(mean, sum / 20.0, 1e-12);
        }
    }
}
