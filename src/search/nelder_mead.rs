//! The simplex method of Nelder and Mead (1965), with the decisions of Lagarias et al. (1998), begun anew where the simplex has shrunk to a point.

use super::generation::{Brood, GenerationRecord};
use super::individual::{Individual, best, first_drawn};
use super::plan::{Motion, Plan};
use super::search::{Found, Search, found};
use super::settings::EvolutionSettings;
use super::symmetric::{UNIT, Vector, plus};
use crate::number::Real;

/// Four corners, of which the worst is to be replaced.
///
/// While a second trial is to decide over a reflected corner, that stands beside the four.
#[derive(Clone, Debug)]
pub struct NelderMead {
    found: Found,
    /// What is tried next.
    motion: Motion,
    /// How often it has begun.
    begun: u32,
}

/// A simplex of which no corner is farther from the best than this in any gain begins anew.
const SMALLEST: f64 = 1e-4;

impl Default for NelderMead {
    fn default() -> Self {
        Self { found: Found::default(), motion: Motion::Begin, begun: 0 }
    }
}

impl Search for NelderMead {
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood {
        let trials = match self.motion {
            Motion::Begin => corners(e, self.begun),
            Motion::Shrink => {
                let [lowest, others @ ..] = self.simplex();
                others.map(|corner| between(corner, lowest, 0.5)).to_vec()
            }
            Motion::Reflection => vec![self.beyond(1.0)],
            Motion::Expansion => vec![self.beyond(2.0)],
            Motion::OutsideContraction => vec![self.beyond(0.5)],
            Motion::InsideContraction => vec![self.beyond(-0.5)],
        };
        let new = |gains: Vector| Individual::new(e.tried(gains), [0.0; 3]);
        let trials = trials.into_iter().map(new).collect();
        Brood::beside(&self.found.population, trials, generation)
    }

    fn tell(&mut self, _: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord {
        let brood = brood.with_costs(costs);
        let trial = best(&brood.offspring);
        let (survives, next) = match self.motion {
            Motion::Begin => ([false; 6], Motion::Reflection),
            Motion::Shrink => ([true, false, false, false, false, false], Motion::Reflection),
            _ => self.decided(&trial),
        };
        // What shrinks, and what begins, is taken whatever it costs.
        let (parents, is_new) = (brood.parents.len(), costs.len() > 1);
        let record = brood.survived_by(&|number| match number.checked_sub(parents) {
            None => survives[number],
            Some(_) => is_new || survives[5],
        });
        self.begun += u32::from(self.motion == Motion::Begin);
        self.found.follow(&record);
        self.motion = next;
        if next == Motion::Reflection && self.is_small() {
            self.motion = Motion::Begin;
        }
        record
    }

    fn plan(&self, _: &EvolutionSettings) -> Plan {
        let corners = match self.motion {
            Motion::Begin => Vec::new(),
            _ => self.parted().0.map(|number| number as u32).to_vec(),
        };
        Plan { motion: Some(self.motion), corners, ..Plan::default() }
    }

    found!(found);
}

impl NelderMead {
    /// Which of the five that stand, and whether the trial, survive; and what comes next.
    fn decided(&self, trial: &Individual) -> ([bool; 6], Motion) {
        let all = &self.found.population;
        // A reflected corner stands among the four where it was ranked.
        let (simplex, reflected) = self.parted();
        let [lowest, third, worst] = [0, 2, 3].map(|rank| all[simplex[rank]]);
        let keep = |gone: &[usize], trial_stays: bool| {
            let mut survives = [false; 6];
            (0..all.len()).for_each(|number| survives[number] = !gone.contains(&number));
            survives[5] = trial_stays;
            survives
        };
        let worst_number = simplex[3];
        match (self.motion, reflected) {
            (Motion::Expansion, Some(number)) if trial.is_better_than(&all[number]) => {
                (keep(&[worst_number, number], true), Motion::Reflection)
            }
            (Motion::Expansion, Some(_)) => (keep(&[worst_number], false), Motion::Reflection),
            (Motion::OutsideContraction, Some(number)) if !all[number].is_better_than(trial) => {
                (keep(&[worst_number, number], true), Motion::Reflection)
            }
            (Motion::InsideContraction, _) if trial.is_better_than(&worst) => {
                (keep(&[worst_number], true), Motion::Reflection)
            }
            (Motion::OutsideContraction, Some(number)) => (keep(&[number], false), Motion::Shrink),
            (Motion::InsideContraction, _) => (keep(&[], false), Motion::Shrink),
            _ if trial.is_better_than(&lowest) => (keep(&[], true), Motion::Expansion),
            _ if trial.is_better_than(&third) => (keep(&[worst_number], true), Motion::Reflection),
            _ if trial.is_better_than(&worst) => (keep(&[], true), Motion::OutsideContraction),
            _ => (keep(&[], false), Motion::InsideContraction),
        }
    }

    /// The numbers of the four corners, best first, and of the reflected one, if a trial is to decide over it: that is
    /// the best while it is expanded, and the last but one while it is contracted.
    fn parted(&self) -> ([usize; 4], Option<usize>) {
        match self.motion {
            Motion::Expansion => ([1, 2, 3, 4], Some(0)),
            Motion::OutsideContraction => ([0, 1, 2, 4], Some(3)),
            _ => ([0, 1, 2, 3], None),
        }
    }

    fn simplex(&self) -> [Vector; 4] {
        self.parted().0.map(|number| self.found.population[number].gains.to_array())
    }

    /// From the worst corner through the centre of the others, and so far beyond.
    fn beyond(&self, distance: f64) -> Vector {
        let [a, b, c, worst] = self.simplex();
        let centre = [0, 1, 2].map(|j| (a[j] + b[j] + c[j]) / 3.0);
        between(centre, worst, -distance)
    }

    fn is_small(&self) -> bool {
        let [lowest, others @ ..] = self.simplex();
        let edge = |corner: &Vector| {
            (0..3).fold(0.0, |largest: f64, j| largest.at_least((corner[j] - lowest[j]).abs()))
        };
        let largest = others.iter().map(edge).fold(0.0, f64::at_least);
        // Also where no corner has a cost, for then not even the best is finite.
        largest <= SMALLEST || !self.found.population[0].cost.is_finite()
    }
}

/// A draw from the initial range, and a corner one step from it in each gain.
fn corners(e: &EvolutionSettings, begun: u32) -> Vec<Vector> {
    let first = first_drawn(e, begun).gains.to_array();
    let others = UNIT.map(|axis| plus(first, e.initial_sigma, axis));
    [first].into_iter().chain(others).collect()
}

fn between(from: Vector, to: Vector, share: f64) -> Vector {
    [0, 1, 2].map(|j| from[j] + share * (to[j] - from[j]))
}
