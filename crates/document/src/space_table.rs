//! The space of a path or scene as properties, `space.centre` and so on.

use glam::DVec3;
use vides_engine::path::{Space, Up};
use vides_engine::property::table::{Affects, Row, Unit};
use vides_engine::property::{Value, properties};

use crate::error::Result;
use crate::set;

properties! {
    /// The space of a path or scene.
    pub struct SpaceTable {
        /// Centre of the space.
        pub centre: DVec3 = DVec3::ZERO => Row {
            unit: Unit::Length,
            affects: Affects::Nothing,
            ..Row::new(&["centre"])
        },
        /// Half the length of its edge.
        pub half_size: f64 = 1.0 => Row { unit: Unit::Length, ..Row::new(&["half_size"]) },
        /// The axis that is up.
        pub up: Up = Up::Y => Row::new(&["up"]),
    }
}

impl From<Space> for SpaceTable {
    fn from(space: Space) -> Self {
        let Space {
            centre,
            half_size,
            up,
        } = space;
        Self {
            centre,
            half_size,
            up,
        }
    }
}

/// A space with another value of a property; not checked.
///
/// # Errors
/// `ErrorKind::Argument` for a value of another kind.
pub(super) fn changed(space: Space, property: &'static str, mut value: Value) -> Result<Space> {
    let mut table = SpaceTable::from(space);
    set::exchange(&mut table, property, &mut value, &SpaceTable::NEW)?;
    let SpaceTable {
        centre,
        half_size,
        up,
    } = table;
    Ok(Space {
        centre,
        half_size,
        up,
    })
}
