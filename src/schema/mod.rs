//! What is known outside of Rust: names, units, ranges, words and descriptions, each of which stands once.
//!
//! A record is a table of its fields. From that one table a plain object is read, completed, checked and written, and its
//! TypeScript is told. This room knows neither robots nor JavaScript: [`Source`] is whatever is read, [`Writer`] whatever
//! is written.

mod text;

mod allowed;

mod place;

mod types;

mod plain;

mod record;

mod words;

mod field;

mod source;

mod input;

pub use allowed::{Allowed, InvalidInput, Refusal, Result};
pub use field::{Field, Fields, WordField};
pub use input::Input;
pub use place::Place;
pub use plain::{Column, Columns, Each, Flags, Plain, Writer};
pub use source::{Keys, Kind, Source};
pub use text::Text;
pub use types::{Declared, Types};

pub(crate) use input::{check_field, field_rows, read_field, read_whole, unranged};
pub(crate) use record::{record, told};
pub(crate) use source::{quoted, read_object, refused, too_many};
pub(crate) use words::words;
