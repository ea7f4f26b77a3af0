//! A whole run of evolution, and every generation of it.

use super::{GenerationRecord, Individual, Statistics};
use crate::episode::Setting;
use crate::experiment::Experiment;
use crate::fields::{InvalidInput, shown};
use crate::random::LARGEST_INDEX;

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

/// The memory that snapshots may take. When it is full every second one is dropped.
const SNAPSHOT_BYTES: usize = 8 << 20;

/// The last generation that a run can reach; the number of streams sets it.
pub const LAST_GENERATION: u32 = LARGEST_INDEX;

impl Evolution {
    /// Generation 0: the random initial population, driven.
    ///
    /// The error names the field of the experiment that is wrong.
    pub fn new(experiment: Experiment) -> Result<Self, InvalidInput> {
        let setting = Setting::new(experiment)?;
        let mut evolution = Self {
            setting,
            population: Vec::new(),
            statistics: Vec::new(),
            snapshots: Vec::new(),
            snapshot_interval: 1,
            hash: Hash::EMPTY,
        };
        evolution.append(GenerationRecord::initial(&evolution.setting));
        Ok(evolution)
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
    pub fn step(&mut self) -> Statistics {
        let generation = self.generation() + 1;
        assert!(generation <= LAST_GENERATION, "a run ends at generation {LAST_GENERATION}");
        let parents = self.population.clone();
        self.append(GenerationRecord::next(&self.setting, parents, generation));
        self.newest()
    }

    /// The newest generation in short.
    pub fn newest(&self) -> Statistics {
        self.statistics[self.statistics.len() - 1]
    }

    /// One generation in short; the error says which there are.
    pub fn statistics(&self, generation: f64) -> Result<Statistics, InvalidInput> {
        let generation = self.validate(generation)?;
        Ok(self.statistics[generation as usize])
    }

    /// One generation in full; the error says which there are.
    pub fn record(&self, generation: f64) -> Result<GenerationRecord, InvalidInput> {
        let generation = self.validate(generation)?;
        if generation == 0 {
            return Ok(GenerationRecord::initial(&self.setting));
        }
        let parents = self.population_after(generation - 1);
        Ok(GenerationRecord::next(&self.setting, parents, generation))
    }

    /// The population that a generation left, best ranked first; the error says which there are.
    pub fn population(&self, generation: f64) -> Result<Vec<Individual>, InvalidInput> {
        Ok(self.population_after(self.validate(generation)?))
    }

    /// 16 hexadecimal digits over every number of the history: FNV-1a over the little-endian bytes of each generation's
    /// number, parents, offspring, opponents, wins and survivors. Two runs with the same hash are the same to the bit.
    pub fn hash(&self) -> String {
        format!("{:016x}", self.hash.0)
    }

    fn validate(&self, generation: f64) -> Result<u32, InvalidInput> {
        let last = self.generation();
        if generation.fract() == 0.0 && (0.0..=f64::from(last)).contains(&generation) {
            Ok(generation as u32)
        } else {
            let expected = format!("a whole number from 0 to {last}, the newest");
            Err(InvalidInput::new("generation", expected, shown(generation)))
        }
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
        self.statistics.push(Statistics::new(&record, starts));
        if record.generation.is_multiple_of(self.snapshot_interval) {
            self.snapshots.push(self.population.clone());
            let bytes = self.snapshots.len() * size_of_val(self.population.as_slice());
            if bytes > SNAPSHOT_BYTES {
                let mut keep = false;
                self.snapshots.retain(|_| {
                    keep = !keep;
                    keep
                });
                self.snapshot_interval *= 2;
            }
        }
    }
}

/// FNV-1a, 64 bits.
#[derive(Clone, Copy, Debug)]
struct Hash(u64);

impl Hash {
    const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    fn word(&mut self, word: u64) {
        const PRIME: u64 = 0x0000_0100_0000_01b3;
        // A byte of zero only multiplies, so that the zeros at the end of a small number are one multiplication.
        let zeros = word.leading_zeros() / 8;
        for byte in &word.to_le_bytes()[..8 - zeros as usize] {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(PRIME);
        }
        self.0 = self.0.wrapping_mul(PRIME.wrapping_pow(zeros));
    }

    fn number(&mut self, number: f64) {
        // The bits of NaN are the machine's choice, so all count as one.
        self.word(if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() });
    }

    fn record(&mut self, record: &GenerationRecord) {
        self.word(record.generation.into());
        for individual in record.parents.iter().chain(&record.offspring) {
            individual.gains.iter().chain(&individual.sigmas).for_each(|x| self.number(*x));
            self.number(individual.cost);
        }
        let opponents = record.tournament.opponents.iter().flatten();
        for number in opponents.chain(&record.tournament.wins).chain(&record.survivors) {
            self.word((*number).into());
        }
    }
}
