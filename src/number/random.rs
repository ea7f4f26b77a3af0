//! Seeded streams of random numbers.

use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;

/// What a stream of random numbers is for. Each purpose has its own, so that showing more never shifts a draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Purpose {
    Initialisation,
    Mutation,
    Tournament,
    Disturbance,
    Starts,
}

/// The bits of the word that begins a stream: 32 of the seed, 3 of the purpose, the rest of the index.
const PURPOSE_BITS: u32 = 3;

/// The largest index of a stream.
pub(crate) const LARGEST_INDEX: u32 = (1 << (32 - PURPOSE_BITS)) - 1;

/// The stream for one purpose and one index (a generation, or a start posture), a function of these and the seed alone.
///
/// # Panics
/// If the index is larger than [`LARGEST_INDEX`]: its stream would be that of another.
pub(crate) fn stream(seed: u32, purpose: Purpose, index: u32) -> Xoshiro256PlusPlus {
    assert!(index <= LARGEST_INDEX, "there is no stream {index}");
    Xoshiro256PlusPlus::seed_from_u64(first_word(seed, purpose, index))
}

/// Another for each seed, purpose and index.
///
/// A purpose that no longer fits in its bits must not come here: it would share the streams of another. It goes into a
/// second word, through which [`SeedableRng::from_seed`] begins a stream.
const fn first_word(seed: u32, purpose: Purpose, index: u32) -> u64 {
    const { assert!((Purpose::Starts as u32) < 1 << PURPOSE_BITS) };
    (seed as u64) | (purpose as u64) << 32 | (index as u64) << (32 + PURPOSE_BITS)
}
