//! One run of one robot: commanded, limited, moved, and paid for, sample by sample.

use serde::Serialize;

use crate::control::{Gains, Law, lyapunov, lyapunov_rate};
use crate::cost::Cost;
use crate::disturbance::DisturbanceSequence;
use crate::experiment::{Experiment, Tolerance};
use crate::fields::{InvalidInput, shown};
use crate::limits::Limits;
use crate::posture::{Arc, ErrorPosture, Posture, Velocity, wrap};
use crate::real::{Real, SMALL_TURN};

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// The robot came within the tolerances of the goal.
    Arrived,
    /// The horizon was reached.
    Horizon,
    /// The robot left the finite numbers, as it can without limits.
    Diverged,
}

/// An experiment that was validated and is ready to be driven.
#[derive(Clone, Debug)]
pub struct Setting {
    experiment: Experiment,
    rules: Rules,
    samples: u32,
}

/// What every sample needs of an experiment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rules {
    law: Law,
    reference_velocity: Velocity,
    /// How the reference moves in one sample, if it does.
    reference_arc: Option<Arc<f64>>,
    limits: Limits,
    pub(crate) sample_time: f64,
    /// The largest (x_e² + y_e², |θ_e|) that counts as arrived; none if the reference moves.
    pub(crate) arrival: Option<[f64; 2]>,
}

/// What a robot carries from one sample to the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Robot<S> {
    pub(crate) error: ErrorPosture<S>,
    /// The velocity applied during the sample before.
    pub(crate) velocity: Velocity<S>,
    /// Σ (p − p_r)ᵀ(p − p_r), still without ½ dt.
    pub(crate) path: S,
    /// Σ v² and Σ ω², still without R and ½ dt.
    pub(crate) energy: Velocity<S>,
}

/// What happened to a robot between two samples.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step<S> {
    pub(crate) command: Velocity<S>,
    pub(crate) arc: Arc<S>,
    pub(crate) next: Robot<S>,
}

impl Robot<f64> {
    pub(crate) fn at_rest(error: ErrorPosture) -> Self {
        Self { error, velocity: Velocity::ZERO, path: 0.0, energy: Velocity::ZERO }
    }

    /// The same robot in every lane.
    pub(crate) fn splat<S: Real>(&self) -> Robot<S> {
        Robot {
            error: self.error.splat(),
            velocity: self.velocity.splat(),
            path: S::splat(self.path),
            energy: self.energy.splat(),
        }
    }
}

impl Setting {
    /// Validates an experiment; the error names the field that is wrong.
    pub fn new(experiment: Experiment) -> Result<Self, InvalidInput> {
        experiment.validate()?;
        let samples = experiment.samples();
        Ok(Self { rules: Rules::new(&experiment), experiment, samples })
    }

    /// The experiment.
    pub fn experiment(&self) -> &Experiment {
        &self.experiment
    }

    /// Checks that a start posture with this index exists.
    pub fn validate_start(&self, start: f64) -> Result<u32, InvalidInput> {
        let last = self.experiment.starts.len() - 1;
        if start.fract() == 0.0 && (0.0..=last as f64).contains(&start) {
            Ok(start as u32)
        } else {
            Err(InvalidInput::new(
                "start",
                format!("a whole number from 0 to {last}"),
                shown(start),
            ))
        }
    }

    /// A run with these gains from the start posture with this index, which must exist.
    pub fn episode(&self, gains: Gains, start: u32) -> Episode<'_> {
        Episode::new(self, gains, start)
    }

    /// Samples until the horizon.
    pub(crate) fn samples(&self) -> u32 {
        self.samples
    }

    /// What every sample needs.
    pub(crate) fn rules(&self) -> Rules {
        self.rules
    }

    /// A robot at rest at this posture.
    pub(crate) fn robot_at(&self, start: Posture) -> Robot<f64> {
        Robot::at_rest(start.error_to(self.experiment.goal))
    }

    /// The reference posture at sample `n`.
    fn reference_at(&self, n: u32) -> Posture {
        let Experiment { goal, reference_velocity, sample_time, .. } = self.experiment;
        goal.advance(reference_velocity, f64::from(n) * sample_time)
    }

    /// How a run has ended at sample `n`, if it has.
    #[inline(always)]
    pub(crate) fn outcome(&self, error: &ErrorPosture, n: u32) -> Option<Outcome> {
        let horizon = (n >= self.samples).then_some(Outcome::Horizon);
        self.rules.end(error).or(horizon)
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
        let half_dt = 0.5 * e.sample_time;
        let [rv, rw] = e.weights.velocity;
        let cost = Cost {
            time: self.final_time(outcome, n),
            final_error: e.weights.final_error(&robot.error, self.reference_at(n).theta),
            path: half_dt * robot.path,
            energy: half_dt * (rv * robot.energy.linear + rw * robot.energy.angular),
            penalty: e.weights.penalty(gains),
        };
        if outcome == Some(Outcome::Diverged) {
            return Cost { final_error: f64::INFINITY, ..cost }.without_nan();
        }
        cost.without_nan()
    }
}

