//! One trial solution.

use rand::{Rng, RngExt};

use super::settings::EvolutionSettings;
use crate::number::{Purpose, stream};
use crate::robot::Gains;
use crate::schema::record;

record! { (Copy)
    /// One trial solution: gains, their strategy parameters σ, and its cost.
    pub struct Individual {
        /// The gains (kx, ky, kθ).
        pub gains: Gains => "gains",
        /// The strategy parameters: the standard deviation of each gain's mutation.
        pub sigmas: [f64; 3] => "sigmas",
        /// J, the mean over the start postures; infinite if it is not finite or not yet known.
        pub cost: f64 => "cost",
    }
}

impl Individual {
    /// An individual with k_j uniform in [low, high) and σ_j the initial σ (step 1).
    fn random(settings: &EvolutionSettings, rng: &mut impl Rng) -> Self {
        let [low, high] = settings.initial_range;
        let gains = [0; 3].map(|_| low + (high - low) * rng.random::<f64>());
        Self { gains: gains.into(), sigmas: [settings.initial_sigma; 3], cost: f64::INFINITY }
    }
}

/// A population drawn from the initial range, still to be driven: k_j uniform in it and σ_j the initial σ (step 1).
///
/// There is one of each number. Evolution begins with number 0.
pub(super) fn drawn(e: &EvolutionSettings, number: u32) -> Vec<Individual> {
    let mut rng = stream(e.seed, Purpose::Initialisation, number);
    (0..e.population).map(|_| Individual::random(e, &mut rng)).collect()
}

/// The first of those with the lowest cost.
pub(crate) fn best(population: &[Individual]) -> Individual {
    let lower =
        |a: Individual, b: &Individual| if b.cost.total_cmp(&a.cost).is_lt() { *b } else { a };
    population[1..].iter().fold(population[0], lower)
}
