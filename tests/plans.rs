//! What a record tells of how each method came to its trials, and what it learnt from them.

mod common;

use ep_locomotion::search::{EvolutionSettings, GenerationRecord, Method, Motion, Plan, search};
use wasm_bindgen_test::wasm_bindgen_test;

/// The records of 80 generations from 0 on, with the paper's first experiment.
fn records(method: Method, change: impl Fn(&mut EvolutionSettings)) -> Vec<GenerationRecord> {
    let experiment = common::searched_by(|e| {
        e.method = method;
        change(e);
    });
    common::records(&common::evolved(experiment, 80))
}

fn by_gain(number: impl Fn(usize) -> f64) -> [f64; 3] {
    [0, 1, 2].map(number)
}

fn assert_near(a: [f64; 3], b: [f64; 3]) {
    let is_near = (0..3).all(|j| (a[j] - b[j]).abs() <= 1e-9 * (1.0 + a[j].abs()));
    assert!(is_near, "{a:?} {b:?}");
}

fn gains(all: &[ep_locomotion::search::Individual], number: usize) -> [f64; 3] {
    all[number].gains.to_array()
}

#[wasm_bindgen_test(unsupported = test)]
fn what_a_method_goes_by_next_it_goes_by_in_the_next_generation() {
    for &method in Method::ALL {
        let records = records(method, |_| ());
        for pair in records.windows(2) {
            assert_eq!(pair[0].next, pair[1].plan, "{method:?}");
        }
        let has_none = [Method::Ep, Method::Random, Method::De].contains(&method);
        assert_eq!(records.iter().all(|one| one.plan == Plan::default()), has_none, "{method:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_trial_of_differential_evolution_has_each_gain_from_the_mutant_or_the_member() {
    let mut kept = 0;
    for record in &records(Method::De, |_| ())[1..] {
        for (own, (donors, mutant)) in
            record.making.donors.iter().zip(&record.making.bases).enumerate()
        {
            let [a, b, c] = [0, 1, 2].map(|i| gains(&record.parents, donors[i] as usize));
            let mutant = mutant.gains.to_array();
            assert_eq!(mutant, by_gain(|j| a[j] + 0.5 * (b[j] - c[j])));
            let (trial, member) = (gains(&record.offspring, own), gains(&record.parents, own));
            assert!((0..3).all(|j| [mutant[j], member[j]].contains(&trial[j])));
            kept += usize::from(trial != mutant);
        }
    }
    // Two gains of three are kept with a probability of 1 in 10 each.
    assert!((200..400).contains(&kept), "{kept}");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_mean_of_cma_es_moves_to_the_trials_by_their_weights() {
    for record in records(Method::CmaEs, |_| ()) {
        let Plan { ellipse: Some(before), weights, .. } = &record.plan else {
            panic!("no ellipse")
        };
        assert_eq!(record.making.ellipse.as_ref(), Some(before));
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12 && weights.len() == 10);
        let ranked = record.population();
        let mean = before.mean.to_array();
        let step = |j: usize| -> f64 {
            let parts = weights.iter().zip(&ranked);
            parts.map(|(weight, one)| weight * (one.gains.to_array()[j] - mean[j])).sum()
        };
        let after = record.next.ellipse.as_ref().expect("an ellipse");
        assert_near(after.mean.to_array(), by_gain(|j| mean[j] + step(j)));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_sigma_of_the_one_plus_one_strategy_grows_with_a_success_and_shrinks_with_a_failure() {
    let records = records(Method::OnePlusOneEs, |_| ());
    assert_eq!(records[0].next.steps, Some([1.0; 3]));
    let mut successes = 0;
    for record in &records[1..] {
        let [before, after] = [&record.plan, &record.next].map(|plan| plan.steps.expect("a σ"));
        let is_success = record.survivors == [1];
        let factor = if is_success { 1.5 } else { 1.5_f64.powf(-0.25) };
        assert_near(after, by_gain(|j| factor * before[j]));
        assert_eq!(record.parents[0].sigmas, before);
        successes += u32::from(is_success);
    }
    assert!((8..40).contains(&successes), "{successes}");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_moves_of_the_simplex_are_those_of_nelder_and_mead() {
    let mut seen = Vec::new();
    for record in &records(Method::NelderMead, |_| ())[1..] {
        let motion = record.plan.motion.expect("a motion");
        seen.push(motion);
        let corner = |rank: usize| gains(&record.parents, record.plan.corners[rank] as usize);
        let trial = |number: usize| gains(&record.offspring, number);
        let costs: Vec<_> =
            record.plan.corners.iter().map(|n| record.parents[*n as usize].cost).collect();
        assert!(costs.is_sorted(), "{costs:?}");
        let distance = match motion {
            Motion::Begin => {
                assert!(record.plan.corners.is_empty());
                for j in 0..3 {
                    let first = trial(0);
                    assert_eq!(trial(j + 1), by_gain(|i| first[i] + f64::from(u8::from(i == j))));
                }
                continue;
            }
            Motion::Shrink => {
                let lowest = corner(0);
                for rank in 1..4 {
                    assert_near(trial(rank - 1), by_gain(|j| 0.5 * (lowest[j] + corner(rank)[j])));
                }
                continue;
            }
            Motion::Reflection => 1.0,
            Motion::Expansion => 2.0,
            Motion::OutsideContraction => 0.5,
            Motion::InsideContraction => -0.5,
        };
        let centre = by_gain(|j| (0..3).map(|rank| corner(rank)[j] / 3.0).sum());
        assert_near(trial(0), by_gain(|j| centre[j] + distance * (centre[j] - corner(3)[j])));
    }
    use Motion::{Expansion, InsideContraction, OutsideContraction, Reflection, Shrink};
    for motion in [Reflection, Expansion, OutsideContraction, InsideContraction, Shrink] {
        assert!(seen.contains(&motion), "{motion:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn one_gain_at_a_time_takes_the_step_that_was_planned_and_changes_only_that() {
    for record in &records(Method::OneAtATime, |_| ())[1..] {
        let turn = (record.generation as usize - 1) % 3;
        let [plan, next] = [&record.plan, &record.next].map(|plan| plan.steps.expect("steps"));
        let own = |j: usize, value: f64| if j == turn { value } else { 0.0 };
        let from = gains(&record.parents, 0);
        assert_eq!(gains(&record.offspring, 0), by_gain(|j| from[j] + own(j, plan[j])));
        let factor = if record.survivors == [1] { 2.0 } else { -0.5 };
        assert_eq!(next, by_gain(|j| if j == turn { factor * plan[j] } else { plan[j] }));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn finite_differences_tell_the_slope_and_step_down_it() {
    let (mut probed, mut stepped) = (0, 0);
    for record in &records(Method::FiniteDifferences, |_| ())[1..] {
        let (here, from) = (record.parents[0].cost, gains(&record.parents, 0));
        let Some(steps) = record.plan.steps else {
            assert_eq!(record.plan.slope, None);
            let told = by_gain(|j| (record.offspring[j].cost - here) / 1e-4);
            if let Some(slope) = record.next.slope {
                assert_eq!(slope, told);
                let next = record.next.steps.expect("a step");
                let along: f64 = (0..3).map(|j| slope[j] * next[j]).sum();
                let lengths = [slope, next].map(|v| v.iter().map(|x| x * x).sum::<f64>().sqrt());
                assert!((along / lengths[0] / lengths[1] + 1.0).abs() < 1e-9);
                probed += 1;
            }
            continue;
        };
        assert_near(gains(&record.offspring, 0), by_gain(|j| from[j] + steps[j]));
        if let Some(next) = record.next.steps {
            assert_near(next, steps.map(|step| 0.5 * step));
        }
        stepped += 1;
    }
    assert!(probed > 2 && stepped > 10, "{probed} {stepped}");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_axes_of_an_ellipse_spread_each_gain_by_its_sigma() {
    for record in records(Method::CmaEs, |_| ()) {
        let ellipse = record.making.ellipse.as_ref().expect("an ellipse");
        let sigmas = record.tried()[0].sigmas;
        let spread = by_gain(|j| ellipse.axes.iter().map(|axis| axis[j] * axis[j]).sum());
        assert_near(spread, sigmas.map(|sigma| sigma * sigma));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn each_simplex_begins_at_the_next_draw_of_the_initial_range() {
    let experiment = common::searched_by(|e| e.method = Method::NelderMead);
    let begun: Vec<_> = common::records(&common::evolved(experiment, 300))
        .iter()
        .filter(|record| record.plan.motion == Some(Motion::Begin))
        .map(|record| gains(record.tried(), 0))
        .collect();
    assert!(begun.len() > 1, "it never shrinks");
    let draws = records(Method::Random, |_| ());
    let drawn: Vec<_> = draws.iter().map(|record| gains(record.tried(), 0)).collect();
    assert_eq!(begun, drawn[..begun.len()]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_simplex_without_a_single_cost_begins_anew() {
    let e = common::searched_by(|e| e.method = Method::NelderMead).evolution;
    for (costs, motion) in [
        ([f64::INFINITY; 4], Motion::Begin),
        ([1.0, 2.0, 3.0, f64::INFINITY], Motion::Reflection),
        ([0.0; 4], Motion::Reflection),
    ] {
        let mut search = search(e.method);
        search.tell(&e, search.ask(&e, 0), &costs);
        let plan = search.plan(&e);
        assert_eq!((plan.motion, plan.corners.is_empty()), (Some(motion), motion == Motion::Begin));
    }
}

/// Four corners cost 1, 2, 3 and 4: what the trials after them cost, what comes after each, which costs are left, and whether
/// the last trial is among them.
#[wasm_bindgen_test(unsupported = test)]
fn a_simplex_keeps_what_nelder_and_mead_keep() {
    use Motion::{Expansion, InsideContraction, OutsideContraction, Reflection, Shrink};
    let e = common::searched_by(|e| e.method = Method::NelderMead).evolution;
    type Case<'a> = (&'a [f64], &'a [Motion], [f64; 4], bool);
    let cases: [Case; 13] = [
        (&[2.5], &[Reflection], [1.0, 2.0, 2.5, 3.0], true),
        (&[1.0], &[Reflection], [1.0, 1.0, 2.0, 3.0], true),
        (&[0.5, 0.4], &[Expansion, Reflection], [0.4, 1.0, 2.0, 3.0], true),
        (&[0.5, 0.5], &[Expansion, Reflection], [0.5, 1.0, 2.0, 3.0], false),
        (&[0.5, 9.0], &[Expansion, Reflection], [0.5, 1.0, 2.0, 3.0], false),
        (&[3.5, 0.5], &[OutsideContraction, Reflection], [0.5, 1.0, 2.0, 3.0], true),
        (&[3.5, 3.5], &[OutsideContraction, Reflection], [1.0, 2.0, 3.0, 3.5], true),
        (&[3.0, 3.1], &[OutsideContraction, Shrink], [1.0, 2.0, 3.0, 4.0], false),
        (&[3.5, 3.6], &[OutsideContraction, Shrink], [1.0, 2.0, 3.0, 4.0], false),
        (&[4.5, 3.9], &[InsideContraction, Reflection], [1.0, 2.0, 3.0, 3.9], true),
        (&[4.0, 4.0], &[InsideContraction, Shrink], [1.0, 2.0, 3.0, 4.0], false),
        (&[4.5, 4.1], &[InsideContraction, Shrink], [1.0, 2.0, 3.0, 4.0], false),
        (
            &[4.5, 4.1, 7.0, 9.0, 8.0],
            &[InsideContraction, Shrink, Reflection],
            [1.0, 7.0, 8.0, 9.0],
            true,
        ),
    ];
    for (mut costs, motions, left, stays) in cases {
        let mut search = search(e.method);
        search.tell(&e, search.ask(&e, 0), &[1.0, 2.0, 3.0, 4.0]);
        let mut last = search.best().gains;
        for (generation, motion) in (1..).zip(motions) {
            let brood = search.ask(&e, generation);
            let trials = brood.gains();
            let (own, others) = costs.split_at(trials.len());
            search.tell(&e, brood, own);
            assert_eq!(search.plan(&e).motion, Some(*motion), "{own:?}");
            (costs, last) = (others, trials[trials.len() - 1]);
        }
        let found = search.population();
        assert_eq!(found.iter().map(|one| one.cost).collect::<Vec<_>>(), left, "{motions:?}");
        assert_eq!(found.iter().any(|one| one.gains == last), stays, "{left:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn where_no_slope_can_be_told_it_is_probed_again() {
    let e = common::searched_by(|e| e.method = Method::FiniteDifferences).evolution;
    for (here, beside) in [(7.0, 7.0), (7.0, f64::INFINITY), (f64::INFINITY, f64::INFINITY)] {
        let mut search = search(e.method);
        search.tell(&e, search.ask(&e, 0), &[here]);
        for generation in 1..4 {
            search.tell(&e, search.ask(&e, generation), &[beside; 3]);
            assert_eq!(search.plan(&e), Plan::default(), "{here} {beside}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn steps_that_find_nothing_are_halved_to_the_shortest_before_the_slope_is_probed_again() {
    let change = |e: &mut EvolutionSettings| {
        (e.method, e.initial_sigma) = (Method::FiniteDifferences, 4e-6);
    };
    let e = common::searched_by(change).evolution;
    let mut search = search(e.method);
    search.tell(&e, search.ask(&e, 0), &[1.0]);
    let mut lengths = Vec::new();
    for generation in 1..=6 {
        let steps = search.plan(&e).steps;
        lengths.push(steps.map(|[x, ..]| -x));
        let costs: &[f64] = if steps.is_some() { &[2.0] } else { &[2.0, 1.0, 1.0] };
        search.tell(&e, search.ask(&e, generation), costs);
    }
    assert_eq!(lengths, [None, Some(4e-6), Some(2e-6), Some(1e-6), None, Some(1e-6)]);
}
