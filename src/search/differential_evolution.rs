//! Differential evolution, DE/rand/1/bin (Storn and Price 1997).

use rand::{Rng, RngExt};

use super::generation::{Brood, GenerationRecord, Making};
use super::individual::{Individual, drawn};
use super::search::{Found, Search, found};
use super::settings::EvolutionSettings;
use crate::number::{Purpose, stream};

/// F, the factor on the difference of two members.
const FACTOR: f64 = 0.5;

/// CR, how probable it is that a gain comes from the mutant.
const CROSSOVER: f64 = 0.9;

/// A population in which each member is replaced by its trial where that costs no more.
///
/// The trial of a member is a + F (b − c) of three others, crossed with the member gain by gain.
#[derive(Clone, Debug, Default)]
pub struct DifferentialEvolution(Found);

impl Search for DifferentialEvolution {
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood {
        let members = &self.0.population;
        if generation == 0 {
            let first = drawn(e, 0).into_iter().map(|one| Individual::new(one.gains, [0.0; 3]));
            return Brood::initial(first.collect());
        }
        let mut rng = stream(e.seed, Purpose::Partners, generation);
        let (mut donors, mut bases) = (Vec::new(), Vec::new());
        let trials = (0..members.len()).map(|own| {
            let others = others(own, members.len(), &mut rng);
            let mutant = mutant(others.map(|donor| &members[donor]));
            donors.push(others.map(|donor| donor as u32).to_vec());
            bases.push(mutant);
            trial(e, &members[own], &mutant, &mut rng)
        });
        let trials = trials.collect();
        let making = Making { donors, bases, ..Making::default() };
        Brood::beside(members, trials, generation).made_by(making)
    }

    fn tell(&mut self, _: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord {
        let brood = brood.with_costs(costs);
        let record = brood.survived_in_pairs(|trial, member| trial <= member);
        self.0.follow(&record);
        record
    }

    found!(0);
}

/// Three members, none of them twice and none of them this one.
fn others(own: usize, count: usize, rng: &mut impl Rng) -> [usize; 3] {
    assert!(count >= 4, "differential evolution needs four members, not {count}");
    let mut taken = [own; 4];
    for place in 1..4 {
        taken[place] = loop {
            let drawn = rng.random_range(0..count);
            if !taken[..place].contains(&drawn) {
                break drawn;
            }
        };
    }
    [taken[1], taken[2], taken[3]]
}

/// a + F (b − c).
fn mutant(donors: [&Individual; 3]) -> Individual {
    let [a, b, c] = donors.map(|donor| donor.gains.to_array());
    Individual::new([0, 1, 2].map(|j| a[j] + FACTOR * (b[j] - c[j])).into(), [0.0; 3])
}

/// The mutant, crossed with the member; at least one gain is the mutant's.
fn trial(
    e: &EvolutionSettings,
    member: &Individual,
    mutant: &Individual,
    rng: &mut impl Rng,
) -> Individual {
    let [member, mutant] = [member, mutant].map(|one| one.gains.to_array());
    let always = rng.random_range(0..3_usize);
    let gains = [0, 1, 2].map(|j| {
        let is_crossed = rng.random::<f64>() < CROSSOVER;
        if is_crossed || j == always { mutant[j] } else { member[j] }
    });
    Individual::new(e.tried(gains), [0.0; 3])
}
