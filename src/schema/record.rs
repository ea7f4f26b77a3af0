//! Tables of fields.

/// A struct that is a plain object outside: its fields with their names there, and after `in` which numbers each may be.
///
/// `input` makes it one that is read: of an experiment, where what is left out keeps its value. `required` makes it one of
/// which nothing may be left out but what is `[optional]`.
macro_rules! record {
    (input $($rest:tt)+) => { crate::schema::record! { @both false $($rest)+ } };
    (required $($rest:tt)+) => { crate::schema::record! { @both true $($rest)+ } };
    (@both $required:literal $(($($derive:ident),*))?
        $(#[doc = $about:literal])+
        pub struct $name:ident $(<$scalar:ident = f64>)? {
            $(
                $(#[doc = $doc:literal])+
                pub $field:ident: $type:ty => $key:literal $([$optional:ident])? $(in $allowed:expr)?,
            )+
        }
    ) => {
        crate::schema::record! {
            $(($($derive),*))?
            $(#[doc = $about])+
            pub struct $name $(<$scalar = f64>)? {
                $($(#[doc = $doc])+ pub $field: $type => $key $([$optional])?,)+
            }
        }

        const _: () = {
            // Not `Allowed`, for what stands after `in` names it.
            use crate::schema::{
                self as schema, Fields, Input, Place, Plain, Result, Source, check_field,
                field_rows, read_field, read_object, record,
            };

            impl Input for $name {
                fn fields(path: &str, _: &schema::Allowed, rows: &mut Fields) {
                    fn of<T: Input>(
                        _: fn(&$name) -> &T,
                        path: &str,
                        key: &str,
                        allowed: &schema::Allowed,
                        rows: &mut Fields,
                    ) {
                        field_rows::<T>(path, key, allowed, rows);
                    }
                    $(of(|record| &record.$field, path, $key, record!(@allowed $($allowed)?), rows);)+
                }

                fn check(&self, place: Place<'_>, _: &schema::Allowed) -> Result<()> {
                    $(check_field(&self.$field, (&place, $key), record!(@allowed $($allowed)?))?;)+
                    Ok(())
                }

                fn read<S: Source>(&mut self, given: &S, place: Place<'_>, _: &schema::Allowed) -> Result<()> {
                    read_object(given, place, Self::KEYS)?;
                    $(read_field(
                        &mut self.$field,
                        given,
                        (&place, $key),
                        record!(@allowed $($allowed)?),
                        record!(@required $required $($optional)?),
                    )?;)+
                    Ok(())
                }
            }
        };
    };
    (@required $required:literal) => { $required };
    (@required $required:literal optional) => { false };
    (@allowed) => { &crate::schema::Allowed::ANY };
    (@allowed $allowed:expr) => {{
        const ALLOWED: crate::schema::Allowed = $allowed;
        &ALLOWED
    }};
    ($(($($derive:ident),*))?
        $(#[doc = $about:literal])+
        pub struct $name:ident $(<$scalar:ident = f64>)? {
            $(
                $(#[doc = $doc:literal])+
                pub $field:ident: $type:ty => $key:literal $([$optional:ident])?,
            )+
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Clone, Debug, PartialEq $($(, $derive)*)?)]
        pub struct $name $(<$scalar = f64>)? {
            $($(#[doc = $doc])+ pub $field: $type,)+
        }

        crate::schema::told! {
            $(#[doc = $about])+
            $name: $name {
                $($(#[doc = $doc])+ $key $([$optional])? => |record| &record.$field,)+
            }
        }
    };
}

/// What is told of a type outside: a plain object by this name, whose fields are computed. Whoever gives one may leave out
/// those that are `[optional]`.
macro_rules! told {
    (@ optional) => { "?" };
    (
        $(#[doc = $about:literal])+
        $name:ident: $type:ty {
            $($(#[doc = $doc:literal])+ $key:literal $([$optional:ident])? => |$it:ident| $value:expr,)+
        }
    ) => {
        const _: () = {
            use crate::schema::{Plain, Types, Writer};

            impl Plain for $type {
                const KEYS: &'static [&'static str] = &[$($key),+];

                fn typescript(types: &mut Types) -> String {
                    fn of<'a, T: Plain>(types: &mut Types, _: impl Fn(&'a $type) -> T) -> String {
                        T::typescript(types)
                    }
                    types.interface(stringify!($name), &[$($about),+], |types| {
                        vec![$((
                            concat!($key $(, crate::schema::told!(@ $optional))?),
                            &[$($doc),+] as &[&str],
                            of(types, |$it| $value),
                        )),+]
                    })
                }

                fn write<W: Writer>(&self, to: &W) -> W::Value {
                    to.object([$((
                        $key,
                        {
                            let $it = self;
                            Plain::write(&$value, to)
                        },
                    )),+])
                }
            }
        };
    };
}

pub(crate) use record;
pub(crate) use told;