impl Rules {
    fn new(e: &Experiment) -> Self {
        let Tolerance { position, heading } = e.tolerance;
        let tracking = e.is_tracking();
        Self {
            law: e.law,
            reference_velocity: e.reference_velocity,
            reference_arc: tracking.then(|| Arc::new(e.reference_velocity, e.sample_time)),
            limits: e.limits,
            sample_time: e.sample_time,
            arrival: (!tracking).then_some([position * position, heading]),
        }
    }

    /// The same rules where they are those of parking by the law (5) with limits of both velocities, which allow small
    /// turns only, and of both accelerations or none. All that is then known is a constant, so that the compiler leaves
    /// out the rest.
    #[inline(always)]
    pub(crate) fn parking<const ACCELERATION: bool>(&self) -> Option<Self> {
        let limits = match self.limits {
            Limits {
                speed: Some(speed),
                turn_rate: Some(turn_rate),
                acceleration,
                turn_acceleration,
            } if turn_rate * self.sample_time < SMALL_TURN => {
                let (speed, turn_rate) = (Some(speed), Some(turn_rate));
                match (acceleration, turn_acceleration) {
                    (None, None) if !ACCELERATION => Limits { speed, turn_rate, ..Limits::NONE },
                    (Some(linear), Some(angular)) if ACCELERATION => Limits {
                        speed,
                        turn_rate,
                        acceleration: Some(linear),
                        turn_acceleration: Some(angular),
                    },
                    _ => return None,
                }
            }
            _ => return None,
        };
        let parking = self.law == Law::ShimKim && self.reference_velocity == Velocity::ZERO;
        parking.then_some(Self {
            law: Law::ShimKim,
            reference_velocity: Velocity::ZERO,
            reference_arc: None,
            limits,
            ..*self
        })
    }

    /// Whether the reference turns so far in a sample that only single robots can follow.
    pub(crate) fn reference_turns_far(&self) -> bool {
        self.reference_arc.is_some_and(|arc| arc.turn().abs() >= SMALL_TURN)
    }

    /// How a run ends here, at whatever time.
    #[inline(always)]
    pub(crate) fn end(&self, error: &ErrorPosture) -> Option<Outcome> {
        if !error.squared_deviation().is_finite() {
            return Some(Outcome::Diverged);
        }
        let [square, heading] = self.arrival?;
        let arrived = error.squared_distance() <= square && error.theta.abs() <= heading;
        arrived.then_some(Outcome::Arrived)
    }

    /// One sample: law, limits, cost, motion.
    #[inline(always)]
    pub(crate) fn step<S: Real>(
        &self,
        robot: &Robot<S>,
        gains: &Gains<S>,
        disturbance: Option<Velocity<S>>,
    ) -> Step<S> {
        let (decided, command) = self.decided(robot, gains);
        let (next, arc) = self.moved(&decided, disturbance);
        Step { command, arc, next }
    }

    /// The first half of a sample: the law, the limits, the cost of being here. The robot has its new velocity, and the
    /// command is beside it.
    #[inline(always)]
    pub(crate) fn decided<S: Real>(
        &self,
        robot: &Robot<S>,
        gains: &Gains<S>,
    ) -> (Robot<S>, Velocity<S>) {
        let command = self.law.command(&robot.error, gains, self.reference_velocity);
        let velocity = self.limits.applied(command, robot.velocity, self.sample_time);
        let path = robot.path + robot.error.squared_deviation();
        (Robot { velocity, path, ..*robot }, command)
    }

    /// The second half: the cost of the velocity, the motion. This is the one place where a robot moves.
    #[inline(always)]
    pub(crate) fn moved<S: Real>(
        &self,
        robot: &Robot<S>,
        disturbance: Option<Velocity<S>>,
    ) -> (Robot<S>, Arc<S>) {
        let q = robot.velocity;
        let squares = Velocity { linear: q.linear * q.linear, angular: q.angular * q.angular };
        let arc = Arc::new(disturbance.map_or(q, |delta| q + delta), self.sample_time);
        let moved = robot.error.robot_moved(&arc);
        let error = match &self.reference_arc {
            Some(reference) => moved.reference_moved(&reference.splat()),
            None => moved,
        };
        (Robot { error, energy: robot.energy + squares, ..*robot }, arc)
    }
}

