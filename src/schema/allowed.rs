//! Which numbers and words a field may be, and the error that says so.

use core::fmt;

use super::record::record;

/// An input that was refused: which field, what it must be, and what it was.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InvalidInput {
    /// The field, by the name that it has outside.
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

/// A number as a message shows it: very large and very small ones with an exponent.
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

/// Which numbers a field may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allowed {
    /// Their unit; empty for a pure number.
    pub unit: &'static str,
    /// Smallest allowed value.
    pub min: f64,
    /// Largest allowed value.
    pub max: f64,
    /// Whether it must be a whole number.
    pub integer: bool,
    /// Whether it may be null, for "not limited".
    pub nullable: bool,
}

impl Allowed {
    /// Any number.
    pub const ANY: Self = Self::within("", f64::NEG_INFINITY, f64::INFINITY);
    /// Any seed of a stream of random numbers.
    pub const SEED: Self = Self::whole(0, u32::MAX);

    /// Numbers from `min` to `max`.
    pub const fn within(unit: &'static str, min: f64, max: f64) -> Self {
        Self { unit, min, max, integer: false, nullable: false }
    }

    /// Whole numbers from `min` to `max`.
    pub const fn whole(min: u32, max: u32) -> Self {
        Self { integer: true, ..Self::within("", min as f64, max as f64) }
    }

    /// These, or null for "not limited".
    pub const fn or_null(self) -> Self {
        Self { nullable: true, ..self }
    }

    /// Whether a value is among them, and whole where it must be; NaN never is.
    pub fn allows(&self, value: f64) -> bool {
        value >= self.min && value <= self.max && (!self.integer || value.fract() == 0.0)
    }

    /// What such a number must be, in words.
    pub fn expected(&self) -> String {
        if *self == Self::ANY {
            return "a number".into();
        }
        let kind = if self.integer { "a whole number" } else { "a number" };
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        let null = if self.nullable { ", or null for no limit" } else { "" };
        format!("{kind} from {} to {}{unit}{null}", shown(self.min), shown(self.max))
    }

    /// Refuses a number that is not among them.
    pub(crate) fn check(&self, name: &str, value: f64) -> Result<(), InvalidInput> {
        if self.allows(value) {
            return Ok(());
        }
        Err(InvalidInput::new(name, self.expected(), shown(value)))
    }
}

record! {
    /// The range of one numeric field of an experiment.
    pub struct NumberField {
        /// Where it stands in the experiment; `[]` means each element.
        pub path: String => "path",
        /// Empty for a pure number.
        pub unit: &'static str => "unit",
        /// Smallest allowed value.
        pub min: f64 => "min",
        /// Largest allowed value.
        pub max: f64 => "max",
        /// Whether it must be a whole number.
        pub integer: bool => "integer",
        /// Whether it may be null, for "not limited".
        pub nullable: bool => "nullable",
    }
}

impl NumberField {
    /// Which numbers it may be.
    pub fn allowed(&self) -> Allowed {
        let Self { unit, min, max, integer, nullable, .. } = *self;
        Allowed { unit, min, max, integer, nullable }
    }
}

record! {
    /// A field of an experiment that is one of a few words.
    pub struct WordField {
        /// Where it stands in the experiment.
        pub path: String => "path",
        /// Always empty: a word has none.
        pub unit: &'static str => "unit",
        /// What it may be.
        pub words: &'static [&'static str] => "words",
    }
}

/// One field of an experiment.
#[derive(Clone, Debug, PartialEq)]
pub enum Field {
    /// A number, or each number of a list.
    Number(NumberField),
    /// One of a few words.
    Word(WordField),
}

impl Field {
    /// Where it stands in the experiment; `[]` means each element.
    pub fn path(&self) -> &str {
        match self {
            Self::Number(field) => &field.path,
            Self::Word(field) => &field.path,
        }
    }
}

impl super::Plain for Field {
    fn typescript(types: &mut super::Types) -> String {
        let kinds = [NumberField::typescript(types), WordField::typescript(types)].join(" | ");
        let about = "One field of an experiment: a word if `'words' in field`, else a number.";
        types.alias("Field", &[about], &kinds)
    }

    fn write<W: super::Writer>(&self, to: &W) -> W::Value {
        match self {
            Self::Number(field) => field.write(to),
            Self::Word(field) => field.write(to),
        }
    }
}
