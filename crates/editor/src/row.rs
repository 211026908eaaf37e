//! Numbers as the rows of properties have them: which values a field takes, what they count, and
//! the edit that sets it. What a field is called, and where it stands, its panel says.

use vides_document::{Edit, Selection};
use vides_engine::path::{Orientation, OrientationOverrides, Space};
use vides_engine::property::{Kind, Property, Unit, find};
use vides_engine::scene::Channel;

use crate::number::Number;
use crate::state::{Editor, with};
use crate::typed::Quantity;

impl Number<'_> {
    /// A number of a view by its key in files.
    pub(crate) fn of_view(self, key: &str) -> Self {
        if let Some(row) = find(Orientation::PROPERTIES, key) {
            return self.of_row(row);
        }
        match find(OrientationOverrides::PROPERTIES, key) {
            Some(row) => self.of_row(row),
            None => self,
        }
    }

    /// One of the numbers of a node's channel.
    pub(crate) fn of_channel(self, channel: &Channel, space: Space) -> Self {
        let number = match channel {
            Channel::Position => return self.in_space(space),
            Channel::Rotation | Channel::Roll | Channel::Cone => self.counting(Unit::Degrees),
            Channel::Deformation { parameter, .. } if is_angle(parameter) => {
                self.counting(Unit::Degrees)
            }
            Channel::Zoom => self.counting(Unit::Millimetres),
            Channel::Colour | Channel::Intensity => self.decimals(2),
            Channel::AimWeight => self.decimals(2).steps(0.1, 0.005),
            _ => self,
        };
        let (low, high) = channel.range();
        number.range(low..=high)
    }

    fn counting(self, unit: Unit) -> Self {
        match unit {
            Unit::Degrees => self.degrees(),
            Unit::Millimetres => self.decimals(1).steps(1.0, 0.2),
            Unit::Frames => self.quantity(Quantity::Frames).steps(1.0, 0.5),
            Unit::Length => self.quantity(Quantity::Length),
            Unit::One => self,
        }
    }

    /// The number of this property.
    fn of_row<T>(self, row: &Property<T>) -> Self {
        let number = self.counting(row.unit);
        let number = match row.kinds {
            [Kind::Whole] => number.whole(),
            _ => number,
        };
        match row.range {
            Some((low, high)) => number.range(low..=high),
            None => number,
        }
    }
}

/// Whether a deformation's parameter of this name is an angle.
fn is_angle(parameter: &str) -> bool {
    matches!(parameter, "angle" | "phi_min" | "phi_max")
}

impl Editor {
    /// The edit that sets a number of a view by its key in files.
    pub(crate) fn with_number(
        &self,
        at: Selection,
        current: &Orientation,
        key: &str,
        number: f64,
    ) -> Result<Edit, String> {
        if let Some(row) = find(Orientation::PROPERTIES, key) {
            return Ok(with(at, current, |new| _ = row.set_number(new, number)));
        }
        self.with_own(at, current, |own| {
            let row = find(OrientationOverrides::PROPERTIES, key);
            row.map(|row| row.set_number(own, number));
        })
    }
}

#[cfg(test)]
mod tests {
    use vides_engine::property::Table;

    use super::*;

    fn holds<T: Table>(key: &str) -> Option<bool> {
        let mut new = T::NEW;
        let row = find(T::PROPERTIES, key)?;
        Some(row.set_number(&mut new, 7.0) && (row.value)(&new).number() == Some(7.0))
    }

    #[test]
    fn the_panels_fields_are_numbers_of_views() {
        for key in ["hold_frames", "frames", "roll_degrees", "zoom_mm", "ahead"] {
            let held = holds::<Orientation>(key).or_else(|| holds::<OrientationOverrides>(key));
            assert_eq!(held, Some(true), "{key}");
        }
        assert_eq!(holds::<Orientation>("target"), Some(false));
    }
}
