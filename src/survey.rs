//! Many gains, many starts, many seeds in one call. Every job can be split by index without changing a bit.

use serde::{Deserialize, Serialize};

use crate::control::Gains;
use crate::convoy::{Run, RunEnd};
use crate::cost::Cost;
use crate::episode::Setting;
use crate::evolution::{Brood, GenerationRecord, Individual, drawn, drive_all};
use crate::experiment::{EvolutionSettings, Experiment};
use crate::fields::{InvalidInput, shown};
use crate::random::LARGEST_INDEX;
use crate::starts::{Range, StartGrid, validate_part};

/// J of each of these gains, the mean over the start postures.
///
/// The error says how many are allowed in one call.
pub fn evaluate(setting: &Setting, gains: &[Gains]) -> Result<Vec<f64>, InvalidInput> {
    setting.experiment().validate_work("the number of gain triples", gains.len())?;
    Ok(totals(setting, gains))
}

fn totals(setting: &Setting, gains: &[Gains]) -> Vec<f64> {
    setting.costs(gains).iter().map(Cost::total).collect()
}

/// One of the three gains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Gain {
    /// kx
    #[serde(rename = "kx")]
    X,
    /// ky
    #[serde(rename = "ky")]
    Y,
    /// kθ
    #[serde(rename = "ktheta", alias = "kθ")]
    Theta,
}

impl Gain {
    fn set(self, gains: &mut Gains, value: f64) {
        match self {
            Self::X => gains.x = value,
            Self::Y => gains.y = value,
            Self::Theta => gains.theta = value,
        }
    }
}

/// `count` values of a gain, from `from` to `to`: evenly spaced, or with `log` evenly in the logarithm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// Which gain.
    pub gain: Gain,
    /// The first value.
    pub from: f64,
    /// The last value.
    pub to: f64,
    /// How many values.
    pub count: u32,
    /// Whether they are spaced evenly in the logarithm.
    #[serde(default)]
    pub log: bool,
}

impl Axis {
    /// The value with this index; with a count of 1 it is `from`.
    pub fn value(&self, index: u32) -> f64 {
        let Self { from, to, count, .. } = *self;
        if self.log {
            libm::exp(Range { from: libm::log(from), to: libm::log(to), count }.value(index))
        } else {
            Range { from, to, count }.value(index)
        }
    }

    fn validate(&self, name: &str) -> Result<(), InvalidInput> {
        let Self { from, to, count, .. } = *self;
        for (end, value) in [("from", from), ("to", to)] {
            if self.log && value.is_finite() && value <= 0.0 {
                let field = format!("{name}.{end}");
                return Err(InvalidInput::new(
                    field,
                    "a number over 0 on a log axis",
                    shown(value),
                ));
            }
        }
        Range { from, to, count }.validate(name)
    }
}

/// A rectangle of gains: two vary along the axes, the third stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landscape {
    /// The gain that varies within a row.
    pub x: Axis,
    /// The gain that varies from row to row.
    pub y: Axis,
    /// All three gains; those on the axes are replaced.
    pub gains: Gains,
}

impl Landscape {
    /// J of the cells in rows [first, end), row by row. The error names the field that is wrong.
    pub fn costs(&self, setting: &Setting, rows: [u32; 2]) -> Result<Vec<f64>, InvalidInput> {
        self.x.validate("x")?;
        self.y.validate("y")?;
        if self.x.gain == self.y.gain {
            let found = format!("{:?} on both", self.y.gain).to_lowercase();
            return Err(InvalidInput::new("y.gain", "another gain than x.gain", found));
        }
        let [first, end] = validate_part("rows", rows, self.y.count)?;
        let cells = (end - first) as usize * self.x.count as usize;
        setting.experiment().validate_work("the number of cells", cells)?;
        let gains_at = |row, column| {
            let mut gains = self.gains;
            self.x.gain.set(&mut gains, self.x.value(column));
            self.y.gain.set(&mut gains, self.y.value(row));
            gains
        };
        let cells = (first..end)
            .flat_map(|row| (0..self.x.count).map(move |column| gains_at(row, column)))
            .collect::<Vec<_>>();
        Ok(totals(setting, &cells))
    }
}

/// How the robot with these gains fares from each posture of the grid with index in [first, end).
///
/// The start postures of the experiment do not matter. The error names the field that is wrong.
pub fn robustness(
    setting: &Setting,
    gains: Gains,
    grid: &StartGrid,
    part: [u32; 2],
) -> Result<Vec<RunEnd>, InvalidInput> {
    grid.validate()?;
    let count = u32::try_from(grid.count()).unwrap_or(u32::MAX);
    let [first, end] = validate_part("part", part, count)?;
    let runs = (end - first) as usize;
    // One run each, however many starts the experiment has.
    let single = Experiment { starts: Vec::new(), ..setting.experiment().clone() };
    single.validate_work("the number of starts", runs)?;
    Ok(setting.drive(runs, |i| {
        let index = first as usize + i;
        // A start beyond the streams shares one with another; their disturbances stay in the bounds.
        Run { gains, start: grid.posture(index), stream: index as u32 % (LARGEST_INDEX + 1) }
    }))
}

