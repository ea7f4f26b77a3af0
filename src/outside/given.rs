//! What many calls are given.

use crate::run::{Experiment, Preset, Setting};
use crate::schema::{Allowed, Input, Place, Result, Source, refused};
use crate::search::LAST_GENERATION;
use crate::study::Evolution;

/// The given experiment, completed with the fields of the preset that it was made from, or else of the usual one; or the preset
/// of this name. Beside it, the preset.
pub fn setting<S: Source>(given: &S) -> Result<(Setting, Preset)> {
    match given.text() {
        Some(name) => named(Preset::find(&name)?),
        None => {
            let preset = usual(given);
            Ok((completed(preset, given)?, preset))
        }
    }
}

fn named(preset: Preset) -> Result<(Setting, Preset)> {
    Ok((Setting::new(preset.experiment())?, preset))
}

/// The experiment of a preset, or the given fields of one with every other field filled in. With both, in whichever order,
/// the preset is what fills in; without, the one that the fields were made from, or else `velocity-limits`. Beside it, what filled in.
pub fn experiment<S: Source>(given: &S, other: &S) -> Result<(Setting, Preset)> {
    let preset = preset(given, other)?;
    let fields = match given.text() {
        Some(_) if other.is_given() => other,
        Some(_) => return named(preset),
        None => given,
    };
    Ok((completed(preset, fields)?, preset))
}

fn preset<S: Source>(given: &S, other: &S) -> Result<Preset> {
    match given.text().or_else(|| other.text()) {
        Some(name) => Preset::find(&name),
        None if other.is_given() => Err(refused(other, Place::Named("preset"), Preset::expected())),
        None => Ok(usual(given)),
    }
}

/// The preset that the fields were made from, or else `velocity-limits`.
fn usual<S: Source>(given: &S) -> Preset {
    given.origin().and_then(Preset::named).unwrap_or(Preset::VelocityLimits)
}

/// The given fields of an experiment, with every other field filled in from this preset.
fn completed<S: Source>(preset: Preset, given: &S) -> Result<Setting> {
    let mut experiment: Experiment = preset.experiment();
    experiment.read(given)?;
    Setting::new(experiment)
}

/// A number that has a name.
pub fn number<S: Source>(given: &S, name: &str) -> Result<f64> {
    let mut number = 0.0;
    number.read(given, Place::Named(name), &Allowed::ANY)?;
    Ok(number)
}

/// The index of a start posture; 0 if it is left out.
pub fn start<S: Source>(setting: &Setting, given: &S) -> Result<u32> {
    whole(given, "start", setting.start_indices(), 0)
}

/// How many steps to take; one if it is left out.
pub fn steps<S: Source>(given: &S, name: &str) -> Result<u32> {
    whole(given, name, Allowed::whole(1, LAST_GENERATION), 1)
}

fn whole<S: Source>(given: &S, name: &str, allowed: Allowed, usual: u32) -> Result<u32> {
    if !given.is_given() {
        return Ok(usual);
    }
    let number = number(given, name)?;
    allowed.check(name, number)?;
    Ok(number as u32)
}

/// The number of a generation; the newest if it is left out.
pub fn generation<S: Source>(evolution: &Evolution, given: &S) -> Result<u32> {
    let newest = evolution.generation();
    if !given.is_given() {
        return Ok(newest);
    }
    let number = number(given, "generation")?;
    if Allowed::whole(0, newest).allows(number) {
        return Ok(number as u32);
    }
    Err(evolution.refused(number))
}
