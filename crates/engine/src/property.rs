//! A field is one row. [`properties!`](crate::property::properties) declares a struct and, with
//! each field, its row: what a file calls it, what its numbers count, which are allowed, and what
//! becomes of it in a copy. Range checks, equality bit by bit, copies, the keys of `.vid` files
//! with their sentences, `vides set` and the tables of the documents come of the rows; a field
//! without one does not compile.
//!
//! A structure that files write in a way of their own is nested: its row says the keys and what
//! becomes of copies, its reader and writer stand in the crate `document`.

use std::fmt;
use std::sync::Arc;

use glam::{DQuat, DVec3};

use crate::error::{Invalid, OutOfRange, Quantity, Result};
use crate::limits::SPEEDS;
use crate::path::{Space, Tcb};

/// What a property's numbers count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// Nothing.
    #[default]
    One,
    /// Degrees.
    Degrees,
    /// Millimetres of focal length.
    Millimetres,
    /// Frames.
    Frames,
    /// Lengths of the world.
    Length,
}

impl Unit {
    /// Its name in a table; empty for [`Unit::One`].
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::One => "",
            Self::Degrees => "degrees",
            Self::Millimetres => "mm",
            Self::Frames => "frames",
            Self::Length => "lengths",
        }
    }
}

/// What a property is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A finite number.
    Number,
    /// A whole number from 0.
    Whole,
    /// Yes or no.
    Switch,
    /// The ten speeds of a speed curve.
    Speeds,
    /// Tension, continuity and bias.
    Shape,
    /// A structure that files write in a way of their own.
    Nested,
}

impl fmt::Display for Kind {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Number => "number",
            Self::Whole => "whole number",
            Self::Switch => "switch",
            Self::Speeds => "ten numbers",
            Self::Shape => "tension, continuity, bias",
            Self::Nested => "structure",
        })
    }
}

/// A value on its way into or out of a property that is not nested.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Of [`Kind::Number`].
    Number(f64),
    /// Of [`Kind::Whole`].
    Whole(u32),
    /// Of [`Kind::Switch`].
    Switch(bool),
    /// Of [`Kind::Speeds`].
    Speeds([f64; SPEEDS]),
    /// Of [`Kind::Shape`].
    Shape(Tcb),
}

/// As files have it: TOML with the fewest digits that give the same bits back.
impl fmt::Display for Value {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(out, "{number:?}"),
            Self::Whole(number) => write!(out, "{number}"),
            Self::Switch(switch) => write!(out, "{switch}"),
            Self::Speeds(speeds) => write!(out, "{speeds:?}"),
            Self::Shape(Tcb {
                tension,
                continuity,
                bias,
            }) => write!(
                out,
                "{{ tension = {tension:?}, continuity = {continuity:?}, bias = {bias:?} }}"
            ),
        }
    }
}

/// Which values a field of type `F` may have.
pub enum Check<F> {
    /// Each.
    Any,
    /// Finite numbers; others are refused by this name.
    Finite(Quantity),
    /// Numbers from the one to the other.
    Between(Quantity, f64, f64),
    /// Whole numbers up to this one; greater ones are refused so.
    UpTo(u32, fn() -> OutOfRange),
    /// Those that this accepts in a space.
    By(fn(&F, Space) -> Result<()>),
}

/// What becomes of a field of type `F` elsewhere.
pub enum Copied<F> {
    /// It goes along in every copy.
    Anywhere,
    /// It holds for its place, and is given to other places only where one asks for it.
    IfAsked,
    /// It holds for its place alone.
    Nowhere,
    /// It goes along after this.
    After(fn(&mut F)),
}

/// What is said of a field where it is declared.
pub struct Row<F> {
    /// Its key in files; several if the key says which of several forms follows.
    pub keys: &'static [&'static str],
    /// What its numbers count.
    pub unit: Unit,
    /// Which values it may have.
    pub check: Check<F>,
    /// Whether a file has it even with the value of a new one.
    pub always: bool,
    /// What becomes of it elsewhere.
    pub copied: Copied<F>,
}

