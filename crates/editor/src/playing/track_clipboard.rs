//! Keys by the clipboard, where the timeline has the keyboard: as the text of tracks in a `.vid` file,
//! their frames counted from the first one.

use egui::{Context, Event, Key, Modifiers};
use vides_document::error::{Refused, Result};
use vides_document::{Document, Edit};
use vides_engine::scene::{Channel, KeyList, Node, Part, Track};

use super::key_motion::{Place, by_track, keys_at, removed};
use super::track_curve::Of;
use super::track_menu::{converted, of_keys};
use crate::action::Action;
use crate::state::Editor;
use crate::texts::fill;
use crate::texts::refusals::of_edit;

/// What the clipboard's keys want.
enum Wanted {
    Copy,
    Cut,
    /// What the clipboard has.
    Ask,
    Paste(String),
}

/// Handles the clipboard's keys before other widgets; beside the `rows` only what is put
/// in, if it is keys.
pub(super) fn take_keys(editor: &mut Editor, context: &Context, rows: bool) {
    if editor.document.edited_scene().is_none() {
        return;
    }
    let mut wanted = Vec::new();
    context.input_mut(|input| {
        input.events.retain(|event| {
            let next = match event {
                Event::Key {
                    key,
                    pressed: true,
                    repeat: false,
                    modifiers,
                    ..
                } if modifiers.matches_exact(Modifiers::CTRL) => match key {
                    Key::C if rows => Some(Wanted::Copy),
                    Key::X if rows => Some(Wanted::Cut),
                    Key::V => Some(Wanted::Ask),
                    _ => None,
                },
                Event::Copy if rows => Some(Wanted::Copy),
                Event::Cut if rows => Some(Wanted::Cut),
                Event::Paste(text) if rows || text.contains("[[node.track]]") => {
                    Some(Wanted::Paste(text.clone()))
                }
                _ => None,
            };
            let is_other = next.is_none();
            wanted.extend(next);
            is_other
        });
    });
    for wanted in wanted {
        match wanted {
            Wanted::Copy => {
                editor.copy_keys(context);
            }
            Wanted::Cut => editor.cut_keys(context),
            Wanted::Ask => Editor::ask_for_clipboard(context),
            Wanted::Paste(text) => editor.paste_keys(&text),
        }
    }
}

impl Editor {
    /// Copies the selected keys; false with a message if none is selected or memory is short.
    fn copy_keys(&mut self, context: &Context) -> bool {
        let keys = self.selected_keys();
        if keys.is_empty() {
            self.complain(self.texts().timeline.no_keys_selected);
            return false;
        }
        match self.keys_as_text() {
            Ok(text) => {
                context.copy_text(text);
                self.say(fill(self.texts().timeline.keys_copied, &[&keys.len()]));
                true
            }
            Err(error) => {
                self.complain_of(&error);
                false
            }
        }
    }

    fn cut_keys(&mut self, context: &Context) {
        if self.copy_keys(context) {
            let said = self.message.take();
            let keys = self.selected_keys();
            self.act(Action::Edits(removed(&self.document, &keys)), context);
            self.select_keys(Vec::new());
            self.message = self.message.take().or(said);
        }
    }

    fn keys_as_text(&self) -> Result<String> {
        let edited = self.document.edited_scene().ok_or(Refused::NoScene)?;
        let tracks = by_track(edited, &self.selected_keys());
        let first = tracks.iter().map(|(of, keys)| of.track.frames()[keys[0]]);
        let first = first.fold(f64::INFINITY, f64::min);
        let moved = |(of, keys): &(Of<'_>, Vec<usize>)| {
            let keys = of.track.keys(keys)?;
            moved(of.track, keys, -first)
        };
        let mut named = Vec::new();
        for of_node in tracks.chunk_by(|(a, _), (b, _)| a.node == b.node) {
            let moved: Result<Vec<Track>> = of_node.iter().map(moved).collect();
            let node = edited.scene().node(of_node[0].0.node)?;
            named.push((node.name.clone(), moved?));
        }
        Document::keys_as_text(&named)
    }

