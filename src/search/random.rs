//! Random search: a new population from the initial range for each generation.

use super::individual::drawn;
use super::settings::EvolutionSettings;
use crate::robot::Gains;

/// What evolution is compared with: as many trials, and nothing learnt from them.
#[derive(Clone, Debug)]
pub struct RandomSearch {
    settings: EvolutionSettings,
    lowest: f64,
}

impl RandomSearch {
    /// A search in the initial range of these settings, which has tried nothing yet.
    pub fn new(settings: EvolutionSettings) -> Self {
        Self { settings, lowest: f64::INFINITY }
    }

    /// What to drive in a generation. In generation 0 it is what evolution begins with.
    pub fn trials(&self, generation: u32) -> Vec<Gains> {
        drawn(&self.settings, generation).iter().map(|individual| individual.gains).collect()
    }

    /// The lowest cost until now, after trials that cost this.
    pub fn driven(&mut self, costs: &[f64]) -> f64 {
        self.lowest = costs.iter().copied().fold(self.lowest, f64::min);
        self.lowest
    }
}
