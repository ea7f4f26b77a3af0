//! A generation in short.

use super::generation::by_cost;
use super::individual::Individual;
use crate::schema::record;

record! { (Copy)
    /// One generation in short.
    pub struct Statistics {
        /// The generation's number.
        pub generation: u32 => "generation",
        /// Drives since the start, one for each individual and start posture. `trials`, and whoever compares methods, counts
        /// an individual once, from however many starts it drives.
        pub evaluations: f64 => "evaluations",
        /// The individual with the lowest cost of all that were driven until now.
        pub best: Individual => "best",
        /// Median cost; with an even number of individuals the mean of the two in the middle.
        pub median: f64 => "median",
        /// Highest cost.
        pub worst: f64 => "worst",
        /// Mean strategy parameter of each gain over the population.
        pub mean_sigmas: [f64; 3] => "meanSigmas",
    }
}

impl Statistics {
    /// Of a population that is left by a generation, after so many drives.
    pub(crate) fn new(
        generation: u32,
        evaluations: f64,
        best: Individual,
        population: &[Individual],
    ) -> Self {
        let ranked = by_cost(population);
        let n = ranked.len();
        let cost = |rank: usize| population[ranked[rank] as usize].cost;
        let mean = |j: usize| population.iter().map(|i| i.sigmas[j]).sum::<f64>() / n as f64;
        Self {
            generation,
            evaluations,
            best,
            median: 0.5 * (cost((n - 1) / 2) + cost(n / 2)),
            worst: cost(n - 1),
            mean_sigmas: [0, 1, 2].map(mean),
        }
    }
}
