//! One generation of evolutionary programming, steps 1 to 6 of the paper's procedure.

use super::individual::{Individual, drawn};
use super::mutation::Mutation;
use super::settings::EvolutionSettings;
use super::tournament::{Tournament, in_order};
use crate::number::{Purpose, stream};
use crate::robot::Gains;
use crate::schema::{record, told};

/// One generation in full. Solutions are numbered 0 to N − 1 for the parents and N to 2N − 1 for the offspring.
///
/// Generation 0 has only parents, the initial population in the order of its draws; all survive.
#[derive(Clone, Debug, PartialEq)]
pub struct GenerationRecord {
    /// The generation's number.
    pub generation: u32,
    /// The survivors of the generation before.
    pub parents: Vec<Individual>,
    /// One offspring of each parent, in their order.
    pub offspring: Vec<Individual>,
    /// The draws that made each offspring.
    pub mutations: Vec<Mutation>,
    /// Whom each of the 2N solutions met, and how many bouts it won.
    pub tournament: Tournament,
    /// The numbers of all, best ranked first.
    pub ranking: Vec<u32>,
    /// The numbers of those that survive, best ranked first: the first N of the ranking.
    pub survivors: Vec<u32>,
}

told! {
    /// One generation in full. Solutions are numbered 0 to N − 1 for the parents and N to 2N − 1 for the offspring.
    /// Generation 0 has only parents: the initial population in the order of its draws, all of which survive.
    GenerationRecord: GenerationRecord {
        /// The generation's number.
        "generation" => |record| record.generation,
        /// The survivors of the generation before.
        "parents" => |record| &record.parents,
        /// One offspring of each parent, in their order.
        "offspring" => |record| &record.offspring,
        /// The draws behind each offspring.
        "mutations" => |record| &record.mutations,
        /// For each of the 2N solutions, whom it met.
        "opponents" => |record| &record.tournament.opponents,
        /// For each of the 2N solutions, how many bouts it won.
        "wins" => |record| &record.tournament.wins,
        /// All of them, best ranked first: most wins first, then lower J, then lower number.
        "ranking" => |record| &record.ranking,
        /// The N that survive, best ranked first.
        "survivors" => |record| &record.survivors,
    }
}

/// A generation whose new solutions are still to be driven.
#[derive(Clone, Debug)]
pub struct Brood {
    generation: u32,
    parents: Vec<Individual>,
    mutations: Vec<Mutation>,
    /// In generation 0 the population that it begins with.
    offspring: Vec<Individual>,
}

impl Brood {
    /// Generation 0: N individuals with k_j uniform in the initial range and σ_j the initial σ (step 1).
    pub fn first(e: &EvolutionSettings) -> Self {
        let (parents, mutations) = (Vec::new(), Vec::new());
        Self { generation: 0, parents, mutations, offspring: drawn(e, 0) }
    }

    /// One offspring of each parent (step 3). It depends on the settings, the parents and the generation's number alone.
    ///
    /// # Panics
    /// If the generation is beyond [`LAST_GENERATION`](super::LAST_GENERATION).
    pub fn of(e: &EvolutionSettings, parents: Vec<Individual>, generation: u32) -> Self {
        let mut rng = stream(e.seed, Purpose::Mutation, generation);
        let mutations: Vec<_> = parents.iter().map(|_| Mutation::draw(&mut rng)).collect();
        let pairs = mutations.iter().zip(&parents);
        let offspring = pairs.map(|(mutation, parent)| mutation.offspring(parent)).collect();
        Self { generation, parents, mutations, offspring }
    }

    /// The gains that are to be driven.
    pub fn trials(&self) -> Vec<Gains> {
        self.offspring.iter().map(|individual| individual.gains).collect()
    }

    /// The generation once each trial has cost so much (steps 5 and 6).
    ///
    /// # Panics
    /// If there is not one cost for each trial.
    pub fn driven(self, e: &EvolutionSettings, costs: &[f64]) -> GenerationRecord {
        let Self { generation, parents, mutations, mut offspring } = self;
        assert_eq!(costs.len(), offspring.len(), "one cost for each trial");
        offspring.iter_mut().zip(costs).for_each(|(one, cost)| one.cost = *cost);
        if generation == 0 {
            return founded(offspring);
        }
        let costs: Vec<f64> = parents.iter().chain(&offspring).map(|i| i.cost).collect();
        let mut rng = stream(e.seed, Purpose::Tournament, generation);
        let tournament = Tournament::hold(&costs, e.opponents, &mut rng);
        let ranking = tournament.ranking(&costs);
        let survivors = ranking[..parents.len()].to_vec();
        GenerationRecord {
            generation,
            parents,
            offspring,
            mutations,
            tournament,
            ranking,
            survivors,
        }
    }
}

/// The numbers of these, the lowest cost first.
fn by_cost(population: &[Individual]) -> Vec<u32> {
    in_order(population.len(), &|i, j| population[i].cost.total_cmp(&population[j].cost))
}

fn founded(parents: Vec<Individual>) -> GenerationRecord {
    let ranking = by_cost(&parents);
    GenerationRecord {
        generation: 0,
        parents,
        offspring: Vec::new(),
        mutations: Vec::new(),
        tournament: Tournament::default(),
        survivors: ranking.clone(),
        ranking,
    }
}

impl GenerationRecord {
    /// The solution with this number.
    ///
    /// # Panics
    /// If there is none.
    pub fn solution(&self, number: u32) -> &Individual {
        let number = number as usize;
        let offspring = || &self.offspring[number - self.parents.len()];
        self.parents.get(number).unwrap_or_else(offspring)
    }

    /// The individuals that survive, best ranked first: the parents of the next generation.
    pub fn population(&self) -> Vec<Individual> {
        self.survivors.iter().map(|number| *self.solution(*number)).collect()
    }
}

record! { (Copy)
    /// One generation in short.
    pub struct Statistics {
        /// The generation's number.
        pub generation: u32 => "generation",
        /// Drives since the start, one for each individual and start posture.
        pub evaluations: f64 => "evaluations",
        /// The individual with the lowest cost.
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
    /// Of a population that is left by a generation, when each trial is driven from so many starts.
    pub(crate) fn new(generation: u32, population: &[Individual], starts: usize) -> Self {
        let ranked = by_cost(population);
        let n = ranked.len();
        let at = |rank: usize| population[ranked[rank] as usize];
        let mean = |j: usize| population.iter().map(|i| i.sigmas[j]).sum::<f64>() / n as f64;
        Self {
            generation,
            evaluations: (f64::from(generation) + 1.0) * (n * starts) as f64,
            best: at(0),
            median: 0.5 * (at((n - 1) / 2).cost + at(n / 2).cost),
            worst: at(n - 1).cost,
            mean_sigmas: [0, 1, 2].map(mean),
        }
    }
}
