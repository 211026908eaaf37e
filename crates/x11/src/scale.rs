//! Pixels per point, from the desktop's resolution.

use x11rb::protocol::xproto::ConnectionExt as _;
use x11rb::resource_manager::Database;

use super::connection::Connection;
use crate::error::Result;

/// The maximum length of the resources to read, in units of 4 bytes.
const MAX_UNITS: u32 = 1 << 16;

/// Reads the X resources from the root window; `None` without a reply.
pub(super) fn ask(connection: &Connection) -> Result<Option<Database>> {
    let mut question = Database::GET_RESOURCE_DATABASE;
    question.window = root(connection);
    let answer = connection.answer(connection.get_property(
        false,
        question.window,
        question.property,
        question.type_,
        0,
        MAX_UNITS,
    ))?;
    Ok(answer.map(|answer| Database::new_from_get_property_reply(&answer).unwrap_or_default()))
}

/// The window that holds the resources: the first screen's root, whatever the screen.
pub(super) fn root(connection: &Connection) -> u32 {
    use x11rb::connection::Connection as _;
    connection
        .setup()
        .roots
        .first()
        .map_or(0, |screen| screen.root)
}

/// Pixels per point by the resource `Xft.dpi`; 1 without it.
pub(super) fn of(resources: &Database) -> f32 {
    let dots = resources.get_value("Xft.dpi", "").ok().flatten();
    dots.map_or(1.0, from_dots)
}

/// Scales are quarters from 1 to 4, so that lines stay sharp.
fn from_dots(dots: f32) -> f32 {
    let scale = (dots / 96.0 * 4.0).round() / 4.0;
    if scale.is_finite() {
        scale.clamp(1.0, 4.0)
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_are_quarters_within_bounds() {
        for (dots, scale) in [
            (96.0, 1.0),
            (72.0, 1.0),
            (110.0, 1.25),
            (120.0, 1.25),
            (144.0, 1.5),
            (192.0, 2.0),
            (1e9, 4.0),
            (-5.0, 1.0),
            (0.0, 1.0),
            (f32::NAN, 1.0),
            (f32::INFINITY, 1.0),
        ] {
            assert_eq!(from_dots(dots), scale, "{dots}");
        }
    }

    #[test]
    fn resources_are_read() {
        let of = |text: &str| of(&Database::new_from_data(text.as_bytes()));
        assert_eq!(
            of("Xcursor.size:\t24\nXft.dpi:\t192\nXft.hinting: 1\n"),
            2.0
        );
        assert_eq!(of("Xfont.dpi: 192\n"), 1.0);
        assert_eq!(of("Xft.dpi: many\n"), 1.0);
        assert_eq!(of(""), 1.0);
    }
}
