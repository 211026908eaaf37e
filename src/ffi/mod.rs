//! The C interface: the functions of `include/libvides.h`.
//!
//! A C host may pass null or dangling pointers, stale handles and NaN, run out of memory, or call
//! from several threads. An export checks and converts its arguments, calls safe code and converts
//! the result; the oddities of the 1994 interface (lists, `number < 0`) stay in [`legacy`] and
//! [`list`].
//!
//! Every export's body runs inside [`border::border`], which stops panics and keeps the last error.
//! That is a function and not a macro around the exports because cbindgen reads the source as
//! written.
//!
//! Nothing else in the library may use this module, and only here may unsafe code touch the host's
//! memory.

// C's naming conventions.
#![allow(non_camel_case_types, non_snake_case, unreachable_pub)]
#![allow(unsafe_code)]
// The header's preamble states what callers must uphold.
#![allow(clippy::missing_safety_doc)]

mod border;
mod by_name;
mod camera;
mod checks;
mod counted;
mod curve;
// Defines `enter!` for the modules below.
#[macro_use]
mod enter;
mod callbacks;
mod editor;
mod editor_scene;
mod editor_steps;
mod exchange;
mod fit;
mod handles;
mod host_loop;
mod legacy;
mod list;
mod live;
mod object;
mod orientations;
mod pace;
mod path;
mod path_object;
mod pointers;
mod points;
mod poses;
mod progress;
mod properties;
mod quaternions;
mod scene;
mod scene_contents;
mod scene_handles;
mod scene_properties;
mod scene_shown;
mod scene_states;
mod scene_tracks;
mod scene_types;
mod shape;
mod space;
mod splines;
mod status;
mod times;
mod toolbox;
mod tools;
mod types;
mod view;

#[cfg(test)]
mod host_tests;
