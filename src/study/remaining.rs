//! The error that remains under a disturbance, beside the sets that Theorem 2 describes.

use crate::robot::Gains;
use crate::run::{Outcome, Sample, Setting, check_bytes};
use crate::schema::{Columns, InvalidInput, Plain, Result, Text, told};
use crate::theory::{ErrorSizes, theorem_2_sets};

/// The parts of the error at one sample of a run, and how far the sets reach there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartsSample {
    /// t in seconds.
    pub time: f64,
    /// The parts of the error.
    pub error: ErrorSizes,
    /// The sets of [`theorem_2_sets`], for the disturbance of the experiment.
    pub sets: ErrorSizes,
}

told! {
    /// The sizes of the error of one run over time that Theorem 2 bounds one by one: one value a sample.
    ErrorParts: Columns<PartsSample> {
        /// Seconds.
        "time" => |run| run.column(|sample| sample.time),
        /// |x_e cos θ_e| in metres.
        "x" => |run| run.column(|sample| sample.error.x),
        /// |y_e| in metres.
        "y" => |run| run.column(|sample| sample.error.y),
        /// |sin θ_e|.
        "theta" => |run| run.column(|sample| sample.error.theta),
        /// How far the set of |y_e| reaches at this heading, (ε1 |sin θ_e| / ky)^⅓ in metres (7). The theorem is about the law (5) alone.
        "ySet" => |run| run.column(|sample| sample.sets.y),
    }
}

/// The columns of that table.
const COLUMNS: usize = Columns::<PartsSample>::KEYS.len();

/// Refuses to tell the parts of the error of more runs than fit in the memory.
pub fn check_error_parts(setting: &Setting) -> Result<()> {
    check_starts(setting, setting.bytes_of_columns(COLUMNS))
}

fn check_starts(setting: &Setting, bytes_of_each: f64) -> Result<()> {
    let (what, count) = ("the number of starts", setting.experiment().starts.len() as f64);
    setting.experiment().check_drives(what, count, 1)?;
    check_bytes(what, count, bytes_of_each)
}

/// The parts of the error of a run from the start posture with this index, sample by sample.
///
/// # Panics
/// If there is no such start posture.
pub fn error_parts(setting: &Setting, gains: &Gains, start: u32) -> Vec<PartsSample> {
    let bound = setting.experiment().disturbance.bound();
    let parts = |sample: Sample| PartsSample {
        time: sample.time,
        error: match sample.outcome {
            Some(Outcome::Diverged) => ErrorSizes::INFINITE,
            _ => ErrorSizes::new(&sample.error),
        },
        sets: theorem_2_sets(gains, bound, sample.error.sin),
    };
    setting.episode(*gains, start).samples().map(parts).collect()
}

/// The largest parts of the error in the last seconds of a run, and how far the sets reached then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RemainingError {
    /// The largest of each part.
    pub error: ErrorSizes,
    /// The farthest reach of each set.
    pub sets: ErrorSizes,
}

told! {
    /// |x_e cos θ_e| and |y_e| in metres, |sin θ_e|: one value for each start.
    PartsOfStarts: Columns<ErrorSizes> {
        /// |x_e cos θ_e| in metres.
        "x" => |starts| starts.column(|sizes| sizes.x),
        /// |y_e| in metres.
        "y" => |starts| starts.column(|sizes| sizes.y),
        /// |sin θ_e|.
        "theta" => |starts| starts.column(|sizes| sizes.theta),
    }
}

told! {
    /// What remains of the error at the end of each run, beside the sets of Theorem 2.
    RemainingErrors: Columns<RemainingError> {
        /// The largest in the last seconds; Infinity for a robot that left the finite numbers.
        "error" => |all| Columns(all.0.iter().map(|one| one.error).collect()),
        /// How far the sets reach, ε1/kx (6), (ε1 |sin θ_e| / ky)^⅓ (7) and ε2/kθ (8); of (7) the farthest in the last seconds.
        /// The theorem is about the law (5) alone.
        "sets" => |all| Columns(all.0.iter().map(|one| one.sets).collect()),
    }
}

/// What remains of the error of a robot in the last `seconds` of its run, for each start posture of the experiment.
///
/// A robot that arrives stops there; in an experiment whose tolerances are 0 it goes on to the horizon. The error names
/// the range of `seconds`, or says that the work is too much for one call.
pub fn remaining_errors(
    setting: &Setting,
    gains: &Gains,
    seconds: f64,
) -> Result<Vec<RemainingError>> {
    let experiment = setting.experiment();
    if !(0.0..=experiment.horizon).contains(&seconds) {
        let expected = Text::from("a number from 0 to the horizon of ") + experiment.horizon + " s";
        return Err(InvalidInput::new("seconds", expected, seconds));
    }
    check_starts(setting, size_of::<[RemainingError; 2]>() as f64)?;
    let starts = 0..experiment.starts.len() as u32;
    Ok(starts.map(|start| remaining(&error_parts(setting, gains, start), seconds)).collect())
}

fn remaining(run: &[PartsSample], seconds: f64) -> RemainingError {
    let first = run.last().map_or(0.0, |last| last.time - seconds);
    let none = RemainingError { error: ErrorSizes::ZERO, sets: ErrorSizes::ZERO };
    run.iter().filter(|sample| sample.time >= first).fold(none, |largest, sample| RemainingError {
        error: largest.error.max(sample.error),
        sets: largest.sets.max(sample.sets),
    })
}
