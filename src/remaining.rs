//! The error that remains under a disturbance, beside the sets that Theorem 2 describes.

use crate::control::Gains;
use crate::episode::{Outcome, Sample, Setting};
use crate::fields::{InvalidInput, shown};
use crate::posture::{ErrorPosture, Velocity};

/// The three sizes of an error posture that Theorem 2 bounds one by one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorParts {
    /// |x_e cos θ_e| in metres.
    pub x: f64,
    /// |y_e| in metres.
    pub y: f64,
    /// |sin θ_e|, without a unit.
    pub theta: f64,
}

impl ErrorParts {
    /// The parts of an error posture.
    pub fn new(e: &ErrorPosture) -> Self {
        Self { x: (e.x * e.cos).abs(), y: e.y.abs(), theta: e.sin.abs() }
    }

    /// The larger of each part.
    fn max(self, other: Self) -> Self {
        Self { x: self.x.max(other.x), y: self.y.max(other.y), theta: self.theta.max(other.theta) }
    }

    const ZERO: Self = Self { x: 0.0, y: 0.0, theta: 0.0 };
    const INFINITE: Self = Self { x: f64::INFINITY, y: f64::INFINITY, theta: f64::INFINITY };
}

/// How far the sets reach in which a part of V̇ can be 0 or more although |δ1| ≤ ε1 and |δ2| ≤ ε2.
///
/// They are Theorem 2's inequalities solved for the error: |x_e cos θ_e| ≤ ε1 / kx (6),
/// |y_e|³ ≤ ε1 |sin θ_e| / ky (7), |sin θ_e| ≤ ε2 / kθ (8). The one of y_e depends on the heading, so it is that for
/// `sin` = sin θ_e. Outside all three, V̇ < 0 for the law (5) without limits and in continuous time; outside one of them
/// only its own part is negative. A gain that is not over 0 makes no part negative: its set has no end.
pub fn theorem_2_sets(k: &Gains, bound: Velocity, sin: f64) -> ErrorParts {
    let quotient = |push: f64, gain: f64| if gain > 0.0 { push / gain } else { f64::INFINITY };
    let [e1, e2] = [bound.linear.abs(), bound.angular.abs()];
    ErrorParts {
        x: quotient(e1, k.x),
        y: libm::cbrt(quotient(e1 * sin.abs(), k.y)),
        theta: quotient(e2, k.theta),
    }
}

/// The parts of the error at one sample of a run, and how far the sets reach there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartsSample {
    /// t in seconds.
    pub time: f64,
    /// The parts of the error.
    pub error: ErrorParts,
    /// The sets of [`theorem_2_sets`], for the disturbance of the experiment.
    pub sets: ErrorParts,
}

/// The parts of the error of a run from the start posture with this index, sample by sample.
pub fn error_parts(setting: &Setting, gains: &Gains, start: u32) -> Vec<PartsSample> {
    let bound = setting.experiment().disturbance.bound();
    let parts = |sample: Sample| PartsSample {
        time: sample.time,
        error: match sample.outcome {
            Some(Outcome::Diverged) => ErrorParts::INFINITE,
            _ => ErrorParts::new(&sample.error),
        },
        sets: theorem_2_sets(gains, bound, sample.error.sin),
    };
    setting.episode(*gains, start).samples().map(parts).collect()
}

/// The largest parts of the error in the last seconds of a run, and how far the sets reached then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RemainingError {
    /// The largest of each part.
    pub error: ErrorParts,
    /// The farthest reach of each set.
    pub sets: ErrorParts,
}

/// What remains of the error of a robot in the last `seconds` of its run, for each start posture of the experiment.
///
/// A robot that arrives stops there; in an experiment whose tolerances are 0 it goes on to the horizon. The error names
/// the range of `seconds`, or says that the work is too much for one call.
pub fn remaining_errors(
    setting: &Setting,
    gains: &Gains,
    seconds: f64,
) -> Result<Vec<RemainingError>, InvalidInput> {
    let experiment = setting.experiment();
    if !(0.0..=experiment.horizon).contains(&seconds) {
        let expected = format!("a number from 0 to the horizon of {} s", experiment.horizon);
        return Err(InvalidInput::new("seconds", expected, shown(seconds)));
    }
    experiment.validate_work("the number of starts", 1)?;
    let starts = 0..experiment.starts.len() as u32;
    Ok(starts.map(|start| remaining(&error_parts(setting, gains, start), seconds)).collect())
}

fn remaining(run: &[PartsSample], seconds: f64) -> RemainingError {
    let first = run.last().map_or(0.0, |last| last.time - seconds);
    let none = RemainingError { error: ErrorParts::ZERO, sets: ErrorParts::ZERO };
    run.iter().filter(|sample| sample.time >= first).fold(none, |largest, sample| RemainingError {
        error: largest.error.max(sample.error),
        sets: largest.sets.max(sample.sets),
    })
}
