//! The allowed range of every number, and the error that says so.

use core::fmt;

use serde::Serialize;

use crate::control::Law;
use crate::disturbance::DisturbanceKind;
use crate::experiment::Experiment;

/// An input that was refused: which field, what it must be, and what it was.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InvalidInput {
    /// The field, named as in JavaScript.
    pub field: String,
    /// What it must be.
    pub expected: String,
    /// What it was.
    pub found: String,
}

impl InvalidInput {
    pub(crate) fn new(
        field: impl Into<String>,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Self {
        Self { field: field.into(), expected: expected.into(), found: found.into() }
    }
}

impl fmt::Display for InvalidInput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} must be {}, but was {}", self.field, self.expected, self.found)
    }
}

impl core::error::Error for InvalidInput {}

/// A number as JavaScript writes it, near enough for a message.
pub(crate) fn shown(number: f64) -> String {
    let magnitude = number.abs();
    if number.is_infinite() {
        return if number > 0.0 { "Infinity" } else { "-Infinity" }.into();
    }
    if magnitude >= 1e21 || (magnitude < 1e-6 && magnitude > 0.0) {
        return format!("{number:e}");
    }
    number.to_string()
}

/// The range of one number of an experiment.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Field {
    /// Where it stands in the plain object; `[]` means each element.
    pub path: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Smallest allowed value.
    pub min: f64,
    /// Largest allowed value.
    pub max: f64,
    /// Whether it must be a whole number.
    pub integer: bool,
    /// Whether it may be null, for "not limited".
    pub nullable: bool,
    #[serde(skip)]
    values: fn(&Experiment) -> Vec<Option<f64>>,
}

const fn field(
    path: &'static str,
    unit: &'static str,
    range: [f64; 2],
    values: fn(&Experiment) -> Vec<Option<f64>>,
) -> Field {
    Field { path, unit, min: range[0], max: range[1], integer: false, nullable: false, values }
}

impl Field {
    const fn integer(self) -> Self {
        Self { integer: true, ..self }
    }

    const fn nullable(self) -> Self {
        Self { nullable: true, ..self }
    }

    /// What the field must be, in words.
    pub fn expected(&self) -> String {
        let kind = if self.integer { "a whole number" } else { "a number" };
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        let null = if self.nullable { ", or null for no limit" } else { "" };
        format!("{kind} from {} to {}{unit}{null}", shown(self.min), shown(self.max))
    }

    /// All values of an experiment in this field, null as `None`.
    pub(crate) fn values(&self, experiment: &Experiment) -> Vec<Option<f64>> {
        (self.values)(experiment)
    }

    /// Whether a value is in the range, and whole where it must be; NaN never is.
    pub fn allows(&self, value: f64) -> bool {
        value >= self.min && value <= self.max && (!self.integer || value.fract() == 0.0)
    }
}

/// Coordinates beyond a kilometre lose the millimetres of a goal next to them, and no lesson needs them.
const METRES: [f64; 2] = [-1000.0, 1000.0];
const RADIANS: [f64; 2] = [-100.0, 100.0];
const SPEED: [f64; 2] = [-100.0, 100.0];
const LIMIT: [f64; 2] = [0.0, 1e6];
const WEIGHT: [f64; 2] = [0.0, 1e6];
const SEED: [f64; 2] = [0.0, u32::MAX as f64];

fn one(value: f64) -> Vec<Option<f64>> {
    vec![Some(value)]
}

fn all<'a>(values: impl IntoIterator<Item = &'a f64>) -> Vec<Option<f64>> {
    values.into_iter().map(|v| Some(*v)).collect()
}

/// Every number of an experiment with its range.
pub const FIELDS: [Field; 27] = [
    field("starts[].x", "m", METRES, |e| all(e.starts.iter().map(|p| &p.x))),
    field("starts[].y", "m", METRES, |e| all(e.starts.iter().map(|p| &p.y))),
    field("starts[].theta", "rad", RADIANS, |e| all(e.starts.iter().map(|p| &p.theta))),
    field("goal.x", "m", METRES, |e| one(e.goal.x)),
    field("goal.y", "m", METRES, |e| one(e.goal.y)),
    field("goal.theta", "rad", RADIANS, |e| one(e.goal.theta)),
    field("referenceVelocity.linear", "m/s", SPEED, |e| one(e.reference_velocity.linear)),
    field("referenceVelocity.angular", "rad/s", SPEED, |e| one(e.reference_velocity.angular)),
    field("sampleTime", "s", [1e-5, 10.0], |e| one(e.sample_time)),
    field("horizon", "s", [1e-5, 1e5], |e| one(e.horizon)),
    field("limits.speed", "m/s", LIMIT, |e| vec![e.limits.speed]).nullable(),
    field("limits.turnRate", "rad/s", LIMIT, |e| vec![e.limits.turn_rate]).nullable(),
    field("limits.acceleration", "m/s²", LIMIT, |e| vec![e.limits.acceleration]).nullable(),
    field("limits.turnAcceleration", "rad/s²", LIMIT, |e| vec![e.limits.turn_acceleration])
        .nullable(),
    field("tolerance.position", "m", [0.0, 1000.0], |e| one(e.tolerance.position)),
    field("tolerance.heading", "rad", [0.0, 100.0], |e| one(e.tolerance.heading)),
    field("weights.final[]", "", WEIGHT, |e| all(&e.weights.final_error)),
    field("weights.velocity[]", "", WEIGHT, |e| all(&e.weights.velocity)),
    field("weights.penalty", "", WEIGHT, |e| one(e.weights.penalty)),
    field("disturbance.linear", "m/s", SPEED, |e| one(e.disturbance.linear)),
    field("disturbance.angular", "rad/s", SPEED, |e| one(e.disturbance.angular)),
    field("disturbance.seed", "", SEED, |e| one(e.disturbance.seed.into())).integer(),
    field("evolution.population", "", [1.0, 2000.0], |e| one(e.evolution.population.into()))
        .integer(),
    field("evolution.opponents", "", [1.0, 1000.0], |e| one(e.evolution.opponents.into()))
        .integer(),
    field("evolution.seed", "", SEED, |e| one(e.evolution.seed.into())).integer(),
    field("evolution.initialRange[]", "", [-1e6, 1e6], |e| all(&e.evolution.initial_range)),
    field("evolution.initialSigma", "", [0.0, 1e6], |e| one(e.evolution.initial_sigma)),
];

/// A field that is one of a few words.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct WordField {
    /// Where it stands in the plain object.
    pub path: &'static str,
    /// The words that it may be.
    pub words: &'static [&'static str],
}

/// Every field of an experiment that is one of a few words.
pub const WORD_FIELDS: [WordField; 2] = [
    WordField { path: "law", words: Law::WORDS },
    WordField { path: "disturbance.kind", words: DisturbanceKind::WORDS },
];

/// The field with this path; an index in brackets stands for `[]`.
pub fn field_at(path: &str) -> Option<&'static Field> {
    let general: String = path.chars().filter(|c| !c.is_ascii_digit()).collect();
    FIELDS.iter().find(|field| field.path == general)
}
