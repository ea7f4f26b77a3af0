//! The tests as WebAssembly: one program, because each takes longer to link than to run. Not tests/panics.rs, which loses the instance.
#![cfg(target_arch = "wasm32")]

#[path = "boundary.rs"]
pub mod boundary;
#[path = "episodes.rs"]
pub mod episodes;
#[path = "evolution.rs"]
pub mod evolution;
#[path = "golden.rs"]
pub mod golden;
#[path = "hostile.rs"]
pub mod hostile;
#[path = "lanes_and_survey.rs"]
pub mod lanes_and_survey;
#[path = "motion_and_law.rs"]
pub mod motion_and_law;
#[path = "remaining.rs"]
pub mod remaining;
#[path = "stability.rs"]
pub mod stability;