impl<F> Row<F> {
    /// A row that allows all, and is copied anywhere.
    #[must_use]
    pub const fn new(keys: &'static [&'static str]) -> Self {
        Self {
            keys,
            unit: Unit::One,
            check: Check::Any,
            always: false,
            copied: Copied::Anywhere,
        }
    }
}

/// A row of a struct `T`.
pub struct Property<T: 'static> {
    /// See [`Row::keys`].
    pub keys: &'static [&'static str],
    /// What it is for: the field's documentation.
    pub does: &'static str,
    /// What it is.
    pub kind: Kind,
    /// See [`Row::unit`].
    pub unit: Unit,
    /// The least and the greatest number, if they do not depend on the space.
    pub range: Option<(f64, f64)>,
    /// See [`Row::always`].
    pub always: bool,
    /// Whether it is given to other places where one asks for it.
    pub travels: bool,
    /// Its value; none if it is nested or not set.
    pub value: fn(&T) -> Option<Value>,
    /// Sets it; does nothing with a value of another kind.
    pub set: fn(&mut T, Value),
    /// Checks it.
    pub check: fn(&T, Space) -> Result<()>,
    /// Whether two have it equal bit by bit: 0 and −0 differ.
    pub same: fn(&T, &T) -> bool,
    /// Gives the first the second's.
    pub take: fn(&mut T, &T),
    /// Makes it what it is in a copy at another place.
    pub for_a_copy: fn(&mut T),
}

impl<T> Property<T> {
    /// Its key in files, if it has but one.
    #[must_use]
    pub const fn key(&self) -> &'static str {
        self.keys[0]
    }
}

/// The row of a table that has a key.
#[must_use]
pub fn find<T>(table: &'static [Property<T>], key: &str) -> Option<&'static Property<T>> {
    table.iter().find(|row| row.keys.contains(&key))
}

/// Equality bit by bit: 0 and −0 differ.
pub trait SameBits {
    /// Whether no bit differs.
    fn same_bits(&self, other: &Self) -> bool;
}

/// A type of fields.
pub trait Stored: SameBits + Sized {
    /// What a property of this type is.
    const KIND: Kind = Kind::Nested;
    /// The value of a field, if it is set and not nested.
    fn value(&self) -> Option<Value> {
        None
    }
    /// A field of a value of its kind.
    fn of(_: Value) -> Option<Self> {
        None
    }
}

macro_rules! stored {
    ($($type:ty: $kind:ident, |$a:ident, $b:ident| $same:expr;)*) => { $(
        impl SameBits for $type {
            fn same_bits(&self, other: &Self) -> bool {
                let ($a, $b) = (self, other);
                $same
            }
        }
        impl Stored for $type {
            const KIND: Kind = Kind::$kind;
            fn value(&self) -> Option<Value> {
                Some(Value::$kind(*self))
            }
            fn of(value: Value) -> Option<Self> {
                match value {
                    Value::$kind(value) => Some(value),
                    _ => None,
                }
            }
        }
    )* };
}

stored! {
    f64: Number, |a, b| a.to_bits() == b.to_bits();
    u32: Whole, |a, b| a == b;
    bool: Switch, |a, b| a == b;
    [f64; SPEEDS]: Speeds, |a, b| a[..].same_bits(&b[..]);
    Tcb: Shape, |a, b| {
        let numbers = |tcb: &Tcb| [tcb.tension, tcb.continuity, tcb.bias];
        numbers(a)[..].same_bits(&numbers(b)[..])
    };
}

/// A field that need not be set.
impl Stored for Option<f64> {
    const KIND: Kind = Kind::Number;
    fn value(&self) -> Option<Value> {
        self.map(Value::Number)
    }
    fn of(value: Value) -> Option<Self> {
        f64::of(value).map(Some)
    }
}

impl<T: SameBits> SameBits for Option<T> {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Some(a), Some(b)) => a.same_bits(b),
            (None, None) => true,
            _ => false,
        }
    }
}

