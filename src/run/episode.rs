//! One run of one robot: commanded, limited, moved, and paid for, sample by sample.

use super::cost::Cost;
use super::rules::{Outcome, Robot};
use super::setting::Setting;
use crate::number::wrap;
use crate::robot::{DisturbanceSequence, ErrorPosture, Gains, Posture, Velocity};
use crate::schema::told;
use crate::theory::Lyapunov;

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
    pub(super) robot: Robot<f64>,
    /// θ of the robot, not wrapped.
    pub(super) heading: f64,
    /// What the law asked for during the sample before.
    pub(super) command: Velocity,
    pub(super) n: u32,
    pub(super) outcome: Option<Outcome>,
}

/// The robot at one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// t in seconds.
    pub time: f64,
    /// The robot's posture; θ is not wrapped, but that beyond 10⁶ rad full turns are left out.
    pub posture: Posture,
    /// The reference posture.
    pub reference: Posture,
    /// What the control law asks for; at the end of a run, what it last asked for.
    pub command: Velocity,
    /// What the limits leave of it, applied until the next sample; at the end, what was last applied.
    pub velocity: Velocity,
    /// The error posture (3).
    pub error: ErrorPosture,
    /// V = ½ x_e² + ½ y_e² + (1 − cos θ_e) of the paper, in m².
    pub lyapunov: f64,
    /// V̇ with the applied velocity, without the disturbance, in m²/s.
    pub lyapunov_rate: f64,
    /// How the run ended, if it has.
    pub outcome: Option<Outcome>,
}

told! {
    /// The robot at one sample.
    Sample: Sample {
        /// Seconds.
        "time" => |sample| sample.time,
        /// Where the robot is; θ is not wrapped, but that beyond 10⁶ rad full turns are left out.
        "posture" => |sample| &sample.posture,
        /// The reference posture, which moves when the reference velocity is not zero.
        "reference" => |sample| &sample.reference,
        /// What the control law asks for; at the end of a run, what it last asked for.
        "command" => |sample| &sample.command,
        /// What the limits leave of it, applied until the next sample; at the end, what was last applied.
        "velocity" => |sample| &sample.velocity,
        /// The error posture (3), in the frame of the reference: metres, and radians in (−π, π].
        "error" => |sample| &sample.error,
        /// V = ½ x_e² + ½ y_e² + (1 − cos θ_e) of the paper, in m².
        "lyapunov" => |sample| sample.lyapunov,
        /// dV/dt with the applied velocity, without the disturbance, in m²/s.
        "lyapunovRate" => |sample| sample.lyapunov_rate,
        /// How the run ended; null while the robot drives.
        "outcome" => |sample| &sample.outcome,
        /// Whether the robot has arrived.
        "arrived" => |sample| sample.outcome == Some(Outcome::Arrived),
    }
}

/// Beyond so many radians the full turns are forgotten: nobody counts them, and an angle must stay finite.
const MOST_HEADING: f64 = 1e6;

impl EpisodeState {
    pub(crate) fn new(setting: &Setting, gains: Gains, start: u32) -> Self {
        let experiment = setting.experiment();
        let starts = &experiment.starts;
        let posture = starts.get(start as usize);
        let posture =
            *posture.unwrap_or_else(|| panic!("start {start} of {}, counted from 0", starts.len()));
        let robot = setting.robot_at(posture);
        Self {
            gains,
            disturbances: experiment.disturbance.sequence(start),
            robot,
            heading: posture.theta,
            command: Velocity::ZERO,
            n: 0,
            outcome: setting.outcome(&robot, 0),
        }
    }

    /// The robot now; if the run goes on, the robot then moves to the next sample.
    pub(crate) fn step(&mut self, setting: &Setting) -> Sample {
        let Self { robot: Robot { error, .. }, heading, n, outcome, .. } = *self;
        self.advance(setting);
        let frame = setting.frame_at(n);
        let reference_velocity = setting.experiment().reference_velocity;
        Sample {
            time: setting.final_time(outcome, n),
            posture: Posture { theta: heading, ..frame.posture_at(&error) },
            reference: frame.reference,
            command: self.command,
            velocity: self.robot.velocity,
            error,
            lyapunov: Lyapunov::PAPER.value(&error),
            lyapunov_rate: Lyapunov::PAPER.rate(&error, self.robot.velocity, reference_velocity),
            outcome,
        }
    }

    #[inline]
    pub(super) fn advance(&mut self, setting: &Setting) {
        if self.outcome.is_none() {
            let step = setting.rules().step(&self.robot, &self.gains, self.disturbances.next());
            self.command = step.command;
            self.robot = step.next;
            self.n += 1;
            self.outcome = setting.outcome(&self.robot, self.n);
            self.heading += step.arc.turn();
            if self.heading.abs() > MOST_HEADING {
                let reference = setting.frame_at(self.n).reference;
                self.heading = wrap(reference.theta - self.robot.error.theta);
            }
        }
    }

    /// J until now, in parts.
    pub(super) fn cost(&self, setting: &Setting) -> Cost {
        setting.cost_at(&self.robot, &self.gains, self.n, self.outcome)
    }
}

impl Setting {
    /// A run with these gains from the start posture with this index.
    ///
    /// # Panics
    /// If there is no such start posture.
    pub fn episode(&self, gains: Gains, start: u32) -> Episode<'_> {
        Episode { setting: self, state: EpisodeState::new(self, gains, start) }
    }
}

impl Episode<'_> {
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
        self.state.cost(self.setting)
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
