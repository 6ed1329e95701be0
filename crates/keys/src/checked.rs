//! A scenario's tables after reading: every key is known, every value has its kind, is in SI and within its bounds, and
//! defaults are filled in. Code looks keys up by the constants of [`table_keys!`](crate::table_keys): the compiler
//! refuses a key that does not exist, a key of another table, and a key that holds something else.
//!
//! ```
//! use fenderline_keys::checked::Table;
//! use fenderline_keys::keys::anchor::AnchorKey;
//!
//! fn mass_kg(anchor: &Table) -> f64 {
//!     *anchor.of::<AnchorKey>().given(AnchorKey::MASS).number()
//! }
//! ```
//!
//! With a misspelt key these lines do not compile:
//!
//! ```compile_fail,E0599
//! # use fenderline_keys::checked::Table;
//! # use fenderline_keys::keys::anchor::AnchorKey;
//! fn mass_kg(anchor: &Table) -> f64 {
//!     *anchor.of::<AnchorKey>().given(AnchorKey::MAS).number()
//! }
//! ```
//!
//! Nor with a key of another table:
//!
//! ```compile_fail,E0308
//! # use fenderline_keys::checked::Table;
//! # use fenderline_keys::keys::anchor::AnchorKey;
//! # use fenderline_keys::keys::body::BodyKey;
//! fn mass_kg(anchor: &Table) -> f64 {
//!     *anchor.of::<AnchorKey>().given(BodyKey::MASS).number()
//! }
//! ```
//!
//! Nor if the key holds another kind of value:
//!
//! ```compile_fail,E0599
//! # use fenderline_keys::checked::Table;
//! # use fenderline_keys::keys::anchor::AnchorKey;
//! fn mass_kg(anchor: &Table) -> f64 {
//!     *anchor.of::<AnchorKey>().given(AnchorKey::SIDE).number()
//! }
//! ```

use core::fmt;
use core::iter::Map;
use core::marker::PhantomData;
use core::ops::Deref;
use core::slice;

use fenderline_contact::Vec2;

use crate::choices::Word;
use crate::held::{
    Curve, Flag, ListOf, Name, NamedOf, Number, OneOf, Points, TableOf, Text, Texts, TwoNames,
    Vector,
};
use crate::key_path;
use crate::place::Span;
use crate::spec::{TableKeys, TableSpec};
use crate::typed_key::{AnyKey, Anything, Key, ReadAs, are_among};

/// A table that has been read.
#[derive(Clone, Debug)]
pub struct Table {
    /// The declaration of the table.
    pub spec: &'static TableSpec,
    /// Dotted path of the table; empty for the whole file.
    pub path: String,
    /// Header of the table, or the whole of an inline table.
    pub span: Span,
    /// The keys of the table, in the order of the declaration.
    pub items: Vec<Item>,
}

/// A key and its value.
#[derive(Clone, Debug)]
pub struct Item {
    /// The name of the key.
    pub name: &'static str,
    /// The span of the key; the table's span for a default.
    pub key_span: Span,
    /// The span of the value; the table's span for a default.
    pub span: Span,
    /// The value is the default: the file does not give the key.
    pub is_default: bool,
    /// The value.
    pub value: Value,
}

/// A value that has been read.
#[derive(Clone, Debug)]
pub enum Value {
    /// A text.
    Text(String),
    /// Texts.
    Texts(Vec<String>),
    /// True or false.
    Flag(bool),
    /// One of several words.
    Choice(Word),
    /// In SI.
    Number(f64),
    /// In SI.
    Vector(Vec2),
    /// In metres.
    Outline(Vec<Vec2>),
    /// In SI; the first of each row rises.
    Curve(Vec<(f64, f64)>),
    /// A name.
    Name(String),
    /// Two names.
    TwoNames([String; 2]),
    /// A table.
    Table(Table),
    /// Tables by name.
    Named(Vec<(String, Table)>),
    /// A list of tables.
    List(Vec<Table>),
}

impl Table {
    /// The dotted path of an item of the table.
    pub fn path_to(&self, item: &Item) -> String {
        key_path::join(&self.path, item.name)
    }

    /// The table as a table with the keys `T`, for code that looks its keys up.
    ///
    /// # Panics
    /// In a debug build, if the table is declared with a key that is not of `T`.
    pub fn of<T: TableKeys>(&self) -> Of<'_, T> {
        debug_assert!(are_among(self.spec.keys, T::KEYS), "{} has other keys", self.spec.what);
        Of { table: self, of: PhantomData }
    }
}

impl Item {
    /// Whether the item is of this key.
    pub fn is<T, V>(&self, key: Key<T, V>) -> bool {
        self.name == key.name()
    }

    /// The item as the entry of a key.
    ///
    /// # Panics
    /// If the item is of another key.
    pub fn entry<T, V>(&self, key: Key<T, V>) -> Entry<'_, V> {
        assert!(self.is(key), "{} is not {key}", self.name);
        Entry { item: self, of: PhantomData }
    }
}

