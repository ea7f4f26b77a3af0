//! Laws of every method of searching, and of the ingredients of evolutionary programming.

mod common;

use common::{Random, evolved, wild};
use ep_locomotion::run::{Experiment, Preset, Setting};
use ep_locomotion::search::{
    BelowZero, EvolutionSettings, GenerationRecord, Individual, Method, Selection, Step,
};
use ep_locomotion::study::{Evolution, trials};
use wasm_bindgen_test::wasm_bindgen_test;

/// The paper's first experiment with another search.
fn searched_by(change: impl Fn(&mut EvolutionSettings)) -> Experiment {
    let mut experiment = Preset::VelocityLimits.experiment();
    change(&mut experiment.evolution);
    experiment
}

fn records(evolution: &Evolution) -> Vec<GenerationRecord> {
    (0..=evolution.generation()).map(|n| evolution.record(n).expect("a generation")).collect()
}

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
        for trial in
            trials(&Setting::new(searched_by(|e| e.method = method)).expect("valid"), [1, 6], 400)
                .expect("valid")
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
                (e.method, e.below_zero, e.initial_sigma) = (method, below_zero, 5.0);
            };
            let records = records(&evolved(searched_by(change), 60));
            let gains = records.iter().flat_map(|r| r.tried()).flat_map(|i| i.gains.to_array());
            gains.fold(f64::INFINITY, f64::min)
        };
        assert!(lowest(BelowZero::Mirror) >= 0.0, "{method:?}");
        let held = lowest(BelowZero::Clamp);
        assert!(held >= 0.0, "{method:?}");
        let stays_within = [Method::Random, Method::FiniteDifferences].contains(&method);
        assert_eq!(lowest(BelowZero::Penalty) >= 0.0, stays_within, "{method:?}");
        assert_eq!(held > 0.0, stays_within, "{method:?}");
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
            let [a, b, c] = record.donors[own][..] else { panic!("three donors") };
            assert!(a != b && b != c && c != a && ![a, b, c].contains(&(own as u32)));
            let [a, b, c, k] = [a, b, c, own as u32].map(|n| record.solution(n).gains.to_array());
            let mutant = [0, 1, 2].map(|j| a[j] + 0.5 * (b[j] - c[j]));
            let crossed = trial.gains.to_array();
            assert!((0..3).all(|j| crossed[j] == mutant[j] || crossed[j] == k[j]));
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
fn without_adaptation_every_sigma_stays_and_with_a_floor_none_is_under_it() {
    let fixed = evolved(searched_by(|e| (e.adaptation, e.initial_sigma) = (0.0, 0.7)), 40);
    for record in records(&fixed) {
        assert!(record.parents.iter().chain(&record.offspring).all(|i| i.sigmas == [0.7; 3]));
    }
    let floored = records(&evolved(searched_by(|e| e.sigma_floor = 0.5), 40));
    let sigmas = floored.iter().flat_map(|r| r.tried()).flat_map(|i| i.sigmas);
    assert_eq!(sigmas.fold(f64::INFINITY, f64::min), 0.5);
}

#[wasm_bindgen_test(unsupported = test)]
fn cauchys_steps_have_its_quartiles_and_shift_no_other_draw() {
    let step = |step| {
        let change = move |e: &mut EvolutionSettings| (e.step, e.population) = (step, 2000);
        let mut experiment = searched_by(change);
        experiment.horizon = 0.01;
        records(&evolved(experiment, 3)).split_off(1)
    };
    let (cauchy, gaussian) = (step(Step::Cauchy), step(Step::Gaussian));
    let mut draws: Vec<f64> =
        cauchy.iter().flat_map(|r| &r.mutations).flat_map(|m| m.gains).collect();
    draws.sort_by(f64::total_cmp);
    // tan(π (p − ½)), each within four standard errors.
    for (share, quantile) in [(0.1, -3.0777), (0.25, -1.0), (0.5, 0.0), (0.75, 1.0), (0.9, 3.0777)]
    {
        let count = draws.len() as f64;
        let under = draws.iter().filter(|draw| **draw < quantile).count() as f64 / count;
        assert!(
            (under - share).abs() < 4.0 * (share * (1.0 - share) / count).sqrt(),
            "{share} {under}"
        );
    }
    for (a, b) in cauchy[0].mutations.iter().zip(&gaussian[0].mutations) {
        assert_eq!((a.common, a.sigmas), (b.common, b.sigmas));
        assert_ne!(a.gains, b.gains);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn who_survives_is_as_the_selection_says() {
    for &selection in Selection::ALL {
        let evolution = evolved(searched_by(|e| e.selection = selection), 30);
        for record in &records(&evolution)[1..] {
            let cost = |number: u32| record.solution(number).cost;
            assert_eq!(record.survivors[..], record.ranking[..20]);
            match selection {
                Selection::Tournament => assert_eq!(record.tournament.wins.len(), 40),
                Selection::Truncation => {
                    assert!(record.ranking.is_sorted_by(|a, b| cost(*a) <= cost(*b)));
                    assert!(record.tournament.wins.is_empty());
                }
                Selection::Parent => {
                    for own in 0..20 {
                        let better = if cost(own + 20) < cost(own) { own + 20 } else { own };
                        assert!(record.survivors.contains(&better));
                    }
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_crossed_parent_has_each_gain_and_its_sigma_of_one_of_two() {
    let evolution = evolved(searched_by(|e| e.crossover = 0.5), 40);
    let mut crossed = 0;
    for record in &records(&evolution)[1..] {
        for own in 0..20 {
            let (parent, base) = (record.parents[own], record.bases[own]);
            let Some(&partner) = record.donors[own].first() else {
                assert_eq!(base, parent);
                continue;
            };
            crossed += 1;
            assert_ne!(partner as usize, own);
            let partner = record.parents[partner as usize];
            for j in 0..3 {
                let pair = |i: &Individual| (i.gains.to_array()[j], i.sigmas[j]);
                assert!(pair(&base) == pair(&parent) || pair(&base) == pair(&partner));
            }
            let child = record.mutations[own].offspring(&base);
            assert_eq!(child.gains, record.offspring[own].gains);
        }
    }
    assert!((340..460).contains(&crossed), "{crossed} of 800");
    assert!(
        evolved(searched_by(|e| (e.crossover, e.population) = (1.0, 1)), 3).newest().best.cost
            > 0.0
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_trial_is_the_evolution_of_its_seed_drive_by_drive() {
    for &method in Method::ALL {
        let experiment = searched_by(|e| (e.method, e.population) = (method, 7));
        let setting = Setting::new(experiment.clone()).expect("valid");
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
        assert_eq!(of(population).expect_err("refused").to_string(), message);
        let mut least = of(population + 1).expect("enough");
        for _ in 0..30 {
            least.step();
        }
    }
    let setting = Setting::new(searched_by(|_| ())).expect("valid");
    let refused = |seeds, drives| trials(&setting, seeds, drives).expect_err("refused").to_string();
    assert_eq!(
        refused([2, 1], 5),
        "seeds must be [first, end] with 0 ≤ first ≤ end ≤ 4294967295, but was [2, 1]"
    );
    assert_eq!(refused([1, 2], 0), "drives must be a whole number from 1 to 536870911, but was 0");
    assert_eq!(
        refused([0, 52], 8000),
        "the number of drives must be at most 400000 with 1 starts and 1000 samples a run, but was 416000"
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
        let mut evolution = Evolution::new(Setting::new(experiment).expect("within the ranges"));
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
