//! What a file says of how its scene is shown: `camera` and `range`, at its top.

use std::fmt::{self, Write};

use super::field::{Field, Source};
use super::text::{Quoted, Text};
use crate::error::{EngineError, Error, Invalid, Key, Result};
use vides_engine::scene::Scene;

/// Both as they were read, with their byte offsets: the nodes come further down.
#[derive(Default)]
pub(super) struct Shown {
    camera: Option<(usize, String)>,
    range: Option<(usize, [f64; 2])>,
}

impl Shown {
    /// Takes a field of a file; false if it is of something else.
    pub(super) fn take(&mut self, field: Field<'_>) -> Result<bool> {
        match field.key {
            "camera" => self.camera = Some((field.offset(), field.text()?.to_owned())),
            "range" => self.range = Some((field.offset(), field.numbers()?)),
            _ => return Ok(false),
        }
        Ok(true)
    }

    pub(super) fn set(self, scene: &mut Scene, text: &str) -> Result<()> {
        let source = Source { text, start: 0 };
        if let Some((offset, name)) = self.camera {
            let camera = match scene.find(&name) {
                Some(at) => scene.set_camera(Some(at)),
                None => Err(Invalid::NoNodeNamed((&name).into()).into()),
            };
            camera.map_err(|error| placed(source, offset, "camera", error))?;
        }
        if let Some((offset, [first, last])) = self.range {
            let range = scene.set_range(Some((first, last)));
            range.map_err(|error| placed(source, offset, "range", error))?;
        }
        Ok(())
    }
}

fn placed(source: Source<'_>, offset: usize, key: &str, error: EngineError) -> Error {
    match error {
        EngineError::Memory => error.into(),
        other => Error::Format {
            line: source.line(offset),
            key: Key(Some(key.into())),
            cause: other.into(),
        },
    }
}

pub(super) fn write(out: &mut Text, scene: &Scene) -> fmt::Result {
    if let Some(camera) = scene.camera() {
        writeln!(out, "camera = {}", Quoted(&scene.nodes()[camera].name))?;
    }
    if let Some((first, last)) = scene.range() {
        writeln!(out, "range = {:?}", [first, last])?;
    }
    Ok(())
}
