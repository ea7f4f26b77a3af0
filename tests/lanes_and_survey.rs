//! Many runs in one call cost what each costs alone, to the bit.

mod common;

use common::{Random, wild};
use ep_locomotion::control::Gains;
use ep_locomotion::cost::Cost;
use ep_locomotion::episode::Setting;
use ep_locomotion::experiment::{Experiment, Preset};
use ep_locomotion::survey::{Axis, Gain, Landscape, evaluate};
use wasm_bindgen_test::wasm_bindgen_test;

fn bits(cost: &Cost) -> [u64; 6] {
    [cost.total(), cost.time, cost.final_error, cost.path, cost.energy, cost.penalty]
        .map(f64::to_bits)
}

/// Each run by itself, sample by sample, without lanes.
fn one_by_one(setting: &Setting, gains: &[Gains]) -> Vec<[u64; 6]> {
    let starts = setting.experiment().starts.len() as u32;
    let cost = |k: &Gains| {
        Cost::mean((0..starts).map(|start| setting.episode(*k, start).finished().cost()))
    };
    gains.iter().map(|k| bits(&cost(k))).collect()
}

fn assert_same(experiment: Experiment, gains: &[Gains]) {
    let setting = Setting::new(experiment).expect("valid");
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
    let mut experiment = Preset::VelocityLimits.experiment();
    experiment.starts = vec![experiment.goal, experiment.starts[0], experiment.goal];
    assert_same(experiment, &[Gains::new(3.0, 0.1, 5.0); 20]);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_values_of_an_axis_begin_and_end_where_it_says() {
    let axis = |from, to, count, log| Axis { gain: Gain::X, from, to, count, log };
    let values = |axis: Axis| -> Vec<f64> { (0..axis.count).map(|i| axis.value(i)).collect() };
    assert_eq!(values(axis(1.0, 3.0, 5, false)), [1.0, 1.5, 2.0, 2.5, 3.0]);
    assert_eq!(values(axis(2.0, -2.0, 3, false)), [2.0, 0.0, -2.0]);
    assert_eq!(values(axis(5.0, 9.0, 1, false)), [5.0]);
    for (value, expected) in
        values(axis(0.01, 100.0, 5, true)).iter().zip([0.01, 0.1, 1.0, 10.0, 100.0])
    {
        assert!((value / expected - 1.0).abs() < 1e-14);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_cell_of_a_landscape_is_the_cost_of_its_gains() {
    let setting = Setting::new(Preset::VelocityLimits.experiment()).expect("valid");
    let landscape = Landscape {
        x: Axis { gain: Gain::Y, from: 0.0, to: 1.0, count: 3, log: false },
        y: Axis { gain: Gain::Theta, from: 1.0, to: 9.0, count: 5, log: true },
        gains: Gains::new(3.5, 77.0, 77.0),
    };
    let costs = landscape.costs(&setting, [0, 5]).expect("valid");
    let expected: Vec<f64> = (0..5)
        .flat_map(|row| (0..3).map(move |column| (row, column)))
        .map(|(row, column)| {
            let k = Gains::new(3.5, landscape.x.value(column), landscape.y.value(row));
            setting.cost(&k).total()
        })
        .collect();
    assert_eq!(costs, expected);
    let rows = [[0, 2], [2, 2], [2, 5]].map(|rows| landscape.costs(&setting, rows).expect("valid"));
    assert_eq!(rows.concat(), costs);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_wrong_landscape_is_refused_by_name() {
    let setting = Setting::new(Preset::VelocityLimits.experiment()).expect("valid");
    let good = Landscape {
        x: Axis { gain: Gain::X, from: 1.0, to: 9.0, count: 4, log: false },
        y: Axis { gain: Gain::Y, from: 1.0, to: 9.0, count: 4, log: false },
        gains: Gains::new(1.0, 1.0, 1.0),
    };
    let refused = |change: fn(&mut Landscape), rows| {
        let mut landscape = good;
        change(&mut landscape);
        landscape.costs(&setting, rows).expect_err("refused").to_string()
    };
    for (change, rows, message) in [
        (
            (|l| l.x.from = f64::NAN) as fn(&mut Landscape),
            [0, 4],
            "x.from must be a finite number, but was NaN",
        ),
        (
            |l| (l.y.to, l.y.log) = (0.0, true),
            [0, 4],
            "y.to must be a number over 0 on a log axis, but was 0",
        ),
        (|l| l.x.count = 0, [0, 4], "x.count must be a whole number from 1 to 1024, but was 0"),
        (
            |l| l.y.gain = Gain::X,
            [0, 4],
            "y.gain must be another gain than x.gain, but was x on both",
        ),
        (|_| (), [3, 2], "rows must be [first, end] with 0 ≤ first ≤ end ≤ 4, but was [3, 2]"),
        (|_| (), [0, 5], "rows must be [first, end] with 0 ≤ first ≤ end ≤ 4, but was [0, 5]"),
    ] {
        assert_eq!(refused(change, rows), message);
    }
    let mut long = Preset::VelocityLimits.experiment();
    (long.horizon, long.starts) = (1000.0, vec![long.goal; 10]);
    let long = Setting::new(long).expect("valid");
    assert_eq!(
        evaluate(&long, &[Gains::new(1.0, 1.0, 1.0); 401]).expect_err("refused").to_string(),
        "the number of gain triples must be at most 400 with 10 starts and 100000 samples a run, \
         but was 401"
    );
}
