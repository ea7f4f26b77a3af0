//! Whatever is read: plain values that somebody gave.

use super::allowed::{InvalidInput, Result};
use super::place::Place;
use super::text::Text;

/// A plain value that somebody gave.
pub trait Source: Sized {
    /// What it is, as far as that is seen at once.
    fn kind(&self) -> Kind;
    /// The numbers that it is, side by side; refused if they are more than allowed.
    fn column(&self, place: Place<'_>, most: usize) -> Result<Option<Vec<f64>>>;
    /// How many elements it has, if it is a list; also one of numbers side by side, if those may be.
    fn length(&self, columns: bool) -> Option<usize>;
    /// The element with this index.
    fn element(&self, index: usize) -> Self;
    /// Whether it is an object with no fields but these.
    fn keys(&self, known: &[&'static str]) -> Keys;
    /// The field with this name; where there is none, what is of the kind [`Kind::Missing`].
    fn field(&self, name: &'static str) -> Self;

    /// The name of what it was made from, where that is remembered.
    fn origin(&self) -> Option<&'static str> {
        None
    }

    /// Whether it is there at all.
    fn is_given(&self) -> bool {
        self.kind() != Kind::Missing
    }

    /// The number that it is.
    fn number(&self) -> Option<f64> {
        match self.kind() {
            Kind::Number(number) => Some(number),
            _ => None,
        }
    }

    /// The text that it is.
    fn text(&self) -> Option<String> {
        match self.kind() {
            Kind::Text(text) => Some(text),
            _ => None,
        }
    }
}

/// What a value is.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// It is not there.
    Missing,
    /// Nothing, which was given.
    Null,
    /// True or false.
    Truth(bool),
    /// A number.
    Number(f64),
    /// A text.
    Text(String),
    /// A list, and how many elements it has where that can be told.
    List(Option<usize>),
    /// Something else, by what it is called.
    Other(String),
    /// Its owner throws when it is looked at.
    Unreadable,
}

impl Kind {
    /// What it is, in words for a message.
    pub(super) fn description(self) -> Text {
        match self {
            Self::Missing => "undefined".into(),
            Self::Null => "null".into(),
            Self::Truth(truth) => truth.to_string().into(),
            Self::Number(number) => number.into(),
            Self::Text(text) => quoted(&text).into(),
            Self::List(Some(count)) => format!("an array of {count}").into(),
            Self::List(None) => "an array of elements".into(),
            Self::Other(name) => Text::from("of type ") + name,
            Self::Unreadable => "one that cannot be read".into(),
        }
    }
}

/// What the fields of a value are.
pub enum Keys {
    /// It has none, being no object.
    NoObject,
    /// It is of this class, which keeps elsewhere what it has.
    Instance(String),
    /// They are known.
    Known,
    /// One is not known: this.
    Unknown(String),
    /// Its owner throws when they are looked at.
    Unreadable,
}

/// The error that says what a value must be.
pub(crate) fn refused<S: Source>(
    given: &S,
    place: Place<'_>,
    expected: impl Into<Text>,
) -> InvalidInput {
    InvalidInput::new(place.to_string(), expected, given.kind().description())
}

/// The error that says how many numbers there may be.
pub(crate) fn too_many(place: Place<'_>, most: usize, count: usize) -> InvalidInput {
    let (expected, found) = (format!("at most {most} numbers"), format!("{count} numbers"));
    InvalidInput::new(place.to_string(), expected, found)
}

/// Refuses anything but an object with no fields but these.
pub(crate) fn read_object<S: Source>(
    given: &S,
    place: Place<'_>,
    known: &[&'static str],
) -> Result<()> {
    match given.keys(known) {
        Keys::Known => Ok(()),
        Keys::NoObject => Err(refused(given, place, "an object")),
        Keys::Instance(class) => {
            let found = format!("of type {class}");
            Err(InvalidInput::new(place.to_string(), "a plain object", found))
        }
        Keys::Unreadable => {
            let found = Kind::Unreadable.description();
            Err(InvalidInput::new(place.to_string(), "an object", found))
        }
        Keys::Unknown(key) => {
            let expected = format!("an object with no fields but {}", known.join(", "));
            let found = format!("one with {}", quoted(&key));
            Err(InvalidInput::new(place.to_string(), expected, found))
        }
    }
}

/// The beginning of a text in quotation marks.
pub(crate) fn quoted(text: &str) -> String {
    let shown: String = text.chars().take(40).collect();
    if shown.len() < text.len() { format!("'{shown}…'") } else { format!("'{shown}'") }
}
