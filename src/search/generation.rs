//! One generation of a search: what it asks for, and what came of it.

use super::individual::Individual;
use super::mutation::Mutation;
use super::plan::{Ellipse, Plan};
use super::tournament::{Tournament, in_order};
use crate::robot::Gains;
use crate::schema::told;

/// What made the new solutions of a generation, as far as a method draws it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Making {
    /// The draws that made each offspring of evolutionary programming.
    pub mutations: Vec<Mutation>,
    /// For each new solution the numbers of the other parents it was made with; empty where there are none.
    pub donors: Vec<Vec<u32>>,
    /// What each mutation began with, where parents are crossed; the mutants a + F (b − c) of differential evolution, before
    /// they are crossed; else empty.
    pub bases: Vec<Individual>,
    /// The distribution of CMA-ES.
    pub ellipse: Option<Ellipse>,
}

/// One generation in full. Solutions are numbered 0 to N − 1 for the parents, and from N on for the offspring.
///
/// Generation 0 has only parents, the initial population in the order of its draws; all survive.
#[derive(Clone, Debug, PartialEq)]
pub struct GenerationRecord {
    /// The generation's number.
    pub generation: u32,
    /// The survivors of the generation before.
    pub parents: Vec<Individual>,
    /// One offspring of each parent, in their order; of other methods than evolutionary programming, whatever was tried.
    pub offspring: Vec<Individual>,
    /// What made the offspring.
    pub making: Making,
    /// Whom each of the 2N solutions met, and how many bouts it won; empty without a tournament.
    pub tournament: Tournament,
    /// The numbers of all, best ranked first.
    pub ranking: Vec<u32>,
    /// The numbers of those that survive, best ranked first: the first of the ranking.
    pub survivors: Vec<u32>,
    /// What the method went by; filled in where a history is asked for a generation.
    pub plan: Plan,
    /// What it goes by next; filled in there, too.
    pub next: Plan,
}

told! {
    /// One generation in full. Solutions are numbered 0 to N − 1 for the parents, and from N on for the offspring.
    /// Generation 0 has only parents: the initial population in the order of its draws, all of which survive.
    GenerationRecord: GenerationRecord {
        /// The generation's number.
        "generation" => |record| record.generation,
        /// The survivors of the generation before, best ranked first.
        "parents" => |record| &record.parents,
        /// One offspring of each parent, in their order; of other methods than evolutionary programming, whatever was tried.
        "offspring" => |record| &record.offspring,
        /// The draws behind each offspring of evolutionary programming.
        "mutations" => |record| &record.making.mutations,
        /// For each offspring the numbers of the other parents it was made with: with whom its parent was crossed, or a, b and c of
        /// a + F (b − c) in differential evolution. Empty where a method crosses nothing.
        "donors" => |record| &record.making.donors,
        /// What each mutation began with, where parents are crossed; the mutants a + F (b − c) of differential evolution, before
        /// they are crossed; else empty.
        "bases" => |record| &record.making.bases,
        /// The distribution from which CMA-ES drew the offspring; null for other methods.
        "ellipse" => |record| record.making.ellipse.as_ref(),
        /// For each of the 2N solutions, whom it met in the tournament; empty without one.
        "opponents" => |record| &record.tournament.opponents,
        /// For each of the 2N solutions, how many bouts it won; empty without a tournament.
        "wins" => |record| &record.tournament.wins,
        /// All of them, best ranked first: most wins first, then lower J, then lower number. Without a tournament those that
        /// survive come first, each part by J.
        "ranking" => |record| &record.ranking,
        /// Those that survive, best ranked first.
        "survivors" => |record| &record.survivors,
        /// What the method went by, besides its population.
        "plan" => |record| &record.plan,
        /// What it goes by in the next generation.
        "next" => |record| &record.next,
    }
}

/// A generation whose new solutions are still to be driven.
#[derive(Clone, Debug)]
pub struct Brood {
    pub(super) generation: u32,
    pub(super) parents: Vec<Individual>,
    /// In generation 0 what the search begins with.
    pub(super) offspring: Vec<Individual>,
    pub(super) making: Making,
}

