//! Sets of start postures: to train on, to test on, to map.

use core::f64::consts::TAU;

use rand::RngExt;
use serde::{Deserialize, Serialize};

use crate::experiment::MAX_STARTS;
use crate::fields::{InvalidInput, field_at, shown};
use crate::posture::{Posture, wrap};
use crate::random::{Purpose, stream};

/// `count` postures evenly on a circle around `centre`, each with a random heading.
///
/// The radius is in metres. The error says how many postures are allowed.
pub fn on_circle(
    centre: Posture,
    radius: f64,
    count: u32,
    seed: u32,
) -> Result<Vec<Posture>, InvalidInput> {
    for (name, value) in [("x", centre.x), ("y", centre.y), ("radius", radius)] {
        validate_coordinate(name, value)?;
    }
    if count == 0 || count as usize > MAX_STARTS {
        let expected = format!("a whole number from 1 to {MAX_STARTS}");
        return Err(InvalidInput::new("count", expected, count.to_string()));
    }
    let mut rng = stream(seed, Purpose::Starts, 0);
    let posture = |i| {
        let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(count));
        Posture {
            x: centre.x + radius * cos,
            y: centre.y + radius * sin,
            theta: wrap(TAU * rng.random::<f64>()),
        }
    };
    Ok((0..count).map(posture).collect())
}

/// `count` values from `from` to `to`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Range {
    /// The first value.
    pub from: f64,
    /// The last value.
    pub to: f64,
    /// How many.
    pub count: u32,
}

impl Range {
    /// The value with this index; with a count of 1 it is `from`.
    pub fn value(&self, index: u32) -> f64 {
        let t = f64::from(index) / f64::from(self.count.saturating_sub(1).max(1));
        self.from * (1.0 - t) + self.to * t
    }

    pub(crate) fn validate(&self, name: &str) -> Result<(), InvalidInput> {
        for (end, value) in [("from", self.from), ("to", self.to)] {
            if !value.is_finite() {
                let found = shown(value);
                return Err(InvalidInput::new(format!("{name}.{end}"), "a finite number", found));
            }
        }
        validate_count(&format!("{name}.count"), self.count)
    }
}

/// Most values on one axis of a grid or a landscape.
pub const MAX_AXIS_COUNT: u32 = 1024;

fn validate_count(field: &str, count: u32) -> Result<(), InvalidInput> {
    if (1..=MAX_AXIS_COUNT).contains(&count) {
        return Ok(());
    }
    let expected = format!("a whole number from 1 to {MAX_AXIS_COUNT}");
    Err(InvalidInput::new(field, expected, count.to_string()))
}

/// Checks a part [first, end) of a job that has `count` parts.
pub(crate) fn validate_part(
    field: &str,
    part: [u32; 2],
    count: u32,
) -> Result<[u32; 2], InvalidInput> {
    let [first, end] = part;
    if first <= end && end <= count {
        return Ok(part);
    }
    let expected = format!("[first, end] with 0 ≤ first ≤ end ≤ {count}");
    Err(InvalidInput::new(field, expected, format!("[{first}, {end}]")))
}

/// Start postures have the range of those of an experiment.
fn validate_coordinate(name: &str, value: f64) -> Result<(), InvalidInput> {
    match field_at("starts[].x") {
        Some(field) if !field.allows(value) => {
            Err(InvalidInput::new(name, field.expected(), shown(value)))
        }
        _ => Ok(()),
    }
}

/// Positions on a grid, each with several headings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StartGrid {
    /// x in metres.
    pub x: Range,
    /// y in metres.
    pub y: Range,
    /// How many headings, evenly around the circle from 0.
    pub headings: u32,
}

impl StartGrid {
    /// How many postures there are.
    pub fn count(&self) -> usize {
        self.x.count as usize * self.y.count as usize * self.headings as usize
    }

    /// The posture with this index: all headings of the first position, then the next position in x, then the next in y.
    pub fn posture(&self, index: usize) -> Posture {
        let heading = (index % self.headings as usize) as u32;
        let position = index / self.headings as usize;
        let (column, row) =
            ((position % self.x.count as usize) as u32, (position / self.x.count as usize) as u32);
        Posture {
            x: self.x.value(column),
            y: self.y.value(row),
            theta: wrap(TAU * f64::from(heading) / f64::from(self.headings)),
        }
    }

    /// The postures with index in [first, end); the error says how many are allowed.
    pub fn postures(&self, part: [u32; 2]) -> Result<Vec<Posture>, InvalidInput> {
        self.validate()?;
        let count = u32::try_from(self.count()).unwrap_or(u32::MAX);
        let [first, end] = validate_part("part", part, count)?;
        if (end - first) as usize > MAX_STARTS {
            let expected = format!("at most {MAX_STARTS} starts in one call");
            return Err(InvalidInput::new("part", expected, (end - first).to_string()));
        }
        Ok((first..end).map(|index| self.posture(index as usize)).collect())
    }

    pub(crate) fn validate(&self) -> Result<(), InvalidInput> {
        for (name, range) in [("x", self.x), ("y", self.y)] {
            range.validate(name)?;
            for (end, value) in [("from", range.from), ("to", range.to)] {
                if let Some(field) = field_at("starts[].x").filter(|field| !field.allows(value)) {
                    let found = shown(value);
                    return Err(InvalidInput::new(
                        format!("{name}.{end}"),
                        field.expected(),
                        found,
                    ));
                }
            }
        }
        validate_count("headings", self.headings)
    }
}
