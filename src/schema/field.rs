//! The rows of `fields()` and `wordFields()`.

use serde::Serialize;

use super::allowed::Allowed;
use super::record::record;

record! {
    (Serialize)
    /// The range of one numeric field of an experiment.
    pub struct Field {
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

impl Field {
    /// Which numbers it may be.
    pub fn allowed(&self) -> Allowed {
        let Self { unit, min, max, integer, nullable, .. } = *self;
        Allowed { unit, min, max, integer, nullable }
    }
}

record! {
    (Serialize)
    /// A field of an experiment that is one of a few words.
    pub struct WordField {
        /// Where it stands in the experiment.
        pub path: String => "path",
        /// What it may be.
        pub words: &'static [&'static str] => "words",
    }
}

/// The rows for a plain object, each kind in its order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fields {
    /// Every number, or each number of a list.
    pub numbers: Vec<Field>,
    /// Every word.
    pub words: Vec<WordField>,
}
