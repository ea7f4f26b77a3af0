//! Evolutionary programming as in section 4 of the paper: mutation, drive, tournament, survival.

mod history;
mod individual;
mod mutation;
mod tournament;

pub use history::{Evolution, LAST_GENERATION};
pub use individual::Individual;
pub use mutation::{COMMON_LEARNING_RATE, LEARNING_RATE, Mutation};
pub use tournament::{Tournament, wins_bout};

use serde::Serialize;

use crate::episode::Setting;
use crate::experiment::EvolutionSettings;
use crate::random::{Purpose, stream};

/// One generation in full. Solutions are numbered 0 to N − 1 for the parents and N to 2N − 1 for the offspring.
///
/// Generation 0 has only parents, the initial population in the order of its draws; all survive.
#[derive(Clone, Debug, PartialEq, Serialize)]
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
    #[serde(flatten)]
    pub tournament: Tournament,
    /// The numbers of all, best ranked first.
    pub ranking: Vec<u32>,
    /// The numbers of those that survive, best ranked first: the first N of the ranking.
    pub survivors: Vec<u32>,
}

/// What a generation breeds, still to be driven: one offspring of each parent.
pub(crate) struct Brood {
    mutations: Vec<Mutation>,
    pub(crate) offspring: Vec<Individual>,
}

impl Brood {
    /// Step 3 of the paper's procedure.
    pub(crate) fn of(e: &EvolutionSettings, parents: &[Individual], generation: u32) -> Self {
        let mut rng = stream(e.seed, Purpose::Mutation, generation);
        let mutations: Vec<_> = parents.iter().map(|_| Mutation::draw(&mut rng)).collect();
        let pairs = mutations.iter().zip(parents);
        let offspring = pairs.map(|(mutation, parent)| mutation.offspring(parent)).collect();
        Self { mutations, offspring }
    }
}

/// A population drawn from the initial range, still to be driven: k_j uniform in it and σ_j the initial σ (step 1).
///
/// There is one of each number. Evolution begins with number 0.
pub(crate) fn drawn(e: &EvolutionSettings, number: u32) -> Vec<Individual> {
    let mut rng = stream(e.seed, Purpose::Initialisation, number);
    (0..e.population).map(|_| Individual::random(e, &mut rng)).collect()
}

/// Drives all these individuals from every start (steps 2 and 4). In one call many are faster than few.
pub(crate) fn drive_all<'a>(
    setting: &Setting,
    individuals: impl IntoIterator<Item = &'a mut Individual>,
) {
    let individuals: Vec<_> = individuals.into_iter().collect();
    let gains: Vec<_> = individuals.iter().map(|individual| individual.gains.into()).collect();
    for (individual, cost) in individuals.into_iter().zip(setting.costs(&gains)) {
        individual.cost = cost.total();
    }
}

impl GenerationRecord {
    /// Generation 0: N individuals with k_j uniform in the initial range and σ_j the initial σ (steps 1 and 2).
    pub fn initial(setting: &Setting) -> Self {
        let mut parents = drawn(&setting.experiment().evolution, 0);
        drive_all(setting, &mut parents);
        Self::founded(parents)
    }

    /// Generation 0 with these parents, which were driven.
    pub(crate) fn founded(parents: Vec<Individual>) -> Self {
        let mut ranking: Vec<u32> = (0..parents.len() as u32).collect();
        ranking.sort_by(|a, b| parents[*a as usize].cost.total_cmp(&parents[*b as usize].cost));
        Self {
            generation: 0,
            parents,
            offspring: Vec::new(),
            mutations: Vec::new(),
            tournament: Tournament::default(),
            survivors: ranking.clone(),
            ranking,
        }
    }

    /// Steps 3 to 6 of the paper's procedure: one offspring of each parent, their drives, the tournament.
    ///
    /// It depends on the setting, the parents and the generation's number alone.
    pub fn next(setting: &Setting, parents: Vec<Individual>, generation: u32) -> Self {
        let e = &setting.experiment().evolution;
        let mut brood = Brood::of(e, &parents, generation);
        drive_all(setting, &mut brood.offspring);
        Self::selected(e, parents, brood, generation)
    }

    /// Steps 5 and 6: the tournament of the parents and their offspring, all driven.
    pub(crate) fn selected(
        e: &EvolutionSettings,
        parents: Vec<Individual>,
        Brood { mutations, offspring }: Brood,
        generation: u32,
    ) -> Self {
        let costs: Vec<f64> = parents.iter().chain(&offspring).map(|i| i.cost).collect();
        let mut rng = stream(e.seed, Purpose::Tournament, generation);
        let tournament = Tournament::hold(&costs, e.opponents, &mut rng);
        let ranking = tournament.ranking(&costs);
        let survivors = ranking[..parents.len()].to_vec();
        Self { generation, parents, offspring, mutations, tournament, ranking, survivors }
    }

    /// The solution with this number.
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

/// One generation in short.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Statistics {
    /// The generation's number.
    pub generation: u32,
    /// Runs driven since the start: one for each solution and start posture.
    pub evaluations: f64,
    /// The individual with the lowest cost.
    pub best: Individual,
    /// Median cost; with an even number of individuals the mean of the two in the middle.
    pub median: f64,
    /// Highest cost.
    pub worst: f64,
    /// The mean of σ_j over the population.
    pub mean_sigmas: [f64; 3],
}

impl Statistics {
    fn new(record: &GenerationRecord, starts: usize) -> Self {
        let mut population = record.population();
        population.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        let n = population.len();
        let median = 0.5 * (population[(n - 1) / 2].cost + population[n / 2].cost);
        let sigmas: nalgebra::Vector3<f64> = population.iter().map(|i| i.sigmas).sum();
        Self {
            generation: record.generation,
            evaluations: (f64::from(record.generation) + 1.0) * (n * starts) as f64,
            best: population[0],
            median,
            worst: population[n - 1].cost,
            mean_sigmas: (sigmas / n as f64).into(),
        }
    }
}
