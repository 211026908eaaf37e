//! Edits of the scene: a part is replaced, together with all that must follow.
//!
//! The path that is edited lives beside the scene ([`super::edited_scene`]), which has it as it was
//! when its node was chosen. Where an edit needs it as it is now, it is put there first.

use std::collections::HashSet;
use std::sync::Arc;

use vides_engine::scene::{
    Channel, FollowPath, Keep, KeyList, Kind, Node, Part, Rest, Scene, Track, Warnings,
};

use super::content::Content;
use super::edit::Selection;
use super::edited_scene::EditedScene;
use crate::error::{Invalid, Refused, Result};

/// Edits the scene. A path alone becomes one first, and stays a path if nothing changes.
pub(super) fn edit(
    content: &mut Content,
    edit: impl FnOnce(&mut Content) -> Result<()>,
) -> Result<()> {
    if content.scene.is_some() {
        return edit(content);
    }
    let of_path = Arc::new(EditedScene::of_path(&content.path)?);
    let mut of_scene = content.clone();
    of_scene.scene = Some(Arc::clone(&of_path));
    of_scene.comments = Arc::new(content.comments.in_scene());
    edit(&mut of_scene)?;
    if !Arc::ptr_eq(edited(&of_scene)?, &of_path) {
        *content = of_scene;
    }
    Ok(())
}

fn edited(content: &Content) -> Result<&Arc<EditedScene>> {
    Ok(content.scene.as_ref().ok_or(Refused::NoScene)?)
}

fn edited_mut(content: &mut Content) -> Result<&mut EditedScene> {
    let edited = content.scene.as_mut().ok_or(Refused::NoScene)?;
    Ok(Arc::make_mut(edited))
}

/// The scene with the edited path as it is now.
fn present(content: &Content) -> Result<Scene> {
    edited(content)?.with(&content.path)
}

/// Replaces a part of the scene, unless it is equal.
fn put(content: &mut Content, part: Part) -> Result<()> {
    match edited(content)?.scene().has(&part) {
        true => Ok(()),
        false => edited_mut(content)?.apply(part),
    }
}

/// The same, with all that must follow.
pub(super) fn part(content: &mut Content, part: Part) -> Result<()> {
    let own = edited(content)?.node();
    match part {
        Part::Remove(which) => remove(content, which),
        Part::Path { node, path } if own == Some(node) => edited_path(content, node, path),
        Part::Path { node, path } => {
            let count = path.as_ref().map_or(0, |path| path.path().points.len());
            unpin(content, |pin, at| pin == node && at >= count)?;
            put(content, Part::Path { node, path })
        }
        Part::Pin {
            node,
            point,
            marker,
        } if own == Some(node) => {
            let (edited, path) = (edited(content)?, Arc::clone(&content.path));
            edited.check_pin(&path, point, marker.as_deref())?;
            let old = edited.pinned().find(|pin| pin.0 == point);
            if old.map(|pin| pin.1) != marker {
                edited_mut(content)?.pin(point, marker);
            }
            Ok(())
        }
        Part::Marker { name, frame: None } => {
            rename_pins(content, &name, None)?;
            put(content, Part::Marker { name, frame: None })
        }
        Part::Keys {
            node,
            channel,
            remove,
            put,
        } => keys(content, node, channel, remove, put),
        Part::RemoveShape { node, at } => {
            if edited(content)?.scene().object(node)?.shapes().len() == 1 {
                put(content, Part::track(node, Channel::Weights, None)?)?;
            }
            put(content, Part::RemoveShape { node, at })
        }
        Part::RemoveDeformation { node, at } => {
            let tracks = edited(content)?.scene().node(node)?.tracks_of(at);
            let channels: Vec<Channel> = tracks.map(|track| track.channel().clone()).collect();
            for channel in channels {
                put(content, Part::track(node, channel, None)?)?;
            }
            put(content, Part::RemoveDeformation { node, at })
        }
        other => put(content, other),
    }
}

/// Frees points of paths in the scene by node and number.
fn unpin(content: &mut Content, which: impl Fn(usize, usize) -> bool) -> Result<()> {
    let pins = edited(content)?.scene().pins().iter();
    let pins = pins.map(|pin| (pin.node, pin.point));
    let free: Vec<_> = pins.filter(|pin| which(pin.0, pin.1)).collect();
    free.into_iter().try_for_each(|(node, point)| {
        let marker = None;
        put(
            content,
            Part::Pin {
                node,
                point,
                marker,
            },
        )
    })
}

