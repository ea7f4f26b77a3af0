//! The Lyapunov function along a run: what the control law promises of it, and what becomes of that.

use crate::robot::{ErrorPosture, Gains, Velocity};
use crate::run::Setting;
use crate::schema::{Column, Flags, told};
use crate::theory::{Lyapunov, PromisedRate};

/// The Lyapunov function at one sample of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilitySample {
    /// t in seconds.
    pub time: f64,
    /// The error posture (3).
    pub error: ErrorPosture,
    /// V of the law in m²; the paper's V where the law has none.
    pub lyapunov: f64,
    /// The parts of V̇ that the law promises: those of [`Law::promised_rate`](crate::robot::Law::promised_rate).
    pub promised: Option<PromisedRate>,
    /// V̇ in m²/s under the velocity that the robot has from now on, after limits and disturbance.
    ///
    /// It is computed from the rate of the error (4), and is the sum of the promised parts wherever neither limits nor
    /// disturbance change the command and no divisor of the law is guarded. It holds at the sample only: until the next one
    /// the velocity stays while the error moves on.
    pub rate: f64,
    /// Whether the limits changed the command.
    pub limited: bool,
}

/// The Lyapunov function along one run.
#[derive(Clone, Debug, PartialEq)]
pub struct Stability {
    /// Which function it is; none if nothing is promised.
    pub function: Option<Lyapunov>,
    /// The run, sample by sample.
    pub samples: Vec<StabilitySample>,
}

impl Stability {
    /// The Lyapunov function of a run from the start posture with this index, sample by sample.
    ///
    /// The samples are those of [`Setting::episode`]. The last one, where the run has ended, is taken as if the robot drove on.
    ///
    /// # Panics
    /// If there is no such start posture.
    pub fn of(setting: &Setting, gains: &Gains, start: u32) -> Self {
        let (experiment, rules) = (setting.experiment(), setting.rules());
        let (law, reference) = (experiment.law, experiment.reference_velocity);
        let function = law.lyapunov(gains);
        let lyapunov = function.unwrap_or(Lyapunov::PAPER);
        let mut robot = setting.robot_at(experiment.starts[start as usize]);
        let mut disturbances = experiment.disturbance.sequence(start);
        let mut samples = Vec::new();
        for n in 0.. {
            let outcome = setting.outcome(&robot, n);
            let (decided, command) = rules.decided(&robot, gains);
            let disturbance = disturbances.next();
            let motion = decided.velocity + disturbance.unwrap_or(Velocity::ZERO);
            let error = robot.error;
            samples.push(StabilitySample {
                time: setting.final_time(outcome, n),
                error,
                lyapunov: lyapunov.value(&error),
                promised: law.promised_rate(&error, gains, reference),
                rate: lyapunov.rate(&error, motion, reference),
                limited: decided.velocity != command,
            });
            if outcome.is_some() {
                break;
            }
            (robot, _) = rules.moved(&decided, disturbance);
        }
        Self { function, samples }
    }

    fn column(&self, value: fn(&StabilitySample) -> f64) -> Column {
        Column::of(&self.samples, value)
    }

    fn promised(&self, part: fn(PromisedRate) -> f64) -> Column {
        Column::of(&self.samples, |sample| sample.promised.map_or(f64::NAN, part))
    }
}

told! {
    /// The Lyapunov function V = ½ x_e² + ½ y_e² + w (1 − cos θ_e) along one run: arrays with one value a sample, those of
    /// `simulate`. The last sample, where the run has ended, is taken as if the robot drove on.
    Stability: Stability {
        /// Seconds.
        "time" => |run| run.column(|s| s.time),
        /// x_e of the error posture (3), metres.
        "errorX" => |run| run.column(|s| s.error.x),
        /// y_e, metres.
        "errorY" => |run| run.column(|s| s.error.y),
        /// θ_e, radians in (−π, π].
        "errorTheta" => |run| run.column(|s| s.error.theta),
        /// V, m².
        "lyapunov" => |run| run.column(|s| s.lyapunov),
        /// The part of dV/dt on x_e that the law promises for its commanded velocity, m²/s: −kx x_e² cos² θ_e for the law (5),
        /// −kx x² for Kanayama's rule, x = x_e cos θ_e − y_e sin θ_e being how far the reference is ahead of the robot. NaN
        /// where nothing is promised.
        "promisedX" => |run| run.promised(|rate| rate.x),
        /// The part on y_e, m²/s: −ky y_e⁴, or 0 for Kanayama's rule.
        "promisedY" => |run| run.promised(|rate| rate.y),
        /// The part on θ_e, m²/s: −kθ sin² θ_e, or −v_r (kθ/ky) sin² θ_e for Kanayama's rule, which is positive where the
        /// reference drives backwards.
        "promisedTheta" => |run| run.promised(|rate| rate.theta),
        /// dV/dt under the velocity that the robot has from the sample on, after limits and disturbance, m²/s, from the rate of
        /// the error (4). Where these leave the command as it is, and no divisor of the law is guarded, it is the sum of
        /// the promised parts.
        "rate" => |run| run.column(|s| s.rate),
        /// 1 where the limits changed the command, else 0.
        "limited" => |run| Flags::of(&run.samples, |s| s.limited),
        /// w, m²: 1 for the law (5), 1/ky for Kanayama's rule. Null if that has ky ≤ 0: then nothing is promised, and V is that
        /// of (5).
        "headingWeight" => |run| run.function.map(|function| function.heading_weight),
    }
}
