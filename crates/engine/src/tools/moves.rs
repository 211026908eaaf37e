//! Ready-made moves: support points with targets in the middle of the view (thesis chapter 8).
//!
//! Circles are cubics of at most 30° with tangents 4·tan(θ/4)·r (Goldapp 1991): their radius errs
//! by 3.7e-7 of itself. Points are placed where whole frames of an even pace fall, so that all
//! sections have one speed; their angles differ by what a frame makes. A dolly zoom keeps zoom/distance exactly: both are linear in the share of
//! the way. Headings are as in `docs/reference/tools.md`.

mod parameters;

use std::f64::consts::TAU;

use glam::DVec3;

use self::parameters::{
    AROUND, FROM, HEIGHT, RADIUS, RISE, SECONDS, TURNS, ZOOM, degrees, distance, length,
};
use super::parameter::{Parameter, Unit};
use crate::deform::Bounds;
use crate::error::{Invalid, OutOfRange, Result, vec_with_room};
use crate::limits::{MAX_FRAMES, MAX_ZOOM, MIN_ZOOM};
use crate::path::fit_frames::fit_frames;
use crate::path::{
    BaseFrames, CameraPath, CurveParameters, Orientation, Space, SupportPoint, Tangents, Target,
    Timeline,
};

/// The largest angle of one circular segment.
const ARC: f64 = TAU / 12.0;

/// A shorter way, in units of `half_size`, counts as none (docs/theory/path.md, sections).
const NO_WAY: f64 = 1e-9;

/// The largest angle between two views of a tilted pan, which would cut its way short.
const PAN: f64 = TAU / 8.0;

/// Of a level one, which turns about one axis: short of the half turn that goes either way.
const LEVEL_PAN: f64 = TAU * (179.0 / 360.0);

/// No circular segment has more, however few the frames are.
const WIDEST: f64 = TAU / 4.0;

/// Parts of a section in which its speed counts as changing evenly.
const CELLS: usize = 32;

/// Segments of a figure of eight.
const EIGHT: usize = 24;

