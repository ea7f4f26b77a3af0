//! How a search comes down with many seeds, drive by drive.

use super::part::validate_part;
use super::seeds::BYTES_OF_A_SOLUTION;
use crate::robot::Gains;
use crate::run::{BYTES_OF_AN_OBJECT, Setting, Work};
use crate::schema::{Allowed, Column, InvalidInput, Place, Source, read_whole, record};
use crate::search::{Brood, EvolutionSettings, LAST_GENERATION, Search, search};

/// How many drives a trial may have.
const DRIVES: Allowed = Allowed::whole(1, LAST_GENERATION);

record! { required (Copy)
    /// Which seeds [first, end) to run, and with how many drives each.
    pub struct Trials {
        /// The seeds [first, end).
        pub seeds: [u32; 2] => "seeds" in Allowed::SEED,
        /// How many drives; one from several start postures counts once.
        pub drives: u32 => "drives" in DRIVES,
    }
}

impl Trials {
    /// Seeds and drives.
    pub fn read<S: Source>(given: &S) -> Result<Self, InvalidInput> {
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
pub fn trials(setting: &Setting, seeds: [u32; 2], drives: u32) -> Result<Vec<Trial>, InvalidInput> {
    let [first, end] = validate_part("seeds", seeds, u32::MAX)?;
    DRIVES.check("drives", drives.into())?;
    let (experiment, e) = (setting.experiment(), setting.experiment().evolution);
    let (count, starts) = (f64::from(end - first), experiment.starts.len());
    let all = f64::from(drives) * count;
    Work { field: "the number of drives", count: all, starts, bytes: 0.0 }
        .check_solutions(experiment)?;
    let kept = f64::from(e.population.max(e.most_solutions()));
    let columns = f64::from(drives) * size_of::<[f64; 2]>() as f64;
    let bytes = kept * BYTES_OF_A_SOLUTION + columns + BYTES_OF_AN_OBJECT;
    Work { field: "the number of seeds", count, starts: 1, bytes }.check(experiment)?;

    let mut runs: Vec<_> =
        (first..end).map(|seed| Descent::new(EvolutionSettings { seed, ..e })).collect();
    loop {
        let broods: Vec<_> = runs.iter().map(|run| run.asked(drives)).collect();
        let gains: Vec<_> = broods.iter().flatten().flat_map(|(_, gains)| gains).copied().collect();
        if gains.is_empty() {
            return Ok(runs.into_iter().map(Descent::finished).collect());
        }
        let costs = setting.totals(&gains);
        let mut rest = costs.as_slice();
        for (run, brood) in runs.iter_mut().zip(broods) {
            let Some((brood, gains)) = brood else { continue };
            let (own, others) = rest.split_at(gains.len());
            run.driven(brood, &gains, own);
            rest = others;
        }
    }
}

/// A search with one seed. All seeds take a step together, so that there are many runs to drive.
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

    /// What it tries next, as far as so many drives reach; nothing where there are none left.
    fn asked(&self, drives: u32) -> Option<(Brood, Vec<Gains>)> {
        let left = drives - self.driven;
        (left > 0).then(|| {
            let brood = self.search.ask(&self.settings, self.generation);
            let mut gains = brood.gains();
            gains.truncate(left as usize);
            (brood, gains)
        })
    }

    fn driven(&mut self, brood: Brood, gains: &[Gains], costs: &[f64]) {
        for (gains, cost) in gains.iter().zip(costs) {
            self.driven += 1;
            let is_first = self.champion.is_none();
            if is_first || self.champion.is_some_and(|best| *cost < best.cost) {
                self.champion = Some(Champion { gains: *gains, cost: *cost });
                self.drives.push(self.driven.into());
                self.costs.push(*cost);
            }
        }
        // A generation for which the drives do not suffice is the last.
        if brood.gains().len() == costs.len() {
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
