//! The tools of the table, by their names.

use std::cell::RefCell;
use std::ffi::{c_char, c_int};
use std::sync::Arc;

use glam::DVec3;

use super::border::border;
use super::by_name::named;
use super::path::change;
use super::pointers::{Out, index, optional, text};
use super::progress::watched;
use super::scene_handles::edit;
use super::scene_tracks::mesh;
use super::scene_types::{V_MESH, V_SCENE};
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK, add_last_warning, clear_last_warning};
use super::types::V_PATH;
use crate::deform::Bounds;
use crate::document::tool::{Needs, Tool, ToolInput, tools};
use crate::document::{Document, Edit};

thread_local! {
    /// What the last tool reported.
    static NUMBERS: RefCell<Vec<(&'static str, f64)>> = const { RefCell::new(Vec::new()) };
}

/// Those that need nothing but their options and an object.
fn plain() -> impl Iterator<Item = Tool> {
    tools().filter(|tool| tool.needs() == Needs::Nothing)
}

/// ==== Tools: changes of a whole path, checks ====
///
/// Changes a path by a tool, atomically. docs/reference/command.md lists the options
/// of each with their defaults, tools.md and planning.md what they do.
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
/// "tour"     replaces the path by one that shows an object: seconds, coverage, distance,
///            inside, start (without it a closed tour). Reports "coverage", "places",
///            "distance", "length", "seconds". Takes some seconds and 300 bytes per
///            triangle for a million of them. From outside, only the side of the normals
///            counts where neighbouring triangles agree about it
/// "move", "turn", "scale", "mirror"  transform points from first to last
/// "taper", "bulge", "twist", "bend", "free-form"  deform them, in their bounds or in box
///            (two corners)
/// "orbit", "spiral", "arc", "flyby", "approach", "dolly-zoom", "crane", "pan",
/// "figure-eight"  replace the path by a move, or with put=append add it: around or at
///            (the target's position or the camera's), radius, height, distance, width,
///            length, end-radius, end-height, end-distance, headings in degrees (from,
///            to: 0 towards +z, 90 towards +x; with z up +x and +y), turns, rise, tilt,
///            zoom, seconds
///
/// options  lines of name=value ("frames=250\nlast=3", "around=0,1,0"); NULL: none.
///     Points count from 1, from the first to the last by default; 0 and the last
///     stand for the whole path, if closed with the way back to the first
/// object  in the coordinates of the path, for "avoid", "picture" and "tour"; NULL:
///     the path's own
///
/// v_last_warning() returns what was done, v_last_number() the numbers.
/// V_ERR_ARGUMENT (no such tool, no way, too few seconds: v_last_error() names the
/// place or the least), V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_tool(
    path: *mut V_PATH,
    tool: *const c_char,
    options: *const c_char,
    object: *const V_MESH,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { apply(tool, options, object, |work| change(path, work)) }
}

/// Changes the path that a node of a scene follows, like v_path_tool(); its pins
/// hold. object NULL: the objects of the scene at the first pose.
/// V_ERR_ARGUMENT (also a node that follows no path), V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_tool(
    scene: *mut V_SCENE,
    node: c_int,
    tool: *const c_char,
    options: *const c_char,
    object: *const V_MESH,
) -> c_int {
    let change = |work: Work<'_>| {
        let node = index(node, "node")?;
        edit(scene, |document| document.edit_path(node, work))
    };
    // SAFETY: as the header says.
    unsafe { apply(tool, options, object, change) }
}

type Work<'a> = &'a dyn Fn(&mut Document) -> Answer<c_int>;

/// Calls a tool by its name on the document to which `change` gives access.
///
/// # Safety
/// Texts end by zero, and the object is a mesh as its `size` says; each may be NULL.
unsafe fn apply(
    tool: *const c_char,
    options: *const c_char,
    object: *const V_MESH,
    change: impl FnOnce(Work<'_>) -> Answer<c_int>,
) -> c_int {
    clear_last_report();
    border(V_ERR_INTERNAL, || {
        // SAFETY: as required of the caller.
        let name = unsafe { text(tool, "tool") }?;
        // SAFETY: the same.
        let options = optional(options, |options| unsafe { text(options, "options") })?;
        // SAFETY: the same.
        let object = optional(object, |object| unsafe { mesh(object, "object") })?;
        let found = plain().find(|known| known.name == name);
        let tool = found.ok_or_else(|| Failure::NoTool((&name).into()))?;
        change(&|document| {
            let options = named(tool.options(document, options.unwrap_or("")))?;
            let start = options.more("start").map(DVec3::from_slice);
            let input = match (&object, tool.asks_object()) {
                (Some(object), true) => ToolInput::Object(Arc::new(document.solid(Some(object))?)),
                (object, false) if tool.makes_flight() => {
                    let object = object.as_ref().map(|object| Box::new(object.clone()));
                    ToolInput::Tour(object, start)
                }
                _ => ToolInput::None,
            };
            let made =
                watched(|go_on| Ok(tool.edit(document, &input, &options.numbers, go_on)?))?;
            let mut edit = made.edit;
            if let (Some(Edit::DeformPoints { bounds, .. }), Some(corners)) =
                (&mut edit, options.more("box"))
            {
                let [low, high] = [0, 3].map(|at| DVec3::from_slice(&corners[at..]));
                *bounds = Some(Bounds::new(low, high)?);
            }
            if let Some(edit) = edit {
                document.apply(edit)?;
            }
            for line in made.lines.iter().map(ToString::to_string) {
                line.lines()
                    .for_each(|line| add_last_warning(format_args!("{line}")));
            }
            NUMBERS.set(made.numbers);
            Ok(V_OK)
        })
    })
}

/// Forgets what the last tool reported.
pub(super) fn clear_last_report() {
    clear_last_warning();
    NUMBERS.with_borrow_mut(Vec::clear);
}

/// Makes a number that [`v_last_number`] returns.
pub(super) fn report_number(name: &'static str, number: f64) {
    NUMBERS.with_borrow_mut(|all| all.push((name, number)));
}

/// Gets a number that the calling thread's last tool or v_path_fit_poses() reported.
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

#[cfg(test)]
mod tests {
    use crate::tools::moves::MOVES;

    /// The header names the moves of the engine, and all their options.
    #[test]
    fn the_header_lists_the_moves_of_the_engine() {
        let source = include_str!("toolbox.rs");
        let comment = source.split("/// \"orbit\", ").nth(1).unwrap_or_default();
        let comment = comment.split("///\n").next().unwrap_or_default();
        let words = comment.split(|c: char| !c.is_alphanumeric() && c != '-');
        let words: Vec<_> = words.chain(["orbit"]).collect();
        for known in MOVES {
            assert!(words.contains(&known.name), "{}", known.name);
            for parameter in known.parameters {
                assert!(words.contains(&parameter.name), "{}", parameter.name);
            }
        }
    }
}
