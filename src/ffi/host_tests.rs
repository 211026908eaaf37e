//! What a host does, done in Rust, for Miri, which does not run C: whether what
//! is read and written there is anybody's, whose it is, and who else is at it.
//! That the functions do what the header says is tested from C.

use std::mem::MaybeUninit;
use std::ptr::{self, null, null_mut};
use std::thread;

use super::curve::v_path_curve_point;
use super::legacy::v_free_liste;
use super::orientations::{v_orientation_init, v_path_get_orientation, v_path_set_orientation};
use super::path::{v_path_clone, v_path_free, v_path_new};
use super::points::v_path_insert_point;
use super::poses::{v_path_frame_count, v_path_sample, v_path_to_list};
use super::quaternions::v_view_from_quat;
use super::status::{V_ERR_ARGUMENT, V_ERR_HANDLE, V_ERR_NULL, V_ERR_SIZE, V_OK, v_last_error};
use super::types::{V_KAMERAPAR, V_ORIENTATION, V_PATH, V_POSE};

/// Calls what the header promises to take these arguments.
macro_rules! call {
    ($status:ident, $call:expr) => {
        // SAFETY: every pointer is one that the header allows here.
        assert_eq!(unsafe { $call }, $status)
    };
}

/// A path of few poses.
fn path() -> *mut V_PATH {
    let mut path = null_mut();
    call!(V_OK, v_path_new(&raw mut path));
    call!(
        V_OK,
        super::properties::v_path_set_numbers(path, c"base_speeds".as_ptr(), [8.0; 4].as_ptr(), 4)
    );
    path
}

fn free(path: *mut V_PATH) {
    // SAFETY: any handle may be freed.
    unsafe { v_path_free(path) };
}

/// A handle that one thread hands to another.
#[derive(Clone, Copy)]
struct Shared(*mut V_PATH);
// SAFETY: handles may be used on any thread.
unsafe impl Send for Shared {}

#[test]
fn structs_and_arrays_are_the_hosts_from_end_to_end() {
    let path = path();
    // As malloc gives them: nothing has been written there.
    let mut o = MaybeUninit::<V_ORIENTATION>::uninit();
    let mut count = MaybeUninit::<usize>::uninit();
    let mut poses = Box::new([MaybeUninit::<V_POSE>::uninit(); 11]);
    // SAFETY: room for the struct.
    unsafe { v_orientation_init(o.as_mut_ptr()) };
    call!(V_OK, v_path_set_orientation(path, 0, 0, o.as_ptr()));
    call!(V_OK, v_path_get_orientation(path, 1, 0, o.as_mut_ptr()));
    call!(V_OK, v_path_frame_count(path, count.as_mut_ptr()));
    // SAFETY: just written.
    let frames = unsafe { count.assume_init() };
    assert_eq!(frames, 11);
    let first = poses.as_mut_ptr().cast();
    // Into room for one less nothing is written.
    let marks = [7.0_f64; 10 * 10];
    let mut few = Box::new(marks);
    call!(
        V_ERR_SIZE,
        v_path_sample(path, few.as_mut_ptr().cast(), 10, count.as_mut_ptr())
    );
    assert_eq!(*few, marks);
    call!(V_OK, v_path_sample(path, first, frames, count.as_mut_ptr()));
    // SAFETY: all were written.
    let last = unsafe { poses[frames - 1].assume_init() };
    assert_eq!(last.vrp, [0.6, 0.2, 0.8]);
    free(path);
}

#[test]
fn what_goes_in_may_be_what_comes_out() {
    let mut numbers = [0.5, 0.5, 0.5, 0.5, 9.0, 9.0];
    let q = numbers.as_mut_ptr();
    // SAFETY: four numbers are read, three and three are written.
    call!(V_OK, v_view_from_quat(q.cast_const(), q, q.add(3)));
    assert_eq!(numbers, [1.0, 0.0, 0.0, 0.0, 0.0, 1.0].map(|n| n + 0.0));
}

#[test]
fn pointers_that_are_none_are_not_followed() {
    let path = path();
    let mut numbers = [0.0; 4];
    let odd = numbers.as_mut_ptr().wrapping_byte_add(1);
    call!(V_ERR_NULL, v_path_curve_point(path, 0, 0.5, null_mut()));
    call!(V_ERR_ARGUMENT, v_path_curve_point(path, 0, 0.5, odd));
    call!(V_ERR_ARGUMENT, v_path_insert_point(path, 0, odd));
    let mut other = null_mut();
    call!(V_ERR_NULL, v_path_clone(null(), &raw mut other));
    let stale = path;
    free(path);
    let path = self::path(); // perhaps where the other was
    for handle in [
        stale,
        odd.cast(),
        ptr::without_provenance_mut(9),
        (&raw mut numbers).cast(),
    ] {
        call!(V_ERR_HANDLE, v_path_clone(handle, &raw mut other));
        free(handle);
    }
    assert!(other.is_null());
    free(path);
}

/// An element with this number, and nothing else in it.
fn element(number: i32) -> V_KAMERAPAR {
    // SAFETY: numbers and pointers, which may all be zero.
    let zero = unsafe { MaybeUninit::<V_KAMERAPAR>::zeroed().assume_init() };
    V_KAMERAPAR { number, ..zero }
}

#[test]
fn a_list_is_made_and_freed_element_by_element() {
    let path = path();
    let mut head = element(-1);
    let first = &raw mut head;
    for _ in 0..2 {
        call!(V_OK, v_path_to_list(path, first));
    }
    // Forwards and back, as a host goes.
    let mut at = first;
    for number in 1..=11 {
        // SAFETY: an element of the list.
        unsafe {
            assert_eq!(((*at).number, (*(*at).next).prev), (number, at));
            at = (*at).next;
        }
    }
    assert_eq!(at, first);
    // Changed by the host: nothing is freed, until it is as it was.
    // SAFETY: elements of the list.
    unsafe {
        let third = (*(*first).next).next;
        (*third).number = 77;
        v_free_liste(first);
        assert!((*first).number == 1 && *v_last_error() != 0);
        (*third).number = 3;
        v_free_liste(first);
        assert!((*first).number == -1 && *v_last_error() == 0);
        v_free_liste(first);
        assert!((*first).number == -1 && *v_last_error() == 0);
    }
    // Freed by the host itself, and said so: forgotten, not followed.
    call!(V_OK, v_path_to_list(path, first));
    // SAFETY: the elements are malloc's and the host's.
    unsafe {
        let mut at = (*first).next;
        while at != first {
            let next = (*at).next;
            libc::free(at.cast());
            at = next;
        }
        (*first).number = -1;
    }
    call!(V_OK, v_path_to_list(path, first));
    // SAFETY: a list of the library's.
    unsafe { v_free_liste(first) };
    free(path);
}

fn read_until_freed(path: Shared) {
    loop {
        let mut head = element(-1);
        // SAFETY: a handle, be it valid or not, and an element of ours.
        let status = unsafe { v_path_to_list(path.0, &raw mut head) };
        if status == V_ERR_HANDLE {
            break;
        }
        assert_eq!(status, V_OK);
        // SAFETY: a list of the library's.
        unsafe { v_free_liste(&raw mut head) };
    }
}

#[test]
fn threads_share_a_path_that_one_of_them_frees() {
    let shared = Shared(path());
    let readers = [shared; 2].map(|shared| thread::spawn(move || read_until_freed(shared)));
    let place = [0.1, 0.2, 0.3];
    call!(V_OK, v_path_insert_point(shared.0, 1, place.as_ptr()));
    free(shared.0);
    for reader in readers {
        reader.join().expect("no panic");
    }
}
