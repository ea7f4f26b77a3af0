//! Evolution with many seeds, beside random search.

use super::part::{read_part, validate_part};
use crate::run::{Setting, Work};
use crate::schema::{
    Allowed, Column, Input, InvalidInput, Place, Source, read_object, record, told,
};
use crate::search::{Brood, EvolutionSettings, Individual, LAST_GENERATION, RandomSearch, best};

/// Which seeds [first, end) to run, and for how many generations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeedRuns {
    /// The seeds [first, end).
    pub seeds: [u32; 2],
    /// How many generations.
    pub generations: u32,
}

told! {
    /// Which seeds [first, end) to run, and for how many generations.
    SeedRuns: SeedRuns {
        /// The seeds [first, end).
        "seeds" => |given| given.seeds,
        /// How many generations.
        "generations" => |given| given.generations,
    }
}

impl SeedRuns {
    /// Seeds and generations.
    pub fn read<S: Source>(given: &S) -> Result<Self, S::Error> {
        let place = Place::Named("seeds");
        read_object(given, place, &["seeds", "generations"])?;
        let seeds = read_part(&given.field("seeds")?, Place::Field(&place, "seeds"), u32::MAX)?;
        let (at, allowed) =
            (Place::Field(&place, "generations"), Allowed::whole(0, LAST_GENERATION));
        let mut generations = 0;
        generations.read(&given.field("generations")?, at, &allowed)?;
        generations.check(at, &allowed)?;
        Ok(Self { seeds, generations })
    }
}

record! {
    /// What evolution with one seed found, and random search with as many drives.
    pub struct SeedRun {
        /// The best J of each generation, from 0.
        pub best: Column => "best",
        /// The best individual in the end.
        pub champion: Individual => "champion",
        /// The best J that random search had found by then; it begins with the same population, and draws a new one from the
        /// initial range for each generation.
        pub random: Column => "random",
    }
}

/// Runs evolution for so many generations with each seed, beside random search.
///
/// The seed of the experiment does not matter. The error names the field that is wrong.
pub fn seed_runs(
    setting: &Setting,
    seeds: [u32; 2],
    generations: u32,
) -> Result<Vec<SeedRun>, InvalidInput> {
    let [first, end] = validate_part("seeds", seeds, u32::MAX)?;
    let (experiment, settings) = (setting.experiment(), setting.experiment().evolution);
    let (n, g) = (f64::from(settings.population), f64::from(generations) + 1.0);
    let (count, starts) = (f64::from(end - first), experiment.starts.len());
    // Evolution and random search.
    let drives = 2.0 * n * g * count;
    Work { field: "the number of drives", count: drives, starts, bytes: 0.0 }.check(experiment)?;
    let bytes = n * BYTES_OF_A_SOLUTION + g * 2.0 * size_of::<f64>() as f64;
    Work { field: "the number of seeds", count, starts: 1, bytes }.check(experiment)?;

    let races = (first..end).map(|seed| Race::new(EvolutionSettings { seed, ..settings }));
    let mut races: Vec<_> = races.collect();
    for generation in 0..=generations {
        let broods: Vec<Brood> = races.iter_mut().map(|race| race.brood(generation)).collect();
        let mut trials: Vec<_> = broods.iter().flat_map(Brood::trials).collect();
        if generation > 0 {
            trials.extend(races.iter().flat_map(|race| race.random.trials(generation)));
        }
        let costs = setting.totals(&trials);
        // In generation 0 both have the same population, which is driven once.
        let (evolved, drawn) = costs.split_at(costs.len() / if generation > 0 { 2 } else { 1 });
        let drawn = if generation > 0 { drawn } else { evolved };
        let size = settings.population as usize;
        let costs = evolved.chunks_exact(size).zip(drawn.chunks_exact(size));
        for ((race, brood), (evolved, drawn)) in races.iter_mut().zip(broods).zip(costs) {
            race.driven(brood, evolved, drawn);
        }
    }
    Ok(races.into_iter().map(Race::finished).collect())
}

/// Parents, offspring, draws, trials, costs, tournament: what a solution takes while its generation is under way.
const BYTES_OF_A_SOLUTION: f64 = 512.0;

/// Evolution and random search with one seed. All seeds take a step together, so that there are many runs to drive.
struct Race {
    settings: EvolutionSettings,
    population: Vec<Individual>,
    random: RandomSearch,
    best: Vec<f64>,
    drawn: Vec<f64>,
    champion: Option<Individual>,
}

impl Race {
    fn new(settings: EvolutionSettings) -> Self {
        let (random, champion) = (RandomSearch::new(settings), None);
        let [best, drawn] = [Vec::new(), Vec::new()];
        Self { settings, population: Vec::new(), random, best, drawn, champion }
    }

    /// What evolution tries next.
    fn brood(&mut self, generation: u32) -> Brood {
        match generation {
            0 => Brood::first(&self.settings),
            _ => Brood::of(&self.settings, core::mem::take(&mut self.population), generation),
        }
    }

    /// Goes on with the survivors, and notes what both have found.
    fn driven(&mut self, brood: Brood, evolved: &[f64], drawn: &[f64]) {
        self.population = brood.driven(&self.settings, evolved).population();
        let best = best(&self.population);
        self.best.push(best.cost);
        self.drawn.push(self.random.driven(drawn));
        self.champion = Some(best);
    }

    fn finished(self) -> SeedRun {
        let champion = self.champion.expect("generation 0 was driven");
        SeedRun { best: Column(self.best), champion, random: Column(self.drawn) }
    }
}
