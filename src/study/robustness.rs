//! How one robot fares from many starts.

use super::part::validate_part;
use super::starts::Grid;
use crate::number::LARGEST_INDEX;
use crate::robot::Gains;
use crate::run::{Departure, RunEnd, Setting, check_bytes};
use crate::schema::Result;

/// How a run ended, and what is told of it.
const BYTES_OF_A_START: f64 = (size_of::<RunEnd>() + 2 * size_of::<f64>() + 1) as f64;

/// How the robot with these gains fares from each posture of the grid with index in [first, end).
///
/// The start postures of the experiment do not matter. The error names the field that is wrong.
pub fn robustness(
    setting: &Setting,
    gains: Gains,
    grid: &Grid,
    part: [u32; 2],
) -> Result<Vec<RunEnd>> {
    grid.validate()?;
    let [first, end] = validate_part("grid.part", part, grid.most())?;
    let (what, count) = ("the number of starts", f64::from(end - first));
    setting.experiment().check_drives(what, count, 1)?;
    check_bytes(what, count, BYTES_OF_A_START)?;
    Ok(setting.drive((end - first) as usize, &|i| {
        let index = first + i as u32;
        // A start beyond the streams shares one with another; their disturbances stay in the bounds.
        Departure { gains, start: grid.posture(index), stream: index % (LARGEST_INDEX + 1) }
    }))
}

/// How the robot with these gains fares from each start posture of the experiment, in their order.
///
/// Their costs' mean is what [`Setting::evaluate`] gives for these gains.
pub fn fares(setting: &Setting, gains: Gains) -> Vec<RunEnd> {
    let starts = &setting.experiment().starts;
    let departure = |i: usize| Departure { gains, start: starts[i], stream: i as u32 };
    setting.drive(starts.len(), &departure)
}
