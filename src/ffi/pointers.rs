//! The host's pointers: looked at before they are followed.
//!
//! What can be seen of a bad pointer is seen here: NULL, and an address that
//! is not aligned for its type. That the rest of what it promises holds (it
//! points to as much memory as the header says, and nobody else writes there
//! meanwhile) is the host's part, and the header says so.

use std::ffi::{CStr, OsStr, c_char, c_int};
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::ptr;

use glam::DVec3;

use super::status::{Answer, Failure, V_ERR_ARGUMENT, V_ERR_NULL, V_ERR_RANGE, V_ERR_SIZE, V_OK};

const NULL: Failure = Failure::Border(V_ERR_NULL, "a pointer is NULL that must not be");
const UNALIGNED: Failure = Failure::Border(
    V_ERR_ARGUMENT,
    "a pointer is not aligned for what it points to",
);

/// Refuses NULL and unaligned addresses.
pub(super) fn check<T>(pointer: *const T) -> Answer<()> {
    if pointer.is_null() {
        return Err(NULL);
    }
    if !pointer.is_aligned() {
        return Err(UNALIGNED);
    }
    Ok(())
}

/// A copy of what the host points to: inputs and outputs may overlap.
///
/// # Safety
/// A pointer that is not NULL points to a `T` that can be read.
pub(super) unsafe fn read<T: Copy>(pointer: *const T) -> Answer<T> {
    check(pointer)?;
    // SAFETY: not NULL, aligned, and the caller's word for the rest.
    Ok(unsafe { pointer.read() })
}

/// As [`read`] for an array given by its first element, as C does.
///
/// # Safety
/// A pointer that is not NULL points to `N` elements that can be read.
pub(super) unsafe fn read_array<T: Copy, const N: usize>(pointer: *const T) -> Answer<[T; N]> {
    // SAFETY: the caller's word; an array is aligned as its elements are.
    unsafe { read(pointer.cast::<[T; N]>()) }
}

/// Three coordinates.
///
/// # Safety
/// A pointer that is not NULL points to three doubles that can be read.
pub(super) unsafe fn read_vector(xyz: *const f64) -> Answer<DVec3> {
    // SAFETY: the caller's word.
    Ok(DVec3::from_array(unsafe { read_array(xyz) }?))
}

/// As [`read`], with NULL for nothing.
///
/// # Safety
/// A pointer that is not NULL points to a `T` that can be read.
pub(super) unsafe fn read_optional<T: Copy>(pointer: *const T) -> Answer<Option<T>> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: the caller's word.
    unsafe { read(pointer) }.map(Some)
}

/// `count` elements, seen as a slice while the call lasts.
///
/// # Safety
/// A pointer that is not NULL points to `count` elements that can be read and
/// are not written while `'a` lasts.
pub(super) unsafe fn slice<'a, T>(pointer: *const T, count: usize) -> Answer<&'a [T]> {
    check(pointer)?;
    check_extent::<T>(count)?;
    // SAFETY: not NULL, aligned, no larger than memory can be, and the
    // caller's word for the rest.
    Ok(unsafe { std::slice::from_raw_parts(pointer, count) })
}

/// `count` elements to be written.
///
/// # Safety
/// A pointer that is not NULL points to `count` elements that can be written
/// and are used by nobody else while `'a` lasts. Every bit pattern that may
/// stand there now is a valid `T`.
pub(super) unsafe fn slice_mut<'a, T>(pointer: *mut T, count: usize) -> Answer<&'a mut [T]> {
    check(pointer)?;
    check_extent::<T>(count)?;
    // SAFETY: as in `slice`.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, count) })
}

/// No object is larger than half of the address space.
fn check_extent<T>(count: usize) -> Answer<()> {
    match count.checked_mul(size_of::<T>()) {
        Some(bytes) if isize::try_from(bytes).is_ok() => Ok(()),
        _ => Err(Failure::Border(V_ERR_RANGE, "a count is impossibly large")),
    }
}

/// Where a result goes. Made before the work, written after it: a call that
/// fails has written nothing but the size that an array needs.
#[derive(Clone, Copy)]
pub(super) struct Out<T>(*mut T);

