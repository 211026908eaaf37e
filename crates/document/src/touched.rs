//! What undo and redo have changed of a scene, so that it can be selected.

use vides_engine::path::CameraPath;
use vides_engine::scene::{Channel, Node, NodeId, Scene, Track};

use super::content::Content;
use super::edited_scene::EditedScene;

/// Nodes and keys of a scene that the last undo or redo has changed and that are there.
#[derive(Debug, Default)]
pub struct Touched {
    nodes: Vec<usize>,
    keys: Vec<(usize, Channel, Vec<usize>)>,
}

/// One of two states.
#[derive(Clone, Copy)]
struct Side<'a> {
    path: &'a CameraPath,
    edited: &'a EditedScene,
}

impl Touched {
    /// The nodes, each once, in rising order.
    #[must_use]
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// The keys that have come, by node and channel.
    pub fn keys(&self) -> impl Iterator<Item = (usize, &Channel, &[usize])> {
        let keys = self.keys.iter();
        keys.map(|(node, channel, keys)| (*node, channel, keys.as_slice()))
    }

    /// What differs in `new` from `old`. Of another scene it reports nothing.
    pub(super) fn between(old: &Content, new: &Content) -> Self {
        let mut touched = Self::default();
        let Some(edited) = new.scene.as_deref() else {
            return touched;
        };
        let of_path;
        let before = match old.scene.as_deref() {
            Some(before) => before,
            None => match EditedScene::of_path(&old.path) {
                Ok(scene) => {
                    of_path = scene;
                    &of_path
                }
                Err(_) => return touched,
            },
        };
        let (new, old) = (
            Side {
                path: &new.path,
                edited,
            },
            Side {
                path: &old.path,
                edited: before,
            },
        );
        let known = before.scene().ids();
        let is_there = |id: &NodeId| edited.scene().number_of(*id).is_some();
        if !known.is_empty() && !known.iter().any(is_there) {
            return touched;
        }
        // Links mean the same then.
        let same = known == edited.scene().ids();
        for (at, &id) in edited.scene().ids().iter().enumerate() {
            let was = match same {
                true => Some(at),
                false => old.edited.scene().number_of(id),
            };
            let unchanged = |was| {
                let (a, b) = (new.node(at), old.node(was));
                let alike = same && std::ptr::eq(a, b);
                (alike || new.node_is(at, old, was)) && new.path_is(at, old, was)
            };
            if !was.is_some_and(unchanged) {
                touched.nodes.push(at);
            }
            if let Some(was) = was {
                touched.note_keys(at, new.node(at), old.node(was));
            }
        }
        touched
    }

    fn note_keys(&mut self, at: usize, new: &Node, old: &Node) {
        for track in new.keys().tracks().without(old.keys().tracks()) {
            let Some(before) = old.keys().track(track.channel()) else {
                continue;
            };
            let keys: Vec<usize> = (0..track.frames().len())
                .filter(|&key| !has_key(before, track, key))
                .collect();
            if !keys.is_empty() {
                self.keys.push((at, track.channel().clone(), keys));
            }
        }
    }
}

/// Whether a track has a key of another one as it is there.
fn has_key(track: &Track, other: &Track, key: usize) -> bool {
    let frame = other.frames()[key];
    let at = track.frames().partition_point(|there| *there < frame);
    let numbers = |track: &Track, key: usize| {
        let [width, shape] = track.key_numbers();
        let values = &track.values()[width * key..][..width];
        (
            values.to_vec(),
            track.shape()[shape * key..][..shape].to_vec(),
        )
    };
    if track.frames().get(at) != Some(&frame) {
        return false;
    }
    let (a, b) = (numbers(track, at), numbers(other, key));
    a.0 == b.0 && (a.1 == b.1 || track.interpolation() != other.interpolation())
}

impl<'a> Side<'a> {
    fn scene(self) -> &'a Scene {
        self.edited.scene()
    }

    fn node(self, at: usize) -> &'a Node {
        &self.scene().nodes()[at]
    }

    /// Whether its node `at`, except for its path, equals node `was` of another side.
    fn node_is(self, at: usize, other: Self, was: usize) -> bool {
        let (new, old) = (self.node(at), other.node(was));
        new.name == old.name
            && new.kind == old.kind
            && (new.pivot, new.rest) == (old.pivot, old.rest)
            && new.keys() == old.keys()
            && self.links(at, other) == other.links(was, self)
    }

    /// Whether its node follows the same path in the same way.
    fn path_is(self, at: usize, other: Self, was: usize) -> bool {
        let starts = |node: &Node| {
            let path = node.path();
            path.map(|path| (path.start_frame(), path.extrapolation()))
        };
        starts(self.node(at)) == starts(other.node(was))
            && same_path(self.path_of(at), other.path_of(was))
            && self.pins_of(at) == other.pins_of(was)
    }

    /// What a node is in and looks at, as far as that is in another side, too.
    fn links(self, at: usize, other: Self) -> [Option<NodeId>; 2] {
        let node = self.node(at);
        [node.parent, node.aim].map(|link| {
            let id = self.scene().ids()[link?];
            other.scene().number_of(id).map(|_| id)
        })
    }

    fn path_of(self, at: usize) -> Option<&'a CameraPath> {
        match self.edited.node() == Some(at) {
            true => Some(self.path),
            false => self.node(at).path().map(|follow| follow.path()),
        }
    }

    fn pins_of(self, at: usize) -> Vec<(usize, String)> {
        if self.edited.node() == Some(at) {
            return self.edited.pinned().collect();
        }
        let pins = self.scene().pins();
        let first = pins.partition_point(|pin| pin.node < at);
        let pins = pins[first..].iter().take_while(|pin| pin.node == at);
        pins.map(|pin| (pin.point, pin.marker.clone())).collect()
    }
}

fn same_path(a: Option<&CameraPath>, b: Option<&CameraPath>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => std::ptr::eq(a, b) || a == b,
        (a, b) => a.is_none() && b.is_none(),
    }
}
