//! Random search: as many trials, and nothing learnt from them.

use super::generation::{Brood, GenerationRecord};
use super::individual::drawn;
use super::search::{Found, Search, found};
use super::settings::EvolutionSettings;
use crate::robot::Gains;

/// Draws a new population from the initial range in each generation. In generation 0 it is what evolution begins with.
#[derive(Clone, Debug, Default)]
pub struct RandomSearch(Found);

impl Search for RandomSearch {
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood {
        Brood::beside(&self.0.population, drawn(e, generation), generation)
    }

    fn tell(&mut self, _: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord {
        let record = brood.with_costs(costs).survived_by_offspring();
        self.0.follow(&record);
        record
    }

    found!(0);
}

/// What random search tries, without its generations.
#[derive(Clone, Debug, Default)]
pub(crate) struct Draws {
    generation: u32,
    waiting: Vec<Gains>,
}

impl Draws {
    /// The next so many.
    pub(crate) fn next(&mut self, e: &EvolutionSettings, count: usize) -> Vec<Gains> {
        while self.waiting.len() < count {
            self.waiting.extend(drawn(e, self.generation).into_iter().map(|one| one.gains));
            self.generation += 1;
        }
        self.waiting.drain(..count).collect()
    }
}
