//! The Lyapunov function along a run: what the control law promises of it, and what becomes of that.

use crate::control::{Gains, Lyapunov};
use crate::episode::Setting;
use crate::posture::{ErrorPosture, Velocity};

/// The Lyapunov function at one sample of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilitySample {
    /// t in seconds.
    pub time: f64,
    /// The error posture (3).
    pub error: ErrorPosture,
    /// V of the law in m²; the paper's V where the law has none.
    pub lyapunov: f64,
    /// The parts of V̇ that the law promises, on x_e, y_e and θ_e, in m²/s: those of
    /// [`Law::promised_rate`](crate::control::Law::promised_rate).
    pub promised: Option<[f64; 3]>,
    /// V̇ in m²/s under the velocity that the robot has from now on, after limits and disturbance.
    ///
    /// It is computed from the rate of the error (4), and is the sum of the promised parts wherever neither limits nor
    /// disturbance change the command and no divisor of the law is guarded. It holds at the sample only: until the next one
    /// the velocity stays while the error moves on.
    pub rate: f64,
    /// Whether the limits changed the command.
    pub limited: bool,
}

/// The Lyapunov function of a run from the start posture with this index, which must exist, sample by sample.
///
/// The samples are those of [`Setting::episode`]. The last one, where the run has ended, is taken as if the robot drove on.
pub fn stability(setting: &Setting, gains: &Gains, start: u32) -> Vec<StabilitySample> {
    let (experiment, rules) = (setting.experiment(), setting.rules());
    let reference = experiment.reference_velocity;
    let function = experiment.law.lyapunov(gains).unwrap_or(Lyapunov::PAPER);
    let mut robot = setting.robot_at(experiment.starts[start as usize]);
    let mut disturbances = experiment.disturbance.sequence(start);
    let mut samples = Vec::new();
    for n in 0.. {
        let outcome = setting.outcome(&robot.error, n);
        let (decided, command) = rules.decided(&robot, gains);
        let disturbance = disturbances.next();
        let motion = decided.velocity + disturbance.unwrap_or(Velocity::ZERO);
        let error = robot.error;
        samples.push(StabilitySample {
            time: setting.final_time(outcome, n),
            error,
            lyapunov: function.value(&error),
            promised: experiment.law.promised_rate(&error, gains, reference),
            rate: function.rate(&error, motion, reference),
            limited: decided.velocity != command,
        });
        if outcome.is_some() {
            break;
        }
        (robot, _) = rules.moved(&decided, disturbance);
    }
    samples
}
