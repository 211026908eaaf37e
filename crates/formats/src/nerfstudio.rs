//! `camera_path.json` of nerfstudio (Tancik et al. 2023), what `ns-render camera-path` renders: one
//! entry a frame, and the keys that its viewer shows and joins by a spline of its own: Kochanek and
//! Bartels, its tension in `smoothness_value`, natural or closed ends. The camera looks along −z, z
//! is up, fields of view are vertical and in degrees.

use std::io::Write;

use glam::DMat4;
use vides_document::error::TooMany;
use vides_engine::limits::MAX_FRAMES;
use vides_engine::math::camera::CameraAxes;
use vides_engine::path::{Pose, Timeline, Up};
use vides_engine::scene::Channel;

use super::content::{Content, Recording};
use super::error::{Cause, Error, Result, Wanted};
use super::flight::Flight;
use super::format::Format;
use super::keyframes::Keyframes;
use super::lens::Lenses;
use super::loss::{Loss, Report};
use super::options::Options;
use super::source::Source;
use super::tree::{self, At};
use super::{blocks, convention, rows};

pub(super) static NERFSTUDIO: Format = Format {
    name: "nerfstudio",
    title: "nerfstudio",
    file_names: &["camera_path.json"],
    up: Some(Up::Z),
    recognises,
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

/// A longer `dataparser_transforms.json` is none.
const MAX_TRANSFORMS: u64 = 1 << 20;

fn recognises(source: &Source) -> bool {
    let text = source.beginning();
    let has = |key: &str| text.contains(key);
    // SuperSplat has keyframes in its tracks.
    let keys = has("\"keyframes\"") && !has("\"animTracks\"");
    text.trim_start().starts_with('{') && (has("\"camera_path\"") || keys)
}

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    let document = tree::parse(&source.bytes)?;
    let root = At::root(&document);
    let mut recording = Recording {
        up: NERFSTUDIO.up,
        fps: root.get("fps").map(At::positive).transpose()?,
        ..Recording::default()
    };
    let mut lenses = Lenses::default();
    let path = root.get("camera_path").map(At::list).transpose()?;
    let path = path.filter(|path| path.len() > 0);
    if let Some(path) = path {
        for entry in path {
            let matrix = entry.need("camera_to_world")?;
            let rows = DMat4::from_cols_array(&matrix.numbers()?).transpose();
            let zoom = zoom(entry.get("fov"), &mut lenses)?;
            recording.push(matrix.pose(rows, CameraAxes::OpenGl, zoom)?)?;
        }
        if let (None, Some(seconds)) = (recording.fps, root.get("seconds")) {
            recording.fps = Some(recording.poses.len() as f64 / seconds.positive()?);
        }
    }
    let has_keys = root.get("keyframes").map(At::list).transpose()?;
    let has_keys = has_keys.is_some_and(|keys| keys.len() > 0);
    if recording.poses.is_empty() || (has_keys && !is_ours(root)?) {
        let mut of_keys = Lenses::default();
        match read_keys(root, &mut recording, &mut of_keys, report) {
            Ok(()) => lenses = of_keys,
            Err(error) if recording.poses.is_empty() => return Err(error),
            // What is rendered is there all the same.
            Err(error) => report.add(Loss::LeftOut((&error).into())),
        }
    }
    lenses.tell(report);
    tell_rest(root, recording.poses.len(), report);
    tell_world(source, report);
    Ok(Content::Poses(recording))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    report.add(Loss::OwnSpline);
    let head = head(flight)?;
    let [width, height] = flight.size();
    flight.write_poses(head, out, |_, text, index, pose| {
        text.extend_from_slice(if index == 0 { b"\n    {" } else { b",\n    {" });
        push_camera(text, "camera_to_world", pose, width / height);
        text.push(b'}');
    })?;
    out.write_all(b"\n  ]\n}\n").map_err(blocks::failed)
}

/// The zoom of a vertical field of view in degrees.
fn zoom(degrees: Option<At<'_>>, lenses: &mut Lenses) -> Result<f64> {
    let Some(degrees) = degrees else {
        return Ok(lenses.without());
    };
    let field = degrees.positive()?.to_radians();
    Ok(lenses.clamped(convention::zoom_of_field(field)))
}

/// Whether VIDES wrote this: its keys are those of its own curve, which no spline of theirs joins.
/// Files of old have no such mark, but a default transition of one frame that no key uses.
fn is_ours(root: At<'_>) -> Result<bool> {
    if root.get("generator").is_some_and(|at| at.value == "VIDES") {
        return Ok(true);
    }
    let number = |key| root.get(key).and_then(|at| at.value.as_f64());
    let (Some(step), Some(fps)) = (number("default_transition_sec"), number("fps")) else {
        return Ok(false);
    };
    let a_frame = (step * fps - 1.0).abs() < 1e-9 && number("smoothness_value") == Some(0.0);
    let mut keys = root.need("keyframes")?.list()?.enumerate();
    let own = |key: At<'_>| {
        key.get("override_transition_enabled")
            .map(|at| at.value == true)
    };
    Ok(a_frame && keys.all(|(at, key)| own(key) == Some(at > 0)))
}

