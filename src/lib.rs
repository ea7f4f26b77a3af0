//! Evolutionary programming finds the gains of a mobile robot's posture controller.
//!
//! The model is that of J.-H. Kim and H.-S. Shim, "Evolutionary Programming-Based Optimal Robust Locomotion Control of
//! Autonomous Mobile Robots" (1995); numbers in parentheses are the equations of that paper. Where the paper leaves
//! something open, the documentation says that the choice is ours.
//!
//! Rooms in reading order. Each knows only those before it, and so does each file of a room (`tests/architecture.rs`):
//!
//! | room | what it holds | what is always so there |
//! |---|---|---|
//! | [`schema`] | what is known outside of Rust: names, units, ranges, words, descriptions, and the types that are told of them | each stands once; nothing here knows a robot, or calls JavaScript |
//! | [`number`] | the scalar, small arcs, two robots in one SIMD register, streams of random numbers | the same bits on every machine |
//! | [`robot`] | posture, arc, error posture (1)–(4), gains, law (5), limits, disturbance | written once, for one robot or several side by side |
//! | [`theory`] | Lyapunov functions (Theorem 1), Theorem 2 (6)–(8) | formulas of the paper; nothing drives |
//! | [`search`] | evolutionary programming and its rivals | knows gains and costs, no robot; a generation depends on where the search stands, its number and the seed alone |
//! | [`run`] | experiment, presets, cost (9), one run, many runs at once | an experiment is checked once, in [`run::Setting::new`]; `run/work.rs` says what a call may cost |
//! | [`study`] | history, landscape, robustness, seeds, contests of methods, starts, stability, remaining error | every job of many runs can be split by index without changing a bit |
//! | [`outside`] | what can be asked from outside, and its types | one table of calls, read in one way for every language |
//! | `wasm` | the same for JavaScript | the only room that calls it |
//! | `bytes` | the same for whoever runs WebAssembly elsewhere, such as Python | imports nothing |
//!
//! ```
//! use ep_locomotion::robot::Gains;
//! use ep_locomotion::run::{Preset, Setting};
//! use ep_locomotion::study::Evolution;
//!
//! let setting = Setting::new(Preset::VelocityLimits.experiment())?;
//! let by_hand = setting.cost(&Gains::new(10.0, 10.0, 10.0)).total();
//!
//! let mut evolution = Evolution::new(setting);
//! for _ in 0..30 {
//!     evolution.step();
//! }
//! assert!(evolution.newest().best.cost < by_hand);
//! # Ok::<(), ep_locomotion::schema::InvalidInput>(())
//! ```
//!
//! What holds everywhere:
//!
//! - The science knows no clock, no global state and no chance but its seeds.
//! - The same experiment gives the same bits natively, on x86-64 and aarch64, and in every WebAssembly engine: sums are in a
//!   fixed order, and every function beyond + − × ÷ √ comes from `libm` (`clippy.toml`).
//! - Each control law stands once in the source, generic over [`number::Real`].
//! - An error names the field, what it must be and what it was.

#![deny(unsafe_code)]
#![warn(missing_docs)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

pub mod schema;

pub mod number;

pub mod robot;

pub mod theory;

pub mod search;

pub mod run;

pub mod study;

pub mod outside;

#[cfg(all(target_arch = "wasm32", feature = "javascript"))]
#[allow(unsafe_code)] // wasm-bindgen writes some
pub mod wasm;

#[cfg(all(target_arch = "wasm32", feature = "bytes"))]
#[allow(unsafe_code)] // names that are called from outside
pub mod bytes;
