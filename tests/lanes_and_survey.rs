//! Many runs in one call cost what each costs alone, to the bit.

mod common;

use common::{Random, assert_close, wild};
use ep_locomotion::number::SMALL_TURN;
use ep_locomotion::robot::{Disturbance, DisturbanceKind, Gains, Posture};
use ep_locomotion::run::{Cost, Experiment, Outcome, Preset, Setting};
use ep_locomotion::study::{
    Axis, Evolution, Gain, Landscape, Range, StartGrid, fares, on_circle, robustness, seed_runs,
};
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
fn robots_that_turn_just_as_far_as_lanes_can_have_the_same_bits_too() {
    let mut experiment = Preset::VelocityLimits.experiment();
    // A power of 2, so that the product is exact.
    experiment.sample_time = 0.0625;
    for turn in [SMALL_TURN.next_down(), SMALL_TURN, SMALL_TURN.next_up(), -SMALL_TURN] {
        experiment.limits.turn_rate = Some(turn.abs() / experiment.sample_time);
        experiment.goal.y = 2f64.copysign(turn);
        assert_same(experiment.clone(), &[Gains::new(3.0, 2.0, 50.0), Gains::new(1.0, 9.0, 9.0)]);
    }
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
        long.evaluate(&[Gains::new(1.0, 1.0, 1.0); 401]).expect_err("refused").to_string(),
        "the number of gain triples must be at most 400 with 10 starts and 100000 samples a run, \
         but was 401"
    );
    let wide = Landscape { x: Axis { count: 401, ..good.x }, ..good };
    assert_eq!(
        wide.costs(&long, [1, 2]).expect_err("refused").to_string(),
        "the number of cells must be at most 400 with 10 starts and 100000 samples a run, \
         but was 401"
    );
}

const GRID: StartGrid = StartGrid {
    x: Range { from: -1.0, to: 3.0, count: 5 },
    y: Range { from: 0.0, to: 4.0, count: 3 },
    headings: 4,
};