/// The keys of the viewer.
fn read_keys(
    root: At<'_>,
    recording: &mut Recording,
    lenses: &mut Lenses,
    report: &mut Report,
) -> Result<()> {
    report.add(Loss::OwnSpline);
    let mut keyframes = Keyframes::default();
    let mut timed = true;
    for key in root.need("keyframes")?.list()? {
        let matrix = key.need("matrix")?;
        let rows = match matrix.value.as_str() {
            // The old viewer in the browser: a text, column by column.
            Some(text) => {
                let numbers = tree::parse(text.as_bytes())
                    .and_then(|value| At::root(&value).numbers())
                    .map_err(|_| matrix.expected(Wanted::Numbers(16)))?;
                DMat4::from_cols_array(&numbers)
            }
            None => DMat4::from_cols_array(&matrix.numbers()?).transpose(),
        };
        let zoom = zoom(key.get("fov").or(root.get("default_fov")), lenses)?;
        let pose = matrix.pose(rows, CameraAxes::OpenGl, zoom)?;
        if keyframes.poses.len() >= MAX_FRAMES {
            return Err(Error::Document(TooMany::SceneFrames(MAX_FRAMES).into()));
        }
        keyframes.poses.try_reserve(1)?;
        keyframes.poses.push(pose);
        let seconds = &mut keyframes.seconds;
        let before = seconds.last().copied();
        match key_seconds(root, key, before)? {
            Some(time) if before.is_some_and(|before| time <= before) => {
                return Err(key.wrong(Cause::Order));
            }
            Some(time) => {
                seconds.try_reserve(1)?;
                seconds.push(time);
            }
            None => timed = false,
        }
    }
    close(root, &mut keyframes)?;
    if recording.poses.is_empty() {
        recording.poses.try_reserve(keyframes.poses.len())?;
        recording.poses.extend_from_slice(&keyframes.poses);
        recording.seconds = timed.then(|| keyframes.seconds.clone());
    }
    match timed {
        true if keyframes.poses.len() > 1 => recording.keyframes = Some(Box::new(keyframes)),
        true => {}
        false => report.add(Loss::Times),
    }
    Ok(())
}

/// The tension of the viewer's spline, and whether it is closed.
fn close(root: At<'_>, keyframes: &mut Keyframes) -> Result<()> {
    let first = root.need("keyframes")?.list()?.next();
    let Some(first) = first.filter(|_| keyframes.poses.len() > 1) else {
        return Ok(());
    };
    // Half the tangents of the old viewer's are the tension of three.js.
    let old = first.get("properties").is_some();
    let smooth = root.get("smoothness_value").map(At::number).transpose()?;
    let tension = smooth.map_or(0.0, |value| if old { 1.0 - 2.0 * value } else { value });
    keyframes.tension = tension.clamp(-1.0, 1.0);
    if !is_closed(root) {
        return Ok(());
    }
    keyframes.closing = match old {
        // Its shares are of the way to the last key.
        true => {
            let seconds = root.need("seconds")?.positive()?;
            let count = keyframes.poses.len() as f64;
            let share = (count - 1.0) / count;
            keyframes.seconds.iter_mut().for_each(|time| *time *= share);
            Some(seconds / count)
        }
        false => transition(root, first)?,
    };
    Ok(())
}

/// When a key is reached: by its own seconds or those of all from the key before on, or, from the
/// old viewer, by its share of the whole.
fn key_seconds(root: At<'_>, key: At<'_>, before: Option<f64>) -> Result<Option<f64>> {
    if let Some(properties) = key.get("properties") {
        let wrong = |_| properties.expected(Wanted::List);
        let list = tree::parse(properties.text()?.as_bytes()).map_err(wrong)?;
        let pairs = list.as_array().map_or(&[][..], Vec::as_slice);
        let time = pairs.iter().find(|pair| pair[0] == "TIME");
        let share = time.and_then(|pair| pair[1].as_f64());
        let seconds = root.get("seconds").map(At::positive).transpose()?;
        return Ok(share
            .zip(seconds)
            .map(|(share, seconds)| share * seconds)
            .filter(|time| time.is_finite()));
    }
    let Some(before) = before else {
        return Ok(Some(0.0));
    };
    Ok(transition(root, key)?.map(|step| before + step))
}

/// How long it takes from the key before to this one, in the first from the last.
fn transition(root: At<'_>, key: At<'_>) -> Result<Option<f64>> {
    let enabled = key.get("override_transition_enabled");
    let own = key.get("override_transition_sec");
    let own = own.filter(|_| enabled.is_none_or(|at| at.value.as_bool() != Some(false)));
    if let Some(step) = own.or(root.get("default_transition_sec")) {
        return step.positive().map(Some);
    }
    // Files of old have none: all are alike.
    let Some(seconds) = root.get("seconds") else {
        return Ok(None);
    };
    let count = root.need("keyframes")?.list()?.len() - usize::from(!is_closed(root));
    Ok(Some(seconds.positive()? / count.max(1) as f64))
}