/// A table with the keys `T`.
pub struct Of<'t, T> {
    table: &'t Table,
    of: PhantomData<fn() -> T>,
}

impl<'t, T> Of<'t, T> {
    /// The dotted path of one of the table's keys.
    pub fn path_of<V>(self, key: Key<T, V>) -> String {
        key_path::join(&self.table.path, key.name())
    }

    /// The key, if the file gives the key or the key has a default.
    pub fn item<V>(self, key: Key<T, V>) -> Option<Entry<'t, V>> {
        debug_assert!(self.has(key), "{} has no key {key}", self.spec.what);
        self.item_if_any(key)
    }

    /// The first of some keys that the file gives or that has a default.
    pub fn first_of(self, keys: &[AnyKey<T>]) -> Option<Entry<'t, Anything>> {
        keys.iter().find_map(|key| self.item(*key))
    }

    /// A key that is always present: the reader refuses its absence or fills in its default.
    pub fn given<V>(self, key: Key<T, V>) -> Entry<'t, V> {
        self.item(key).unwrap_or_else(|| unreachable!("{} without {key}", self.spec.what))
    }

    /// The key, if this kind of table has the key, and the file gives the key or the key has a default.
    pub fn item_if_any<V>(self, key: Key<T, V>) -> Option<Entry<'t, V>> {
        let item = self.table.items.iter().find(|item| item.is(key));
        item.map(|item| Entry { item, of: PhantomData })
    }

    /// The number of a key that only some kinds of table have.
    pub fn number_if_any(self, key: Key<T, Number>) -> Option<f64> {
        self.item_if_any(key).map(|item| *item.number())
    }

    /// Whether this kind of table has the key.
    pub fn has<V>(self, key: Key<T, V>) -> bool {
        self.table.spec.key(key.name()).is_some()
    }

    /// The same table, for code that reads several kinds of table.
    pub fn read_as<R>(self) -> Of<'t, R>
    where
        T: ReadAs<R>,
    {
        Of { table: self.table, of: PhantomData }
    }

    /// The dotted path of an entry of the table.
    pub fn path_to<V>(self, entry: Entry<'_, V>) -> String {
        self.table.path_to(entry.item)
    }

    /// Every entry, whatever it holds.
    pub fn entries(self) -> impl Iterator<Item = Entry<'t, Anything>> {
        self.table.items.iter().map(|item| Entry { item, of: PhantomData })
    }

    /// The same table, for code that does not look keys up.
    pub fn any(self) -> Of<'t, Anything> {
        Of { table: self.table, of: PhantomData }
    }

    /// The table itself.
    pub fn table(self) -> &'t Table {
        self.table
    }
}

/// The value of a key, a `V`, with its place in the file.
pub struct Entry<'t, V> {
    item: &'t Item,
    of: PhantomData<fn() -> V>,
}

impl<'t, V> Entry<'t, V> {
    /// The item itself.
    pub fn item(self) -> &'t Item {
        self.item
    }

    /// The same without the type of the value.
    pub fn any(self) -> Entry<'t, Anything> {
        Entry { item: self.item, of: PhantomData }
    }
}

/// Tables with the keys `T`, by name.
pub struct Tables<'t, T> {
    tables: &'t [(String, Table)],
    of: PhantomData<fn() -> T>,
}

impl<'t, T> Tables<'t, T> {
    /// How many there are.
    pub fn len(self) -> usize {
        self.tables.len()
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.tables.is_empty()
    }

    /// The table at an index.
    ///
    /// # Panics
    /// If there are not so many.
    pub fn at(self, index: usize) -> Of<'t, T> {
        Of { table: &self.tables[index].1, of: PhantomData }
    }

    /// Copies, for tables that are made from these.
    pub fn to_vec(self) -> Vec<(String, Table)> {
        self.tables.to_vec()
    }

    /// Each table with its name, in the order of the file.
    pub fn iter(self) -> EachNamed<'t, T> {
        self.into_iter()
    }
}

/// Iterates over tables with their names.
pub type EachNamed<'t, T> =
    Map<slice::Iter<'t, (String, Table)>, fn(&'t (String, Table)) -> (&'t String, Of<'t, T>)>;

impl<'t, T> IntoIterator for Tables<'t, T> {
    type Item = (&'t String, Of<'t, T>);
    type IntoIter = EachNamed<'t, T>;

    fn into_iter(self) -> EachNamed<'t, T> {
        self.tables.iter().map(|(name, table)| (name, Of { table, of: PhantomData }))
    }
}

impl<'t, T: TableKeys> From<&'t [(String, Table)]> for Tables<'t, T> {
    /// Tables that were made from others.
    fn from(tables: &'t [(String, Table)]) -> Self {
        for (_, table) in tables {
            let _ = table.of::<T>();
        }
        Tables { tables, of: PhantomData }
    }
}

