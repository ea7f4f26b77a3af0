//! What an experiment may be: every field in its range and its words, and what is refused is refused by name.

mod common;

use common::json::written;
use common::{assert_refused, velocity_limits};
use ep_locomotion::robot::{DisturbanceKind, Law, Posture};
use ep_locomotion::run::{Experiment, Preset, Setting};
use ep_locomotion::schema::Fields;
use ep_locomotion::search::Method;
use serde_json::Value;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn rules_between_fields_are_told_in_words() {
    for (change, message) in [
        (
            (|e| e.starts.clear()) as fn(&mut Experiment),
            "starts must be a list of 1 to 10000 postures, but was a list of 0",
        ),
        (
            |e| (e.horizon, e.sample_time) = (1e4, 1e-3),
            "horizon must be at most 100000 times sampleTime, but was 10000 with sampleTime 0.001",
        ),
        (
            |e| e.evolution.initial_range = [2.0, 1.0],
            "evolution.initialRange must be [low, high] with low under high, but was [2, 1]",
        ),
        (
            |e| {
                e.disturbance.kind = DisturbanceKind::Random;
                e.disturbance.linear = -0.1;
            },
            "disturbance.linear must be 0 or more for a random disturbance, but was -0.1",
        ),
        (
            |e| e.evolution.population = 0,
            "evolution.population must be a whole number from 1 to 2000, but was 0",
        ),
        (
            |e| {
                e.starts = vec![Posture::default(); 1000];
                e.evolution.population = 500;
            },
            "evolution.population must be at most 400 with 1000 starts and 1000 samples a run, \
             but was 500",
        ),
        (
            |e| {
                e.starts = vec![Posture::default(); 10_000];
                e.horizon = 1000.0;
                e.evolution.population = 1;
            },
            "starts must be at most 4000 postures with 100000 samples a run, but was 10000",
        ),
        (
            |e| {
                e.starts = vec![Posture::default(); 4000];
                e.horizon = 1000.0;
                e.evolution.method = Method::NelderMead;
            },
            "starts must be at most 1000 postures with 100000 samples a run, but was 4000",
        ),
        (
            |e| {
                (e.horizon, e.evolution.method) = (1000.0, Method::De);
                e.starts = vec![Posture::default(); 2000];
            },
            "starts must be at most 1000 postures with 100000 samples a run, but was 2000",
        ),
    ] {
        let mut experiment = velocity_limits();
        change(&mut experiment);
        assert_refused(Setting::new(experiment), message);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_population_that_a_method_does_not_have_is_not_counted() {
    let mut experiment = velocity_limits();
    experiment.starts = vec![Posture::default(); 1000];
    experiment.evolution.population = 2000;
    assert!(Setting::new(experiment.clone()).is_err());
    experiment.evolution.method = Method::NelderMead;
    assert!(Setting::new(experiment).is_ok());
}

#[wasm_bindgen_test(unsupported = test)]
fn the_ends_of_every_range_are_allowed_and_nothing_beyond() {
    for field in Experiment::fields().numbers {
        let allowed = field.allowed();
        for value in [field.min, field.max] {
            assert!(allowed.allows(value), "{} may be {value}", field.path);
        }
        for value in [field.min.next_down(), field.max.next_up(), f64::NAN] {
            assert!(!allowed.allows(value), "{} may not be {value}", field.path);
        }
        assert!(field.min < field.max);
        assert_eq!(allowed.allows(field.min + 0.5), !field.integer, "{}", field.path);
        let is_limit = field.path.starts_with("limits.")
            || ["tolerance.speed", "tolerance.turnRate"].contains(&field.path.as_str());
        assert_eq!(field.nullable, is_limit, "{}", field.path);
        let null = if field.nullable { ", or null for no limit" } else { "" };
        let expected = allowed.expected().to_string();
        assert!(expected.ends_with(null), "{expected}");
    }
}

/// Nothing of an experiment is written that `fields()` does not tell, and nothing told that is not written.
#[wasm_bindgen_test(unsupported = test)]
fn every_field_has_its_row() {
    fn leaves(path: &str, value: &Value, found: &mut Vec<String>) {
        match value {
            Value::Object(fields) => {
                let dot = if path.is_empty() { "" } else { "." };
                fields
                    .iter()
                    .for_each(|(name, value)| leaves(&format!("{path}{dot}{name}"), value, found));
            }
            Value::Array(elements) => leaves(&format!("{path}[]"), &elements[0], found),
            _ => found.push(path.into()),
        }
    }
    let mut found = Vec::new();
    leaves("", &written(&velocity_limits()), &mut found);
    let Fields { numbers, words } = Experiment::fields();
    let mut told: Vec<String> = numbers.into_iter().map(|field| field.path).collect();
    told.extend(words.into_iter().map(|field| field.path));
    found.sort();
    told.sort();
    assert_eq!(found, told);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_largest_experiments_are_allowed_and_no_larger() {
    type Change = fn(&mut Experiment, u32);
    let check = |change: Change, one_more| {
        let mut experiment = velocity_limits();
        change(&mut experiment, one_more);
        Setting::new(experiment).map(drop).map_err(|error| error.field.clone())
    };
    let rules: [(Change, &str); 5] = [
        (|e, more| e.starts = vec![Posture::default(); 10_000 + more as usize], "starts"),
        (|e, more| e.horizon = 1000.0 + f64::from(more), "horizon"),
        (
            |e, more| {
                // 4·10⁸ samples in one call.
                (e.horizon, e.starts) = (1000.0, vec![Posture::default(); 10]);
                e.evolution.population = 400 + more;
            },
            "evolution.population",
        ),
        (
            |e, more| {
                e.disturbance.kind = DisturbanceKind::Random;
                e.disturbance.angular = -1e-9 * f64::from(more);
            },
            "disturbance.angular",
        ),
        (
            |e, more| e.evolution.initial_range = [1.0, 1.0 + 1e-9 * (1.0 - f64::from(more))],
            "evolution.initialRange",
        ),
    ];
    for (change, field) in rules {
        assert_eq!(check(change, 0), Ok(()), "{field}");
        assert_eq!(check(change, 1), Err(field.to_string()));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_in_messages_are_written_as_javascript_writes_them() {
    for (value, written) in [
        (f64::NAN, "NaN"),
        (f64::INFINITY, "Infinity"),
        (f64::NEG_INFINITY, "-Infinity"),
        (0.0, "0"),
        (-1.5, "-1.5"),
        (1e-6, "0.000001"),
        (1e-7, "1e-7"),
        (-5e-324, "-5e-324"),
        (1e20, "100000000000000000000"),
        (1e21, "1e21"),
        (-1e300, "-1e300"),
    ] {
        let mut experiment = velocity_limits();
        experiment.horizon = value;
        let message = experiment.validate().expect_err("refused").to_string();
        assert_eq!(
            message,
            format!("horizon must be a number from 0.00001 to 100000 s, but was {written}")
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_presets_are_in_every_range() {
    for preset in [Preset::VelocityLimits, Preset::AccelerationLimits] {
        assert_eq!(Preset::find(preset.word()), Ok(preset));
        assert_eq!(preset.experiment().validate(), Ok(()));
    }
    assert_eq!("acceleration-limits".parse(), Ok(Preset::AccelerationLimits));
    assert_eq!(format!("{:>9}.", Law::Kanayama), " kanayama.");
    assert_refused("shim".parse::<Law>(), "Law must be 'shim-kim' or 'kanayama', but was 'shim'");
    assert_refused(
        Preset::find("no-limits"),
        "experiment must be 'velocity-limits' or 'acceleration-limits', but was 'no-limits'",
    );
    let long = Preset::find(&"x".repeat(100_000)).expect_err("refused").to_string();
    assert!(long.ends_with("xxx…'") && long.len() < 200, "{long}");
}
