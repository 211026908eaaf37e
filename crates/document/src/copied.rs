//! Points, views and keys as text for a clipboard, in the words of a `.vid` file, and from it.

use super::editing::Document;
use super::{Edit, Info, vid};
use crate::error::Result;
use crate::path::{CameraPath, Orientation};
use crate::tools::block;
use vides_engine::scene::Track;

impl Document {
    /// The text of a `.vid` file with these points alone, ascending, at least two. A range keeps
    /// its curve, as [`block::extract`] does.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there are no such points, or too few; `ErrorKind::Memory`.
    pub fn points_as_text(&self, points: &[usize]) -> Result<String> {
        let first = points.first().copied().unwrap_or_default();
        let last = points.last().copied().unwrap_or_default();
        let info = Info {
            fps: self.info().fps,
            ..Info::default()
        };
        let mut alone = Self::from_parts(block::extract(self.path(), first, last)?, info)?;
        let others = (first..=last).filter(|at| points.binary_search(at).is_err());
        alone.apply_all(others.rev().map(|at| Edit::RemovePoint { at: at - first }))?;
        alone.to_toml()
    }

    /// The path in such a text; `None` if it has no points.
    ///
    /// # Errors
    /// As [`Document::from_toml`].
    pub fn points_of_text(text: &str) -> Result<Option<CameraPath>> {
        if !text.contains("[[point]]") {
            return Ok(None);
        }
        Ok(Some(Self::from_toml(text)?.into_parts().0))
    }

    /// The lines with which a view stands in a `.vid` file.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn view_as_text(view: &Orientation) -> Result<String> {
        vid::view_to_toml(view)
    }

    /// The lines with which tracks stand in a `.vid` file, of each node with its name.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn keys_as_text(nodes: &[(String, Vec<Track>)]) -> Result<String> {
        vid::keys_to_toml(nodes)
    }

    /// The tracks in such a text by node, whose name is empty if it has none; `None` if there is no
    /// track. Whatever else nodes have there is passed over.
    ///
    /// # Errors
    /// `ErrorKind::Format` with the line, as for a file; `Limit`, `Memory`.
    pub fn keys_of_text(text: &str) -> Result<Option<Vec<(String, Vec<Track>)>>> {
        if !text.contains("[[node.track]]") {
            return Ok(None);
        }
        Ok(Some(vid::keys_from_toml(text)?).filter(|nodes| !nodes.is_empty()))
    }
}
