//! Known values: those of the model's description, and this program's own, which must be the same on every machine.
//! All of them stand in `golden.json`, which the page checks too, in the visitor's browser.

mod common;
#[allow(dead_code)] // its `main`
#[path = "../examples/paper.rs"]
mod paper;

use common::json::Given;
use common::{assert_close, evolved, searched_by, valid, velocity_limits};
use ep_locomotion::robot::{Disturbance, DisturbanceKind, ErrorPosture, Gains, Law, Velocity};
use ep_locomotion::run::{Experiment, Preset};
use serde::Deserialize;
use serde_json::Value;
use wasm_bindgen_test::wasm_bindgen_test;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Golden {
    commands: Rows<KnownCommand>,
    runs: Rows<KnownRun>,
    draws: KnownDraws,
    evolutions: Vec<KnownEvolution>,
    optimum: KnownOptimum,
}

/// What an independent implementation found, and how near ours must come, relatively.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Rows<T> {
    tolerance: f64,
    rows: Vec<T>,
}

/// The law (5): the command (v, ω) at the error posture (x_e, y_e, θ_e) with q_r = (v_r, ω_r).
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct KnownCommand {
    error: [f64; 3],
    gains: [f64; 3],
    reference: [f64; 2],
    command: [f64; 2],
}

/// A run: t_f, J, and where it is known the last posture.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
struct KnownRun {
    preset: String,
    gains: [f64; 3],
    final_time: f64,
    cost: f64,
    end: Option<[f64; 3]>,
}

/// The first draws with a seed: parent 0 of generation 0, its mutation and its opponents in generation 1, and (x, θ)
/// after one sample of a robot at rest in noise of 1 m/s and 1 rad/s.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct KnownDraws {
    seed: u32,
    parent: [f64; 3],
    gains: [f64; 3],
    common: f64,
    sigmas: [f64; 3],
    opponents: Vec<u32>,
    noise: [f64; 2],
}

/// `Evolution::hash` after some generations of a preset with some fields changed.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct KnownEvolution {
    /// What is special about it.
    task: String,
    preset: String,
    changes: Value,
    generations: u32,
    hash: String,
}

/// Between which J the best of a run must come to lie: an independent optimiser finds 7.70 and nothing better.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct KnownOptimum {
    seed: u32,
    generations: u32,
    cost: [f64; 2],
}

fn golden() -> Golden {
    serde_json::from_str(include_str!("golden.json")).expect("the list of known values")
}

impl KnownEvolution {
    fn experiment(&self) -> Experiment {
        let mut experiment = Preset::find(&self.preset).expect("a preset").experiment();
        experiment.read(&Given(Some(&self.changes))).expect("an experiment");
        experiment
    }
}

#[track_caller]
fn assert_relative(value: f64, expected: f64, tolerance: f64) {
    assert!((value / expected - 1.0).abs() <= tolerance, "{value} instead of {expected}");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_law_at_two_postures() {
    let Rows { tolerance, rows } = golden().commands;
    assert_eq!(rows.len(), 2);
    for KnownCommand { error, gains: k, reference: [linear, angular], command } in rows {
        let q = Law::ShimKim.command(
            &ErrorPosture::new(error[0], error[1], error[2]),
            &Gains::new(k[0], k[1], k[2]),
            Velocity { linear, angular },
        );
        assert_relative(q.linear, command[0], tolerance);
        assert_relative(q.angular, command[1], tolerance);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn three_runs_of_the_papers_gains() {
    let Rows { tolerance, rows } = golden().runs;
    assert_eq!(rows.len(), 3);
    for KnownRun { preset, gains: k, final_time, cost, end } in rows {
        let setting = valid(Preset::find(&preset).expect("a preset").experiment());
        let mut episode = setting.episode(Gains::new(k[0], k[1], k[2]), 0);
        let last = episode.samples().last().expect("a sample").posture;
        assert_relative(episode.cost().total(), cost, tolerance);
        assert_relative(episode.time(), final_time, 1e-9);
        for (value, expected) in [last.x, last.y, last.theta].into_iter().zip(end.iter().flatten())
        {
            assert_relative(value, *expected, tolerance);
        }
    }
}

/// What `cargo run --release --example paper` prints, with one seed.
#[wasm_bindgen_test(unsupported = test)]
fn the_example_prints_the_papers_results_beside_ours() {
    let mut told = Vec::new();
    paper::write(&mut told, 1).expect("text");
    let told = String::from_utf8(told).expect("text");
    for KnownRun { final_time, cost, .. } in golden().runs.rows {
        assert!(told.contains(&format!("│{cost:9.4} ={final_time:6.2} +")), "{cost}\n{told}");
    }
    assert_eq!(told.matches("the same order as in the paper").count(), 2, "{told}");
}

/// Three seeds of both presets, and seldom used paths: noise, tracking from several starts, no limits with large turns.
#[wasm_bindgen_test(unsupported = test)]
fn whole_runs_have_the_same_bits_everywhere() {
    let known = golden().evolutions;
    assert_eq!(known.len(), 9);
    for one in known {
        let hash = evolved(one.experiment(), one.generations).hash();
        assert_eq!(hash, one.hash, "{} with {}", one.task, one.changes);
    }
}

/// The streams of random numbers must never change: links made today must give the same run tomorrow.
#[wasm_bindgen_test(unsupported = test)]
fn value_stability_of_the_random_streams() {
    let known = golden().draws;
    let evolution = evolved(searched_by(|e| e.seed = known.seed), 1);
    let [first, second] = [0, 1].map(|number| evolution.record(number).expect("a generation"));
    let draws = second.making.mutations[0];
    assert_eq!(first.parents[0].gains.to_array(), known.parent);
    assert_eq!(draws.gains, known.gains);
    assert_eq!(draws.common, known.common);
    assert_eq!(draws.sigmas, known.sigmas);
    assert_eq!(second.tournament.opponents[0], known.opponents);

    let mut noisy = velocity_limits();
    noisy.disturbance =
        Disturbance { kind: DisturbanceKind::Random, linear: 1.0, angular: 1.0, seed: known.seed };
    let setting = valid(noisy);
    let mut episode = setting.episode(Gains::new(0.0, 0.0, 0.0), 0);
    let posture = episode.samples().nth(1).expect("a second sample").posture;
    assert_eq!([posture.x, posture.theta], known.noise);
}

#[wasm_bindgen_test(unsupported = test)]
fn evolution_comes_near_the_optimum_of_the_model() {
    let KnownOptimum { seed, generations, cost: [low, high] } = golden().optimum;
    let best = evolved(searched_by(|e| e.seed = seed), generations).newest().best;
    assert!(low <= best.cost && best.cost <= high, "{}", best.cost);
    assert_close(best.gains.y, 0.0, 0.05);
}
