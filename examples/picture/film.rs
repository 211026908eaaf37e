//! The film as a table: what follows what, from which frame to which, and how
//! fast the camera moves and turns meanwhile.

use glam::DVec3;
use vides::document::Document;
use vides::path::{Change, Pose, Timeline};

use crate::Problem;

/// A piece of the film: a section or a rest.
pub(crate) struct Piece {
    /// The section's number; none for a rest.
    pub(crate) number: Option<usize>,
    /// What happens.
    pub(crate) what: String,
    /// Whether the camera moves on here; else it stands and turns, rolls or zooms.
    pub(crate) moves: bool,
    /// Its first frame, counted from 1.
    pub(crate) first: usize,
    /// Its frames, at least one.
    pub(crate) frames: usize,
}

/// All pieces in their order. The first pose of all belongs to none.
pub(crate) fn pieces(document: &Document) -> Result<Vec<Piece>, Problem> {
    let path = document.path();
    let mut pieces = Vec::new();
    let mut next = 2;
    let mut add = |number, what, moves, frames: usize| {
        if frames > 0 {
            pieces.push(Piece {
                number,
                what,
                moves,
                first: next,
                frames,
            });
            next += frames;
        }
    };
    let name = |point: usize| match &path.points[point].name {
        Some(name) => name.clone(),
        None => format!("point {}", point + 1),
    };
    let rest = |point: usize| format!("rest at {}", name(point));
    let sections = document.timeline(|timeline| {
        (0..timeline.section_count())
            .map(|section| timeline.section(section))
            .collect::<Vec<_>>()
    })?;
    for (index, section) in sections.iter().enumerate() {
        let point = section.point;
        if section.change != Change::Nothing {
            let hold = path.points[point].orientations[section.orientation].hold;
            add(None, rest(point), false, hold as usize);
        }
        let what = match section.change {
            Change::Position => {
                format!(
                    "{} → {}",
                    name(point),
                    name((point + 1) % path.points.len())
                )
            }
            Change::View => format!("pan by {:.0}°", 180.0 * section.amount),
            Change::Roll => format!("roll by {:.0}°", 90.0 * section.amount),
            Change::Zoom => format!("zoom by {:.0} mm", 99.0 * section.amount),
            Change::Nothing => continue,
        };
        let moves = section.change == Change::Position;
        add(Some(index + 1), what, moves, section.frames);
    }
    let last = path.points.len() - 1;
    if let (false, Some(orientation)) = (path.closed, path.points[last].orientations.last()) {
        add(None, rest(last), false, orientation.hold as usize);
    }
    Ok(pieces)
}

/// How fast the camera is between two frames.
pub(crate) struct Pace {
    /// Half-way between the two frames.
    pub(crate) frame: f64,
    /// Way per second.
    pub(crate) speed: f64,
    /// Degrees from one frame to the next, of the view and the roll together.
    pub(crate) turning: f64,
}

/// Paces that are looked at: more than the picture has columns.
const PACES: usize = 2000;

/// The pace all through the film.
pub(crate) fn paces(document: &Document) -> Result<Vec<Pace>, Problem> {
    let sampler = document.sampler()?;
    let gaps = sampler.frame_count() - 1;
    let count = gaps.min(PACES);
    let mut paces = Vec::with_capacity(count);
    for index in 0..count {
        let frame = 1 + if count > 1 {
            (gaps - 1) * index / (count - 1)
        } else {
            0
        };
        let mut two = [Pose::default(); 2];
        sampler.sample(frame, &mut two)?;
        let [a, b] = two;
        let way = DVec3::from_array(a.vrp).distance(DVec3::from_array(b.vrp));
        paces.push(Pace {
            frame: frame as f64 + 0.5,
            speed: way * document.info().fps,
            turning: rotation(&a, &b).to_degrees(),
        });
    }
    Ok(paces)
}

/// Angle of the rotation that leads from one pose's axes to the other's: the
/// three axes' ways squared are together 8 sin² of half of it.
fn rotation(a: &Pose, b: &Pose) -> f64 {
    let axes = |pose: &Pose| {
        let (ahead, up) = (DVec3::from_array(pose.vpn), DVec3::from_array(pose.vup));
        [ahead, up, ahead.cross(up)]
    };
    let squares = axes(a)
        .into_iter()
        .zip(axes(b))
        .map(|(from, to)| from.distance_squared(to));
    let half: f64 = (squares.sum::<f64>() / 8.0).sqrt();
    2.0 * half.min(1.0).asin()
}

/// One line about the whole.
pub(crate) fn summary(document: &Document) -> Result<String, Problem> {
    let frames = document.sampler()?.frame_count();
    let fps = document.info().fps;
    let length = document.timeline(Timeline::length)?;
    Ok(format!(
        "{} points, length {length:.2}, {frames} frames, {:.1} seconds at {fps} frames per second",
        document.path().points.len(),
        frames as f64 / fps,
    ))
}
