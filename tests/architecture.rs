//! What the crate promises of itself.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::{Path, PathBuf};

fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let nested = entries.map(|path| if path.is_dir() { sources(&path) } else { vec![path] });
    nested.flatten().filter(|path| path.extension().is_some_and(|e| e == "rs")).collect()
}

#[test]
fn only_the_boundary_knows_javascript_a_clock_or_ambient_chance() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = sources(&src);
    assert!(files.len() > 10);
    for path in files
        .iter()
        .filter(|path| !path.starts_with(src.join("wasm")) && !path.ends_with("wasm.rs"))
    {
        let text = fs::read_to_string(path).expect("a source");
        for word in [
            "wasm_bindgen",
            "JsValue",
            "js_sys",
            "web_sys",
            "getrandom",
            "serde_wasm_bindgen",
            "Instant",
            "SystemTime",
            "static mut",
            "thread_local",
        ] {
            assert!(!text.contains(word), "{} names {word}", path.display());
        }
    }
}

#[test]
fn no_function_is_used_whose_bits_differ_between_machines() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for path in sources(&src) {
        let text = fs::read_to_string(&path).expect("a source");
        for function in [
            ".sin()",
            ".cos()",
            ".tan()",
            ".sin_cos()",
            ".atan2(",
            ".asin()",
            ".acos()",
            ".exp()",
            ".ln()",
            ".log10()",
            ".log2()",
            ".powf(",
            ".powi(",
            ".hypot(",
            ".mul_add(",
            "usize>()",
        ] {
            assert!(!text.contains(function), "{} calls {function}", path.display());
        }
    }
}

#[test]
fn every_file_of_tests_for_webassembly_is_in_the_one_program() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let program = fs::read_to_string(tests.join("wasm.rs")).expect("the program");
    let mut found = 0;
    for path in sources(&tests) {
        let text = fs::read_to_string(&path).expect("a source");
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
        if !text.contains("\n#[wasm_bindgen_test") || name == "panics.rs" {
            continue;
        }
        found += 1;
        assert!(program.contains(&format!("#[path = \"{name}\"]")), "tests/wasm.rs lacks {name}");
    }
    assert!(found > 10);
}
