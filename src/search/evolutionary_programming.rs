//! Evolutionary programming, steps 1 to 6 of the paper's procedure, with its ingredients.

use rand::RngExt;

use super::generation::{Brood, GenerationRecord, Making, by_cost};
use super::individual::{Individual, best, drawn};
use super::mutation::Mutation;
use super::search::Search;
use super::settings::{EvolutionSettings, Selection};
use super::tournament::{Tournament, another};
use crate::number::{Purpose, stream};

/// Where evolutionary programming stands: its population.
#[derive(Clone, Debug, Default)]
pub struct EvolutionaryProgramming(Vec<Individual>);

impl Search for EvolutionaryProgramming {
    /// In generation 0 N individuals with k_j uniform in the initial range and σ_j the initial σ (step 1); then one offspring
    /// of each parent (step 3).
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood {
        let parents = &self.0;
        if generation == 0 {
            return Brood::initial(drawn(e, 0));
        }
        let mutations = Mutation::all(e, parents.len(), generation);
        let (donors, bases) = crossed(e, parents, generation);
        let pairs = mutations.iter().zip(if bases.is_empty() { parents } else { &bases });
        let offspring = pairs.map(|(mutation, base)| mutation.offspring(e, base)).collect();
        let making = Making { mutations, donors, bases, ellipse: None };
        Brood::beside(parents, offspring, generation).made_by(making)
    }

    /// The tournament (steps 5 and 6), or another selection.
    fn tell(&mut self, e: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord {
        let brood = brood.with_costs(costs);
        let (costs, count) = (brood.costs(), brood.parents.len());
        let record = match e.selection {
            _ if brood.generation == 0 => brood.founded(),
            Selection::Tournament => {
                let mut rng = stream(e.seed, Purpose::Tournament, brood.generation);
                let tournament = Tournament::hold(&costs, e.opponents, &mut rng);
                let ranking = tournament.ranking(&costs);
                brood.ranked(ranking, count, tournament)
            }
            Selection::Truncation => {
                let all = [brood.parents.as_slice(), &brood.offspring].concat();
                brood.ranked(by_cost(&all), count, Tournament::default())
            }
            Selection::Parent => brood.survived_in_pairs(|offspring, parent| offspring < parent),
        };
        self.0 = record.population();
        record
    }

    fn population(&self) -> &[Individual] {
        &self.0
    }

    /// It never loses its best.
    fn best(&self) -> Individual {
        best(&self.0)
    }

    fn copied(&self) -> Box<dyn Search> {
        Box::new(self.clone())
    }
}

/// With whom each parent is crossed, and what comes of it; nothing where no parent can be.
fn crossed(
    e: &EvolutionSettings,
    parents: &[Individual],
    generation: u32,
) -> (Vec<Vec<u32>>, Vec<Individual>) {
    if e.crossover <= 0.0 || parents.len() < 2 {
        return Default::default();
    }
    let mut rng = stream(e.seed, Purpose::Partners, generation);
    let crossed = parents.iter().zip(0..).map(|(parent, own): (&Individual, u32)| {
        let is_crossed = rng.random::<f64>() < e.crossover;
        let partner = another(own, parents.len() as u32, &mut rng);
        let from_partner = [0; 3].map(|_| rng.random::<bool>());
        if !is_crossed {
            return (Vec::new(), *parent);
        }
        (vec![partner], mixed(parent, &parents[partner as usize], from_partner))
    });
    crossed.unzip()
}

/// The gains, each with its σ, of the one or the other.
fn mixed(parent: &Individual, partner: &Individual, from_partner: [bool; 3]) -> Individual {
    let of = |j: usize| if from_partner[j] { partner } else { parent };
    let gains = [0, 1, 2].map(|j| of(j).gains.to_array()[j]);
    Individual::new(gains.into(), [0, 1, 2].map(|j| of(j).sigmas[j]))
}
