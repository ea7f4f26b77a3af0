//! One gain after the other, as a hand does it.

use super::generation::{Brood, GenerationRecord};
use super::individual::{Individual, first_drawn};
use super::plan::Plan;
use super::search::{Found, Search, found};
use super::settings::EvolutionSettings;

/// Each gain in turn takes a step. Where J falls it stays there, and its next step goes further; where not it goes back, and
/// its next step is shorter and the other way.
#[derive(Clone, Debug, Default)]
pub struct OneAtATime {
    found: Found,
    /// The next step of each gain, with its direction.
    steps: [f64; 3],
}

/// The next step after a success, as a factor.
const FURTHER: f64 = 2.0;

/// The next step after a failure, as a factor.
const BACK: f64 = -0.5;

impl Search for OneAtATime {
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood {
        let Some(point) = self.found.population.first() else {
            return Brood::initial(vec![first_drawn(e, 0)]);
        };
        let mut gains = point.gains.to_array();
        let turn = turn(generation);
        gains[turn] += self.steps[turn];
        let trial = Individual::new(e.tried(gains), self.after(generation, FURTHER).map(f64::abs));
        Brood::beside(&self.found.population, vec![trial], generation)
    }

    fn tell(&mut self, e: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord {
        let brood = brood.with_costs(costs);
        if brood.generation == 0 {
            self.steps = [e.initial_sigma; 3];
            let record = brood.founded();
            self.found.follow(&record);
            return record;
        }
        let is_better = brood.offspring[0].is_better_than(&brood.parents[0]);
        let record = brood.survived_by(&|number| (number == 1) == is_better);
        self.found.follow(&record);
        self.steps = self.after(record.generation, if is_better { FURTHER } else { BACK });
        self.found.population[0].sigmas = self.steps.map(f64::abs);
        record
    }

    fn plan(&self, _: &EvolutionSettings) -> Plan {
        let has_begun = !self.found.population.is_empty();
        Plan { steps: has_begun.then_some(self.steps), ..Plan::default() }
    }

    found!(found);
}

/// Whose turn it is.
fn turn(generation: u32) -> usize {
    (generation as usize - 1) % 3
}

impl OneAtATime {
    /// The steps once the one of this generation is so many times as long.
    fn after(&self, generation: u32, factor: f64) -> [f64; 3] {
        let mut steps = self.steps;
        steps[turn(generation)] *= factor;
        steps
    }
}
