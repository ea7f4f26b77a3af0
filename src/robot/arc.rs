//! The motion of a robot: an exact arc of the kinematics (2).

use super::posture::{Posture, Velocity};
use crate::number::Real;

/// The circular arc that a robot with a constant velocity (v, ω) describes in a time dt.
///
/// It turns by ω dt and leads v sin(ω dt) / ω ahead, v (1 − cos(ω dt)) / ω aside: the exact solution of the
/// kinematics (2), ẋ = v cos θ, ẏ = v sin θ, θ̇ = ω. That a velocity is held for a sample and its arc is exact is our choice;
/// the paper names no method.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc<S> {
    pub(super) velocity: Velocity<S>,
    pub(super) turn: S,
    /// How far ahead a unit speed leads.
    pub(super) ahead: S,
    /// How far to the left a unit speed leads.
    pub(super) aside: S,
}

impl<S: Copy> Arc<S> {
    /// ω in rad/s.
    pub(crate) fn turn_rate(&self) -> S {
        self.velocity.angular
    }

    /// By how much the heading turns, in radians.
    pub(crate) fn turn(&self) -> S {
        self.turn
    }
}

impl Arc<f64> {
    /// The same arc for every robot.
    #[inline]
    pub(crate) fn splat<S: Real>(&self) -> Arc<S> {
        Arc {
            velocity: self.velocity.map(S::splat),
            turn: S::splat(self.turn),
            ahead: S::splat(self.ahead),
            aside: S::splat(self.aside),
        }
    }
}

impl<S: Real> Arc<S> {
    #[inline]
    pub(crate) fn new(velocity: Velocity<S>, dt: f64) -> Self {
        let (ahead, aside) = velocity.angular.along_arc(dt);
        Self { velocity, turn: velocity.angular * S::splat(dt), ahead, aside }
    }

    /// The integral over the time of the vector (x, y) while it turns back.
    #[inline]
    pub(super) fn swept(&self, (x, y): (S, S)) -> (S, S) {
        (self.ahead * x + self.aside * y, self.ahead * y - self.aside * x)
    }

    /// The vector (x, y) turned back by the arc's turn, from what it sweeps: R(T) z = z − ω J ∫ R z dt, for R' = −ω J R
    /// with J the turn by 90°.
    #[inline]
    pub(super) fn turned_back(&self, (x, y): (S, S), swept: (S, S)) -> (S, S) {
        let omega = self.velocity.angular;
        (x + omega * swept.1, y - omega * swept.0)
    }

    /// The same arc driven the other way round.
    #[inline]
    pub(super) fn reversed(&self) -> Self {
        let Velocity { linear, angular } = self.velocity;
        let velocity = Velocity { linear, angular: -angular };
        Self { velocity, turn: -self.turn, aside: -self.aside, ..*self }
    }
}

impl Posture {
    /// Where a robot is after a time `dt` (s) at a constant velocity: the exact arc of the kinematics (2).
    ///
    /// θ is not wrapped.
    pub fn advance(self, velocity: Velocity, dt: f64) -> Self {
        let arc = Arc::new(velocity, dt);
        let (sin, cos) = libm::sincos(self.theta);
        Self {
            x: self.x + velocity.linear * (arc.ahead * cos - arc.aside * sin),
            y: self.y + velocity.linear * (arc.ahead * sin + arc.aside * cos),
            theta: self.theta + arc.turn,
        }
    }
}
