//! The rows of `fields()`.

use super::allowed::Allowed;
use super::plain::{Plain, Writer};
use super::record::record;
use super::types::Types;

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

impl Plain for Field {
    fn typescript(types: &mut Types) -> String {
        let kinds = [NumberField::typescript(types), WordField::typescript(types)].join(" | ");
        let about = "One field of an experiment: a word if `'words' in field`, else a number.";
        types.alias("Field", &[about], &kinds)
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        match self {
            Self::Number(field) => field.write(to),
            Self::Word(field) => field.write(to),
        }
    }
}