impl<T: SameBits> SameBits for [T] {
    fn same_bits(&self, other: &Self) -> bool {
        self.len() == other.len() && self.iter().zip(other).all(|(a, b)| a.same_bits(b))
    }
}

impl SameBits for [f64; 2] {
    fn same_bits(&self, other: &Self) -> bool {
        self[..].same_bits(&other[..])
    }
}

impl SameBits for DVec3 {
    fn same_bits(&self, other: &Self) -> bool {
        self.to_array()[..].same_bits(&other.to_array()[..])
    }
}

impl SameBits for DQuat {
    fn same_bits(&self, other: &Self) -> bool {
        self.to_array()[..].same_bits(&other.to_array()[..])
    }
}

impl<T: SameBits + ?Sized> SameBits for Arc<T> {
    fn same_bits(&self, other: &Self) -> bool {
        Self::ptr_eq(self, other) || (**self).same_bits(other)
    }
}

impl<F: Stored> Check<F> {
    /// Checks a field.
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`].
    pub fn run(&self, field: &F, space: Space) -> Result<()> {
        match (self, field.value()) {
            (Self::By(check), _) => check(field, space),
            (Self::Finite(name), Some(Value::Number(n))) if !n.is_finite() => {
                Err(Invalid::NotFinite(*name).into())
            }
            (Self::Between(name, low, high), Some(Value::Number(n)))
                if !(*low..=*high).contains(&n) =>
            {
                Err(OutOfRange::Between(*name, *low, *high).into())
            }
            (Self::UpTo(most, error), Some(Value::Whole(n))) if n > *most => Err(error().into()),
            _ => Ok(()),
        }
    }

    /// The least and the greatest number.
    #[must_use]
    pub const fn range(&self) -> Option<(f64, f64)> {
        match self {
            Self::Between(_, low, high) => Some((*low, *high)),
            Self::UpTo(most, _) => Some((0.0, *most as f64)),
            _ => None,
        }
    }
}

/// Declares a struct, its values when it is new, and the row of each field.
#[macro_export]
#[doc(hidden)]
macro_rules! properties {
    (
        $(#[$about:meta])*
        pub struct $name:ident {
            $(
                $(#[doc = $does:literal])+
                pub $field:ident: $type:ty = $new:expr => $row:expr,
            )*
        }
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name {
            $(
                $(#[doc = $does])+
                pub $field: $type,
            )*
        }

        impl $name {
            /// A new one.
            pub(crate) const NEW: Self = Self { $($field: $new,)* };

            /// The rows of its fields, in the order of files.
            pub const PROPERTIES: &'static [$crate::property::Property<Self>] = &[$({
                const ROW: $crate::property::Row<$type> = $row;
                $crate::property::Property {
                    keys: ROW.keys,
                    does: concat!($($does),+),
                    kind: <$type as $crate::property::Stored>::KIND,
                    unit: ROW.unit,
                    range: ROW.check.range(),
                    always: ROW.always,
                    travels: !matches!(ROW.copied, $crate::property::Copied::Nowhere),
                    value: |all| $crate::property::Stored::value(&all.$field),
                    set: |all, value| {
                        if let Some(value) = $crate::property::Stored::of(value) {
                            all.$field = value;
                        }
                    },
                    check: |all, space| ROW.check.run(&all.$field, space),
                    same: |a, b| $crate::property::SameBits::same_bits(&a.$field, &b.$field),
                    take: |into, from| into.$field.clone_from(&from.$field),
                    for_a_copy: |all| match ROW.copied {
                        $crate::property::Copied::Anywhere => {}
                        $crate::property::Copied::After(change) => change(&mut all.$field),
                        _ => all.$field = $new,
                    },
                }
            }),*];
        }

        impl $crate::property::SameBits for $name {
            fn same_bits(&self, other: &Self) -> bool {
                Self::PROPERTIES.iter().all(|row| (row.same)(self, other))
            }
        }
    };
}

pub use properties;

#[cfg(test)]
#[path = "property_tests.rs"]
mod tests;
