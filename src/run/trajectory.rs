//! A whole run as columns of numbers.

use super::cost::Cost;
use super::episode::EpisodeState;
use super::rules::{Outcome, Robot};
use super::setting::Setting;
use super::work::{BYTES_OF_AN_OBJECT, check_bytes};
use crate::robot::{Gains, Posture, Velocity};
use crate::schema::{Column, Result, told};

/// What is told of a run at one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunSample {
    /// t in seconds.
    pub time: f64,
    /// The robot's posture; θ is not wrapped, but that beyond 10⁶ rad full turns are left out.
    pub posture: Posture,
    /// The velocity applied until the next sample; at the end, what was last applied.
    pub velocity: Velocity,
    /// What the control law asks for; at the end, what it last asked for.
    pub command: Velocity,
    /// The reference posture.
    pub reference: Posture,
    /// What the path and the energy have cost until now, ½ ∫ (p − p_r)ᵀ(p − p_r) dt and ½ ∫ qᵀ R q dt from 0.
    pub paid: [f64; 2],
}

/// One run, sample by sample, and how it ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// From time 0 to where the run ended.
    pub samples: Vec<RunSample>,
    /// J in parts.
    pub cost: Cost,
    /// How the run ended.
    pub outcome: Outcome,
    /// t_f in seconds.
    pub final_time: f64,
}

impl Run {
    fn column(&self, number: fn(&RunSample) -> f64) -> Column {
        Column::of(&self.samples, number)
    }
}

told! {
    /// One run: arrays with one value a sample, the first at time 0, the last where the run ended.
    Run: Run {
        /// Seconds.
        "time" => |run| run.column(|s| s.time),
        /// Metres.
        "x" => |run| run.column(|s| s.posture.x),
        /// Metres.
        "y" => |run| run.column(|s| s.posture.y),
        /// Radians, not wrapped, but that beyond 10⁶ rad full turns are left out.
        "theta" => |run| run.column(|s| s.posture.theta),
        /// The velocity applied from this sample to the next, after the limits, m/s; the last sample repeats the one before.
        "linear" => |run| run.column(|s| s.velocity.linear),
        /// The same for the turn rate, rad/s.
        "angular" => |run| run.column(|s| s.velocity.angular),
        /// The velocity that the control law asked for, before the limits, m/s.
        "commandLinear" => |run| run.column(|s| s.command.linear),
        /// The same for the turn rate, rad/s.
        "commandAngular" => |run| run.column(|s| s.command.angular),
        /// The reference posture, which moves when the reference velocity is not zero: metres.
        "referenceX" => |run| run.column(|s| s.reference.x),
        /// Metres.
        "referenceY" => |run| run.column(|s| s.reference.y),
        /// Radians.
        "referenceTheta" => |run| run.column(|s| s.reference.theta),
        /// The path's part of J that is paid until the sample: ½ ∫ (p − p_r)ᵀ(p − p_r) dt from 0.
        "pathCost" => |run| run.column(|s| s.paid[0]),
        /// The energy's part of J that is paid until the sample: ½ ∫ qᵀ R q dt from 0.
        "energyCost" => |run| run.column(|s| s.paid[1]),
        /// J of the run, in parts.
        "cost" => |run| run.cost,
        /// How the run ended.
        "outcome" => |run| run.outcome,
        /// Whether the robot arrived.
        "arrived" => |run| run.outcome == Outcome::Arrived,
        /// t_f in seconds: the time of the sample at which the robot was seen to have arrived or to have left the finite
        /// numbers, else the horizon. Where the horizon is not a whole number of samples, the last begins before it and ends
        /// after it: an arrival there is up to one sample time later, and path and energy count that sample whole.
        "finalTime" => |run| run.final_time,
    }
}

/// The columns of a run, one of each number of a sample.
const COLUMNS: usize = size_of::<RunSample>() / size_of::<f64>();

impl Setting {
    /// Refuses more whole runs in one call than it may give back.
    pub fn check_runs(&self, count: usize) -> Result<()> {
        let (what, count) = ("the number of gain triples", count as f64);
        self.experiment().check_drives(what, count, 1)?;
        check_bytes(what, count, BYTES_OF_AN_OBJECT + self.bytes_of_columns(COLUMNS))
    }

    /// A whole run with these gains from the start posture with this index.
    ///
    /// # Panics
    /// If there is no such start posture.
    pub fn run(&self, gains: Gains, start: u32) -> Run {
        let mut state = EpisodeState::new(self, gains, start);
        let mut samples = Vec::new();
        let outcome = loop {
            let ended = state.outcome;
            samples.push(self.next_sample(&mut state));
            if let Some(outcome) = ended {
                break outcome;
            }
        };
        let final_time = self.final_time(Some(outcome), state.n);
        Run { samples, cost: state.cost(self), outcome, final_time }
    }

    /// The sample at which a run is, after which the robot moves on.
    #[inline]
    fn next_sample(&self, state: &mut EpisodeState) -> RunSample {
        let EpisodeState { robot: Robot { error, path, energy, .. }, heading, n, outcome, .. } =
            *state;
        state.advance(self);
        let frame = self.frame_at(n);
        RunSample {
            time: self.final_time(outcome, n),
            posture: Posture { theta: heading, ..frame.posture_at(&error) },
            velocity: state.robot.velocity,
            command: state.command,
            reference: frame.reference,
            paid: self.paid(path, energy),
        }
    }
}
