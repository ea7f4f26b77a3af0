//! The numbers that the control law computes with.

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
    /// |self|
    fn abs(self) -> Self;
    /// The magnitude of `self` with the sign of `sign`, as IEEE 754 has it: −0 is negative.
    fn copysign(self, sign: Self) -> Self;
    /// `bound` where it is smaller than `self`, else `self`; so NaN stays NaN.
    fn at_most(self, bound: Self) -> Self;
    /// `bound` where it is larger than `self`, else `self`; so NaN stays NaN.
    fn at_least(self, bound: Self) -> Self;
    /// The value of the robot with this index.
    fn lane(self, index: usize) -> f64;
    /// Whether `|self|` is at least `limit` for any robot.
    fn any_beyond(self, limit: f64) -> bool;
    /// `exact(index)` for each robot whose `|angle|` is at least `limit`, `self` for the others.
    ///
    /// It is meant for what happens seldom, such as an angle that leaves (−π, π].
    fn replaced_beyond(self, angle: Self, limit: f64, exact: impl Fn(usize) -> f64) -> Self;
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
    fn copysign(self, sign: Self) -> Self {
        f64::copysign(self, sign)
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
    fn lane(self, _index: usize) -> f64 {
        self
    }

    #[inline]
    fn any_beyond(self, limit: f64) -> bool {
        f64::abs(self) >= limit
    }

    #[inline]
    fn replaced_beyond(self, angle: Self, limit: f64, exact: impl Fn(usize) -> f64) -> Self {
        if f64::abs(angle) >= limit { exact(0) } else { self }
    }
}
