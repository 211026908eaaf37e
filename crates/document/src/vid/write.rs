//! From a document to the text of its `.vid` file.

use std::fmt::{self, Write};
use std::path::Path;

use super::bytes::{OFF_NAME, VERSION};
use super::comments::{Comments, OURS};
use super::own::UpPaths;
use super::text::{Quoted, Text, plain};
use super::{mesh, mesh_source, own, pieces};
use crate::error::{EngineError, Result};
use crate::info::{Info, Object};
use vides_engine::property::{Kind, Value};
use vides_engine::tools::check::OFF;

use vides_engine::path::{BaseFrames, CameraPath, Orientation, Space, SupportPoint};

/// The text of a document. Points and orientations omit defaults; mesh files are named relative to
/// `folder`.
pub(crate) fn to_toml(
    path: &CameraPath,
    info: &Info,
    comments: &Comments,
    folder: Option<&Path>,
) -> Result<String> {
    let mut out = Text(String::new());
    // Only running out of memory fails here.
    document(&mut out, path, info, folder).map_err(|_| EngineError::Memory)?;
    comments.put_into(out.0, &[]).and_then(pieces::readable)
}

/// A view as in a file.
pub(crate) fn view_to_toml(view: &Orientation) -> Result<String> {
    let mut out = Text(String::new());
    let written = orientation(&mut out, "point", view, &mut UpPaths::default());
    written.map_err(|_| EngineError::Memory)?;
    Ok(out.0.trim_start().to_owned())
}

fn document(out: &mut Text, path: &CameraPath, info: &Info, folder: Option<&Path>) -> fmt::Result {
    head(out, info)?;
    shape_and_modes(out, path)?;
    writeln!(out, "\n{}\n{}\n[base_speeds]", OURS[0], OURS[1])?;
    base_speeds(out, path)?;
    writeln!(out, "\n[presets]")?;
    for (number, preset) in path.presets.iter().enumerate() {
        writeln!(out, "{number} = {}", Value::Shape(*preset))?;
    }

    space(out, path.space, info, folder)?;
    let mut up_paths = UpPaths::default();
    path.points
        .iter()
        .try_for_each(|point| self::point(out, "point", point, &mut up_paths))
}

pub(super) fn shape_and_modes(out: &mut Text, path: &CameraPath) -> fmt::Result {
    let rows = CameraPath::PROPERTIES.iter();
    let mut plain_ones = rows.filter(|row| matches!(row.kinds, [Kind::Switch | Kind::Choice(_)]));
    plain_ones.try_for_each(|row| plain(out, row, path, &CameraPath::NEW))
}

pub(super) fn base_speeds(out: &mut Text, path: &CameraPath) -> fmt::Result {
    let mut rows = BaseFrames::PROPERTIES.iter();
    rows.try_for_each(|row| plain(out, row, &path.base_frames, &BaseFrames::NEW))
}

pub(super) fn head(out: &mut Text, info: &Info) -> fmt::Result {
    writeln!(out, "version = {VERSION}")?;
    if !info.title.is_empty() {
        writeln!(out, "title = {}", Quoted(&info.title))?;
    }
    if !info.comment.is_empty() {
        writeln!(out, "comment = {}", Quoted(&info.comment))?;
    }
    writeln!(out, "fps = {:?}", info.fps)?;
    writeln!(out, "first_frame = {}", info.first_frame)?;
    Ok(())
}

/// The space, the check limits and the object.
pub(super) fn space(
    out: &mut Text,
    space: Space,
    info: &Info,
    folder: Option<&Path>,
) -> fmt::Result {
    writeln!(out, "\n{}\n[space]", OURS[2])?;
    place(out, space)?;
    writeln!(out, "unit = {}", Quoted(&info.unit))?;
    for (number, (kind, limit)) in info.limits.changed().enumerate() {
        if number == 0 {
            writeln!(out, "\n[check]")?;
        }
        match limit {
            OFF => writeln!(out, "{} = \"{OFF_NAME}\"", kind.name())?,
            _ => writeln!(out, "{} = {limit:?}", kind.name())?,
        }
    }

    object(out, &info.object, folder)
}

pub(super) fn place(out: &mut Text, space: Space) -> fmt::Result {
    writeln!(out, "centre = {:?}", space.centre.to_array())?;
    writeln!(out, "half_size = {:?}", space.half_size)?;
    writeln!(out, "up = \"{}\"", space.up.name())
}

fn object(out: &mut Text, points: &Object, folder: Option<&Path>) -> fmt::Result {
    if let Some(source) = points.source() {
        writeln!(out, "\n[object]")?;
        return mesh_source::write(out, source, folder);
    }
    if let Some(mesh) = points.mesh() {
        writeln!(out, "\n[object]")?;
        return mesh::write(out, mesh);
    }
    if points.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n[object]\npolylines = [")?;
    for (index, point) in points.iter().enumerate() {
        // The first point begins a line, whatever its flag.
        if index == 0 {
            write!(out, "  [")?;
        } else if point.draw {
            write!(out, ", ")?;
        } else {
            write!(out, "],\n  [")?;
        }
        write!(out, "{:?}", point.position.to_array())?;
    }
    writeln!(out, "],\n]")
}

/// A support point; `header` is the name of its array of tables, `up_paths` those written so far.
pub(super) fn point<'a>(
    out: &mut Text,
    header: &str,
    point: &'a SupportPoint,
    up_paths: &mut UpPaths<'a>,
) -> fmt::Result {
    writeln!(out, "\n[[{header}]]")?;
    if let Some(name) = &point.name {
        writeln!(out, "name = {}", Quoted(name))?;
    }
    let mut rows = SupportPoint::PROPERTIES.iter().skip(1);
    rows.try_for_each(|row| plain(out, row, point, &SupportPoint::NEW))?;
    point
        .orientations
        .iter()
        .try_for_each(|orientation| self::orientation(out, header, orientation, up_paths))
}

