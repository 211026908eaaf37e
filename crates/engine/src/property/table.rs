//! The rows of tables, the macro that declares them with their fields, and what they need of types.

use std::fmt;

use glam::{DQuat, DVec3};

use super::same_bits::SameBits;
use super::value::{Kind, Value};

use crate::error::{Invalid, OutOfRange, Quantity, Result};
use crate::limits::{PRESETS, SPEEDS};
use crate::path::base_frames::BaseFrames;
use crate::path::cube::{Space, Up};
use crate::path::ease::EaseKind;
use crate::path::own_parts::{Tangents, TurningPart, Velocities};
use crate::path::tcb::Tcb;

choices! {
    /// What a property's numbers count.
    pub enum Unit {
        /// Nothing.
        #[default]
        One = "",
        /// Degrees.
        Degrees = "degrees",
        /// Millimetres of focal length.
        Millimetres = "mm",
        /// Frames.
        Frames = "frames",
        /// Lengths of the world.
        Length = "lengths",
    }
}

choices! {
    /// What is recomputed where a property changes, with all that follows from it.
    #[derive(PartialOrd, Ord)]
    pub enum Affects {
        /// Nothing: no pose moves.
        Nothing = "nothing",
        /// Where the camera looks, and its zoom.
        Views = "views",
        /// The frames of sections.
        Frames = "frames",
        /// The curve through the points.
        #[default]
        Curve = "curve",
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
    /// Every copy keeps this.
    Anywhere,
    /// It holds for its place, and is given to other places only where one asks for it.
    IfAsked,
    /// It holds for its place alone.
    Nowhere,
    /// It is copied after this.
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
    /// What is recomputed where it changes.
    pub affects: Affects,
    /// What becomes of it elsewhere.
    pub copied: Copied<F>,
}

impl<F> Row<F> {
    /// A row that allows all, affects all, and is copied anywhere.
    #[must_use]
    pub const fn new(keys: &'static [&'static str]) -> Self {
        Self {
            keys,
            unit: Unit::One,
            check: Check::Any,
            always: false,
            affects: Affects::Curve,
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
    /// What it is: one for each of its keys.
    pub kinds: &'static [Kind],
    /// See [`Row::unit`].
    pub unit: Unit,
    /// The least and the greatest number, if they do not depend on the space.
    pub range: Option<(f64, f64)>,
    /// See [`Row::always`].
    pub always: bool,
    /// See [`Row::affects`].
    pub affects: Affects,
    /// Whether a copy keeps it, and if not, whether it is given to other places
    /// where one asks for it.
    pub copied: [bool; 2],
    /// Its value.
    pub value: fn(&T) -> Value,
    /// Exchanges it for a value; false if that is of another kind, and then it stays.
    pub exchange: fn(&mut T, &mut Value) -> bool,
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

    /// What a key of it stands for.
    #[must_use]
    pub fn kind(&self, key: &str) -> Kind {
        let mut all = self.keys.iter().zip(self.kinds);
        let found = all.find_map(|(known, kind)| (*known == key).then_some(*kind));
        found.unwrap_or(Kind::Nested)
    }

    /// Sets it, rounded if it is a whole number; false if it is no number.
    pub fn set_number(&self, of: &mut T, number: f64) -> bool {
        let mut value = match self.kinds {
            [Kind::Whole] => Value::Whole(number.round() as i64),
            _ => Value::Number(number),
        };
        (self.exchange)(of, &mut value)
    }

    /// The key under which files have a value.
    #[must_use]
    pub fn key_of(&self, value: &Value) -> Option<&'static str> {
        let mut all = self.keys.iter().zip(self.kinds);
        all.find_map(|(key, kind)| kind.has(value).then_some(*key))
    }
}

impl<T> fmt::Debug for Property<T> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.keys.fmt(out)
    }
}

/// A struct of which each field has a row.
pub trait Table: Sized + 'static {
    /// A new one.
    const NEW: Self;
    /// The rows of its fields, in the order of files.
    const PROPERTIES: &'static [Property<Self>];
}

