//! Landscapes and runs of many seeds: each is what its runs are, and what cannot be is refused by name.

mod common;

use common::{GRID, assert_refused, valid, velocity_limits};
use ep_locomotion::robot::{Gains, Posture};
use ep_locomotion::schema::InvalidInput;
use ep_locomotion::study::{
    Axis, Circle, Evolution, Gain, Grid, Landscape, Range, robustness, seed_runs,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn circle(x: f64, radius: f64, count: u32) -> Result<Vec<Posture>, InvalidInput> {
    Circle { x, y: 0.0, radius, count, seed: 1 }.starts()
}

#[wasm_bindgen_test(unsupported = test)]
fn the_values_of_an_axis_begin_and_end_where_it_says() {
    let axis = |from, to, count, log| Axis { gain: Gain::X, from, to, count, log };
    let values = |axis: Axis| -> Vec<f64> { (0..axis.count).map(|i| axis.value(i)).collect() };
    assert_eq!(values(axis(1.0, 3.0, 5, false)), [1.0, 1.5, 2.0, 2.5, 3.0]);
    assert_eq!(values(axis(2.0, -2.0, 3, false)), [2.0, 0.0, -2.0]);
    assert_eq!(values(axis(5.0, 9.0, 1, false)), [5.0]);
    // What rounding would move: a constant axis, and the ends of a logarithmic one.
    for constant in
        [axis(0.1, 0.1, 50, false), axis(1000.0, 1000.0, 50, false), axis(10.0, 10.0, 7, true)]
    {
        assert!(values(constant).iter().all(|&value| value == constant.from), "{constant:?}");
    }
    assert_eq!(values(axis(0.1, 10.0, 2, true)), [0.1, 10.0]);
    assert_eq!(values(axis(10.0, 0.1, 1, true)), [10.0]);
    // Within ends so close that the logarithm cannot tell them apart.
    for (from, to) in [(1e6, 1e6 + 1e-9), (1e6 + 1e-9, 1e6)] {
        let between = f64::min(from, to)..=f64::max(from, to);
        assert!(values(axis(from, to, 5, true)).iter().all(|value| between.contains(value)));
    }
    for (value, expected) in
        values(axis(0.01, 100.0, 5, true)).iter().zip([0.01, 0.1, 1.0, 10.0, 100.0])
    {
        assert!((value / expected - 1.0).abs() < 1e-14);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_cell_of_a_landscape_is_the_cost_of_its_gains() {
    let setting = valid(velocity_limits());
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
    let setting = valid(velocity_limits());
    let good = Landscape {
        x: Axis { gain: Gain::X, from: 1.0, to: 9.0, count: 4, log: false },
        y: Axis { gain: Gain::Y, from: 1.0, to: 9.0, count: 4, log: false },
        gains: Gains::new(1.0, 1.0, 1.0),
    };
    for (change, rows, message) in [
        (
            (|l| l.x.from = f64::NAN) as fn(&mut Landscape),
            [0, 4],
            "landscape.x.from must be a finite number, but was NaN",
        ),
        (
            |l| (l.y.to, l.y.log) = (0.0, true),
            [0, 4],
            "landscape.y.to must be a number over 0 on a log axis, but was 0",
        ),
        (
            |l| l.x.count = 0,
            [0, 4],
            "landscape.x.count must be a whole number from 1 to 1024, but was 0",
        ),
        (
            |l| l.y.gain = Gain::X,
            [0, 4],
            "landscape.y.gain must be another gain than x.gain, but was kx on both",
        ),
        (
            |_| (),
            [3, 2],
            "landscape.rows must be [first, end] with 0 ≤ first ≤ end ≤ 4, but was [3, 2]",
        ),
        (
            |_| (),
            [0, 5],
            "landscape.rows must be [first, end] with 0 ≤ first ≤ end ≤ 4, but was [0, 5]",
        ),
    ] {
        let mut landscape = good;
        change(&mut landscape);
        assert_refused(landscape.costs(&setting, rows), message);
    }
    let mut long = velocity_limits();
    (long.horizon, long.starts) = (1000.0, vec![long.goal; 10]);
    let long = valid(long);
    assert_refused(
        long.evaluate(&[Gains::new(1.0, 1.0, 1.0); 401]),
        "the number of gain triples must be at most 400 with 10 starts and 100000 samples a run, \
         but was 401",
    );
    let wide = Landscape { x: Axis { count: 401, ..good.x }, ..good };
    assert_refused(
        wide.costs(&long, [1, 2]),
        "the number of cells must be at most 400 with 10 starts and 100000 samples a run, \
         but was 401",
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn the_run_of_a_seed_is_that_of_its_evolution_beside_random_search() {
    let experiment = velocity_limits();
    let runs = seed_runs(&valid(experiment.clone()), [3, 6], 12).expect("valid");
    assert_eq!(runs.len(), 3);
    for (seed, run) in (3..).zip(&runs) {
        let mut own = experiment.clone();
        own.evolution.seed = seed;
        let mut evolution = Evolution::new(valid(own));
        let mut best = vec![evolution.newest().best.cost];
        (0..12).for_each(|_| best.push(evolution.step().best.cost));
        assert_eq!(run.best.0, best);
        assert_eq!(run.champion, evolution.newest().best);
        assert_eq!((run.random.len(), run.random[0]), (13, best[0]));
        assert!(run.random.is_sorted_by(|a, b| a >= b), "random search keeps its best");
    }
    assert_ne!(runs[0].random, runs[1].random);
    assert_eq!(seed_runs(&valid(experiment.clone()), [4, 5], 12).expect("valid")[0], runs[1]);
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_surveys_are_refused_by_name() {
    let setting = valid(velocity_limits());
    let k = Gains::new(1.0, 1.0, 1.0);
    let of = |grid| robustness(&setting, k, &grid, [0, 1]);
    assert_refused(
        of(Grid { x: Range { to: 1e9, ..GRID.x }, ..GRID }),
        "grid.x.to must be a number from -1000 to 1000 m, but was 1000000000",
    );
    assert_refused(
        of(Grid { y: Range { from: f64::NAN, ..GRID.y }, ..GRID }),
        "grid.y.from must be a finite number, but was NaN",
    );
    assert_refused(
        of(Grid { headings: 0, ..GRID }),
        "grid.headings must be a whole number from 1 to 1024, but was 0",
    );
    assert_refused(
        robustness(&setting, k, &GRID, [3, 61]),
        "grid.part must be [first, end] with 0 ≤ first ≤ end ≤ 60, but was [3, 61]",
    );
    let large =
        Grid { x: Range { count: 1000, ..GRID.x }, y: Range { count: 1000, ..GRID.y }, ..GRID };
    // However many starts the experiment has.
    let mut several = setting.experiment().clone();
    several.starts = vec![Posture::default(); 7];
    let several = valid(several);
    assert_refused(
        robustness(&several, k, &large, [0, 400_001]),
        "the number of starts must be at most 400000 with 1 start and 1000 samples a run, \
         but was 400001",
    );
    assert_refused(
        seed_runs(&setting, [0, 1000], 200),
        "the number of drives of all seeds together must be at most 400000 with 1 start and 1000 samples a run, \
         but was 8040000",
    );
    assert_refused(
        circle(0.0, -1.0, 3),
        "circle.radius must be a number from 0 to 1000 m, but was -1",
    );
    assert_refused(
        circle(0.0, 1.0, 0),
        "circle.count must be a whole number from 1 to 10000, but was 0",
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn the_largest_surveys_are_allowed_and_no_larger() {
    assert_eq!(circle(-1000.0, 1000.0, 10_000).expect("valid").len(), 10_000);
    assert!(circle(-1000.1, 1000.0, 1).is_err() && circle(0.0, 1000.0, 10_001).is_err());

    // Of a run with 1000 samples, 400,000 are allowed; a robot at its goal needs none.
    let mut resting = velocity_limits();
    resting.starts = vec![resting.goal];
    let setting = valid(resting.clone());
    let gains = vec![Gains::new(1.0, 1.0, 1.0); 400_001];
    assert_eq!(setting.evaluate(&gains[1..]).expect("valid").len(), 400_000);
    assert!(setting.evaluate(&gains).is_err());
    resting.evolution.population = 2;
    assert_eq!(seed_runs(&valid(resting.clone()), [1, 1001], 99).expect("valid").len(), 1000);
    assert!(seed_runs(&valid(resting.clone()), [1, 1001], 100).is_err());

    let range = Range { from: -1000.0, to: 1000.0, count: 1024 };
    let grid = |count, headings| Grid { x: Range { count, ..range }, y: range, headings };
    let rows = |grid| robustness(&setting, gains[0], &grid, [5, 5]).map(|ends| ends.len());
    assert_eq!(rows(grid(1024, 1024)), Ok(0));
    assert!(rows(grid(1025, 1)).is_err() && rows(grid(1, 1025)).is_err());
}