impl<T: Copy> Out<T> {
    /// A result that must be wanted.
    pub(super) fn new(pointer: *mut T) -> Answer<Self> {
        check(pointer)?;
        Ok(Self(pointer))
    }

    /// A result that may be unwanted (NULL).
    pub(super) fn optional(pointer: *mut T) -> Answer<Self> {
        if pointer.is_null() {
            return Ok(Self(pointer));
        }
        Self::new(pointer)
    }

    /// Writes the result, if it is wanted.
    ///
    /// # Safety
    /// A pointer that is not NULL points to memory for a `T`.
    pub(super) unsafe fn write(self, value: T) {
        if !self.0.is_null() {
            // SAFETY: not NULL, aligned, and the caller's word for the rest.
            unsafe { self.0.write(value) };
        }
    }
}

impl<T: Copy, const N: usize> Out<[T; N]> {
    /// A result array given by its first element, as C does.
    pub(super) fn array(pointer: *mut T) -> Answer<Self> {
        Self::new(pointer.cast())
    }

    /// The same, that may be unwanted (NULL).
    pub(super) fn optional_array(pointer: *mut T) -> Answer<Self> {
        Self::optional(pointer.cast())
    }
}

/// Where a text goes: an array of the caller's, and how long the text is.
pub(super) struct TextOut {
    buffer: *mut c_char,
    capacity: usize,
    length: Out<usize>,
}

impl TextOut {
    /// A buffer that is NULL with a capacity of 0 only asks for the length.
    pub(super) fn new(buffer: *mut c_char, capacity: usize, length: *mut usize) -> Answer<Self> {
        let length = Out::new(length)?;
        if !buffer.is_null() || capacity != 0 {
            check(buffer)?;
        }
        Ok(Self {
            buffer,
            capacity,
            length,
        })
    }

    /// Writes the text, ended by zero, and its length without the zero.
    ///
    /// # Safety
    /// The buffer is NULL or has `capacity` bytes; there is room for the length.
    pub(super) unsafe fn write(self, text: &[u8]) -> Answer<c_int> {
        let fits = text.len() < self.capacity;
        // SAFETY: the caller's word; text and zero fit.
        unsafe {
            if fits {
                let buffer = self.buffer.cast::<u8>();
                ptr::copy_nonoverlapping(text.as_ptr(), buffer, text.len());
                buffer.add(text.len()).write(0);
            }
            self.length.write(text.len());
        }
        if fits || self.buffer.is_null() {
            return Ok(V_OK);
        }
        Err(Failure::Border(
            V_ERR_SIZE,
            "the array is too small for the text; the length tells how long it is",
        ))
    }
}

/// A text of the host's.
///
/// # Safety
/// A pointer that is not NULL points to a text ended by a zero byte that
/// stays as it is while `'a` lasts.
pub(super) unsafe fn text<'a>(text: *const c_char, not_utf8: &'static str) -> Answer<&'a str> {
    check(text)?;
    // SAFETY: not NULL, and the caller's word for the rest.
    let text = unsafe { CStr::from_ptr(text) };
    text.to_str()
        .map_err(|_| Failure::Border(V_ERR_ARGUMENT, not_utf8))
}

/// A file's name: the bytes as they are, whatever their encoding.
///
/// # Safety
/// A pointer that is not NULL points to a text ended by a zero byte that
/// stays as it is while `'a` lasts.
pub(super) unsafe fn file_name<'a>(file: *const c_char) -> Answer<&'a Path> {
    check(file)?;
    // SAFETY: not NULL, and the caller's word for the rest.
    let text = unsafe { CStr::from_ptr(file) };
    Ok(Path::new(OsStr::from_bytes(text.to_bytes())))
}

/// A short text of C's: a name among some.
///
/// # Safety
/// A pointer that is not NULL points to a text ended by a zero byte that
/// stays as it is while `'a` lasts.
pub(super) unsafe fn name<'a>(text: *const c_char) -> Answer<&'a [u8]> {
    check(text)?;
    // SAFETY: not NULL, and the caller's word for the rest.
    Ok(unsafe { CStr::from_ptr(text) }.to_bytes())
}

