//! The numbers that the control law computes with.

use core::f64::consts::{PI, TAU};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or several side by side: whatever the law, the limits and the motion are computed with.
///
/// The formulas are written once over this trait. Every operation is exactly rounded or built of such operations, so
/// that a robot's run has the same bits on every machine, alone or beside others.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The same value for every robot.
    fn splat(value: f64) -> Self;
    /// `bound` where it is smaller than `self`, else `self`; so NaN stays NaN.
    fn at_most(self, bound: Self) -> Self;
    /// `bound` where it is larger than `self`, else `self`; so NaN stays NaN.
    fn at_least(self, bound: Self) -> Self;
    /// (sin ωt / ω, (1 − cos ωt) / ω) for a turn rate ω = `self` in rad/s and a time t = `dt` in seconds: how far ahead
    /// and how far aside a unit speed leads on the way.
    ///
    /// Side by side it holds only while |ωt| < [`SMALL_TURN`]; whoever drives many robots must see to that.
    fn along_arc(self, dt: f64) -> (Self, Self);
    /// The angle of the direction (cos, sin), in (−π, π], where `self` is the same angle but for full turns, after a turn
    /// by `turn`.
    ///
    /// Side by side it gives back `self`: whoever drives many robots must see to it that |self| < π and |turn| is small.
    fn kept_in_range(self, turn: Self, cos: Self, sin: Self) -> Self;
}

impl Real for f64 {
    #[inline]
    fn splat(value: f64) -> Self {
        value
    }

    #[inline]
    fn at_most(self, bound: Self) -> Self {
        if bound < self { bound } else { self }
    }

    #[inline]
    fn at_least(self, bound: Self) -> Self {
        if bound > self { bound } else { self }
    }

    #[inline]
    fn along_arc(self, dt: f64) -> (Self, Self) {
        if (self * dt).abs() < SMALL_TURN {
            along_small_arc(self, dt)
        } else {
            let h = 0.5 * self * dt;
            let (sin, cos) = libm::sincos(h);
            let chord = dt * (sin / h);
            (chord * cos, chord * sin)
        }
    }

    #[inline]
    fn kept_in_range(self, turn: Self, cos: Self, sin: Self) -> Self {
        if turn.abs() >= SMALL_TURN {
            // After a large turn the direction knows the angle better.
            wrap(libm::atan2(sin, cos))
        } else if self.abs() >= PI {
            wrap(self)
        } else {
            self
        }
    }
}

/// Up to this turn, in radians, polynomials give an arc to within a few units in the last place.
pub const SMALL_TURN: f64 = 1.0 / 14.0;

/// [`Real::along_arc`] for |ω dt| < [`SMALL_TURN`], without a sine: four terms of each series, as polynomials in ω².
#[inline(always)]
pub(super) fn along_small_arc<S: Real>(omega: S, dt: f64) -> (S, S) {
    // The sine has a fifth term, z⁴/9! with z = (ω dt)². In its place is the cubic that is nearest to it for z ≤ m.
    const M: f64 = SMALL_TURN * SMALL_TURN;
    const FIFTH: f64 = 1.0 / 362_880.0;
    let sine = [
        1.0,
        1.0 / 6.0 - 0.25 * M * M * M * FIFTH,
        1.0 / 120.0 - 1.25 * M * M * FIFTH,
        1.0 / 5040.0 - 2.0 * M * FIFTH,
    ];
    let cosine = [1.0 / 2.0, 1.0 / 24.0, 1.0 / 720.0, 1.0 / 40320.0];
    let square = omega * omega;
    let fourth = square * square;
    let polynomial = |coefficients: [f64; 4], mut unit: f64| {
        let [a, b, c, d] = coefficients.map(|coefficient| {
            let term = S::splat(coefficient * unit);
            unit *= dt * dt;
            term
        });
        (a - square * b) + fourth * (c - square * d)
    };
    (polynomial(sine, dt), omega * polynomial(cosine, dt * dt))
}

/// The angle in (−π, π] that points the same way as this one, which is finite. The larger it is, the less of its direction is
/// left in it: at 10¹⁵ rad it is wrong by up to 0.2 rad, beyond 10¹⁷ nothing is left.
pub fn wrap(angle: f64) -> f64 {
    let wrapped = angle - TAU * ((angle - PI) / TAU).ceil();
    // Rounding can leave it just outside.
    if wrapped <= -PI || wrapped > PI { PI } else { wrapped }
}
