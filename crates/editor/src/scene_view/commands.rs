//! What is done to nodes of the scene by menu, list and keys: each command is one step, which
//! selects what it has made. What is refused is told in the output field and changes nothing.

use glam::{DAffine3, DVec3};
use vides_engine::scene::{Geometry, Keep, Kind, Light, Node, Object, Part, Scene};

use super::values::PLACE;
use crate::document::Edit;
use crate::error::Result;
use crate::files::Purpose;
use crate::math::orientation::quaternion_from_view;
use crate::path::Space;
use crate::space::Camera;
use crate::state::Editor;
use crate::texts::fill;
use crate::texts::refusals::of_edit;

/// What is done to nodes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NodeCommand {
    /// Ask for a file of a mesh, to be added as an object.
    AddObject,
    Add(NewNode),
    /// Give a node another name.
    Rename(usize, String),
    /// Remove the selected ones with all that is in them.
    Remove,
    /// Copy the selected ones with all that is in them.
    Copy,
    /// Put these into a node, or into the scene itself.
    PutInto(Vec<usize>, Option<usize>),
}

/// A node that begins without a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NewNode {
    /// Above the space, shining into all directions.
    Light,
    /// As the view that is shown now.
    Camera,
    /// At the origin.
    Group,
}

/// How far above the middle of the space a new light stands, in half sizes.
const ABOVE: f64 = 1.5;

/// The name of a path's camera as soon as there is a scene ([`Scene::of_path`]).
const CAMERA_OF_PATH: &str = "camera";

fn part(part: Part) -> Edit {
    Edit::Part(Box::new(part))
}

impl Editor {
    pub(crate) fn do_to_nodes(&mut self, command: NodeCommand) {
        match command {
            NodeCommand::AddObject => self.choose_file(Purpose::AddObject),
            NodeCommand::Add(what) => self.add_new(what),
            NodeCommand::Rename(node, name) => self.rename_node(node, name),
            NodeCommand::Remove => self.remove_nodes(),
            NodeCommand::Copy => self.copy_nodes(),
            NodeCommand::PutInto(nodes, parent) => self.put_into(nodes, parent),
        }
    }

    fn add_new(&mut self, what: NewNode) {
        let texts = &self.texts().scene;
        let node = match what {
            NewNode::Light => {
                let mut light = Node::new(texts.light, Kind::Light(Light::Point));
                light.rest.position = above(self.shown_space());
                light
            }
            NewNode::Camera => {
                let mut camera = Node::new(texts.camera, Kind::Camera(Default::default()));
                if let Some(seen) = self.seen_camera() {
                    camera.rest.position = seen.position;
                    camera.rest.rotation = quaternion_from_view(seen.view, seen.up);
                    camera.rest.zoom = seen.zoom;
                }
                camera
            }
            NewNode::Group => Node::new(texts.group, Kind::Group),
        };
        if let Err(error) = self.add_node(node, None) {
            self.complain(of_edit(self.language(), &error));
        }
    }

    /// Adds an object with this mesh, as it has it: at the world's origin.
    ///
    /// # Errors
    /// Why the edit was refused.
    pub(crate) fn add_mesh(&mut self, name: &str, mesh: Geometry) -> Result<()> {
        let mut node = Node::new(name, Kind::Object(Object::default()));
        if node.check().is_err() {
            self.texts().scene.object.clone_into(&mut node.name);
        }
        self.add_node(node, Some(mesh))
    }

    /// Adds a node under its name, or that with a number.
    fn add_node(&mut self, mut node: Node, mesh: Option<Geometry>) -> Result<()> {
        let edited = self.document.edited_scene();
        let scene = edited.map(|edited| edited.scene());
        node.name = free_name(scene, &node.name);
        let at = scene.map_or(1, |scene| scene.nodes().len());
        let mut edits = vec![Edit::AddNodes(vec![node])];
        edits.extend(mesh.map(|mesh| part(Part::Mesh { node: at, mesh })));
        self.edit_and_select(edits, vec![at], None)
    }

    /// Does edits in one step after which these nodes are selected, and this one's path is edited.
    fn edit_and_select(
        &mut self,
        mut edits: Vec<Edit>,
        nodes: Vec<usize>,
        path: Option<usize>,
    ) -> Result<()> {
        self.document.end_step();
        let moment = self.frame();
        edits.push(Edit::EditNode(path));
        self.document.apply_all(edits)?;
        if let Ok(moment) = moment {
            self.stay_at(moment);
        }
        self.select_nodes(nodes);
        Ok(())
    }

