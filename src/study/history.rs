//! A whole run of evolution, and every generation of it.

use super::hash::Hash;
use crate::run::{MAX_WORK, Setting};
use crate::schema::{InvalidInput, Result, Text};
use crate::search::{GenerationRecord, Individual, Search, Statistics, search};

/// A run of evolutionary programming, or of one of its rivals, that remembers itself.
///
/// It keeps the statistics of every generation, and where the search stood in some; any other generation is computed again,
/// to the same bits, from the last one kept before it.
#[derive(Clone, Debug)]
pub struct Evolution {
    setting: Setting,
    search: Box<dyn Search>,
    statistics: Vec<Statistics>,
    snapshots: Vec<Box<dyn Search>>,
    /// Generations from one snapshot to the next.
    snapshot_interval: u32,
    hash: Hash,
}

/// The memory that snapshots may take before every second one is dropped, if what is between two can be driven again in one
/// call; and the memory that they may take at all.
const SNAPSHOT_BYTES: usize = 32 << 20;
const MOST_SNAPSHOT_BYTES: usize = 64 << 20;

/// What a snapshot takes besides its population.
const SNAPSHOT_BASE: usize = 512;

/// Takes a search through a generation.
fn advance(setting: &Setting, search: &mut dyn Search, number: u32) -> GenerationRecord {
    let e = &setting.experiment().evolution;
    let brood = search.ask(e, number);
    let costs = setting.totals(&brood.gains());
    search.tell(e, brood, &costs)
}

impl Evolution {
    /// Generation 0: the random initial population, driven.
    pub fn new(setting: Setting) -> Self {
        let mut evolution = Self {
            search: search(setting.experiment().evolution.method),
            setting,
            statistics: Vec::new(),
            snapshots: Vec::new(),
            snapshot_interval: 1,
            hash: Hash::EMPTY,
        };
        evolution.append();
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
        self.append();
        self.newest()
    }

    /// Evolves so many generations, at least one; the error says how many one call may have. One is never refused.
    pub fn advance(&mut self, generations: u32) -> Result<Statistics> {
        if generations > 1 {
            self.setting.experiment().check_generations(generations)?;
        }
        for _ in 1..generations {
            self.append();
        }
        Ok(self.step())
    }

    /// The newest generation in short.
    pub fn newest(&self) -> Statistics {
        self.statistics[self.statistics.len() - 1]
    }

    /// One generation in short; the error says which there are.
    pub fn statistics(&self, generation: u32) -> Result<Statistics> {
        Ok(self.statistics[self.validate(generation)? as usize])
    }

    /// One generation in full; the error says which there are.
    ///
    /// It drives again what is no longer known: at most [`MAX_WORK`] samples, or one generation; more only where a history is
    /// so long that its memory asks for it.
    pub fn record(&self, generation: u32) -> Result<GenerationRecord> {
        let number = self.validate(generation)?;
        let mut search = match number {
            0 => search(self.setting.experiment().evolution.method),
            _ => self.search_after(number - 1),
        };
        let e = &self.setting.experiment().evolution;
        let plan = search.plan(e);
        let record = advance(&self.setting, search.as_mut(), number);
        Ok(GenerationRecord { plan, next: search.plan(e), ..record })
    }

    /// The population that a generation left, best ranked first; the error says which there are.
    pub fn population(&self, generation: u32) -> Result<Vec<Individual>> {
        Ok(self.search_after(self.validate(generation)?).population().to_vec())
    }

    /// 16 hexadecimal digits over the numbers that decide a history: FNV-1a over the little-endian bytes of each generation's
    /// number, parents, offspring, opponents, wins and survivors. Two runs that differ in a bit of them differ in it, but for
    /// one chance in 2⁶⁴.
    pub fn hash(&self) -> String {
        self.hash.digits()
    }

    /// How many generations a record drives at most.
    pub fn most_driven_again(&self) -> u32 {
        self.snapshot_interval
    }

    /// The error that says which generations there are.
    pub(crate) fn refused(&self, found: impl Into<Text>) -> InvalidInput {
        let expected = format!("a whole number from 0 to {}, the newest", self.generation());
        InvalidInput::new("generation", expected, found)
    }

    fn validate(&self, generation: u32) -> Result<u32> {
        if generation <= self.generation() {
            return Ok(generation);
        }
        Err(self.refused(generation))
    }

    /// Where the search stood after a generation.
    fn search_after(&self, number: u32) -> Box<dyn Search> {
        if number == self.generation() {
            return self.search.clone();
        }
        let kept = number / self.snapshot_interval;
        let mut search = self.snapshots[kept as usize].clone();
        for number in kept * self.snapshot_interval + 1..=number {
            advance(&self.setting, search.as_mut(), number);
        }
        search
    }

    fn append(&mut self) {
        let number = self.statistics.len() as u32;
        let record = advance(&self.setting, self.search.as_mut(), number);
        self.hash.record(&record);
        let starts = self.setting.experiment().starts.len();
        let before = self.statistics.last().map_or(0.0, |last| last.evaluations);
        let evaluations = before + (record.tried().len() * starts) as f64;
        let (best, population) = (self.search.best(), self.search.population());
        self.statistics.push(Statistics::new(number, evaluations, best, population));
        if number.is_multiple_of(self.snapshot_interval) {
            self.snapshots.push(self.search.clone());
            self.thin_out();
        }
    }

    /// Drops every second snapshot when they take much memory, though as long as there is some left not if driving again what
    /// is between two then takes too long.
    fn thin_out(&mut self) {
        let snapshot = SNAPSHOT_BASE + size_of_val(self.search.population());
        let bytes = self.snapshots.len() * snapshot;
        let experiment = self.setting.experiment();
        let generation =
            f64::from(experiment.evolution.most_solutions()) * experiment.work_of_a_solution();
        let again = 2.0 * f64::from(self.snapshot_interval) * generation;
        if bytes > SNAPSHOT_BYTES && (again <= MAX_WORK || bytes > MOST_SNAPSHOT_BYTES) {
            let mut keep = false;
            self.snapshots.retain(|_| {
                keep = !keep;
                keep
            });
            self.snapshot_interval *= 2;
        }
    }
}
