//! What a real motor leaves of a commanded velocity (section 5 of the paper).

use super::posture::Velocity;
use crate::number::Real;
use crate::schema::{Allowed, record};

/// What is 0 or more, or null.
pub(crate) const fn limit(unit: &'static str) -> Allowed {
    Allowed::within(unit, 0.0, 1e6).or_null()
}

record! { input (Copy)
    /// Limits of velocity and acceleration; null means not limited.
    pub struct Limits {
        /// Largest |v| in m/s.
        pub speed: Option<f64> => "speed" in limit("m/s"),
        /// Largest |ω| in rad/s.
        pub turn_rate: Option<f64> => "turnRate" in limit("rad/s"),
        /// Largest |dv/dt| in m/s².
        pub acceleration: Option<f64> => "acceleration" in limit("m/s²"),
        /// Largest |dω/dt| in rad/s².
        pub turn_acceleration: Option<f64> => "turnAcceleration" in limit("rad/s²"),
    }
}

impl Limits {
    /// No limits at all.
    pub const NONE: Self =
        Self { speed: None, turn_rate: None, acceleration: None, turn_acceleration: None };

    /// What the limits leave of `command` when the robot moved with `previous` during the sample before:
    /// first the velocity is clamped, then its change to at most acceleration · dt (s).
    #[inline]
    pub fn applied<S: Real>(
        &self,
        command: Velocity<S>,
        previous: Velocity<S>,
        dt: f64,
    ) -> Velocity<S> {
        Velocity {
            linear: limited(command.linear, previous.linear, self.speed, self.acceleration, dt),
            angular: limited(
                command.angular,
                previous.angular,
                self.turn_rate,
                self.turn_acceleration,
                dt,
            ),
        }
    }
}

#[inline]
fn limited<S: Real>(
    command: S,
    previous: S,
    largest: Option<f64>,
    rate: Option<f64>,
    dt: f64,
) -> S {
    let clamped = match largest {
        Some(largest) => command.at_least(S::splat(-largest)).at_most(S::splat(largest)),
        None => command,
    };
    match rate {
        Some(rate) => {
            let change = S::splat(rate * dt);
            clamped.at_least(previous - change).at_most(previous + change)
        }
        None => clamped,
    }
}
