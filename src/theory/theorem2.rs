//! Theorem 2: the gains that a bounded disturbance asks for, and the errors that it can leave.

use super::lyapunov::theorem_1_rate;
use crate::number::Real;
use crate::robot::{ErrorPosture, Gains, Velocity};

/// The gains that Theorem 2 asks for at an error posture when the disturbance is bounded by |δ1| ≤ ε1, |δ2| ≤ ε2:
/// kx > ε1 / |x_e cos θ_e| (6), ky > ε1 |sin θ_e| / |y_e|³ (7), kθ > ε2 / |sin θ_e| (8).
///
/// A bound is infinite where only its divisor is 0: there no gain is large enough. Where its dividend is 0 any gain over 0 does.
pub fn robust_gains(e: &ErrorPosture, bound: Velocity) -> Gains {
    let ratio = |dividend: f64, divisor: f64| {
        if dividend == 0.0 { 0.0 } else { dividend / divisor }
    };
    let Velocity { linear: e1, angular: e2 } = bound.map(f64::abs);
    let ErrorSizes { x, y, theta } = ErrorSizes::new(e);
    Gains::new(ratio(e1, x), ratio(e1 * theta, y * y * y), ratio(e2, theta))
}

/// A bound on V̇, in m²/s, that no disturbance within ±(ε1, ε2) exceeds under the law (5), wherever none of its divisors is
/// guarded ([`SMALLEST_DIVISOR`](crate::robot::SMALLEST_DIVISOR)):
/// V̇ + (|y_e sin θ_e| + |x_e cos θ_e|) ε1 + |sin θ_e| ε2, bounded term by term as in the proof of Theorem 2. It is reached only where
/// the two parts of ε1 do not cancel.
pub fn lyapunov_rate_bound(e: &ErrorPosture, k: &Gains, bound: Velocity) -> f64 {
    let Velocity { linear: e1, angular: e2 } = bound.map(f64::abs);
    let ErrorSizes { x, theta, .. } = ErrorSizes::new(e);
    theorem_1_rate(e, k).total() + ((e.y * e.sin).abs() + x) * e1 + theta * e2
}

/// The three sizes of an error posture that Theorem 2 bounds one by one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorSizes {
    /// |x_e cos θ_e| in metres, which (6) bounds.
    pub x: f64,
    /// |y_e| in metres, which (7) bounds.
    pub y: f64,
    /// |sin θ_e|, without a unit, which (8) bounds.
    pub theta: f64,
}

impl ErrorSizes {
    /// Those of an error posture.
    pub fn new(e: &ErrorPosture) -> Self {
        Self { x: (e.x * e.cos).abs(), y: e.y.abs(), theta: e.sin.abs() }
    }

    /// The larger of each.
    pub(crate) fn max(self, other: Self) -> Self {
        Self {
            x: self.x.at_least(other.x),
            y: self.y.at_least(other.y),
            theta: self.theta.at_least(other.theta),
        }
    }

    pub(crate) const ZERO: Self = Self { x: 0.0, y: 0.0, theta: 0.0 };
    pub(crate) const INFINITE: Self =
        Self { x: f64::INFINITY, y: f64::INFINITY, theta: f64::INFINITY };
}

/// How far the sets reach in which a part of V̇ can be 0 or more although |δ1| ≤ ε1 and |δ2| ≤ ε2.
///
/// They are Theorem 2's inequalities solved for the error: |x_e cos θ_e| ≤ ε1 / kx (6),
/// |y_e|³ ≤ ε1 |sin θ_e| / ky (7), |sin θ_e| ≤ ε2 / kθ (8). The one of y_e depends on the heading, so it is that for
/// `sin` = sin θ_e. Outside all three, V̇ < 0 for the law (5) without limits, in continuous time
/// and wherever none of its divisors is guarded; outside one of them
/// only its own part is negative. A gain that is not over 0 makes no part negative: its set has no end.
pub fn theorem_2_sets(k: &Gains, bound: Velocity, sin: f64) -> ErrorSizes {
    let quotient = |push: f64, gain: f64| if gain > 0.0 { push / gain } else { f64::INFINITY };
    let Velocity { linear: e1, angular: e2 } = bound.map(f64::abs);
    ErrorSizes {
        x: quotient(e1, k.x),
        y: libm::cbrt(quotient(e1 * sin.abs(), k.y)),
        theta: quotient(e2, k.theta),
    }
}
