//! The rivals against published programs, on functions without a robot: how many evaluations until the value is below 1e-8.

use ep_locomotion::robot::Gains;
use ep_locomotion::run::Preset;
use ep_locomotion::search::{EvolutionSettings, Method, search};
use ep_locomotion::study::Evolution;

type Function = fn([f64; 3]) -> f64;

fn sphere(k: [f64; 3]) -> f64 {
    k.iter().map(|x| (x - 3.0) * (x - 3.0)).sum()
}

fn ellipsoid(k: [f64; 3]) -> f64 {
    k.iter().zip([1.0, 100.0, 1e4]).map(|(x, scale)| scale * (x - 3.0) * (x - 3.0)).sum()
}

fn rosenbrock(k: [f64; 3]) -> f64 {
    k.windows(2).map(|x| 100.0 * (x[1] - x[0] * x[0]).powi(2) + (1.0 - x[0]).powi(2)).sum()
}

/// Evaluations until the target, the most where it is not reached.
fn runtime(e: &EvolutionSettings, function: Function) -> usize {
    const MOST: usize = 4000;
    let mut search = search(e.method);
    let mut tried = 0;
    for generation in 0.. {
        let brood = search.ask(e, generation);
        let costs: Vec<f64> = brood.gains().iter().map(|k| function(k.to_array())).collect();
        if let Some(at) = costs.iter().position(|cost| *cost < 1e-8) {
            return (tried + at + 1).min(MOST);
        }
        tried += costs.len();
        if tried >= MOST {
            return MOST;
        }
        search.tell(e, brood, &costs);
    }
    unreachable!()
}

/// Quartiles over 51 runs.
fn quartiles(method: Method, population: u32, function: Function) -> [usize; 3] {
    let e = Preset::VelocityLimits.experiment().evolution;
    let mut times: Vec<_> = (1..=51)
        .map(|seed| runtime(&EvolutionSettings { method, population, seed, ..e }, function))
        .collect();
    times.sort_unstable();
    [12, 25, 38].map(|rank| times[rank])
}

/// The sign of NaN is the machine's: 0/0 is negative on x86 and positive on ARM.
#[test]
fn what_is_not_finite_costs_the_most_whatever_its_sign() {
    let e = Preset::VelocityLimits.experiment().evolution;
    for method in Method::ALL {
        let e = EvolutionSettings { method: *method, ..e };
        let gone = |wrong: f64| {
            let mut search = search(e.method);
            let mut told = Vec::new();
            for generation in 0..6 {
                let brood = search.ask(&e, generation);
                let cost =
                    |(i, k): (usize, &Gains)| if i % 3 == 1 { wrong } else { sphere(k.to_array()) };
                let costs: Vec<f64> = brood.gains().iter().enumerate().map(cost).collect();
                search.tell(&e, brood, &costs);
                told.extend(search.population().iter().map(|one| (one.gains, one.cost.to_bits())));
            }
            assert!(search.best().cost.is_finite());
            told
        };
        let expected = gone(f64::INFINITY);
        for wrong in [f64::NAN, -f64::NAN, f64::NEG_INFINITY] {
            assert_eq!(gone(wrong), expected, "{method:?}, {wrong}");
        }
    }
}

#[test]
#[should_panic(expected = "differential evolution needs four members, not 3")]
fn differential_evolution_of_three_ends_with_a_message() {
    let e = Preset::VelocityLimits.experiment().evolution;
    runtime(&EvolutionSettings { method: Method::De, population: 3, ..e }, sphere);
}

#[test]
#[should_panic(expected = "CMA-ES needs a population of two, not 1")]
fn cma_es_of_one_ends_with_a_message() {
    let e = Preset::VelocityLimits.experiment().evolution;
    runtime(&EvolutionSettings { method: Method::CmaEs, population: 1, ..e }, sphere);
}

/// So that runs can be shared out to threads.
#[test]
fn an_evolution_may_go_to_another_thread() {
    fn goes<T: Send + Sync>() {}
    goes::<Evolution>();
}

/// What `tests/rivals/rivals.py --functions` prints of pycma 4.5.0 and SciPy 1.17.1.
#[test]
fn they_need_as_many_evaluations_as_pycma_and_scipy() {
    let known: [(Method, u32, Function, [usize; 3]); 6] = [
        (Method::CmaEs, 7, sphere, [394, 435, 469]),
        (Method::CmaEs, 7, ellipsoid, [757, 829, 888]),
        (Method::CmaEs, 7, rosenbrock, [983, 1174, 1528]),
        (Method::De, 20, sphere, [1099, 1167, 1207]),
        (Method::De, 20, ellipsoid, [1378, 1463, 1507]),
        (Method::NelderMead, 20, sphere, [111, 118, 126]),
    ];
    for (method, population, function, expected) in known {
        let found = quartiles(method, population, function);
        for (own, theirs) in found.into_iter().zip(expected) {
            let ratio = own as f64 / theirs as f64;
            assert!((0.85..1.15).contains(&ratio), "{method:?}: {found:?}, not {expected:?}");
        }
    }
}
