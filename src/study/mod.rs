//! Studies: what many runs show of the gains, the starts, the seeds and the law.

mod part;

mod starts;

mod landscape;

mod robustness;

mod hash;

mod history;

mod searches;

mod seeds;

mod trials;

mod stability;

mod remaining;

pub use history::Evolution;
pub use landscape::{Axis, Gain, Landscape};
pub use remaining::{
    PartsSample, RemainingError, check_error_parts, error_parts, remaining_errors,
};
pub use robustness::{fares, robustness};
pub use seeds::{SeedRun, SeedRuns, seed_runs};
pub use stability::{Stability, StabilitySample};
pub use starts::{Circle, Grid, MAX_AXIS_COUNT, Range, StartGrid};
pub use trials::{Champion, Trial, Trials, trials};
