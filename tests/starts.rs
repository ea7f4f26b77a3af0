//! Sets of start postures, and how a robot fares from each.

mod common;

use common::{EP_GAINS, GRID, Random, assert_close, assert_refused, bits, valid, velocity_limits};
use ep_locomotion::robot::{Disturbance, DisturbanceKind, Gains, Posture};
use ep_locomotion::run::{Cost, Experiment, Outcome, Preset};
use ep_locomotion::study::{Circle, Evolution, Grid, Range, fares, robustness};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{RngExt, SeedableRng};
use wasm_bindgen_test::wasm_bindgen_test;

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
    let part = |part| GRID.starts(part).map_err(|error| error.to_string());
    let all: Vec<Posture> = (0..60).map(|index| GRID.posture(index)).collect();
    assert_eq!(part([0, 60]).as_deref(), Ok(all.as_slice()));
    assert_eq!(part([20, 22]).as_deref(), Ok(&all[20..22]));
    assert_eq!(part([60, 60]).as_deref(), Ok(&[][..]));
    let expected = "grid.part must be [first, end] with 0 ≤ first ≤ end ≤ 60, but was [0, 61]";
    assert_eq!(part([0, 61]), Err(expected.into()));
    let large = Grid { headings: 1024, ..GRID };
    assert_eq!(large.starts([100, 10_100]).map(|starts| starts.len()), Ok(10_000));
    assert_refused(
        large.starts([100, 10_101]),
        "grid.part must be at most 10000 starts in one call, but was 10001",
    );
    let empty = Grid { headings: 0, ..GRID };
    assert_refused(
        empty.starts([0, 0]),
        "grid.headings must be a whole number from 1 to 1024, but was 0",
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn robustness_is_each_run_by_itself_in_any_parts() {
    let setting = valid(velocity_limits());
    let gains = Gains::new(3.0, 2.0, 5.0);
    let part = |part| robustness(&setting, gains, &GRID, part).expect("valid");
    let whole = part([0, 60]);
    assert_eq!([part([0, 7]), part([7, 60])].concat(), whole);
    for (index, end) in whole.iter().enumerate() {
        let alone =
            Experiment { starts: vec![GRID.posture(index as u32)], ..setting.experiment().clone() };
        let alone = valid(alone);
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
        let setting = valid(experiment);
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

fn on_circle(centre: Posture, radius: f64, count: u32, seed: u32) -> Vec<Posture> {
    Circle { x: centre.x, y: centre.y, radius, count, seed }.starts().expect("valid")
}

#[wasm_bindgen_test(unsupported = test)]
fn starts_on_a_circle_are_as_far_from_its_centre_and_head_anywhere() {
    let centre = Posture { x: 2.0, y: -1.0, theta: 0.5 };
    let starts = on_circle(centre, 2.5, 500, 3);
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
    assert_eq!(starts, on_circle(centre, 2.5, 500, 3));
    assert_ne!(starts, on_circle(centre, 2.5, 500, 4));
}

/// The share of a thousand starts that were never trained on from which these gains arrive.
fn success(gains: Gains) -> f64 {
    let mut test = velocity_limits();
    test.starts = on_circle(test.goal, 2.83, 1000, 99);
    let setting = valid(test);
    let arrived = (0..1000)
        .filter(|start| {
            setting.episode(gains, *start).finished().outcome() == Some(Outcome::Arrived)
        })
        .count();
    arrived as f64 / 1000.0
}

#[wasm_bindgen_test(unsupported = test)]
fn gains_evolved_on_many_starts_arrive_from_many_more_than_the_papers() {
    let mut training = velocity_limits();
    training.starts = on_circle(training.goal, 2.83, 32, 1);
    let mut evolution = Evolution::new(valid(training));
    (0..40).for_each(|_| {
        evolution.step();
    });
    let trained = evolution.newest().best.gains;
    let (papers, ours) = (success(EP_GAINS), success(trained));
    assert!((0.15..0.40).contains(&papers), "the paper's gains: {papers}");
    assert!(ours > papers + 0.25, "evolved on 32 starts, {trained:?}: {ours}, not {papers}");
    assert!(trained.y > 1.0, "ky matters now: {trained:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_beyond_the_streams_meets_the_disturbances_of_another() {
    let mut experiment = velocity_limits();
    experiment.disturbance =
        Disturbance { kind: DisturbanceKind::Random, linear: 0.2, angular: 0.3, seed: 4 };
    let range = Range { from: -1.0, to: 3.0, count: 1024 };
    let grid = Grid { x: range, y: range, headings: 1024 };
    let (streams, k) = (1_u32 << 29, Gains::new(3.0, 2.0, 5.0));
    let setting = valid(experiment.clone());
    let beyond = robustness(&setting, k, &grid, [streams - 1, streams + 2]).expect("valid");
    // The starts of the experiment have the first streams.
    experiment.starts = (0..2).map(|i| grid.posture(streams + i)).collect();
    assert_eq!(beyond[1..], fares(&valid(experiment), k));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_headings_of_a_circle_are_even_draws_of_their_own_stream() {
    let circle = Circle { x: 1.0, y: 2.0, radius: 3.0, count: 50, seed: 9 };
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(9 | 4 << 32);
    for start in circle.starts().expect("a circle") {
        let turn = core::f64::consts::TAU * rng.random::<f64>();
        assert_eq!(
            start.theta,
            if turn < core::f64::consts::PI { turn } else { turn - core::f64::consts::TAU }
        );
    }
}
