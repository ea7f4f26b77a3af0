//! Which numbers a field may be, and the error that says so.

use core::fmt;
use core::ops::Deref;

use super::text::Text;

/// An input that was refused. It is small, for most readings have none.
#[derive(Clone, PartialEq)]
pub struct InvalidInput(Box<Refusal>);

/// What comes of given values, or why they were refused.
pub type Result<T, E = InvalidInput> = core::result::Result<T, E>;

/// Which field was refused, what it must be, and what it was.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// The field, by the name that it has outside.
    pub field: String,
    /// What it must be.
    pub expected: Text,
    /// What it was.
    pub found: Text,
}

impl InvalidInput {
    /// What a source of one's own says where it refuses ([`Source::column`](super::Source::column)).
    pub fn new(
        field: impl Into<String>,
        expected: impl Into<Text>,
        found: impl Into<Text>,
    ) -> Self {
        Self::of(field.into(), expected.into(), found.into())
    }

    // Once, not for each kind of text.
    #[inline(never)]
    fn of(field: String, expected: Text, found: Text) -> Self {
        Self(Box::new(Refusal { field, expected, found }))
    }

    /// The message.
    pub fn message(&self) -> Text {
        let Refusal { field, expected, found } = (**self).clone();
        Text::from(field) + " must be " + expected + ", but was " + found
    }
}

impl Deref for InvalidInput {
    type Target = Refusal;

    fn deref(&self) -> &Refusal {
        &self.0
    }
}

impl fmt::Display for InvalidInput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

/// The sentence, for it is what a program that ends with the error shows.
impl fmt::Debug for InvalidInput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl core::error::Error for InvalidInput {}

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
    /// Any number, also one that is not finite: whoever computes with it says what it must be.
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

    /// Whether a value is among them, and whole where it must be; NaN is in [`Self::ANY`] alone.
    pub fn allows(&self, value: f64) -> bool {
        let within = value >= self.min && value <= self.max;
        *self == Self::ANY || (within && (!self.integer || value.fract() == 0.0))
    }

    /// What such a number must be, in words.
    pub fn expected(&self) -> Text {
        let kind = if self.integer { "a whole number" } else { "a number" };
        if *self == Self::ANY {
            return kind.into();
        }
        let space = if self.unit.is_empty() { "" } else { " " };
        let null = if self.nullable { ", or null for no limit" } else { "" };
        Text::from(kind) + " from " + self.min + " to " + self.max + space + self.unit + null
    }

    /// Refuses a number that is not among them.
    pub(crate) fn check(&self, name: impl fmt::Display, value: f64) -> Result<()> {
        if self.allows(value) {
            return Ok(());
        }
        Err(InvalidInput::new(name.to_string(), self.expected(), value))
    }
}
