//! J over two gains.

use super::part::{read_part, validate_part};
use super::starts::{AXIS_COUNT, Range};
use crate::number::Real;
use crate::robot::{Gains, Triples};
use crate::run::Setting;
use crate::schema::{
    Allowed, Input, InvalidInput, Place, Plain, Result, Source, read_object, read_whole, record,
    refused, told, unranged, words,
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
    unranged!();

    fn read<S: Source>(&mut self, given: &S, place: Place<'_>, _: &Allowed) -> Result<()> {
        let word = given.text();
        let gain = match word.as_deref() {
            Some("kθ") => Some(Self::Theta),
            word => word.and_then(Self::named),
        };
        *self = gain.ok_or_else(|| refused(given, place, "'kx', 'ky' or 'ktheta'"))?;
        Ok(())
    }
}

record! { required (Copy)
    /// One axis of a landscape: `count` values of a gain from `from` to `to`, evenly spaced or, with `log`, evenly in the
    /// logarithm.
    pub struct Axis {
        /// Which gain.
        pub gain: Gain => "gain",
        /// The first value.
        pub from: f64 => "from",
        /// The last value.
        pub to: f64 => "to",
        /// How many values: 1 to 1024.
        pub count: u32 => "count" in AXIS_COUNT,
        /// Whether they are spaced evenly in the logarithm.
        pub log: bool => "log" [optional],
    }
}

impl Axis {
    /// The value with this index; with a count of 1 it is `from`.
    pub fn value(&self, index: u32) -> f64 {
        let Self { from, to, count, .. } = *self;
        let is_end = index == 0 || index + 1 >= count || from == to;
        // An end is the number that was asked for, which the logarithm would round.
        if !self.log || is_end {
            return Range { from, to, count }.value(index);
        }
        let value =
            libm::exp(Range { from: libm::log(from), to: libm::log(to), count }.value(index));
        // Where the ends are close, rounding would lead out of them.
        value.at_least(from.at_most(to)).at_most(from.at_least(to))
    }

    fn validate(&self, name: &str) -> Result<()> {
        let Self { from, to, count, .. } = *self;
        for (end, value) in [("from", from), ("to", to)] {
            if self.log && value.is_finite() && value <= 0.0 {
                let expected = "a number over 0 on a log axis";
                return Err(InvalidInput::new(format!("{name}.{end}"), expected, value));
            }
        }
        Range { from, to, count }.validate(name)
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
        "rows" [optional] => |landscape| [0, landscape.y.count],
    }
}

impl Landscape {
    /// A landscape, and which of its rows are asked for.
    pub fn read<S: Source>(given: &S) -> Result<(Self, [u32; 2])> {
        let place = Place::Named("landscape");
        read_object(given, place, Self::KEYS)?;
        let at = |name| Place::Field(&place, name);
        let none = Axis { gain: Gain::X, from: 0.0, to: 0.0, count: 0, log: false };
        let axis = |name| read_whole(none, &given.field(name), at(name), &Allowed::ANY);
        let [x, y] = [axis("x")?, axis("y")?];
        let gains = Gains::read_one(&given.field("gains"))?;
        let rows = read_part(&given.field("rows"), at("rows"), y.count)?;
        Ok((Self { x, y, gains }, rows))
    }

    /// J of the cells in rows [first, end), row by row. The error names the field that is wrong.
    pub fn costs(&self, setting: &Setting, rows: [u32; 2]) -> Result<Vec<f64>> {
        self.x.validate("landscape.x")?;
        self.y.validate("landscape.y")?;
        if self.x.gain == self.y.gain {
            let found = format!("{} on both", self.y.gain.word());
            return Err(InvalidInput::new("landscape.y.gain", "another gain than x.gain", found));
        }
        let [first, end] = validate_part("landscape.rows", rows, self.y.count)?;
        let cells = f64::from(end - first) * f64::from(self.x.count);
        // The most cells that two axes have take a third of the memory that there may be.
        let experiment = setting.experiment();
        experiment.check_drives("the number of cells", cells, experiment.starts.len())?;
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
