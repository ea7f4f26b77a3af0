//! Seeded streams of random numbers.

use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;

macro_rules! purposes {
    ($($(#[$about:meta])* $name:ident,)*) => {
        /// What a stream of random numbers is for. Each purpose has its own, so that showing more never shifts a draw.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub(crate) enum Purpose { $($(#[$about])* $name,)* }

        #[cfg(test)]
        const PURPOSES: &[Purpose] = &[$(Purpose::$name,)*];
    };
}

// New ones go to the end: where a stream begins depends on the place.
purposes! {
    Initialisation,
    Mutation,
    Tournament,
    Disturbance,
    Starts,
    /// Steps that are not those of the paper's mutation.
    Steps,
    /// Which other solutions go into a new one.
    Partners,
}

/// The bits of the word that begins a stream: 32 of the seed, 3 of the purpose, the rest of the index.
const PURPOSE_BITS: u32 = 3;

/// What those bits are for purposes after the first five, which are told apart by a second word.
const LATER: u64 = (1 << PURPOSE_BITS) - 1;

/// The largest index of a stream.
pub(crate) const LARGEST_INDEX: u32 = (1 << (32 - PURPOSE_BITS)) - 1;

/// The stream for one purpose and one index (a generation, or a start posture), a function of these and the seed alone.
///
/// # Panics
/// If the index is larger than [`LARGEST_INDEX`]: its stream would be that of another.
pub(crate) fn stream(seed: u32, purpose: Purpose, index: u32) -> Xoshiro256PlusPlus {
    assert!(index <= LARGEST_INDEX, "there is no stream {index}");
    let [word, later] = words(seed, purpose, index);
    if later == 0 {
        return Xoshiro256PlusPlus::seed_from_u64(word);
    }
    begun(state(word, later))
}

/// The stream that begins in this state.
fn begun(state: [u64; 4]) -> Xoshiro256PlusPlus {
    let mut bytes = [0; 32];
    for (place, number) in bytes.chunks_exact_mut(8).zip(state) {
        place.copy_from_slice(&number.to_le_bytes());
    }
    Xoshiro256PlusPlus::from_seed(bytes)
}

/// Two words, others for each seed, purpose and index. The second is 0 for the first five purposes.
const fn words(seed: u32, purpose: Purpose, index: u32) -> [u64; 2] {
    const { assert!((Purpose::Starts as u64) < LATER) };
    let later = (purpose as u64).saturating_sub(Purpose::Starts as u64);
    let purpose = if later == 0 { purpose as u64 } else { LATER };
    [(seed as u64) | purpose << 32 | (index as u64) << (32 + PURPOSE_BITS), later]
}

/// The state in which a stream begins: that of the first word alone (SplitMix64), but for the last number.
///
/// Its first number is another for each first word, because every operation there can be undone; and for one first word
/// its last is another for each second word. So no two streams begin in the same state.
fn state(word: u64, later: u64) -> [u64; 4] {
    let mut state = [1, 2, 3, 4].map(|n: u64| {
        let z = word.wrapping_add(n.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    });
    state[3] ^= later;
    state
}

#[cfg(test)]
mod tests {
    use rand::Rng;

    use super::*;

    fn each_stream<T>(of: impl Fn(u32, Purpose, u32) -> T) -> Vec<T> {
        let indices = [0, 1, 7, 8, LARGEST_INDEX];
        let mut all = Vec::new();
        for &purpose in PURPOSES {
            for seed in [0, 1, u32::MAX] {
                all.extend(indices.map(|index| of(seed, purpose, index)));
            }
        }
        all
    }

    #[track_caller]
    fn assert_distinct<T: Ord + Clone>(all: &[T]) {
        let mut sorted = all.to_vec();
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(sorted.len(), all.len());
    }

    #[test]
    fn no_two_streams_begin_with_the_same_words_or_in_the_same_state() {
        assert_distinct(&each_stream(words));
        assert_distinct(&each_stream(|seed, purpose, index| {
            let [word, later] = words(seed, purpose, index);
            state(word, later)
        }));
        assert_distinct(&each_stream(|seed, purpose, index| {
            stream(seed, purpose, index).next_u64()
        }));
    }

    #[test]
    fn the_first_five_purposes_begin_as_they_always_did() {
        // Links made with these words must go on giving the same runs.
        assert_eq!(words(7, Purpose::Tournament, 3), [7 | 2 << 32 | 3 << 35, 0]);
        for (purpose, word) in [(Purpose::Initialisation, 9), (Purpose::Starts, 9 | 4 << 32)] {
            assert_eq!(stream(9, purpose, 0), Xoshiro256PlusPlus::seed_from_u64(word));
        }
    }

    /// A generator that is begun with one word begins in the state of that word.
    #[test]
    fn the_later_purposes_begin_beside_the_state_of_their_first_word() {
        assert_eq!(begun(state(42, 0)), Xoshiro256PlusPlus::seed_from_u64(42));
        assert_ne!(stream(1, Purpose::Steps, 0), stream(1, Purpose::Partners, 0));
    }
}