/// A ready-made move.
#[derive(Debug)]
pub struct Move {
    /// Its name.
    pub name: &'static str,
    /// What the camera does.
    pub does: &'static str,
    /// What it asks for.
    pub parameters: &'static [Parameter],
    make: fn(&MoveArguments<'_>) -> Result<Vec<SupportPoint>>,
}

/// The names of all moves, for a sentence.
const KNOWN: &str = "orbit, spiral, arc, flyby, approach, dolly-zoom, crane, pan, figure-eight";

/// All moves.
pub const MOVES: &[Move] = &[
    Move {
        name: "orbit",
        does: "on a circle round a target",
        parameters: &[AROUND, RADIUS, HEIGHT, FROM, TURNS, ZOOM, SECONDS],
        make: |given| {
            let [radius, height] = given.numbers(["radius", "height"]);
            around(given, [radius; 2], [height; 2], given.turn())
        },
    },
    Move {
        name: "spiral",
        does: "round a target with another radius and height at the end",
        parameters: &[
            AROUND,
            RADIUS,
            HEIGHT,
            FROM,
            TURNS,
            ZOOM,
            SECONDS,
            distance("end-radius", "the radius at the end", 0.5),
            length("end-height", "the height at the end", 1.0),
        ],
        make: |given| {
            let [r0, r1, h0, h1] = given.numbers(["radius", "end-radius", "height", "end-height"]);
            around(given, [r0, r1], [h0, h1], given.turn())
        },
    },
    Move {
        name: "arc",
        does: "on a part of a circle, from one heading to another",
        parameters: &[
            AROUND,
            RADIUS,
            HEIGHT,
            degrees("from", "heading at which the camera begins", -45.0),
            degrees("to", "heading at which it ends", 45.0),
            ZOOM,
            SECONDS,
        ],
        make: |given| {
            let [radius, height, from, to] = given.numbers(["radius", "height", "from", "to"]);
            around(given, [radius; 2], [height; 2], (to - from).to_radians())
        },
    },
    Move {
        name: "flyby",
        does: "straight past a target that stays in view",
        parameters: &[
            AROUND,
            distance("distance", "least distance, seen from above", 1.0),
            HEIGHT,
            degrees("from", "heading of the camera when it is nearest", 0.0),
            distance("length", "length of the path", 2.0),
            ZOOM,
            SECONDS,
        ],
        make: |given| {
            let [distance, height, from, length] =
                given.numbers(["distance", "height", "from", "length"]);
            let (side, along) = (
                heading(from.to_radians()),
                heading(from.to_radians() + TAU / 4.0),
            );
            let middle = distance * side + height * DVec3::Y;
            straight(given, [-0.5, 0.5].map(|k| middle + k * length * along))
        },
    },
    Move {
        name: "approach",
        does: "straight towards a target",
        parameters: &[
            AROUND,
            distance("distance", "how far from the target it begins", 1.0),
            distance("end-distance", "how far from the target it ends", 0.4),
            FROM,
            RISE,
            ZOOM,
            SECONDS,
        ],
        make: towards,
    },
    Move {
        name: "dolly-zoom",
        does: "towards a target that keeps its size in the picture",
        parameters: &[
            AROUND,
            distance("distance", "how far from the target it begins", 1.0),
            distance("end-distance", "how far from the target it ends", 0.4),
            FROM,
            RISE,
            Parameter {
                does: "focal length at the beginning",
                default: 60.0,
                ..ZOOM
            },
            SECONDS,
        ],
        make: |given| {
            let [zoom, from, to] = given.numbers(["zoom", "distance", "end-distance"]);
            let end = zoom * to / from;
            if !(MIN_ZOOM..=MAX_ZOOM).contains(&end) {
                return Err(OutOfRange::ZoomAtEnd(end).into());
            }
            let mut points = towards(given)?;
            points[1].orientations[0].zoom = end;
            Ok(points)
        },
    },
    Move {
        name: "crane",
        does: "straight up or down beside a target that stays in view",
        parameters: &[
            AROUND,
            RADIUS,
            length("height", "how far above the target it begins", -0.2),
            length("end-height", "how far above the target it ends", 1.0),
            FROM,
            ZOOM,
            SECONDS,
        ],
        make: |given| {
            let [radius, low, high, from] =
                given.numbers(["radius", "height", "end-height", "from"]);
            let foot = radius * heading(from.to_radians());
            straight(given, [low, high].map(|height| foot + height * DVec3::Y))
        },
    },
    Move {
        name: "pan",
        does: "turns on the spot",
        parameters: &[
            Parameter {
                width: 3,
                ..length("at", "where the camera stands", 0.0)
            },
            degrees("from", "heading of the first view", -45.0),
            degrees("to", "heading of the last view", 45.0),
            Parameter {
                least: -89.0,
                most: 89.0,
                ..degrees("tilt", "how far it looks up", 0.0)
            },
            ZOOM,
            SECONDS,
        ],
        make: pan,
    },
    Move {
        name: "figure-eight",
        does: "on an eight that lies before the target",
        parameters: &[
            AROUND,
            distance("radius", "how far from the axis it crosses itself", 0.7),
            HEIGHT,
            distance("width", "how wide it is, twice as wide as deep", 1.2),
            FROM,
            ZOOM,
            SECONDS,
        ],
        make: eight,
    },
];

struct MoveArguments<'a> {
    parameters: &'static [Parameter],
    numbers: &'a [f64],
    space: Space,
    /// From the first pose to the last, once they are known.
    frames: Option<usize>,
}