#[wasm_bindgen_test(unsupported = test)]
fn a_grid_of_starts_goes_through_headings_then_x_then_y() {
    assert_eq!(GRID.count(), 60);
    let quarter = core::f64::consts::FRAC_PI_2;
    for (index, x, y, theta) in [
        (0, -1.0, 0.0, 0.0),
        (1, -1.0, 0.0, quarter),
        (2, -1.0, 0.0, 2.0 * quarter),
        (3, -1.0, 0.0, -quarter),
        (4, 0.0, 0.0, 0.0),
        (20, -1.0, 2.0, 0.0),
        (59, 3.0, 4.0, -quarter),
    ] {
        assert_eq!(GRID.posture(index as u32), Posture { x, y, theta }, "{index}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_starts_of_a_grid_are_its_postures_in_any_parts() {
    let part = |part| GRID.postures(part).map_err(|error| error.to_string());
    let all: Vec<Posture> = (0..60).map(|index| GRID.posture(index)).collect();
    assert_eq!(part([0, 60]).as_deref(), Ok(all.as_slice()));
    assert_eq!(part([20, 22]).as_deref(), Ok(&all[20..22]));
    assert_eq!(part([60, 60]).as_deref(), Ok(&[][..]));
    let expected = "part must be [first, end] with 0 ≤ first ≤ end ≤ 60, but was [0, 61]";
    assert_eq!(part([0, 61]), Err(expected.into()));
    let large = StartGrid { headings: 1024, ..GRID };
    assert_eq!(large.postures([100, 10_100]).map(|starts| starts.len()), Ok(10_000));
    let refused = large.postures([100, 10_101]).expect_err("too many").to_string();
    assert_eq!(refused, "part must be at most 10000 starts in one call, but was 10001");
    let empty = StartGrid { headings: 0, ..GRID };
    let refused = empty.postures([0, 0]).expect_err("no heading").to_string();
    assert_eq!(refused, "headings must be a whole number from 1 to 1024, but was 0");
}

#[wasm_bindgen_test(unsupported = test)]
fn robustness_is_each_run_by_itself_in_any_parts() {
    let setting = Setting::new(Preset::VelocityLimits.experiment()).expect("valid");
    let gains = Gains::new(3.0, 2.0, 5.0);
    let part = |part| robustness(&setting, gains, &GRID, part).expect("valid");
    let whole = part([0, 60]);
    assert_eq!([part([0, 7]), part([7, 60])].concat(), whole);
    for (index, end) in whole.iter().enumerate() {
        let alone =
            Experiment { starts: vec![GRID.posture(index as u32)], ..setting.experiment().clone() };
        let alone = Setting::new(alone).expect("valid");
        let episode = alone.episode(gains, 0).finished();
        assert_eq!(bits(&episode.cost()), bits(&end.cost));
        assert_eq!(episode.outcome(), Some(end.outcome));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_robot_fares_from_each_start_as_in_a_run_of_its_own() {
    let mut random = Random::new(7);
    for preset in [Preset::VelocityLimits, Preset::AccelerationLimits] {
        let mut experiment = preset.experiment();
        experiment.starts = (0..21).map(|_| random.posture(3.0)).collect();
        experiment.starts[3] = experiment.goal;
        experiment.disturbance =
            Disturbance { kind: DisturbanceKind::Random, linear: 0.2, angular: 0.3, seed: 4 };
        let setting = Setting::new(experiment).expect("valid");
        let gains = Gains::new(3.0, 2.0, 5.0);
        let ends = fares(&setting, gains);
        assert_eq!(ends.len(), 21);
        for (start, end) in (0..).zip(&ends) {
            let episode = setting.episode(gains, start).finished();
            assert_eq!(bits(&episode.cost()), bits(&end.cost), "start {start}");
            assert_eq!(episode.outcome(), Some(end.outcome), "start {start}");
        }
        assert!(ends.iter().any(|end| end.outcome == Outcome::Arrived));
        assert!(ends.iter().any(|end| end.outcome == Outcome::Horizon));
        let mean = Cost::mean(ends.iter().map(|end| end.cost)).total();
        assert_eq!(setting.evaluate(&[gains]).expect("valid"), [mean]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn starts_on_a_circle_are_as_far_from_its_centre_and_head_anywhere() {
    let centre = Posture { x: 2.0, y: -1.0, theta: 0.5 };
    let starts = on_circle(centre, 2.5, 500, 3).expect("valid");
    let mut quadrants = [0; 4];
    for start in &starts {
        let distance = (start.x - centre.x).hypot(start.y - centre.y);
        assert!((distance - 2.5).abs() < 1e-12);
        quadrants
            [((start.theta + core::f64::consts::PI) / core::f64::consts::FRAC_PI_2) as usize] += 1;
    }
    assert!(quadrants.iter().all(|count| (90..160).contains(count)), "{quadrants:?}");
    for (start, x, y) in [(0, 2.5, 0.0), (125, 0.0, 2.5), (250, -2.5, 0.0), (375, 0.0, -2.5)] {
        let Posture { x: ahead, y: aside, .. } = starts[start];
        assert_close(ahead, centre.x + x, 1e-12);
        assert_close(aside, centre.y + y, 1e-12);
    }
    assert_eq!(starts, on_circle(centre, 2.5, 500, 3).expect("valid"));
    assert_ne!(starts, on_circle(centre, 2.5, 500, 4).expect("valid"));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_run_of_a_seed_is_that_of_its_evolution_beside_random_search() {
    let experiment = Preset::VelocityLimits.experiment();
    let runs =
        seed_runs(&Setting::new(experiment.clone()).expect("valid"), [3, 6], 12).expect("valid");
    assert_eq!(runs.len(), 3);
    for (seed, run) in (3..).zip(&runs) {
        let mut own = experiment.clone();
        own.evolution.seed = seed;
        let mut evolution = Evolution::new(Setting::new(own).expect("valid"));
        let mut best = vec![evolution.newest().best.cost];
        (0..12).for_each(|_| best.push(evolution.step().best.cost));
        assert_eq!(run.best.0, best);
        assert_eq!(run.champion, evolution.newest().best);
        assert_eq!((run.random.len(), run.random[0]), (13, best[0]));
        assert!(run.random.is_sorted_by(|a, b| a >= b), "random search keeps its best");
    }
    assert_ne!(runs[0].random, runs[1].random);
    assert_eq!(
        seed_runs(&Setting::new(experiment.clone()).expect("valid"), [4, 5], 12).expect("valid")[0],
        runs[1]
    );
}

/// The share of a thousand starts that were never trained on from which these gains arrive.
fn success(gains: Gains) -> f64 {
    let mut test = Preset::VelocityLimits.experiment();
    test.starts = on_circle(test.goal, 2.83, 1000, 99).expect("valid");
    let setting = Setting::new(test).expect("valid");
    let arrived = (0..1000)
        .filter(|start| {
            setting.episode(gains, *start).finished().outcome() == Some(Outcome::Arrived)
        })
        .count();
    arrived as f64 / 1000.0
}

#[wasm_bindgen_test(unsupported = test)]
fn gains_evolved_on_many_starts_arrive_from_many_more_than_the_papers() {
    let mut training = Preset::VelocityLimits.experiment();
    training.starts = on_circle(training.goal, 2.83, 32, 1).expect("valid");
    let mut evolution = Evolution::new(Setting::new(training).expect("valid"));
    (0..40).for_each(|_| {
        evolution.step();
    });
    let trained = evolution.newest().best.gains;
    let (papers, ours) = (success(Gains::new(3.23673, 0.09678, 5.17891)), success(trained));
    assert!((0.15..0.40).contains(&papers), "the paper's gains: {papers}");
    assert!(ours > papers + 0.25, "evolved on 32 starts, {trained:?}: {ours}, not {papers}");
    assert!(trained.y > 1.0, "ky matters now: {trained:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_surveys_are_refused_by_name() {
    let setting = Setting::new(Preset::VelocityLimits.experiment()).expect("valid");
    let k = Gains::new(1.0, 1.0, 1.0);
    let grid = |change: fn(&mut StartGrid)| {
        let mut grid = GRID;
        change(&mut grid);
        robustness(&setting, k, &grid, [0, 1]).expect_err("refused").to_string()
    };
    assert_eq!(
        grid(|grid| grid.x.to = 1e9),
        "x.to must be a number from -1000 to 1000 m, but was 1000000000"
    );
    assert_eq!(grid(|grid| grid.y.from = f64::NAN), "y.from must be a finite number, but was NaN");
    assert_eq!(
        grid(|grid| grid.headings = 0),
        "headings must be a whole number from 1 to 1024, but was 0"
    );
    assert_eq!(
        robustness(&setting, k, &GRID, [3, 61]).expect_err("refused").to_string(),
        "part must be [first, end] with 0 ≤ first ≤ end ≤ 60, but was [3, 61]"
    );
    let large = StartGrid {
        x: Range { count: 1000, ..GRID.x },
        y: Range { count: 1000, ..GRID.y },
        ..GRID
    };
    // However many starts the experiment has.
    let mut several = setting.experiment().clone();
    several.starts = vec![Posture::default(); 7];
    let several = Setting::new(several).expect("valid");
    assert_eq!(
        robustness(&several, k, &large, [0, 400_001]).expect_err("refused").to_string(),
        "the number of starts must be at most 400000 with 1 starts and 1000 samples a run, \
         but was 400001"
    );
    assert_eq!(
        seed_runs(&setting, [0, 1000], 200).expect_err("refused").to_string(),
        "the number of drives must be at most 400000 with 1 starts and 1000 samples a run, \
         but was 8040000"
    );
    assert_eq!(
        on_circle(Posture::default(), -1e4, 3, 1).expect_err("refused").to_string(),
        "radius must be a number from -1000 to 1000 m, but was -10000"
    );
    assert_eq!(
        on_circle(Posture::default(), 1.0, 0, 1).expect_err("refused").to_string(),
        "count must be a whole number from 1 to 10000, but was 0"
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn the_largest_surveys_are_allowed_and_no_larger() {
    let circle = |x, count| on_circle(Posture { x, ..Posture::default() }, 1000.0, count, 1);
    assert_eq!(circle(-1000.0, 10_000).expect("valid").len(), 10_000);
    assert!(circle(-1000.1, 1).is_err() && circle(0.0, 10_001).is_err());

    // Of a run with 1000 samples, 400,000 are allowed; a robot at its goal needs none.
    let mut resting = Preset::VelocityLimits.experiment();
    resting.starts = vec![resting.goal];
    let setting = Setting::new(resting.clone()).expect("valid");
    let gains = vec![Gains::new(1.0, 1.0, 1.0); 400_001];
    assert_eq!(setting.evaluate(&gains[1..]).expect("valid").len(), 400_000);
    assert!(setting.evaluate(&gains).is_err());
    resting.evolution.population = 2;
    assert_eq!(
        seed_runs(&Setting::new(resting.clone()).expect("valid"), [1, 1001], 99)
            .expect("valid")
            .len(),
        1000
    );
    assert!(seed_runs(&Setting::new(resting.clone()).expect("valid"), [1, 1001], 100).is_err());

    let range = Range { from: -1000.0, to: 1000.0, count: 1024 };
    let grid = |count, headings| StartGrid { x: Range { count, ..range }, y: range, headings };
    let rows = |grid| robustness(&setting, gains[0], &grid, [5, 5]).map(|ends| ends.len());
    assert_eq!(rows(grid(1024, 1024)), Ok(0));
    assert!(rows(grid(1025, 1)).is_err() && rows(grid(1, 1025)).is_err());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_beyond_the_streams_meets_the_disturbances_of_another() {
    let mut experiment = Preset::VelocityLimits.experiment();
    experiment.disturbance =
        Disturbance { kind: DisturbanceKind::Random, linear: 0.2, angular: 0.3, seed: 4 };
    let range = Range { from: -1.0, to: 3.0, count: 1024 };
    let grid = StartGrid { x: range, y: range, headings: 1024 };
    let (streams, k) = (1_u32 << 29, Gains::new(3.0, 2.0, 5.0));
    let setting = Setting::new(experiment.clone()).expect("valid");
    let beyond = robustness(&setting, k, &grid, [streams - 1, streams + 2]).expect("valid");
    // The starts of the experiment have the first streams.
    experiment.starts = (0..2).map(|i| grid.posture(streams + i)).collect();
    assert_eq!(beyond[1..], fares(&Setting::new(experiment).expect("valid"), k));
}
