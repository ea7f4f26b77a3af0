//! Many gains in one call: costs of a list, and the landscape of J over two gains.

use serde::{Deserialize, Serialize};

use crate::control::Gains;
use crate::cost::Cost;
use crate::episode::Setting;
use crate::experiment::{InvalidInput, shown};

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

/// Most values on one axis of a landscape.
pub const MAX_AXIS_COUNT: u32 = 1024;

impl Axis {
    /// The value with this index; with a count of 1 it is `from`.
    pub fn value(&self, index: u32) -> f64 {
        let last = f64::from(self.count.saturating_sub(1).max(1));
        let t = f64::from(index) / last;
        if self.log {
            libm::exp(libm::log(self.from) * (1.0 - t) + libm::log(self.to) * t)
        } else {
            self.from * (1.0 - t) + self.to * t
        }
    }

    fn validate(&self, name: &str) -> Result<(), InvalidInput> {
        for (end, value) in [("from", self.from), ("to", self.to)] {
            let (allowed, expected) = if self.log {
                (value > 0.0 && value.is_finite(), "a number over 0 on a log axis")
            } else {
                (value.is_finite(), "a finite number")
            };
            if !allowed {
                return Err(InvalidInput::new(format!("{name}.{end}"), expected, shown(value)));
            }
        }
        if !(1..=MAX_AXIS_COUNT).contains(&self.count) {
            let expected = format!("a whole number from 1 to {MAX_AXIS_COUNT}");
            return Err(InvalidInput::new(
                format!("{name}.count"),
                expected,
                self.count.to_string(),
            ));
        }
        Ok(())
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
    /// J of the cells in rows [first, end), row by row.
    ///
    /// Any split into rows gives the same numbers. The error names the field that is wrong.
    pub fn costs(&self, setting: &Setting, rows: [u32; 2]) -> Result<Vec<f64>, InvalidInput> {
        self.x.validate("x")?;
        self.y.validate("y")?;
        if self.x.gain == self.y.gain {
            let found = format!("{:?} on both", self.y.gain).to_lowercase();
            return Err(InvalidInput::new("y.gain", "another gain than x.gain", found));
        }
        let [first, end] = rows;
        if first > end || end > self.y.count {
            let expected = format!("[first, end] with 0 ≤ first ≤ end ≤ {}", self.y.count);
            return Err(InvalidInput::new("rows", expected, format!("[{first}, {end}]")));
        }
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
