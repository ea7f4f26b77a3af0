//! The numbers that the control law computes with.

use core::f64::consts::PI;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::posture::wrap;

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
    /// |self|
    fn abs(self) -> Self;
    /// `self` with its magnitude raised to `least` where it is smaller. Zeros keep their sign: −0 gives −`least`.
    fn away_from_zero(self, least: f64) -> Self;
    /// `bound` where it is smaller than `self`, else `self`; so NaN stays NaN.
    fn at_most(self, bound: Self) -> Self;
    /// `bound` where it is larger than `self`, else `self`; so NaN stays NaN.
    fn at_least(self, bound: Self) -> Self;
    /// (sin h / h, cos h) for a half turn h = `self` in radians.
    ///
    /// Side by side it holds only while |h| < [`SMALL_ANGLE`]; whoever drives many robots must see to that.
    fn sinc_cos(self) -> (Self, Self);
    /// The angle of the direction (cos, sin), in (−π, π], where `self` is the same angle but for full turns, after a half
    /// turn `h`.
    ///
    /// Side by side it gives back `self`: whoever drives many robots must see to it that |self| < π and |h| is small.
    fn kept_in_range(self, h: Self, cos: Self, sin: Self) -> Self;
}

/// Up to this half turn, in radians, four terms of the series give sin h and cos h to the last bit.
pub const SMALL_ANGLE: f64 = 1.0 / 24.0;

/// (sin h / h, cos h) for |h| < [`SMALL_ANGLE`].
#[inline]
pub(crate) fn sinc_cos_series<S: Real>(h: S) -> (S, S) {
    let z = h * h;
    let one = S::splat(1.0);
    let [a, b, c] = [1.0 / 6.0, 1.0 / 120.0, 1.0 / 5040.0].map(S::splat);
    let sinc = one - z * (a - z * (b - z * c));
    let [a, b, c] = [1.0 / 2.0, 1.0 / 24.0, 1.0 / 720.0].map(S::splat);
    let cos = one - z * (a - z * (b - z * c));
    (sinc, cos)
}

impl Real for f64 {
    #[inline]
    fn splat(value: f64) -> Self {
        value
    }

    #[inline]
    fn abs(self) -> Self {
        f64::abs(self)
    }

    #[inline]
    fn away_from_zero(self, least: f64) -> Self {
        f64::abs(self).at_least(least).copysign(self)
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
    fn sinc_cos(self) -> (Self, Self) {
        if f64::abs(self) < SMALL_ANGLE {
            sinc_cos_series(self)
        } else {
            (libm::sin(self) / self, libm::cos(self))
        }
    }

    #[inline]
    fn kept_in_range(self, h: Self, cos: Self, sin: Self) -> Self {
        if f64::abs(h) >= SMALL_ANGLE {
            // After a large turn the direction knows the angle better.
            wrap(libm::atan2(sin, cos))
        } else if f64::abs(self) >= PI {
            wrap(self)
        } else {
            self
        }
    }
}
