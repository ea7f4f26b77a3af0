//! Where a value stands in a plain object. It is written out only when an error is told.

use core::fmt;

/// A path such as `starts[3].x`.
#[derive(Clone, Copy, Debug)]
pub enum Place<'a> {
    /// The experiment itself, whose fields are named without it.
    Experiment,
    /// Something that was given by this name.
    Named(&'a str),
    /// A field of what stands at a place.
    Field(&'a Place<'a>, &'a str),
    /// An element of what stands at a place.
    Element(&'a Place<'a>, usize),
}

impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Experiment => f.write_str("experiment"),
            Self::Named(name) | Self::Field(Place::Experiment, name) => f.write_str(name),
            Self::Field(record, name) => write!(f, "{record}.{name}"),
            Self::Element(list, index) => write!(f, "{list}[{index}]"),
        }
    }
}
