//! Whatever the numbers, nothing panics and no cost is NaN.

mod common;

use common::{Random, valid, wild};
use ep_locomotion::robot::{ErrorPosture, Gains, Law, Limits, Posture, Velocity};
use ep_locomotion::run::Outcome;
use ep_locomotion::study::{
    Axis, Circle, Evolution, Gain, Grid, Landscape, Range, Stability, error_parts,
    remaining_errors, robustness,
};
use ep_locomotion::theory::{ErrorSizes, lyapunov_rate_bound, robust_gains, theorem_2_sets};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn a_million_wild_runs_never_panic_and_never_cost_nan() {
    let mut random = Random::new(1);
    let (mut finite, mut diverged) = (0, 0);
    for _ in 0..100_000 {
        let setting = valid(wild(&mut random));
        for _ in 0..5 {
            let gains = Gains::new(random.hostile(), random.hostile(), random.hostile());
            for start in 0..2 {
                let episode = setting.episode(gains, start).finished();
                let cost = episode.cost();
                for part in [cost.time, cost.final_error, cost.path, cost.energy, cost.penalty] {
                    assert!(part >= 0.0, "{part}");
                }
                assert!(!cost.total().is_nan());
                finite += u32::from(cost.total().is_finite());
                diverged += u32::from(episode.outcome() == Some(Outcome::Diverged));
            }
        }
    }
    assert!(finite > 100_000 && diverged > 100, "{finite} finite, {diverged} diverged");
}

#[wasm_bindgen_test(unsupported = test)]
fn wild_samples_are_finite_until_a_run_diverges() {
    let mut random = Random::new(2);
    for _ in 0..5_000 {
        let setting = valid(wild(&mut random));
        let gains = Gains::new(random.hostile(), random.hostile(), random.hostile());
        for sample in setting.episode(gains, 0).samples() {
            if sample.outcome == Some(Outcome::Diverged) {
                break;
            }
            let p = sample.posture;
            assert!(p.x.is_finite() && p.y.is_finite() && p.theta.is_finite(), "{sample:?}");
            assert!(sample.error.theta.abs() <= core::f64::consts::PI);
        }
    }
}

/// Any number that there is.
fn any(random: &mut Random) -> f64 {
    match random.below(12) {
        0 => f64::NAN,
        1 => f64::INFINITY,
        2 => f64::NEG_INFINITY,
        _ => random.hostile(),
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn functions_of_numbers_take_any() {
    let mut random = Random::new(4);
    for _ in 0..100_000 {
        let mut next = || any(&mut random);
        let e = ErrorPosture::new(next(), next(), next());
        let k = Gains::new(next(), next(), next());
        let p = Posture { x: next(), y: next(), theta: next() };
        let [q, r] = [0, 1].map(|_| Velocity { linear: next(), angular: next() });
        let dt = next();
        for law in [Law::ShimKim, Law::Kanayama] {
            law.command(&e, &k, r);
            law.promised_rate(&e, &k, r);
            if let Some(function) = law.lyapunov(&k) {
                function.rate(&e, q, r);
                function.value(&e);
            }
        }
        lyapunov_rate_bound(&e, &k, q);
        let robust = robust_gains(&e, q);
        assert!(![robust.x, robust.y, robust.theta].iter().any(|gain| *gain < 0.0));
        let sets = theorem_2_sets(&k, q, dt);
        assert!(![sets.x, sets.y, sets.theta].iter().any(|reach| *reach < 0.0));
        ErrorSizes::new(&e);
        e.posture(p).error_to(p);
        p.advance(q, dt);
        let speed = next().abs();
        let limits = Limits { speed: Some(speed), ..Limits::NONE };
        // NaN stays what it is; all else is limited.
        assert!(limits.applied(q, r, dt).linear.abs() <= speed || (q.linear + speed).is_nan());
        let [from, to] = [0, 1].map(|_| next());
        for log in [false, true] {
            Axis { gain: Gain::X, from, to, count: 3, log }.value(2);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn jobs_take_any_numbers_or_refuse_them_by_name() {
    let mut random = Random::new(5);
    let mut refused = 0;
    for _ in 0..2_000 {
        let setting = valid(wild(&mut random));
        let mut next = || any(&mut random);
        let k = Gains::new(next(), next(), next());
        let [x, y] = [0, 1].map(|_| Range { from: next(), to: next(), count: 2 });
        let axis =
            |gain, Range { from, to, count }: Range| Axis { gain, from, to, count, log: false };
        let cells = Landscape { x: axis(Gain::X, x), y: axis(Gain::Theta, y), gains: k };
        let grid = Grid { x, y, headings: 3 };
        let centre = Posture { x: x.from, y: y.from, theta: 0.0 };
        let errors = [
            cells.costs(&setting, [0, 2]).err(),
            robustness(&setting, k, &grid, [0, 12]).err(),
            Circle { x: centre.x, y: centre.y, radius: x.to, count: 3, seed: 1 }.starts().err(),
            remaining_errors(&setting, &k, y.to).err(),
        ];
        for error in errors.into_iter().flatten() {
            let told = error.to_string();
            let names = ["landscape.", "grid.", "circle.", "seconds "];
            assert!(names.iter().any(|name| told.starts_with(name)), "{told}");
            refused += 1;
        }
        assert!(!setting.evaluate(&[k]).expect("one")[0].is_nan());
        Stability::of(&setting, &k, 0);
        error_parts(&setting, &k, 1);
    }
    assert!(refused > 1000, "{refused}");
}

#[wasm_bindgen_test(unsupported = test)]
fn wild_evolutions_keep_their_order() {
    let mut random = Random::new(3);
    for _ in 0..300 {
        let mut experiment = wild(&mut random);
        experiment.evolution.population = 1 + random.below(5);
        experiment.evolution.initial_sigma = random.hostile().abs().min(1e6);
        let mut evolution = Evolution::new(valid(experiment));
        let mut best = evolution.newest().best.cost;
        for _ in 0..30 {
            let next = evolution.step().best.cost;
            assert!(next <= best);
            best = next;
        }
    }
}
