//! What one call may cost, in samples and in bytes: each of these once took all memory, or never ended.

mod common;

use common::{assert_refused, valid, velocity_limits};
use ep_locomotion::robot::{Gains, Posture};
use ep_locomotion::run::{
    Experiment, LEAST_GENERATION, LEAST_SAMPLES, MAX_BYTES, MAX_STARTS, MAX_WORK, Setting,
};
use ep_locomotion::search::{LAST_GENERATION, Method, Selection};
use ep_locomotion::study::{
    Grid, Range, check_error_parts, remaining_errors, robustness, seed_runs, trials,
};
use wasm_bindgen_test::wasm_bindgen_test;

const GAINS: Gains = Gains::new(3.0, 0.1, 5.0);

/// The paper's first experiment with another horizon.
fn lasting(horizon: f64, change: impl FnOnce(&mut Experiment)) -> Setting {
    let mut experiment = Experiment { horizon, ..velocity_limits() };
    change(&mut experiment);
    valid(experiment)
}

#[wasm_bindgen_test(unsupported = test)]
fn a_map_of_more_starts_than_fit_in_the_memory_is_refused() {
    let setting = lasting(0.01, |_| ());
    let range = Range { from: 0.0, to: 1.0, count: 1024 };
    let grid = Grid { x: range, y: range, headings: 1024 };
    assert_refused(
        robustness(&setting, GAINS, &grid, [0, 300_000_000]),
        "the number of starts must be at most 20000000 with 1 start and 1 samples a run, but was 300000000",
    );
    assert_refused(
        robustness(&setting, GAINS, &grid, [0, 4_129_777]),
        "the number of starts must be at most 4129776, for each takes 65 bytes, but was 4129777",
    );
    assert_eq!(robustness(&setting, GAINS, &grid, [5, 9]).map(|ends| ends.len()), Ok(4));
}

#[wasm_bindgen_test(unsupported = test)]
fn whole_runs_are_counted_by_their_columns() {
    let setting = lasting(10.0, |_| ());
    // 13 numbers of 8 bytes at 1001 samples, and what holds them.
    let most = (MAX_BYTES / (2048.0 + 13.0 * 8.0 * 1001.0)) as usize;
    assert_eq!(most, 2528);
    assert_eq!(setting.check_runs(most), Ok(()));
    assert_refused(
        setting.check_runs(most + 1),
        "the number of gain triples must be at most 2528, for each takes 106152 bytes, but was 2529",
    );
    assert!(lasting(1000.0, |_| ()).check_runs(26).is_err());
    // Runs of one sample are few too: each is an object outside.
    assert!(lasting(0.01, |_| ()).check_runs(200_000).is_err());
}

#[wasm_bindgen_test(unsupported = test)]
fn the_parts_of_errors_are_counted_by_their_columns() {
    let from = |starts| {
        move |e: &mut Experiment| {
            (e.starts, e.evolution.population) = (vec![Posture::default(); starts], 1);
        }
    };
    assert_eq!(check_error_parts(&lasting(1000.0, from(67))), Ok(()));
    let many = lasting(1000.0, from(68));
    assert_refused(
        check_error_parts(&many),
        "the number of starts must be at most 67, for each takes 4000040 bytes, but was 68",
    );
    // What remains of them are six numbers a start.
    assert!(remaining_errors(&lasting(1.0, from(200)), &GAINS, 0.5).is_ok());
}

#[wasm_bindgen_test(unsupported = test)]
fn seeds_are_counted_by_what_each_keeps() {
    let setting = lasting(0.01, |e| e.evolution.population = 1);
    assert_refused(
        seed_runs(&setting, [0, 150_000_000], 0),
        "the number of drives of all seeds together must be at most 1000000 with 1 start and 1 samples a run, but was 300000000",
    );
    assert_refused(
        seed_runs(&setting, [0, 104_207], 0),
        "the number of seeds must be at most 104206, for each takes 2576 bytes, but was 104207",
    );
    assert_refused(
        trials(&setting, [0, 104_207], 1),
        "the number of seeds must be at most 104206, for each takes 2576 bytes, but was 104207",
    );
    assert_refused(
        seed_runs(&setting, [0, 1], LAST_GENERATION),
        "the number of drives of all seeds together must be at most 1000000 with 1 start and 1 samples a run, but was 1073741824",
    );
    // Without a seed there is nothing to go through, not even generations.
    assert_eq!(seed_runs(&setting, [7, 7], LAST_GENERATION).map(|runs| runs.len()), Ok(0));
    assert_eq!(seed_runs(&setting, [7, 9], 3).map(|runs| runs.len()), Ok(2));
    assert_eq!(trials(&setting, [3_000_000, 3_000_002], 1).map(|trials| trials.len()), Ok(2));
}

