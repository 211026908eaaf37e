//! Points, views and keys as text for a clipboard, in the words of a `.vid` file, and from it.

use super::editing::Document;
use super::{Info, vid};
use crate::error::Result;
use vides_engine::path::Orientation;
use vides_engine::scene::Track;
use vides_engine::tools::block;

impl Document {
    /// The text of a `.vid` file with these points alone, ascending, at least two. A range keeps
    /// its curve, as [`block::extract`] does, and its times.
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
        alone.keep_frames(&self.frames_from(first, last)?)?;
        let others = (first..=last).filter(|at| points.binary_search(at).is_err());
        let others: Vec<usize> = others.map(|at| at - first).collect();
        alone.remove_points(&others)?;
        alone.to_toml()
    }

    /// The document in such a text; `None` if it has no points.
    ///
    /// # Errors
    /// As [`Document::from_toml`].
    pub fn points_of_text(text: &str) -> Result<Option<Self>> {
        if !text.contains("[[point]]") {
            return Ok(None);
        }
        Self::from_toml(text).map(Some)
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

    /// The tracks in such a text by node, whose name is empty if it has none; nothing if there is no
    /// track. Whatever else nodes have there is passed over.
    ///
    /// # Errors
    /// `ErrorKind::Format` with the line, as for a file; `Limit`, `Memory`.
    pub fn keys_of_text(text: &str) -> Result<Vec<(String, Vec<Track>)>> {
        match text.contains("[[node.track]]") {
            true => vid::keys_from_toml(text),
            false => Ok(Vec::new()),
        }
    }
}

#[cfg(test)]
mod tests {
    use vides_engine::scene::{Channel, Extrapolation, Interpolation};

    use super::*;

    /// Keys come back to the last bit, whatever they are, and of whatever nodes.
    #[test]
    fn keys_come_back_from_their_text() {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as f64 / f64::from(1_u32 << 31)
        };
        for count in [1, 2, 3] {
            let mut nodes = Vec::new();
            for number in 0..count {
                let mut tracks = Vec::new();
                for (channel, width, by) in [
                    ("position", 3, Interpolation::Hermite),
                    ("rotation", 4, Interpolation::Tcb),
                    ("value:a \"b\"", 1, Interpolation::Host("c d".to_owned())),
                    ("deformation.2.angle", 1, Interpolation::Cubic),
                ] {
                    let shape = match by {
                        Interpolation::Hermite => 6,
                        Interpolation::Tcb => 3,
                        _ => 0,
                    };
                    let keys = 1 + (random() * 9.0) as usize;
                    let frames = (0..keys).map(|key| key as f64 + 0.9 * random()).collect();
                    let values = (0..keys * width).map(|_| random() - 0.5).collect();
                    let shape = (0..keys * shape).map(|_| random() - 0.5).collect();
                    let channel = Channel::parse(channel).unwrap();
                    let track = Track::new(channel, by, frames, values, shape).unwrap();
                    let ends = (Extrapolation::Offset, Extrapolation::PingPong);
                    tracks.push(track.with_extrapolation(ends.0, ends.1).unwrap());
                }
                nodes.push((format!("node \"{number}\""), tracks));
            }
            let text = Document::keys_as_text(&nodes).unwrap();
            let mut back = Document::keys_of_text(&text).unwrap();
            if count == 1 {
                assert_eq!(back[0].0, "");
                back[0].0.clone_from(&nodes[0].0);
            }
            assert_eq!(back, nodes, "{text}");
        }
    }

    /// What a person has cut out of a file is taken: comments, and what else a node has.
    #[test]
    fn keys_are_found_in_the_text_of_nodes() {
        let track = "[[node.track]]\nchannel = \"roll\"\ninterpolation = \"linear\"\nframes = [0, 5]\nvalues = [1, 2]\n";
        let text = format!(
            "# two\n[[node]]\nname = \"a\"\nkind = \"camera\"\nroll_degrees = 3.0\n{track}\n[[node]]\nname = \"b\"\n{track}"
        );
        let nodes = Document::keys_of_text(&text).unwrap();
        assert_eq!(nodes.len(), 2);
        assert_eq!(nodes[1].1[0].frames(), [0.0, 5.0]);
        assert!(Document::keys_of_text("node = 3\n# [[node.track]]").is_err());
        assert_eq!(Document::keys_of_text("title = \"x\"").unwrap(), []);
        assert_eq!(Document::keys_of_text("# [[node.track]]").unwrap(), []);
        let wrong = Document::keys_of_text(&track.replace("roll", "wobble"));
        assert!(wrong.unwrap_err().to_string().starts_with("line 2: "));
    }
}
