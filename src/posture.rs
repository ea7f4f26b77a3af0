//! Postures, velocities, and the motion that the one gives the other: equations (1) to (4) of the paper.

use core::f64::consts::{PI, TAU};

use nalgebra::{Rotation2, Vector2};
use serde::{Deserialize, Serialize};

use crate::real::Real;

/// A posture p = (x, y, θ) in the global frame, equation (1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Posture {
    /// x in metres.
    pub x: f64,
    /// y in metres.
    pub y: f64,
    /// θ in radians, counter-clockwise from the X axis.
    pub theta: f64,
}

/// A velocity q = (v, ω).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Velocity<S = f64> {
    /// v in m/s, positive forwards.
    pub linear: S,
    /// ω in rad/s, positive counter-clockwise.
    pub angular: S,
}

impl Velocity {
    /// The velocity of a robot at rest.
    pub const ZERO: Self = Self { linear: 0.0, angular: 0.0 };

    /// The same velocity for every robot.
    #[inline]
    pub fn splat<S: Real>(self) -> Velocity<S> {
        Velocity { linear: S::splat(self.linear), angular: S::splat(self.angular) }
    }
}

impl<S: Real> core::ops::Add for Velocity<S> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { linear: self.linear + other.linear, angular: self.angular + other.angular }
    }
}

/// The angle in (−π, π] that points the same way.
pub fn wrap(angle: f64) -> f64 {
    let wrapped = angle - TAU * ((angle - PI) / TAU).ceil();
    // Rounding can leave it just outside.
    if wrapped <= -PI || wrapped > PI { PI } else { wrapped }
}

/// The circular arc that a robot with a constant velocity (v, ω) describes in a time dt.
///
/// It turns by ω dt and leads v sin(ω dt) / ω ahead, v (1 − cos(ω dt)) / ω aside: the exact solution of the
/// kinematics (2), ẋ = v cos θ, ẏ = v sin θ, θ̇ = ω.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc<S> {
    velocity: Velocity<S>,
    turn: S,
    /// How far ahead a unit speed leads.
    ahead: S,
    /// How far to the left a unit speed leads.
    aside: S,
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
            velocity: self.velocity.splat(),
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
    fn swept(&self, (x, y): (S, S)) -> (S, S) {
        (self.ahead * x + self.aside * y, self.ahead * y - self.aside * x)
    }

    /// The vector (x, y) turned back by the arc's turn, from what it sweeps: R' = −ω R for a turn by 90°.
    #[inline]
    fn turned_back(&self, (x, y): (S, S), swept: (S, S)) -> (S, S) {
        let omega = self.velocity.angular;
        (x + omega * swept.1, y - omega * swept.0)
    }

    /// The same arc driven the other way round.
    #[inline]
    fn reversed(&self) -> Self {
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

    /// The error posture (3): the vector from this posture to `reference`, in the frame of `reference`.
    pub fn error_to(self, reference: Self) -> ErrorPosture {
        let distance = Vector2::new(reference.x - self.x, reference.y - self.y);
        let local = Rotation2::new(reference.theta).inverse() * distance;
        ErrorPosture::new(local.x, local.y, reference.theta - self.theta)
    }
}

/// The error posture (x_e, y_e, θ_e) of equation (3), in the frame of the reference posture.
///
/// The direction (cos θ_e, sin θ_e) is kept beside the angle and turned with it, so that no sample needs a sine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ErrorPosture<S = f64> {
    /// x_e in metres: how far the reference is ahead, along its own heading.
    pub x: S,
    /// y_e in metres: how far it is to the side, positive to the left of its heading.
    pub y: S,
    /// θ_e = θ_r − θ_c in radians, in (−π, π].
    pub theta: S,
    /// cos θ_e
    #[serde(skip)]
    pub cos: S,
    /// sin θ_e
    #[serde(skip)]
    pub sin: S,
}

impl ErrorPosture {
    /// An error posture; `theta` is wrapped into (−π, π].
    pub fn new(x: f64, y: f64, theta: f64) -> Self {
        let theta = wrap(theta);
        let (sin, cos) = libm::sincos(theta);
        Self { x, y, theta, cos, sin }
    }

    /// The same error in every lane.
    pub(crate) fn splat<S: Real>(&self) -> ErrorPosture<S> {
        ErrorPosture {
            x: S::splat(self.x),
            y: S::splat(self.y),
            theta: S::splat(self.theta),
            cos: S::splat(self.cos),
            sin: S::splat(self.sin),
        }
    }

    /// The posture that has this error: the inverse of equation (3). θ is in (θ_r − π, θ_r + π].
    pub fn posture(self, reference: Posture) -> Posture {
        let offset = Rotation2::new(reference.theta) * Vector2::new(self.x, self.y);
        Posture {
            x: reference.x - offset.x,
            y: reference.y - offset.y,
            theta: reference.theta - self.theta,
        }
    }

    /// ẋ_e, ẏ_e, θ̇_e for a robot with velocity `q` and a reference with velocity `r`: equation (4), Lemma 1.
    ///
    /// ẋ_e = y_e ω_r + v_r − v cos θ_e, ẏ_e = −x_e ω_r + v sin θ_e, θ̇_e = ω_r − ω.
    pub fn rate(&self, q: Velocity, r: Velocity) -> [f64; 3] {
        [
            self.y * r.angular + r.linear - q.linear * self.cos,
            -self.x * r.angular + q.linear * self.sin,
            r.angular - q.angular,
        ]
    }
}

impl<S: Real> ErrorPosture<S> {
    /// x_e² + y_e² + θ_e², the integrand (p − p_r)ᵀ(p − p_r) of the cost (9).
    #[inline]
    pub fn squared_deviation(&self) -> S {
        self.squared_distance() + self.theta * self.theta
    }

    /// x_e² + y_e²
    #[inline]
    pub fn squared_distance(&self) -> S {
        self.x * self.x + self.y * self.y
    }

    /// The error after the robot has moved along the arc.
    #[inline]
    pub(crate) fn robot_moved(&self, arc: &Arc<S>) -> Self {
        let (turned, (cos, sin)) = self.turned_back(arc);
        let v = arc.velocity.linear;
        Self { x: self.x - v * cos, y: self.y + v * sin, ..turned }
    }

    /// The error after the reference has moved along the arc, and its frame with it.
    #[inline]
    pub(crate) fn reference_moved(&self, arc: &Arc<S>) -> Self {
        let v = arc.velocity.linear;
        let ahead = (self.x + v * arc.ahead, self.y + v * arc.aside);
        let (x, y) = arc.turned_back(ahead, arc.swept(ahead));
        let (turned, _) = self.turned_back(&arc.reversed());
        Self { x, y, ..turned }
    }

    /// The same place with the heading error reduced by the arc's turn, and what the direction sweeps meanwhile.
    #[inline]
    fn turned_back(&self, arc: &Arc<S>) -> (Self, (S, S)) {
        let swept = arc.swept((self.cos, self.sin));
        let (cos, sin) = arc.turned_back((self.cos, self.sin), swept);
        let theta = (self.theta - arc.turn).kept_in_range(arc.turn, cos, sin);
        (Self { theta, cos, sin, ..*self }, swept)
    }
}
