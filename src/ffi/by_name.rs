//! Properties by name: what paths and scenes have in common.

use std::ffi::{c_char, c_int};

use super::border::border;
use super::pointers::{ArrayOut, MAX_TEXT, Out, TextOut, most, slice, text};
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use crate::document::{self, Given};

/// What a call by name answers: a failure says the name, and counts as that does, from 1.
pub(super) fn named<T>(result: document::Result<T>) -> Answer<T> {
    result.map_err(Failure::of_property)
}

/// Sets the property of a name.
///
/// # Safety
/// `name` is NULL or points to a zero-terminated text.
pub(super) unsafe fn set<'a>(
    name: *const c_char,
    given: impl FnOnce() -> Answer<Given<'a>>,
    set: impl FnOnce(&str, Given<'a>) -> Answer<()>,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: as required of the caller.
        set(unsafe { text(name, "name") }?, given()?)?;
        Ok(V_OK)
    })
}

/// Numbers for a property from the host, or NULL.
///
/// # Safety
/// As for [`slice()`].
pub(super) unsafe fn numbers_given<'a>(values: *const f64, count: usize) -> Answer<Given<'a>> {
    match count {
        0 => Ok(Given::Numbers(&[])),
        // SAFETY: as required of the caller.
        _ => Ok(Given::Numbers(unsafe { slice(values, count, "values") }?)),
    }
}

/// A text of the host's for a property, of a length that a file can have.
///
/// # Safety
/// `value` is NULL or points to a zero-terminated text, unchanged during `'a`.
pub(super) unsafe fn text_given<'a>(value: *const c_char) -> Answer<Given<'a>> {
    // SAFETY: as required of the caller.
    let value = unsafe { text(value, "value") }?;
    most(value.len(), MAX_TEXT, "the length of value")?;
    Ok(Given::Text(value))
}

/// Gets the property of a name.
///
/// # Safety
/// As for [`set`]; `value` is NULL, or there is room for a value.
pub(super) unsafe fn get<T: Copy>(
    name: *const c_char,
    value: *mut T,
    of: impl FnOnce(&str) -> Answer<T>,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(value, "value")?;
        // SAFETY: as required of the caller.
        unsafe { out.answer(of(text(name, "name")?)?) }
    })
}

/// Gets several numbers.
///
/// # Safety
/// As for [`set`]; there is room for that many numbers, and for their count.
pub(super) unsafe fn get_numbers(
    name: *const c_char,
    values: *mut f64,
    capacity: usize,
    count: *mut usize,
    of: impl FnOnce(&str) -> Answer<Vec<f64>>,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = ArrayOut::new(values, capacity, count, ["values", "count"])?;
        // SAFETY: as required of the caller.
        unsafe {
            let numbers = of(text(name, "name")?)?;
            if out.wants(numbers.len())? {
                out.room(numbers.len())?.copy_from_slice(&numbers);
            }
            out.answer(numbers.len())
        }
    })
}

/// Gets a text.
///
/// # Safety
/// As for [`set`]; there is room for that many bytes, and for their number.
pub(super) unsafe fn get_text(
    name: *const c_char,
    value: *mut c_char,
    capacity: usize,
    length: *mut usize,
    of: impl FnOnce(&str) -> Answer<String>,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(value, capacity, length, "value")?;
        // SAFETY: as required of the caller.
        unsafe { out.write(of(text(name, "name")?)?.as_bytes()) }
    })
}

/// The functions that the exports for one kind of handle pass on.
macro_rules! by_name {
    ($handle:ty, $held:ty, $read:path, $change:path) => {
        fn setter<'a>(
            handle: *mut $handle,
        ) -> impl FnOnce(&str, Given<'a>) -> $crate::ffi::status::Answer<()> {
            move |name, given| {
                $change(handle, |held| {
                    $crate::ffi::by_name::named(held.set_value(name, given))
                })
            }
        }

        fn getter<T>(
            handle: *const $handle,
            of: impl FnOnce(&$held, &str) -> $crate::document::Result<T>,
        ) -> impl FnOnce(&str) -> $crate::ffi::status::Answer<T> {
            move |name| $read(handle, |held| $crate::ffi::by_name::named(of(held, name)))
        }

        fn number(held: &$held, name: &str) -> $crate::document::Result<f64> {
            Ok(held.number_of(name)?.unwrap_or(f64::NAN))
        }

        fn flag(held: &$held, name: &str) -> $crate::document::Result<c_int> {
            held.flag_of(name).map(c_int::from)
        }
    };
}
pub(super) use by_name;
