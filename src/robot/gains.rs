//! The gains that are looked for.

use crate::number::Real;
use crate::schema::{
    Allowed, InvalidInput, Place, Plain, Result, Source, Types, Writer, refused, too_many,
};

/// The three gains k = (kx, ky, kθ) that evolution looks for, in the units of the paper's law (5), for which Theorem 1 holds
/// if they are positive. In Kanayama's rule kx in 1/s is on the distance ahead, ky in rad/m² on that aside, both seen from the
/// robot, and kθ in rad/m on sin θ_e. In ω of (5) the terms of kx and ky are divided by the weight of the heading in V, 1 m²: the
/// same numbers for other units of length would be another law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains<S = f64> {
    /// kx in 1/s, on x_e.
    pub x: S,
    /// ky in 1/(m² s), on y_e³.
    pub y: S,
    /// kθ in rad/s, on sin θ_e.
    pub theta: S,
}

impl Gains {
    /// Gains from kx, ky and kθ.
    pub const fn new(x: f64, y: f64, theta: f64) -> Self {
        Self { x, y, theta }
    }

    /// kx, ky and kθ.
    pub const fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.theta]
    }

    /// The same gains in every lane.
    pub(crate) fn splat<S: Real>(&self) -> Gains<S> {
        Gains { x: S::splat(self.x), y: S::splat(self.y), theta: S::splat(self.theta) }
    }

    /// Triples (kx, ky, kθ) one after the other, as many as are given.
    pub fn read_all<S: Source>(given: &S) -> Result<Vec<Self>> {
        let numbers = read_numbers(given)?;
        if !numbers.len().is_multiple_of(3) {
            let found = format!("{} numbers", numbers.len());
            return Err(InvalidInput::new("gains", "three numbers for each robot", found));
        }
        if let Some(index) = numbers.iter().position(|k| !k.is_finite()) {
            let name = gain_name(index);
            return Err(InvalidInput::new(name, "a finite number", numbers[index]));
        }
        Ok(numbers.chunks_exact(3).map(|k| Self::new(k[0], k[1], k[2])).collect())
    }

    /// One triple.
    pub fn read_one<S: Source>(given: &S) -> Result<Self> {
        match Self::read_all(given)?[..] {
            [gains] => Ok(gains),
            ref several => {
                let found = format!("{} numbers", 3 * several.len());
                Err(InvalidInput::new("gains", "three numbers (kx, ky, kθ)", found))
            }
        }
    }
}

impl From<[f64; 3]> for Gains {
    fn from([x, y, theta]: [f64; 3]) -> Self {
        Self::new(x, y, theta)
    }
}

/// Most gain triples in one call: what they take of the memory stays taken.
const MAX_TRIPLES: usize = 1_000_000;

/// kx, ky or kθ, and of which robot if it is not the first.
fn gain_name(index: usize) -> String {
    let name = ["kx", "ky", "kθ"][index % 3];
    if index < 3 { name.into() } else { format!("{name} (gains[{index}])") }
}

fn read_numbers<S: Source>(given: &S) -> Result<Vec<f64>> {
    const MOST: usize = 3 * MAX_TRIPLES;
    let place = Place::Named("gains");
    if let Some(numbers) = given.column(place, MOST)? {
        return Ok(numbers);
    }
    let Some(count) = given.length(true) else {
        return Err(refused(given, place, "a Float64Array or an array of numbers"));
    };
    if count > MOST {
        return Err(too_many(place, MOST, count));
    }
    let number = |i| {
        let element = given.element(i);
        let wrong = || refused(&element, Place::Named(&gain_name(i)), Allowed::ANY.expected());
        element.number().ok_or_else(wrong)
    };
    (0..count).map(number).collect()
}

impl Plain for Gains {
    fn typescript(_: &mut Types) -> String {
        "[number, number, number]".into()
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        self.to_array().write(to)
    }
}

/// Gains as they are given: triples one after the other.
#[derive(Clone, Debug)]
pub(crate) struct Triples(pub(crate) Vec<f64>);

impl From<Gains> for Triples {
    fn from(gains: Gains) -> Self {
        Self(gains.to_array().into())
    }
}

impl Plain for Triples {
    fn typescript(types: &mut Types) -> String {
        let about = "Three gains (kx, ky, kθ), or such triples one after the other: at most a million in one call, fewer where drives are long.";
        types.alias("Gains", &[about], "Float64Array | readonly number[]")
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        to.column(&self.0)
    }
}
