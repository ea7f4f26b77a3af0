//! What a message says.

use core::fmt;
use core::ops::Add;

/// A text with numbers in it, which remain numbers until somebody writes them: how that is done, and with how large a
/// program, is another thing in each language.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Text(Vec<Piece>);

#[derive(Clone, Debug, PartialEq)]
enum Piece {
    Words(String),
    Number(f64),
}

impl Text {
    // Once, not in each message.
    #[inline(never)]
    fn followed_by(mut self, mut more: Self) -> Self {
        self.0.append(&mut more.0);
        self
    }

    /// The text, with each number written in this way.
    pub fn written(&self, number: impl Fn(f64) -> String) -> String {
        let piece = |piece: &Piece| match piece {
            Piece::Words(words) => words.clone(),
            Piece::Number(value) => number(*value),
        };
        self.0.iter().map(piece).collect()
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.written(shown))
    }
}

/// A number in a message: very large and very small ones with an exponent.
fn shown(number: f64) -> String {
    let magnitude = number.abs();
    if number.is_infinite() {
        return if number > 0.0 { "Infinity" } else { "-Infinity" }.into();
    }
    if magnitude >= 1e21 || (magnitude < 1e-6 && magnitude > 0.0) {
        return format!("{number:e}");
    }
    number.to_string()
}

impl From<&str> for Text {
    fn from(words: &str) -> Self {
        String::from(words).into()
    }
}

impl From<String> for Text {
    #[inline(never)]
    fn from(words: String) -> Self {
        Self(vec![Piece::Words(words)])
    }
}

impl From<f64> for Text {
    #[inline(never)]
    fn from(number: f64) -> Self {
        Self(vec![Piece::Number(number)])
    }
}

impl From<u32> for Text {
    fn from(number: u32) -> Self {
        f64::from(number).into()
    }
}

impl<T: Into<Text>> Add<T> for Text {
    type Output = Self;

    fn add(self, more: T) -> Self {
        self.followed_by(more.into())
    }
}
