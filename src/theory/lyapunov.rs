//! Lyapunov functions: why the laws lead to the goal (Theorem 1).

use crate::robot::{ErrorPosture, Gains, Law, Velocity};
use crate::schema::record;

/// A Lyapunov function V = ½ x_e² + ½ y_e² + w (1 − cos θ_e), in m²: a measure of the whole error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lyapunov {
    /// w in m², over 0: how much the heading weighs beside the position.
    pub heading_weight: f64,
}

impl Lyapunov {
    /// The one of the paper, w = 1.
    pub const PAPER: Self = Self { heading_weight: 1.0 };

    /// V at an error posture, in m². It is 0 at the reference posture and more everywhere else.
    pub fn value(&self, e: &ErrorPosture) -> f64 {
        0.5 * e.x * e.x + 0.5 * e.y * e.y + self.heading_weight * (1.0 - e.cos)
    }

    /// V̇ = x_e ẋ_e + y_e ẏ_e + w sin θ_e θ̇_e in m²/s, by the error's rate (4), for a robot that moves with `q` while the
    /// reference moves with `r`.
    pub fn rate(&self, e: &ErrorPosture, q: Velocity, r: Velocity) -> f64 {
        let [x_rate, y_rate, theta_rate] = e.rate(q, r);
        e.x * x_rate + e.y * y_rate + self.heading_weight * e.sin * theta_rate
    }
}

record! { (Copy)
    /// The parts of dV/dt that a law promises for its command, in m²/s, as in `Stability`.
    pub struct PromisedRate {
        /// The part on x_e.
        pub x: f64 => "x",
        /// The part on y_e.
        pub y: f64 => "y",
        /// The part on θ_e.
        pub theta: f64 => "theta",
    }
}

impl PromisedRate {
    /// V̇, the sum of the parts.
    pub fn total(&self) -> f64 {
        self.x + self.y + self.theta
    }
}

impl Law {
    /// The Lyapunov function with which the law is proved: the paper's for [`Law::ShimKim`], w = 1/ky for
    /// [`Law::Kanayama`], which has none unless ky > 0.
    pub fn lyapunov(self, k: &Gains) -> Option<Lyapunov> {
        match self {
            Law::ShimKim => Some(Lyapunov::PAPER),
            Law::Kanayama => (k.y > 0.0).then(|| Lyapunov { heading_weight: 1.0 / k.y }),
        }
    }

    /// The parts of V̇ that the proof promises for the commanded velocity: V̇ of [`Law::lyapunov`] is their sum wherever no
    /// divisor of the law is guarded ([`SMALLEST_DIVISOR`](crate::robot::SMALLEST_DIVISOR)). None where the law has no such function.
    ///
    /// [`Law::ShimKim`], any q_r: −kx x_e² cos² θ_e, −ky y_e⁴ and −kθ sin² θ_e (Theorem 1).
    ///
    /// [`Law::Kanayama`], with x = x_e cos θ_e − y_e sin θ_e, which is how far the reference is ahead of the robot:
    /// −kx x², 0 and −v_r (kθ/ky) sin² θ_e. With v_r = 0 only the first is left, and it is 0 wherever the reference is
    /// beside the robot: such a robot cannot park.
    pub fn promised_rate(self, e: &ErrorPosture, k: &Gains, r: Velocity) -> Option<PromisedRate> {
        match self {
            Law::ShimKim => Some(theorem_1_rate(e, k)),
            Law::Kanayama => self.lyapunov(k).map(|Lyapunov { heading_weight }| {
                let ahead = e.x * e.cos - e.y * e.sin;
                let turning = r.linear * k.theta * heading_weight;
                PromisedRate { x: -k.x * ahead * ahead, y: 0.0, theta: -turning * e.sin * e.sin }
            }),
        }
    }
}

/// The parts of V̇ under the law (5) without limits or disturbance (Theorem 1), wherever no divisor is guarded:
/// −kx x_e² cos² θ_e, −ky y_e⁴, −kθ sin² θ_e.
pub(super) fn theorem_1_rate(e: &ErrorPosture, k: &Gains) -> PromisedRate {
    let (ahead, aside) = (e.x * e.cos, e.y * e.y);
    PromisedRate {
        x: -k.x * ahead * ahead,
        y: -k.y * aside * aside,
        theta: -k.theta * e.sin * e.sin,
    }
}
