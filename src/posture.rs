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
/// With h = ω dt / 2 the robot moves by a chord v dt · sin h / h in the direction θ + h, and turns by 2h.
/// That is the exact solution of the kinematics (2), ẋ = v cos θ, ẏ = v sin θ, θ̇ = ω.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc<S> {
    half_turn: S,
    cos: S,
    sin: S,
    chord: S,
}

impl<S: Copy> Arc<S> {
    /// h, half of the angle by which the heading turns, in radians.
    pub(crate) fn half_turn(&self) -> S {
        self.half_turn
    }
}

impl Arc<f64> {
    /// By how much the heading turns, in radians.
    pub(crate) fn turn(&self) -> f64 {
        2.0 * self.half_turn
    }

    /// The same arc for every robot.
    #[inline]
    pub(crate) fn splat<S: Real>(&self) -> Arc<S> {
        Arc {
            half_turn: S::splat(self.half_turn),
            cos: S::splat(self.cos),
            sin: S::splat(self.sin),
            chord: S::splat(self.chord),
        }
    }
}

impl<S: Real> Arc<S> {
    #[inline]
    pub(crate) fn new(velocity: Velocity<S>, dt: f64) -> Self {
        let h = velocity.angular * S::splat(0.5 * dt);
        let (sinc, cos) = h.sinc_cos();
        Self { half_turn: h, cos, sin: h * sinc, chord: velocity.linear * S::splat(dt) * sinc }
    }

    /// The vector (x, y) turned by −h.
    #[inline]
    fn turned_back(&self, (x, y): (S, S)) -> (S, S) {
        (x * self.cos + y * self.sin, y * self.cos - x * self.sin)
    }

    /// A vector turned twice, from itself and the vector turned once: R² = 2 cos h R − 1.
    #[inline]
    fn turned_twice(&self, vector: (S, S), once: (S, S)) -> (S, S) {
        let twice_cos = self.cos + self.cos;
        (twice_cos * once.0 - vector.0, twice_cos * once.1 - vector.1)
    }

    /// The same arc driven the other way round.
    #[inline]
    fn reversed(&self) -> Self {
        Self { half_turn: -self.half_turn, sin: -self.sin, ..*self }
    }
}

impl Posture {
    /// Where a robot is after a time `dt` (s) at a constant velocity: the exact arc of the kinematics (2).
    ///
    /// θ is not wrapped.
    pub fn advance(self, velocity: Velocity, dt: f64) -> Self {
        let arc = Arc::new(velocity, dt);
        let (sin, cos) = libm::sincos(self.theta + arc.half_turn);
        Self {
            x: self.x + arc.chord * cos,
            y: self.y + arc.chord * sin,
            theta: self.theta + arc.turn(),
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
        Self { x: self.x - arc.chord * cos, y: self.y + arc.chord * sin, ..turned }
    }

    /// The error after the reference has moved along the arc, and its frame with it.
    #[inline]
    pub(crate) fn reference_moved(&self, arc: &Arc<S>) -> Self {
        let (x, y) = arc.turned_back((self.x, self.y));
        let (x, y) = arc.turned_back((x + arc.chord, y));
        let (turned, _) = self.turned_back(&arc.reversed());
        Self { x, y, ..turned }
    }

    /// The same place with the heading error reduced by the arc's turn 2h, and the direction half way.
    #[inline]
    fn turned_back(&self, arc: &Arc<S>) -> (Self, (S, S)) {
        let half_way = arc.turned_back((self.cos, self.sin));
        let (cos, sin) = arc.turned_twice((self.cos, self.sin), half_way);
        let theta = self.theta - (arc.half_turn + arc.half_turn);
        let theta = theta.kept_in_range(arc.half_turn, cos, sin);
        (Self { theta, cos, sin, ..*self }, half_way)
    }
}
