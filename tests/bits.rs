//! What the same bits on every machine rest on, where the known evolutions would not notice.

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
fn hash(numbers: impl Iterator<Item = f64>) -> u64 {
    let bytes = numbers.flat_map(f64::to_le_bytes);
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// Beyond 3.654, where one draw of 4000 lies, a normal needs a logarithm, and of those few differ between machines.
#[wasm_bindgen_test(unsupported = test)]
fn a_million_normals_have_the_same_bits_everywhere() {
    let hash = hash(normals().take(1_000_000));
    assert_eq!(format!("{hash:016x}"), "25c9da22310c5490");
    assert!(normals().take(1_000_000).filter(|x| x.abs() > 3.66).count() > 200);
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