fn is_closed(root: At<'_>) -> bool {
    root.get("is_cycle").is_some_and(|at| at.value == true)
}

/// Reports by which factor the viewer's world was made of the capture, if a file beside says it.
fn tell_world(source: &Source, report: &mut Report) {
    let file = source.beside("dataparser_transforms.json", MAX_TRANSFORMS);
    let scale = file.and_then(|bytes| At::root(&tree::parse(&bytes)?).need("scale")?.positive());
    if let Ok(scale) = scale {
        report.add(Loss::NormalisedWorld(scale));
    }
}

/// Reports what else such a file holds.
fn tell_rest(root: At<'_>, poses: usize, report: &mut Report) {
    match root.get("camera_type").and_then(|at| at.value.as_str()) {
        None | Some("perspective") => {}
        Some(other) => report.not_taken(&format!("camera_type {other}"), poses),
    }
    if root.get("crop").is_some() {
        report.not_taken("crop", 1);
    }
}

/// All before the first frame: what holds for the whole, and the keys.
fn head(flight: &Flight<'_>) -> Result<Vec<u8>> {
    let mut head = Vec::new();
    let [width, height] = flight.pixels();
    let (fps, count) = (flight.fps(), flight.count());
    let mut pose = [Pose::default()];
    flight.poses(0, &mut pose)?;
    let field = convention::field_of_view(pose[0].zoom).to_degrees();
    // Writing into a vector cannot fail.
    let _ = write!(
        head,
        "{{\n  \"generator\": \"VIDES\",\n  \"camera_type\": \"perspective\",\n  \
         \"render_width\": {width},\n  \"render_height\": {height},\n  \"fps\": {fps},\n  \"seconds\": {:?},\n  \
         \"is_cycle\": false,\n  \"smoothness_value\": 0.0,\n  \"default_fov\": {field:?},\n  \
         \"default_transition_sec\": {:?},\n  \"keyframes\": [",
        count as f64 / fps,
        1.0 / fps,
    );
    let mut before = None;
    for index in keys(flight)? {
        flight.poses(index, &mut pose)?;
        let comma = if before.is_none() { "" } else { "," };
        let _ = write!(head, "{comma}\n    {{");
        push_camera(
            &mut head,
            "matrix",
            &pose[0],
            f64::from(width) / f64::from(height),
        );
        let step = before.map(|before| (index - before) as f64 / fps);
        let (own, step) = step.map_or((false, "null".to_owned()), |step| {
            (true, format!("{step:?}"))
        });
        let _ = write!(
            head,
            ", \"override_transition_enabled\": {own}, \"override_transition_sec\": {step}}}"
        );
        before = Some(index);
    }
    head.extend_from_slice(b"\n  ],\n  \"camera_path\": [");
    Ok(head)
}

fn push_camera(text: &mut Vec<u8>, name: &str, pose: &Pose, aspect: f64) {
    let rows = convention::matrix(pose, CameraAxes::OpenGl).transpose();
    let field = convention::field_of_view(pose.zoom).to_degrees();
    let _ = write!(text, "\"{name}\": [");
    rows::push(text, rows.to_cols_array(), ", ");
    let _ = write!(text, "], \"fov\": {field:?}, \"aspect\": {aspect:?}");
}

/// The poses nearest to the keys of the node, in order; the first and the last are always there.
fn keys(flight: &Flight<'_>) -> Result<Vec<usize>> {
    let node = &flight.scene().nodes()[flight.node()];
    let (first, step) = flight.first_and_step();
    let last = flight.count() - 1;
    let mut keys = vec![0, last];
    let mut push = |frame: f64| -> Result<()> {
        let index = ((frame - first) / step).round();
        if index > 0.0 && index < last as f64 {
            keys.try_reserve(1)?;
            keys.push(index as usize);
        }
        Ok(())
    };
    if let Some(follow) = node.path() {
        let timeline = Timeline::new(follow.path())?;
        let sampler = follow.sampler()?;
        for section in 0..timeline.section_count() {
            let frames = timeline.section(section).frames;
            if frames > 0 {
                // Where a key has rested, and where the next is reached.
                let rested = follow.start_frame() + sampler.first_frame(section) as f64 - 2.0;
                push(rested)?;
                push(rested + frames as f64)?;
            }
        }
    } else {
        let channels = [Channel::Position, Channel::Rotation, Channel::Zoom];
        for track in channels
            .iter()
            .filter_map(|channel| node.keys().track(channel))
        {
            track.frames().iter().try_for_each(|frame| push(*frame))?;
        }
    }
    keys.sort_unstable();
    keys.dedup();
    Ok(keys)
}

#[cfg(test)]
#[path = "nerfstudio_tests.rs"]
mod tests;