/// Pins all that is pinned to a marker to another one, or frees it.
fn rename_pins(content: &mut Content, marker: &str, to: Option<&str>) -> Result<()> {
    let pins = edited(content)?.scene().pins().iter();
    let pins = pins.filter(|pin| pin.marker == marker);
    let pinned: Vec<_> = pins.map(|pin| (pin.node, pin.point)).collect();
    for (node, point) in pinned {
        let marker = to.map(str::to_owned);
        put(
            content,
            Part::Pin {
                node,
                point,
                marker,
            },
        )?;
    }
    if edited(content)?.pinned().any(|pin| pin.1 == marker) {
        edited_mut(content)?.rename_pins(marker, to);
    }
    Ok(())
}

/// Gives a marker another name.
pub(super) fn rename_marker(content: &mut Content, from: String, to: String) -> Result<()> {
    let scene = edited(content)?.scene();
    let frame = scene.marker(&from);
    let frame = frame.ok_or_else(|| Invalid::NoMarker((&from).into()))?;
    if from == to {
        return Ok(());
    }
    if scene.marker(&to).is_some() {
        return Err(Invalid::MarkerTwice((&to).into()).into());
    }
    let name = to.clone();
    let frame = Some(frame);
    put(content, Part::Marker { name, frame })?;
    rename_pins(content, &from, Some(&to))?;
    let (name, frame) = (from, None);
    put(content, Part::Marker { name, frame })
}

/// Keys that lie where others come give way. If none is left, the last one's value stays.
fn keys(
    content: &mut Content,
    node: usize,
    channel: Channel,
    mut remove: Vec<usize>,
    come: KeyList,
) -> Result<()> {
    let of = edited(content)?.scene().node(node)?;
    if let Some(track) = of.keys().track(&channel) {
        let frames = track.frames();
        remove.extend(come.frames.iter().filter_map(|frame| {
            let at = frames.partition_point(|key| key < frame);
            (frames.get(at) == Some(frame)).then_some(at)
        }));
        remove.sort_unstable();
        remove.dedup();
        let none_left = come.is_empty() && remove.len() == frames.len();
        if none_left && remove.last() == Some(&(frames.len() - 1)) {
            let rest = at_rest(of, node, track)?;
            put(content, Part::track(node, channel, None)?)?;
            return rest.map_or(Ok(()), |rest| put(content, rest));
        }
    }
    put(
        content,
        Part::Keys {
            node,
            channel,
            remove,
            put: come,
        },
    )
}

/// Edits the path of another node.
pub(super) fn edit_node(content: &mut Content, node: Option<usize>) -> Result<()> {
    if content.node() == node {
        return Ok(());
    }
    synchronise(content)?;
    choose(content, node)
}

fn synchronise(content: &mut Content) -> Result<()> {
    let path = Arc::clone(&content.path);
    edited_mut(content)?.synchronise(&path)
}

fn choose(content: &mut Content, node: Option<usize>) -> Result<()> {
    let path = edited_mut(content)?.choose(node)?;
    content.info.check(path.space)?;
    content.put_path(path);
    content.selection = Selection::default();
    Ok(())
}

fn edited_path(content: &mut Content, node: usize, path: Option<Arc<FollowPath>>) -> Result<()> {
    if let Some(follow) = path {
        put(
            content,
            Part::Start {
                node,
                start_frame: follow.start_frame(),
                beyond: follow.extrapolation(),
            },
        )?;
        return content.replace_path(follow.path().try_clone()?, |point| point);
    }
    synchronise(content)?;
    choose(content, None)?;
    unpin(content, |pin, _| pin == node)?;
    put(content, Part::Path { node, path: None })
}

fn remove(content: &mut Content, which: Vec<usize>) -> Result<()> {
    let gone = edited(content)?.scene().with_all_in(&which)?;
    if content.node().is_some_and(|node| gone[node]) {
        synchronise(content)?;
        let mut left = edited(content)?.scene().nodes().iter().enumerate();
        let camera = left.find(|(at, node)| {
            !gone[*at] && matches!(node.kind, Kind::Camera(_)) && node.path().is_some()
        });
        let camera = camera.map(|(at, _)| at);
        choose(content, camera)?;
    }
    put(content, Part::Remove(which))
}

/// Puts nodes behind the others; they count on from there.
pub(super) fn add(content: &mut Content, nodes: Vec<Node>) -> Result<()> {
    match nodes.is_empty() {
        true => Ok(()),
        false => edited_mut(content)?.add(nodes),
    }
}

