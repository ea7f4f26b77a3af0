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
        /// The strategy parameters: the standard deviation of each gain's mutation, of Cauchy's steps their scale. Of
        /// CMA-ES the one it was drawn with; of a method that goes from point to point, of a parent the next step, of what was
        /// tried the step after a success, but of finite differences the step that led to it; of random search the initial σ;
        /// else 0.
        pub sigmas: [f64; 3] => "sigmas",
        /// J, the mean over the start postures; infinite if it is not finite or not yet known.
        pub cost: f64 => "cost",
    }
}

impl Individual {
    /// Gains that are still to be driven.
    pub(super) fn new(gains: Gains, sigmas: [f64; 3]) -> Self {
        Self { gains, sigmas, cost: f64::INFINITY }
    }

    /// An individual with k_j uniform in [low, high) and σ_j the initial σ (step 1).
    fn random(e: &EvolutionSettings, rng: &mut impl Rng) -> Self {
        let [low, high] = e.initial_range;
        let gains = [0; 3].map(|_| low + (high - low) * rng.random::<f64>());
        Self::new(e.tried(gains), [e.first_sigma(); 3])
    }

    /// Whether its cost is lower.
    pub(super) fn is_better_than(&self, other: &Self) -> bool {
        self.cost.total_cmp(&other.cost).is_lt()
    }
}

/// A population drawn from the initial range, still to be driven: k_j uniform in it and σ_j the initial σ (step 1).
///
/// There is one of each number. Evolution begins with number 0.
pub(super) fn drawn(e: &EvolutionSettings, number: u32) -> Vec<Individual> {
    let mut rng = stream(e.seed, Purpose::Initialisation, number);
    (0..e.population).map(|_| Individual::random(e, &mut rng)).collect()
}

/// The first individual of such a population: where a method that goes from one point to the next sets out.
pub(super) fn first_drawn(e: &EvolutionSettings, number: u32) -> Individual {
    Individual::random(e, &mut stream(e.seed, Purpose::Initialisation, number))
}

/// The first of those with the lowest cost.
pub(crate) fn best(population: &[Individual]) -> Individual {
    let lower = |a: Individual, b: &Individual| if b.is_better_than(&a) { *b } else { a };
    population[1..].iter().fold(population[0], lower)
}