impl Brood {
    /// What a search begins with.
    pub(super) fn initial(offspring: Vec<Individual>) -> Self {
        Self { generation: 0, parents: Vec::new(), offspring, making: Making::default() }
    }

    /// New solutions beside those that are there.
    pub(super) fn beside(
        parents: &[Individual],
        offspring: Vec<Individual>,
        generation: u32,
    ) -> Self {
        Self { generation, parents: parents.to_vec(), offspring, making: Making::default() }
    }

    /// How its new solutions were made.
    pub(super) fn made_by(self, making: Making) -> Self {
        Self { making, ..self }
    }

    /// The gains that are to be driven.
    pub fn gains(&self) -> Vec<Gains> {
        self.offspring.iter().map(|individual| individual.gains).collect()
    }

    /// The same once each new solution has cost so much; what is not finite is infinite, so that no machine's sign of NaN
    /// makes it the best.
    ///
    /// # Panics
    /// If there is not one cost for each of them.
    pub(super) fn with_costs(mut self, costs: &[f64]) -> Self {
        assert_eq!(costs.len(), self.offspring.len(), "one cost for each new solution");
        for (one, cost) in self.offspring.iter_mut().zip(costs) {
            one.cost = if cost.is_finite() { *cost } else { f64::INFINITY };
        }
        self
    }

    /// What all its solutions cost, in their order.
    pub(super) fn costs(&self) -> Vec<f64> {
        self.parents.iter().chain(&self.offspring).map(|one| one.cost).collect()
    }

    /// Generation 0, of which all survive.
    pub(super) fn founded(self) -> GenerationRecord {
        let ranking = by_cost(&self.offspring);
        let count = self.offspring.len();
        let founders = Self { parents: self.offspring, offspring: Vec::new(), ..self };
        founders.ranked(ranking, count, Tournament::default())
    }

    /// The generation of which these survive, all of generation 0; each part is ranked by cost.
    pub(super) fn survived_by(self, survives: &dyn Fn(usize) -> bool) -> GenerationRecord {
        if self.generation == 0 {
            return self.founded();
        }
        let costs = self.costs();
        let ranking = in_order(costs.len(), &|i, j| {
            survives(j).cmp(&survives(i)).then(costs[i].total_cmp(&costs[j]))
        });
        let count = (0..costs.len()).filter(|number| survives(*number)).count();
        self.ranked(ranking, count, Tournament::default())
    }

    /// The generation in which the offspring survives instead of its parent where `replaces` says so of its cost and that
    /// of the parent.
    pub(super) fn survived_in_pairs(self, replaces: fn(f64, f64) -> bool) -> GenerationRecord {
        let (costs, count) = (self.costs(), self.parents.len());
        let is_replaced = |parent: usize| replaces(costs[parent + count], costs[parent]);
        self.survived_by(&|number| match number.checked_sub(count) {
            None => !is_replaced(number),
            Some(parent) => is_replaced(parent),
        })
    }

    /// The generation of which the offspring survive, whatever they cost.
    pub(super) fn survived_by_offspring(self) -> GenerationRecord {
        let count = self.parents.len();
        self.survived_by(&|number| number >= count)
    }

    /// The generation of which the first of this ranking survive.
    pub(super) fn ranked(
        self,
        ranking: Vec<u32>,
        count: usize,
        tournament: Tournament,
    ) -> GenerationRecord {
        let Self { generation, parents, offspring, making } = self;
        let survivors = ranking[..count].to_vec();
        GenerationRecord {
            generation,
            parents,
            offspring,
            making,
            tournament,
            ranking,
            survivors,
            plan: Plan::default(),
            next: Plan::default(),
        }
    }
}

/// The numbers of these, the lowest cost first.
pub(super) fn by_cost(population: &[Individual]) -> Vec<u32> {
    in_order(population.len(), &|i, j| population[i].cost.total_cmp(&population[j].cost))
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

    /// What was driven: in generation 0 the parents, later the offspring.
    pub fn tried(&self) -> &[Individual] {
        if self.generation == 0 { &self.parents } else { &self.offspring }
    }
}
