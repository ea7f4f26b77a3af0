//! What one call may cost: the one place that says so.

use super::experiment::Experiment;
use crate::number::Real;
use crate::schema::{InvalidInput, Text};

/// Most samples that one call may have to drive: robots × starts × samples. It bounds how long a call can take.
pub const MAX_WORK: f64 = 4e8;

/// A run counts as so many samples at least: to draw its gains, to begin it and to tell how it ended takes that long.
pub const LEAST_SAMPLES: f64 = 20.0;

/// A generation counts as so many samples at least.
pub const LEAST_GENERATION: f64 = 400.0;

/// Most bytes that what a call gives back may take.
pub const MAX_BYTES: f64 = 256.0 * 1024.0 * 1024.0;

/// What a plain object takes outside, with its columns, beside the numbers in them.
pub(crate) const BYTES_OF_AN_OBJECT: f64 = 2048.0;

/// The field that is refused where no other can be small enough.
pub(crate) const STARTS: &str = "starts";

/// Something that a call does many times.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Work<'a> {
    /// Of what the call has too many, if it has; [`STARTS`] where its number is not to choose.
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
        self.check_each(e, e.work_from(self.starts))
    }

    /// The same for new solutions of a search, which does more than to drive.
    pub(crate) fn check_solutions(self, e: &Experiment) -> Result<(), InvalidInput> {
        self.check_each(e, e.work_of_a_solution())
    }

    fn check_each(self, e: &Experiment, one: f64) -> Result<(), InvalidInput> {
        let Self { field, count, starts, bytes } = self;
        let refuse = |expected: Text| Err(InvalidInput::new(field, expected, count));
        if count * one > MAX_WORK {
            let (most, samples) = ((MAX_WORK / one).floor(), e.samples());
            let least = if field == STARTS { count } else { 1.0 };
            if most < least {
                // Only fewer starts help.
                let most = (MAX_WORK * starts as f64 / (least * one)).floor();
                let expected = Text::from("at most ") + most + " postures with ";
                let expected = expected + format!("{samples} samples a run");
                return Err(InvalidInput::new(STARTS, expected, format!("{starts}")));
            }
            let starts = if starts > 1 { format!("{starts} starts") } else { "1 start".into() };
            let most = Text::from("at most ") + most;
            return refuse(most + format!(" with {starts} and {samples} samples a run"));
        }
        if count * bytes > MAX_BYTES {
            let most = (MAX_BYTES / bytes).floor();
            return refuse(Text::from("at most ") + most + ", for each takes " + bytes + " bytes");
        }
        Ok(())
    }
}

impl Experiment {
    /// What a new solution of the search takes, in samples. Where it is not the driving that takes longest, it is the bouts (one
    /// takes as long as half a sample, and beside each there is a parent), or the generation about it.
    pub(crate) fn work_of_a_solution(&self) -> f64 {
        let bouts = f64::from(self.evolution.bouts());
        let generation = LEAST_GENERATION / f64::from(self.evolution.most_solutions());
        self.work_from(self.starts.len()).at_least(bouts).at_least(generation)
    }

    fn work_from(&self, starts: usize) -> f64 {
        starts.max(1) as f64 * (self.horizon / self.sample_time).at_least(LEAST_SAMPLES)
    }
}
