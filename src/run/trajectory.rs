//! A whole run as columns of numbers.

use super::cost::Cost;
use super::episode::EpisodeState;
use super::rules::{Outcome, Robot};
use super::setting::Setting;
use super::work::check_bytes;
use crate::robot::Gains;
use crate::schema::{Column, Result, record};

record! {
    /// One run: arrays with one value a sample, the first at time 0, the last where the run ended.
    pub struct Run {
        /// Seconds.
        pub time: Column => "time",
        /// Metres.
        pub x: Column => "x",
        /// Metres.
        pub y: Column => "y",
        /// Radians, not wrapped.
        pub theta: Column => "theta",
        /// The velocity applied from this sample to the next, after the limits, m/s; the last sample repeats the one before.
        pub linear: Column => "linear",
        /// The same for the turn rate, rad/s.
        pub angular: Column => "angular",
        /// The velocity that the control law asked for, before the limits, m/s.
        pub command_linear: Column => "commandLinear",
        /// The same for the turn rate, rad/s.
        pub command_angular: Column => "commandAngular",
        /// The reference posture, which moves when the reference velocity is not zero: metres.
        pub reference_x: Column => "referenceX",
        /// Metres.
        pub reference_y: Column => "referenceY",
        /// Radians.
        pub reference_theta: Column => "referenceTheta",
        /// The path's part of J that is paid until the sample: ½ ∫ (p − p_r)ᵀ(p − p_r) dt from 0.
        pub path_cost: Column => "pathCost",
        /// The energy's part of J that is paid until the sample: ½ ∫ qᵀ R q dt from 0.
        pub energy_cost: Column => "energyCost",
        /// J of the run, in parts.
        pub cost: Cost => "cost",
        /// How the run ended.
        pub outcome: Outcome => "outcome",
        /// Whether the robot arrived.
        pub arrived: bool => "arrived",
        /// t_f in seconds: the time of the sample at which the robot was seen to have arrived or to have left the finite
        /// numbers, else the horizon. Where the horizon is not a whole number of samples, the last begins before it and ends
        /// after it: an arrival there is up to one sample time later, and path and energy count that sample whole.
        pub final_time: f64 => "finalTime",
    }
}

/// The columns of a run.
const COLUMNS: usize = 13;

impl Setting {
    /// Refuses more whole runs in one call than it may give back.
    pub fn check_runs(&self, count: usize) -> Result<()> {
        let (what, count) = ("the number of gain triples", count as f64);
        self.experiment().check_drives(what, count, 1)?;
        check_bytes(what, count, self.bytes_of_columns(COLUMNS))
    }

    /// A whole run with these gains from the start posture with this index.
    ///
    /// # Panics
    /// If there is no such start posture.
    pub fn run(&self, gains: Gains, start: u32) -> Run {
        let mut state = EpisodeState::new(self, gains, start);
        let mut rows: Vec<[f64; COLUMNS]> = Vec::new();
        let outcome = loop {
            let (ended, row) = self.row(&mut state);
            rows.push(row);
            if let Some(outcome) = ended {
                break outcome;
            }
        };
        // In the order of a row.
        let [time, x, y, theta, linear, angular, command_linear, command_angular, rest @ ..] =
            std::array::from_fn::<_, COLUMNS, _>(|i| {
                Column(rows.iter().map(|row| row[i]).collect())
            });
        let [reference_x, reference_y, reference_theta, path_cost, energy_cost] = rest;
        Run {
            time,
            x,
            y,
            theta,
            linear,
            angular,
            command_linear,
            command_angular,
            reference_x,
            reference_y,
            reference_theta,
            path_cost,
            energy_cost,
            cost: state.cost(self),
            outcome,
            arrived: outcome == Outcome::Arrived,
            final_time: self.final_time(Some(outcome), state.n),
        }
    }

    /// One sample of each column, after which the robot moves on.
    #[inline]
    fn row(&self, state: &mut EpisodeState) -> (Option<Outcome>, [f64; COLUMNS]) {
        let EpisodeState { robot, heading, n, outcome, .. } = *state;
        let Robot { error, path, energy, .. } = robot;
        state.advance(self);
        let frame = self.frame_at(n);
        let (posture, reference) = (frame.posture_at(&error), frame.reference);
        let (q, command) = (state.robot.velocity, state.command);
        let [path_cost, energy_cost] = self.paid(path, energy);
        let row = [
            self.final_time(outcome, n),
            posture.x,
            posture.y,
            heading,
            q.linear,
            q.angular,
            command.linear,
            command.angular,
            reference.x,
            reference.y,
            reference.theta,
            path_cost,
            energy_cost,
        ];
        (outcome, row)
    }
}