impl MoveArguments<'_> {
    fn number(&self, name: &str) -> f64 {
        Parameter::find(self.parameters, name).map_or(0.0, |(at, _)| self.numbers[at])
    }

    fn numbers<const N: usize>(&self, names: [&str; N]) -> [f64; N] {
        names.map(|name| self.number(name))
    }

    fn place(&self, name: &str) -> DVec3 {
        Parameter::find(self.parameters, name).map_or(DVec3::ZERO, |(at, _)| {
            DVec3::from_slice(&self.numbers[at..])
        })
    }

    fn turn(&self) -> f64 {
        TAU * self.number("turns")
    }

    /// Shares of the way at which the points of `sections` sections are: even ones, moved to where
    /// the nearest whole frame of an even pace falls; fewer if there are fewer frames, but no fewer
    /// than `least` sections. `speed` is that of the camera over its share.
    #[allow(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss
    )]
    fn shares(
        &self,
        sections: usize,
        least: usize,
        speed: &dyn Fn(f64) -> f64,
    ) -> Result<Vec<f64>> {
        let mut shares = vec_with_room(sections + 1)?;
        let Some(frames) = self.frames else {
            shares.extend((0..=sections).map(|k| k as f64 / sections as f64));
            return Ok(shares);
        };
        let cells = CELLS * sections;
        let step = 1.0 / cells as f64;
        let mut ways: Vec<f64> = vec_with_room(cells + 1)?;
        let mut way = 0.0;
        ways.push(way);
        for cell in 0..cells {
            // Simpson's rule.
            let at = |part: f64| speed((cell as f64 + part) * step);
            way += (at(0.0) + 4.0 * at(0.5) + at(1.0)) * (step / 6.0);
            ways.push(way);
        }
        if frames < least {
            let (frames, least) = (frames + 1, least + 1);
            return Err(OutOfRange::TooFewFrames { frames, least }.into());
        }
        let frames = frames as f64;
        let mut last = -1.0;
        for k in 0..=sections {
            let frame = (ways[CELLS * k] / way * frames).round();
            if frame > last {
                let target = frame / frames * way;
                let after = ways.partition_point(|way| *way < target).clamp(1, cells);
                let [before, behind] = [ways[after - 1], ways[after]];
                let part = (target - before) / (behind - before);
                shares.push((((after - 1) as f64 + part) * step).clamp(0.0, 1.0));
                last = frame;
            }
        }
        if let Some(end) = shares.last_mut() {
            *end = 1.0;
        }
        Ok(shares)
    }
}

/// Unit vector of a heading.
fn heading(angle: f64) -> DVec3 {
    DVec3::new(angle.sin(), 0.0, angle.cos())
}

impl Move {
    /// The move of this name.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] if it does not exist.
    pub fn named(name: &str) -> Result<&'static Self> {
        MOVES
            .iter()
            .find(|known| known.name == name)
            .ok_or_else(|| {
                Invalid::NoMove {
                    name: name.into(),
                    known: KNOWN,
                }
                .into()
            })
    }

    /// Its defaults for an object (the middle of its bounds, lengths in their diagonal) or a space.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn defaults(&self, object: Option<&Bounds>, space: Space) -> Result<Vec<f64>> {
        let mut numbers = Parameter::numbers(self.parameters, &[], space.half_size)?;
        let (mut middle, mut size) = (space.centre, space.half_size);
        if let Some(bounds) = object {
            middle = 0.5 * (bounds.min() + bounds.max());
            let diagonal = (bounds.max() - bounds.min()).length();
            if diagonal > 1e-6 * size {
                size = diagonal;
            }
        }
        let mut start = 0;
        for parameter in self.parameters {
            if parameter.width == 3 {
                numbers[start..start + 3].copy_from_slice(&middle.to_array());
            } else if parameter.unit == Unit::Length {
                let [least, most] = [parameter.least, parameter.most].map(|k| k * space.half_size);
                numbers[start] = (parameter.default * size).clamp(least, most);
            }
            start += parameter.width;
        }
        Ok(numbers)
    }

    /// The path of this move. What is not given has its default; `fps` makes frames of its seconds.
    ///
    /// # Errors
    /// What is wrong with the numbers; [`crate::Error::Limit`], [`crate::Error::Memory`].
    pub fn path(&self, given: &[f64], space: Space, fps: f64) -> Result<CameraPath> {
        self.path_with_base_frames(given, space, fps, BaseFrames::default())
    }

    /// The same with base speeds, which count where `seconds` is 0: as long as its way.
    ///
    /// # Errors
    /// As [`Move::path`].
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub fn path_with_base_frames(
        &self,
        given: &[f64],
        space: Space,
        fps: f64,
        speeds: BaseFrames,
    ) -> Result<CameraPath> {
        let numbers = Parameter::numbers(self.parameters, given, space.half_size)?;
        let mut given = MoveArguments {
            parameters: self.parameters,
            numbers: &numbers,
            space,
            frames: None,
        };
        let mut path = CameraPath::try_new()?;
        path.points = (self.make)(&given)?.into();
        path.space = space;
        path.base_frames = speeds;
        path.check()?;
        let seconds = given.number("seconds");
        let frames = if seconds > 0.0 {
            (seconds * fps).round() as usize
        } else {
            let timeline = Timeline::new(&path)?;
            let each = timeline.moving();
            let all: f64 = each.map(|k| timeline.unrounded_frames(&path, k)).sum();
            all.round() as usize + 1
        };
        if path.points.len() > 2 {
            given.frames = Some(frames.clamp(1, MAX_FRAMES) - 1);
            path.points = (self.make)(&given)?.into();
            path.check()?;
        }
        if seconds > 0.0 {
            let timeline = Timeline::new(&path)?;
            let amount = |k: usize| timeline.section(k).amount;
            let all: f64 = timeline.moving().map(amount).sum();
            let last = path.points.len() - 1;
            let fixed = fit_frames(&path, &timeline, 0, last, frames)?;
            for (mut fixed, k) in fixed.into_iter().zip(timeline.moving()) {
                // Whole, but for rounding, by the choice of the points.
                fixed.frames = (amount(k) / all * (frames - 1) as f64).round() as u32;
                fixed.apply(&mut path)?;
            }
        }
        if self.name == "dolly-zoom" {
            keep_zoom_linear(&mut path)?;
        }
        Ok(path)
    }
}

