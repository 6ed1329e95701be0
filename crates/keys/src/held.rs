//! Types that say what kind of value a key holds. The declaration of a key in [`table_keys!`](crate::table_keys) states
//! the type of the key's value, and the compiler compares this type with the [`Kind`] of the key.

use core::marker::PhantomData;

use crate::spec::{KeySpec, Kind, TableKeys};

/// A type that says what kind of value a key holds.
pub trait Held {
    /// The variant of [`Value`](crate::checked::Value) in which the reader stores the value of such a key.
    const VARIANT: Variant;
    /// If the value is a table or tables: the keys of these tables.
    const TABLE: Option<&'static [KeySpec]> = None;
}

/// A variant of [`Value`](crate::checked::Value).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Variant {
    Text,
    Texts,
    Flag,
    Choice,
    Number,
    NameOrNumber,
    Vector,
    Outline,
    Curve,
    Name,
    TwoNames,
    Table,
    Named,
    List,
}

impl Kind {
    /// The variant of [`Value`](crate::checked::Value) that values of this kind of key have.
    pub const fn variant(&self) -> Variant {
        match self {
            Kind::Text | Kind::FileName | Kind::AnyNumber => Variant::Text,
            Kind::Texts | Kind::FileNames | Kind::Values => Variant::Texts,
            Kind::Flag => Variant::Flag,
            Kind::Choice(_) => Variant::Choice,
            Kind::Quantity(_) => Variant::Number,
            Kind::NameOr(_) => Variant::NameOrNumber,
            Kind::Vector(_) | Kind::Point(_) => Variant::Vector,
            Kind::Outline(_) | Kind::Points(..) => Variant::Outline,
            Kind::Curve(_) => Variant::Curve,
            Kind::MaterialName | Kind::BodyName => Variant::Name,
            Kind::TwoBodyNames => Variant::TwoNames,
            Kind::Table(_) => Variant::Table,
            Kind::Named(_) => Variant::Named,
            Kind::List(_) => Variant::List,
        }
    }

    /// The keys of the tables that a key of this kind holds; `None` if the kind holds no table.
    pub const fn table(&self) -> Option<&'static [KeySpec]> {
        match self {
            Kind::Table(spec) | Kind::Named(spec) | Kind::List(spec) => Some(spec.keys),
            _ => None,
        }
    }
}

macro_rules! held {
    ($($(#[$doc:meta])* $name:ident: $variant:ident;)*) => {
        $(
            $(#[$doc])*
            #[derive(Debug)]
            pub enum $name {}

            impl Held for $name {
                const VARIANT: Variant = Variant::$variant;
            }
        )*
    };
}

held! {
    /// A text.
    Text: Text;
    /// A list of texts.
    Texts: Texts;
    /// `true` or `false`.
    Flag: Flag;
    /// A number in SI.
    Number: Number;
    /// A name, or a number in SI.
    NameOr: NameOrNumber;
    /// Two numbers in SI.
    Vector: Vector;
    /// Points in metres.
    Points: Outline;
    /// Rows of two numbers in SI.
    Curve: Curve;
    /// A name of a body or a material.
    Name: Name;
    /// Two names of bodies.
    TwoNames: TwoNames;
}

/// One of several words, each of which stands for a value of type `C`.
#[derive(Debug)]
pub struct OneOf<C>(PhantomData<fn() -> C>);

/// A table with the keys `T`.
#[derive(Debug)]
pub struct TableOf<T>(PhantomData<fn() -> T>);

/// Tables with the keys `T`, by name.
#[derive(Debug)]
pub struct NamedOf<T>(PhantomData<fn() -> T>);

/// A list of tables with the keys `T`.
#[derive(Debug)]
pub struct ListOf<T>(PhantomData<fn() -> T>);

impl<C> Held for OneOf<C> {
    const VARIANT: Variant = Variant::Choice;
}

impl<T: TableKeys> Held for TableOf<T> {
    const VARIANT: Variant = Variant::Table;
    const TABLE: Option<&'static [KeySpec]> = Some(T::KEYS);
}

impl<T: TableKeys> Held for NamedOf<T> {
    const VARIANT: Variant = Variant::Named;
    const TABLE: Option<&'static [KeySpec]> = Some(T::KEYS);
}

impl<T: TableKeys> Held for ListOf<T> {
    const VARIANT: Variant = Variant::List;
    const TABLE: Option<&'static [KeySpec]> = Some(T::KEYS);
}
