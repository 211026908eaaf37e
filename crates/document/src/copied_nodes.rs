//! Nodes as text for a clipboard, in the words of a `.vid` file, and nodes from it.

use std::collections::HashSet;
use std::path::Path;

use vides_engine::scene::{Node, Scene};

use super::editing::Document;
use super::info::Info;
use super::references::trusting;
use super::scene_edit::new_name;
use super::{mesh_file, vid};
use crate::error::{Error, Result, vec_with_room};

/// Nodes of a text, as [`super::Edit::AddNodes`] takes them.
#[derive(Debug)]
pub struct CopiedNodes {
    /// Parents and aims count as in the scene with them; names are free there.
    pub nodes: Vec<Node>,
    /// The numbers there of those that are in none of the others.
    pub tops: Vec<usize>,
    /// Those whose aim does not exist, with its name.
    pub without_aim: Vec<(String, String)>,
    /// What was wrong with files of meshes, which are empty then or have changed.
    pub warnings: Vec<Error>,
}

impl Document {
    /// The text of a `.vid` file with these nodes of the scene and all that is in them. Pins stay
    /// here; aims at others are there by name.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there is no such node; `ErrorKind::Limit` if it is too long to be read
    /// again; `ErrorKind::Memory`.
    pub fn nodes_as_text(&self, which: &[usize]) -> Result<String> {
        let scene = self.scene()?;
        let within = scene.with_all_in(which)?;
        let info = Info {
            fps: self.info().fps,
            ..Info::default()
        };
        vid::nodes_to_toml(&scene, &within, &info)
    }

    /// The nodes in such a text, to be added in `parent`; `None` if it has none. Names that are
    /// taken get a number, aims among them are kept, others find their node by its name.
    ///
    /// # Errors
    /// `ErrorKind::Format` with line and reason; `ErrorKind::Memory`.
    pub fn nodes_of_text(&self, text: &str, parent: Option<usize>) -> Result<Option<CopiedNodes>> {
        if !text.lines().any(|line| line.trim() == "[[node]]") {
            return Ok(None);
        }
        let (mut scene, aims) = vid::nodes_from_toml(text)?;
        // Who pastes it names what it names.
        let warnings = trusting(|| mesh_file::read_meshes(&mut scene, Path::new("")))?;
        let own;
        let here = match self.edited_scene() {
            Some(edited) => edited.scene(),
            None => {
                own = self.scene()?;
                &own
            }
        };
        let count = here.nodes().len();
        let mut nodes: Vec<Node> = vec_with_room(scene.nodes().len())?;
        let (mut tops, mut names) = (Vec::new(), HashSet::new());
        for (at, node) in scene.nodes().iter().enumerate() {
            let mut node = node.clone();
            node.name = free_name(here, &names, node.name);
            names.insert(node.name.clone());
            if node.parent.is_none() {
                tops.push(count + at);
            }
            node.parent = node.parent.map(|parent| count + parent).or(parent);
            node.aim = node.aim.map(|aim| count + aim);
            nodes.push(node);
        }
        let mut without_aim = Vec::new();
        for (at, aim) in aims {
            nodes[at].aim = here.find(&aim);
            if nodes[at].aim.is_none() {
                without_aim.push((nodes[at].name.clone(), aim));
            }
        }
        Ok(Some(CopiedNodes {
            nodes,
            tops,
            without_aim,
            warnings,
        }))
    }
}

/// This name if it is free, else with a number.
fn free_name(scene: &Scene, others: &HashSet<String>, name: String) -> String {
    match scene.find(&name).is_none() && !others.contains(&name) {
        true => name,
        false => new_name(scene, others, &name),
    }
}
