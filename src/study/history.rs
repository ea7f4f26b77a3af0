//! A whole run of evolution, and every generation of it.

use super::hash::Hash;
use crate::run::{MAX_WORK, Setting};
use crate::schema::InvalidInput;
use crate::search::{Brood, GenerationRecord, Individual, Statistics};

/// A run of evolutionary programming that remembers itself.
///
/// It keeps the statistics of every generation, and the populations of some; any other generation is computed again,
/// to the same bits, from the last one kept before it.
#[derive(Clone, Debug)]
pub struct Evolution {
    setting: Setting,
    population: Vec<Individual>,
    statistics: Vec<Statistics>,
    snapshots: Vec<Vec<Individual>>,
    /// Generations from one snapshot to the next.
    snapshot_interval: u32,
    hash: Hash,
}

/// The memory that snapshots may take before every second one is dropped.
const SNAPSHOT_BYTES: usize = 32 << 20;

impl GenerationRecord {
    /// Generation 0: N individuals with k_j uniform in the initial range and σ_j the initial σ (steps 1 and 2).
    pub fn initial(setting: &Setting) -> Self {
        Self::driven(setting, Brood::first(&setting.experiment().evolution))
    }

    /// Steps 3 to 6 of the paper's procedure: one offspring of each parent, their drives, the tournament.
    ///
    /// It depends on the setting, the parents and the generation's number alone.
    ///
    /// # Panics
    /// If the generation is beyond [`LAST_GENERATION`](crate::search::LAST_GENERATION).
    pub fn next(setting: &Setting, parents: Vec<Individual>, generation: u32) -> Self {
        Self::driven(setting, Brood::of(&setting.experiment().evolution, parents, generation))
    }

    fn driven(setting: &Setting, brood: Brood) -> Self {
        let costs = setting.totals(&brood.trials());
        brood.driven(&setting.experiment().evolution, &costs)
    }
}

impl Evolution {
    /// Generation 0: the random initial population, driven.
    pub fn new(setting: Setting) -> Self {
        let mut evolution = Self {
            setting,
            population: Vec::new(),
            statistics: Vec::new(),
            snapshots: Vec::new(),
            snapshot_interval: 1,
            hash: Hash::EMPTY,
        };
        evolution.append(GenerationRecord::initial(&evolution.setting));
        evolution
    }

    /// The validated experiment.
    pub fn setting(&self) -> &Setting {
        &self.setting
    }

    /// The newest generation.
    pub fn generation(&self) -> u32 {
        self.statistics.len() as u32 - 1
    }

    /// Evolves one generation.
    ///
    /// # Panics
    /// If the newest is [`LAST_GENERATION`](crate::search::LAST_GENERATION), for which no memory suffices.
    pub fn step(&mut self) -> Statistics {
        let parents = self.population.clone();
        self.append(GenerationRecord::next(&self.setting, parents, self.generation() + 1));
        self.newest()
    }

    /// The newest generation in short.
    pub fn newest(&self) -> Statistics {
        self.statistics[self.statistics.len() - 1]
    }

    /// One generation in short; the error says which there are.
    pub fn statistics(&self, generation: u32) -> Result<Statistics, InvalidInput> {
        Ok(self.statistics[self.validate(generation)? as usize])
    }

    /// One generation in full; the error says which there are.
    ///
    /// It drives again what is no longer known: at most [`MAX_WORK`] samples, or one generation.
    pub fn record(&self, generation: u32) -> Result<GenerationRecord, InvalidInput> {
        match self.validate(generation)? {
            0 => Ok(GenerationRecord::initial(&self.setting)),
            generation => {
                let parents = self.population_after(generation - 1);
                Ok(GenerationRecord::next(&self.setting, parents, generation))
            }
        }
    }

    /// The population that a generation left, best ranked first; the error says which there are.
    pub fn population(&self, generation: u32) -> Result<Vec<Individual>, InvalidInput> {
        Ok(self.population_after(self.validate(generation)?))
    }

    /// 16 hexadecimal digits over every number of the history: FNV-1a over the little-endian bytes of each generation's
    /// number, parents, offspring, opponents, wins and survivors. Two runs with the same hash are the same to the bit.
    pub fn hash(&self) -> String {
        self.hash.digits()
    }

    /// How many generations a record drives at most.
    pub fn most_driven_again(&self) -> u32 {
        self.snapshot_interval
    }

    /// The error that says which generations there are.
    pub(crate) fn refused(&self, found: String) -> InvalidInput {
        let expected = format!("a whole number from 0 to {}, the newest", self.generation());
        InvalidInput::new("generation", expected, found)
    }

    fn validate(&self, generation: u32) -> Result<u32, InvalidInput> {
        if generation <= self.generation() {
            return Ok(generation);
        }
        Err(self.refused(generation.to_string()))
    }

    fn population_after(&self, generation: u32) -> Vec<Individual> {
        if generation == self.generation() {
            return self.population.clone();
        }
        let kept = generation / self.snapshot_interval;
        let snapshot = self.snapshots[kept as usize].clone();
        (kept * self.snapshot_interval + 1..=generation).fold(snapshot, |parents, generation| {
            GenerationRecord::next(&self.setting, parents, generation).population()
        })
    }

    fn append(&mut self, record: GenerationRecord) {
        self.hash.record(&record);
        self.population = record.population();
        let starts = self.setting.experiment().starts.len();
        self.statistics.push(Statistics::new(record.generation, &self.population, starts));
        if record.generation.is_multiple_of(self.snapshot_interval) {
            self.snapshots.push(self.population.clone());
            self.thin_out();
        }
    }

    /// Drops every second snapshot when they take much memory, unless driving again what is between two then takes too long.
    fn thin_out(&mut self) {
        let bytes = self.snapshots.len() * size_of_val(self.population.as_slice());
        let experiment = self.setting.experiment();
        let drives = self.population.len() as f64 * experiment.starts.len() as f64;
        let again =
            2.0 * f64::from(self.snapshot_interval) * drives * f64::from(self.setting.samples());
        if bytes > SNAPSHOT_BYTES && again <= MAX_WORK {
            let mut keep = false;
            self.snapshots.retain(|_| {
                keep = !keep;
                keep
            });
            self.snapshot_interval *= 2;
        }
    }
}
