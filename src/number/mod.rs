//! Numbers: the scalar that everything is computed with, alone or side by side, and seeded streams of random ones.

mod real;

mod lanes;

mod random;

pub use real::{Real, SMALL_TURN, wrap};

pub(crate) use lanes::{LANES, Lanes};
pub(crate) use random::{LARGEST_INDEX, Purpose, stream};
