//! Checks of the host's pointers before use: NULL and alignment. For what cannot be checked (the
//! size of the memory, no concurrent writes) the header makes the host responsible.
//!
//! Each check is given the name that the header gives to what it checks, for the sentence.

use std::ffi::{CStr, OsStr, c_char, c_int};
use std::mem::MaybeUninit;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::ptr;

use glam::DVec3;

use super::status::{Answer, Failure, Name, V_OK};

pub(super) fn check<T>(pointer: *const T, name: impl Into<Name>) -> Answer<()> {
    if pointer.is_null() {
        return Err(Failure::Null(name.into()));
    }
    if !pointer.is_aligned() {
        return Err(Failure::Unaligned(name.into()));
    }
    Ok(())
}

/// Copies what the host points to, since inputs and outputs may overlap.
///
/// # Safety
/// `pointer` is NULL or points to a readable `T`.
pub(super) unsafe fn read<T: Copy>(pointer: *const T, name: &'static str) -> Answer<T> {
    check(pointer, name)?;
    // SAFETY: not NULL, aligned, and else as required of the caller.
    Ok(unsafe { pointer.read() })
}

/// As [`read`], for an array given by its first element.
///
/// # Safety
/// `pointer` is NULL or points to `N` readable elements.
pub(super) unsafe fn read_array<T: Copy, const N: usize>(
    pointer: *const T,
    name: &'static str,
) -> Answer<[T; N]> {
    // SAFETY: as required of the caller; an array has its elements' alignment.
    unsafe { read(pointer.cast::<[T; N]>(), name) }
}

/// Three coordinates.
///
/// # Safety
/// `xyz` is NULL or points to three readable doubles.
pub(super) unsafe fn read_vector(xyz: *const f64, name: &'static str) -> Answer<DVec3> {
    // SAFETY: as required of the caller.
    Ok(DVec3::from_array(unsafe { read_array(xyz, name) }?))
}

/// As [`read`], with `None` for NULL.
///
/// # Safety
/// `pointer` is NULL or points to a readable `T`.
pub(super) unsafe fn read_optional<T: Copy>(
    pointer: *const T,
    name: &'static str,
) -> Answer<Option<T>> {
    // SAFETY: as required of the caller.
    optional(pointer, |pointer| unsafe { read(pointer, name) })
}

/// What `read` makes of a pointer; `None` for NULL.
pub(super) fn optional<T, R>(
    pointer: *const T,
    read: impl FnOnce(*const T) -> Answer<R>,
) -> Answer<Option<R>> {
    (!pointer.is_null()).then(|| read(pointer)).transpose()
}

/// Borrows `count` elements during the call.
///
/// # Safety
/// `pointer` is NULL or points to `count` readable elements, not written during `'a`.
pub(super) unsafe fn slice<'a, T>(
    pointer: *const T,
    count: usize,
    name: impl Into<Name>,
) -> Answer<&'a [T]> {
    let name = name.into();
    check(pointer, name)?;
    check_extent::<T>(count, name)?;
    // SAFETY: not NULL, aligned, not larger than an object can be, and else as required.
    Ok(unsafe { std::slice::from_raw_parts(pointer, count) })
}

/// Borrows `count` elements for writing.
///
/// # Safety
/// `pointer` is NULL or points to `count` writable elements, not used by others during `'a`. Any
/// bit pattern is a valid `T`.
pub(super) unsafe fn slice_mut<'a, T>(
    pointer: *mut T,
    count: usize,
    name: impl Into<Name>,
) -> Answer<&'a mut [T]> {
    let name = name.into();
    check(pointer, name)?;
    check_extent::<T>(count, name)?;
    // SAFETY: as in `slice`.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, count) })
}

/// No object is larger than `isize::MAX` bytes.
fn check_extent<T>(count: usize, name: Name) -> Answer<()> {
    match count.checked_mul(size_of::<T>()) {
        Some(bytes) if isize::try_from(bytes).is_ok() => Ok(()),
        _ => Err(Failure::NoSuchCount { name, count }),
    }
}

/// The destination of a result: checked before the work, written after it, so that a failed call
/// writes nothing.
#[derive(Clone, Copy)]
pub(super) struct Out<T>(*mut T);

