//! Texts of a C host that are longer than there is memory to copy them: a status, never an end of
//! the program.
#![cfg(feature = "capi")]
// The functions that C calls, called as from C.
#![allow(unsafe_code)]

#[path = "common/counting.rs"]
mod counting;

use std::ffi::{CString, c_char, c_int, c_void};
use std::ptr::null_mut;

use counting::with_at_most;
use vides as _;

unsafe extern "C" {
    fn v_path_new(path: *mut *mut c_void) -> c_int;
    fn v_path_free(path: *mut c_void);
    fn v_path_set_text(path: *mut c_void, name: *const c_char, value: *const c_char) -> c_int;
    fn v_editor_options_init_sized(options: *mut Options, size: usize);
    fn v_editor_open(options: *const Options, editor: *mut *mut c_void) -> c_int;
}

const V_OK: c_int = 0;
const V_ERR_LIMIT: c_int = 6;
const V_ERR_MEMORY: c_int = 7;

const LONG: usize = 8 << 20;

fn long() -> CString {
    CString::new("x".repeat(LONG)).unwrap()
}

#[test]
fn a_text_beyond_its_limit_is_not_copied() {
    let (mut path, long) = (null_mut(), long());
    // SAFETY: room for a handle; a handle and a text ended by zero.
    unsafe {
        assert_eq!(v_path_new(&raw mut path), V_OK);
        for name in [c"title", c"comment"] {
            let set = || v_path_set_text(path, name.as_ptr(), long.as_ptr());
            let status = with_at_most(LONG / 2, set);
            assert_eq!(status, V_ERR_LIMIT);
        }
        v_path_free(path);
    }
}

/// `V_EDITOR_OPTIONS` as far as its title, with room for the others.
#[repr(C)]
struct Options {
    size: usize,
    title: *const c_char,
    others: [usize; 64],
}

#[test]
fn a_title_without_room_for_it_opens_no_window() {
    let long = long();
    let mut editor = null_mut();
    let mut options = Options {
        size: 0,
        title: null_mut(),
        others: [0; 64],
    };
    // SAFETY: room for all options and a handle; a text ended by zero.
    unsafe {
        v_editor_options_init_sized(&raw mut options, size_of::<Options>());
        options.title = long.as_ptr();
        let status = with_at_most(LONG / 2, || {
            v_editor_open(&raw const options, &raw mut editor)
        });
        assert_eq!(status, V_ERR_MEMORY);
    }
}
