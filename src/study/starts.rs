//! Sets of start postures: to train on, to test on, to map.

use core::f64::consts::TAU;

use rand::RngExt;

use super::part::{read_part, validate_part};
use crate::number::{Purpose, Real, stream, wrap};
use crate::robot::{Gains, METRES, Posture, Triples};
use crate::run::MAX_STARTS;
use crate::schema::{
    Allowed, Input, InvalidInput, Place, Plain, Result, Source, read_object, read_whole, record,
    told,
};

record! { required (Copy)
    /// Where start postures stand on a circle: its centre and radius in metres.
    pub struct Circle {
        /// x of the centre.
        pub x: f64 => "x" in METRES,
        /// y of the centre.
        pub y: f64 => "y" in METRES,
        /// How far they are from it.
        pub radius: f64 => "radius" in Allowed::within("m", 0.0, METRES.max),
        /// How many: 1 to 10 000.
        pub count: u32 => "count" in Allowed::whole(1, MAX_STARTS),
        /// The seed of their headings.
        pub seed: u32 => "seed" in Allowed::SEED,
    }
}

impl Circle {
    const PLACE: Place<'static> = Place::Named("circle");

    /// A circle.
    pub fn read<S: Source>(given: &S) -> Result<Self> {
        let none = Self { x: 0.0, y: 0.0, radius: 0.0, count: 0, seed: 0 };
        read_whole(none, given, Self::PLACE, &Allowed::ANY)
    }

    /// Postures evenly on the circle, each with a random heading. The error names the field that is wrong.
    pub fn starts(&self) -> Result<Vec<Posture>> {
        self.check(Self::PLACE, &Allowed::ANY)?;
        let Self { x, y, radius, count, seed } = *self;
        let mut rng = stream(seed, Purpose::Starts, 0);
        let posture = |i| {
            let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(count));
            let theta = wrap(TAU * rng.random::<f64>());
            Posture { x: x + radius * cos, y: y + radius * sin, theta }
        };
        Ok((0..count).map(posture).collect())
    }
}

record! { required (Copy)
    /// `count` values from `from` to `to`, evenly spaced.
    pub struct Range {
        /// The first value.
        pub from: f64 => "from",
        /// The last value.
        pub to: f64 => "to",
        /// How many: 1 to 1024.
        pub count: u32 => "count" in AXIS_COUNT,
    }
}

impl Range {
    /// The value with this index; with a count of 1 it is `from`.
    pub fn value(&self, index: u32) -> f64 {
        let Self { from, to, count } = *self;
        let t = f64::from(index) / f64::from(count.saturating_sub(1).max(1));
        // Rounding may leave it just outside, also where both ends are the same.
        (from * (1.0 - t) + to * t).at_least(from.at_most(to)).at_most(from.at_least(to))
    }

    pub(crate) fn validate(&self, name: &str) -> Result<()> {
        for (end, value) in [("from", self.from), ("to", self.to)] {
            if !value.is_finite() {
                return Err(InvalidInput::new(format!("{name}.{end}"), "a finite number", value));
            }
        }
        AXIS_COUNT.check(format!("{name}.count"), self.count.into())
    }
}

/// Most values on one axis of a grid or a landscape.
pub const MAX_AXIS_COUNT: u32 = 1024;

pub(crate) const AXIS_COUNT: Allowed = Allowed::whole(1, MAX_AXIS_COUNT);

/// Start postures at every position of a grid, each with several headings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// x in metres.
    pub x: Range,
    /// y in metres.
    pub y: Range,
    /// How many headings, evenly around the circle from 0.
    pub headings: u32,
}

told! {
    /// Start postures at every position of a grid, with `headings` headings each, evenly around the circle from 0.
    Grid: Grid {
        /// Metres.
        "x" => |grid| &grid.x,
        /// Metres.
        "y" => |grid| &grid.y,
        /// How many headings at each position: 1 to 1024.
        "headings" => |grid| grid.headings,
        /// The starts [first, end) to take, at most 10 000 in one call; all when left out. All headings of a position stand together, then x varies, then y.
        "part" [optional] => |grid| [0, grid.most()],
    }
}

