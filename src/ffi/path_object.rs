//! The object shown with a path.

use std::ffi::c_int;

use super::border::border;
use super::object::{thread_mesh, wireframe};
use super::path::{edit_by, read};
use super::pointers::GrowingOut;
use super::scene_types::V_MESH;
use super::status::V_ERR_INTERNAL;
use super::types::V_PATH;
use crate::document::Edit;

/// Sets the object shown with a path; NULL: none. The window draws its lines and the
/// edges of its triangles; beyond 1,000,000 points of lines, only points where they
/// end or bend. v_path_check() uses the triangles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_object(path: *mut V_PATH, object: *const V_MESH) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a mesh, as the header says.
        let object = unsafe { wireframe(object, "object") }?;
        edit_by(path, |document| {
            let mut info = document.info().clone();
            info.object = object;
            Ok(Edit::SetInfo(Box::new(info)))
        })
    })
}

/// Gets the object shown with a path, 0 points without one. The arrays are valid
/// until the same thread's next call of this function.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_object(path: *const V_PATH, mesh: *mut V_MESH) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a struct as its size says, as the header demands.
        let out = unsafe { GrowingOut::new(mesh, "mesh") }?;
        let object = read(path, |document| Ok(document.info().object.clone()))?;
        let mesh = thread_mesh(object)?;
        // SAFETY: as above.
        unsafe { out.answer(mesh) }
    })
}
