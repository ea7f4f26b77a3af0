//! The posture controller: the paper's law (5), the rule it improves on, and the stability of both.

use crate::posture::{ErrorPosture, Velocity};
use crate::real::Real;
use crate::words::words;
use nalgebra::Vector3;

/// The three gains k = (kx, ky, kθ) that evolution looks for. Theorem 1 holds for positive ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains<S = f64> {
    /// kx in 1/s, on x_e.
    pub x: S,
    /// ky in 1/(m² s), on y_e³.
    pub y: S,
    /// kθ in rad/s, on sin θ_e.
    pub theta: S,
}

impl Gains {
    /// Gains from kx, ky and kθ.
    pub const fn new(x: f64, y: f64, theta: f64) -> Self {
        Self { x, y, theta }
    }

    /// The same gains in every lane.
    pub(crate) fn splat<S: Real>(&self) -> Gains<S> {
        Gains { x: S::splat(self.x), y: S::splat(self.y), theta: S::splat(self.theta) }
    }
}

impl From<Vector3<f64>> for Gains {
    fn from(k: Vector3<f64>) -> Self {
        Self::new(k.x, k.y, k.z)
    }
}

impl From<Gains> for Vector3<f64> {
    fn from(k: Gains) -> Self {
        Self::new(k.x, k.y, k.theta)
    }
}

words! {
    /// How the commanded velocity follows from the error posture.
    #[derive(Default)]
    pub enum Law {
        /// The law (5) of the paper, from Shim and Kim (1994).
        #[default]
        ShimKim = "shim-kim",
        /// The rule of Kanayama et al. (1990), which the paper improves on.
        Kanayama = "kanayama",
    }
}

/// Where |sin θ_e| or |cos θ_e| is smaller than this, the law divides by this instead, with their sign.
pub const SMALLEST_DIVISOR: f64 = 1e-6;

/// 1/s, with |s| never under [`SMALLEST_DIVISOR`].
#[inline]
fn guarded_reciprocal<S: Real>(s: S) -> S {
    // Clamping the quotient is clamping the divisor, and keeps its sign: 1/−0 is −∞.
    let largest = 1.0 / SMALLEST_DIVISOR;
    (S::splat(1.0) / s).at_most(S::splat(largest)).at_least(S::splat(-largest))
}

impl Law {
    /// The commanded velocity q_m for an error posture e and a reference velocity q_r = (v_r, ω_r).
    ///
    /// [`Law::ShimKim`] is the law (5):
    /// v = kx x_e cos θ_e − ky y_e³ / sin θ_e + v_r / cos θ_e,
    /// ω = ω_r + kθ sin θ_e + ky x_e y_e³ cos θ_e / sin² θ_e + kx x_e y_e cos θ_e + y_e v_r / cos θ_e.
    ///
    /// [`Law::Kanayama`], with the error (x, y, θ_e) seen from the robot's own frame:
    /// v = v_r cos θ_e + kx x, ω = ω_r + v_r (ky y + kθ sin θ_e). With q_r = 0 it never turns.
    ///
    /// Near sin θ_e = 0 and cos θ_e = 0 the division is guarded by [`SMALLEST_DIVISOR`]: the command is then huge,
    /// and the limits make it physical.
    #[inline]
    pub fn command<S: Real>(self, e: &ErrorPosture<S>, k: &Gains<S>, r: Velocity) -> Velocity<S> {
        match self {
            Law::ShimKim => {
                let cosec = guarded_reciprocal(e.sin);
                let x_cos = e.x * e.cos;
                let ahead = k.x * x_cos;
                let aside = k.y * (e.y * e.y * e.y) * cosec;
                let parking = Velocity {
                    linear: ahead - aside,
                    angular: (k.theta * e.sin + ahead * e.y) + aside * (cosec * x_cos),
                };
                if r == Velocity::ZERO {
                    return parking;
                }
                let forward = S::splat(r.linear) * guarded_reciprocal(e.cos);
                let turn = S::splat(r.angular) + e.y * forward;
                parking + Velocity { linear: forward, angular: turn }
            }
            Law::Kanayama => {
                let (x, y) = (e.x * e.cos - e.y * e.sin, e.x * e.sin + e.y * e.cos);
                let vr = S::splat(r.linear);
                Velocity {
                    linear: vr * e.cos + k.x * x,
                    angular: S::splat(r.angular) + vr * (k.y * y + k.theta * e.sin),
                }
            }
        }
    }
}

/// A command by what asks for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CommandTerms {
    /// What kx, ky and kθ ask for.
    pub gains: [Velocity; 3],
    /// What the reference velocity asks for by itself.
    pub reference: Velocity,
}

