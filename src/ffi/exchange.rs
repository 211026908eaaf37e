//! Scenes in files of other programs.

use std::ffi::{c_char, c_int};

use super::border::border;
use super::pointers::{Out, file_name, optional_text};
use super::scene_handles::{self, insert};
use super::scene_types::V_SCENE;
use super::status::{Answer, V_ERR_INTERNAL, V_OK, add_last_warning, clear_last_warning};
use crate::formats::{self, Format, Options, Report, Source};

/// Writes a scene in the format of another program: gltf, glb, usda, blender,
/// paraview, vtk, nerfstudio, transforms, cameras, tum, kitti, colmap (a folder), osg, chan,
/// html, ascii, csv, json or vid; format NULL: the one that the file's name tells. options are
/// lines name=value ("fps=30\nnode=camera"), NULL: none; the names are node, frames, fps, start,
/// size, up, scale, as, tolerance, angle, compact, digits and rotation-order, as `vides convert
/// --help` explains them; of two alike the last counts, and one that a format has no use for is
/// ignored. Each file is afterwards wholly the old or wholly the new one; a missing folder is made
/// only for colmap, in one that is there.
///
/// What the format cannot hold is left out: the answer is V_OK, and v_last_warning()
/// tells, a line each, "" if nothing is.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY, V_ERR_ARGUMENT (format,
/// options, no such node, a host interpolation that fails), V_ERR_RANGE (frames, fps), V_ERR_FORMAT
/// (a folder that holds what would be read first), V_ERR_IO, V_ERR_LIMIT, V_ERR_MEMORY.
/// Memory that runs out while a file is opened or written may end the program; the old file
/// stays.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_export(
    scene: *const V_SCENE,
    file: *const c_char,
    format: *const c_char,
    options: *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        clear_last_warning();
        // SAFETY: texts ended by zero, or NULL where it may be, as the header says.
        let (file, (format, options)) =
            unsafe { (file_name(file, "file")?, choices(format, options)?) };
        let format = match format {
            Some(format) => format,
            None => formats::by_target(file)?,
        };
        scene_handles::read(scene, |document| {
            let report = formats::export(document, file, format, &options, &mut |_, _| {})?;
            tell(&report, &[]);
            Ok(V_OK)
        })
    })
}

/// Reads the file of another program, or a folder of COLMAP's, as a scene: one of gltf, glb,
/// usda, nerfstudio, transforms, cameras, tum, kitti, colmap, osg, chan, paraview (what
/// v_scene_export() wrote; nothing is run), ascii, csv, json and vid; format NULL: the one that
/// the content shows. options as of v_scene_export(). Poses become a path of few points, fitted,
/// or with "as=keys", or fewer than three, a camera with a key for each. *scene is the caller's, to be freed
/// with v_scene_free().
///
/// What is not taken, and how well a path fits, is told by v_last_warning() beside V_OK, a line
/// each, "" if there is nothing to tell.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT (format, options), V_ERR_IO,
/// V_ERR_FORMAT (with place and reason in v_last_error()), V_ERR_RANGE, V_ERR_LIMIT,
/// V_ERR_MEMORY. Memory that runs out while the file is parsed may end the program.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_import(
    file: *const c_char,
    format: *const c_char,
    options: *const c_char,
    scene: *mut *mut V_SCENE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        clear_last_warning();
        let out = Out::new(scene, "scene")?;
        // SAFETY: texts ended by zero, or NULL where it may be, as the header says.
        let (file, (format, options)) =
            unsafe { (file_name(file, "file")?, choices(format, options)?) };
        let imported = formats::import(&Source::open(file)?, format, &options)?;
        tell(&imported.report, imported.document.warnings());
        let made = insert(imported.document)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// # Safety
/// Each is NULL or points to a text ended by zero.
unsafe fn choices(
    format: *const c_char,
    options: *const c_char,
) -> Answer<(Option<&'static Format>, Options)> {
    // SAFETY: as required of the caller.
    let (format, options) = unsafe {
        (
            optional_text(format, "format")?,
            optional_text(options, "options")?,
        )
    };
    let format = format.as_deref().map(formats::by_name).transpose()?;
    Ok((format, Options::parse(options.as_deref().unwrap_or(""))?))
}

/// A line for each loss, and for each mesh with which something is wrong.
fn tell(report: &Report, meshes: &[crate::Error]) {
    clear_last_warning();
    let losses = report.losses().iter().map(|loss| format!("{loss}."));
    let lines = losses.chain(meshes.iter().map(|warning| format!("{warning}.")));
    add_last_warning(format_args!("{}", lines.collect::<Vec<_>>().join("\n")));
}
