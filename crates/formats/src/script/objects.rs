//! The objects of a scene in a script: meshes as at the first frame, and where they are.

use std::io::Write;

use glam::{DAffine3, DVec3};
use vides_document::error::vec_with_room;
use vides_engine::scene::{Kind, Mesh, Node, NodeState, Warnings};

use super::data::{MOST_PIECES, push_frame, push_rows, push_text};
use crate::blocks::BLOCK;
use crate::convention::{self, Continued};
use crate::error::Result;
use crate::flight::{Flight, succeeded};
use crate::loss::{Loss, Report};

/// Position, rotation (w, x, y, z), scale, and 1 if it is hidden.
type Row = [f64; 11];

/// Appends the objects, as far as points, lines, triangles and places of all together are few, and
/// reports what of the scene is not there.
pub(super) fn push(text: &mut Vec<u8>, flight: &Flight<'_>, report: &mut Report) -> Result<()> {
    let own = flight.info().object.pieces();
    // The document's own was left out if it is larger.
    let mut room = MOST_PIECES - if own > MOST_PIECES { 0 } else { own };
    let [
        mut others,
        mut cameras,
        mut sheared,
        mut deformed,
        mut count,
    ] = [0; 5];
    let mut coloured = false;
    for (at, node) in flight.scene().nodes().iter().enumerate() {
        let object = match &node.kind {
            Kind::Object(object) => object,
            Kind::Group => continue,
            Kind::Camera(_) => {
                cameras += usize::from(at != flight.node());
                continue;
            }
            Kind::Light(_) => {
                others += 1;
                continue;
            }
        };
        let mesh = object.mesh();
        if mesh.points.is_empty() {
            continue;
        }
        let pieces = mesh.points.len() + mesh.lines.len() + mesh.triangles.len();
        let rest = room.checked_sub(pieces);
        let rows = rest.map(|rest| rows(flight, at, rest, &mut sheared));
        let Some(rows) = rows.transpose()?.flatten() else {
            others += 1;
            continue;
        };
        room -= pieces + rows.len();
        text.extend_from_slice(if count == 0 {
            b"\"objects\": ["
        } else {
            b",\n"
        });
        count += 1;
        push_one(text, flight, (at, node), mesh, &rows)?;
        deformed += usize::from(!object.deformations().is_empty() || !object.shapes().is_empty());
        coloured |= !mesh.colours.is_empty();
    }
    if count > 0 {
        text.extend_from_slice(b"],\n");
    }
    report.count(others, Loss::OtherNodes);
    report.count(cameras, Loss::OtherCameras);
    report.count(sheared, Loss::Sheared);
    report.count(deformed, Loss::Deformations);
    if coloured {
        report.add(Loss::PointColours);
    }
    Ok(())
}

/// One object: its mesh in its own coordinates, and a place, or one a frame if it moves.
fn push_one(
    text: &mut Vec<u8>,
    flight: &Flight<'_>,
    (at, node): (usize, &Node),
    mesh: &Mesh,
    rows: &[Row],
) -> Result<()> {
    let mut points: Vec<DVec3> = vec_with_room(mesh.points.len())?;
    points.resize(mesh.points.len(), DVec3::ZERO);
    let mut warnings = Warnings::default();
    let scene = flight.scene();
    scene.vertices(at, flight.frame(0), &mut points, &mut warnings)?;
    succeeded(warnings, node)?;
    text.extend_from_slice(b"{\n\"name\": ");
    push_text(text, &node.name);
    text.extend_from_slice(b",\n\"points\": [");
    push_rows(text, points.iter().map(|point| point.to_array()));
    text.extend_from_slice(b"],\n\"lines\": [");
    push_rows(text, &mesh.lines);
    text.extend_from_slice(b"],\n\"triangles\": [");
    push_rows(text, &mesh.triangles);
    text.extend_from_slice(b"],\n\"places\": [");
    for (index, row) in rows.iter().enumerate() {
        push_frame(text, index, row);
    }
    // Writing into a vector cannot fail.
    let _ = write!(text, "]\n}}");
    Ok(())
}

/// Where a node is in the file's world, frame by frame, or once if it stays; none if these are more
/// than `most`.
fn rows(
    flight: &Flight<'_>,
    at: usize,
    most: usize,
    sheared: &mut usize,
) -> Result<Option<Vec<Row>>> {
    let count = flight.count();
    let mut rows: Vec<Row> = Vec::new();
    let (mut first, mut same) = (None, 0);
    let mut continued = Continued::default();
    let mut is_sheared = false;
    for from in (0..count).step_by(BLOCK) {
        for state in flight.states(at, from, BLOCK.min(count - from))? {
            let row = row(flight, &state, &mut continued, &mut is_sheared);
            let first = *first.get_or_insert(row);
            if rows.is_empty() && row == first {
                // So far it stays.
                same += 1;
                continue;
            }
            if count > most {
                return Ok(None);
            }
            rows.try_reserve(count)?;
            rows.resize(rows.len().max(same), first);
            rows.push(row);
        }
    }
    if rows.is_empty() {
        rows.extend(first);
    }
    *sheared += usize::from(is_sheared);
    Ok((rows.len() <= most).then_some(rows))
}

fn row(
    flight: &Flight<'_>,
    state: &NodeState,
    continued: &mut Continued,
    is_sheared: &mut bool,
) -> Row {
    let world: DAffine3 = flight.to_file() * state.world();
    let parts = convention::parts(world);
    *is_sheared |= parts.sheared;
    let [x, y, z] = parts.position.to_array();
    let turn = continued.next(parts.rotation);
    let [a, b, c] = parts.scale.to_array();
    let hidden = f64::from(state.visible == 0);
    [x, y, z, turn.w, turn.x, turn.y, turn.z, a, b, c, hidden]
}