/// A robot on its way: sample by sample, or whole.
#[derive(Clone, Debug)]
pub struct Episode<'a> {
    setting: &'a Setting,
    state: EpisodeState,
}

/// An episode without the setting that it runs in, for those who keep both.
#[derive(Clone, Debug)]
pub(crate) struct EpisodeState {
    gains: Gains,
    disturbances: DisturbanceSequence,
    robot: Robot<f64>,
    /// θ of the robot, not wrapped.
    heading: f64,
    /// What the law asked for during the sample before.
    command: Velocity,
    n: u32,
    outcome: Option<Outcome>,
}

/// The robot at one sample.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Sample {
    /// t in seconds.
    pub time: f64,
    /// The robot's posture; θ is not wrapped.
    pub posture: Posture,
    /// The reference posture.
    pub reference: Posture,
    /// What the control law asks for; at the end of a run, what it last asked for.
    pub command: Velocity,
    /// What the limits leave of it, applied until the next sample; at the end, what was last applied.
    pub velocity: Velocity,
    /// The error posture (3).
    pub error: ErrorPosture,
    /// V
    pub lyapunov: f64,
    /// V̇ with the applied velocity.
    pub lyapunov_rate: f64,
    /// How the run ended, if it has.
    pub outcome: Option<Outcome>,
}

/// Beyond so many radians the full turns are forgotten: nobody counts them, and an angle must stay finite.
const MOST_HEADING: f64 = 1e6;

impl EpisodeState {
    pub(crate) fn new(setting: &Setting, gains: Gains, start: u32) -> Self {
        let experiment = &setting.experiment;
        let posture = experiment.starts[start as usize];
        let robot = setting.robot_at(posture);
        Self {
            gains,
            disturbances: experiment.disturbance.sequence(start),
            robot,
            heading: posture.theta,
            command: Velocity::ZERO,
            n: 0,
            outcome: setting.outcome(&robot.error, 0),
        }
    }

    /// The robot now; if the run goes on, the robot then moves to the next sample.
    pub(crate) fn step(&mut self, setting: &Setting) -> Sample {
        let before = self.clone();
        self.advance(setting);
        let Experiment { reference_velocity, .. } = setting.experiment;
        let time = setting.final_time(before.outcome, before.n);
        let reference = setting.reference_at(before.n);
        let error = before.robot.error;
        Sample {
            time,
            posture: Posture { theta: before.heading, ..error.posture(reference) },
            reference,
            command: self.command,
            velocity: self.robot.velocity,
            error,
            lyapunov: lyapunov(&error),
            lyapunov_rate: lyapunov_rate(&error, self.robot.velocity, reference_velocity),
            outcome: before.outcome,
        }
    }

    #[inline]
    fn advance(&mut self, setting: &Setting) {
        if self.outcome.is_none() {
            let step = setting.rules.step(&self.robot, &self.gains, self.disturbances.next());
            self.command = step.command;
            self.robot = step.next;
            self.n += 1;
            self.outcome = setting.outcome(&self.robot.error, self.n);
            self.heading += step.arc.turn();
            if self.heading.abs() > MOST_HEADING {
                let reference = setting.reference_at(self.n);
                self.heading = wrap(reference.theta - self.robot.error.theta);
            }
        }
    }
}

impl<'a> Episode<'a> {
    fn new(setting: &'a Setting, gains: Gains, start: u32) -> Self {
        Self { setting, state: EpisodeState::new(setting, gains, start) }
    }

    /// The run driven to its end.
    pub fn finished(mut self) -> Self {
        while self.state.outcome.is_none() {
            self.state.advance(self.setting);
        }
        self
    }

    /// How the run ended, if it has.
    pub fn outcome(&self) -> Option<Outcome> {
        self.state.outcome
    }

    /// t_f if the run has ended, else the time now, in seconds.
    pub fn time(&self) -> f64 {
        self.setting.final_time(self.state.outcome, self.state.n)
    }

    /// J until now, in parts.
    pub fn cost(&self) -> Cost {
        let EpisodeState { robot, gains, n, outcome, .. } = &self.state;
        self.setting.cost_at(robot, gains, *n, *outcome)
    }

    /// All samples from here to the end of the run.
    pub fn samples(&mut self) -> impl Iterator<Item = Sample> {
        let mut over = false;
        core::iter::from_fn(move || {
            if over {
                return None;
            }
            let sample = self.state.step(self.setting);
            over = sample.outcome.is_some();
            Some(sample)
        })
    }
}