/// How the robot with these gains fares from each start posture of the experiment, in their order.
///
/// Their costs' mean is what [`evaluate`] gives for these gains.
pub fn fares(setting: &Setting, gains: Gains) -> Vec<RunEnd> {
    let starts = &setting.experiment().starts;
    setting.drive(starts.len(), |i| Run { gains, start: starts[i], stream: i as u32 })
}

/// What one seed's run found, and what random search found with the same number of evaluations.
#[derive(Clone, Debug, PartialEq)]
pub struct SeedRun {
    /// The best J of each generation, from 0.
    pub best: Vec<f64>,
    /// The individual with the best J in the end.
    pub champion: Individual,
    /// The best J that random search has found by the time of each generation.
    ///
    /// It draws a new population from the initial range for each generation, the first being evolution's own.
    pub random: Vec<f64>,
}

/// Runs evolution for `generations` with each seed in [first, end), beside random search.
///
/// The seed of the experiment does not matter. The error names the field that is wrong.
pub fn seed_runs(
    experiment: &Experiment,
    seeds: [u32; 2],
    generations: u32,
) -> Result<Vec<SeedRun>, InvalidInput> {
    let [first, end] = validate_part("seeds", seeds, u32::MAX)?;
    let drives = f64::from(experiment.evolution.population)
        * (f64::from(generations) + 1.0)
        * f64::from(end - first);
    // Evolution and random search.
    experiment.validate_work("the number of drives", (2.0 * drives) as usize)?;
    let setting = Setting::new(experiment.clone())?;
    let mut searches: Vec<_> = (first..end).map(|seed| Search::new(experiment, seed)).collect();
    drive_all(&setting, searches.iter_mut().flat_map(|search| &mut search.population));
    searches.iter_mut().for_each(Search::begin);
    for generation in 1..=generations {
        let (mut broods, mut draws): (Vec<_>, Vec<_>) =
            searches.iter().map(|search| search.candidates(generation)).unzip();
        let offspring = broods.iter_mut().flat_map(|brood| &mut brood.offspring);
        drive_all(&setting, offspring.chain(draws.iter_mut().flatten()));
        for ((search, brood), draw) in searches.iter_mut().zip(broods).zip(draws) {
            search.choose(brood, &draw, generation);
        }
    }
    Ok(searches.into_iter().map(|search| search.found).collect())
}

/// Evolution and random search with one seed. All seeds take a step together, so that there are many runs to drive.
struct Search {
    settings: EvolutionSettings,
    population: Vec<Individual>,
    found: SeedRun,
}

impl Search {
    fn new(experiment: &Experiment, seed: u32) -> Self {
        let settings = EvolutionSettings { seed, ..experiment.evolution };
        let population = drawn(&settings, 0);
        let found = SeedRun { best: Vec::new(), champion: population[0], random: Vec::new() };
        Self { settings, population, found }
    }

    /// Ranks generation 0, which both begin with; it was driven.
    fn begin(&mut self) {
        let population = core::mem::take(&mut self.population);
        self.note(GenerationRecord::founded(population), f64::INFINITY);
    }

    /// Whom evolution and whom random search tries next; all are still to be driven.
    fn candidates(&self, generation: u32) -> (Brood, Vec<Individual>) {
        (Brood::of(&self.settings, &self.population, generation), drawn(&self.settings, generation))
    }

    /// Lets those that were tried, and driven, take part.
    fn choose(&mut self, brood: Brood, draw: &[Individual], generation: u32) {
        let parents = core::mem::take(&mut self.population);
        let record = GenerationRecord::selected(&self.settings, parents, brood, generation);
        self.note(record, best(draw).cost);
    }

    /// Goes on with the survivors of a generation, beside which random search has found this cost.
    fn note(&mut self, record: GenerationRecord, drawn: f64) {
        self.population = record.population();
        let SeedRun { best: costs, champion, random } = &mut self.found;
        *champion = best(&self.population);
        costs.push(champion.cost);
        let lowest = random.last().unwrap_or(&champion.cost);
        random.push(lowest.min(drawn));
    }
}

/// The first of those with the lowest cost.
fn best(population: &[Individual]) -> Individual {
    let lower =
        |a: Individual, b: &Individual| if b.cost.total_cmp(&a.cost).is_lt() { *b } else { a };
    population[1..].iter().fold(population[0], lower)
}
