//! What is done to a node from its panels.

use vides_document::error::{Refused, Result};
use vides_document::{Document, Edit, Info};
use vides_engine::path::CameraPath;
use vides_engine::scene::{Channel, Extrapolation, FollowPath, KeyList, Part};
use vides_engine::tools::fit::Tolerance;

use crate::state::Editor;
use crate::state::scene_view::{Moves, NodeAction};

/// The channels that a path moves.
const OF_PATH: [Channel; 3] = [Channel::Position, Channel::Rotation, Channel::Zoom];

impl Editor {
    pub(crate) fn node_action(&mut self, action: NodeAction) {
        match action {
            NodeAction::Enter(entry) => self.enter_with(*entry, |editor, edit| {
                editor.edit(edit);
            }),
            NodeAction::Value(node, channel, entry) => self.enter_with(entry, |editor, value| {
                editor.set_channel(node, &channel, &value);
            }),
            NodeAction::SwitchKey(node, channel) => self.switch_key(node, &channel),
            NodeAction::SetKeys => self.set_keys(),
            NodeAction::Motion(node, moves) => self.set_motion(node, moves),
            NodeAction::FewKeys(node) => self.path_to_few_keys(node),
            NodeAction::Near(position, angle) => {
                self.scene_view.tolerance = Some(Tolerance { position, angle });
            }
            NodeAction::Reload(node) => self.reload_mesh(node),
            NodeAction::AskFile(purpose) => self.choose_file(purpose),
            NodeAction::ShowBox(shown) => self.scene_view.deformation = shown,
            NodeAction::ShowNode(shown) => self.scene_view.shows_node = shown,
        }
    }

    /// What moves a node.
    pub(crate) fn moves(&self, node: usize) -> Moves {
        let Ok(of) = self.node_of_scene(node) else {
            return Moves::Nothing;
        };
        match (of.path(), of.keys().tracks().is_empty()) {
            (Some(_), _) => Moves::Path,
            (None, false) => Moves::Keys,
            (None, true) => Moves::Nothing,
        }
    }

    fn set_motion(&mut self, node: usize, moves: Moves) {
        let now = self.moves(node);
        let texts = &self.texts().node;
        let of = self.node_of_scene(node).ok();
        let looks_at = of.is_some_and(|of| of.aim.is_some());
        let by_key = of.is_some_and(|of| {
            let mut all = OF_PATH.iter();
            all.any(|channel| of.keys().track(channel).is_some())
        });
        let (made, said) = match (now, moves) {
            (now, wanted) if now == wanted => return,
            (_, Moves::Nothing) => (self.still(node), texts.rests),
            (Moves::Path, Moves::Keys) => (self.document.path_to_keys(node), texts.became_keys),
            (_, Moves::Keys) => {
                self.select_nodes(vec![node]);
                return self.set_keys();
            }
            (_, Moves::Path) if by_key || looks_at => return self.keys_to_path(node),
            (_, Moves::Path) => (self.new_path(node), ""),
        };
        let edits = match made {
            Ok(edits) => edits,
            Err(error) => return self.complain_of(&error),
        };
        // What is selected stays so, though its path may go.
        self.select_nodes(vec![node]);
        if self.edit_all(edits) && !said.is_empty() {
            self.say_done(said.to_owned());
        }
    }

    /// The edits that take away path and keys; the values of the last keys stay.
    fn still(&self, node: usize) -> Result<Vec<Edit>> {
        let of = self.node_of_scene(node)?;
        let mut parts = Vec::new();
        if of.path().is_some() {
            parts.push(Part::path(node, None)?);
        }
        for track in of.keys().tracks() {
            parts.push(Part::Keys {
                node,
                channel: track.channel().clone(),
                remove: (0..track.frames().len()).collect(),
                put: KeyList::default(),
            });
        }
        let edits = parts.into_iter().map(|part| Edit::Part(Box::new(part)));
        Ok(edits.collect())
    }

    /// The edits that let a node follow a new path, which begins here and now.
    fn new_path(&self, node: usize) -> Result<Vec<Edit>> {
        let edited = self.document.edited_scene().ok_or(Refused::NoScene)?;
        let of = edited.scene().node(node)?;
        let space = edited.scene().space();
        let mut document = Document::from_parts(CameraPath::try_new()?, Info::default())?;
        document.apply(Edit::SetSpace { space, fit: true })?;
        let (mut path, _) = document.into_parts();
        // Half as long as a new path, and towards the middle, so that it stays in the space.
        let (from, first) = (of.rest.position, path.points[0].position);
        let way = path.points[path.points.len() - 1].position - first;
        let share = if way.dot(from - space.centre) > 0.0 {
            -0.5
        } else {
            0.5
        };
        for point in &mut path.points {
            point.position = from + share * (point.position - first);
        }
        let start = self.previewed_frame()?.round();
        let follow = FollowPath::new(path, start, Extrapolation::Hold)?;
        let part = Part::path(node, Some(follow))?;
        let part = Edit::Part(Box::new(part));
        Ok(vec![part, Edit::EditNode(Some(node))])
    }
}