/// The row of a table that has a key.
#[must_use]
pub fn find<T>(table: &'static [Property<T>], key: &str) -> Option<&'static Property<T>> {
    table.iter().find(|row| row.keys.contains(&key))
}

/// A type of fields.
pub trait Stored: SameBits + Clone {
    /// What a property of this type is: one of each of its keys.
    const KINDS: &'static [Kind] = &[Kind::Nested];
    /// Its least and its greatest number, if it has any.
    const RANGE: Option<(f64, f64)> = None;
    /// The value of a field.
    fn value(self) -> Value {
        Value::Unset
    }
    /// A field of a value of its kind.
    fn of(_: Value) -> Option<Self> {
        None
    }
}

/// Types with their own kind of [`Value`].
macro_rules! stored {
    ($($type:ty: $kind:ident;)*) => { $(
        impl Stored for $type {
            const KINDS: &'static [Kind] = &[Kind::$kind];
            fn value(self) -> Value {
                Value::$kind(self)
            }
            fn of(value: Value) -> Option<Self> {
                match value {
                    Value::$kind(value) => Some(value),
                    _ => None,
                }
            }
        }
        impl From<$type> for Value {
            fn from(value: $type) -> Self {
                Self::$kind(value)
            }
        }
    )* };
}

stored! {
    f64: Number;
    bool: Switch;
    String: Text;
    DVec3: Place;
    DQuat: Rotation;
    [f64; 3]: Colour;
    [f64; 2]: Cone;
    [f64; SPEEDS]: Speeds;
    Tcb: Shape;
    [Tcb; PRESETS]: Presets;
    BaseFrames: BaseFrames;
    TurningPart: Turning;
}

/// Whole numbers.
macro_rules! whole {
    ($($type:ty)*) => { $(
        impl Stored for $type {
            const KINDS: &'static [Kind] = &[Kind::Whole];
            const RANGE: Option<(f64, f64)> = Some((<$type>::MIN as f64, <$type>::MAX as f64));
            fn value(self) -> Value {
                Value::Whole(self.into())
            }
            fn of(value: Value) -> Option<Self> {
                match value {
                    Value::Whole(number) => number.try_into().ok(),
                    _ => None,
                }
            }
        }
    )* };
}

whole! { u32 i32 }

impl From<usize> for Value {
    fn from(number: usize) -> Self {
        Self::Whole(number.try_into().unwrap_or(i64::MAX))
    }
}

/// Two vectors that files name.
macro_rules! pairs {
    ($($type:ty: $one:ident, $other:ident;)*) => { $(
        impl SameBits for $type {
            fn same_bits(&self, other: &Self) -> bool {
                [self.$one, self.$other].same_bits(&[other.$one, other.$other])
            }
        }
        impl Stored for $type {
            const KINDS: &'static [Kind] =
                &[Kind::Pair([stringify!($one), stringify!($other)])];
            fn value(self) -> Value {
                self.into()
            }
            fn of(value: Value) -> Option<Self> {
                match value {
                    Value::Pair(_, [$one, $other]) => Some(Self { $one, $other }),
                    _ => None,
                }
            }
        }
        impl From<$type> for Value {
            fn from(pair: $type) -> Self {
                Self::Pair([stringify!($one), stringify!($other)], [pair.$one, pair.$other])
            }
        }
    )* };
}

pairs! {
    Tangents: before, after;
    Velocities: reach, leave;
}

/// A field that need not be set.
impl<T: Stored> Stored for Option<T> {
    const KINDS: &'static [Kind] = T::KINDS;
    const RANGE: Option<(f64, f64)> = T::RANGE;
    fn value(self) -> Value {
        self.map_or(Value::Unset, T::value)
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Unset => Some(None),
            value => T::of(value).map(Some),
        }
    }
}

impl<T: Into<Self>> From<Option<T>> for Value {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Unset, Into::into)
    }
}

choice! { Up }
choice! { EaseKind }

/// Structures that files write in a special way.
impl<T: SameBits + Clone> Stored for Vec<T> {}

impl Stored for Space {}

