//! Laws of every method of searching.

mod common;

use common::{Random, assert_refused, evolved, records, searched_by, valid, wild};
use ep_locomotion::robot::Law;
use ep_locomotion::run::Setting;
use ep_locomotion::search::{BelowZero, EvolutionSettings, Individual, Method, Selection, Step};
use ep_locomotion::study::{Evolution, trials};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn every_method_is_a_function_of_its_experiment_and_can_go_on_from_anywhere() {
    for &method in Method::ALL {
        let experiment = searched_by(|e| (e.method, e.population) = (method, 6));
        let one = evolved(experiment.clone(), 60);
        let mut other = evolved(experiment.clone(), 20);
        let records = records(&one);
        let mut kept = other.clone();
        for generation in (0..=20).rev() {
            assert_eq!(other.record(generation).as_ref(), Ok(&records[generation as usize]));
        }
        for _ in 0..40 {
            assert_eq!(other.step(), kept.step());
        }
        assert_eq!([other.hash(), kept.hash()], [one.hash(), one.hash()], "{method:?}");
        let different = searched_by(|e| (e.method, e.population, e.seed) = (method, 6, 2));
        assert_ne!(evolved(different, 60).hash(), one.hash(), "{method:?}");
        // Some methods choose the step of a survivor only then.
        let gains = |all: &[Individual]| all.iter().map(|one| one.gains).collect::<Vec<_>>();
        for pair in records.windows(2) {
            let left = one.population(pair[0].generation).expect("kept");
            assert_eq!(pair[1].parents, left, "{method:?}");
            assert_eq!(gains(&pair[0].population()), gains(&left), "{method:?}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_best_is_the_lowest_of_all_that_were_driven_and_each_is_counted() {
    for &method in Method::ALL {
        let evolution = evolved(searched_by(|e| (e.method, e.population) = (method, 6)), 80);
        let (mut lowest, mut count) = (f64::INFINITY, 0);
        for record in records(&evolution) {
            lowest = record.tried().iter().map(|one| one.cost).fold(lowest, f64::min);
            count += record.tried().len();
            let statistics = evolution.statistics(record.generation).expect("a generation");
            assert_eq!((statistics.best.cost, statistics.evaluations), (lowest, count as f64));
            let k = statistics.best.gains;
            assert_eq!(
                evolution.setting().cost(&k).total(),
                lowest,
                "{method:?}: lanes are scalar"
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_method_finds_better_gains_than_it_began_with() {
    for &method in Method::ALL {
        let (mut first, mut last) = (0.0, 0.0);
        for trial in trials(&valid(searched_by(|e| e.method = method)), [1, 6], 400).expect("valid")
        {
            first += trial.costs[0];
            last += trial.champion.cost;
        }
        assert!(last < first - 1.0, "{method:?}: {first} {last}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn mirrored_and_held_gains_are_never_below_zero_and_others_are() {
    for &method in Method::ALL {
        let lowest = |below_zero| {
            let change = |e: &mut EvolutionSettings| {
                (e.method, e.below_zero, e.initial_range) = (method, below_zero, [-10.0, -1.0]);
            };
            let records = records(&evolved(searched_by(change), 60));
            let gains = records.iter().flat_map(|r| r.tried()).flat_map(|i| i.gains.to_array());
            gains.fold(f64::INFINITY, f64::min)
        };
        assert!(lowest(BelowZero::Mirror) >= 0.0, "{method:?}");
        assert_eq!(lowest(BelowZero::Clamp), 0.0, "{method:?}");
        assert!(lowest(BelowZero::Penalty) < 0.0, "{method:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn each_member_of_differential_evolution_only_gets_better() {
    let evolution = evolved(searched_by(|e| e.method = Method::De), 50);
    for record in &records(&evolution)[1..] {
        assert_eq!(record.survivors.len(), 20);
        for (own, (parent, trial)) in record.parents.iter().zip(&record.offspring).enumerate() {
            let stays = record.survivors.contains(&(own as u32));
            let replaced = record.survivors.contains(&(own as u32 + 20));
            assert_eq!([stays, replaced], [trial.cost > parent.cost, trial.cost <= parent.cost]);
            let [a, b, c] = record.making.donors[own][..] else { panic!("three donors") };
            assert!(a != b && b != c && c != a && ![a, b, c].contains(&(own as u32)));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_simplex_has_four_corners_and_loses_none_but_its_worst() {
    let evolution = evolved(searched_by(|e| e.method = Method::NelderMead), 300);
    for record in &records(&evolution)[1..] {
        assert!([4, 5].contains(&record.survivors.len()), "{record:?}");
        if record.offspring.len() == 1 {
            let lowest = record.parents[0].cost.min(record.offspring[0].cost);
            assert_eq!(record.solution(record.survivors[0]).cost, lowest);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_trial_is_the_evolution_of_its_seed_drive_by_drive() {
    for &method in Method::ALL {
        let experiment = searched_by(|e| (e.method, e.population) = (method, 7));
        let setting = valid(experiment.clone());
        let all = trials(&setting, [3, 6], 100).expect("valid");
        assert_eq!(
            trials(&setting, [4, 5], 100).expect("valid")[0],
            all[1],
            "alone as beside others"
        );
        for (seed, trial) in (3..).zip(all) {
            let mut own = experiment.clone();
            own.evolution.seed = seed;
            let records = records(&evolved(own, 100));
            let costs = records.iter().flat_map(|r| r.tried()).map(|one| one.cost).take(100);
            let (mut lowest, mut falls) = (f64::INFINITY, Vec::new());
            for (drive, cost) in (1..).zip(costs) {
                if cost < lowest {
                    (lowest, _) = (cost, falls.push((f64::from(drive), cost)));
                }
            }
            let told: Vec<_> =
                trial.drives.iter().copied().zip(trial.costs.iter().copied()).collect();
            assert_eq!((trial.seed, told), (seed, falls), "{method:?}");
            assert_eq!(setting.cost(&trial.champion.gains).total(), trial.champion.cost);
            assert_eq!(trial.champion.cost, lowest);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_cannot_run_is_refused_by_name() {
    for (method, population, message) in [
        (Method::De, 3, "evolution.population must be 4 or more with the method 'de', but was 3"),
        (
            Method::CmaEs,
            1,
            "evolution.population must be 2 or more with the method 'cma-es', but was 1",
        ),
    ] {
        let of = |population| {
            Setting::new(searched_by(|e| (e.method, e.population) = (method, population)))
                .map(Evolution::new)
        };
        assert_refused(of(population), message);
        let mut least = of(population + 1).expect("enough");
        for _ in 0..30 {
            least.step();
        }
    }
    let setting = valid(searched_by(|_| ()));
    assert_refused(
        trials(&setting, [2, 1], 5),
        "seeds must be [first, end] with 0 ≤ first ≤ end ≤ 4294967295, but was [2, 1]",
    );
    assert_refused(
        trials(&setting, [1, 2], 0),
        "drives must be a whole number from 1 to 536870911, but was 0",
    );
    assert_refused(
        trials(&setting, [0, 52], 8000),
        "the number of drives of all seeds together must be at most 400000 with 1 start and 1000 samples a run, but was 416000",
    );
    assert_eq!(trials(&setting, [5, 5], 10).map(|trials| trials.len()), Ok(0));
}

#[wasm_bindgen_test(unsupported = test)]
fn wild_experiments_stop_no_method() {
    let mut random = Random::new(5);
    for round in 0..200 {
        let mut experiment = wild(&mut random);
        let e = &mut experiment.evolution;
        e.method = Method::ALL[round % 8];
        e.population = 4 + random.below(4);
        e.initial_sigma = random.hostile().abs().min(1e6);
        e.sigma_floor = random.hostile().abs().min(1e6);
        e.adaptation = random.within(0.0, 10.0);
        e.crossover = random.within(0.0, 1.0);
        let mut evolution = Evolution::new(valid(experiment));
        let mut best = evolution.newest().best.cost;
        for _ in 0..40 {
            let next = evolution.step().best.cost;
            assert!(next <= best);
            best = next;
        }
    }
}

/// Links made today must give the same runs tomorrow, on every machine.
#[wasm_bindgen_test(unsupported = test)]
fn every_method_and_ingredient_has_the_same_bits_everywhere() {
    type Change = fn(&mut EvolutionSettings);
    let known: [(Change, &str); 13] = [
        (|e| e.method = Method::Random, "503c71ac46b4c41e"),
        (|e| e.method = Method::De, "e331fdff507b742c"),
        (|e| e.method = Method::CmaEs, "2dc6aef4c9a86f7e"),
        (|e| e.method = Method::OnePlusOneEs, "520c4f0968a90745"),
        (|e| e.method = Method::NelderMead, "08b1f831571e5acc"),
        (|e| e.method = Method::OneAtATime, "976201fda9fd8d10"),
        (|e| e.method = Method::FiniteDifferences, "3c25cc46d8bb8d07"),
        (|e| e.step = Step::Cauchy, "5bed01ad4667cf1d"),
        (|e| (e.adaptation, e.sigma_floor) = (0.5, 0.1), "1d8441e6d9bd4d72"),
        (|e| e.selection = Selection::Truncation, "dff8e39eb9a9c3a1"),
        (|e| (e.selection, e.crossover) = (Selection::Parent, 0.7), "949129bf9c59654d"),
        (|e| (e.method, e.below_zero) = (Method::CmaEs, BelowZero::Mirror), "f292f38ac82f560d"),
        (|e| (e.method, e.below_zero) = (Method::OneAtATime, BelowZero::Clamp), "1e03b46b65ad0a17"),
    ];
    let hashes = known.map(|(change, _)| evolved(searched_by(change), 100).hash());
    assert_eq!(hashes.each_ref().map(String::as_str), known.map(|(_, hash)| hash));
}

#[wasm_bindgen_test(unsupported = test)]
fn where_j_is_level_the_sigma_of_the_one_plus_one_strategy_stays_finite() {
    let mut experiment = searched_by(|e| e.method = Method::OnePlusOneEs);
    (experiment.law, experiment.horizon) = (Law::Kanayama, 0.02);
    // On the goal Kanayama's robot does not move.
    experiment.starts = vec![experiment.goal];
    experiment.evolution.below_zero = BelowZero::Clamp;
    let sigmas = evolved(experiment, 2000).newest().mean_sigmas;
    assert!(sigmas.iter().all(|sigma| sigma.is_finite()), "{sigmas:?}");
}