impl<T: Copy> Out<T> {
    /// A required result.
    pub(super) fn new(pointer: *mut T, name: &'static str) -> Answer<Self> {
        check(pointer, name)?;
        Ok(Self(pointer))
    }

    /// An optional result; NULL if unwanted.
    pub(super) fn optional(pointer: *mut T, name: &'static str) -> Answer<Self> {
        if pointer.is_null() {
            return Ok(Self(pointer));
        }
        Self::new(pointer, name)
    }

    /// Writes the result, if it is wanted.
    ///
    /// # Safety
    /// The pointer is NULL or points to memory for a `T`.
    pub(super) unsafe fn write(self, value: T) {
        if !self.0.is_null() {
            // SAFETY: not NULL, aligned, and else as required of the caller.
            unsafe { self.0.write(value) };
        }
    }

    /// Writes the only result of a call.
    ///
    /// # Safety
    /// As for [`Self::write`].
    pub(super) unsafe fn answer(self, value: T) -> Answer<c_int> {
        // SAFETY: as required of the caller.
        unsafe { self.write(value) };
        Ok(V_OK)
    }
}

impl<T: Copy, const N: usize> Out<[T; N]> {
    /// A required array, given by its first element.
    pub(super) fn array(pointer: *mut T, name: &'static str) -> Answer<Self> {
        Self::new(pointer.cast(), name)
    }

    /// An optional array; NULL if unwanted.
    pub(super) fn optional_array(pointer: *mut T, name: &'static str) -> Answer<Self> {
        Self::optional(pointer.cast(), name)
    }
}

/// The destination of an array: the host's memory, and the number of elements.
pub(super) struct ArrayOut<T> {
    array: *mut T,
    capacity: usize,
    count: Out<usize>,
    name: &'static str,
}

impl<T: Copy> ArrayOut<T> {
    /// A NULL array with capacity 0 only asks for the count.
    pub(super) fn new(
        array: *mut T,
        capacity: usize,
        count: *mut usize,
        [name, count_name]: [&'static str; 2],
    ) -> Answer<Self> {
        let count = Out::new(count, count_name)?;
        if !array.is_null() || capacity != 0 {
            check(array, name)?;
        }
        Ok(Self {
            array,
            capacity,
            count,
            name,
        })
    }

    /// Also the count may be unwanted, and a NULL array have any capacity.
    pub(super) fn optional(
        array: *mut T,
        capacity: usize,
        count: *mut usize,
        [name, count_name]: [&'static str; 2],
    ) -> Answer<Self> {
        let count = Out::optional(count, count_name)?;
        Out::optional(array, name)?;
        Ok(Self {
            array,
            capacity,
            count,
            name,
        })
    }

    /// Whether the elements are wanted. If there is too little room for `count`, writes that.
    ///
    /// # Safety
    /// There is room for the count.
    pub(super) unsafe fn wants(&self, count: usize) -> Answer<bool> {
        let wants = !self.array.is_null();
        if wants && count > self.capacity {
            // SAFETY: as required of the caller.
            unsafe { self.count.write(count) };
            return Err(Failure::NoRoom {
                name: self.name,
                room: self.capacity,
                needed: count,
            });
        }
        Ok(wants)
    }

    /// The room for elements that are wanted.
    ///
    /// # Safety
    /// As for [`slice_mut`], with the capacity.
    pub(super) unsafe fn room<'a>(&self, count: usize) -> Answer<&'a mut [T]> {
        // SAFETY: as required of the caller.
        unsafe { slice_mut(self.array, count, self.name) }
    }

    /// Writes the count, after the elements.
    ///
    /// # Safety
    /// There is room for it.
    pub(super) unsafe fn answer(self, count: usize) -> Answer<c_int> {
        // SAFETY: as required of the caller.
        unsafe { self.count.answer(count) }
    }
}

/// The destination of a text: the host's buffer, and the text's length.
pub(super) struct TextOut {
    buffer: *mut c_char,
    capacity: usize,
    length: Out<usize>,
    name: &'static str,
}

impl TextOut {
    /// A NULL buffer with capacity 0 only asks for the length.
    pub(super) fn new(
        buffer: *mut c_char,
        capacity: usize,
        length: *mut usize,
        name: &'static str,
    ) -> Answer<Self> {
        let length = Out::new(length, "length")?;
        if !buffer.is_null() || capacity != 0 {
            check(buffer, name)?;
        }
        Ok(Self {
            buffer,
            capacity,
            length,
            name,
        })
    }

    /// Writes the text with a terminating zero, and its length without it.
    ///
    /// # Safety
    /// The buffer is NULL or has `capacity` bytes; there is room for the length.
    pub(super) unsafe fn write(self, text: &[u8]) -> Answer<c_int> {
        let fits = text.len() < self.capacity;
        // SAFETY: as required of the caller; text and zero fit.
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
        Err(Failure::NoRoom {
            name: self.name,
            room: self.capacity,
            needed: text.len() + 1,
        })
    }
}

/// A host's UTF-8 text.
///
/// # Safety
/// `text` is NULL or points to a zero-terminated text, unchanged during `'a`.
pub(super) unsafe fn text<'a>(text: *const c_char, name: &'static str) -> Answer<&'a str> {
    // SAFETY: as required of the caller.
    std::str::from_utf8(unsafe { bytes(text, name) }?).map_err(|_| Failure::NotUtf8(name))
}

