//! The (1+1) evolution strategy with the 1/5 success rule (Rechenberg 1973).

use rand_distr::{Distribution, StandardNormal};

use super::generation::{Brood, GenerationRecord};
use super::individual::{Individual, first_drawn};
use super::plan::Plan;
use super::search::{Found, Search, found};
use super::settings::EvolutionSettings;
use super::symmetric::plus;
use crate::number::{Purpose, Real, stream};

/// σ after a success, as a factor.
const GROWTH: f64 = 1.5;

/// σ after a failure: GROWTH^(−1/4), so that it stays where one step of five succeeds.
const DECAY: f64 = 0.903_602_003_609_844_8;

/// Where J is level every step is a success: σ grows no further than it may begin.
const LARGEST: f64 = 1e6;

/// One parent, one offspring a generation; the offspring stays where it costs no more.
#[derive(Clone, Debug, Default)]
pub struct OnePlusOne(Found);

impl Search for OnePlusOne {
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood {
        let Some(parent) = self.0.population.first() else {
            return Brood::initial(vec![first_drawn(e, 0)]);
        };
        let mut rng = stream(e.seed, Purpose::Steps, generation);
        let step = [0; 3].map(|_| StandardNormal.sample(&mut rng));
        let gains = e.tried(plus(parent.gains.to_array(), parent.sigmas[0], step));
        let offspring =
            Individual::new(gains, parent.sigmas.map(|sigma| (GROWTH * sigma).at_most(LARGEST)));
        Brood::beside(&self.0.population, vec![offspring], generation)
    }

    fn tell(&mut self, _: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord {
        let brood = brood.with_costs(costs);
        let record = brood.survived_in_pairs(|offspring, parent| offspring <= parent);
        self.0.follow(&record);
        if record.survivors == [0] && record.generation > 0 {
            let parent = &mut self.0.population[0];
            parent.sigmas = parent.sigmas.map(|sigma| DECAY * sigma);
        }
        record
    }

    fn plan(&self, _: &EvolutionSettings) -> Plan {
        Plan { steps: self.0.population.first().map(|parent| parent.sigmas), ..Plan::default() }
    }

    found!(0);
}
