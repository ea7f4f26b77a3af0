//! Evolutionary programming, steps 1 to 6 of the paper's procedure, with its ingredients.

use rand::RngExt;

use super::generation::{Brood, GenerationRecord, Making, by_cost};
use super::individual::{Individual, best, drawn};
use super::mutation::Mutation;
use super::search::Search;
use super::settings::{EvolutionSettings, Selection};
use super::tournament::Tournament;
use crate::number::{Purpose, stream};

/// Where evolutionary programming stands: its population.
#[derive(Clone, Debug, Default)]
pub struct EvolutionaryProgramming(Vec<Individual>);

impl Search for EvolutionaryProgramming {
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood {
        match generation {
            0 => Brood::first(e),
            _ => Brood::of(e, self.0.clone(), generation),
        }
    }

    fn tell(&mut self, e: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord {
        let record = brood.driven(e, costs);
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

impl Brood {
    /// Generation 0: N individuals with k_j uniform in the initial range and σ_j the initial σ (step 1).
    pub fn first(e: &EvolutionSettings) -> Self {
        Self::initial(drawn(e, 0))
    }

    /// One offspring of each parent (step 3). It depends on the settings, the parents and the generation's number alone.
    ///
    /// # Panics
    /// If the generation is beyond [`LAST_GENERATION`](super::LAST_GENERATION).
    pub fn of(e: &EvolutionSettings, parents: Vec<Individual>, generation: u32) -> Self {
        let mutations = Mutation::all(e, parents.len(), generation);
        let (donors, bases) = crossed(e, &parents, generation);
        let pairs = mutations.iter().zip(if bases.is_empty() { &parents } else { &bases });
        let offspring = pairs.map(|(mutation, base)| mutation.offspring_in(e, base)).collect();
        let making = Making { mutations, donors, bases, ellipse: None };
        Self { generation, parents, offspring, making }
    }

    /// The generation once each trial has cost so much (steps 5 and 6).
    ///
    /// # Panics
    /// If there is not one cost for each trial.
    pub fn driven(self, e: &EvolutionSettings, costs: &[f64]) -> GenerationRecord {
        let brood = self.with_costs(costs);
        if brood.generation == 0 {
            return brood.founded();
        }
        let (costs, count) = (brood.costs(), brood.parents.len());
        match e.selection {
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
            Selection::Parent => {
                let stays = |parent: usize| costs[parent] <= costs[parent + count];
                brood.survived_by(&|number| match number.checked_sub(count) {
                    None => stays(number),
                    Some(parent) => !stays(parent),
                })
            }
        }
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
        let (is_crossed, drawn) =
            (rng.random::<f64>() < e.crossover, rng.random_range(0..parents.len() as u32 - 1));
        let from_partner = [0; 3].map(|_| rng.random::<bool>());
        if !is_crossed {
            return (Vec::new(), *parent);
        }
        let partner = if drawn < own { drawn } else { drawn + 1 };
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
