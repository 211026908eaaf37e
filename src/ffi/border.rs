//! The wrapper around every export's body.

use std::ffi::{c_char, c_int};
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::status::{Answer, clear_last_error, set_last_error};
use crate::error::panic_said;
use crate::inject;

/// An export's return type.
pub(super) trait Returned {
    /// The value that reports a failure with this status.
    fn failed(status: c_int) -> Self;
}

impl Returned for c_int {
    fn failed(status: c_int) -> Self {
        status
    }
}

impl Returned for f64 {
    /// NaN, which no result is; [`super::status::v_last_error`] returns the reason.
    fn failed(_: c_int) -> Self {
        Self::NAN
    }
}

impl Returned for *const c_char {
    /// An empty text; [`super::status::v_last_error`] returns the reason.
    fn failed(_: c_int) -> Self {
        c"".as_ptr()
    }
}

impl Returned for () {
    /// Only [`super::status::v_last_error`] reports the failure.
    fn failed(_: c_int) -> Self {}
}

/// Runs the body of an export: clears the last error, and sets it on failure. A panic must not
/// unwind into C, so this catches it and returns `on_panic`. Unwind safety: only a path or a scene
/// could be left half changed, and its lock is poisoned then.
pub(super) fn border<T: Returned>(on_panic: T, body: impl FnOnce() -> Answer<T>) -> T {
    clear_last_error();
    let body = || {
        inject::point(inject::Place::Call);
        body()
    };
    match catch_unwind(AssertUnwindSafe(body)) {
        Ok(Ok(value)) => value,
        Ok(Err(failure)) => {
            set_last_error(format_args!("{failure}"));
            T::failed(failure.status())
        }
        Err(panic) => {
            let said = panic_said(&*panic);
            set_last_error(format_args!("a fault inside the library: {said}"));
            on_panic
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ffi::status::{Failure, V_ERR_INTERNAL, V_ERR_RANGE, V_OK, v_last_error};
    use std::ffi::CStr;

    fn last() -> &'static str {
        // SAFETY: v_last_error always gives a zero-terminated text.
        let text = unsafe { CStr::from_ptr(v_last_error()) };
        text.to_str().expect("valid UTF-8")
    }

    #[test]
    fn a_panic_stops_at_the_border() {
        assert_eq!(
            border(V_ERR_INTERNAL, || panic!("number {}", 7)),
            V_ERR_INTERNAL
        );
        assert_eq!(last(), "a fault inside the library: number 7");
        assert_eq!(border(V_ERR_INTERNAL, || panic!("plain")), V_ERR_INTERNAL);
        assert_eq!(last(), "a fault inside the library: plain");
        border((), || panic!("nothing to return"));
        assert_eq!(last(), "a fault inside the library: nothing to return");
    }

    #[test]
    fn a_failure_is_told_and_a_success_clears_it() {
        let failed = border(V_ERR_INTERNAL, || Err(Failure::range("too far")));
        assert_eq!((failed, last()), (V_ERR_RANGE, "too far"));
        assert_eq!(border(V_ERR_INTERNAL, || Ok(V_OK)), V_OK);
        assert_eq!(last(), "");
    }
}
