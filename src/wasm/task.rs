//! An experiment that is read once and driven often.

use js_sys::{Array, Float64Array};
use wasm_bindgen::prelude::*;

use super::Result;
use super::read::{Given, number, setting, start};
use super::write::plain;
use crate::robot::Gains;
use crate::run::{Experiment, Setting};
use crate::schema::Columns;
use crate::study::{self, GridOfRobot, Landscape, SeedRuns, Trials};
use crate::theory::{LawTerms, read_error};

/// An experiment that is read once. Its methods are the functions of the same names without their first argument.
#[wasm_bindgen]
pub struct Task(Setting);

#[wasm_bindgen]
impl Task {
    /// Throws an Error that names the field when one is unknown, of a wrong type, or out of its range.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    ) -> Result<Task> {
        Ok(Task(setting(experiment)?))
    }

    /// The experiment with every field filled in.
    #[wasm_bindgen(getter, unchecked_return_type = "Experiment")]
    pub fn experiment(&self) -> JsValue {
        plain(self.0.experiment())
    }
}

/// Methods of a task, and functions of the same names that read the experiment themselves: their arguments have these types
/// in JavaScript, the last of which may be left out. (Documentation as texts: the types would show `///` of a macro as r"…".)
macro_rules! tasks {
    ($(
        $($doc:literal)+
        $name:ident as $js:literal(|$task:ident $(, $given:ident: $type:literal)+ $(; $last:ident)?| -> $returned:literal $body:block)
    )+) => {
        #[wasm_bindgen]
        impl Task {$(
            $(#[doc = $doc])+
            #[wasm_bindgen(js_name = $js, unchecked_return_type = $returned)]
            pub fn $name(
                &self,
                $(#[wasm_bindgen(unchecked_param_type = $type)] $given: JsValue,)+
                $(#[wasm_bindgen(unchecked_optional_param_type = "number")] $last: JsValue,)?
            ) -> Result<JsValue> {
                let $task = &self.0;
                $body
            }
        )+}

        $(
            $(#[doc = $doc])+
            #[wasm_bindgen(js_name = $js, unchecked_return_type = $returned)]
            pub fn $name(
                #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
                $(#[wasm_bindgen(unchecked_param_type = $type)] $given: JsValue,)+
                $(#[wasm_bindgen(unchecked_optional_param_type = "number")] $last: JsValue,)?
            ) -> Result<JsValue> {
                Task::new(experiment)?.$name($($given,)+ $($last)?)
            }
        )+
    };
}

tasks! {
    "J of each gain triple, the mean over the start postures: n triples in, n costs out."
    evaluate as "evaluate"(|setting, gains: "Gains"| -> "Float64Array" {
        let costs = setting.evaluate(&Gains::read_all(&Given::of(gains))?)?;
        Ok(Float64Array::from(costs.as_slice()).into())
    })
    "Drives one robot from `starts[start]` (0 if left out) to the end of its run."
    simulate as "simulate"(|setting, gains: "Gains"; from| -> "Run" {
        let from = start(setting, from)?;
        Ok(plain(&setting.run(Gains::read_one(&Given::of(gains))?, from)))
    })
    "Drives a robot with each gain triple from `starts[start]` (0 if left out)."
    simulate_all as "simulateAll"(|setting, gains: "Gains"; from| -> "Run[]" {
        let from = start(setting, from)?;
        let gains = Gains::read_all(&Given::of(gains))?;
        setting.check_runs(gains.len())?;
        Ok(gains.into_iter().map(|gains| plain(&setting.run(gains, from))).collect::<Array>().into())
    })
    "J over two gains, row by row: `x.count` values for each row of `rows`."
    landscape as "landscape"(|setting, landscape: "Landscape"| -> "Float64Array" {
        let (landscape, rows) = Landscape::read(&Given::of(landscape))?;
        let costs = landscape.costs(setting, rows)?;
        Ok(Float64Array::from(costs.as_slice()).into())
    })
    "How a robot with these gains fares from many starts: positions on a grid, each with several headings."
    robustness as "robustness"(|setting, grid: "StartGrid"| -> "Robustness" {
        let GridOfRobot { gains, starts } = GridOfRobot::read(&Given::of(grid))?;
        Ok(plain(&Columns(&study::robustness(setting, gains, &starts.grid, starts.part)?)))
    })
    "What the control law makes of an error posture (3): the terms of its command, and the rate of V that it promises."
    law_terms as "lawTerms"(|setting, gains: "Gains", error: "Posture"| -> "LawTerms" {
        let Experiment { law, reference_velocity, .. } = setting.experiment();
        let gains = Gains::read_one(&Given::of(gains))?;
        let error = read_error(&Given::of(error))?;
        Ok(plain(&LawTerms::new(*law, &error, &gains, *reference_velocity)))
    })
    "How one robot fares from each of the experiment's starts: J, t_f and whether it arrives."
    fares as "fares"(|setting, gains: "Gains"| -> "Robustness" {
        Ok(plain(&Columns(&study::fares(setting, Gains::read_one(&Given::of(gains))?))))
    })
    "The Lyapunov function of one run from `starts[start]` (0 if left out)."
    stability as "stability"(|setting, gains: "Gains"; from| -> "Stability" {
        let from = start(setting, from)?;
        Ok(plain(&study::Stability::of(setting, &Gains::read_one(&Given::of(gains))?, from)))
    })
    "The parts of the error over time that Theorem 2 bounds, of one run from each start posture."
    error_parts as "errorParts"(|setting, gains: "Gains"| -> "ErrorParts[]" {
        let gains = Gains::read_one(&Given::of(gains))?;
        study::check_error_parts(setting)?;
        let starts = 0..setting.experiment().starts.len() as u32;
        let parts = |start| plain(&Columns(&study::error_parts(setting, &gains, start)));
        Ok(starts.map(parts).collect::<Array>().into())
    })
    "What remains of the error in the last `seconds` of a run from each start posture, beside the sets of Theorem 2."
    remaining_errors as "remainingErrors"(|setting, gains: "Gains", seconds: "number"| -> "RemainingErrors" {
        let seconds = number(seconds, "seconds")?;
        let gains = Gains::read_one(&Given::of(gains))?;
        Ok(plain(&Columns(&study::remaining_errors(setting, &gains, seconds)?)))
    })
    "Evolution with many seeds, beside random search with the same number of drives."
    seed_runs as "seedRuns"(|setting, seeds: "SeedRuns"| -> "SeedRun[]" {
        let SeedRuns { seeds, generations } = SeedRuns::read(&Given::of(seeds))?;
        Ok(plain(&study::seed_runs(setting, seeds, generations)?))
    })
    "The method of the experiment with many seeds: at which drives the best J fell, and to what."
    trials as "trials"(|setting, trials: "Trials"| -> "Trial[]" {
        let Trials { seeds, drives } = Trials::read(&Given::of(trials))?;
        Ok(plain(&study::trials(setting, seeds, drives)?))
    })
}
