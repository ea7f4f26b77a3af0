//! Runs: the experiment that defines them, what happens in a sample, one run, and many at once.
//!
//! An experiment is checked once, in [`Setting::new`]. What one call may cost is bounded in `work.rs`.

mod cost;

mod experiment;

mod presets;

mod work;

mod rules;

mod setting;

mod episode;

mod trajectory;

mod runs;

mod side_by_side;

mod team;

mod convoy;

pub use cost::{Cost, Weights};
pub use episode::{Episode, Sample};
pub use experiment::{Experiment, MAX_SAMPLES, MAX_STARTS, Tolerance};
pub use presets::{PAPER_RESULTS, PaperMethod, PaperResult, Preset};
pub use rules::Outcome;
pub use runs::RunEnd;
pub use setting::Setting;
pub use trajectory::{Run, RunSample};
pub use work::{LEAST_GENERATION, LEAST_SAMPLES, MAX_BYTES, MAX_WORK};

#[cfg(all(target_arch = "wasm32", feature = "javascript"))]
// elsewhere an episode keeps its setting
pub(crate) use episode::EpisodeState;
pub(crate) use runs::Departure;
pub(crate) use work::{BYTES_OF_AN_OBJECT, check_bytes, check_bytes_beside};