/// Copies a host's text, with `None` for NULL.
///
/// # Safety
/// `text` is NULL or points to a zero-terminated text.
pub(super) unsafe fn optional_text(
    text: *const c_char,
    name: &'static str,
) -> Answer<Option<String>> {
    // SAFETY: as required of the caller.
    optional(text, |text| copied(unsafe { self::text(text, name) }?))
}

/// Copies a text, which may be long; fails with `ErrorKind::Memory`.
pub(super) fn copied(text: &str) -> Answer<String> {
    let mut copy = String::new();
    copy.try_reserve_exact(text.len())?;
    copy.push_str(text);
    Ok(copy)
}

/// A file name, whose bytes may have any encoding.
///
/// # Safety
/// `file` is NULL or points to a zero-terminated text, unchanged during `'a`.
pub(super) unsafe fn file_name<'a>(file: *const c_char, name: &'static str) -> Answer<&'a Path> {
    // SAFETY: as required of the caller.
    Ok(Path::new(OsStr::from_bytes(unsafe { bytes(file, name) }?)))
}

/// The bytes of a text.
///
/// # Safety
/// `text` is NULL or points to a zero-terminated text, unchanged during `'a`.
pub(super) unsafe fn bytes<'a>(text: *const c_char, name: &'static str) -> Answer<&'a [u8]> {
    check(text, name)?;
    // SAFETY: not NULL, and else as required of the caller.
    Ok(unsafe { CStr::from_ptr(text) }.to_bytes())
}

/// Converts an index, which must not be negative.
pub(super) fn index(given: c_int, name: &'static str) -> Answer<usize> {
    usize::try_from(given).map_err(|_| Failure::NegativeIndex { name, given })
}

/// Converts a count, which must not be negative.
pub(super) fn how_many(given: c_int, name: &'static str) -> Answer<usize> {
    usize::try_from(given).map_err(|_| Failure::NegativeCount { name, given })
}

/// The one of a list that has a number.
pub(super) fn numbered<T: Copy>(
    all: &[T],
    number: c_int,
    name: &'static str,
    known: &'static str,
) -> Answer<T> {
    let found = usize::try_from(number).ok().and_then(|at| all.get(at));
    found
        .copied()
        .ok_or_else(|| Failure::unknown(name, number, known))
}

/// Refuses a count that is too large.
pub(super) fn most(given: usize, limit: usize, name: impl Into<Name>) -> Answer<()> {
    if given > limit {
        let name = name.into();
        return Err(Failure::TooMany { name, given, limit });
    }
    Ok(())
}

/// The most bytes of a text in memory, those of a file.
#[allow(clippy::cast_possible_truncation)] // below 2³²
pub(super) const MAX_TEXT: usize = crate::limits::MAX_FILE_BYTES as usize;

