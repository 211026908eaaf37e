//! The border to C: every function of `include/libvides.h`, and nothing else.
//!
//! The host is C: it hands over null and dangling pointers, stale handles,
//! numbers that are none; it may run out of memory or call from several
//! threads. All of that ends here. An export checks what it was given,
//! converts it, calls safe code and converts the answer; the oddities of the
//! 1994 interface (lists, `number < 0`) stay in [`legacy`] and [`list`].
//!
//! Handles are tokens and not addresses ([`handles`]), so that a wrong one is
//! a status and not a crash. Every export's body stands inside
//! [`border::border`], which stops panics and keeps the last error. It is a
//! function and not a macro around the exports, since cbindgen reads the
//! source as it is written.
//!
//! Nothing else in the library may use this module, and only here may
//! unsafe code deal with the host's memory.

// The names are C's.
#![allow(non_camel_case_types, non_snake_case, unreachable_pub)]
#![allow(unsafe_code)]
// What a caller must hold to is said once, in the header's preamble.
#![allow(clippy::missing_safety_doc)]

mod border;
mod checks;
mod counted;
mod curve;
// Its macro is for those below.
#[macro_use]
mod enter;
mod editor;
mod editor_scene;
mod handles;
mod host_loop;
mod legacy;
mod list;
mod live;
mod object;
mod orientations;
mod pace;
mod path;
mod pointers;
mod points;
mod poses;
mod quaternions;
mod scene;
mod scene_states;
mod scene_tracks;
mod scene_types;
mod settings;
mod shape;
mod space;
mod splines;
mod status;
mod tools;
mod types;
mod view;

#[cfg(test)]
mod host_tests;
