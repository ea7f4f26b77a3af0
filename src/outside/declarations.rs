//! The types that JavaScript sees, told from the tables of the rooms.

use crate::run::{Cost, Experiment, PaperResult, Preset, Run, RunEnd, Sample};
use crate::schema::{Columns, Field, Plain, Types, WordField};
use crate::search::{GenerationRecord, Individual, LearningRates, Statistics};
use crate::study::{
    Circle, Grid, Landscape, PartsSample, RemainingError, SeedRun, SeedRuns, Stability, StartGrid,
    Trial, Trials,
};
use crate::theory::LawTerms;

/// `src/wasm/interface.d.ts`, as it must be: `tests/types.rs` writes it, and holds that it is so.
pub fn declarations() -> String {
    let mut types = Types::default();
    type Told = fn(&mut Types) -> String;
    const ALL: [Told; 25] = [
        Experiment::typescript,
        Preset::typescript,
        Run::typescript,
        Cost::typescript,
        Sample::typescript,
        Individual::typescript,
        Statistics::typescript,
        GenerationRecord::typescript,
        LearningRates::typescript,
        Landscape::typescript,
        Grid::typescript,
        LawTerms::typescript,
        StartGrid::typescript,
        Columns::<RunEnd>::typescript,
        SeedRuns::typescript,
        SeedRun::typescript,
        Trials::typescript,
        Trial::typescript,
        Stability::typescript,
        Columns::<PartsSample>::typescript,
        Columns::<RemainingError>::typescript,
        Circle::typescript,
        Field::typescript,
        WordField::typescript,
        PaperResult::typescript,
    ];
    for told in ALL {
        told(&mut types);
    }
    let mut text = String::from(
        "// Written by tests/types.rs from the tables in the Rust sources.\n\
         /// <reference lib=\"esnext.disposable\" />\n",
    );
    text.push_str(&types.declarations());
    text.push_str(PARTIAL);
    text
}

/// What may be given for an experiment; the only type that no value has.
const PARTIAL: &str = "\
/**
 * An experiment in which any field may be left out. The preset of which a spread copy was made fills it in, else
 * `velocity-limits`; with `experiment(partial, preset)` the one that is named. Starts may be their numbers side by side.
 */
export type PartialExperiment = {
  [K in keyof Experiment]?: K extends 'starts' ? readonly Partial<Posture>[] | Float64Array
    : Experiment[K] extends object ? {
      readonly [F in keyof Experiment[K]]?: Experiment[K][F] extends unknown[] ? Readonly<Experiment[K][F]> : Experiment[K][F];
    } : Experiment[K];
};
";
