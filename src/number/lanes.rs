//! A number of each of two robots in one SIMD register, with the bits that each robot would have alone.

use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

use wide::f64x2;

use super::real::{Real, along_small_arc};

/// How many robots share a register.
pub(crate) const LANES: usize = 2;

/// A number of each of the robots that share a register.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lanes(f64x2);

impl Lanes {
    #[inline(always)]
    pub(crate) fn lane(&self, index: usize) -> f64 {
        self.0.as_array()[index]
    }

    #[inline(always)]
    pub(crate) fn set(&mut self, index: usize, value: f64) {
        self.0.as_mut_array()[index] = value;
    }
}

/// Masks of lanes.
impl Lanes {
    #[inline(always)]
    pub(crate) fn under(self, bound: f64) -> Self {
        Self(self.0.simd_lt(f64x2::splat(bound)))
    }

    #[inline(always)]
    pub(crate) fn over(self, bound: f64) -> Self {
        Self(self.0.simd_gt(f64x2::splat(bound)))
    }

    #[inline(always)]
    pub(crate) fn all(self) -> bool {
        self.0.all()
    }

    pub(crate) fn is_set(&self, index: usize) -> bool {
        self.lane(index).to_bits() != 0
    }
}

macro_rules! lanewise {
    ($($operator:ident $function:ident),*) => {$(
        impl $operator for Lanes {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self(self.0.$function(other.0))
            }
        }
    )*};
}

lanewise!(Add add, Sub sub, Mul mul, Div div, BitAnd bitand, BitOr bitor);

impl Neg for Lanes {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Lanes {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self(f64x2::splat(value))
    }

    // SSE2 and WebAssembly have these as one instruction each, which differ in which operand they give back when neither
    // is the smaller: when one is NaN, or when both are zero. The minimum of other machines is yet another function.
    #[inline(always)]
    fn at_most(self, Self(bound): Self) -> Self {
        Self(if cfg!(target_feature = "sse2") {
            bound.fast_min(self.0)
        } else if cfg!(target_feature = "simd128") {
            self.0.fast_min(bound)
        } else {
            bound.simd_lt(self.0).select(bound, self.0)
        })
    }

    #[inline(always)]
    fn at_least(self, Self(bound): Self) -> Self {
        Self(if cfg!(target_feature = "sse2") {
            bound.fast_max(self.0)
        } else if cfg!(target_feature = "simd128") {
            self.0.fast_max(bound)
        } else {
            bound.simd_gt(self.0).select(bound, self.0)
        })
    }

    #[inline(always)]
    fn along_arc(self, dt: f64) -> (Self, Self) {
        along_small_arc(self, dt)
    }

    #[inline(always)]
    fn kept_in_range(self, _turn: Self, _cos: Self, _sin: Self) -> Self {
        self
    }
}