/// 507 solutions of 512 bytes, 32 drives of 16 and an object of 2048 are 2¹⁸ bytes, a part in 1024 of what there may be.
#[wasm_bindgen_test(unsupported = test)]
fn what_fills_the_memory_to_the_last_byte_is_allowed() {
    let setting = lasting(0.01, |e| (e.evolution.population, e.starts) = (507, vec![e.goal]));
    assert_eq!(trials(&setting, [0, 1024], 32).map(|trials| trials.len()), Ok(1024));
    assert_refused(
        trials(&setting, [0, 1025], 32),
        "the number of seeds must be at most 1024, for each takes 262144 bytes, but was 1025",
    );
}

/// 20 solutions of 512 bytes and an object of 2048 leave room for 2²⁴ - 768 drives of 16.
#[wasm_bindgen_test(unsupported = test)]
fn where_one_seed_alone_has_too_many_drives_it_is_these_that_are_refused() {
    let setting = lasting(0.01, |e| e.starts = vec![e.goal]);
    for drives in [16_776_449, 18_000_000] {
        let message = "the number of drives must be at most 16776448, for each takes 16 bytes";
        assert_refused(trials(&setting, [0, 1], drives), &format!("{message}, but was {drives}"));
    }
    assert_eq!(trials(&setting, [0, 0], 18_000_000).map(|trials| trials.len()), Ok(0));
}

/// To begin a run takes as long as some samples, and so do the bouts of a tournament.
#[wasm_bindgen_test(unsupported = test)]
fn what_is_not_driving_is_counted_too() {
    let most = |change: fn(&mut Experiment)| {
        let setting = lasting(0.01, change);
        let message = trials(&setting, [0, 1], 500_000_000).expect_err("refused").to_string();
        let most = message.split("at most ").nth(1).and_then(|rest| rest.split(' ').next());
        most.and_then(|most| most.parse::<f64>().ok()).expect("a number")
    };
    let truncated: fn(&mut Experiment) = |e| {
        e.evolution.selection = Selection::Truncation;
        e.evolution.population = 100;
    };
    type Change = fn(&mut Experiment);
    let cases: [(f64, Change); 5] = [
        (LEAST_SAMPLES, truncated),
        (40.0, |e| e.horizon = 0.4),
        (999.0, |e| e.evolution.opponents = 999),
        (LEAST_GENERATION, |e| e.evolution.method = Method::OnePlusOneEs),
        (LEAST_GENERATION / 2.0, |e| e.evolution.population = 2),
    ];
    for (one, change) in cases {
        assert_eq!(most(change), (MAX_WORK / one).floor(), "{one}");
    }
}

/// The largest population from the most starts is within the bounds as long as its runs are short.
#[wasm_bindgen_test(unsupported = test)]
fn the_largest_population_may_start_everywhere() {
    let largest = |samples: f64| {
        let mut experiment = velocity_limits();
        experiment.horizon = samples * experiment.sample_time;
        experiment.evolution.population = 2000;
        experiment.starts = vec![Posture::default(); MAX_STARTS as usize];
        Setting::new(experiment).map(|_| ())
    };
    assert_eq!(largest(1.0), Ok(()));
    assert_eq!(largest(LEAST_SAMPLES), Ok(()));
    assert!(largest(LEAST_SAMPLES + 1.0).is_err());
}

#[wasm_bindgen_test(unsupported = test)]
fn the_horizon_is_counted_without_a_sample_time() {
    for (horizon, sample_time, samples) in
        [(10.0, 0.0, u32::MAX), (0.0, 0.0, 0), (10.0, f64::NAN, 0), (f64::INFINITY, 1.0, u32::MAX)]
    {
        let experiment = Experiment { horizon, sample_time, ..velocity_limits() };
        assert_eq!(experiment.samples(), samples, "{horizon} / {sample_time}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_grid_without_headings_or_columns_has_no_starts() {
    let range = |count| Range { from: 1.0, to: 2.0, count };
    for (columns, headings) in [(2, 0), (0, 2), (0, 0)] {
        let grid = Grid { x: range(columns), y: range(2), headings };
        assert_eq!(grid.count(), 0);
        assert_eq!(grid.posture(0), Posture { x: 1.0, y: 1.0, theta: 0.0 });
        assert!(robustness(&lasting(1.0, |_| ()), GAINS, &grid, [0, 0]).is_err());
    }
}

/// Beyond the last generation there is no stream of random numbers that is not another's.
#[cfg(not(target_arch = "wasm32"))]
#[test]
#[should_panic(expected = "there is no stream 536870912")]
fn a_generation_beyond_the_last_has_no_draws() {
    let e = lasting(0.01, |_| ()).experiment().evolution;
    ep_locomotion::search::search(Method::Ep).ask(&e, LAST_GENERATION + 1);
}
