//! A mesh file that is read part by part.

use glam::DVec3;
use vides_engine::scene::Mesh;

use super::error::{Beside, Error, Problem, Result};
use super::format::Format;
use super::read::read;
#[cfg(feature = "gltf")]
use super::shared::checked;

/// A file whose meshes are read one after another.
pub struct Opened {
    format: Format,
    content: Content,
}

enum Content {
    Bytes(Vec<u8>),
    #[cfg(feature = "gltf")]
    Gltf(Box<super::gltf::Container<'static>>, super::gltf::Room),
}

impl Opened {
    /// Opens a file; `beside` returns external buffers by name.
    ///
    /// # Errors
    /// [`Error`] if a glTF file is malformed.
    pub fn new(format: Format, bytes: Vec<u8>, beside: Beside<'_>) -> Result<Self> {
        #[cfg(feature = "gltf")]
        if format == Format::Gltf {
            let container = super::gltf::Container::open(bytes.into(), beside)?;
            let room = super::gltf::Room::of(&container);
            let content = Content::Gltf(Box::new(container), room);
            return Ok(Self { format, content });
        }
        let _ = beside;
        let content = Content::Bytes(bytes);
        Ok(Self { format, content })
    }

    /// The mesh of the whole file.
    ///
    /// # Errors
    /// Those of [`super::read()`].
    pub fn whole(&self, go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
        match &self.content {
            Content::Bytes(bytes) => read(self.format, bytes, go_on),
            #[cfg(feature = "gltf")]
            Content::Gltf(container, _) => checked(super::gltf::whole(container, go_on)?),
        }
    }

    /// One mesh of a glTF file, by its index from 0, and the positions of its points in each morph
    /// target. The file's size bounds all parts together.
    ///
    /// # Errors
    /// Those of [`super::read()`]; [`Problem::NoPart`] if there is no such part, as in all other
    /// formats.
    pub fn part(
        &mut self,
        number: usize,
        go_on: &mut dyn FnMut(f64) -> bool,
    ) -> Result<(Mesh, Vec<Vec<DVec3>>)> {
        match &mut self.content {
            Content::Bytes(_) => {
                let _ = (number, go_on);
                Err(Error::File(Problem::NoPart))
            }
            #[cfg(feature = "gltf")]
            Content::Gltf(container, room) => {
                let part = container.part(number, room, go_on)?;
                Ok((checked(part.mesh)?, part.targets))
            }
        }
    }
}
