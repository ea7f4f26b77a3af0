//! Plain values that are read, and refused by name where they are wrong.
//!
//! Reading looks at what a value is; whether a number is in its range is checked once, afterwards, by [`Input::check`].

use super::allowed::{Allowed, InvalidInput};
use super::field::{Field, Fields};
use super::place::Place;
use super::plain::Plain;

/// A value that can be read from its plain form.
pub trait Input: Plain {
    /// Adds a row for every number and word in it.
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields);

    /// Refuses numbers that are not allowed.
    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<(), InvalidInput>;

    /// Takes over what is given. What is left out stays as it is.
    fn read<S: Source>(
        &mut self,
        given: &S,
        place: Place<'_>,
        allowed: &Allowed,
    ) -> Result<(), InvalidInput>;
}

/// A plain value that somebody gave. One that cannot be read is of no kind, and its description says so.
pub trait Source: Sized {
    /// Whether it is there at all.
    fn is_given(&self) -> bool;
    /// Whether it is null.
    fn is_null(&self) -> bool;
    /// The number that it is.
    fn number(&self) -> Option<f64>;
    /// The truth that it is.
    fn truth(&self) -> Option<bool>;
    /// The text that it is.
    fn text(&self) -> Option<String>;
    /// The numbers that it is, side by side; refused if they are more than allowed.
    fn column(&self, place: Place<'_>, most: usize) -> Result<Option<Vec<f64>>, InvalidInput>;
    /// How many elements it has, if it is a list; also one of numbers side by side, if those may be.
    fn length(&self, columns: bool) -> Option<usize>;
    /// The element with this index.
    fn element(&self, index: usize) -> Self;
    /// Whether it is an object with no fields but these.
    fn keys(&self, known: &[&'static str]) -> Keys;
    /// The field with this name.
    fn field(&self, name: &'static str) -> Self;
    /// What it is, in words for a message.
    fn description(&self) -> String;
}

/// What the fields of a value are.
pub enum Keys {
    /// It has none, being no object.
    NoObject,
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
    expected: impl Into<String>,
) -> InvalidInput {
    InvalidInput::new(place.to_string(), expected, given.description())
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
) -> Result<(), InvalidInput> {
    match given.keys(known) {
        Keys::Known => Ok(()),
        Keys::NoObject => Err(refused(given, place, "an object")),
        Keys::Unreadable => {
            Err(InvalidInput::new(place.to_string(), "an object", "one that cannot be read"))
        }
        Keys::Unknown(key) => {
            let expected = format!("an object with no fields but {}", known.join(", "));
            Err(InvalidInput::new(place.to_string(), expected, format!("one with {key}")))
        }
    }
}

/// Adds the rows of one field of a record.
#[inline(never)]
pub(crate) fn field_rows<T: Input>(path: &str, key: &str, allowed: &Allowed, rows: &mut Fields) {
    let dot = if path.is_empty() { "" } else { "." };
    T::fields(&[path, dot, key].concat(), allowed, rows);
}

/// Checks one field of a record. Like [`read_field`] it stands once for each type, not once for each field.
#[inline(never)]
pub(crate) fn check_field<T: Input>(
    value: &T,
    (record, key): (&Place<'_>, &str),
    allowed: &Allowed,
) -> Result<(), InvalidInput> {
    value.check(Place::Field(record, key), allowed)
}

/// Takes over one field of a record, where it is given or must be.
#[inline(never)]
pub(crate) fn read_field<T: Input, S: Source>(
    value: &mut T,
    given: &S,
    (record, key): (&Place<'_>, &'static str),
    allowed: &Allowed,
    required: bool,
) -> Result<(), InvalidInput> {
    let field = given.field(key);
    if required || field.is_given() {
        value.read(&field, Place::Field(record, key), allowed)?;
    }
    Ok(())
}

#[inline(never)]
fn number_field(path: &str, allowed: &Allowed, rows: &mut Fields) {
    let Allowed { unit, min, max, integer, nullable } = *allowed;
    rows.numbers.push(Field { path: path.into(), unit, min, max, integer, nullable });
}

impl Input for f64 {
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields) {
        number_field(path, allowed, rows);
    }

    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<(), InvalidInput> {
        allowed.check(place, *self)
    }

    fn read<S: Source>(
        &mut self,
        given: &S,
        place: Place<'_>,
        allowed: &Allowed,
    ) -> Result<(), InvalidInput> {
        *self = given.number().ok_or_else(|| refused(given, place, allowed.expected()))?;
        Ok(())
    }
}

impl Input for u32 {
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields) {
        number_field(path, allowed, rows);
    }

    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<(), InvalidInput> {
        f64::from(*self).check(place, allowed)
    }

    fn read<S: Source>(
        &mut self,
        given: &S,
        place: Place<'_>,
        allowed: &Allowed,
    ) -> Result<(), InvalidInput> {
        let whole = given.number().filter(|number| Allowed::SEED.allows(*number));
        *self = whole.ok_or_else(|| refused(given, place, allowed.expected()))? as u32;
        Ok(())
    }
}

impl Input for Option<f64> {
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields) {
        number_field(path, allowed, rows);
    }

    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<(), InvalidInput> {
        self.map_or(Ok(()), |number| number.check(place, allowed))
    }

    fn read<S: Source>(
        &mut self,
        given: &S,
        place: Place<'_>,
        allowed: &Allowed,
    ) -> Result<(), InvalidInput> {
        *self = if given.is_null() { None } else { Some(0.0) };
        self.as_mut().map_or(Ok(()), |number| number.read(given, place, allowed))
    }
}

impl Input for bool {
    fn fields(_: &str, _: &Allowed, _: &mut Fields) {}

    fn check(&self, _: Place<'_>, _: &Allowed) -> Result<(), InvalidInput> {
        Ok(())
    }

    fn read<S: Source>(
        &mut self,
        given: &S,
        place: Place<'_>,
        _: &Allowed,
    ) -> Result<(), InvalidInput> {
        *self = given.truth().ok_or_else(|| refused(given, place, "true or false"))?;
        Ok(())
    }
}

impl<T: Input, const N: usize> Input for [T; N] {
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields) {
        T::fields(&format!("{path}[]"), allowed, rows);
    }

    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<(), InvalidInput> {
        let mut elements = self.iter().enumerate();
        elements.try_for_each(|(i, element)| element.check(Place::Element(&place, i), allowed))
    }

    fn read<S: Source>(
        &mut self,
        given: &S,
        place: Place<'_>,
        allowed: &Allowed,
    ) -> Result<(), InvalidInput> {
        if given.length(false) != Some(N) {
            return Err(refused(given, place, format!("an array of {N}")));
        }
        for (i, element) in self.iter_mut().enumerate() {
            element.read(&given.element(i), Place::Element(&place, i), allowed)?;
        }
        Ok(())
    }
}
