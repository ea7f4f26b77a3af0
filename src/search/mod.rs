//! Searches for the gains of least cost. They know gains and costs, and no robot: whoever searches asks for trials, drives
//! them, and tells what they cost.

mod settings;

mod individual;

mod mutation;

mod tournament;

mod generation;

mod random;

pub use generation::{Brood, GenerationRecord, Statistics};
pub use individual::Individual;
pub use mutation::{LearningRates, Mutation};
pub use random::RandomSearch;
pub use settings::EvolutionSettings;
pub use tournament::{Tournament, wins_bout};

pub(crate) use individual::best;

use crate::number::LARGEST_INDEX;

/// The last generation that a search can reach; the number of streams sets it.
pub const LAST_GENERATION: u32 = LARGEST_INDEX;
