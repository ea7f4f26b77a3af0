//! Plain values that are read, and refused by name where they are wrong.
//!
//! Reading looks at what a value is; whether a number is in its range is checked once, afterwards, by [`Input::check`].

use super::allowed::{Allowed, Result};
use super::field::{Field, Fields};
use super::place::Place;
use super::plain::Plain;
use super::source::{Kind, Source, refused};

/// A value that can be read from its plain form.
pub trait Input: Plain {
    /// Adds a row for every number and word in it.
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields);

    /// Refuses numbers that are not allowed.
    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<()>;

    /// Takes over what is given. What is left out stays as it is.
    fn read<S: Source>(&mut self, given: &S, place: Place<'_>, allowed: &Allowed) -> Result<()>;
}

/// What an input has in which no number has a range of its own, and of which no table has a row.
macro_rules! unranged {
    () => {
        fn fields(_: &str, _: &$crate::schema::Allowed, _: &mut $crate::schema::Fields) {}

        fn check(
            &self,
            _: $crate::schema::Place<'_>,
            _: &$crate::schema::Allowed,
        ) -> $crate::schema::Result<()> {
            Ok(())
        }
    };
}

pub(crate) use unranged;

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
) -> Result<()> {
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
) -> Result<()> {
    let field = given.field(key);
    if required || field.is_given() {
        value.read(&field, Place::Field(record, key), allowed)?;
    }
    Ok(())
}

/// A value with what is given taken over, and checked.
pub(crate) fn read_whole<T: Input, S: Source>(
    mut value: T,
    given: &S,
    place: Place<'_>,
    allowed: &Allowed,
) -> Result<T> {
    value.read(given, place, allowed)?;
    value.check(place, allowed)?;
    Ok(value)
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

    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        allowed.check(place, *self)
    }

    fn read<S: Source>(&mut self, given: &S, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        *self = given.number().ok_or_else(|| refused(given, place, allowed.expected()))?;
        Ok(())
    }
}

impl Input for u32 {
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields) {
        number_field(path, allowed, rows);
    }

    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        f64::from(*self).check(place, allowed)
    }

    fn read<S: Source>(&mut self, given: &S, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        let whole = given.number().filter(|number| Allowed::SEED.allows(*number));
        *self = whole.ok_or_else(|| refused(given, place, allowed.expected()))? as u32;
        Ok(())
    }
}

impl Input for Option<f64> {
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields) {
        number_field(path, allowed, rows);
    }

    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        self.map_or(Ok(()), |number| number.check(place, allowed))
    }

    fn read<S: Source>(&mut self, given: &S, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        *self = match given.kind() {
            Kind::Null => None,
            Kind::Number(number) => Some(number),
            _ => return Err(refused(given, place, allowed.expected())),
        };
        Ok(())
    }
}

impl Input for bool {
    unranged!();

    fn read<S: Source>(&mut self, given: &S, place: Place<'_>, _: &Allowed) -> Result<()> {
        match given.kind() {
            Kind::Truth(truth) => *self = truth,
            _ => return Err(refused(given, place, "true or false")),
        }
        Ok(())
    }
}

impl<T: Input, const N: usize> Input for [T; N] {
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields) {
        T::fields(&format!("{path}[]"), allowed, rows);
    }

    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        let mut elements = self.iter().enumerate();
        elements.try_for_each(|(i, element)| element.check(Place::Element(&place, i), allowed))
    }

    fn read<S: Source>(&mut self, given: &S, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        if given.length(false) != Some(N) {
            return Err(refused(given, place, format!("an array of {N}")));
        }
        for (i, element) in self.iter_mut().enumerate() {
            element.read(&given.element(i), Place::Element(&place, i), allowed)?;
        }
        Ok(())
    }
}