impl Grid {
    const PLACE: Place<'static> = Place::Named("grid");

    /// A grid, and which of its starts [first, end) are asked for.
    pub fn read<S: Source>(given: &S) -> Result<(Self, [u32; 2])> {
        read_object(given, Self::PLACE, Self::KEYS)?;
        Self::read_fields(given)
    }

    fn read_fields<S: Source>(given: &S) -> Result<(Self, [u32; 2])> {
        let at = |name| Place::Field(&Self::PLACE, name);
        let none = Range { from: 0.0, to: 0.0, count: 0 };
        let range = |name| read_whole(none, &given.field(name), at(name), &Allowed::ANY);
        let [x, y] = [range("x")?, range("y")?];
        let headings = read_whole(0, &given.field("headings"), at("headings"), &AXIS_COUNT)?;
        let grid = Self { x, y, headings };
        let part = read_part(&given.field("part"), at("part"), grid.most())?;
        Ok((grid, part))
    }

    /// How many postures there are.
    pub fn count(&self) -> u64 {
        let positions = u64::from(self.x.count) * u64::from(self.y.count);
        positions.saturating_mul(self.headings.into())
    }

    /// The same where it is small enough to be numbered.
    pub(crate) fn most(&self) -> u32 {
        u32::try_from(self.count()).unwrap_or(u32::MAX)
    }

    /// The posture with this index: all headings of the first position, then the next position in x, then the next in y.
    pub fn posture(&self, index: u32) -> Posture {
        // A grid without columns or headings has no postures; whoever asks all the same is told where they would begin.
        let [headings, columns] = [self.headings.max(1), self.x.count.max(1)];
        let (heading, position) = (index % headings, index / headings);
        Posture {
            x: self.x.value(position % columns),
            y: self.y.value(position / columns),
            theta: wrap(TAU * f64::from(heading) / f64::from(headings)),
        }
    }

    /// The postures with index in [first, end); the error says how many are allowed.
    pub fn starts(&self, part: [u32; 2]) -> Result<Vec<Posture>> {
        self.validate()?;
        let [first, end] = validate_part("grid.part", part, self.most())?;
        if end - first > MAX_STARTS {
            let expected = format!("at most {MAX_STARTS} starts in one call");
            return Err(InvalidInput::new("grid.part", expected, end - first));
        }
        Ok((first..end).map(|index| self.posture(index)).collect())
    }

    pub(crate) fn validate(&self) -> Result<()> {
        for (name, range) in [("grid.x", self.x), ("grid.y", self.y)] {
            range.validate(name)?;
            for (end, value) in [("from", range.from), ("to", range.to)] {
                METRES.check(format!("{name}.{end}"), value)?;
            }
        }
        AXIS_COUNT.check("grid.headings", self.headings.into())
    }
}

/// A robot, and the grid from whose starts it drives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StartGrid {
    /// Its gains.
    pub gains: Gains,
    /// Where it starts.
    pub grid: Grid,
}

told! {
    /// The starts of a grid, and the gains of the robot that drives from them.
    StartGrid: StartGrid {
        /// The gains of the robot.
        "gains" => |given| Triples::from(given.gains),
        /// Metres.
        "x" => |given| &given.grid.x,
        /// Metres.
        "y" => |given| &given.grid.y,
        /// How many headings at each position: 1 to 1024.
        "headings" => |given| given.grid.headings,
        /// The starts [first, end) to drive from; all when left out, in the order of `Grid`.
        "part" [optional] => |given| [0, given.grid.most()],
    }
}

impl StartGrid {
    /// A robot with its grid, and from which of the starts [first, end) it is to drive.
    pub fn read<S: Source>(given: &S) -> Result<(Self, [u32; 2])> {
        read_object(given, Grid::PLACE, Self::KEYS)?;
        let gains = Gains::read_one(&given.field("gains"))?;
        let (grid, part) = Grid::read_fields(given)?;
        Ok((Self { gains, grid }, part))
    }
}
