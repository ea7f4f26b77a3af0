//! What one call may cost: the one place that says so.

use super::experiment::Experiment;
use crate::schema::InvalidInput;

/// Most samples that one call may have to drive: robots × starts × samples. It bounds how long a call can take.
pub const MAX_WORK: f64 = 4e8;

/// Most bytes that what a call gives back may take.
pub const MAX_BYTES: f64 = 256.0 * 1024.0 * 1024.0;

/// Something that a call does many times.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Work<'a> {
    /// Of what the call has too many, if it has.
    pub(crate) field: &'a str,
    /// How many times.
    pub(crate) count: f64,
    /// From how many starts each time.
    pub(crate) starts: usize,
    /// How many bytes remain of each time until the end of the call.
    pub(crate) bytes: f64,
}

impl Work<'_> {
    /// Refuses what takes more than [`MAX_WORK`] samples or [`MAX_BYTES`] bytes.
    pub(crate) fn check(self, e: &Experiment) -> Result<(), InvalidInput> {
        let Self { field, count, starts, bytes } = self;
        let one = starts.max(1) as f64 * (e.horizon / e.sample_time).max(1.0);
        let refuse = |expected| Err(InvalidInput::new(field, expected, format!("{count}")));
        if count * one > MAX_WORK {
            let (most, starts) = ((MAX_WORK / one).floor(), starts.max(1));
            let samples = e.samples();
            return refuse(format!(
                "at most {most} with {starts} starts and {samples} samples a run"
            ));
        }
        if count * bytes > MAX_BYTES {
            let most = (MAX_BYTES / bytes).floor();
            return refuse(format!("at most {most}, for each takes {bytes} bytes"));
        }
        Ok(())
    }
}
