//! A script for ParaView, which is read again by its data.

use std::io::Write;

use glam::DVec3;
use vides_document::error::vec_with_room;
use vides_engine::path::Pose;
use vides_engine::path::camera_path::Target;

use super::data;
use crate::content::{Content, Recording};
use crate::error::{Error, Result};
use crate::flight::Flight;
use crate::format::{Format, Holds};
use crate::json::text;
use crate::loss::{Loss, Report};
use crate::options::Options;
use crate::source::Source;
use crate::tree::{self, At};

const SCRIPT: &str = include_str!("for_paraview.py");

/// How the file begins.
const TITLE: &str = "\"\"\"A camera flight for ParaView";

/// How the scripts for others begin, which have less in their data.
const OTHERS: [(&str, &str); 2] = [
    ("blender", "\"\"\"A camera flight for Blender"),
    ("vtk", "\"\"\"A camera flight for VTK"),
];

/// Shares of the space's `half_size` nearer than which nothing is focused.
const NEAREST: f64 = 1e-6;

pub(crate) static PARAVIEW: Format = Format {
    name: "paraview",
    title: "ParaView script",
    endings: &["py"],
    holds: Holds::Motion,
    recognises: |source| source.beginning().starts_with(TITLE),
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    for (name, title) in OTHERS {
        if source.beginning().starts_with(title) {
            return Err(Error::NotRead(name));
        }
    }
    let (json, lines) = data::data(source.text()?)?;
    let parsed = tree::parse(json.as_bytes()).map_err(|error| data::in_file(error, lines))?;
    let root = At::root(&parsed);
    let mut recording = Recording {
        title: text(root.get("title"))?,
        unit: text(root.get("unit"))?,
        fps: root.get("fps").map(At::positive).transpose()?,
        first_frame: root.get("first_frame").map(At::number).transpose()?,
        up: root.get("up").map(At::up).transpose()?,
        ..Recording::default()
    };
    for frame in root.need("frames")?.list()? {
        let row = frame.numbers::<11>()?;
        let vector = |at: usize| [row[at], row[at + 1], row[at + 2]];
        recording.push(Pose {
            vrp: vector(0),
            vpn: vector(3),
            vup: vector(6),
            zoom: row[9],
        })?;
    }
    if root.get("object").is_some() {
        report.add(Loss::Object);
    }
    Ok(Content::Poses(recording))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    let first = flight.number(0).round() as i64;
    let mut head = data::head(flight, SCRIPT, first, report)?;
    data::begin_frames(&mut head);
    let focus = Focus::new(flight)?;
    let sample =
        |flight: &Flight<'_>, from, framed: &mut [Framed]| focus.sample(flight, from, framed);
    flight.write_blocks(head, out, sample, |_, text, index, framed| {
        let Framed { pose, distance } = framed;
        let mut row = [pose.zoom; 11];
        row[..9].copy_from_slice([pose.vrp, pose.vpn, pose.vup].as_flattened());
        row[10] = *distance;
        data::push_frame(text, index, &row);
    })?;
    data::finish(SCRIPT, out)
}

/// A pose, and how far away the point lies about which the user turns the view.
#[derive(Clone, Copy, Default)]
struct Framed {
    pose: Pose,
    distance: f64,
}

/// What the camera looks at.
struct Focus {
    /// Frames of the keys of a path and what they look at; a relative target does not count.
    targets: Vec<(f64, Option<DVec3>)>,
    /// The node that the camera aims at.
    aim: Option<usize>,
    /// The middle of the object's points.
    object: Option<DVec3>,
    half_size: f64,
}

impl Focus {
    fn new(flight: &Flight<'_>) -> Result<Self> {
        let object = &flight.info().object;
        let sum: DVec3 = object.iter().map(|point| point.position).sum();
        let mut targets = Vec::new();
        if let Some(follow) = flight.path_alone() {
            let sampler = follow.sampler()?;
            let points = follow.path().points.iter();
            let views: Vec<_> = points.flat_map(|point| &point.orientations).collect();
            let sections = views.len() - usize::from(!follow.path().closed);
            targets = vec_with_room(sections + 1)?;
            for key in 0..=sections {
                let frame = match key < sections {
                    true => sampler.first_frame(key) - 1,
                    false => sampler.frame_count(),
                };
                let target = match views[key % views.len()].target {
                    Target::Absolute(target) => Some(target),
                    Target::Relative(_) => None,
                };
                targets.push((frame as f64, target));
            }
        }
        Ok(Self {
            targets,
            aim: flight.scene().nodes()[flight.node()].aim,
            object: (!object.is_empty()).then(|| sum / object.len() as f64),
            half_size: flight.scene().space().half_size,
        })
    }

    fn sample(&self, flight: &Flight<'_>, from: usize, framed: &mut [Framed]) -> Result<()> {
        let mut poses = vec_with_room(framed.len())?;
        poses.resize(framed.len(), Pose::default());
        flight.poses(from, &mut poses)?;
        let aims = match self.aim {
            Some(aim) => flight.states(aim, from, framed.len())?,
            None => Vec::new(),
        };
        let scale = flight.options().scale;
        for (at, (framed, pose)) in framed.iter_mut().zip(poses).enumerate() {
            let aimed = aims.get(at).map(|state| state.world().translation);
            let target = aimed.or_else(|| self.target(flight.frame(from + at)));
            let along = |place: DVec3| (flight.place(place) - pose.position()).dot(pose.view());
            let away = |place: DVec3| flight.place(place).distance(pose.position());
            let nearest = NEAREST * self.half_size * scale;
            let enough = |distance: &f64| *distance > nearest && distance.is_finite();
            let distance = target.map(along).filter(enough);
            let distance = distance.or_else(|| self.object.map(away).filter(enough));
            let distance = distance.unwrap_or(self.half_size * scale);
            *framed = Framed { pose, distance };
        }
        Ok(())
    }

    /// Of two keys with targets what lies between them.
    fn target(&self, frame: f64) -> Option<DVec3> {
        let next = self.targets.partition_point(|(at, _)| *at <= frame);
        let (start, from) = *self.targets.get(next.checked_sub(1)?)?;
        match self.targets.get(next) {
            Some((end, Some(to))) => Some(from?.lerp(*to, (frame - start) / (end - start))),
            Some((_, None)) => None,
            None => from,
        }
    }
}
