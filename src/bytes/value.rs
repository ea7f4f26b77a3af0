//! Plain values as bytes: a tag, then what it holds, all numbers little-endian.
//!
//! | tag | value | what follows |
//! |---|---|---|
//! | 0, 1, 2 | null, false, true | |
//! | 3 | a number | its 8 bytes |
//! | 4 | a text | how many bytes (u32), UTF-8 |
//! | 5 | numbers side by side | how many (u32), 8 bytes each |
//! | 6 | zeros and ones side by side, only in answers | how many (u32), a byte each |
//! | 7 | a list | how many (u32), values |
//! | 8 | an object | how many (u32), and for each field its name, as the text it is without a tag, and its value |
//! | 9 | something else | what it is called, as a text without a tag |
//! | 10 | a whole number, only in answers | its 4 bytes |

use crate::schema::{Keys, Kind, Place, Result, Source, Writer, too_many};

/// A value that was given.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Null,
    Truth(bool),
    Number(f64),
    Text(String),
    Column(Vec<f64>),
    List(Vec<Value>),
    Object(Vec<(String, Value)>),
    /// Something that has no plain form, by what it is called.
    Other(String),
}

impl Value {
    /// The value that these bytes are, if they are one.
    pub(super) fn of(mut bytes: &[u8]) -> Option<Self> {
        let value = read(&mut bytes, DEEPEST)?;
        bytes.is_empty().then_some(value)
    }
}

/// An experiment goes four deep.
const DEEPEST: u32 = 64;

fn take<'a>(bytes: &mut &'a [u8], count: usize) -> Option<&'a [u8]> {
    let (taken, rest) = bytes.split_at_checked(count)?;
    *bytes = rest;
    Some(taken)
}

fn read_count(bytes: &mut &[u8]) -> Option<usize> {
    let count = take(bytes, 4)?.try_into().ok()?;
    Some(u32::from_le_bytes(count) as usize)
}

fn read_text(bytes: &mut &[u8]) -> Option<String> {
    let count = read_count(bytes)?;
    String::from_utf8(take(bytes, count)?.to_vec()).ok()
}

fn read_number(bytes: &[u8]) -> f64 {
    bytes.try_into().map_or(f64::NAN, f64::from_le_bytes)
}

fn read(bytes: &mut &[u8], depth: u32) -> Option<Value> {
    let deeper = depth.checked_sub(1)?;
    Some(match take(bytes, 1)?[0] {
        0 => Value::Null,
        1 => Value::Truth(false),
        2 => Value::Truth(true),
        3 => Value::Number(read_number(take(bytes, 8)?)),
        4 => Value::Text(read_text(bytes)?),
        5 => {
            let count = read_count(bytes)?;
            let numbers = take(bytes, count.checked_mul(8)?)?;
            Value::Column(numbers.chunks_exact(8).map(read_number).collect())
        }
        7 => {
            let count = read_count(bytes)?;
            Value::List((0..count).map(|_| read(bytes, deeper)).collect::<Option<_>>()?)
        }
        8 => {
            let count = read_count(bytes)?;
            let mut field = || Some((read_text(bytes)?, read(bytes, deeper)?));
            Value::Object((0..count).map(|_| field()).collect::<Option<_>>()?)
        }
        9 => Value::Other(read_text(bytes)?),
        _ => return None,
    })
}

/// A value that was given, or none.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given<'a>(pub(super) Option<&'a Value>);

impl Source for Given<'_> {
    fn kind(&self) -> Kind {
        match self.0 {
            None => Kind::Missing,
            Some(Value::Null) => Kind::Null,
            Some(Value::Truth(truth)) => Kind::Truth(*truth),
            Some(Value::Number(number)) => Kind::Number(*number),
            Some(Value::Text(text)) => Kind::Text(text.clone()),
            Some(Value::Column(numbers)) => Kind::List(Some(numbers.len())),
            Some(Value::List(list)) => Kind::List(Some(list.len())),
            Some(Value::Object(_)) => Kind::Other("object".into()),
            Some(Value::Other(name)) => Kind::Other(name.clone()),
        }
    }

    fn column(&self, place: Place<'_>, most: usize) -> Result<Option<Vec<f64>>> {
        match self.0 {
            Some(Value::Column(numbers)) if numbers.len() > most => {
                Err(too_many(place, most, numbers.len()))
            }
            Some(Value::Column(numbers)) => Ok(Some(numbers.clone())),
            _ => Ok(None),
        }
    }

    fn length(&self, columns: bool) -> Option<usize> {
        match self.0 {
            Some(Value::List(list)) => Some(list.len()),
            Some(Value::Column(numbers)) if columns => Some(numbers.len()),
            _ => None,
        }
    }

    fn element(&self, index: usize) -> Self {
        match self.0 {
            Some(Value::List(list)) => Given(list.get(index)),
            _ => Given(None),
        }
    }

    fn keys(&self, known: &[&'static str]) -> Keys {
        let Some(Value::Object(fields)) = self.0 else { return Keys::NoObject };
        let unknown = fields.iter().find(|(name, _)| !known.contains(&name.as_str()));
        unknown.map_or(Keys::Known, |(name, _)| Keys::Unknown(name.clone()))
    }

    fn field(&self, name: &'static str) -> Self {
        let Some(Value::Object(fields)) = self.0 else { return Given(None) };
        Given(fields.iter().find(|(known, _)| known == name).map(|(_, value)| value))
    }
}

/// Writes values as bytes.
pub(super) struct Bytes;

fn with_count(tag: u8, count: usize, rest: impl FnOnce(&mut Vec<u8>)) -> Vec<u8> {
    let mut bytes = vec![tag];
    bytes.extend_from_slice(&(count as u32).to_le_bytes());
    rest(&mut bytes);
    bytes
}

impl Writer for Bytes {
    type Value = Vec<u8>;

    fn null(&self) -> Vec<u8> {
        vec![0]
    }

    fn number(&self, number: f64) -> Vec<u8> {
        [&[3], &number.to_le_bytes()[..]].concat()
    }

    fn whole(&self, number: u32) -> Vec<u8> {
        with_count(10, number as usize, |_| ())
    }

    fn truth(&self, truth: bool) -> Vec<u8> {
        vec![1 + u8::from(truth)]
    }

    fn text(&self, text: &str) -> Vec<u8> {
        with_count(4, text.len(), |bytes| bytes.extend_from_slice(text.as_bytes()))
    }

    fn column(&self, numbers: &[f64]) -> Vec<u8> {
        with_count(5, numbers.len(), |bytes| {
            bytes.reserve(8 * numbers.len());
            numbers.iter().for_each(|number| bytes.extend_from_slice(&number.to_le_bytes()));
        })
    }

    fn flags(&self, flags: &[u8]) -> Vec<u8> {
        with_count(6, flags.len(), |bytes| bytes.extend_from_slice(flags))
    }

    fn list(&self, elements: impl Iterator<Item = Vec<u8>>) -> Vec<u8> {
        let (mut count, mut all) = (0, Vec::new());
        elements.for_each(|element| {
            count += 1;
            all.extend(element);
        });
        with_count(7, count, |bytes| bytes.extend(all))
    }

    fn object<const N: usize>(&self, fields: [(&'static str, Vec<u8>); N]) -> Vec<u8> {
        with_count(8, N, |bytes| {
            for (name, value) in fields {
                bytes.extend_from_slice(&(name.len() as u32).to_le_bytes());
                bytes.extend_from_slice(name.as_bytes());
                bytes.extend(value);
            }
        })
    }
}
