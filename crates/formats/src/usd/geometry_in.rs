//! Meshes, curves and points of a file.

use glam::DVec3;
use vides_document::ObjectPoint;
use vides_document::error::{EngineError, vec_with_room};
use vides_engine::scene::Mesh;
use vides_mesh::srgb;

use super::curve::Curve;
use super::lexer::Lexer;
use super::stage::{Prim, Stage};
use crate::error::{Cause, Result, Wanted};

/// What a prim of geometry holds.
pub(super) struct Geometry {
    /// What was there, and that of the prim.
    pub(super) mesh: Mesh,
    /// Of the whole.
    pub(super) colour: Option<Curve>,
    /// What is not taken.
    pub(super) told: Vec<&'static str>,
}

fn points(stage: &Stage<'_>, prim: &Prim<'_>) -> Result<Vec<DVec3>> {
    let Some((place, numbers)) = stage.list(prim, "points")? else {
        return Ok(Vec::new());
    };
    let (points, []) = numbers.as_chunks::<3>() else {
        return Err(place.expected(Wanted::Numbers(3)));
    };
    let mut out = vec_with_room(points.len())?;
    out.extend(points.iter().copied().map(DVec3::from));
    Ok(out)
}

/// Whole numbers below `below`.
fn indices<'a>(
    stage: &Stage<'a>,
    prim: &Prim<'a>,
    name: &str,
    below: usize,
) -> Result<(Lexer<'a>, Vec<u32>)> {
    let Some((place, numbers)) = stage.list(prim, name)? else {
        return Ok((stage.lexer, Vec::new()));
    };
    let mut out = vec_with_room(numbers.len())?;
    for number in numbers {
        if !(number >= 0.0 && number.fract() == 0.0) {
            return Err(place.expected(Wanted::WholeNumber));
        }
        if number >= below as f64 || number > f64::from(u32::MAX) {
            let (index, count) = (number as u64, below);
            return Err(place.wrong(Cause::Index { index, count }));
        }
        out.push(number as u32);
    }
    Ok((place, out))
}

/// How many corners each part has; together as many as there are.
fn counts<'a>(stage: &Stage<'a>, prim: &Prim<'a>, name: &str, all: usize) -> Result<Vec<u32>> {
    let (place, counts) = indices(stage, prim, name, all + 1)?;
    let wanted = counts.iter().map(|&count| u64::from(count)).sum::<u64>();
    if wanted != all as u64 {
        let wanted = usize::try_from(wanted).unwrap_or(usize::MAX);
        return Err(place.wrong(Cause::NumberCount { wanted, found: all }));
    }
    Ok(counts)
}

/// Geometry of a prim, behind what was read of the same object.
///
/// # Errors
/// What is wrong in the file, with the line.
pub(super) fn read(stage: &Stage<'_>, prim: &Prim<'_>, before: &Mesh) -> Result<Geometry> {
    let mut told = Vec::new();
    let mut mesh = before.clone();
    let first = mesh.points.len() as u32;
    let points = points(stage, prim)?;
    let own = points.len();
    if stage
        .attribute(prim, "points")
        .is_some_and(|found| found.samples)
    {
        told.push("points.timeSamples");
    }
    match prim.kind {
        "Mesh" => {
            let (_, corners) = indices(stage, prim, "faceVertexIndices", own)?;
            let mut rest = &corners[..];
            for count in counts(stage, prim, "faceVertexCounts", corners.len())? {
                let (face, others) = rest.split_at(count as usize);
                rest = others;
                let from = mesh.triangles.len();
                let fan = vides_mesh::fan(face, &mut mesh.triangles);
                fan.map_err(|_| EngineError::Memory)?;
                let new = mesh.triangles[from..].iter_mut().flatten();
                new.for_each(|corner| *corner += first);
            }
            if !matches!(stage.token(prim, "subdivisionScheme")?, Some("none")) {
                told.push("subdivisionScheme");
            }
        }
        "BasisCurves" => {
            let closed = stage.token(prim, "wrap")? == Some("periodic");
            if stage.token(prim, "type")? != Some("linear") {
                told.push("cubic BasisCurves");
            }
            let mut at = first;
            for count in counts(stage, prim, "curveVertexCounts", own)? {
                mesh.lines.try_reserve(count as usize)?;
                let end = at + count;
                mesh.lines.extend((at + 1..end).map(|to| [to - 1, to]));
                if closed && count > 2 {
                    mesh.lines.push([end - 1, at]);
                }
                at = end;
            }
        }
        _ => {}
    }
    mesh.points.try_reserve(own)?;
    mesh.points.extend(points);
    let colour = colours(stage, prim, own, &mut mesh, &mut told)?;
    Ok(Geometry { mesh, colour, told })
}

/// Colours of the points go into the mesh; one for all is given back.
fn colours(
    stage: &Stage<'_>,
    prim: &Prim<'_>,
    own: usize,
    mesh: &mut Mesh,
    told: &mut Vec<&'static str>,
) -> Result<Option<Curve>> {
    const NAME: &str = "primvars:displayColor";
    const WHITE: [u8; 3] = [255; 3];
    let all = mesh.points.len();
    let mut own_colours = None;
    let mut whole = None;
    if let Some(attribute) = stage.attribute(prim, NAME) {
        let indexed = stage
            .attribute(prim, "primvars:displayColor:indices")
            .is_some();
        match attribute.interpolation {
            "" | "constant" if !indexed => match stage.list(prim, NAME)? {
                Some((_, numbers)) if numbers.len() == 3 => whole = stage.curve(prim, NAME, 3)?,
                Some((_, numbers)) if numbers.is_empty() => {}
                _ => told.push("primvars:displayColor"),
            },
            "vertex" | "varying" if !indexed && !attribute.samples => {
                own_colours = stage
                    .list(prim, NAME)?
                    .filter(|(_, colours)| !colours.is_empty());
            }
            _ => told.push("primvars:displayColor"),
        }
    }
    if own_colours.is_none() && mesh.colours.is_empty() {
        return Ok(whole);
    }
    mesh.colours.try_reserve(all)?;
    mesh.colours.resize(all - own, WHITE);
    if let Some((place, colours)) = own_colours {
        if colours.len() != 3 * own {
            return Err(place.wrong(Cause::NumberCount {
                wanted: 3 * own,
                found: colours.len(),
            }));
        }
        let colours = colours.chunks_exact(3);
        mesh.colours
            .extend(colours.map(|colour| [0, 1, 2].map(|part| srgb::byte(colour[part]))));
    }
    mesh.colours.resize(all, WHITE);
    Ok(whole)
}

/// The points of the document's wireframe.
///
/// # Errors
/// As [`read`].
pub(super) fn wireframe(
    stage: &Stage<'_>,
    prim: &Prim<'_>,
    out: &mut Vec<ObjectPoint>,
) -> Result<()> {
    let points = points(stage, prim)?;
    let mut rest = &points[..];
    for count in counts(stage, prim, "curveVertexCounts", points.len())? {
        let (curve, others) = rest.split_at(count as usize);
        rest = others;
        // A line of no length is a point.
        let curve = match curve {
            [a, b] if a == b => &curve[..1],
            _ => curve,
        };
        out.try_reserve(curve.len())?;
        out.extend(curve.iter().enumerate().map(|(at, &position)| ObjectPoint {
            position,
            draw: at > 0,
        }));
    }
    Ok(())
}
