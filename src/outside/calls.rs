//! What is asked of an experiment: one table, of which each boundary makes its functions.

use super::given::{self, number};
use crate::robot::Gains;
use crate::run::{Experiment, Run, RunEnd, Setting};
use crate::schema::{Column, Columns, Each, Plain, Result, Source, Types};
use crate::study::{
    self, Landscape, PartsSample, RemainingError, SeedRun, SeedRuns, Stability, StartGrid, Trial,
    Trials,
};
use crate::theory::{LawTerms, read_error};

/// The calls, handed to a macro: what each tells, its name, here and in JavaScript, what is given to it and what comes, each
/// with its type in TypeScript. What stands behind a semicolon is a number that may be left out.
macro_rules! calls {
    ($with:ident) => {
        $with! { setting
            "J of each gain triple, the mean over the start postures: n triples in, n costs out."
            evaluate "evaluate"(gains: "Gains") -> Column as "Float64Array" {
                Column(setting.evaluate(&Gains::read_all(gains)?)?)
            }
            "Drives one robot from `starts[start]` (0 if left out) to the end of its run."
            simulate "simulate"(gains: "Gains"; start) -> Run as "Run" {
                let from = given::start(setting, start)?;
                setting.run(Gains::read_one(gains)?, from)
            }
            "Drives a robot with each gain triple from `starts[start]` (0 if left out)."
            simulate_all "simulateAll"(gains: "Gains"; start) -> Each<'a, Run> as "Run[]" {
                let from = given::start(setting, start)?;
                let gains = Gains::read_all(gains)?;
                setting.check_runs(gains.len())?;
                let count = gains.len() as u32;
                Each { count, make: Box::new(move |i| setting.run(gains[i as usize], from)) }
            }
            "J over two gains, row by row: `x.count` values for each row of `rows`."
            landscape "landscape"(landscape: "Landscape") -> Column as "Float64Array" {
                let (landscape, rows) = Landscape::read(landscape)?;
                Column(landscape.costs(setting, rows)?)
            }
            "How a robot with these gains fares from many starts: positions on a grid, each with several headings."
            robustness "robustness"(grid: "StartGrid") -> Columns<RunEnd> as "Robustness" {
                let (StartGrid { gains, grid }, part) = StartGrid::read(grid)?;
                Columns(study::robustness(setting, gains, &grid, part)?)
            }
            "What the control law makes of an error posture (3): the terms of its command, and the rate of V that it promises."
            law_terms "lawTerms"(gains: "Gains", error: "Posture") -> LawTerms as "LawTerms" {
                let Experiment { law, reference_velocity, .. } = setting.experiment();
                let gains = Gains::read_one(gains)?;
                LawTerms::new(*law, &read_error(error)?, &gains, *reference_velocity)
            }
            "How one robot fares from each of the experiment's starts: J, t_f and whether it arrives."
            fares "fares"(gains: "Gains") -> Columns<RunEnd> as "Robustness" {
                Columns(study::fares(setting, Gains::read_one(gains)?))
            }
            "The Lyapunov function of one run from `starts[start]` (0 if left out)."
            stability "stability"(gains: "Gains"; start) -> Stability as "Stability" {
                let from = given::start(setting, start)?;
                Stability::of(setting, &Gains::read_one(gains)?, from)
            }
            "The parts of the error over time that Theorem 2 bounds, of one run from each start posture."
            error_parts "errorParts"(gains: "Gains") -> Each<'a, Columns<PartsSample>> as "ErrorParts[]" {
                let gains = Gains::read_one(gains)?;
                study::check_error_parts(setting)?;
                let count = setting.experiment().starts.len() as u32;
                let make = move |start| Columns(study::error_parts(setting, &gains, start));
                Each { count, make: Box::new(make) }
            }
            "What remains of the error in the last `seconds` of a run from each start posture, beside the sets of Theorem 2. A robot that arrives stops there; where the tolerances are 0 it goes on to the horizon."
            remaining_errors "remainingErrors"(gains: "Gains", seconds: "number")
                -> Columns<RemainingError> as "RemainingErrors"
            {
                let seconds = number(seconds, "seconds")?;
                let gains = Gains::read_one(gains)?;
                Columns(study::remaining_errors(setting, &gains, seconds)?)
            }
            "The method of the experiment with many seeds, beside random search with the same number of drives."
            seed_runs "seedRuns"(seeds: "SeedRuns") -> Vec<SeedRun> as "SeedRun[]" {
                let SeedRuns { seeds, generations } = SeedRuns::read(seeds)?;
                study::seed_runs(setting, seeds, generations)?
            }
            "The method of the experiment with many seeds: at which drives the best J fell, and to what."
            trials "trials"(trials: "Trials") -> Vec<Trial> as "Trial[]" {
                let Trials { seeds, drives } = Trials::read(trials)?;
                study::trials(setting, seeds, drives)?
            }
        }
    };
}

#[cfg(all(target_arch = "wasm32", any(feature = "javascript", feature = "bytes")))]
// else there is no boundary
pub(crate) use calls;

// All have the lifetime that some need.
macro_rules! functions {
    ($setting:ident $(
        $doc:literal
        $name:ident $js:literal($($given:ident: $type:literal),+ $(; $last:ident)?) -> $returned:ty as $told:literal
        $body:block
    )+) => {
        $(
            #[doc = $doc]
            #[allow(clippy::needless_lifetimes)]
            pub fn $name<'a, S: Source>(
                $setting: &'a Setting,
                $($given: &S,)+
                $($last: &S)?
            ) -> Result<$returned> {
                Ok($body)
            }
        )+

        /// The type of what comes of each call in TypeScript, as the table has it and as it is.
        #[allow(clippy::extra_unused_lifetimes)]
        pub fn returned<'a>(types: &mut Types) -> Vec<[String; 2]> {
            vec![$([$told.into(), <$returned>::typescript(types)]),+]
        }
    };
}

calls!(functions);
