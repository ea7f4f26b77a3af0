//! A small arc, without a sine: polynomials that any number of robots can share.

use core::ops::{Add, Mul, Sub};

/// Up to this turn, in radians, polynomials give an arc to within a few units in the last place.
pub const SMALL_TURN: f64 = 1.0 / 14.0;

/// [`Real::along_arc`](super::Real::along_arc) for |ω dt| < [`SMALL_TURN`]: four terms of each series, as polynomials in ω².
#[inline(always)]
pub(crate) fn along_small_arc<S>(omega: S, dt: f64, splat: impl Fn(f64) -> S) -> (S, S)
where
    S: Copy + Add<Output = S> + Sub<Output = S> + Mul<Output = S>,
{
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
            let term = splat(coefficient * unit);
            unit *= dt * dt;
            term
        });
        (a - square * b) + fourth * (c - square * d)
    };
    (polynomial(sine, dt), omega * polynomial(cosine, dt * dt))
}
