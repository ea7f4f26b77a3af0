//! Evolutionary programming finds the gains of a mobile robot's posture controller.
//!
//! The model is that of J.-H. Kim and H.-S. Shim, "Evolutionary Programming-Based Optimal Robust Locomotion Control of
//! Autonomous Mobile Robots" (1995); numbers in parentheses are the equations of that paper. Where the paper leaves
//! something open, the documentation says that the choice is ours.
//!
//! Modules in reading order:
//!
//! - [`posture`]: postures, velocities, the motion along an arc (2), the error posture (3) and its rate (4)
//! - [`control`]: gains, the control law (5), the rule it improves on, Lyapunov functions, Theorem 2 (6)–(8)
//! - [`limits`], [`disturbance`]: what becomes of a command on its way to the wheels
//! - [`cost`]: the cost J (9) in its parts
//! - [`experiment`], [`fields`]: everything that defines a run, the presets; the allowed range of every number
//! - [`episode`]: one run of one robot
//! - [`stability`]: the Lyapunov function along a run, as promised and as it is
//! - [`remaining`]: the error that remains under a disturbance, and the sets of Theorem 2
//! - `lanes`, [`convoy`]: the numbers of two robots in one SIMD register; many runs at once, with the same law and bits
//! - [`evolution`]: mutation, tournament, one generation, the whole run
//! - [`starts`]: start postures on a circle and on a grid
//! - [`survey`]: many gains, many starts, many seeds in one call
//! - `wasm`: the same for JavaScript
//!
//! ```
//! use ep_locomotion::control::Gains;
//! use ep_locomotion::episode::Setting;
//! use ep_locomotion::evolution::Evolution;
//! use ep_locomotion::experiment::Preset;
//!
//! let experiment = Preset::VelocityLimits.experiment();
//! let setting = Setting::new(experiment.clone())?;
//! let by_hand = setting.cost(&Gains::new(10.0, 10.0, 10.0)).total();
//!
//! let mut evolution = Evolution::new(experiment)?;
//! for _ in 0..30 {
//!     evolution.step();
//! }
//! assert!(evolution.newest().best.cost < by_hand);
//! # Ok::<(), ep_locomotion::fields::InvalidInput>(())
//! ```
//!
//! What holds everywhere:
//!
//! - The science knows no clock, no global state and no chance but its seeds; only `wasm` knows JavaScript.
//! - The same experiment gives the same bits natively, on x86-64 and aarch64, and in every WebAssembly engine: sums are in a
//!   fixed order, and every function beyond + − × ÷ √ comes from `libm`.
//! - There is one control law in the source, generic over [`real::Real`].
//! - Input is checked once, in [`episode::Setting::new`]; an error names the field, what it must be and what it was.

#![deny(unsafe_code)]
#![warn(missing_docs)]

pub mod real;

pub mod posture;

pub mod control;

pub mod disturbance;
pub mod limits;

pub mod cost;

pub mod experiment;
pub mod fields;

pub mod episode;

pub mod remaining;
pub mod stability;

pub mod convoy;
mod lanes;

pub mod evolution;

pub mod starts;
pub mod survey;

mod random;
mod words;

#[cfg(target_arch = "wasm32")]
#[allow(unsafe_code)] // wasm-bindgen writes some
pub mod wasm;
