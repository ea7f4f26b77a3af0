//! Plain values as JSON: what the boundary does with JavaScript's.

use ep_locomotion::schema::{InvalidInput, Keys, Kind, Place, Plain, Source, Writer};
use serde_json::{Map, Value};

/// The plain form of a value.
pub fn written(value: &impl Plain) -> Value {
    value.write(&Json)
}

struct Json;

impl Writer for Json {
    type Value = Value;

    fn null(&self) -> Value {
        Value::Null
    }

    fn number(&self, number: f64) -> Value {
        number.into()
    }

    fn truth(&self, truth: bool) -> Value {
        truth.into()
    }

    fn text(&self, text: &str) -> Value {
        text.into()
    }

    fn column(&self, numbers: &[f64]) -> Value {
        numbers.into()
    }

    fn flags(&self, flags: &[u8]) -> Value {
        flags.into()
    }

    fn list(&self, elements: impl Iterator<Item = Value>) -> Value {
        elements.collect()
    }

    fn object<const N: usize>(&self, fields: [(&'static str, Value); N]) -> Value {
        Value::Object(Map::from_iter(fields.map(|(name, value)| (name.into(), value))))
    }
}

/// A value that was given, or none. An object with the one field `column` stands for numbers side by side.
pub struct Given<'a>(pub Option<&'a Value>);

impl Source for Given<'_> {
    fn kind(&self) -> Kind {
        match self.0 {
            None => Kind::Missing,
            Some(Value::Null) => Kind::Null,
            Some(Value::Bool(truth)) => Kind::Truth(*truth),
            Some(Value::Number(number)) => Kind::Number(number.as_f64().expect("a number")),
            Some(Value::String(text)) => Kind::Text(text.clone()),
            Some(Value::Array(list)) => Kind::List(Some(list.len())),
            Some(Value::Object(_)) => Kind::Other("object".into()),
        }
    }

    fn column(&self, place: Place<'_>, most: usize) -> Result<Option<Vec<f64>>, InvalidInput> {
        let Some(list) = self.0.and_then(|value| value.get("column")).and_then(Value::as_array)
        else {
            return Ok(None);
        };
        let numbers: Option<Vec<f64>> = list.iter().map(Value::as_f64).collect();
        let expected = format!("at most {most} numbers");
        let refused =
            || InvalidInput::new(place.to_string(), expected, format!("a list of {}", list.len()));
        numbers.filter(|numbers| numbers.len() <= most).map(Some).ok_or_else(refused)
    }

    fn length(&self, _: bool) -> Option<usize> {
        self.0.and_then(Value::as_array).map(Vec::len)
    }

    fn element(&self, index: usize) -> Self {
        Given(self.0.and_then(|list| list.get(index)))
    }

    fn keys(&self, known: &[&'static str]) -> Keys {
        let Some(object) = self.0.and_then(Value::as_object) else { return Keys::NoObject };
        let unknown = object.keys().find(|key| !known.contains(&key.as_str()));
        unknown.map_or(Keys::Known, |key| Keys::Unknown(key.clone()))
    }

    fn field(&self, name: &'static str) -> Self {
        Given(self.0.and_then(|object| object.get(name)))
    }
}
