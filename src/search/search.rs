//! What every method of searching can do.

use core::fmt;

use super::generation::{Brood, GenerationRecord};
use super::individual::Individual;
use super::plan::Plan;
use super::settings::EvolutionSettings;

/// A search for the gains of least cost. It asks for new solutions to be driven, and is told what they cost.
///
/// Methods are added in this room alone, beside the others (CONTRIBUTING.md): what they ask for is made of parts that nobody
/// else can put together.
///
/// What it asks for in a generation depends on where it stands, the settings with their seed and the generation's number
/// alone; so a search that is kept can go on from there at any time, to the same bits.
pub trait Search: Send + Sync {
    /// What is to be driven in a generation: 0, 1, 2, …, each told before the next is asked for. Asked in another order it may
    /// panic, or give what another search would try.
    ///
    /// # Panics
    /// If the generation is beyond [`LAST_GENERATION`](super::LAST_GENERATION), and the method draws in it, or if
    /// differential evolution has fewer than four members, or CMA-ES fewer than two. (No experiment that is checked has.)
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood;

    /// The generation once each new solution has cost so much. From here on the search stands behind it.
    ///
    /// # Panics
    /// If there is not one cost for each of them. It may panic, too, if the brood is not what this search was just asked for.
    fn tell(&mut self, e: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord;

    /// What the last generation left, best ranked first.
    fn population(&self) -> &[Individual];

    /// The first of all that were driven until now with the lowest cost.
    ///
    /// # Panics
    /// If nothing was driven.
    fn best(&self) -> Individual;

    /// What it goes by when it asks next, besides its population.
    fn plan(&self, _: &EvolutionSettings) -> Plan {
        Plan::default()
    }

    /// Another that stands where this one does.
    fn copied(&self) -> Box<dyn Search>;
}

/// In the trait itself it would make the module 10 kB larger, though nobody asks for it there.
impl fmt::Debug for dyn Search {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Search").field(&self.population()).finish()
    }
}

impl Clone for Box<dyn Search> {
    fn clone(&self) -> Self {
        self.copied()
    }
}

/// What a search keeps that may lose its best again.
#[derive(Clone, Debug, Default)]
pub(super) struct Found {
    pub(super) population: Vec<Individual>,
    best: Option<Individual>,
}

impl Found {
    /// Takes over what a generation leaves, and its best if that is the best until now.
    pub(super) fn follow(&mut self, record: &GenerationRecord) {
        self.population = record.population();
        for one in record.tried() {
            if self.best.is_none_or(|best| one.is_better_than(&best)) {
                self.best = Some(*one);
            }
        }
    }

    pub(super) fn best(&self) -> Individual {
        self.best.expect("generation 0 was driven")
    }
}

/// What such a search says of it.
macro_rules! found {
    ($field:tt) => {
        fn population(&self) -> &[$crate::search::individual::Individual] {
            &self.$field.population
        }

        fn best(&self) -> $crate::search::individual::Individual {
            self.$field.best()
        }

        fn copied(&self) -> Box<dyn Search> {
            Box::new(self.clone())
        }
    };
}

pub(super) use found;