impl<F: Stored> Check<F> {
    /// Checks a field.
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`].
    pub fn run(&self, field: &F, space: Space) -> Result<()> {
        let number = || field.clone().value().number().unwrap_or_default();
        match self {
            Self::Any => Ok(()),
            Self::By(check) => check(field, space),
            Self::Finite(name) if !number().is_finite() => Err(Invalid::NotFinite(*name).into()),
            Self::Between(name, low, high) if !(*low..=*high).contains(&number()) => {
                Err(OutOfRange::Between(*name, *low, *high).into())
            }
            Self::UpTo(most, error) if number() > f64::from(*most) => Err(error().into()),
            _ => Ok(()),
        }
    }

    /// The least and the greatest number.
    #[must_use]
    pub const fn range(&self) -> Option<(f64, f64)> {
        match self {
            Self::Between(_, low, high) => Some((*low, *high)),
            Self::UpTo(most, _) => Some((0.0, *most as f64)),
            _ => F::RANGE,
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
            pub const NEW: Self = <Self as $crate::property::table::Table>::NEW;

            /// The rows of its fields, in the order of files.
            pub const PROPERTIES: &'static [$crate::property::table::Property<Self>] =
                <Self as $crate::property::table::Table>::PROPERTIES;
        }

        impl $crate::property::table::Table for $name {
            const NEW: Self = Self { $($field: $new,)* };

            const PROPERTIES: &'static [$crate::property::table::Property<Self>] = &[$({
                const ROW: $crate::property::table::Row<$type> = $row;
                $crate::property::table::Property {
                    keys: ROW.keys,
                    does: concat!($($does),+),
                    kinds: <$type as $crate::property::table::Stored>::KINDS,
                    unit: ROW.unit,
                    range: ROW.check.range(),
                    always: ROW.always,
                    affects: ROW.affects,
                    copied: match ROW.copied {
                        $crate::property::table::Copied::Nowhere => [false, false],
                        $crate::property::table::Copied::IfAsked => [false, true],
                        _ => [true, true],
                    },
                    value: |all| $crate::property::table::Stored::value(all.$field.clone()),
                    exchange: |all, value| {
                        let new = $crate::property::table::Stored::of(std::mem::take(value));
                        let fits = new.is_some();
                        if let Some(new) = new {
                            let old = std::mem::replace(&mut all.$field, new);
                            *value = $crate::property::table::Stored::value(old);
                        }
                        fits
                    },
                    check: |all, space| ROW.check.run(&all.$field, space),
                    same: |a, b| $crate::property::same_bits::SameBits::same_bits(&a.$field, &b.$field),
                    take: |into, from| into.$field.clone_from(&from.$field),
                    for_a_copy: |all| match ROW.copied {
                        $crate::property::table::Copied::Anywhere => {}
                        $crate::property::table::Copied::After(change) => change(&mut all.$field),
                        _ => all.$field = $new,
                    },
                }
            }),*];
        }

        impl $crate::property::same_bits::SameBits for $name {
            fn same_bits(&self, other: &Self) -> bool {
                Self::PROPERTIES.iter().all(|row| (row.same)(self, other))
            }
        }
    };
}

/// Makes an enumeration of [`named!`] a choice in tables.
#[macro_export]
#[doc(hidden)]
macro_rules! choice {
    ($type:ident) => {
        impl $crate::property::same_bits::SameBits for $type {
            fn same_bits(&self, other: &Self) -> bool {
                self == other
            }
        }

        impl $crate::property::table::Stored for $type {
            const KINDS: &'static [$crate::property::value::Kind] =
                &[$crate::property::value::Kind::Choice(Self::NAMES)];
            fn value(self) -> $crate::property::value::Value {
                self.into()
            }
            fn of(value: $crate::property::value::Value) -> Option<Self> {
                match value {
                    $crate::property::value::Value::Choice(name) => Self::named(name),
                    _ => None,
                }
            }
        }

        impl From<$type> for $crate::property::value::Value {
            fn from(one: $type) -> Self {
                Self::Choice(one.name())
            }
        }
    };
}

/// Declares an enumeration with the names of its values in files.
#[macro_export]
#[doc(hidden)]
macro_rules! choices {
    (
        $(#[$about:meta])*
        $seen:vis enum $type:ident $values:tt
    ) => {
        $crate::property::named::named! { $(#[$about])* $seen enum $type $values }
        $crate::property::table::choice! { $type }
    };
}

pub use {choice, choices, properties};
