//! An experiment that is ready to be driven.

use super::cost::Cost;
use super::experiment::Experiment;
use super::rules::{Outcome, Robot, Rules};
use crate::robot::{Frame, Gains, Posture, Velocity};
use crate::schema::{Allowed, Result};

/// An experiment that was validated and is ready to be driven.
#[derive(Clone, Debug)]
pub struct Setting {
    experiment: Experiment,
    rules: Rules,
    samples: u32,
    /// The frame of the goal.
    goal: Frame,
}

impl Setting {
    /// Validates an experiment; the error names the field that is wrong, or what a generation is too large for
    /// ([`MAX_WORK`](super::MAX_WORK)).
    pub fn new(experiment: Experiment) -> Result<Self> {
        experiment.validate()?;
        experiment.check_generation()?;
        let (samples, rules) = (experiment.samples(), Rules::new(&experiment));
        Ok(Self { rules, samples, goal: Frame::new(experiment.goal), experiment })
    }

    /// The experiment.
    pub fn experiment(&self) -> &Experiment {
        &self.experiment
    }

    /// Which indices the start postures have.
    pub fn start_indices(&self) -> Allowed {
        Allowed::whole(0, self.experiment.starts.len() as u32 - 1)
    }

    /// Samples until the horizon.
    pub(crate) fn samples(&self) -> u32 {
        self.samples
    }

    /// The bytes of so many numbers of each sample of a whole run.
    pub(crate) fn bytes_of_columns(&self, count: usize) -> f64 {
        (count * size_of::<f64>()) as f64 * (f64::from(self.samples) + 1.0)
    }

    /// What every sample needs.
    pub(crate) fn rules(&self) -> Rules {
        self.rules
    }

    /// A robot at rest at this posture.
    pub(crate) fn robot_at(&self, start: Posture) -> Robot<f64> {
        Robot::at_rest(start.error_to(self.experiment.goal))
    }

    /// The frame of the reference at sample `n`.
    #[inline]
    pub(crate) fn frame_at(&self, n: u32) -> Frame {
        let Experiment { goal, reference_velocity, sample_time, .. } = self.experiment;
        if self.rules.is_parking() {
            return self.goal;
        }
        Frame::new(goal.advance(reference_velocity, f64::from(n) * sample_time))
    }

    /// How a run has ended at sample `n`, if it has.
    #[inline(always)]
    pub(crate) fn outcome(&self, robot: &Robot<f64>, n: u32) -> Option<Outcome> {
        let horizon = (n >= self.samples).then_some(Outcome::Horizon);
        self.rules.end(robot).or(horizon)
    }

    /// Time of sample `n`, where a run ended with `outcome`: t_f.
    pub(crate) fn final_time(&self, outcome: Option<Outcome>, n: u32) -> f64 {
        match outcome {
            Some(Outcome::Horizon) => self.experiment.horizon,
            _ => f64::from(n) * self.experiment.sample_time,
        }
    }

    /// J of a robot that is at sample `n`, in parts.
    pub(crate) fn cost_at(
        &self,
        robot: &Robot<f64>,
        gains: &Gains,
        n: u32,
        outcome: Option<Outcome>,
    ) -> Cost {
        let e = &self.experiment;
        let [path, energy] = self.paid(robot.path, robot.energy);
        let cost = Cost {
            time: self.final_time(outcome, n),
            final_error: e.weights.final_error(&robot.error, &self.frame_at(n)),
            path,
            energy,
            penalty: e.weights.penalty(gains),
        };
        if outcome == Some(Outcome::Diverged) {
            return Cost { final_error: f64::INFINITY, ..cost }.without_nan();
        }
        cost.without_nan()
    }

    /// What the path and the energy cost, from their sums; infinite where a sum is not a number.
    #[inline]
    pub(crate) fn paid(&self, path: f64, energy: Velocity) -> [f64; 2] {
        let half_dt = 0.5 * self.experiment.sample_time;
        let [rv, rw] = self.experiment.weights.velocity;
        let paid = [half_dt * path, half_dt * (rv * energy.linear + rw * energy.angular)];
        paid.map(|part| if part.is_nan() { f64::INFINITY } else { part })
    }
}
