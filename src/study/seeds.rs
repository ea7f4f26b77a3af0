//! A method of search with many seeds, beside random search.

use super::part::validate_part;
use super::searches::{check_searches, step_together};
use crate::number::Real;
use crate::robot::Gains;
use crate::run::Setting;
use crate::schema::{Allowed, Column, Place, Result, Source, read_whole, record};
use crate::search::{Brood, Draws, EvolutionSettings, Individual, LAST_GENERATION, Search, search};

record! { required (Copy)
    /// Which seeds [first, end) to run, and for how many generations.
    pub struct SeedRuns {
        /// The seeds [first, end); the last of all, 2³² − 1, cannot be among them.
        pub seeds: [u32; 2] => "seeds" in Allowed::SEED,
        /// How many generations.
        pub generations: u32 => "generations" in Allowed::whole(0, LAST_GENERATION),
    }
}

impl SeedRuns {
    /// Seeds and generations.
    pub fn read<S: Source>(given: &S) -> Result<Self> {
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
pub fn seed_runs(setting: &Setting, seeds: [u32; 2], generations: u32) -> Result<Vec<SeedRun>> {
    let [first, end] = validate_part("seeds", seeds, u32::MAX)?;
    let settings = setting.experiment().evolution;
    let (n, g) = (f64::from(settings.most_solutions()), f64::from(generations) + 1.0);
    // Evolution and random search.
    check_searches(setting, f64::from(end - first), 2.0 * n * g, g)?;

    let race = |seed| Race::new(EvolutionSettings { seed, ..settings }, generations);
    let mut races: Vec<_> = (first..end).map(race).collect();
    if races.is_empty() {
        return Ok(Vec::new());
    }
    for generation in 0..=generations {
        step_together(setting, &mut races, |race| race.asked(generation), Race::driven);
    }
    Ok(races.into_iter().map(Race::finished).collect())
}

/// A search and random search with one seed.
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

    /// What both try next, one after the other; once where that is the same.
    fn asked(&mut self, generation: u32) -> (Brood, Vec<Gains>) {
        let brood = self.search.ask(&self.settings, generation);
        let mut gains = brood.gains();
        let drawn = self.random.next(&self.settings, gains.len());
        if drawn != gains {
            gains.extend(drawn);
        }
        (brood, gains)
    }

    /// Notes what both have found.
    fn driven(&mut self, brood: Brood, costs: &[f64]) {
        let (evolved, drawn) = costs.split_at(brood.gains().len());
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
