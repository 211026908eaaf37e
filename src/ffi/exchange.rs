//! Scenes in files of other programs.

use std::ffi::{c_char, c_int};
use std::fmt;

use super::border::border;
use super::pointers::{Out, file_name, optional_text};
use super::scene_handles::{self, insert};
use super::scene_types::V_SCENE;
use super::status::{Answer, V_ERR_INTERNAL, V_OK, add_last_warning, clear_last_warning};
use crate::formats::{self, Format, Loss, Options, Report, Source};

/// Writes a scene in another program's format. Each file is replaced atomically. A
/// missing folder is created only for colmap, inside an existing one.
///
/// format  gltf, glb, usda, blender, paraview, vtk, nerfstudio, transforms,
///     instant-ngp, cameras, supersplat, tum, euroc, kitti, matrices, open3d, colmap
///     (a folder), osg, chan, html, ascii, csv, json or vid; NULL: by the name of the
///     file
/// options  lines of name=value ("fps=30\nnode=camera"); NULL: none. The names are
///     node, clip, frames, fps, times, start, size, up, scale, as, tolerance, angle,
///     compact, digits and rotation-order; `vides convert --help` explains them.
///
/// v_last_warning() lists what the format cannot hold, one per line.
/// V_ERR_ARGUMENT (also no such node, a host interpolation that fails), V_ERR_FORMAT
/// (a folder that holds what would be read first), V_ERR_IO.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_export(
    scene: *const V_SCENE,
    file: *const c_char,
    format: *const c_char,
    options: *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        clear_last_warning();
        // SAFETY: zero-terminated texts, or NULL where it may be, as the header says.
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

/// Reads another program's file, or a folder of files, as a scene. Poses become a
/// path fitted with few points; with "as=keys", or fewer than three poses, a camera
/// with one key each.
///
/// format  as for v_scene_export(), without blender, vtk and html, and also record3d
///     and polycam; paraview as v_scene_export() writes it, no code is run. NULL: by
///     the content
/// options  as for v_scene_export()
///
/// v_last_warning() lists ignored parts of the file, and how well a path fits.
/// V_ERR_IO, V_ERR_FORMAT.
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
        // SAFETY: zero-terminated texts, or NULL where it may be, as the header says.
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

/// Writes a line for each loss and each mesh with a problem.
fn tell(report: &Report, meshes: &[crate::Error]) {
    clear_last_warning();
    add_last_warning(format_args!("{}", Lines(report.losses(), meshes)));
}

/// Formatted only when the warning is written, which counts from 0 as C does.
struct Lines<'a>(&'a [Loss], &'a [crate::Error]);

impl fmt::Display for Lines<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let losses = self.0.iter().map(|loss| loss as &dyn fmt::Display);
        let meshes = self.1.iter().map(|warning| warning as &dyn fmt::Display);
        for (at, line) in losses.chain(meshes).enumerate() {
            let end = if at == 0 { "" } else { "\n" };
            write!(f, "{end}{line}.")?;
        }
        Ok(())
    }
}
