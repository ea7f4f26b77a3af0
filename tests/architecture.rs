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

/// The modules that a file declares, in the order in which they are to be read.
fn declared(path: &Path) -> Vec<String> {
    let text = fs::read_to_string(path).expect("a source");
    let lines = text.lines().map(|line| line.trim_start_matches("pub "));
    let name = |line: &str| Some(line.strip_prefix("mod ")?.strip_suffix(';')?.to_string());
    lines.filter_map(name).collect()
}

/// What follows each `crate::` or `super::` of a file outside of comments, up to the end of the name.
fn named_after<'a>(text: &'a str, root: &'a str) -> impl Iterator<Item = &'a str> {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    let after = code.flat_map(move |line| line.split(root).skip(1));
    after.map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or(rest))
}

/// The module behind `own` in this order that a file names, if it does.
fn upward(text: &str, root: &str, order: &[String], own: usize) -> Option<String> {
    let later = |name: &&str| order.iter().position(|known| known == name) > Some(own);
    named_after(text, root).find(later).map(Into::into)
}

#[test]
fn each_room_knows_only_those_before_it_and_so_does_each_file_of_a_room() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let rooms = declared(&src.join("lib.rs"));
    assert!(rooms.len() > 7, "{rooms:?}");
    for (own, room) in rooms.iter().enumerate() {
        if src.join(room).with_extension("rs").exists() {
            continue;
        }
        let files = declared(&src.join(room).join("mod.rs"));
        for path in sources(&src.join(room)) {
            let text = fs::read_to_string(&path).expect("a source");
            for hidden in ["crate::{", "super::{", "super::super"] {
                assert!(!text.contains(hidden), "{}: {hidden} hides a name", path.display());
            }
            if let Some(name) = upward(&text, "crate::", &rooms, own) {
                panic!("{} names {name}, which comes after {room}", path.display());
            }
            let stem = path.file_stem().and_then(|stem| stem.to_str()).expect("a name");
            let Some(place) = files.iter().position(|file| file == stem) else {
                assert_eq!(stem, "mod", "{} is in no table of contents", path.display());
                continue;
            };
            if let Some(name) = upward(&text, "super::", &files, place) {
                panic!("{} names {name}, which comes after {stem}", path.display());
            }
            // A name that mod.rs hands on does not say where it stands; macros of the schema are for other rooms.
            let (code, own) =
                (text.split("#[cfg(test)]").next().unwrap_or(&text), format!("crate::{room}::"));
            let mut names = named_after(code, "super::").chain(named_after(code, &own));
            let handed_on =
                names.find(|name| name.starts_with(char::is_uppercase) && *name != "Result");
            let hides = code.contains(&format!("{own}{{"));
            assert!(
                (handed_on.is_none() && !hides) || room == "schema",
                "{}: {handed_on:?}",
                path.display()
            );
        }
    }
}

#[test]
fn no_file_is_long() {
    for path in sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src")) {
        let lines = fs::read_to_string(&path).expect("a source").lines().count();
        assert!(lines <= 300, "{} has {lines} lines", path.display());
    }
}

/// Searches know gains and costs, and of a robot nothing else.
#[test]
fn a_search_knows_no_robot() {
    let search = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/search");
    for path in sources(&search) {
        let text = fs::read_to_string(&path).expect("a source");
        for line in text.lines().filter(|line| line.contains("crate::robot")) {
            assert_eq!(line, "use crate::robot::Gains;", "{}", path.display());
        }
    }
}

#[test]
fn only_the_boundaries_know_javascript_a_clock_or_ambient_chance() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = sources(&src);
    assert!(files.len() > 10);
    let boundaries = ["wasm", "bytes"].map(|room| src.join(room));
    for path in files.iter().filter(|path| boundaries.iter().all(|room| !path.starts_with(room))) {
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
            "HashMap",
            "HashSet",
            "std::env",
            "std::thread",
        ] {
            assert!(!text.contains(word), "{} names {word}", path.display());
        }
    }
}

#[test]
fn every_file_of_tests_is_in_the_one_program() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let program = fs::read_to_string(tests.join("all.rs")).expect("the program");
    let mut found = 0;
    for path in sources(&tests) {
        let text = fs::read_to_string(&path).expect("a source");
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
        if !["\n#[test]", "\n#[wasm_bindgen_test"].iter().any(|mark| text.contains(mark))
            || name == "panics.rs"
        {
            continue;
        }
        found += 1;
        assert!(program.contains(&format!("#[path = \"{name}\"]")), "tests/all.rs lacks {name}");
    }
    assert!(found > 10);
}
