//! What one call may cost: the bounds. What one of something takes stands beside it.

use super::experiment::Experiment;
use crate::number::Real;
use crate::schema::{InvalidInput, Result, Text};

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

/// Refuses so many of something if what remains of them until the end of the call takes more than [`MAX_BYTES`].
pub(crate) fn check_bytes(what: &str, count: f64, bytes_of_each: f64) -> Result<()> {
    check_bytes_beside(0.0, what, count, bytes_of_each)
}

/// The same where so many bytes are taken by something else.
pub(crate) fn check_bytes_beside(taken: f64, what: &str, count: f64, each: f64) -> Result<()> {
    let room = MAX_BYTES - taken;
    if count * each > room {
        let most = (room / each).floor();
        let expected = Text::from("at most ") + most + ", for each takes " + each + " bytes";
        return Err(InvalidInput::new(what, expected, count));
    }
    Ok(())
}

impl Experiment {
    /// Refuses so many drives, each of them from so many starts, if they take more than [`MAX_WORK`] samples.
    pub(crate) fn check_drives(&self, what: &str, count: f64, starts: usize) -> Result<()> {
        self.check_work(what, count, starts, self.work_from(starts))
    }

    /// The same for new solutions of a search, which does more than to drive them from all starts.
    pub(crate) fn check_solutions(&self, what: &str, count: f64) -> Result<()> {
        self.check_work(what, count, self.starts.len(), self.work_of_a_solution())
    }

    /// The same for so many generations of a search.
    pub(crate) fn check_generations(&self, count: u32) -> Result<()> {
        let each = self.work_of_a_solution() * f64::from(self.evolution.most_solutions());
        self.check_work("generations", count.into(), self.starts.len(), each)
    }

    /// Refuses a search if one of its generations takes more than [`MAX_WORK`] samples.
    pub(super) fn check_generation(&self) -> Result<()> {
        let (count, starts) = (f64::from(self.evolution.most_solutions()), self.starts.len());
        // A population can be smaller; else only fewer starts help.
        let work = f64::from(self.evolution.least_solutions()) * self.work_from(starts);
        if work > MAX_WORK {
            let most = (MAX_WORK * starts as f64 / work).floor();
            let expected = Text::from("at most ") + most + " postures with ";
            let expected = expected + format!("{} samples a run", self.samples());
            return Err(InvalidInput::new("starts", expected, format!("{starts}")));
        }
        self.check_drives("evolution.population", count, starts)
    }

    fn check_work(&self, what: &str, count: f64, starts: usize, work_of_each: f64) -> Result<()> {
        if count * work_of_each > MAX_WORK {
            let (most, samples) = ((MAX_WORK / work_of_each).floor(), self.samples());
            let starts = if starts > 1 { format!("{starts} starts") } else { "1 start".into() };
            let expected = Text::from("at most ") + most;
            let expected = expected + format!(" with {starts} and {samples} samples a run");
            return Err(InvalidInput::new(what, expected, count));
        }
        Ok(())
    }

    /// What a new solution of the search takes, in samples. Where it is not the driving that takes longest, it is the bouts (one
    /// takes as long as half a sample, and beside each there is a parent), or the generation about it.
    pub(crate) fn work_of_a_solution(&self) -> f64 {
        let bouts = f64::from(self.evolution.bouts());
        let generation = LEAST_GENERATION / f64::from(self.evolution.most_solutions());
        self.work_from(self.starts.len()).at_least(bouts).at_least(generation)
    }

    fn work_from(&self, starts: usize) -> f64 {
        starts as f64 * (self.horizon / self.sample_time).at_least(LEAST_SAMPLES)
    }
}
