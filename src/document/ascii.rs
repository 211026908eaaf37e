//! ASCII output.

use std::io::Write;
use std::path::Path;

use super::info::Space;
use crate::error::Result;
use crate::path::Sampler;

/// Writes every pose as one line of ten numbers; `space` puts the positions
/// into the user's world.
pub fn write_ascii(_sampler: &Sampler, _space: Option<&Space>, _out: &mut dyn Write) -> Result<()> {
    unimplemented!()
}

/// The same into a file, atomically.
pub fn write_ascii_file(_sampler: &Sampler, _space: Option<&Space>, _file: &Path) -> Result<()> {
    unimplemented!()
}
