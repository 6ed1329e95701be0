//! A scenario's tables after reading: every key is known, every value has its kind, is in SI and within its bounds, and
//! defaults are filled in. The getters panic if the code asks for a key or kind that the key table does not have.

use fenderline_contact::Vec2;

use crate::choices::Word;
use crate::key_path;
use crate::place::Span;
use crate::spec::TableSpec;

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
    /// The dotted path of one of the table's keys.
    pub fn path_of(&self, name: &str) -> String {
        key_path::join(&self.path, name)
    }

    /// The key, if the file gives the key or the key has a default.
    pub fn item(&self, name: &str) -> Option<&Item> {
        debug_assert!(self.spec.key(name).is_some(), "{} has no key {name}", self.spec.what);
        self.items.iter().find(|item| item.name == name)
    }

    /// The number of a key that only some kinds of table have.
    pub fn number_if_any(&self, name: &str) -> Option<f64> {
        self.item_if_any(name).map(|item| *item.number())
    }

    /// The key, if this kind of table has the key, and the file gives the key or the key has a default.
    pub fn item_if_any(&self, name: &str) -> Option<&Item> {
        self.items.iter().find(|item| item.name == name)
    }

    /// A key that is always present: the reader refuses its absence or fills in its default.
    pub fn given(&self, name: &str) -> &Item {
        self.item(name).unwrap_or_else(|| unreachable!("{} without {name}", self.spec.what))
    }
}

impl Item {
    /// The word of a key of the kind Choice.
    pub fn word(&self) -> &'static str {
        match &self.value {
            Value::Choice(word) => word.word,
            other => unreachable!("{} holds {other:?}", self.name),
        }
    }

    /// What the word of a key of the kind Choice stands for.
    pub fn choice<T: Copy + 'static>(&self) -> T {
        match &self.value {
            Value::Choice(word) => word.value(),
            other => unreachable!("{} holds {other:?}", self.name),
        }
    }
}

macro_rules! getters {
    ($($method:ident: $variant:ident -> $type:ty;)*) => {
        impl Item {
            $(
                #[doc = concat!("The value of a key of the kind ", stringify!($variant), ".")]
                pub fn $method(&self) -> &$type {
                    match &self.value {
                        Value::$variant(value) => value,
                        other => unreachable!("{} holds {other:?}", self.name),
                    }
                }
            )*
        }
    };
}

getters! {
    text: Text -> str;
    texts: Texts -> [String];
    flag: Flag -> bool;
    number: Number -> f64;
    vector: Vector -> Vec2;
    outline: Outline -> [Vec2];
    curve: Curve -> [(f64, f64)];
    name: Name -> str;
    two_names: TwoNames -> [String; 2];
    table: Table -> Table;
    named: Named -> [(String, Table)];
    list: List -> [Table];
}