impl Law {
    /// The terms of [`Law::command`], which is their sum, up to rounding.
    ///
    /// Both laws are linear in their gains: a term is what the command is with this gain alone, less what it is with none.
    pub fn terms(self, e: &ErrorPosture, k: &Gains, r: Velocity) -> CommandTerms {
        let reference = self.command(e, &Gains::new(0.0, 0.0, 0.0), r);
        let term = |alone: Gains| {
            let asked = self.command(e, &alone, r);
            Velocity {
                linear: asked.linear - reference.linear,
                angular: asked.angular - reference.angular,
            }
        };
        let gains =
            [Gains::new(k.x, 0.0, 0.0), Gains::new(0.0, k.y, 0.0), Gains::new(0.0, 0.0, k.theta)];
        CommandTerms { gains: gains.map(term), reference }
    }
}

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

impl Law {
    /// The Lyapunov function with which the law is proved: the paper's for [`Law::ShimKim`], w = 1/ky for
    /// [`Law::Kanayama`], which has none unless ky > 0.
    pub fn lyapunov(self, k: &Gains) -> Option<Lyapunov> {
        match self {
            Law::ShimKim => Some(Lyapunov::PAPER),
            Law::Kanayama => (k.y > 0.0).then(|| Lyapunov { heading_weight: 1.0 / k.y }),
        }
    }

    /// The parts of V̇ that the proof promises for the commanded velocity, on x_e, y_e and θ_e, in m²/s: V̇ of
    /// [`Law::lyapunov`] is their sum. None where the law has no such function.
    ///
    /// [`Law::ShimKim`], any q_r: −kx x_e² cos² θ_e, −ky y_e⁴ and −kθ sin² θ_e (Theorem 1).
    ///
    /// [`Law::Kanayama`], with x = x_e cos θ_e − y_e sin θ_e, which is how far the reference is ahead of the robot:
    /// −kx x², 0 and −v_r (kθ/ky) sin² θ_e. With v_r = 0 only the first is left, and it is 0 wherever the reference is
    /// beside the robot: such a robot cannot park.
    pub fn promised_rate(self, e: &ErrorPosture, k: &Gains, r: Velocity) -> Option<[f64; 3]> {
        match self {
            Law::ShimKim => Some(lyapunov_rate_parts(e, k)),
            Law::Kanayama => self.lyapunov(k).map(|Lyapunov { heading_weight }| {
                let ahead = e.x * e.cos - e.y * e.sin;
                let turning = r.linear * k.theta * heading_weight;
                [-k.x * ahead * ahead, 0.0, -turning * e.sin * e.sin]
            }),
        }
    }
}

/// The paper's Lyapunov function V = ½ x_e² + ½ y_e² + (1 − cos θ_e).
pub fn lyapunov(e: &ErrorPosture) -> f64 {
    Lyapunov::PAPER.value(e)
}

/// Its rate V̇ = x_e ẋ_e + y_e ẏ_e + sin θ_e θ̇_e for a robot that moves with `q` while the reference moves with `r`.
pub fn lyapunov_rate(e: &ErrorPosture, q: Velocity, r: Velocity) -> f64 {
    Lyapunov::PAPER.rate(e, q, r)
}

/// The three parts of V̇ under the law (5) without limits or disturbance (Theorem 1):
/// −kx x_e² cos² θ_e, −ky y_e⁴ and −kθ sin² θ_e. V̇ is their sum.
pub fn lyapunov_rate_parts(e: &ErrorPosture, k: &Gains) -> [f64; 3] {
    let (ahead, aside) = (e.x * e.cos, e.y * e.y);
    [-k.x * ahead * ahead, -k.y * aside * aside, -k.theta * e.sin * e.sin]
}

/// The gains that Theorem 2 asks for at an error posture when the disturbance is bounded by |δ1| ≤ ε1, |δ2| ≤ ε2:
/// kx > ε1 / |x_e cos θ_e| (6), ky > ε1 |sin θ_e| / |y_e|³ (7), kθ > ε2 / |sin θ_e| (8).
///
/// A bound is infinite where its divisor is 0: there no gain is large enough.
pub fn robust_gains(e: &ErrorPosture, bound: Velocity) -> Gains {
    let ratio = |dividend: f64, divisor: f64| {
        if dividend == 0.0 { 0.0 } else { dividend / divisor }
    };
    let [e1, e2] = [bound.linear.abs(), bound.angular.abs()];
    let y = e.y.abs();
    Gains::new(
        ratio(e1, (e.x * e.cos).abs()),
        ratio(e1 * e.sin.abs(), y * y * y),
        ratio(e2, e.sin.abs()),
    )
}

/// The largest V̇ that a disturbance within ±(ε1, ε2) can cause under the law (5):
/// V̇ + (|y_e sin θ_e| + |x_e cos θ_e|) ε1 + |sin θ_e| ε2, bounded term by term as in the proof of Theorem 2.
pub fn lyapunov_rate_bound(e: &ErrorPosture, k: &Gains, bound: Velocity) -> f64 {
    let [e1, e2] = [bound.linear.abs(), bound.angular.abs()];
    lyapunov_rate_parts(e, k).iter().sum::<f64>()
        + ((e.y * e.sin).abs() + (e.x * e.cos).abs()) * e1
        + e.sin.abs() * e2
}
