//! The tools of the table, by their names.

use std::cell::RefCell;
use std::ffi::{c_char, c_int};
use std::sync::Arc;

use super::border::border;
use super::path::change;
use super::pointers::{Out, optional, text};
use super::progress::watched;
use super::properties::named;
use super::scene_tracks::mesh;
use super::scene_types::V_MESH;
use super::status::{Failure, V_ERR_INTERNAL, V_OK, add_last_warning, clear_last_warning};
use super::types::V_PATH;
use crate::document::tool::{Needs, Tool, ToolInput, tools};

thread_local! {
    /// What the last tool reported.
    static NUMBERS: RefCell<Vec<(&'static str, f64)>> = const { RefCell::new(Vec::new()) };
}

/// Those that need nothing but their options and an object.
fn plain() -> impl Iterator<Item = Tool> {
    tools().filter(|tool| tool.needs() == Needs::Nothing)
}

/// ==== Tools by name ====
///
/// Changes a path by a tool, atomically. docs/reference/tools.md and planning.md describe
/// the tools; they are those of the window and the command.
///
/// "reverse"  the same poses in reverse order
/// "repeat"   count times, each beginning where the last one ended: times
/// "frames"   fixes the frames from the first pose at one point to the last pose at
///            another: frames, first, last. Sections share them by what they take at their
///            speed, at least one each; those with "locked" keep theirs
/// "retime"   speed as fast as the limits of v_path_check() allow, or for a duration with
///            the lowest peaks: seconds, first, last. Reports "seconds"
/// "steady"   stabilises a recorded flight: period in seconds, within. Reports
///            "furthest", "turned"
/// "avoid"    leads a path clear of an object: clearance, radius. Reports "parts",
///            "moved", "inserted", "furthest"
/// "picture"  keeps an object in the picture: margin, what (zoom, distance, view).
///            Reports "added", "tightest", "loosest"
///
/// Also "move", "turn", "scale", "mirror", "taper", "bulge", "twist", "bend", "free-form",
/// and the moves of v_path_from_move() and "tour", which replace the path's points, or with
/// put are inserted after its first one.
///
/// tool  its name
/// options  lines of name=value ("frames=250\nlast=3"), the others have their defaults;
///     NULL: none. Points count from 1, from the first to the last point by default; 0 and
///     the last stand for the whole path, if closed with the way back to the first
/// object  an object in the coordinates of the path, for "avoid" and "picture"; NULL: the
///     path's own. Others ignore it
///
/// v_last_warning() returns lines about what was done, or ""; v_last_number() numbers.
/// V_ERR_ARGUMENT (no such tool or option, a value for it, no way: v_last_error() names
/// the place), V_ERR_RANGE, V_ERR_SIZE, V_ERR_LIMIT, V_ERR_MEMORY, V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_tool(
    path: *mut V_PATH,
    tool: *const c_char,
    options: *const c_char,
    object: *const V_MESH,
) -> c_int {
    clear_last_warning();
    NUMBERS.with_borrow_mut(Vec::clear);
    border(V_ERR_INTERNAL, || {
        // SAFETY: zero-terminated texts, as the header says.
        let name = unsafe { text(tool, "tool") }?;
        // SAFETY: the same.
        let options = optional(options, |options| unsafe { text(options, "options") })?;
        // SAFETY: a mesh, as the header says.
        let object = optional(object, |object| unsafe { mesh(object, "object") })?;
        let found = plain().find(|known| known.name == name);
        let tool = found.ok_or_else(|| Failure::NoTool((&name).into()))?;
        change(path, |document| {
            let input = match object.filter(|_| tool.asks_object()) {
                Some(object) => ToolInput::Object(Arc::new(document.solid(Some(&object))?)),
                None => ToolInput::None,
            };
            let numbers = named(tool.numbers(document, options.unwrap_or("")))?;
            let made = watched(|go_on| Ok(tool.edit(document, &input, &numbers, go_on)?))?;
            if let Some(edit) = made.edit {
                document.apply(edit)?;
            }
            for line in &made.lines {
                add_last_warning(format_args!("{line}"));
            }
            NUMBERS.set(made.numbers);
            Ok(V_OK)
        })
    })
}

/// Gets a number that the calling thread's last v_path_tool() reported, by the name given
/// there.
/// V_ERR_ARGUMENT (no such number).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_last_number(name: *const c_char, value: *mut f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(value, "value")?;
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        let found = NUMBERS.with_borrow(|all| {
            let found = all.iter().find(|(known, _)| *known == name);
            found.map(|(_, number)| *number)
        });
        let number = found.ok_or_else(|| Failure::NoNumber((&name).into()))?;
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer(number) }
    })
}
