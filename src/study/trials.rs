//! How a search comes down with many seeds, drive by drive.
//!
//! A trial is here, as where methods are compared, one run of a search: with a seed of its own.

use super::part::validate_part;
use super::searches::{check_searches, step_together};
use crate::robot::Gains;
use crate::run::Setting;
use crate::schema::{Allowed, Column, Place, Result, Source, read_whole, record};
use crate::search::{Brood, EvolutionSettings, LAST_GENERATION, Search, search};

/// How many drives a trial may have.
const DRIVES: Allowed = Allowed::whole(1, LAST_GENERATION);

record! { required (Copy)
    /// Which seeds [first, end) to run, and with how many drives each.
    pub struct Trials {
        /// The seeds [first, end); the last of all, 2³² − 1, cannot be among them.
        pub seeds: [u32; 2] => "seeds" in Allowed::SEED,
        /// How many drives; one from several start postures counts once.
        pub drives: u32 => "drives" in DRIVES,
    }
}

impl Trials {
    /// Seeds and drives.
    pub fn read<S: Source>(given: &S) -> Result<Self> {
        let none = Self { seeds: [0; 2], drives: 0 };
        read_whole(none, given, Place::Named("trials"), &Allowed::ANY)
    }
}

record! { (Copy)
    /// The gains that a search has found, and what they cost.
    pub struct Champion {
        /// The gains (kx, ky, kθ).
        pub gains: Gains => "gains",
        /// J.
        pub cost: f64 => "cost",
    }
}

record! {
    /// How a search with one seed came down.
    pub struct Trial {
        /// The seed.
        pub seed: u32 => "seed",
        /// At which drives, counted from 1, the best J fell.
        pub drives: Column => "drives",
        /// To what it fell then.
        pub costs: Column => "costs",
        /// The best in the end.
        pub champion: Champion => "champion",
    }
}

/// Runs the method of the experiment with each seed for so many drives.
///
/// The seed of the experiment does not matter. The error names the field that is wrong.
pub fn trials(setting: &Setting, seeds: [u32; 2], drives: u32) -> Result<Vec<Trial>> {
    let [first, end] = validate_part("seeds", seeds, u32::MAX)?;
    DRIVES.check("drives", drives.into())?;
    check_searches(setting, f64::from(end - first), drives.into(), drives.into())?;

    let settings = setting.experiment().evolution;
    let descent = |seed| Descent::new(EvolutionSettings { seed, ..settings });
    let mut descents: Vec<_> = (first..end).map(descent).collect();
    while descents.iter().any(|descent| descent.driven < drives) {
        step_together(setting, &mut descents, |descent| descent.asked(drives), Descent::driven);
    }
    Ok(descents.into_iter().map(Descent::finished).collect())
}

/// A search with one seed.
struct Descent {
    settings: EvolutionSettings,
    search: Box<dyn Search>,
    generation: u32,
    driven: u32,
    drives: Vec<f64>,
    costs: Vec<f64>,
    champion: Option<Champion>,
}

impl Descent {
    fn new(settings: EvolutionSettings) -> Self {
        let search = search(settings.method);
        let [drives, costs] = [Vec::new(), Vec::new()];
        Self { settings, search, generation: 0, driven: 0, drives, costs, champion: None }
    }

    /// What it tries next, as far as so many drives reach.
    fn asked(&self, drives: u32) -> (Brood, Vec<Gains>) {
        let brood = self.search.ask(&self.settings, self.generation);
        let mut gains = brood.gains();
        gains.truncate((drives - self.driven) as usize);
        (brood, gains)
    }

    fn driven(&mut self, brood: Brood, costs: &[f64]) {
        let all = brood.gains();
        for (&gains, &cost) in all.iter().zip(costs) {
            self.driven += 1;
            if self.champion.is_none_or(|best| cost < best.cost) {
                self.champion = Some(Champion { gains, cost });
                self.drives.push(self.driven.into());
                self.costs.push(cost);
            }
        }
        // A generation for which the drives do not suffice is the last.
        if all.len() == costs.len() {
            self.search.tell(&self.settings, brood, costs);
            self.generation += 1;
        }
    }

    fn finished(self) -> Trial {
        Trial {
            seed: self.settings.seed,
            drives: Column(self.drives),
            costs: Column(self.costs),
            champion: self.champion.expect("one drive at least"),
        }
    }
}
