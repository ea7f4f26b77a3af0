//! What happens in one sample: the law, the limits, the cost, the motion.

use super::experiment::{Experiment, Tolerance};
use crate::number::{Real, SMALL_TURN};
use crate::robot::{Arc, ErrorPosture, Gains, Law, Limits, Velocity};
use crate::schema::words;

words! {
    /// How a run ended: the robot came within the tolerances of the goal, the horizon was reached, or it left the finite
    /// numbers, or went so far that its square is none.
    pub enum Outcome {
        /// The robot came within the tolerances of the goal.
        Arrived = "arrived",
        /// The horizon was reached.
        Horizon = "horizon",
        /// The robot left the finite numbers, as it can without limits.
        Diverged = "diverged",
    }
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
    /// The largest (|v|, |ω|) that counts as arrived.
    standstill: [f64; 2],
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
}

impl<S: Real> Robot<S> {
    /// What this function makes of each number.
    pub(crate) fn map<T>(&self, f: impl Fn(S) -> T) -> Robot<T> {
        let Self { error, velocity, path, energy } = *self;
        Robot {
            error: error.map(&f),
            velocity: velocity.map(&f),
            path: f(path),
            energy: energy.map(&f),
        }
    }
}

impl Rules {
    pub(crate) fn new(e: &Experiment) -> Self {
        let Tolerance { position, heading, speed, turn_rate } = e.tolerance;
        let tracking = e.is_tracking();
        Self {
            law: e.law,
            reference_velocity: e.reference_velocity,
            reference_arc: tracking.then(|| Arc::new(e.reference_velocity, e.sample_time)),
            limits: e.limits,
            sample_time: e.sample_time,
            arrival: (!tracking).then_some([position * position, heading]),
            standstill: [speed, turn_rate].map(|largest| largest.unwrap_or(f64::INFINITY)),
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

    /// Whether the reference stands still.
    pub(crate) fn is_parking(&self) -> bool {
        self.reference_arc.is_none()
    }

    /// Whether the reference turns so far in a sample that only single robots can follow.
    pub(crate) fn reference_turns_far(&self) -> bool {
        self.reference_arc.is_some_and(|arc| arc.turn().abs() >= SMALL_TURN)
    }

    /// How a run ends here, at whatever time.
    #[inline(always)]
    pub(crate) fn end(&self, robot: &Robot<f64>) -> Option<Outcome> {
        let Robot { error, velocity, .. } = robot;
        if !error.squared_deviation().is_finite() {
            return Some(Outcome::Diverged);
        }
        let [square, heading] = self.arrival?;
        let [speed, turn_rate] = self.standstill;
        let is_near = error.squared_distance() <= square && error.theta.abs() <= heading;
        let is_slow = velocity.linear.abs() <= speed && velocity.angular.abs() <= turn_rate;
        (is_near && is_slow).then_some(Outcome::Arrived)
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
        let squares = q.map(|q| q * q);
        let arc = Arc::new(disturbance.map_or(q, |delta| q + delta), self.sample_time);
        let moved = robot.error.robot_moved(&arc);
        let error = match &self.reference_arc {
            Some(reference) => moved.reference_moved(&reference.splat()),
            None => moved,
        };
        (Robot { error, energy: robot.energy + squares, ..*robot }, arc)
    }
}
