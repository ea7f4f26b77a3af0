//! The types that JavaScript sees are those that the tables in the sources tell.
#![cfg(not(target_arch = "wasm32"))]

use ep_locomotion::schema::Types;
use std::env;
use std::fs;

/// To write the file anew: `WRITE_TYPES=1 cargo test --test types`
#[test]
fn the_interface_is_told_by_the_tables() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/wasm/interface.d.ts");
    let told = ep_locomotion::outside::declarations();
    if env::var_os("WRITE_TYPES").is_some() {
        fs::write(path, &told).expect("the file is written");
    }
    let written = fs::read_to_string(path).expect("the file");
    assert!(written == told, "write it anew: WRITE_TYPES=1 cargo test --test types");
}

#[test]
fn what_comes_of_a_call_has_the_type_that_is_told() {
    let mut types = Types::default();
    for [told, is] in ep_locomotion::outside::returned(&mut types) {
        assert_eq!(told, is);
    }
}
