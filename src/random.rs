//! Seeded streams of random numbers.

use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;

/// What a stream of random numbers is for. Each purpose has its own, so that showing more never shifts a draw.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Purpose {
    Initialisation = 0,
    Mutation = 1,
    Tournament = 2,
    Disturbance = 3,
    Starts = 4,
}

/// What seed and purpose leave of the 64 bits that begin a stream.
pub(crate) const LARGEST_INDEX: u32 = (1 << 29) - 1;

/// The stream for one purpose and one index (a generation, or a start posture), a function of these and the seed alone.
///
/// Index must be at most [`LARGEST_INDEX`].
pub(crate) fn stream(seed: u32, purpose: Purpose, index: u32) -> Xoshiro256PlusPlus {
    debug_assert!(index <= LARGEST_INDEX);
    let state = u64::from(seed) | (purpose as u64) << 32 | u64::from(index) << 35;
    Xoshiro256PlusPlus::seed_from_u64(state)
}
