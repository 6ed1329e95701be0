//! Keys as constants, so that the compiler knows every key of every table and the type of the key's value.
//!
//! [`table_keys!`](crate::table_keys) declares the keys of a table once. Reader, overrides and schema use these
//! declarations, and each key becomes a constant with which code looks up the key in a table that has been read.

use core::fmt;
use core::marker::PhantomData;

use crate::held::Held;
use crate::spec::KeySpec;

/// States that a table with these keys also has the keys `T`, so that code for tables with the keys `T` can read this
/// table.
pub trait ReadAs<T> {}

/// A key of a table with the keys `T`; the key's value is of the type `V`.
pub struct Key<T, V> {
    name: &'static str,
    of: PhantomData<fn() -> (T, V)>,
}

/// Any value.
#[derive(Debug)]
pub enum Anything {}

/// A key of a table with the keys `T`, whatever the type of the key's value.
pub type AnyKey<T> = Key<T, Anything>;

impl<T, V> Key<T, V> {
    /// The name of the key, as files write it.
    pub const fn name(self) -> &'static str {
        self.name
    }

    /// This key as a key of the tables `S`; this kind of table is one of the tables `S`.
    pub const fn shared<S>(self) -> Key<S, V>
    where
        T: ReadAs<S>,
    {
        Key { name: self.name, of: PhantomData }
    }

    /// This key without the type of its value, for lists of keys with values of different types.
    pub const fn any(self) -> AnyKey<T> {
        Key { name: self.name, of: PhantomData }
    }
}

impl<T, V: Held> Key<T, V> {
    /// The typed key for a declaration, for use in a constant. The compiler checks that the declaration fits the type
    /// of the value and the name of the constant.
    #[must_use]
    pub const fn declared(spec: &KeySpec, constant: &str) -> Key<T, V> {
        assert!(
            is_in_capitals(constant, spec.name),
            "the constant of a key is its name in capitals"
        );
        Key::of(spec)
    }

    /// The typed key for a declaration of a key.
    #[must_use]
    pub const fn of(spec: &KeySpec) -> Key<T, V> {
        assert!(
            spec.kind.variant() as u8 == V::VARIANT as u8,
            "the key holds another kind of value"
        );
        if let (Some(declared), Some(typed)) = (spec.kind.table(), V::TABLE) {
            assert!(are_among(declared, typed), "the key holds a table with other keys");
        }
        Key { name: spec.name, of: PhantomData }
    }
}

impl<T, V> Clone for Key<T, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T, V> Copy for Key<T, V> {}

impl<T, V> PartialEq for Key<T, V> {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl<T, V> Eq for Key<T, V> {}

impl<T, V> fmt::Debug for Key<T, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Key({})", self.name)
    }
}

impl<T, V> fmt::Display for Key<T, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// Declares the keys of a table: the list of keys for [`TableSpec`](crate::spec::TableSpec), and a constant for each
/// key.
///
/// A key is declared as `CONSTANT: type of the value = declaration`. The constant is the key's name in capitals. The
/// constant `ALL` is the list of all these keys. A table that has further keys names the list of all its keys after
/// `of`.
#[macro_export]
macro_rules! table_keys {
    (
        $(#[$doc:meta])*
        $vis:vis $keys:ident { $($constant:ident: $held:ty = $spec:expr),* $(,)? }
    ) => {
        $crate::table_keys! {
            $(#[$doc])*
            $vis $keys of $keys::ALL; { $($constant: $held = $spec),* }
        }
    };
    (
        $(#[$doc:meta])*
        $vis:vis $keys:ident of $all:expr; { $($constant:ident: $held:ty = $spec:expr),* $(,)? }
    ) => {
        $(#[$doc])*
        #[derive(Debug)]
        $vis enum $keys {}

        #[allow(dead_code, reason = "no code looks up a key that is only checked, or read with all keys of its table")]
        impl $keys {
            /// The declarations of the keys, in the order in which the documentation shows the keys.
            $vis const ALL: &'static [$crate::spec::KeySpec] = &[$($spec),*];

            $(
                #[doc = concat!("```text\n", stringify!($spec), "\n```")]
                $vis const $constant: $crate::typed_key::Key<$keys, $held> =
                    $crate::typed_key::Key::declared(&$spec, stringify!($constant));
            )*
        }

        impl $crate::spec::TableKeys for $keys {
            const KEYS: &'static [$crate::spec::KeySpec] = $all;
        }
    };
}

/// Declares keys that several tables share, for code that reads all these tables.
///
/// An example is `shared_keys!{ pub SectionsKey of PassingKey and InteractionKey { SECTIONS: OneOf<SectionsBy> } }`.
#[macro_export]
macro_rules! shared_keys {
    (
        $(#[$doc:meta])*
        $vis:vis $shared:ident of $first:ident $(and $other:ident)*
        { $($constant:ident: $held:ty),+ $(,)? }
    ) => {
        $(#[$doc])*
        #[derive(Debug)]
        $vis enum $shared {}

        impl $shared {
            $(
                #[doc = concat!("As `", stringify!($first), "::", stringify!($constant), "`.")]
                $vis const $constant: $crate::typed_key::Key<$shared, $held> =
                    $first::$constant.shared();
            )+
        }

        $crate::shared_keys! { @of $shared, $first { $($constant: $held),+ } }
        $crate::shared_keys! { @others $shared, [$($other)*] { $($constant: $held),+ } }
    };
    (@others $shared:ident, [] $keys:tt) => {};
    (@others $shared:ident, [$other:ident $($more:ident)*] $keys:tt) => {
        $crate::shared_keys! { @of $shared, $other $keys }
        $crate::shared_keys! { @others $shared, [$($more)*] $keys }
    };
    (@of $shared:ident, $table:ident { $($constant:ident: $held:ty),+ }) => {
        impl $crate::typed_key::ReadAs<$shared> for $table {}

        const _: () = {
            $(let _: $crate::typed_key::Key<$shared, $held> = $table::$constant.shared();)+
        };
    };
}

/// Makes a list of keys of a table, whatever the types of their values: `any_keys![TailKey: ROPE, LENGTH]`.
#[macro_export]
macro_rules! any_keys {
    ($keys:ident: $($constant:ident),+ $(,)?) => {
        const { &[$($keys::$constant.any()),+] }
    };
}

/// Whether the text `capitals` is the text `text` in capitals.
const fn is_in_capitals(capitals: &str, text: &str) -> bool {
    let (capitals, text) = (capitals.as_bytes(), text.as_bytes());
    if capitals.len() != text.len() {
        return false;
    }
    let mut index = 0;
    while index < text.len() {
        if capitals[index] != text[index].to_ascii_uppercase() {
            return false;
        }
        index += 1;
    }
    true
}

/// Whether the names of the keys `some` are all among the names of the keys `others`.
pub(crate) const fn are_among(some: &[KeySpec], others: &[KeySpec]) -> bool {
    let mut index = 0;
    while index < some.len() {
        let mut at = 0;
        while at < others.len() && !is_same(some[index].name, others[at].name) {
            at += 1;
        }
        if at == others.len() {
            return false;
        }
        index += 1;
    }
    true
}

/// Whether two texts are the same. The function does by hand what `==` of texts cannot do at compile time.
pub(crate) const fn is_same(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    if one.len() != other.len() {
        return false;
    }
    let mut index = 0;
    while index < one.len() {
        if one[index] != other[index] {
            return false;
        }
        index += 1;
    }
    true
}