/// Converts a count for C. The limits of a path keep every count below `INT_MAX`.
pub(super) fn count(value: usize) -> Answer<c_int> {
    c_int::try_from(value).map_err(|_| Failure::range("a count is too large for an int"))
}

/// A struct that begins with its size and may grow at its end within version 1.
///
/// # Safety
/// The type is `repr(C)`, its first field is `size: usize`, and any bits are valid for the fields
/// up to `FIRST`, zeroes for all.
pub(super) unsafe trait Growing: Copy {
    /// Its name in the header.
    const NAME: &'static str;
    /// Its `sizeof` in version 1.0, all that a caller without a size has. A field of a later
    /// version makes it the offset of that field.
    const FIRST: usize;
    /// Values for fields the host does not know.
    // SAFETY: zeroes are valid for all fields.
    const DEFAULTS: Self = unsafe { MaybeUninit::zeroed().assume_init() };
}

/// The size in a host's struct, which tells the fields the host knows. One below that of version
/// 1.0 was never set; a larger one is from a newer header, or garbage. Both are refused.
///
/// # Safety
/// `pointer` is NULL or points to a struct that begins with its size.
unsafe fn size_of_host<T: Growing>(pointer: *const T, name: &'static str) -> Answer<usize> {
    check(pointer, name)?;
    // SAFETY: not NULL, aligned, and every version begins with `size`.
    let size = unsafe { pointer.cast::<usize>().read() };
    if (T::FIRST..=size_of::<T>()).contains(&size) && size.is_multiple_of(align_of::<T>()) {
        return Ok(size);
    }
    Err(wrong_size::<T>(Name::Field(name, "size"), size))
}

fn wrong_size<T: Growing>(name: Name, size: usize) -> Failure {
    Failure::Size {
        name,
        size,
        of: T::NAME,
        wanted: size_of::<T>(),
    }
}

/// Fills in a host's struct of `size` bytes, as far as both sides know it. One that is shorter
/// than that of version 1.0 has no room for it. Callers without a size, from version 1.0, pass
/// 1.0's size.
///
/// # Safety
/// `pointer` is NULL or points to `size` bytes for a struct of that version.
pub(super) unsafe fn init<T: Growing>(
    pointer: *mut T,
    value: T,
    size: usize,
    name: &'static str,
) -> Answer<()> {
    check(pointer, name)?;
    if size < T::FIRST {
        return Err(wrong_size::<T>("size".into(), size));
    }
    let size = size.min(size_of::<T>());
    // SAFETY: as required of the caller.
    unsafe { GrowingOut { pointer, size }.write(value) };
    Ok(())
}

/// Reads a struct of a host perhaps compiled with an earlier 1.x; unknown fields get defaults.
///
/// # Safety
/// `pointer` is NULL or points to a struct as its `size` says.
pub(super) unsafe fn read_growing<T: Growing>(pointer: *const T, name: &'static str) -> Answer<T> {
    // SAFETY: as required of the caller.
    let size = unsafe { size_of_host(pointer, name) }?;
    let mut value = T::DEFAULTS;
    // SAFETY: `size` bytes are there, and fit into a `T`, whose fields take them.
    unsafe { ptr::copy_nonoverlapping(pointer.cast::<u8>(), (&raw mut value).cast(), size) };
    Ok(value)
}

/// The destination of a struct of which the host may know only the first fields.
pub(super) struct GrowingOut<T> {
    pointer: *mut T,
    size: usize,
}

impl<T: Growing> GrowingOut<T> {
    /// # Safety
    /// `pointer` is NULL or points to a struct as its `size` says.
    pub(super) unsafe fn new(pointer: *mut T, name: &'static str) -> Answer<Self> {
        // SAFETY: as required of the caller.
        let size = unsafe { size_of_host(pointer, name) }?;
        Ok(Self { pointer, size })
    }

    /// Writes the fields the host knows; its size stays.
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

    /// Writes the only result of a call.
    ///
    /// # Safety
    /// As for [`Self::new`], still.
    pub(super) unsafe fn answer(self, value: T) -> Answer<c_int> {
        // SAFETY: as required of the caller.
        unsafe { self.write(value) };
        Ok(V_OK)
    }
}
