//! Memory that the X server reads, too.
//!
//! It is a file without a name, so that nothing is left behind whatever
//! happens, sealed against shrinking, so that the server may trust it, and with
//! all its pages taken beforehand, so that a lack of memory is an error here
//! and not a signal later.
#![allow(unsafe_code)] // mapped memory

use std::io::{Error, Result};
use std::os::fd::{AsRawFd, OwnedFd};
use std::ptr::NonNull;

use rustix::fs::{FallocateFlags, MemfdFlags, SealFlags, fallocate, fcntl_add_seals, memfd_create};

/// A run of pixels or bytes.
#[derive(Debug)]
pub(super) struct Memory {
    start: NonNull<u8>,
    /// Bytes, a multiple of 4096.
    length: usize,
}

impl Memory {
    /// At least `length` bytes, zero, and the descriptor that the server takes
    /// them by.
    ///
    /// # Errors
    /// The system's; there is no memory left.
    pub(super) fn new(length: usize) -> Result<(Self, OwnedFd)> {
        let length = length.max(1).next_multiple_of(4096);
        let flags = MemfdFlags::CLOEXEC | MemfdFlags::ALLOW_SEALING;
        let file = memfd_create("vides", flags)?;
        fallocate(&file, FallocateFlags::empty(), 0, length as u64)?;
        fcntl_add_seals(&file, SealFlags::SHRINK | SealFlags::GROW | SealFlags::SEAL)?;
        let protection = libc::PROT_READ | libc::PROT_WRITE;
        // SAFETY: a new mapping where the system likes; it replaces none.
        let start = unsafe {
            libc::mmap(
                std::ptr::null_mut(),
                length,
                protection,
                libc::MAP_SHARED,
                file.as_raw_fd(),
                0,
            )
        };
        if start == libc::MAP_FAILED {
            return Err(Error::last_os_error());
        }
        let start = NonNull::new(start.cast()).ok_or(std::io::ErrorKind::OutOfMemory)?;
        Ok((Self { start, length }, file))
    }

    /// Bytes.
    pub(super) fn length(&self) -> usize {
        self.length
    }

    /// All of it as pixels. The server only reads it.
    pub(super) fn pixels(&mut self) -> &mut [u32] {
        // SAFETY: the mapping is `length` bytes long, begins at a page, lives as
        // long as `self`, and any bits are numbers. Nobody else writes to it: the
        // server was told to map it for reading only.
        unsafe { std::slice::from_raw_parts_mut(self.start.as_ptr().cast(), self.length / 4) }
    }

    /// All of it as bytes.
    pub(super) fn bytes(&mut self) -> &mut [u8] {
        // SAFETY: as for the pixels.
        unsafe { std::slice::from_raw_parts_mut(self.start.as_ptr(), self.length) }
    }
}

impl Drop for Memory {
    fn drop(&mut self) {
        // SAFETY: the mapping is ours alone, and nothing points into it any more.
        unsafe { libc::munmap(self.start.as_ptr().cast(), self.length) };
    }
}
