//! Laws of mutation, tournament and the whole run of evolution.

mod common;

use common::{Random, assert_close, evolved, searched_by, valid};
use ep_locomotion::robot::Gains;
use ep_locomotion::run::{Experiment, MAX_WORK};
use ep_locomotion::search::{
    GenerationRecord, Individual, LAST_GENERATION, LearningRates, Method, Mutation, Tournament,
    wins_bout,
};
use ep_locomotion::study::Evolution;
use wasm_bindgen_test::wasm_bindgen_test;

fn experiment(seed: u32) -> Experiment {
    searched_by(|e| e.seed = seed)
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn covariance(a: &[f64], b: &[f64]) -> f64 {
    let (mean_a, mean_b) = (mean(a), mean(b));
    let products: Vec<f64> = a.iter().zip(b).map(|(a, b)| (a - mean_a) * (b - mean_b)).collect();
    mean(&products)
}

const PARENT: Individual =
    Individual { gains: Gains::new(3.0, 0.5, 5.0), sigmas: [0.5, 2.0, 1e-3], cost: 8.0 };

#[wasm_bindgen_test(unsupported = test)]
fn tau_and_tau_prime_are_the_papers_for_three_gains() {
    let n = 3f64;
    assert_close(LearningRates::PAPER.own, 1.0 / (2.0 * n.sqrt()).sqrt(), 1e-15);
    assert_close(LearningRates::PAPER.common, 1.0 / (2.0 * n).sqrt(), 1e-15);
}

#[wasm_bindgen_test(unsupported = test)]
fn gains_spread_by_the_old_sigma_and_sigmas_by_tau_and_tau_prime() {
    let (mut random, settings) = (Random::new(1), experiment(1).evolution);
    let count = 100_000;
    let mut steps = [const { Vec::new() }; 3];
    let mut logs = [const { Vec::new() }; 3];
    for _ in 0..count {
        let offspring = Mutation::draw(&mut random.0).offspring(&settings, &PARENT);
        for j in 0..3 {
            steps[j].push(
                (offspring.gains.to_array()[j] - PARENT.gains.to_array()[j]) / PARENT.sigmas[j],
            );
            logs[j].push((offspring.sigmas[j] / PARENT.sigmas[j]).ln());
        }
    }
    let noise = 5.0 / f64::from(count).sqrt();
    for j in 0..3 {
        assert!(mean(&steps[j]).abs() < noise, "unbiased");
        // With the new σ the variance would be exp(2 (τ² + τ'²)) = 2.5 times as large.
        assert!((covariance(&steps[j], &steps[j]) - 1.0).abs() < 2.0 * noise);
        assert!(mean(&logs[j]).abs() < noise);
        let spread = LearningRates::PAPER.own * LearningRates::PAPER.own
            + LearningRates::PAPER.common * LearningRates::PAPER.common;
        assert!((covariance(&logs[j], &logs[j]) - spread).abs() < noise);
        for other in 0..3 {
            assert!(covariance(&steps[j], &logs[other]).abs() < noise, "separate draws");
            if other != j {
                assert!(covariance(&steps[j], &steps[other]).abs() < noise);
                // Only the common draw ties two σ together.
                let tie = covariance(&logs[j], &logs[other]);
                assert!(
                    (tie - LearningRates::PAPER.common * LearningRates::PAPER.common).abs() < noise
                );
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_offspring_is_the_formula_of_its_draws() {
    let draws = Mutation { gains: [1.0, -2.0, 0.5], common: 0.3, sigmas: [-1.0, 0.0, 2.0] };
    let offspring = draws.offspring(&experiment(1).evolution, &PARENT);
    assert_eq!(offspring.gains, Gains::new(3.5, -3.5, 5.0005));
    for j in 0..3 {
        let exponent =
            LearningRates::PAPER.common * 0.3 + LearningRates::PAPER.own * draws.sigmas[j];
        assert_close(offspring.sigmas[j], PARENT.sigmas[j] * exponent.exp(), 1e-14);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn opponents_are_the_others_each_as_often() {
    let mut random = Random::new(2);
    let costs = [1.0; 6];
    let mut met = [[0u32; 6]; 6];
    let rounds = 6_000;
    for _ in 0..rounds {
        for (own, opponents) in
            Tournament::hold(&costs, 10, &mut random.0).opponents.iter().enumerate()
        {
            assert_eq!(opponents.len(), 10);
            opponents.iter().for_each(|other| met[own][*other as usize] += 1);
        }
    }
    let expected = f64::from(rounds * 10 / 5);
    for (own, row) in met.iter().enumerate() {
        assert_eq!(row[own], 0, "nobody meets itself");
        let chi_squared: f64 = (0..6)
            .filter(|other| *other != own)
            .map(|other| (f64::from(row[other]) - expected).powi(2) / expected)
            .sum();
        assert!(chi_squared < 18.5, "χ² with 4 degrees of freedom is {chi_squared}"); // 0.1 %
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn bouts_table() {
    const INF: f64 = f64::INFINITY;
    for (cost, opponent, wins) in [
        (1.0, 2.0, true),
        (2.0, 1.0, false),
        (1.0, 1.0, true),
        (1.0, INF, true),
        (INF, 1.0, false),
        (INF, INF, false),
        (f64::NAN, 1.0, false),
    ] {
        assert_eq!(wins_bout(cost, opponent), wins, "{cost} against {opponent}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn ranking_table() {
    let tournament = |wins: &[u32]| Tournament { opponents: Vec::new(), wins: wins.to_vec() };
    for (wins, costs, ranking) in [
        ([1, 3, 2, 0], [5.0, 6.0, 7.0, 8.0], [1, 2, 0, 3]),
        ([2, 2, 2, 2], [4.0, 1.0, 3.0, 2.0], [1, 3, 2, 0]),
        ([2, 2, 2, 2], [1.0, 1.0, 0.5, 1.0], [2, 0, 1, 3]),
        ([0, 0, 0, 1], [f64::INFINITY, f64::INFINITY, 1.0, 9.0], [3, 2, 0, 1]),
    ] {
        assert_eq!(tournament(&wins).ranking(&costs), ranking, "{wins:?} {costs:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_first_population_is_uniform_in_the_initial_range() {
    let mut start = experiment(3);
    start.evolution.population = 2000;
    start.horizon = 0.01;
    let population = Evolution::new(valid(start)).population(0).expect("generation 0");
    for j in 0..3 {
        let gains: Vec<f64> = population.iter().map(|i| i.gains.to_array()[j]).collect();
        assert!(gains.iter().all(|k| (0.01..10.0).contains(k)));
        assert!((mean(&gains) - 5.005).abs() < 0.26);
        assert!((covariance(&gains, &gains) - 9.99f64.powi(2) / 12.0).abs() < 0.6);
    }
    assert!(population.iter().all(|i| i.sigmas == [1.0; 3]));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_best_cost_never_rises_and_the_first_of_the_population_has_it() {
    for seed in [1, 2, 3] {
        let mut evolution = evolved(experiment(seed), 0);
        assert_eq!(evolution.population(0).expect("first")[0], evolution.newest().best);
        let mut best = evolution.newest().best.cost;
        for generation in 1..=100 {
            let statistics = evolution.step();
            assert!(statistics.best.cost <= best);
            best = statistics.best.cost;
            let population = evolution.population(generation).expect("newest");
            assert_eq!(population[0], statistics.best);
            assert!(statistics.median >= best && statistics.worst >= statistics.median);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_record_adds_up() {
    let evolution = evolved(experiment(4), 30);
    let mut population = evolution.population(0).expect("generation 0");
    for generation in 1..=30 {
        let record = evolution.record(generation).expect("a generation");
        assert_eq!(record.parents, population);
        let costs: Vec<f64> = (0..40).map(|number| record.solution(number).cost).collect();
        for (parent, (draws, offspring)) in
            record.parents.iter().zip(record.making.mutations.iter().zip(&record.offspring))
        {
            let child = draws.offspring(&experiment(4).evolution, parent);
            assert_eq!((child.gains, child.sigmas), (offspring.gains, offspring.sigmas));
            let cost = evolution.setting().cost(&offspring.gains).total();
            assert_eq!(cost, offspring.cost);
        }
        for (own, opponents) in record.tournament.opponents.iter().enumerate() {
            let won = opponents.iter().filter(|o| costs[own] <= costs[**o as usize]).count();
            assert_eq!(won as u32, record.tournament.wins[own]);
        }
        let fewest = |numbers: &mut dyn Iterator<Item = u32>| {
            numbers.map(|number| record.tournament.wins[number as usize]).min()
        };
        let weakest = fewest(&mut record.survivors.iter().copied()).expect("20 survive");
        for number in (0..40).filter(|number| !record.survivors.contains(number)) {
            assert!(record.tournament.wins[number as usize] <= weakest);
        }
        assert_eq!(record.ranking, record.tournament.ranking(&costs));
        assert_eq!(record.ranking[..20], record.survivors);
        population = record.population();
    }
    assert_eq!(population, evolution.population(30).expect("newest"));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_run_is_a_function_of_its_experiment_alone() {
    let straight = evolved(experiment(5), 40);
    let mut watched = evolved(experiment(5), 0);
    let mut other = evolved(experiment(6), 0);
    for generation in 0..40 {
        watched.record(generation / 2).expect("a generation");
        other.step();
        watched.step();
    }
    assert_eq!(straight.hash(), watched.hash());
    assert_ne!(straight.hash(), other.hash());
    let records = |e: &Evolution| -> Vec<GenerationRecord> {
        (0..=40).rev().map(|g| e.record(g).expect("a generation")).collect()
    };
    assert_eq!(records(&straight), records(&watched));
}

#[wasm_bindgen_test(unsupported = test)]
fn dropped_snapshots_are_computed_again_to_the_bit() {
    // Of the methods that remember something the one whose generations are the smallest, and which never comes to rest.
    let mut small = searched_by(|e| e.method = Method::NelderMead);
    small.horizon = 0.01;
    // Some 45 000 snapshots of four corners fill their memory; later every fourth is kept.
    let mut evolution = evolved(small, 0);
    let mut kept = Vec::new();
    for generation in 1..=100_000 {
        evolution.step();
        if generation % 997 == 0 {
            kept.push((generation, evolution.population(generation).expect("newest")));
        }
    }
    assert_eq!(evolution.most_driven_again(), 4);
    for (generation, population) in &kept {
        assert_eq!(&evolution.population(*generation).expect("kept or not"), population);
    }
    assert!(kept.windows(2).all(|pair| pair[0].1 != pair[1].1), "it has come to rest");
}

/// Snapshots are dropped only while what is between two can be driven again in one call.
#[wasm_bindgen_test(unsupported = test)]
fn a_record_drives_no_more_than_a_call_may() {
    let mut long = searched_by(|e| (e.method, e.population) = (Method::Random, 2000));
    long.horizon = 1000.0;
    long.starts = vec![long.goal]; // where nothing is left to drive
    let mut evolution = evolved(long.clone(), 650);
    let one = 2000.0 * f64::from(long.samples());
    assert_eq!(one, 0.5 * MAX_WORK);
    assert_eq!(evolution.most_driven_again(), 2);
    // Until their memory is all that they may have.
    for _ in 650..1250 {
        evolution.step();
    }
    assert_eq!(evolution.most_driven_again(), 4);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_generation_that_is_not_there_is_refused() {
    let evolution = evolved(experiment(1), 2);
    for generation in [3, u32::MAX] {
        let message = evolution.record(generation).expect_err("refused").to_string();
        assert!(message.starts_with("generation must be a whole number from 0 to 2"), "{message}");
        assert!(evolution.population(generation).is_err());
        assert!(evolution.statistics(generation).is_err());
    }
    // The 29 bits that seed and purpose leave.
    assert_eq!(LAST_GENERATION, 536_870_911);
}

#[wasm_bindgen_test(unsupported = test)]
fn many_generations_at_once_are_as_many_steps() {
    let (mut one, mut other) = (evolved(experiment(3), 0), evolved(experiment(3), 7));
    assert_eq!(one.advance(7), Ok(other.newest()));
    assert_eq!(one.advance(1), Ok(other.step()));
    assert_eq!((one.generation(), one.hash()), (8, other.hash()));
    // 20 robots for 1000 samples each.
    let message = one.advance(20_001).expect_err("refused").to_string();
    assert!(message.starts_with("generations must be at most 20000 with 1 start"), "{message}");
    assert_eq!(one.generation(), 8);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_population_of_one_still_evolves() {
    let mut lonely = experiment(8);
    lonely.evolution.population = 1;
    let statistics = evolved(lonely, 20).newest();
    assert_eq!((statistics.generation, statistics.evaluations), (20, 21.0));
    assert_eq!(statistics.median, statistics.best.cost);
}
