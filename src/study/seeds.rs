//! Evolution with many seeds, beside random search.

use super::part::validate_part;
use crate::number::Real;
use crate::robot::Gains;
use crate::run::{BYTES_OF_AN_OBJECT, Setting, Work};
use crate::schema::{Allowed, Column, InvalidInput, Place, Source, read_whole, record};
use crate::search::{Brood, Draws, EvolutionSettings, Individual, LAST_GENERATION, Search, search};

record! { required (Copy)
    /// Which seeds [first, end) to run, and for how many generations.
    pub struct SeedRuns {
        /// The seeds [first, end).
        pub seeds: [u32; 2] => "seeds" in Allowed::SEED,
        /// How many generations.
        pub generations: u32 => "generations" in Allowed::whole(0, LAST_GENERATION),
    }
}

impl SeedRuns {
    /// Seeds and generations.
    pub fn read<S: Source>(given: &S) -> Result<Self, InvalidInput> {
        let none = Self { seeds: [0; 2], generations: 0 };
        read_whole(none, given, Place::Named("seeds"), &Allowed::ANY)
    }
}

record! {
    /// What evolution with one seed found, and random search with as many drives.
    pub struct SeedRun {
        /// The best J of each generation, from 0.
        pub best: Column => "best",
        /// The best individual in the end.
        pub champion: Individual => "champion",
        /// The best J that random search had found by then with as many drives: it takes its draws from the initial range in
        /// the order in which random search itself would, so that of evolutionary programming begins with the same population.
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
    let (n, g) = (f64::from(settings.most_solutions()), f64::from(generations) + 1.0);
    let (count, starts) = (f64::from(end - first), experiment.starts.len());
    // Evolution and random search.
    let drives = 2.0 * n * g * count;
    Work { field: "the number of drives", count: drives, starts, bytes: 0.0 }
        .check_solutions(experiment)?;
    let kept = f64::from(settings.population.max(settings.most_solutions()));
    let columns = g * size_of::<[f64; 2]>() as f64;
    let bytes = kept * BYTES_OF_A_SOLUTION + columns + BYTES_OF_AN_OBJECT;
    Work { field: "the number of seeds", count, starts: 1, bytes }.check(experiment)?;

    let race = |seed| Race::new(EvolutionSettings { seed, ..settings }, generations);
    let mut races: Vec<_> = (first..end).map(race).collect();
    for generation in 0..=generations {
        let broods: Vec<_> = races.iter_mut().map(|race| race.asked(generation)).collect();
        let all = broods.iter().flat_map(|(brood, drawn)| [brood.gains(), drawn.clone()].concat());
        let costs = setting.totals(&all.collect::<Vec<_>>());
        let mut rest = costs.as_slice();
        for (race, (brood, drawn)) in races.iter_mut().zip(broods) {
            let (evolved, others) = rest.split_at(brood.gains().len());
            let (random, others) = others.split_at(drawn.len());
            race.driven(brood, evolved, random);
            rest = others;
        }
    }
    Ok(races.into_iter().map(Race::finished).collect())
}

/// Parents, offspring, draws, trials, costs, tournament: what a solution takes while its generation is under way.
pub(super) const BYTES_OF_A_SOLUTION: f64 = 512.0;

/// A search and random search with one seed. All seeds take a step together, so that there are many runs to drive.
struct Race {
    settings: EvolutionSettings,
    search: Box<dyn Search>,
    random: Draws,
    lowest: f64,
    best: Vec<f64>,
    drawn: Vec<f64>,
}

impl Race {
    fn new(settings: EvolutionSettings, generations: u32) -> Self {
        let (search, random) = (search(settings.method), Draws::default());
        let [best, drawn] = [0; 2].map(|_| Vec::with_capacity(generations as usize + 1));
        Self { settings, search, random, lowest: f64::INFINITY, best, drawn }
    }

    /// What both try next; nothing by random search where that is the same.
    fn asked(&mut self, generation: u32) -> (Brood, Vec<Gains>) {
        let brood = self.search.ask(&self.settings, generation);
        let trials = brood.gains();
        let drawn = self.random.next(&self.settings, trials.len());
        let drawn = if drawn == trials { Vec::new() } else { drawn };
        (brood, drawn)
    }

    /// Notes what both have found.
    fn driven(&mut self, brood: Brood, evolved: &[f64], drawn: &[f64]) {
        let drawn = if drawn.is_empty() { evolved } else { drawn };
        self.lowest = drawn.iter().copied().fold(self.lowest, f64::at_most);
        self.drawn.push(self.lowest);
        self.search.tell(&self.settings, brood, evolved);
        self.best.push(self.search.best().cost);
    }

    fn finished(self) -> SeedRun {
        let champion = self.search.best();
        SeedRun { best: Column(self.best), champion, random: Column(self.drawn) }
    }
}
