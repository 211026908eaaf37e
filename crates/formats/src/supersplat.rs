//! Camera tracks of SuperSplat (PlayCanvas): the `settings.json` of its viewer, and the document in
//! its `.ssproj` files, which is read only. A key is a place, a target and a field of view in degrees
//! across the longer side of the picture; there is no roll. The world is that of the PLY file, which
//! SuperSplat turns by half a turn about z.

use std::io::Write;

use glam::DVec3;
use vides_document::error::vec_with_room;
use vides_engine::path::Pose;

use super::content::{Content, Recording, SEEN_AS_MOTION};
use super::error::{Cause, Result};
use super::flight::Flight;
use super::format::Format;
use super::lens::Lenses;
use super::loss::{Loss, Report};
use super::options::{DEFAULT_SIZE, Options};
use super::source::Source;
use super::tree::{self, At};
use super::{blocks, convention, rows};

pub(super) static SUPERSPLAT: Format = Format {
    name: "supersplat",
    title: "SuperSplat",
    file_names: &["settings.json"],
    recognises,
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

/// What SuperSplat takes where a file lacks it.
const DEFAULT_FIELD: f64 = 60.0;
const DEFAULT_RATE: f64 = 30.0;
const DEFAULT_FRAMES: f64 = 180.0;

/// Radians of roll that are rounding.
const NO_ROLL: f64 = 1e-6;

fn recognises(source: &Source) -> bool {
    let text = source.beginning();
    let keys = ["\"animTracks\"", "\"poseSets\""];
    text.trim_start().starts_with('{') && keys.iter().any(|key| text.contains(key))
}

/// A camera in SuperSplat's world.
struct Key {
    frame: f64,
    position: DVec3,
    target: DVec3,
    degrees: f64,
}

fn read(source: &Source, options: &Options, report: &mut Report) -> Result<Content> {
    let document = tree::parse(&source.bytes)?;
    let root = At::root(&document);
    let field = root.get("camera").and_then(|camera| camera.get("fov"));
    let field = field.map_or(Ok(DEFAULT_FIELD), At::positive)?;
    let mut keys = Keys {
        rate: DEFAULT_RATE,
        size: options.size.unwrap_or(DEFAULT_SIZE).map(f64::from),
        ..Keys::default()
    };
    match root.get("animTracks") {
        Some(tracks) => keys.read_tracks(tracks, field, report)?,
        None => keys.read_document(root, field, report)?,
    }
    keys.lenses.tell(report);
    if keys.frames.windows(2).any(|pair| pair[1] - pair[0] > 1.5) {
        report.add(Loss::OwnSpline);
    }
    let mut recording = keys.recording;
    let rate = keys.rate;
    recording.fps = (rate >= SEEN_AS_MOTION).then_some(rate);
    keys.frames.iter_mut().for_each(|frame| *frame /= rate);
    recording.seconds = Some(keys.frames);
    Ok(Content::Poses(recording))
}

#[derive(Default)]
struct Keys {
    recording: Recording,
    frames: Vec<f64>,
    rate: f64,
    size: [f64; 2],
    lenses: Lenses,
}

impl Keys {
    /// The first track of a viewer's settings, which is the one that it plays.
    fn read_tracks(&mut self, tracks: At<'_>, field: f64, report: &mut Report) -> Result<()> {
        let mut tracks = tracks.list()?;
        let Some(track) = tracks.next() else {
            return Ok(());
        };
        report.not_taken("animTracks", tracks.len());
        let mode = track.get("loopMode").and_then(|mode| mode.value.as_str());
        report.not_taken(
            "loopMode",
            usize::from(mode.is_some_and(|mode| mode != "none")),
        );
        let keyframes = track.need("keyframes")?;
        let (times, values) = (keyframes.need("times")?, keyframes.need("values")?);
        let count = times.list()?.len();
        let flat = |at: At<'_>, width: usize| numbers(at, width * count);
        let mut frames = flat(times, 1)?;
        match track.get("frameRate") {
            Some(rate) => self.rate = rate.positive()?,
            // Early files have seconds.
            None => frames.iter_mut().for_each(|time| *time *= DEFAULT_RATE),
        }
        let targets = values.need("target")?;
        let (positions, aims) = (flat(values.need("position")?, 3)?, flat(targets, 3)?);
        let fields = values
            .get("fov")
            .map(|fields| flat(fields, 1))
            .transpose()?;
        let vector = |from: &[f64], index: usize| DVec3::from_slice(&from[3 * index..]);
        for (index, &frame) in frames.iter().enumerate() {
            if index > 0 && frame <= frames[index - 1] {
                return Err(times.element(index)?.wrong(Cause::Order));
            }
            let key = Key {
                frame,
                position: vector(&positions, index),
                target: vector(&aims, index),
                degrees: fields.as_ref().map_or(field, |fields| fields[index]),
            };
            self.push(targets.element(3 * index)?, &key)?;
        }
        Ok(())
    }

    /// The keys of a document within its time line.
    fn read_document(&mut self, root: At<'_>, field: f64, report: &mut Report) -> Result<()> {
        let of_line = |key, otherwise| {
            let at = root.get("timeline").and_then(|line| line.get(key));
            at.map_or(Ok(otherwise), At::positive)
        };
        self.rate = of_line("frameRate", DEFAULT_RATE)?;
        let end = of_line("frames", DEFAULT_FRAMES)?;
        let mut sets = root.need("poseSets")?.list()?;
        let Some(set) = sets.next() else {
            return Ok(());
        };
        let poses = set.need("poses")?.list()?;
        let mut keys = vec_with_room(poses.len())?;
        for (index, pose) in poses.enumerate() {
            let otherwise = index as f64 * self.rate;
            let target = pose.need("target")?;
            let key = Key {
                frame: pose.get("frame").map_or(Ok(otherwise), At::number)?,
                position: pose.need("position")?.numbers::<3>()?.into(),
                target: target.numbers::<3>()?.into(),
                degrees: pose.get("fov").map_or(Ok(field), At::positive)?,
            };
            keys.push((target, key));
        }
        let all = keys.len();
        keys.retain(|(_, key)| key.frame < end);
        report.not_taken("a pose beyond the time line", all - keys.len());
        keys.sort_by(|(_, a), (_, b)| a.frame.total_cmp(&b.frame));
        for (target, key) in keys {
            if self
                .frames
                .last()
                .is_some_and(|&before| key.frame <= before)
            {
                return Err(target.wrong(Cause::Order));
            }
            self.push(target, &key)?;
        }
        Ok(())
    }

    fn push(&mut self, target: At<'_>, key: &Key) -> Result<()> {
        let view = (key.target - key.position).try_normalize();
        let view = view.ok_or_else(|| target.wrong(Cause::NoRotation))?;
        let half = (0.5 * key.degrees.to_radians()).tan() / across(self.size);
        let field = 2.0 * half.atan();
        let to_file = convention::supersplat;
        self.recording.push(Pose {
            vrp: to_file(key.position).to_array(),
            vpn: to_file(view).to_array(),
            vup: to_file(up_of(view)).to_array(),
            zoom: self.lenses.clamped(convention::zoom_of_field(field)),
        })?;
        self.frames.try_reserve(1)?;
        self.frames.push(key.frame);
        Ok(())
    }
}

/// A list of exactly this many numbers.
fn numbers(at: At<'_>, wanted: usize) -> Result<Vec<f64>> {
    let list = at.list()?;
    let found = list.len();
    if found != wanted {
        return Err(at.wrong(Cause::NumberCount { wanted, found }));
    }
    let mut numbers = vec_with_room(found)?;
    for number in list {
        numbers.push(number.number()?);
    }
    Ok(numbers)
}

/// Where the top of the picture is in SuperSplat: y, and what turns there if it looks along y.
fn up_of(view: DVec3) -> DVec3 {
    let up = DVec3::Y - view * view.y;
    if view.x * view.x + view.z * view.z > 1e-8 {
        up.normalize()
    } else {
        DVec3::Z * view.y.signum()
    }
}

/// How much longer the longer side of a picture is than its height.
fn across([width, height]: [f64; 2]) -> f64 {
    (width / height).max(1.0)
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    let poses = flight.all_poses()?;
    let across = across(flight.size());
    let degrees = |pose: &Pose| {
        let half = (0.5 * convention::field_of_view(pose.zoom)).tan() * across;
        (2.0 * half.atan()).to_degrees()
    };
    // About where things are, for who goes on by hand.
    let distance = flight.scene().space().half_size * flight.options().scale;
    let to_file = convention::supersplat;
    let place = |pose: &Pose| to_file(pose.position());
    let target = |pose: &Pose| to_file(pose.position() + pose.view() * distance);
    let rolled = |pose: &&Pose| {
        let up = up_of(to_file(pose.view()));
        up.angle_between(to_file(pose.up())) > NO_ROLL
    };
    report.count(poses.iter().filter(rolled).count(), Loss::Roll);
    let (fps, count) = (flight.fps(), poses.len());
    let first = &poses[0];
    let mut text = Vec::new();
    // Writing into a vector cannot fail.
    let _ = write!(
        text,
        "{{\n  \"version\": 2,\n  \"tonemapping\": \"none\",\n  \"highPrecisionRendering\": false,\n  \
         \"background\": {{\"color\": [0, 0, 0]}},\n  \"postEffectSettings\": {{\n    \
         \"sharpness\": {{\"enabled\": false, \"amount\": 0}},\n    \
         \"bloom\": {{\"enabled\": false, \"intensity\": 1, \"blurLevel\": 2}},\n    \
         \"grading\": {{\"enabled\": false, \"brightness\": 1, \"contrast\": 1, \"saturation\": 1, \
         \"tint\": [1, 1, 1]}},\n    \
         \"vignette\": {{\"enabled\": false, \"intensity\": 0.5, \"inner\": 0.3, \"outer\": 0.75, \
         \"curvature\": 1}},\n    \"fringing\": {{\"enabled\": false, \"intensity\": 0.5}}\n  }},\n  \
         \"startMode\": \"animTrack\",\n  \"annotations\": [],\n  \"cameras\": [{{\"initial\": \
         {{\"position\": {:?}, \"target\": {:?}, \"fov\": {:?}}}}}],\n  \"animTracks\": [{{\n    \
         \"name\": \"cameraAnim\",\n    \"duration\": {:?},\n    \"frameRate\": {fps:?},\n    \
         \"loopMode\": \"none\",\n    \"interpolation\": \"spline\",\n    \"smoothness\": 1,\n    \
         \"keyframes\": {{\n      \"times\": [",
        place(first).to_array(),
        target(first).to_array(),
        degrees(first),
        (count - 1) as f64 / fps,
    );
    rows::push(&mut text, (0..count).map(|index| index as f64), ", ");
    text.extend_from_slice(b"],\n      \"values\": {\n        \"position\": [");
    rows::push(
        &mut text,
        poses.iter().flat_map(|pose| place(pose).to_array()),
        ", ",
    );
    text.extend_from_slice(b"],\n        \"target\": [");
    rows::push(
        &mut text,
        poses.iter().flat_map(|pose| target(pose).to_array()),
        ", ",
    );
    text.extend_from_slice(b"],\n        \"fov\": [");
    rows::push(&mut text, poses.iter().map(degrees), ", ");
    text.extend_from_slice(b"]\n      }\n    }\n  }]\n}\n");
    out.write_all(&text).map_err(blocks::failed)
}