fn orientation<'a>(
    out: &mut Text,
    header: &str,
    orientation: &'a Orientation,
    up_paths: &mut UpPaths<'a>,
) -> fmt::Result {
    writeln!(out, "\n[[{header}.orientation]]")?;
    own::write(out, orientation, up_paths)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::info::Object;
    use crate::info::ObjectPoint;
    use glam::{DQuat, DVec3};
    use vides_engine::limits;
    use vides_engine::path::Tcb;
    use vides_engine::path::Up;
    use vides_engine::path::{CurveParameters, Target};
    use vides_engine::path::{
        OrientationOverrides, Overrides, Pace, PacePart, PaceSource, Tangents, TurningPart,
        UpVector, Velocities,
    };

    /// The most characters that a number takes.
    const LONGEST: f64 = -1.234_567_890_123_456_7e-300;

    fn size(path: &CameraPath, info: &Info) -> usize {
        to_toml(path, info, &Comments::default(), None)
            .unwrap()
            .len()
    }

    /// Everything that an orientation may own, each of it as long as can be.
    fn largest_own(number: f64) -> Overrides {
        let vector = DVec3::splat(number);
        let own = Overrides::default().with(|own| {
            *own = OrientationOverrides {
                pace: Pace::Part(PacePart {
                    of: PaceSource::Track(vec![[number; 3]; limits::MAX_DISTANCE_KEYS].into()),
                    from: number,
                    to: number,
                }),
                frames: u32::MAX,
                locked: true,
                curve_time: Some(number),
                ahead: Some(number),
                up: UpVector::Point(vector),
                velocities: Some(Velocities {
                    reach: vector,
                    leave: vector,
                }),
                turning: Some(TurningPart {
                    control: [DQuat::from_array([number; 4]); 4],
                    from: number,
                    to: number,
                }),
                roll_slope: Some(number),
                zoom_slope: Some(number),
            }
        });
        own.unwrap()
    }

    /// Sizes of one point, one orientation, one object point and the rest at
    /// their largest, times how many there may be.
    #[test]
    fn the_largest_document_fits_into_a_file() {
        assert_eq!(format!("{LONGEST:?}").len(), 24);
        let tcb = Tcb::new(LONGEST, LONGEST, LONGEST);
        let orientation = Orientation {
            target: Target::Absolute(DVec3::splat(LONGEST)),
            roll: LONGEST,
            zoom: 12.345_678_901_234_567,
            turning: tcb,
            speeds: [12.345_678_901_234_567; limits::SPEEDS],
            hold: limits::MAX_HOLD,
            own: largest_own(LONGEST),
        };
        let point = SupportPoint {
            position: DVec3::splat(LONGEST),
            name: Some("\"".repeat(limits::MAX_NAME_BYTES)),
            curve: CurveParameters::Own(tcb),
            tangents: Some(Tangents {
                before: DVec3::splat(LONGEST),
                after: DVec3::splat(LONGEST),
            }),
            keeps_motion: true,
            orientations: Vec::new(),
        };
        let mut path = CameraPath {
            points: vides_engine::shared_list::SharedList::new(),
            presets: [tcb; limits::PRESETS],
            space: Space {
                centre: DVec3::splat(LONGEST),
                half_size: LONGEST,
                up: Up::Z,
            },
            ..CameraPath::default()
        };
        let mut info = Info {
            title: "\"".repeat(limits::MAX_NAME_BYTES),
            comment: "\u{7f}".repeat(limits::MAX_COMMENT_BYTES),
            fps: LONGEST,
            first_frame: i32::MIN,
            unit: "\"".repeat(limits::MAX_NAME_BYTES),
            object: Object::default(),
            limits: Info::default().limits,
        };
        let rest = size(&path, &info);
        path.points.push(point);
        let point = size(&path, &info) - rest;
        path.points[0].orientations.push(orientation);
        let orientation = size(&path, &info) - rest - point;
        path.points.clear();
        let draw = ObjectPoint {
            position: DVec3::splat(LONGEST),
            draw: false,
        };
        info.object = vec![draw].into();
        let one = size(&path, &info);
        info.object = vec![draw; 2].into();
        let object = size(&path, &info) - one;

        let all = one
            + limits::MAX_POINTS * point
            + limits::MAX_ALL_ORIENTATIONS * orientation
            + limits::MAX_OBJECT_POINTS * object
            + limits::MAX_UP_PATHS * limits::MAX_UP_PATH_POINTS * 9 * (24 + ", ".len());
        assert!(
            all as u64 <= limits::MAX_FILE_BYTES,
            "{all} bytes: {point} a point, {orientation} an orientation, {object} an object point"
        );
    }
}
