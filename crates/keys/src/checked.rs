//! The tables of a scenario after they were read and checked: every key is known, every value is of the right kind, in
//! SI units and within its bounds, and missing keys have their defaults. Code looks up a key of a table by a constant
//! that [`table_keys!`](crate::table_keys) makes, so the compiler refuses a key that does not exist, a key of another
//! table, and a key whose value is of another type.
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
//! A look-up with a misspelt key does not compile:
//!
//! ```compile_fail,E0599
//! # use fenderline_keys::checked::Table;
//! # use fenderline_keys::keys::anchor::AnchorKey;
//! fn mass_kg(anchor: &Table) -> f64 {
//!     *anchor.of::<AnchorKey>().given(AnchorKey::MAS).number()
//! }
//! ```
//!
//! A look-up with a key of another table does not compile:
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
//! A look-up does not compile if the key holds another kind of value:
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

/// A table of a scenario file after it was read and checked.
#[derive(Clone, Debug)]
pub struct Table {
    /// The declaration of the table: which keys the table may have.
    pub spec: &'static TableSpec,
    /// Dotted path of the table; empty for the whole file.
    pub path: String,
    /// Place in the file of the table's header, or of the whole table if the table is written inline.
    pub span: Span,
    /// The keys of the table with their values, in the order in which the declaration lists the keys.
    pub items: Vec<Item>,
}

/// A key and its value.
#[derive(Clone, Debug)]
pub struct Item {
    /// The name of the key.
    pub name: &'static str,
    /// Place of the key in the file; for a default, the place of the table.
    pub key_span: Span,
    /// Place of the value in the file; for a default, the place of the table.
    pub span: Span,
    /// True if the value is the key's default, because the file does not give the key.
    pub is_default: bool,
    /// The value.
    pub value: Value,
}

/// The value of a key after it was read and checked.
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
    /// A number in SI units.
    Number(f64),
    /// A vector in SI units.
    Vector(Vec2),
    /// The vertices of an outline (m).
    Outline(Vec<Vec2>),
    /// Rows of two numbers in SI units; the first number increases from row to row.
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
    /// Panics in a debug build if the declaration of the table has a key that `T` does not have.
    pub fn of<T: TableKeys>(&self) -> Of<'_, T> {
        debug_assert!(are_among(self.spec.keys, T::KEYS), "{} has other keys", self.spec.what);
        Of { table: self, of: PhantomData }
    }
}

impl Item {
    /// Whether the item is the value of the key `key`.
    pub fn is<T, V>(&self, key: Key<T, V>) -> bool {
        self.name == key.name()
    }

    /// The item as an [`Entry`], whose type says what kind of value the key holds.
    ///
    /// # Panics
    /// Panics if the item belongs to another key than `key`.
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
    /// The dotted path of a key of the table, as in `body.tug.mass`.
    pub fn path_of<V>(self, key: Key<T, V>) -> String {
        key_path::join(&self.table.path, key.name())
    }

    /// The entry of a key; `None` if the file does not give the key and the key has no default.
    pub fn item<V>(self, key: Key<T, V>) -> Option<Entry<'t, V>> {
        debug_assert!(self.has(key), "{} has no key {key}", self.spec.what);
        self.item_if_any(key)
    }

    /// The entry of the first key in the list `keys` that the file gives or that has a default.
    pub fn first_of(self, keys: &[AnyKey<T>]) -> Option<Entry<'t, Anything>> {
        keys.iter().find_map(|key| self.item(*key))
    }

    /// The entry of a key that is always present, because the reader of the file refuses a table without the key or
    /// fills in the key's default.
    pub fn given<V>(self, key: Key<T, V>) -> Entry<'t, V> {
        self.item(key).unwrap_or_else(|| unreachable!("{} without {key}", self.spec.what))
    }

    /// The entry of a key that this kind of table may lack; `None` without the key, or if the file does not give the
    /// key and the key has no default.
    pub fn item_if_any<V>(self, key: Key<T, V>) -> Option<Entry<'t, V>> {
        let item = self.table.items.iter().find(|item| item.is(key));
        item.map(|item| Entry { item, of: PhantomData })
    }

    /// The number under a key that only some kinds of table have; `None` if the table does not hold the key.
    pub fn number_if_any(self, key: Key<T, Number>) -> Option<f64> {
        self.item_if_any(key).map(|item| *item.number())
    }

    /// Whether the declaration of this kind of table has the key `key`.
    pub fn has<V>(self, key: Key<T, V>) -> bool {
        self.table.spec.key(key.name()).is_some()
    }

    /// This table with another type of keys, for code that reads several kinds of table by the keys that these tables
    /// share.
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

    /// Every entry of the table, whatever kind of value the entry holds.
    pub fn entries(self) -> impl Iterator<Item = Entry<'t, Anything>> {
        self.table.items.iter().map(|item| Entry { item, of: PhantomData })
    }

    /// This table without the type of its keys, for code that does not look up keys.
    pub fn any(self) -> Of<'t, Anything> {
        Of { table: self.table, of: PhantomData }
    }

    /// The table itself.
    pub fn table(self) -> &'t Table {
        self.table
    }
}

/// A key's value of type `V`, with the place of the value in the file.
pub struct Entry<'t, V> {
    item: &'t Item,
    of: PhantomData<fn() -> V>,
}

impl<'t, V> Entry<'t, V> {
    /// The item itself.
    pub fn item(self) -> &'t Item {
        self.item
    }

    /// This entry without the type of its value.
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
    /// Number of tables.
    pub fn len(self) -> usize {
        self.tables.len()
    }

    /// Whether there is no table.
    pub fn is_empty(self) -> bool {
        self.tables.is_empty()
    }

    /// The table at the index `index`, from 0.
    ///
    /// # Panics
    /// Panics if `index` is not less than the number of tables.
    pub fn at(self, index: usize) -> Of<'t, T> {
        Of { table: &self.tables[index].1, of: PhantomData }
    }

    /// Copies the tables with their names, for code that makes other tables from them.
    pub fn to_vec(self) -> Vec<(String, Table)> {
        self.tables.to_vec()
    }

    /// Each table with its name, in the order of the file.
    pub fn iter(self) -> EachNamed<'t, T> {
        self.into_iter()
    }
}

/// Iterator over tables with their names.
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
    /// Wraps tables that the program itself made from other tables.
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
    /// Number of tables in the list.
    pub fn len(self) -> usize {
        self.tables.len()
    }

    /// Whether the list has no table.
    pub fn is_empty(self) -> bool {
        self.tables.is_empty()
    }

    /// The table at the index `index` of the list, from 0.
    ///
    /// # Panics
    /// Panics if `index` is not less than the number of tables.
    pub fn at(self, index: usize) -> Of<'t, T> {
        Of { table: &self.tables[index], of: PhantomData }
    }

    /// Each table of the list, in the order of the file.
    pub fn iter(self) -> Each<'t, T> {
        self.into_iter()
    }
}

/// Iterator over the tables of a list.
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
    /// The value of the program for which the word in the file stands.
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
