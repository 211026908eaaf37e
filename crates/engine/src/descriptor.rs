//! Descriptors that leave the standard streams alone.

use std::io::Result;
use std::os::fd::{AsFd, AsRawFd, OwnedFd};

/// The number after standard input, output and error.
const FIRST: i32 = 3;

/// Moves what was just opened to a number from 3 on. A host that has closed standard output would
/// otherwise print into it.
///
/// # Errors
/// What `fcntl` reports, if the process may have no further descriptor.
pub fn off_standard<T: AsFd + From<OwnedFd>>(opened: T) -> Result<T> {
    if opened.as_fd().as_raw_fd() >= FIRST {
        return Ok(opened);
    }
    // The standard library duplicates to 3 or more.
    Ok(opened.as_fd().try_clone_to_owned()?.into())
}
