//! Values that can be told outside of Rust.

use core::ops::Deref;

use super::types::Types;

/// A value that has a plain form: a number, a word, a list, an object.
pub trait Plain {
    /// The names of its fields, where it has some.
    const KEYS: &'static [&'static str] = &[];

    /// Its type in TypeScript; whatever that names is declared.
    fn typescript(types: &mut Types) -> String;

    /// The value in its plain form.
    fn write<W: Writer>(&self, to: &W) -> W::Value;
}

/// What plain forms are made of.
pub trait Writer {
    /// A plain form.
    type Value;

    /// Nothing.
    fn null(&self) -> Self::Value;
    /// A number.
    fn number(&self, number: f64) -> Self::Value;
    /// A whole number, for whom it is another thing.
    fn whole(&self, number: u32) -> Self::Value {
        self.number(f64::from(number))
    }
    /// True or false.
    fn truth(&self, truth: bool) -> Self::Value;
    /// A text.
    fn text(&self, text: &str) -> Self::Value;
    /// Numbers side by side.
    fn column(&self, numbers: &[f64]) -> Self::Value;
    /// Zeros and ones side by side.
    fn flags(&self, flags: &[u8]) -> Self::Value;
    /// A list.
    fn list(&self, elements: impl Iterator<Item = Self::Value>) -> Self::Value;
    /// An object, by the names of its fields.
    fn object<const N: usize>(&self, fields: [(&'static str, Self::Value); N]) -> Self::Value;
}

/// One number of each of many things, such as the samples of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column(pub Vec<f64>);

impl Column {
    /// One number of each of these.
    pub fn of<T>(all: &[T], number: impl Fn(&T) -> f64) -> Self {
        Self(all.iter().map(number).collect())
    }
}

impl Deref for Column {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.0
    }
}

impl Plain for Column {
    fn typescript(_: &mut Types) -> String {
        "Float64Array".into()
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        to.column(self)
    }
}

/// Many things of which a plain object tells some numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns<T>(pub Vec<T>);

impl<T> Columns<T> {
    /// One number of each.
    pub(crate) fn column(&self, number: fn(&T) -> f64) -> Column {
        Column::of(&self.0, number)
    }
}

/// So many things, each of which is made when it is written: all at once would take much memory.
pub struct Each<'a, T> {
    /// How many.
    pub count: u32,
    /// Makes the one with this index.
    pub make: Box<dyn Fn(u32) -> T + 'a>,
}

/// Whether something holds, as 1 or 0, of each of many things.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Flags(pub Vec<u8>);

impl Flags {
    /// Of each of these, whether it holds.
    pub fn of<T>(all: &[T], holds: impl Fn(&T) -> bool) -> Self {
        Self(all.iter().map(|one| u8::from(holds(one))).collect())
    }
}

impl Plain for Flags {
    fn typescript(_: &mut Types) -> String {
        "Uint8Array".into()
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        to.flags(&self.0)
    }
}

macro_rules! simple {
    ($($type:ty: $typescript:literal = |$value:ident, $to:ident| $written:expr;)+) => {$(
        impl Plain for $type {
            fn typescript(_: &mut Types) -> String {
                $typescript.into()
            }

            fn write<W: Writer>(&self, $to: &W) -> W::Value {
                let $value = self;
                $written
            }
        }
    )+};
}

simple! {
    f64: "number" = |value, to| to.number(*value);
    u32: "number" = |value, to| to.whole(*value);
    bool: "boolean" = |value, to| to.truth(*value);
    String: "string" = |value, to| to.text(value);
    &'static str: "string" = |value, to| to.text(value);
    &'static [&'static str]: "string[]" = |value, to| to.list(value.iter().map(|text| to.text(text)));
}

impl<T: Plain> Plain for &T {
    fn typescript(types: &mut Types) -> String {
        T::typescript(types)
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        (**self).write(to)
    }
}

impl<T: Plain> Plain for Option<T> {
    fn typescript(types: &mut Types) -> String {
        format!("{} | null", T::typescript(types))
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        self.as_ref().map_or_else(|| to.null(), |value| value.write(to))
    }
}

impl<T: Plain> Plain for Vec<T> {
    fn typescript(types: &mut Types) -> String {
        format!("{}[]", T::typescript(types))
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        to.list(self.iter().map(|value| value.write(to)))
    }
}

impl<T: Plain> Plain for Each<'_, T> {
    fn typescript(types: &mut Types) -> String {
        Vec::<T>::typescript(types)
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        to.list((0..self.count).map(|index| (self.make)(index).write(to)))
    }
}

impl<T: Plain, const N: usize> Plain for [T; N] {
    fn typescript(types: &mut Types) -> String {
        format!("[{}]", vec![T::typescript(types); N].join(", "))
    }

    fn write<W: Writer>(&self, to: &W) -> W::Value {
        to.list(self.iter().map(|value| value.write(to)))
    }
}
