//! `vides info --json`: the same as the tables say, for programs. Points and views count from 1.

use std::path::Path;

use serde_json::{Value, json};
use vides::document::{Info, SceneDocument};
use vides::path::{CameraPath, CurveParameters, Timeline};
use vides::scene::{Kind, Node, Scene};
use vides::shared_list::SharedList;

use super::failure::json as json_text;
use super::info_parts::{changed, last_of, modes};
use super::input;

pub(super) fn object(file: &Path, document: &SceneDocument) -> vides::Result<String> {
    let info = &document.info;
    let mut object = match document.path_alone() {
        Some(path) => of_path(path, info)?,
        None => of_scene(&document.scene, info),
    };
    object["file"] = input::name(file).into();
    object["title"] = info.title.as_str().into();
    object["comment"] = info.comment.as_str().into();
    object["fps"] = info.fps.into();
    Ok(json_text(&format!("{object:#}")))
}

fn of_path(path: &CameraPath, info: &Info) -> vides::Result<Value> {
    let timeline = Timeline::new(path)?;
    let frames = timeline.frame_count()?;
    let [orientation_mode, zoom_mode] = modes(path);
    let (speeds, space) = (path.base_frames, path.space);
    Ok(json!({
        "kind": "path",
        "closed": path.closed,
        "curve": path.curve.name(),
        "orientation_mode": orientation_mode,
        "zoom_mode": zoom_mode,
        "length": timeline.length(),
        "frames": frames,
        "first_frame": info.first_frame,
        "seconds": frames as f64 / info.fps,
        "base_speeds": {
            "move_frames": speeds.movement,
            "turn_frames": speeds.turning,
            "zoom_frames": speeds.zoom,
            "roll_frames": speeds.rolling,
        },
        "space": {
            "centre": space.centre.to_array(),
            "half_size": space.half_size,
            "up": space.up.name(),
            "unit": info.unit,
        },
        "object": {
            "points": info.object.len(),
            "lines": info.object.iter().filter(|point| point.draw).count(),
            "file": info.object.source().map(|source| &source.file),
        },
        "points": points(path),
        "sections": sections(path, info, &timeline),
    }))
}

fn points(path: &CameraPath) -> Value {
    let each = path.points.iter().enumerate().map(|(at, point)| {
        let tcb = path.tcb(at);
        json!({
            "name": point.name,
            "position": point.position.to_array(),
            "views": point.orientations.len(),
            "preset": match point.curve {
                CurveParameters::Preset(preset) => Some(preset),
                CurveParameters::Own(_) => None,
            },
            "tension": tcb.tension,
            "continuity": tcb.continuity,
            "bias": tcb.bias,
        })
    });
    each.collect()
}

fn sections(path: &CameraPath, info: &Info, timeline: &Timeline) -> Value {
    // The very first pose belongs to no section.
    let mut next = i64::from(info.first_frame) + 1;
    let each = (0..timeline.section_count()).map(|index| {
        let section = timeline.section(index);
        let (point, view) = (section.point, section.orientation);
        let views = &path.points[point].orientations;
        let to = match view + 1 < views.len() {
            true => [point + 1, view + 2],
            false => [(point + 1) % path.points.len() + 1, 1],
        };
        let (changes, by, unit) = changed(&section, path.space.half_size);
        let moves = section.frames > 0;
        next += if moves {
            i64::from(views[view].hold)
        } else {
            0
        };
        let first = next;
        next += section.frames as i64;
        json!({
            "from": [point + 1, view + 1],
            "to": to,
            "changes": changes,
            "by": by,
            "unit": unit,
            "hold_frames": views[view].hold,
            "frames": section.frames,
            "first_frame": moves.then_some(first),
            "last_frame": moves.then(|| last_of(first, section.frames)),
        })
    });
    each.collect()
}

fn of_scene(scene: &Scene, info: &Info) -> Value {
    let (first, last) = scene.frame_range();
    // As people count them.
    let seen = |frame: f64| frame + f64::from(info.first_frame) - 1.0;
    let markers = scene.markers().iter().map(|marker| {
        let pins = scene.pins().iter().filter(|pin| pin.marker == marker.name);
        let pins =
            pins.map(|pin| json!({ "node": scene.nodes()[pin.node].name, "point": pin.point + 1 }));
        json!({
            "frame": seen(marker.frame),
            "name": marker.name,
            "pins": pins.collect::<Value>(),
        })
    });
    json!({
        "kind": "scene",
        "camera": scene.shown_camera().map(|at| &scene.nodes()[at].name),
        "first_frame": seen(first),
        "last_frame": seen(last),
        "seconds": (last - first + 1.0) / info.fps,
        "nodes": scene.nodes().iter().map(|one| node(one, scene.nodes(), &seen)).collect::<Value>(),
        "markers": markers.collect::<Value>(),
    })
}

fn node(node: &Node, nodes: &SharedList<Node>, seen: &dyn Fn(f64) -> f64) -> Value {
    let name = |at: Option<usize>| at.map(|at| &nodes[at].name);
    let tracks = node.keys().tracks().iter().map(|track| {
        let (first, last) = track.ends();
        json!({
            "channel": track.channel().to_string(),
            "interpolation": track.interpolation().to_string(),
            "keys": track.frames().len(),
            "first_frame": seen(first),
            "last_frame": seen(last),
            "after": track.extrapolation().1.name(),
        })
    });
    json!({
        "name": node.name,
        "kind": node.kind.name(),
        "parent": name(node.parent),
        "aim": name(node.aim),
        "path": node.path().map(|path| json!({
            "points": path.path().points.len(),
            "start_frame": seen(path.start_frame()),
        })),
        "tracks": tracks.collect::<Value>(),
        "mesh": match &node.kind {
            Kind::Object(object) => json!({
                "points": object.mesh().points.len(),
                "lines": object.mesh().lines.len(),
                "triangles": object.mesh().triangles.len(),
                "shapes": object.shapes().len(),
                "deformations": object.deformations().len(),
                "file": object.source().map(|source| &source.file),
            }),
            _ => Value::Null,
        },
    })
}
