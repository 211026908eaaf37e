//! Keys by the clipboard, where the timeline has the keyboard: as the text of tracks in a `.vid` file,
//! their frames counted from the first one.

use egui::{Context, Event, Key, Modifiers};
use vides_document::error::{Refused, Result};
use vides_document::{Document, Edit};
use vides_engine::scene::{Channel, Interpolation, KeyList, Node, Part, Track};

use super::key_motion::{by_track, keys_at, removed};
use super::track_menu::{angles, by_angles, quaternions, smooth};
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
            self.act(Action::Edits(removed(&keys)), context);
            self.select_keys(Vec::new());
            self.message = self.message.take().or(said);
        }
    }

    fn keys_as_text(&self) -> Result<String> {
        let edited = self.document.edited_scene().ok_or(Refused::NoScene)?;
        let mut nodes: Vec<(usize, Vec<Track>)> = Vec::new();
        for (node, channel, which) in by_track(&self.selected_keys()) {
            let of = edited.scene().node(node)?;
            let Some(track) = of.keys().track(&channel) else {
                continue;
            };
            let KeyList {
                frames,
                values,
                shape,
            } = track.keys(&which)?;
            let by = track.interpolation().clone();
            let (before, after) = track.extrapolation();
            let part = Track::new(channel, by, frames, values, shape)?;
            let part = part.with_extrapolation(before, after)?;
            match nodes.last_mut() {
                Some((last, tracks)) if *last == node => tracks.push(part),
                _ => nodes.push((node, vec![part])),
            }
        }
        let tracks = nodes.iter().flat_map(|(_, tracks)| tracks);
        let first = tracks
            .map(|track| track.ends().0)
            .fold(f64::INFINITY, f64::min);
        let mut named = Vec::new();
        for (node, tracks) in nodes {
            let moved: Result<Vec<Track>> =
                tracks.iter().map(|track| moved(track, -first)).collect();
            named.push((edited.scene().node(node)?.name.clone(), moved?));
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
        let pasted: Vec<Pasted> = match pasted {
            Ok(pasted) => pasted.into_iter().flatten().collect(),
            Err(error) => {
                let why = of_edit(self.language(), &error);
                return self.complain(fill(texts.keys_not_pasted, &[&why]));
            }
        };
        if pasted.is_empty() {
            return self.complain(texts.fits_no_channel);
        }
        let (edits, places): (Vec<_>, Vec<_>) = pasted
            .into_iter()
            .map(|of| (of.edit, ((of.node, of.channel), of.frames)))
            .unzip();
        let count: usize = places.iter().map(|(_, frames)| frames.len()).sum();
        if self.edit_all(edits) {
            self.select_keys(keys_at(&self.document, places.into_iter()));
            self.say_done(fill(self.texts().timeline.keys_pasted, &[&count]));
        }
    }

    /// The edits that put keys into a node.
    fn pasted_keys(&self, node: usize, tracks: &[Track]) -> Result<Vec<Pasted>> {
        let edited = self.document.edited_scene().ok_or(Refused::NoScene)?;
        let of = edited.scene().node(node)?;
        // No minus zero.
        let by = self.previewed_frame()?.round() + 0.0;
        let mut all = Vec::new();
        for track in tracks.iter().filter(|track| fits(of, track)) {
            let moved = moved(track, by)?;
            let frames = moved.frames().to_vec();
            let there = of.keys().track(track.channel());
            let channel = there.map_or(track.channel(), Track::channel).clone();
            let part = match there {
                Some(there) => Part::Keys {
                    node,
                    channel: channel.clone(),
                    remove: Vec::new(),
                    put: as_keys_of(there, &moved),
                },
                None => Part::track(node, channel.clone(), Some(moved))?,
            };
            all.push(Pasted {
                node,
                channel,
                frames,
                edit: Edit::Part(Box::new(part)),
            });
        }
        Ok(all)
    }
}

/// Keys that come into a track.
struct Pasted {
    node: usize,
    channel: Channel,
    frames: Vec<f64>,
    edit: Edit,
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

/// The same keys, later by a number of frames.
fn moved(track: &Track, by: f64) -> Result<Track> {
    let frames = track.frames().iter().map(|frame| frame + by).collect();
    let (values, shape) = (track.values().to_vec(), track.shape().to_vec());
    let (channel, manner) = (track.channel().clone(), track.interpolation().clone());
    let (before, after) = track.extrapolation();
    let moved = Track::new(channel, manner, frames, values, shape)?;
    Ok(moved.with_extrapolation(before, after)?)
}

/// Keys as a track has them that goes from key to key in its own way.
fn as_keys_of(there: &Track, new: &Track) -> KeyList {
    let turns = [there, new].map(|track| by_angles(track.interpolation()));
    let values = match turns {
        [false, true] => quaternions(new),
        [true, false] => angles(new),
        _ => new.values().to_vec(),
    };
    let frames = new.frames().to_vec();
    let same = there.interpolation() == new.interpolation();
    let shape = match there.interpolation() {
        Interpolation::Hermite | Interpolation::Tcb if same => new.shape().to_vec(),
        Interpolation::Hermite => smooth(&frames, &values, there.width()),
        Interpolation::Tcb => vec![0.0; 3 * frames.len()],
        _ => Vec::new(),
    };
    KeyList {
        frames,
        values,
        shape,
    }
}

#[cfg(test)]
#[path = "track_clipboard_tests.rs"]
mod tests;
