//! Laws of the ingredients of evolutionary programming: steps, adaptation, selection, crossover.

mod common;

use common::json::{Given, written};
use common::{WORDS, evolved, records, searched_by, velocity_limits};
use ep_locomotion::run::Experiment;
use ep_locomotion::search::{EvolutionSettings, Individual, Method, Selection, Step};
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

/// A word that nothing obeys would be a choice that changes nothing.
#[wasm_bindgen_test(unsupported = test)]
fn no_two_words_of_a_field_make_the_same_evolution() {
    // One in which every field matters.
    let mut base = searched_by(|e| (e.initial_sigma, e.crossover) = (5.0, 0.5));
    (base.disturbance.linear, base.disturbance.angular) = (0.1, 0.1);
    for (path, words) in WORDS {
        let mut hashes: Vec<_> = words
            .iter()
            .map(|word| {
                let (mut given, mut experiment) = (written(&base), velocity_limits());
                let place = given.pointer_mut(&format!("/{}", path.replace('.', "/")));
                *place.expect("a field") = json!(word);
                experiment.read(&Given(Some(&given))).expect("a word");
                evolved(experiment, 20).hash()
            })
            .collect();
        hashes.sort();
        hashes.dedup();
        assert_eq!(hashes.len(), words.len(), "{path} is not obeyed where this test looks");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn each_method_and_each_ingredient_is_defined_in_words() {
    let text = include_str!("../src/search/METHODS.md");
    for word in Method::WORDS {
        assert!(text.contains(&format!("| `{word}` |")), "METHODS.md has no row for {word}");
    }
    let fields = Experiment::fields();
    let words = fields.words.iter().map(|field| &field.path);
    let names: Vec<_> = fields.numbers.iter().map(|field| &field.path).chain(words).collect();
    let names = names.iter().filter_map(|path| path.strip_prefix("evolution."));
    let names: Vec<_> = names.map(|name| name.trim_end_matches("[]")).collect();
    // What stands in backquotes is a setting, or belongs to the one before it.
    let mut of = "";
    let mut said = Vec::new();
    for quoted in text.split('`').skip(1).step_by(2) {
        if names.contains(&quoted) {
            of = quoted;
        }
        said.push((of, quoted));
    }
    for name in names {
        // The table begins with the methods, and has the paper's q; a seed is no ingredient.
        if !["method", "opponents", "seed"].contains(&name) {
            assert!(said.contains(&(name, name)), "METHODS.md does not say what {name} is");
        }
    }
    for (path, words) in WORDS {
        let name = path.strip_prefix("evolution.").filter(|name| *name != "method");
        let Some(name) = name else { continue };
        for &word in words {
            assert!(said.contains(&(name, word)), "METHODS.md does not say what {name} {word} is");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn without_adaptation_every_sigma_stays_and_with_a_floor_none_is_under_it() {
    let fixed = evolved(searched_by(|e| (e.adaptation, e.initial_sigma) = (0.0, 0.7)), 40);
    for record in records(&fixed) {
        assert!(record.parents.iter().chain(&record.offspring).all(|i| i.sigmas == [0.7; 3]));
    }
    let floored = records(&evolved(searched_by(|e| e.sigma_floor = 1.5), 40));
    let sigmas = floored.iter().flat_map(|r| r.tried()).flat_map(|i| i.sigmas);
    assert_eq!(sigmas.fold(f64::INFINITY, f64::min), 1.5);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_floor_is_that_of_evolutionary_programming_alone() {
    for &method in Method::ALL {
        let of = |floor| {
            evolved(searched_by(|e| (e.method, e.sigma_floor) = (method, floor)), 12).hash()
        };
        assert_eq!(of(5.0) == of(0.0), method != Method::Ep, "{method:?}");
    }
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
        cauchy.iter().flat_map(|r| &r.making.mutations).flat_map(|m| m.gains).collect();
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
    for (a, b) in cauchy[0].making.mutations.iter().zip(&gaussian[0].making.mutations) {
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
    let (mut crossed, mut exchanged, e) = (0, 0, &evolution.setting().experiment().evolution);
    for record in &records(&evolution)[1..] {
        for own in 0..20 {
            let (parent, base) = (record.parents[own], record.making.bases[own]);
            let Some(&partner) = record.making.donors[own].first() else {
                assert_eq!(base, parent);
                continue;
            };
            crossed += 1;
            assert_ne!(partner as usize, own);
            let partner = record.parents[partner as usize];
            for j in 0..3 {
                let pair = |i: &Individual| (i.gains.to_array()[j], i.sigmas[j]);
                assert!(pair(&base) == pair(&parent) || pair(&base) == pair(&partner));
                exchanged += usize::from(pair(&base) != pair(&parent));
            }
            let child = record.making.mutations[own].offspring(e, &base);
            assert_eq!(child.gains, record.offspring[own].gains);
        }
    }
    assert!((340..460).contains(&crossed), "{crossed} of 800");
    let share = exchanged as f64 / (3.0 * f64::from(crossed));
    assert!((0.44..0.56).contains(&share), "{share}");
    let of_two = evolved(searched_by(|e| (e.crossover, e.population) = (1.0, 2)), 3);
    assert!(records(&of_two)[1..].iter().all(|record| record.making.donors == [[1], [0]]));
    let alone = |crossover| {
        evolved(searched_by(|e| (e.crossover, e.population) = (crossover, 1)), 3).hash()
    };
    assert_eq!(alone(1.0), alone(0.0));
}
