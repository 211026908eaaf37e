//! What is done to nodes of the scene by menu, list and keys: each command is one step, which
//! selects what it has made. The output field shows why an edit is refused.

use glam::{DAffine3, DVec3};
use vides_document::Edit;
use vides_document::error::Result;
use vides_engine::math::orientation::quaternion_from_view;
use vides_engine::path::Space;
use vides_engine::scene::{Geometry, Keep, Kind, Light, Node, Object, Part, Scene};

use crate::space::cameras::Camera;
use crate::state::Editor;
use crate::state::files::Purpose;
use crate::state::scene_view::{NewNode, NodeCommand};
use crate::state::windows::ParentWindow;
use crate::texts::fill;
use crate::texts::refusals::of_edit;

/// Height of a new light above the middle of the space, in units of `half_size`.
const HIGH: f64 = 0.75;

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
            NodeCommand::Paste(text) => {
                if !self.paste_nodes(&text) {
                    self.complain(self.texts().scene.no_nodes);
                }
            }
            NodeCommand::PutInto(nodes, parent) => self.put_into(nodes, parent),
            NodeCommand::PutAs(nodes, parent, keep) => self.put_as(nodes, parent, keep),
        }
    }

    fn add_new(&mut self, what: NewNode) {
        let texts = &self.texts().scene;
        let node = match what {
            NewNode::Light => {
                let mut light = Node::new(texts.light, Kind::Light(Light::Point));
                light.rest.position = high_in(self.shown_space());
                light
            }
            NewNode::Camera => {
                let planes = vides_engine::scene::Camera::for_size(self.shown_space().half_size);
                let mut camera = Node::new(texts.camera, Kind::Camera(planes));
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
    pub(super) fn edit_and_select(
        &mut self,
        mut edits: Vec<Edit>,
        nodes: Vec<usize>,
        path: Option<usize>,
    ) -> Result<()> {
        self.document.end_step();
        let moment = self.previewed_frame();
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
        let name = name.trim().to_owned();
        if name.is_empty() {
            return self.complain(fill(self.texts().scene.needs_name, &[&old]));
        }
        let new = name.clone();
        if self.edit_all([part(Part::Name { node, name })]) {
            self.scene_view.list.get_mut().renamed(&old, &new);
        }
    }

    /// The names of the nodes that aim at one.
    fn aiming(&self) -> Vec<String> {
        let edited = self.document.edited_scene();
        let nodes = edited.into_iter().flat_map(|edited| edited.scene().nodes());
        let aiming = nodes.filter(|node| node.aim.is_some());
        aiming.map(|node| node.name.clone()).collect()
    }

    /// Whether a node is left; of a path alone it is its camera.
    fn has_node(&self, name: &str) -> bool {
        let edited = self.document.edited_scene();
        edited.is_none_or(|edited| edited.scene().find(name).is_some())
    }

    fn remove_nodes(&mut self) {
        let mut which = self.selected_nodes();
        which.sort_unstable();
        let aiming = self.aiming();
        if !which.is_empty() && self.edit_all([part(Part::Remove(which))]) {
            let left = self.aiming();
            let lost = |name: &&String| self.has_node(name) && !left.contains(name);
            let lost: Vec<_> = aiming.iter().filter(lost).cloned().collect();
            if !lost.is_empty() {
                self.say_done(fill(self.texts().scene.aims_lost, &[&lost.join(", ")]));
            }
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

    /// Nodes at rest keep their place; of those that move it is asked.
    fn put_into(&mut self, which: Vec<usize>, parent: Option<usize>) {
        let (nodes, moving) = self.that_change(&which, parent);
        if moving.is_empty() {
            return self.put_as(nodes, parent, Keep::Place);
        }
        let Some(edited) = self.document.edited_scene() else {
            return;
        };
        // What is refused either way is not asked about.
        let within = edited.scene().with_all_in(&nodes).unwrap_or_default();
        if parent.is_some_and(|parent| within.get(parent) != Some(&false)) {
            return self.put_as(nodes, parent, Keep::Numbers);
        }
        self.windows.parent = ParentWindow::of(self, nodes, parent, &moving);
    }

    /// Those of some nodes that get another parent directly, and those of them that move; what
    /// is in another one of them moves with it.
    fn that_change(&self, which: &[usize], parent: Option<usize>) -> (Vec<usize>, Vec<usize>) {
        let Some(edited) = self.document.edited_scene() else {
            return Default::default();
        };
        let (scene, nodes) = (edited.scene(), edited.scene().nodes());
        let within = scene.with_all_in(which).unwrap_or_default();
        let changes = |&node: &usize| {
            let old = nodes[node].parent;
            old != parent && !old.is_some_and(|old| within[old])
        };
        let nodes_there = which.iter().copied().filter(|&node| node < within.len());
        let changed: Vec<usize> = nodes_there.filter(changes).collect();
        let moving = changed.iter().copied().filter(|&node| nodes[node].moves());
        let moving = moving.collect();
        (changed, moving)
    }

    /// Puts nodes into another one; those that move keep this, the others their place.
    fn put_as(&mut self, which: Vec<usize>, parent: Option<usize>, keep: Keep) {
        let (changed, moving) = self.that_change(&which, parent);
        let edits: Vec<Edit> = changed
            .iter()
            .map(|&node| {
                let keep = match moving.contains(&node) {
                    true => keep,
                    false => Keep::Place,
                };
                Edit::SetParent { node, parent, keep }
            })
            .collect();
        let named = moving.first().and_then(|&node| {
            let edited = self.document.edited_scene()?;
            Some(edited.scene().nodes().get(node)?.name.clone())
        });
        if edits.is_empty() || !self.edit_all(edits) {
            return;
        }
        if let Some(name) = named {
            let texts = &self.texts().scene;
            let text = match keep {
                Keep::Way => texts.keeps_way,
                _ => texts.goes_along,
            };
            self.say_done(fill(text, &[&name]));
        }
    }
}

/// High in the space, where a path that the light gets lies within it, too.
fn high_in(space: Space) -> DVec3 {
    space.centre + space.up.world(DVec3::Y) * (HIGH * space.half_size)
}

/// This name if it is unused, otherwise the first unused one with a number.
fn free_name(scene: Option<&Scene>, name: &str) -> String {
    let taken = |name: &String| match scene {
        Some(scene) => scene.find(name).is_some(),
        None => name == CAMERA_OF_PATH,
    };
    let numbers = (2_u32..).map(|number| format!("{name} {number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbers);
    names.find(|name| !taken(name)).unwrap_or_default()
}
