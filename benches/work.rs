//! What is measured, the same natively and as WebAssembly. `episode.js` does the first two in plain JavaScript.

use ep_locomotion::robot::Gains;
use ep_locomotion::run::{Cost, Experiment, Preset, Setting};
use ep_locomotion::study::{Axis, Evolution, Gain, Landscape, seed_runs};

/// The case of this number: 0 with runs of 200 samples each, 1 with a landscape whose runs end at different times.
fn experiment(case: u32) -> Experiment {
    let mut experiment = Preset::VelocityLimits.experiment();
    if case == 0 {
        experiment.tolerance.position = 0.0;
        experiment.horizon = 2.0;
    }
    experiment
}

/// Gains on a square of side √robots: kx and kθ from 0.5 to 10, ky 0.1.
fn gains(robots: u32) -> Vec<Gains> {
    let side = f64::from(robots).sqrt().ceil() as u32;
    let value = |i: u32| 0.5 + 9.5 * f64::from(i) / f64::from(side.max(2) - 1);
    (0..robots).map(|i| Gains::new(value(i % side), 0.1, value(i / side))).collect()
}

fn setting(case: u32) -> Setting {
    Setting::new(experiment(case)).expect("valid")
}

/// Sum of J over all robots, driven in lanes.
pub fn lanes(case: u32, robots: u32) -> f64 {
    setting(case).costs(&gains(robots)).iter().map(Cost::total).sum()
}

/// Sum of J over all robots, driven one after the other.
pub fn scalar(case: u32, robots: u32) -> f64 {
    let setting = setting(case);
    gains(robots).into_iter().map(|k| setting.episode(k, 0).finished().cost().total()).sum()
}

/// Samples driven in all.
pub fn samples(case: u32, robots: u32) -> f64 {
    let setting = setting(case);
    let dt = setting.experiment().sample_time;
    setting.costs(&gains(robots)).iter().map(|cost| (cost.time / dt).round()).sum()
}

/// The best J of a whole run of evolution.
pub fn evolution(population: u32, generations: u32, horizon: f64) -> f64 {
    let mut experiment = Experiment { horizon, ..Preset::VelocityLimits.experiment() };
    experiment.evolution.population = population;
    let mut evolution = Evolution::new(Setting::new(experiment).expect("valid"));
    for _ in 0..generations {
        evolution.step();
    }
    evolution.newest().best.cost
}

/// Sum of J over a landscape of `count` × `count` cells.
pub fn landscape(count: u32) -> f64 {
    let axis = |gain| Axis { gain, from: 0.5, to: 10.0, count, log: false };
    let landscape =
        Landscape { x: axis(Gain::X), y: axis(Gain::Theta), gains: Gains::new(0.0, 0.1, 0.0) };
    landscape.costs(&setting(1), [0, count]).expect("valid").iter().sum()
}

/// The best J of a hundred seeds, each evolved for 200 generations beside random search, in four parts.
pub fn seeds() -> f64 {
    let setting = setting(1);
    let part = |first| seed_runs(&setting, [first, first + 25], 200).expect("valid");
    let runs = [0, 25, 50, 75].into_iter().flat_map(part);
    runs.map(|run| run.champion.cost).fold(f64::INFINITY, f64::min)
}
