//! The posture controller: the paper's law (5), and the rule that it improves on.

use super::error::ErrorPosture;
use super::gains::Gains;
use super::posture::Velocity;
use crate::number::Real;
use crate::schema::{told, words};

words! { input
    /// The control law: how the commanded velocity follows from the error posture.
    pub enum Law {
        /// The law (5) of the paper, from Shim and Kim (1994).
        ShimKim = "shim-kim",
        /// The rule of Kanayama et al. (1990), which the paper improves on.
        Kanayama = "kanayama",
    }
}

/// Where |sin θ_e| or |cos θ_e| is smaller than this, the law divides by this instead, with their sign. The paper does not say
/// what happens there; the guard and its size are our choice.
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

told! {
    /// What each gain asks for, and the reference velocity by itself: the command is their sum, up to rounding.
    CommandTerms: CommandTerms {
        /// What kx asks for.
        "kx" => |terms| terms.gains[0],
        /// What ky asks for.
        "ky" => |terms| terms.gains[1],
        /// What kθ asks for.
        "ktheta" => |terms| terms.gains[2],
        /// What the reference velocity asks for.
        "reference" => |terms| terms.reference,
    }
}

impl Law {
    /// The terms of [`Law::command`], which is their sum, up to rounding.
    ///
    /// Both laws are linear in their gains: a term is what the command is with this gain alone, less what it is with none.
    /// In the law (5) it is the same with the reference at rest, where there is nothing to take away, and no digit is lost.
    pub fn terms(self, e: &ErrorPosture, k: &Gains, r: Velocity) -> CommandTerms {
        let asked = |k: Gains, r| self.command(e, &k, r);
        let none = Gains::new(0.0, 0.0, 0.0);
        let reference = asked(none, r);
        let term = |alone: Gains| match self {
            Law::ShimKim => asked(alone, Velocity::ZERO),
            Law::Kanayama => {
                let all = asked(alone, r);
                Velocity {
                    linear: all.linear - reference.linear,
                    angular: all.angular - reference.angular,
                }
            }
        };
        let gains =
            [Gains::new(k.x, 0.0, 0.0), Gains::new(0.0, k.y, 0.0), Gains::new(0.0, 0.0, k.theta)];
        CommandTerms { gains: gains.map(term), reference }
    }
}
