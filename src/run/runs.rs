//! Runs that wait to be driven, and how they ended.

use super::cost::Cost;
use super::rules::{Outcome, Robot};
use super::setting::Setting;
use crate::robot::{DisturbanceSequence, Gains, Posture};
use crate::schema::{Columns, Flags, told};

/// One run that is to be driven.
#[derive(Clone, Copy)]
pub(crate) struct Departure {
    pub(crate) gains: Gains,
    pub(crate) start: Posture,
    /// Which of the streams of disturbances it meets.
    pub(crate) stream: u32,
}

/// How a run ended, and what it cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunEnd {
    /// J in parts; its time is t_f.
    pub cost: Cost,
    /// How the run ended.
    pub outcome: Outcome,
}

told! {
    /// One value for each start of a grid, or of an experiment.
    Robustness: Columns<RunEnd> {
        /// J.
        "cost" => |ends| ends.column(|end| end.cost.total()),
        /// t_f in seconds.
        "finalTime" => |ends| ends.column(|end| end.cost.time),
        /// 1 where the robot arrived, else 0.
        "arrived" => |ends| Flags::of(&ends.0, |end| end.outcome == Outcome::Arrived),
    }
}

/// Runs that are taken up one after the other, and how they ended.
pub(super) struct Runs<'a> {
    pub(super) setting: &'a Setting,
    departure: &'a dyn Fn(usize) -> Departure,
    taken: usize,
    pub(super) ends: Vec<RunEnd>,
}

impl<'a> Runs<'a> {
    pub(super) fn new(
        setting: &'a Setting,
        count: usize,
        departure: &'a dyn Fn(usize) -> Departure,
    ) -> Self {
        let ends = vec![RunEnd { cost: Cost::default(), outcome: Outcome::Horizon }; count];
        Self { setting, departure, taken: 0, ends }
    }

    /// The next robot that does not start at its goal, and its seat.
    pub(super) fn next(&mut self, now: u64) -> Option<(Robot<f64>, Seat)> {
        while self.taken < self.ends.len() {
            let number = self.taken;
            self.taken += 1;
            let Departure { gains, start, stream } = (self.departure)(number);
            let robot = self.setting.robot_at(start);
            let horizon = now + u64::from(self.setting.samples());
            let disturbances = self.setting.experiment().disturbance.sequence(stream);
            let seat = Seat { run: number, gains, horizon, disturbances };
            if !self.note_end(&seat, &robot, now) {
                return Some((robot, seat));
            }
        }
        None
    }

    /// Whether the run of this seat ends now; if so, how and at what cost is noted.
    pub(super) fn note_end(&mut self, seat: &Seat, robot: &Robot<f64>, now: u64) -> bool {
        let n = self.setting.samples() - (seat.horizon - now) as u32;
        let Some(outcome) = self.setting.outcome(robot, n) else { return false };
        let cost = self.setting.cost_at(robot, &seat.gains, n, Some(outcome));
        self.ends[seat.run] = RunEnd { cost, outcome };
        true
    }
}

/// What a lane knows of the run that it is driving.
#[derive(Clone)]
pub(super) struct Seat {
    /// The number of the run.
    pub(super) run: usize,
    pub(super) gains: Gains,
    /// The sample, counted from when the first robots set out, at which it reaches the horizon.
    pub(super) horizon: u64,
    pub(super) disturbances: DisturbanceSequence,
}
