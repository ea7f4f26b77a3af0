//! Down the slope, which finite differences tell.

use super::generation::{Brood, GenerationRecord};
use super::individual::{Individual, first_drawn};
use super::plan::Plan;
use super::search::{Found, Search, found};
use super::settings::EvolutionSettings;
use super::symmetric::{UNIT, Vector, dot, plus};
use crate::number::Real;

/// Descent from a draw of the initial range: a probe beside it in each gain tells the slope, and steps down the slope are
/// tried, each half as long as the one before, until J falls, and then one twice as long.
#[derive(Clone, Debug, Default)]
pub struct FiniteDifferences {
    found: Found,
    /// How much J rises by each gain; nothing while it is to be found.
    slope: Option<Vector>,
    /// How far the next step goes.
    length: f64,
}

/// How far beside the point a slope is probed.
const PROBE: f64 = 1e-4;

/// Where a step is as short as this, the slope is probed again.
const SHORTEST: f64 = 1e-6;

impl Search for FiniteDifferences {
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood {
        let Some(point) = self.found.population.first() else {
            return Brood::initial(vec![first_drawn(e, 0)]);
        };
        let k = point.gains.to_array();
        let trials = match self.direction() {
            None => UNIT.map(|axis| plus(k, PROBE, axis)).to_vec(),
            Some(direction) => vec![plus(k, self.length, direction)],
        };
        let trial = |gains| Individual::new(e.tried(gains), point.sigmas);
        let trials = trials.into_iter().map(trial).collect();
        Brood::beside(&self.found.population, trials, generation)
    }

    fn tell(&mut self, e: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord {
        let brood = brood.with_costs(costs);
        let record = match (brood.generation, self.slope) {
            (0, _) => {
                self.length = e.initial_sigma;
                brood.founded()
            }
            (_, None) => {
                let here = brood.parents[0].cost;
                let slope = [0, 1, 2].map(|j| (brood.offspring[j].cost - here) / PROBE);
                let steepness = steepness(slope);
                // Where it is level, or no slope can be told, another probe finds the same.
                self.slope = (steepness > 0.0 && steepness.is_finite()).then_some(slope);
                brood.survived_by(&|number| number == 0)
            }
            (_, Some(_)) => {
                let is_better = brood.offspring[0].is_better_than(&brood.parents[0]);
                self.length *= if is_better { 2.0 } else { 0.5 };
                if is_better || self.length < SHORTEST {
                    self.slope = None;
                }
                self.length = self.length.at_least(SHORTEST);
                brood.survived_by(&|number| (number == 1) == is_better)
            }
        };
        self.found.follow(&record);
        self.found.population[0].sigmas = [self.length; 3];
        record
    }

    fn plan(&self, _: &EvolutionSettings) -> Plan {
        let steps = self.direction().map(|direction| direction.map(|way| self.length * way));
        Plan { slope: self.slope, steps, ..Plan::default() }
    }

    found!(found);
}

impl FiniteDifferences {
    /// The direction in which J falls, of length 1.
    fn direction(&self) -> Option<Vector> {
        self.slope.map(|slope| slope.map(|s| -s / steepness(slope)))
    }
}

fn steepness(slope: Vector) -> f64 {
    dot(slope, slope).sqrt()
}
