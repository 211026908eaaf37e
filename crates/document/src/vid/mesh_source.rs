//! The file of a mesh, as a `.vid` file names it: `file`, `bytes`, `checksum`, and of a glTF
//! file the number of a mesh (`part`). Written by hand, `file` alone, or with its `part`: 0 bytes,
//! which no mesh has, until it is read.

use std::fmt::{self, Write};
use std::path::Path;

use vides_engine::scene::MeshSource;

use super::field::Field;
use super::text::{Quoted, Text};
use crate::error::{Malformed, Result};
use crate::mesh_file::name_from;

pub(super) const KEYS: [&str; 4] = ["file", "bytes", "checksum", "part"];

#[derive(Default)]
pub(super) struct Reading<'a> {
    file: Option<&'a str>,
    bytes: Option<i64>,
    checksum: Option<u64>,
    part: Option<u32>,
}

impl<'a> Reading<'a> {
    /// Takes a field; false if [`KEYS`] does not have it.
    pub(super) fn take(&mut self, field: &Field<'a>) -> Result<bool> {
        match field.key {
            "file" => self.file = Some(field.text()?),
            "bytes" => self.bytes = Some(field.integer_in(0, i64::MAX)?),
            "checksum" => {
                let number = u64::from_str_radix(field.text()?, 16);
                self.checksum = Some(number.map_err(|_| field.error(Malformed::Checksum))?);
            }
            "part" => self.part = Some(field.integer_in(0, u32::MAX.into())? as u32),
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// The source if there is a file; `alone`: the file stores no points itself.
    pub(super) fn done(self, table: &Field<'_>, alone: bool) -> Result<Option<MeshSource>> {
        let part = self.part;
        match (self.file, self.bytes, self.checksum) {
            (None, None, None) if part.is_none() => Ok(None),
            (Some(file), Some(bytes), Some(checksum)) if alone => Ok(Some(MeshSource {
                file: file.to_owned(),
                bytes: bytes.unsigned_abs(),
                checksum,
                part,
            })),
            (Some(file), None, None) if alone => Ok(Some(MeshSource {
                file: file.to_owned(),
                bytes: 0,
                checksum: 0,
                part,
            })),
            _ => Err(table.error(Malformed::MeshFile)),
        }
    }
}

/// Writes it, relative to `folder`.
pub(super) fn write(out: &mut Text, source: &MeshSource, folder: Option<&Path>) -> fmt::Result {
    let file = name_from(folder, &source.file);
    writeln!(out, "file = {}", Quoted(&file))?;
    let MeshSource {
        bytes,
        checksum,
        part,
        ..
    } = source;
    if let Some(part) = part {
        writeln!(out, "part = {part}")?;
    }
    if *bytes == 0 {
        return Ok(());
    }
    writeln!(out, "bytes = {bytes}\nchecksum = \"{checksum:x}\"")
}