/// Copies nodes with all that is in them. Aims among them are copied; pins are not.
pub(super) fn copy(content: &mut Content, which: &[usize]) -> Result<()> {
    let scene = present(content)?;
    let within = scene.with_all_in(which)?;
    let count = scene.nodes().len();
    let places: Vec<usize> = (0..count).filter(|&at| within[at]).collect();
    let copied = |at: usize| places.binary_search(&at).map_or(at, |place| count + place);
    let mut names = HashSet::new();
    let nodes = places.iter().map(|&at| {
        let mut node = scene.nodes()[at].clone();
        node.name = new_name(&scene, &names, &node.name);
        names.insert(node.name.clone());
        node.parent = node.parent.map(copied);
        node.aim = node.aim.map(copied);
        node
    });
    let nodes = nodes.collect();
    add(content, nodes)
}

/// Puts a node into another one.
pub(super) fn parent(
    content: &mut Content,
    node: usize,
    parent: Option<usize>,
    keep: Keep,
) -> Result<()> {
    let old = edited(content)?.scene().node(node)?;
    let (aim, name) = (old.aim, &old.name);
    match keep {
        Keep::Way => {
            let parts = present(content)?.way_in(node, parent)?;
            return parts.into_iter().try_for_each(|one| part(content, one));
        }
        Keep::Place => {
            let place = |error: vides_engine::Error| {
                error.at(vides_engine::error::Place::Node(name.into()))
            };
            let rest = present(content)?.rest_in(node, parent).map_err(place)?;
            let rest = Box::new(rest);
            put(content, Part::Rest { node, rest })?;
        }
        Keep::Numbers => {}
    }
    put(content, Part::Links { node, parent, aim })
}

/// A name that no node has: this one with a number.
pub(super) fn new_name(scene: &Scene, others: &HashSet<String>, name: &str) -> String {
    let stem = name.rsplit_once(' ').filter(|(_, number)| {
        !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
    });
    let stem = stem.map_or(name, |(stem, _)| stem);
    let names = (2_u32..).map(|number| format!("{stem} {number}"));
    let mut free = names.filter(|name| scene.find(name).is_none() && !others.contains(name));
    free.next().unwrap_or_default()
}

/// The part that gives a node the value of a track's last key at rest; none for the host's own.
fn at_rest(of: &Node, node: usize, track: &Track) -> Result<Option<Part>> {
    let last = track.ends().1;
    let key = &track.values()[(track.frames().len() - 1) * track.width()..];
    let mut rest = Rest::of(of);
    let values = &mut rest.values;
    match (track.channel(), key, &of.kind) {
        (Channel::Rotation, ..) => {
            values.rotation = track.rotation(last, &mut Warnings::default());
        }
        (Channel::Weights, ..) => {
            let weights = key.to_vec();
            return Ok(Some(Part::Weights { node, weights }));
        }
        (Channel::Deformation { at, parameter }, _, Kind::Object(object)) => {
            let (mut deformation, bounds) = object.deformations()[*at].clone();
            if let Some(numbers) = deformation.channel_mut(parameter) {
                numbers.copy_from_slice(key);
            }
            return Ok(Some(Part::Deformation {
                node,
                at: *at,
                deformation,
                bounds,
            }));
        }
        _ if values.set(track.channel(), key) => {}
        _ => return Ok(None),
    }
    let rest = Box::new(rest);
    Ok(Some(Part::Rest { node, rest }))
}

/// The paths of nodes other than the edited one become what their pins require.
pub(super) fn hold_pins(content: &mut Content) -> Result<()> {
    let scene = edited(content)?.scene();
    let pins = scene.pins().chunk_by(|a, b| a.node == b.node);
    let nodes = pins.map(|pins| pins[0].node);
    let mut held = Vec::new();
    for node in nodes.filter(|&node| content.node() != Some(node)) {
        if let Some(path) = scene.path_held_by_pins(node)? {
            held.push(Part::path(node, Some(path))?);
        }
    }
    held.into_iter().try_for_each(|part| put(content, part))
}

/// A scene of nothing but a camera on a path is that path.
pub(super) fn path_again(content: &mut Content) -> Result<()> {
    edit_node(content, Some(0))?;
    let camera = edited(content)?.scene().ids()[0];
    content.comments = Arc::new(content.comments.of_path_alone(camera));
    content.scene = None;
    Ok(())
}