/// An index or a number from C, where negative is never right.
pub(super) fn index(value: c_int) -> Answer<usize> {
    usize::try_from(value)
        .map_err(|_| Failure::Border(V_ERR_RANGE, "an index must not be negative"))
}

/// How many of something, where negative is never right.
pub(super) fn how_many(value: c_int) -> Answer<usize> {
    usize::try_from(value).map_err(|_| Failure::Border(V_ERR_RANGE, "a count must not be negative"))
}

/// A number for C. The limits of a path keep every count below `INT_MAX`.
pub(super) fn count(value: usize) -> Answer<c_int> {
    c_int::try_from(value)
        .map_err(|_| Failure::Border(V_ERR_RANGE, "a count is too large for an int"))
}

/// A struct that begins with its size and may grow at its end within version 1.
///
/// # Safety
/// The type is `repr(C)`, its first field is `size: usize`, and any bits are valid
/// for the fields up to `FIRST`.
pub(super) unsafe trait Growing: Copy {
    /// The `sizeof` of version 1.0.
    const FIRST: usize;
    /// What a host means that does not know a field.
    const DEFAULTS: Self;
}

/// The `size` with which a host's struct begins: its `sizeof`, which tells which
/// fields it knows. A smaller one than that of version 1.0 was never set, a larger
/// one belongs to a newer header than the library, or is what happened to stand in
/// memory; either way reading on would be wrong.
///
/// # Safety
/// `pointer` is NULL or points to a struct that begins with its size.
unsafe fn size_of_host<T: Growing>(pointer: *const T) -> Answer<usize> {
    check(pointer)?;
    // SAFETY: not NULL, aligned, and every version begins with `size`.
    let size = unsafe { pointer.cast::<usize>().read() };
    if (T::FIRST..=size_of::<T>()).contains(&size) && size.is_multiple_of(align_of::<T>()) {
        return Ok(size);
    }
    Err(Failure::Border(
        V_ERR_SIZE,
        "the size with which a struct begins is not its sizeof",
    ))
}

/// Fills in a struct of the host's that is `size` long: as far as both know it. The
/// functions of version 1.0 that take no size write what a host of 1.0 has.
///
/// # Safety
/// `pointer` is NULL or points to `size` bytes for a struct of that version.
pub(super) unsafe fn init<T: Growing>(pointer: *mut T, value: T, size: usize) -> Answer<()> {
    check(pointer)?;
    let size = size.clamp(T::FIRST, size_of::<T>());
    // SAFETY: the caller's word.
    unsafe { GrowingOut { pointer, size }.write(value) };
    Ok(())
}

/// A struct of a host that may have been compiled with an earlier 1.x: the fields
/// that it does not know have their defaults.
///
/// # Safety
/// `pointer` is NULL or points to a struct as its `size` says.
pub(super) unsafe fn read_growing<T: Growing>(pointer: *const T) -> Answer<T> {
    // SAFETY: the caller's word.
    let size = unsafe { size_of_host(pointer) }?;
    let mut value = T::DEFAULTS;
    // SAFETY: `size` bytes are there, and fit into a `T`, whose fields take them.
    unsafe { ptr::copy_nonoverlapping(pointer.cast::<u8>(), (&raw mut value).cast(), size) };
    Ok(value)
}

/// Where a struct goes of which the host may know the first fields only.
pub(super) struct GrowingOut<T> {
    pointer: *mut T,
    size: usize,
}

impl<T: Growing> GrowingOut<T> {
    /// # Safety
    /// `pointer` is NULL or points to a struct as its `size` says.
    pub(super) unsafe fn new(pointer: *mut T) -> Answer<Self> {
        // SAFETY: the caller's word.
        let size = unsafe { size_of_host(pointer) }?;
        Ok(Self { pointer, size })
    }

    /// Writes the fields that the host knows; its size stays.
    ///
    /// # Safety
    /// As for [`Self::new`], still.
    pub(super) unsafe fn write(self, value: T) {
        let mut value = value;
        // SAFETY: every version begins with `size`, and `size` bytes are there.
        unsafe {
            (&raw mut value).cast::<usize>().write(self.size);
            ptr::copy_nonoverlapping(
                (&raw const value).cast::<u8>(),
                self.pointer.cast(),
                self.size,
            );
        }
    }
}
