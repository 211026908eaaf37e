//! Scenes: `vides info` of one, and interpolations from shared libraries.

#![allow(unsafe_code)] // functions of a library that the user names

use std::ffi::{CStr, CString, c_int, c_void};
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

use vides::document::SceneDocument;
use vides::scene::host::{self, Question};
use vides::scene::{Extrapolation, Kind, Node};
use vides::shared_list::SharedList;

use super::failure::{Failure, one_line};
use super::info_parts::heading;
use super::input;
use super::table::{Align, Table};

pub(super) fn tables(file: &Path, document: &SceneDocument) -> String {
    let scene = &document.scene;
    let info = &document.info;
    let mut text = heading(info);
    let (first, last) = scene.frame_range();
    // As people count them.
    let seen = |frame: f64| frame + f64::from(info.first_frame) - 1.0;
    let camera = scene.shown_camera().map(|at| &*scene.nodes()[at].name);
    let _ = write!(
        text,
        "File         {}\nScene        {} nodes\nCamera       {}\nFrames       {} to {}\n\
         Time         {:.2} s at {} frames per second\n",
        one_line(&input::name(file)),
        scene.nodes().len(),
        one_line(camera.unwrap_or("none")),
        seen(first),
        seen(last),
        (last - first + 1.0) / info.fps,
        info.fps
    );
    let _ = write!(text, "\nNodes\n{}", nodes(scene.nodes(), &seen));
    let tracks = tracks(scene.nodes(), &seen);
    if scene
        .nodes()
        .iter()
        .any(|node| !node.keys().tracks().is_empty())
    {
        let _ = write!(text, "\nTracks\n{tracks}");
    }
    if !scene.markers().is_empty() {
        let _ = writeln!(text, "\nMarkers");
        let mut table = Table::new(&[
            ("Frame", Align::Right),
            ("Name", Align::Left),
            ("Pinned", Align::Left),
        ]);
        for marker in scene.markers() {
            let pins = scene.pins().iter().filter(|pin| pin.marker == marker.name);
            let pinned = pins.map(|pin| {
                let name = &scene.nodes()[pin.node].name;
                format!("{} {}", one_line(name), pin.point + 1)
            });
            table.row(vec![
                seen(marker.frame).to_string(),
                one_line(&marker.name),
                pinned.collect::<Vec<_>>().join(", "),
            ]);
        }
        let _ = write!(text, "{table}");
    }
    text
}

fn nodes(nodes: &SharedList<Node>, seen: &dyn Fn(f64) -> f64) -> Table {
    let mut table = Table::new(&[
        ("Name", Align::Left),
        ("Kind", Align::Left),
        ("Parent", Align::Left),
        ("Moves by", Align::Left),
        ("Aims at", Align::Left),
        ("Mesh", Align::Left),
    ]);
    let name = |at: Option<usize>| at.map_or(String::new(), |at| one_line(&nodes[at].name));
    for node in nodes {
        let motion = match (node.path(), node.keys().tracks().len()) {
            (Some(path), _) => format!(
                "path, {} points, from {}",
                path.path().points.len(),
                seen(path.start_frame())
            ),
            (None, 0) => String::new(),
            (None, 1) => "1 track".to_owned(),
            (None, tracks) => format!("{tracks} tracks"),
        };
        let mesh = match &node.kind {
            Kind::Object(object) => {
                let mesh = object.mesh();
                let mut parts = Vec::new();
                for (count, what) in [
                    (mesh.points.len(), "points"),
                    (mesh.lines.len(), "lines"),
                    (mesh.triangles.len(), "triangles"),
                    (object.shapes().len(), "shapes"),
                    (object.deformations().len(), "deformations"),
                ] {
                    if count > 0 {
                        parts.push(format!("{count} {what}"));
                    }
                }
                parts.join(", ")
            }
            _ => String::new(),
        };
        table.row(vec![
            one_line(&node.name),
            node.kind.name().to_owned(),
            name(node.parent),
            motion,
            name(node.aim),
            mesh,
        ]);
    }
    table
}

fn tracks(nodes: &SharedList<Node>, seen: &dyn Fn(f64) -> f64) -> Table {
    let mut table = Table::new(&[
        ("Node", Align::Left),
        ("Channel", Align::Left),
        ("Interpolation", Align::Left),
        ("Keys", Align::Right),
        ("First", Align::Right),
        ("Last", Align::Right),
        ("After", Align::Left),
    ]);
    for node in nodes {
        for track in node.keys().tracks() {
            let (first, last) = track.ends();
            let after = match track.extrapolation().1 {
                Extrapolation::Hold => "",
                other => other.name(),
            };
            table.row(vec![
                one_line(&node.name),
                one_line(&track.channel().to_string()),
                one_line(&track.interpolation().to_string()),
                track.frames().len().to_string(),
                seen(first).to_string(),
                seen(last).to_string(),
                after.to_owned(),
            ]);
        }
    }
    table
}

/// A function of the type `V_INTERPOLATE` in `libvides.h`; returns 0 on success.
type Interpolate =
    unsafe extern "C" fn(*const f64, *const f64, usize, usize, f64, *mut f64, *mut c_void) -> c_int;

/// Registers an interpolation given as `NAME=file.so:symbol`.
pub(super) fn register(text: &str) -> Result<(), Failure> {
    let wrong = || {
        Failure::Usage(format!(
            "--interpolation {}: expected NAME=FILE.so:SYMBOL",
            one_line(text)
        ))
    };
    let (name, place) = text.split_once('=').ok_or_else(wrong)?;
    let (file, symbol) = place.rsplit_once(':').ok_or_else(wrong)?;
    if name.is_empty() || file.is_empty() || symbol.is_empty() {
        return Err(wrong());
    }
    // Without a slash dlopen would search the system's folders.
    let file = if file.contains('/') {
        file.to_owned()
    } else {
        format!("./{file}")
    };
    let (file, symbol) = CString::new(file)
        .ok()
        .zip(CString::new(symbol).ok())
        .ok_or_else(wrong)?;
    // SAFETY: NUL-terminated strings; the user wants the library's constructors run; it stays open.
    let function = unsafe {
        let library = libc::dlopen(file.as_ptr(), libc::RTLD_NOW | libc::RTLD_LOCAL);
        if library.is_null() {
            return Err(loader_failed());
        }
        libc::dlsym(library, symbol.as_ptr())
    };
    if function.is_null() {
        return Err(loader_failed());
    }
    // SAFETY: the user asserts that this symbol is such a function.
    let function: Interpolate = unsafe { std::mem::transmute(function) };
    let call = move |question: Question<'_>, value: &mut [f64]| {
        // SAFETY: by the header: `frames.len()` frames and rows of values, and room for one row.
        let status = unsafe {
            function(
                question.frames.as_ptr(),
                question.values.as_ptr(),
                question.width,
                question.frames.len(),
                question.frame,
                value.as_mut_ptr(),
                std::ptr::null_mut(),
            )
        };
        status == 0
    };
    Ok(host::register(name, Some(Arc::new(call))).map_err(vides::Error::from)?)
}

/// The dynamic loader's error message, which names the file.
fn loader_failed() -> Failure {
    // SAFETY: the loader's string is valid until its next call; there is no other thread.
    let said = unsafe {
        let said = libc::dlerror();
        (!said.is_null()).then(|| CStr::from_ptr(said).to_string_lossy().into_owned())
    };
    Failure::Input(said.unwrap_or_else(|| "the library cannot be loaded".to_owned()))
}