    /// Puts keys in at the playhead, at the channels of the selected nodes that they fit.
    pub(crate) fn paste_keys(&mut self, text: &str) {
        let texts = &self.texts().timeline;
        let nodes = match Document::keys_of_text(text) {
            Ok(nodes) if nodes.is_empty() => return self.complain(texts.no_keys),
            Ok(nodes) => nodes,
            Err(error) => {
                let why = self.without_name(&error);
                return self.complain(fill(texts.keys_not_pasted, &[&why]));
            }
        };
        let mut selected = self.selected_nodes();
        selected.sort_unstable();
        let several = nodes.len() > 1;
        if several && nodes.len() != selected.len() {
            return self.complain(fill(texts.as_many_nodes, &[&nodes.len(), &selected.len()]));
        }
        let pasted = selected.iter().enumerate().map(|(at, &node)| {
            let (_, tracks) = &nodes[if several { at } else { 0 }];
            self.pasted_keys(node, tracks)
        });
        let pasted: Result<Vec<_>> = pasted.collect();
        let pasted: Vec<_> = match pasted {
            Ok(pasted) => pasted.into_iter().flatten().collect(),
            Err(error) => {
                let why = of_edit(self.language(), &error);
                return self.complain(fill(texts.keys_not_pasted, &[&why]));
            }
        };
        if pasted.is_empty() {
            return self.complain(texts.fits_no_channel);
        }
        let (edits, places): (Vec<_>, Vec<_>) = pasted.into_iter().unzip();
        let count: usize = places.iter().map(|(.., frames)| frames.len()).sum();
        if self.edit_all(edits) {
            self.select_keys(keys_at(&self.document, &places));
            self.say_done(fill(self.texts().timeline.keys_pasted, &[&count]));
        }
    }

    /// The edits that put keys into a node, and where these lie then.
    fn pasted_keys(&self, node: usize, tracks: &[Track]) -> Result<Vec<(Edit, Place)>> {
        let edited = self.document.edited_scene().ok_or(Refused::NoScene)?;
        let of = edited.scene().node(node)?;
        // No minus zero.
        let by = self.previewed_frame()?.round() + 0.0;
        let mut all = Vec::new();
        for track in tracks.iter().filter(|track| fits(of, track)) {
            let moved = moved(track, converted(track, track.interpolation()), by)?;
            let there = of.keys().track(track.channel());
            let channel = there.map_or(track.channel(), Track::channel).clone();
            let place = (node, channel.clone(), moved.frames().to_vec());
            let part = match there {
                Some(there) => Part::Keys {
                    node,
                    channel,
                    remove: Vec::new(),
                    put: converted(&moved, there.interpolation()),
                },
                None => Part::track(node, channel, Some(moved))?,
            };
            all.push((Edit::Part(Box::new(part)), place));
        }
        Ok(all)
    }
}

/// Whether a node has a channel for these keys.
fn fits(of: &Node, track: &Track) -> bool {
    use Channel::{Position, Rotation, Zoom};
    let channel = track.channel();
    if of.path().is_some() && matches!(channel, Position | Rotation | Zoom) {
        return false;
    }
    let there = of.keys().track(channel);
    match (channel, there) {
        (Rotation, _) => true,
        (_, Some(there)) => there.width() == track.width(),
        (_, None) => channel.width(of).is_ok_and(|width| width == track.width()),
    }
}

/// Keys of a track, later by a number of frames.
fn moved(track: &Track, mut keys: KeyList, by: f64) -> Result<Track> {
    keys.frames.iter_mut().for_each(|frame| *frame += by);
    of_keys(track, track.interpolation().clone(), keys)
}

#[cfg(test)]
#[path = "track_clipboard_tests.rs"]
mod tests;
