//! J over two gains.

use super::part::{read_part, validate_part};
use super::starts::{MAX_AXIS_COUNT, Range};
use crate::robot::{Gains, Triples};
use crate::run::{Cost, Setting, Work};
use crate::schema::{
    Allowed, Fields, Input, InvalidInput, Place, Source, read_object, refused, shown, told, words,
};

words! {
    /// One of the three gains.
    pub enum Gain {
        /// kx
        X = "kx",
        /// ky
        Y = "ky",
        /// kθ
        Theta = "ktheta",
    }
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

/// kθ may be written with its letter.
impl Input for Gain {
    fn fields(_: &str, _: &Allowed, _: &mut Fields) {}

    fn check(&self, _: Place<'_>, _: &Allowed) -> Result<(), InvalidInput> {
        Ok(())
    }

    fn read<S: Source>(
        &mut self,
        given: &S,
        place: Place<'_>,
        _: &Allowed,
    ) -> Result<(), InvalidInput> {
        let word = given.text();
        let gain = match word.as_deref() {
            Some("kθ") => Some(Self::Theta),
            word => word.and_then(Self::named),
        };
        *self = gain.ok_or_else(|| refused(given, place, "'kx', 'ky' or 'ktheta'"))?;
        Ok(())
    }
}

/// `count` values of a gain, from `from` to `to`: evenly spaced, or with `log` evenly in the logarithm.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    pub log: bool,
}

told! {
    /// One axis of a landscape: `count` values of a gain from `from` to `to`, evenly spaced or, with `log`, evenly in the
    /// logarithm.
    Axis: Axis {
        /// Which gain.
        "gain" => |axis| axis.gain,
        /// The first value.
        "from" => |axis| axis.from,
        /// The last value.
        "to" => |axis| axis.to,
        /// How many values.
        "count" => |axis| axis.count,
        /// Whether they are spaced evenly in the logarithm.
        "log" optional => |axis| axis.log,
    }
}

impl Axis {
    /// The value with this index; with a count of 1 it is `from`.
    pub fn value(&self, index: u32) -> f64 {
        let Self { from, to, count, .. } = *self;
        if self.log {
            libm::exp(Range { from: libm::log(from), to: libm::log(to), count }.value(index))
        } else {
            Range { from, to, count }.value(index)
        }
    }

    fn validate(&self, name: &str) -> Result<(), InvalidInput> {
        let Self { from, to, count, .. } = *self;
        for (end, value) in [("from", from), ("to", to)] {
            if self.log && value.is_finite() && value <= 0.0 {
                let expected = "a number over 0 on a log axis";
                return Err(InvalidInput::new(format!("{name}.{end}"), expected, shown(value)));
            }
        }
        Range { from, to, count }.validate(name)
    }

    fn read<S: Source>(given: &S, place: Place<'_>) -> Result<Self, InvalidInput> {
        let mut axis = Self { gain: Gain::X, from: 0.0, to: 0.0, count: 0, log: false };
        read_object(given, place, &["gain", "from", "to", "count", "log"])?;
        let at = |name| Place::Field(&place, name);
        axis.gain.read(&given.field("gain"), at("gain"), &Allowed::ANY)?;
        axis.from.read(&given.field("from"), at("from"), &Allowed::ANY)?;
        axis.to.read(&given.field("to"), at("to"), &Allowed::ANY)?;
        let count = Allowed::whole(0, MAX_AXIS_COUNT);
        axis.count.read(&given.field("count"), at("count"), &count)?;
        axis.count.check(at("count"), &count)?;
        let log = given.field("log");
        if log.is_given() {
            axis.log.read(&log, at("log"), &Allowed::ANY)?;
        }
        Ok(axis)
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

told! {
    /// The cells of a landscape of J over two gains.
    Landscape: Landscape {
        /// The gain that varies within a row.
        "x" => |landscape| &landscape.x,
        /// The gain that varies from row to row.
        "y" => |landscape| &landscape.y,
        /// All three gains; the two on the axes are replaced.
        "gains" => |landscape| Triples::from(landscape.gains),
        /// The rows [first, end) to compute; all when left out.
        "rows" optional => |landscape| [0, landscape.y.count],
    }
}

impl Landscape {
    /// A landscape, and which of its rows are asked for.
    pub fn read<S: Source>(given: &S) -> Result<(Self, [u32; 2]), InvalidInput> {
        let place = Place::Named("landscape");
        read_object(given, place, &["x", "y", "gains", "rows"])?;
        let at = |name| Place::Field(&place, name);
        let [x, y] =
            [Axis::read(&given.field("x"), at("x"))?, Axis::read(&given.field("y"), at("y"))?];
        let gains = Gains::read_one(&given.field("gains"))?;
        let rows = read_part(&given.field("rows"), at("rows"), y.count)?;
        Ok((Self { x, y, gains }, rows))
    }

    /// J of the cells in rows [first, end), row by row. The error names the field that is wrong.
    pub fn costs(&self, setting: &Setting, rows: [u32; 2]) -> Result<Vec<f64>, InvalidInput> {
        self.x.validate("x")?;
        self.y.validate("y")?;
        if self.x.gain == self.y.gain {
            let found = format!("{} on both", ["x", "y", "theta"][self.y.gain as usize]);
            return Err(InvalidInput::new("y.gain", "another gain than x.gain", found));
        }
        let [first, end] = validate_part("rows", rows, self.y.count)?;
        let cells = f64::from(end - first) * f64::from(self.x.count);
        let starts = setting.experiment().starts.len();
        Work { field: "the number of cells", count: cells, starts, bytes: BYTES_OF_A_CELL }
            .check(setting.experiment())?;
        let gains_at = |row, column| {
            let mut gains = self.gains;
            self.x.gain.set(&mut gains, self.x.value(column));
            self.y.gain.set(&mut gains, self.y.value(row));
            gains
        };
        let cells = (first..end)
            .flat_map(|row| (0..self.x.count).map(move |column| gains_at(row, column)))
            .collect::<Vec<_>>();
        Ok(setting.totals(&cells))
    }
}

/// Its gains, and J in parts and as a sum.
const BYTES_OF_A_CELL: f64 = (size_of::<Gains>() + size_of::<Cost>() + size_of::<f64>()) as f64;
