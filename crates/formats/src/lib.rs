//! Camera paths and scenes in the file formats of other programs, out and in.
//!
//! Each format is one file or folder: a [`Format`] in the table [`formats()`]. What is
//! written is a [`Flight`], what is read a [`Content`]; [`export`] and [`import`] are the doors for
//! command, window and C. What a format cannot hold is a [`Loss`], never silent. Axes, angles and
//! times are converted in [`convention`] and nowhere else.
//!
//! Files are hostile ground: nothing is allocated because a header claims a number, and nothing
//! that is read is ever run. The crate knows nothing of windows or of C.

#![forbid(unsafe_code)]
// Standard output is the host's.
#![cfg_attr(not(test), warn(clippy::print_stdout))]

mod all;
mod ascii;
mod base64;
mod blocks;
mod cameras;
mod chan;
mod colmap;
mod content;
pub mod convention;
mod csv;
mod doors;
mod error;
mod euroc;
mod flight;
mod foreign;
mod format;
mod gltf;
mod html;
mod json;
mod keyframes;
mod kitti;
mod lens;
mod loss;
mod matrices;
mod names;
mod natural;
mod nerfstudio;
mod ngp;
mod npy;
mod open3d;
mod options;
mod osg;
mod picture;
mod polycam;
mod record3d;
mod rows;
mod saving;
mod script;
mod source;
mod space;
mod supersplat;
mod transforms;
mod tree;
mod tum;
mod usd;
mod vid;

pub use all::{by_name, by_target, formats};
pub use ascii::{write_ascii, write_ascii_file};
pub use blocks::Progress;
pub use content::{Content, Recording};
pub use doors::{Imported, export, export_to, import, losses, read, recognised, recording};
pub use error::{Cause, Error, Place, Result, Wanted};
pub use flight::Flight;
pub use foreign::{Foreign, Way};
pub use format::{Format, Holds, Reader, Writer};
pub use keyframes::Keyframes;
pub use loss::{Loss, Report};
pub use options::{As, MAX_DECIMALS, OPTIONS, OptionRow, Options, Times};
pub use source::Source;