/// Lets both keys own the slope between them, so that the size stays also within a longer path.
fn keep_zoom_linear(path: &mut CameraPath) -> Result<()> {
    let duration = Timeline::new(path)?.section(0).duration();
    let rise = path.points[1].orientations[0].zoom - path.points[0].orientations[0].zoom;
    for point in &mut path.points {
        let orientation = &mut point.orientations[0];
        orientation.own = orientation
            .own
            .with(|own| own.zoom_slope = Some(rise / duration))?;
    }
    Ok(())
}

/// A point with the tangents before and after it.
fn point(given: &MoveArguments<'_>, offset: DVec3, tangents: [DVec3; 2]) -> Result<SupportPoint> {
    let around = given.place("around");
    let mut point = SupportPoint::try_new(around + given.space.up.world(offset))?;
    point.curve = CurveParameters::Preset(0);
    let [before, after] = tangents.map(|tangent| given.space.up.world(tangent));
    point.tangents = Some(Tangents { before, after });
    point.orientations[0] = Orientation {
        target: Target::Absolute(around),
        zoom: given.number("zoom"),
        ..Orientation::default()
    };
    Ok(point)
}

fn straight(given: &MoveArguments<'_>, [from, to]: [DVec3; 2]) -> Result<Vec<SupportPoint>> {
    if (to - from).length() <= NO_WAY * given.space.half_size {
        return Err(OutOfRange::NoWay.into());
    }
    let mut points = vec_with_room(2)?;
    for place in [from, to] {
        points.push(point(given, place, [to - from; 2])?);
    }
    Ok(points)
}

/// Points along a curve: the place at each share, and the tangent there for a step of the share.
fn along(
    given: &MoveArguments<'_>,
    shares: &[f64],
    at: &dyn Fn(f64) -> DVec3,
    tangent: &dyn Fn(f64, f64) -> DVec3,
) -> Result<Vec<SupportPoint>> {
    let mut points = vec_with_room(shares.len())?;
    for (k, &share) in shares.iter().enumerate() {
        let before = k.checked_sub(1).map(|k| share - shares[k]);
        let after = shares.get(k + 1).map(|next| next - share);
        let steps = [before.or(after), after.or(before)];
        let tangents = steps.map(|step| tangent(share, step.unwrap_or(1.0)));
        points.push(point(given, at(share), tangents)?);
    }
    Ok(points)
}