    /// The camera whose picture is shown, in the world.
    fn seen_camera(&self) -> Option<Camera> {
        let Some(flown) = self.flown() else {
            return self.view().ok().map(|(pose, _)| pose.into());
        };
        let world = self.with_scene(|now| now.into_path.inverse());
        let world = world.ok().flatten().unwrap_or(DAffine3::IDENTITY);
        let view = world.transform_vector3(flown.view).try_normalize()?;
        let up = world.transform_vector3(flown.up);
        Some(Camera {
            position: world.transform_point3(flown.position),
            view,
            up: up.reject_from_normalized(view).try_normalize()?,
            zoom: flown.zoom,
        })
    }

    fn rename_node(&mut self, node: usize, name: String) {
        let edited = self.document.edited_scene();
        let old = edited.and_then(|edited| edited.scene().nodes().get(node));
        let old = old.map(|old| old.name.clone()).unwrap_or_default();
        if name.is_empty() {
            return self.complain(fill(self.texts().scene.needs_name, &[&old]));
        }
        let new = name.clone();
        if self.edit_all([part(Part::Name { node, name })]) {
            self.scene_view.list.get_mut().renamed(&old, &new);
        }
    }

    fn remove_nodes(&mut self) {
        let mut which = self.selected_nodes();
        which.sort_unstable();
        if !which.is_empty() && self.edit_all([part(Part::Remove(which))]) {
            // Numbers have moved up: what is edited is selected.
            let edited = self
                .document
                .edited_scene()
                .and_then(|edited| edited.node());
            self.select_nodes(edited.into_iter().collect());
        }
    }

    fn copy_nodes(&mut self) {
        let selected = self.selected_nodes();
        let Some(edited) = self.document.edited_scene() else {
            return;
        };
        let Some(&current) = selected.first() else {
            return;
        };
        let nodes = edited.scene().nodes();
        // The copies stand behind all, in the order of their originals.
        let Ok(within) = edited.scene().with_all_in(&selected) else {
            return;
        };
        let mut copies = vec![0; nodes.len()];
        let all = copies.iter_mut().zip(within);
        let copied = all.filter(|(_, within)| *within);
        for (number, (copy, _)) in (nodes.len()..).zip(copied) {
            *copy = number;
        }
        let path = nodes[current].path().map(|_| copies[current]);
        let new = selected.iter().map(|&at| copies[at]).collect();
        if let Err(error) = self.edit_and_select(vec![Edit::CopyNodes(selected)], new, path) {
            self.complain(of_edit(self.language(), &error));
        }
    }

    /// Nodes at rest keep their place; those that move keep their numbers, which is told.
    fn put_into(&mut self, which: Vec<usize>, parent: Option<usize>) {
        let Some(edited) = self.document.edited_scene() else {
            return;
        };
        let nodes = edited.scene().nodes();
        let Ok(within) = edited.scene().with_all_in(&which) else {
            return;
        };
        let mut moving = None;
        let mut edits = Vec::new();
        for node in which {
            let of = &nodes[node];
            // What is in another one of these goes along with that.
            let goes_along = of.parent.is_some_and(|parent| within[parent]);
            if goes_along || of.parent == parent {
                continue;
            }
            let keep = if moves(of) {
                moving.get_or_insert_with(|| of.name.clone());
                Keep::Numbers
            } else {
                Keep::Place
            };
            edits.push(Edit::SetParent { node, parent, keep });
        }
        if edits.is_empty() || !self.edit_all(edits) {
            return;
        }
        if let Some(name) = moving {
            self.say_done(fill(self.texts().scene.goes_along, &[&name]));
        }
    }
}

/// Above the middle of the space.
fn above(space: Space) -> DVec3 {
    space.centre + space.up.world(DVec3::Y) * (ABOVE * space.half_size)
}

/// Whether a path or keys move a node in its parent.
fn moves(node: &Node) -> bool {
    let mut tracks = PLACE.iter().map(|channel| node.keys().track(channel));
    node.path().is_some() || tracks.any(|track| track.is_some())
}

/// This name if no node has it, else the first one with a number.
fn free_name(scene: Option<&Scene>, name: &str) -> String {
    let taken = |name: &String| match scene {
        Some(scene) => scene.find(name).is_some(),
        None => name == CAMERA_OF_PATH,
    };
    let numbers = (2_u32..).map(|number| format!("{name} {number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbers);
    names.find(|name| !taken(name)).unwrap_or_default()
}
