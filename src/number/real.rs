//! The numbers that the control law computes with.

use core::f64::consts::{PI, TAU};
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::small_arc::{SMALL_TURN, along_small_arc};

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
            along_small_arc(self, dt, Self::splat)
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

/// The angle in (−π, π] that points the same way as this one, which is finite. The larger it is, the less of its direction is
/// left in it: beyond 10¹⁵ rad nothing.
pub fn wrap(angle: f64) -> f64 {
    let wrapped = angle - TAU * ((angle - PI) / TAU).ceil();
    // Rounding can leave it just outside.
    if wrapped <= -PI || wrapped > PI { PI } else { wrapped }
}
