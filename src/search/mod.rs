//! Searches for the gains of least cost. They know gains and costs, and no robot: whoever searches asks for new solutions,
//! drives them, and tells what they cost.
#![doc = include_str!("METHODS.md")]

mod settings;

mod individual;

mod mutation;

mod tournament;

mod plan;

mod generation;

mod statistics;

#[allow(clippy::module_inception)]
mod search;

mod evolutionary_programming;

mod random;

mod symmetric;

mod differential_evolution;

mod cma_es;

mod one_plus_one;

mod nelder_mead;

mod one_at_a_time;

mod finite_differences;

mod methods;

pub use cma_es::CmaEs;
pub use differential_evolution::DifferentialEvolution;
pub use evolutionary_programming::EvolutionaryProgramming;
pub use finite_differences::FiniteDifferences;
pub use generation::{Brood, GenerationRecord, Making};
pub use individual::Individual;
pub use methods::search;
pub use mutation::{LearningRates, Mutation};
pub use nelder_mead::NelderMead;
pub use one_at_a_time::OneAtATime;
pub use one_plus_one::OnePlusOne;
pub use plan::{Ellipse, Motion, Plan};
pub use random::RandomSearch;
pub use search::Search;
pub use settings::{BelowZero, EvolutionSettings, Method, Selection, Step};
pub use statistics::Statistics;
pub use tournament::{Tournament, wins_bout};

pub(crate) use random::Draws;

use crate::number::LARGEST_INDEX;

/// The last generation that a search can reach; the number of streams sets it.
pub const LAST_GENERATION: u32 = LARGEST_INDEX;
