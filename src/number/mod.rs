//! Numbers: the scalar that everything is computed with, alone or side by side, and seeded streams of random ones.

mod small_arc;

mod real;

mod lanes;

mod random;

pub use real::{Real, wrap};
pub use small_arc::SMALL_TURN;

pub(crate) use lanes::{LANES, Lanes};
pub(crate) use random::{LARGEST_INDEX, Purpose, stream};
