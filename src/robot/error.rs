//! The error posture: equations (3) and (4).

use nalgebra::{Rotation2, Vector2};

use super::arc::Arc;
use super::posture::{Posture, Velocity};
use crate::number::{Real, wrap};
use crate::schema::told;

/// The error posture (x_e, y_e, θ_e) of equation (3), in the frame of the reference posture.
///
/// The direction (cos θ_e, sin θ_e) is kept beside the angle and turned with it, so that no sample needs a sine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorPosture<S = f64> {
    /// x_e in metres: how far the reference is ahead, along its own heading.
    pub x: S,
    /// y_e in metres: how far it is to the side, positive to the left of its heading.
    pub y: S,
    /// θ_e = θ_r − θ_c in radians, in (−π, π].
    pub theta: S,
    /// cos θ_e
    pub cos: S,
    /// sin θ_e
    pub sin: S,
}

told! {
    /// The error posture (3), in the frame of the reference.
    ErrorPosture: ErrorPosture {
        /// x_e in metres: how far the reference is ahead, along its own heading.
        "x" => |error| error.x,
        /// y_e in metres: how far it is to the side, positive to the left of its heading.
        "y" => |error| error.y,
        /// θ_e in radians, in (−π, π].
        "theta" => |error| error.theta,
    }
}

impl Posture {
    /// The error posture (3): the vector from this posture to `reference`, in the frame of `reference`.
    pub fn error_to(self, reference: Self) -> ErrorPosture {
        let distance = Vector2::new(reference.x - self.x, reference.y - self.y);
        let local = Rotation2::new(reference.theta).inverse() * distance;
        ErrorPosture::new(local.x, local.y, reference.theta - self.theta)
    }
}

impl ErrorPosture {
    /// An error posture; `theta` is wrapped into (−π, π].
    pub fn new(x: f64, y: f64, theta: f64) -> Self {
        let theta = wrap(theta);
        let (sin, cos) = libm::sincos(theta);
        Self { x, y, theta, cos, sin }
    }

    /// The posture that has this error: the inverse of equation (3). θ is in [θ_r − π, θ_r + π).
    pub fn posture(self, reference: Posture) -> Posture {
        Frame::new(reference).posture_at(&self)
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

/// The frame of a reference posture, in which error postures are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) reference: Posture,
    rotation: Rotation2<f64>,
}

impl Frame {
    pub(crate) fn new(reference: Posture) -> Self {
        Self { reference, rotation: Rotation2::new(reference.theta) }
    }

    /// (x_e, y_e) in the directions of the global frame.
    pub(crate) fn global(&self, e: &ErrorPosture) -> Vector2<f64> {
        self.rotation * Vector2::new(e.x, e.y)
    }

    /// The posture that has this error.
    pub(crate) fn posture_at(&self, e: &ErrorPosture) -> Posture {
        let (offset, reference) = (self.global(e), self.reference);
        Posture {
            x: reference.x - offset.x,
            y: reference.y - offset.y,
            theta: reference.theta - e.theta,
        }
    }
}

impl<S: Real> ErrorPosture<S> {
    /// What this function makes of each number.
    pub(crate) fn map<T>(&self, f: impl Fn(S) -> T) -> ErrorPosture<T> {
        let Self { x, y, theta, cos, sin } = *self;
        ErrorPosture { x: f(x), y: f(y), theta: f(theta), cos: f(cos), sin: f(sin) }
    }

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
