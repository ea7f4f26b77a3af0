//! Enumerations whose values are words outside of Rust.

/// One of a few words, each of which stands here once. `input` makes it one that is read.
macro_rules! words {
    (input $(#[doc = $about:literal])+ pub enum $name:ident { $($rest:tt)+ }) => {
        crate::schema::words! { $(#[doc = $about])+ pub enum $name { $($rest)+ } }

        const _: () = {
            use crate::schema::{
                Allowed, Fields, Input, Place, Result, Source, WordField, refused,
            };

            impl Input for $name {
                fn fields(path: &str, _: &Allowed, rows: &mut Fields) {
                    rows.words.push(WordField { path: path.into(), words: Self::WORDS });
                }

                fn check(&self, _: Place<'_>, _: &Allowed) -> Result<()> {
                    Ok(())
                }

                fn read<S: Source>(&mut self, given: &S, place: Place<'_>, _: &Allowed) -> Result<()> {
                    let word = given.text().and_then(|word| Self::named(&word));
                    *self = word.ok_or_else(|| refused(given, place, Self::expected()))?;
                    Ok(())
                }
            }
        };
    };
    (
        $(#[doc = $about:literal])+
        pub enum $name:ident {
            $($(#[doc = $doc:literal])+ $variant:ident = $word:literal,)+
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name {
            $($(#[doc = $doc])+ $variant,)+
        }

        impl $name {
            /// All of them, in their order.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];
            /// Their words, in the same order.
            pub const WORDS: &'static [&'static str] = &[$($word),+];

            /// The word for this.
            pub const fn word(self) -> &'static str {
                Self::WORDS[self as usize]
            }

            /// The one with this word.
            pub fn named(word: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|one| one.word() == word)
            }

            /// The words in a message.
            pub fn expected() -> String {
                let quoted: Vec<_> = Self::WORDS.iter().map(|word| format!("'{word}'")).collect();
                quoted.join(" or ")
            }
        }

        const _: () = {
            use crate::schema::{InvalidInput, Plain, Types, Writer, quoted};

            impl core::fmt::Display for $name {
                fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                    f.pad(self.word())
                }
            }

            impl core::str::FromStr for $name {
                type Err = InvalidInput;

                fn from_str(word: &str) -> Result<Self, InvalidInput> {
                    let refused = || InvalidInput::new(stringify!($name), Self::expected(), quoted(word));
                    Self::named(word).ok_or_else(refused)
                }
            }

            impl Plain for $name {
                fn typescript(types: &mut Types) -> String {
                    let words = Self::expected().replace(" or ", " | ");
                    types.alias(stringify!($name), &[$($about),+], &words)
                }

                fn write<W: Writer>(&self, to: &W) -> W::Value {
                    to.text(self.word())
                }
            }
        };
    };
}

pub(crate) use words;
