//! Memory shared with the X server: an anonymous file, so nothing is left behind, sealed against
//! shrinking, so the server may trust it, and allocated in full, so that a lack of memory is an
//! error here and not a signal later.
#![allow(unsafe_code)] // mapped memory

use std::io::{Error, Result};
use std::os::fd::{AsRawFd, OwnedFd};
use std::ptr::NonNull;

use vides_engine::descriptor::off_standard;

use rustix::fs::{FallocateFlags, MemfdFlags, SealFlags, fallocate, fcntl_add_seals, memfd_create};

#[derive(Debug)]
pub(super) struct Memory {
    start: NonNull<u8>,
    /// In bytes, a multiple of 4096.
    length: usize,
}

impl Memory {
    /// At least `length` zeroed bytes, and the file descriptor to pass to the server.
    pub(super) fn new(length: usize) -> Result<(Self, OwnedFd)> {
        let length = length.max(1).next_multiple_of(4096);
        let flags = MemfdFlags::CLOEXEC | MemfdFlags::ALLOW_SEALING;
        let file = off_standard(memfd_create("vides", flags)?)?;
        fallocate(&file, FallocateFlags::empty(), 0, length as u64)?;
        fcntl_add_seals(&file, SealFlags::SHRINK | SealFlags::GROW | SealFlags::SEAL)?;
        let protection = libc::PROT_READ | libc::PROT_WRITE;
        // SAFETY: a new mapping at an address the kernel chooses; it replaces none.
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

    pub(super) fn length(&self) -> usize {
        self.length
    }

    pub(super) fn pixels(&mut self) -> &mut [u32] {
        // SAFETY: the mapping is `length` bytes long, page-aligned and lives as long as `self`, and
        // any bits are a valid `u32`. No one else writes: the server was asked to map it read-only.
        unsafe { std::slice::from_raw_parts_mut(self.start.as_ptr().cast(), self.length / 4) }
    }

    pub(super) fn bytes(&mut self) -> &mut [u8] {
        // SAFETY: as in `pixels`.
        unsafe { std::slice::from_raw_parts_mut(self.start.as_ptr(), self.length) }
    }
}

impl Drop for Memory {
    fn drop(&mut self) {
        // SAFETY: only we have the mapping, and nothing points into it any more.
        unsafe { libc::munmap(self.start.as_ptr().cast(), self.length) };
    }
}
