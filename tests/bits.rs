//! What the same bits on every machine rest on, where the known evolutions would not notice.

mod common;

use common::{evolved, records, velocity_limits};
use ep_locomotion::robot::{Disturbance, DisturbanceKind, Law, Velocity};
use ep_locomotion::search::Mutation;
use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;
use wasm_bindgen_test::wasm_bindgen_test;

/// Standard normal draws, as mutation makes them.
fn normals() -> impl Iterator<Item = f64> {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(1);
    core::iter::repeat_with(move || Mutation::draw(&mut rng)).flat_map(|draws| {
        let Mutation { gains: k, common, sigmas: s } = draws;
        [k[0], k[1], k[2], common, s[0], s[1], s[2]]
    })
}

/// FNV-1a over the little-endian bytes.
fn hash(words: impl Iterator<Item = u64>) -> String {
    let hash = words.flat_map(u64::to_le_bytes).fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    format!("{hash:016x}")
}

/// Beyond 3.654, where one draw of 4000 lies, a normal needs a logarithm, and of those few differ between machines.
#[wasm_bindgen_test(unsupported = test)]
fn a_million_normals_have_the_same_bits_everywhere() {
    let hash = hash(normals().take(1_000_000).map(f64::to_bits));
    assert_eq!(hash, "25c9da22310c5490");
    assert!(normals().take(1_000_000).filter(|x| x.abs() > 3.66).count() > 200);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_hash_of_a_history_is_that_of_its_gains_sigmas_costs_opponents_wins_and_survivors() {
    let evolution = evolved(velocity_limits(), 5);
    let mut words = Vec::new();
    for record in records(&evolution) {
        words.push(record.generation.into());
        for one in record.parents.iter().chain(&record.offspring) {
            let numbers = one.gains.to_array().into_iter().chain(one.sigmas).chain([one.cost]);
            words.extend(numbers.map(f64::to_bits));
        }
        let opponents = record.tournament.opponents.iter().flatten();
        let counts = opponents.chain(&record.tournament.wins).chain(&record.survivors);
        words.extend(counts.map(|number| u64::from(*number)));
    }
    assert_eq!(evolution.hash(), hash(words.into_iter()));
}

#[wasm_bindgen_test(unsupported = test)]
fn kanayamas_rule_behind_a_moving_reference_on_slippery_ground_has_the_same_bits_everywhere() {
    let mut experiment = velocity_limits();
    experiment.law = Law::Kanayama;
    experiment.reference_velocity = Velocity { linear: 0.5, angular: 0.1 };
    experiment.disturbance =
        Disturbance { kind: DisturbanceKind::Slip, linear: 0.1, angular: 0.2, seed: 0 };
    experiment.tolerance.speed = Some(0.1);
    assert_eq!(evolved(experiment, 20).hash(), "e07e5472ab1434a2");
}

/// With it rand_distr takes the logarithm of the machine instead of libm's, and nothing says so.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn nothing_turns_on_the_standard_library_in_num_traits() {
    let tree = std::process::Command::new(env!("CARGO"))
        .args(["tree", "--locked", "--edges", "features", "--target", "all"])
        .args(["--invert", "num-traits", "--manifest-path"])
        .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml"))
        .output()
        .expect("cargo tree");
    let (tree, complaint) = (
        String::from_utf8(tree.stdout).expect("text"),
        String::from_utf8(tree.stderr).expect("text"),
    );
    assert!(tree.contains("num-traits feature \"libm\""), "{tree}{complaint}");
    for feature in ["std", "default"] {
        assert!(!tree.contains(&format!("num-traits feature \"{feature}\"")), "{tree}");
    }
}