fn towards(given: &MoveArguments<'_>) -> Result<Vec<SupportPoint>> {
    let [from, to, angle, rise] = given.numbers(["distance", "end-distance", "from", "rise"]);
    let (sin, cos) = rise.to_radians().sin_cos();
    let direction = cos * heading(angle.to_radians()) + sin * DVec3::Y;
    straight(given, [from * direction, to * direction])
}

/// Round the target by an angle, radius and height linear in it.
#[allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss
)]
fn around(
    given: &MoveArguments<'_>,
    [r0, r1]: [f64; 2],
    [h0, h1]: [f64; 2],
    angle: f64,
) -> Result<Vec<SupportPoint>> {
    if angle == 0.0 {
        return Err(OutOfRange::NoTurn.into());
    }
    let from = given.number("from").to_radians();
    // A whole number of arcs may be rounded up by a hair.
    let sections = |widest: f64| (angle.abs() / widest - 1e-9).ceil().max(1.0) as usize;
    let radius = |share: f64| r0 + (r1 - r0) * share;
    let out = |share: f64| heading(from + angle * share);
    let rise = h1 - h0;
    let speed = |share: f64| (angle * radius(share)).hypot(r1 - r0).hypot(rise);
    let shares = given.shares(sections(ARC), sections(WIDEST), &speed)?;
    let place = |share: f64| radius(share) * out(share) + (h0 + rise * share) * DVec3::Y;
    let tangent = |share: f64, step: f64| {
        let out = out(share);
        let across = DVec3::new(out.z, 0.0, -out.x);
        let round = 4.0 * (angle * step / 4.0).tan();
        round * radius(share) * across + step * ((r1 - r0) * out + rise * DVec3::Y)
    };
    along(given, &shares, &place, &tangent)
}

#[allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss
)]
fn pan(given: &MoveArguments<'_>) -> Result<Vec<SupportPoint>> {
    let [from, to, tilt] = given.numbers(["from", "to", "tilt"]).map(f64::to_radians);
    if from == to {
        return Err(OutOfRange::NoTurn.into());
    }
    let sections = |widest: f64| ((to - from).abs() / widest - 1e-9).ceil().max(1.0) as usize;
    let mut shares = given.shares(sections(PAN), sections(WIDEST), &|_| 1.0)?;
    if tilt == 0.0 {
        // Where it could turn on to the next one all the same, a view says nothing.
        let most = LEVEL_PAN / (to - from).abs();
        for k in (1..shares.len() - 1).rev() {
            if shares[k + 1] - shares[k - 1] <= most {
                shares.remove(k);
            }
        }
    }
    let mut points = vec_with_room(shares.len())?;
    for share in shares {
        let angle = from + (to - from) * share;
        let mut point = SupportPoint::try_new(given.place("at"))?;
        let view = tilt.cos() * heading(angle) + tilt.sin() * DVec3::Y;
        point.orientations[0].target = Target::Relative(given.space.offset(view));
        point.orientations[0].zoom = given.number("zoom");
        points.push(point);
    }
    Ok(points)
}

/// Gerono's lemniscate (r·sin t, w·sin 2t), from its middle back to it.
fn eight(given: &MoveArguments<'_>) -> Result<Vec<SupportPoint>> {
    let [radius, width, height, from] = given.numbers(["radius", "width", "height", "from"]);
    let (away, across) = (
        heading(from.to_radians()),
        heading(from.to_radians() + TAU / 4.0),
    );
    let place = |share: f64| {
        let t = TAU * share;
        let place =
            0.5 * width * t.sin() * across + (radius + 0.25 * width * (2.0 * t).sin()) * away;
        place + height * DVec3::Y
    };
    let tangent = |share: f64, step: f64| {
        let t = TAU * share;
        TAU * step * 0.5 * width * (t.cos() * across + (2.0 * t).cos() * away)
    };
    let speed = |share: f64| tangent(share, 1.0).length();
    let shares = given.shares(EIGHT, EIGHT, &speed)?;
    along(given, &shares, &place, &tangent)
}

#[cfg(test)]
#[path = "moves_tests.rs"]
mod tests;