/// A list of tables with the keys `T`.
pub struct List<'t, T> {
    tables: &'t [Table],
    of: PhantomData<fn() -> T>,
}

impl<'t, T> List<'t, T> {
    /// How many there are.
    pub fn len(self) -> usize {
        self.tables.len()
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.tables.is_empty()
    }

    /// The table at an index.
    ///
    /// # Panics
    /// If there are not so many.
    pub fn at(self, index: usize) -> Of<'t, T> {
        Of { table: &self.tables[index], of: PhantomData }
    }

    /// Each table, in the order of the file.
    pub fn iter(self) -> Each<'t, T> {
        self.into_iter()
    }
}

/// Iterates over the tables of a list.
pub type Each<'t, T> = Map<slice::Iter<'t, Table>, fn(&'t Table) -> Of<'t, T>>;

impl<'t, T> IntoIterator for List<'t, T> {
    type Item = Of<'t, T>;
    type IntoIter = Each<'t, T>;

    fn into_iter(self) -> Each<'t, T> {
        self.tables.iter().map(|table| Of { table, of: PhantomData })
    }
}

macro_rules! views {
    ($($view:ident: $target:ty, $field:ident;)*) => {
        $(
            impl<T> Clone for $view<'_, T> {
                fn clone(&self) -> Self {
                    *self
                }
            }

            impl<T> Copy for $view<'_, T> {}

            impl<T> Deref for $view<'_, T> {
                type Target = $target;

                fn deref(&self) -> &$target {
                    self.$field
                }
            }

            impl<T> fmt::Debug for $view<'_, T> {
                fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                    self.$field.fmt(f)
                }
            }
        )*
    };
}

views! {
    Of: Table, table;
    Entry: Item, item;
}

macro_rules! lists {
    ($($view:ident;)*) => {
        $(
            impl<T> Clone for $view<'_, T> {
                fn clone(&self) -> Self {
                    *self
                }
            }

            impl<T> Copy for $view<'_, T> {}

            impl<T> Default for $view<'_, T> {
                fn default() -> Self {
                    $view { tables: &[], of: PhantomData }
                }
            }

            impl<T> fmt::Debug for $view<'_, T> {
                fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                    self.tables.fmt(f)
                }
            }
        )*
    };
}

lists! {
    Tables;
    List;
}

impl<C: Copy + 'static> Entry<'_, OneOf<C>> {
    /// What the word stands for.
    pub fn choice(self) -> C {
        match &self.item.value {
            Value::Choice(word) => word.value(),
            other => unreachable!("{} holds {other:?}", self.name),
        }
    }
}

impl<C> Entry<'_, OneOf<C>> {
    /// The word.
    pub fn word(self) -> &'static str {
        match &self.item.value {
            Value::Choice(word) => word.word,
            other => unreachable!("{} holds {other:?}", self.name),
        }
    }
}

macro_rules! getters {
    ($($(#[$doc:meta])* $method:ident: $held:ident is $variant:ident -> $type:ty;)*) => {
        $(
            impl<'t> Entry<'t, $held> {
                $(#[$doc])*
                pub fn $method(self) -> &'t $type {
                    match &self.item.value {
                        Value::$variant(value) => value,
                        other => unreachable!("{} holds {other:?}", self.name),
                    }
                }
            }
        )*
    };
}

getters! {
    /// The text.
    text: Text is Text -> str;
    /// The texts.
    texts: Texts is Texts -> [String];
    /// The flag.
    flag: Flag is Flag -> bool;
    /// The number in SI.
    number: Number is Number -> f64;
    /// Both numbers in SI.
    vector: Vector is Vector -> Vec2;
    /// The points in metres.
    outline: Points is Outline -> [Vec2];
    /// The rows in SI.
    curve: Curve is Curve -> [(f64, f64)];
    /// The name.
    name: Name is Name -> str;
    /// Both names.
    two_names: TwoNames is TwoNames -> [String; 2];
}

impl<'t, T> Entry<'t, TableOf<T>> {
    /// The table.
    pub fn table(self) -> Of<'t, T> {
        match &self.item.value {
            Value::Table(table) => Of { table, of: PhantomData },
            other => unreachable!("{} holds {other:?}", self.name),
        }
    }
}

impl<'t, T> Entry<'t, NamedOf<T>> {
    /// The tables by name.
    pub fn named(self) -> Tables<'t, T> {
        match &self.item.value {
            Value::Named(tables) => Tables { tables, of: PhantomData },
            other => unreachable!("{} holds {other:?}", self.name),
        }
    }
}

impl<'t, T> Entry<'t, ListOf<T>> {
    /// The list.
    pub fn list(self) -> List<'t, T> {
        match &self.item.value {
            Value::List(tables) => List { tables, of: PhantomData },
            other => unreachable!("{} holds {other:?}", self.name),
        }
    }
}
