//! Wavefront OBJ. Written by hand: other readers drop points without faces and give no line
//! numbers.

use vides_engine::scene::Mesh;

use super::error::{Error, Problem, Result};
use super::shared::{coordinates, fan, lines};

pub(super) fn read(bytes: &[u8], go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
    let mut mesh = Mesh::default();
    let mut corners: Vec<u32> = Vec::new();
    // A statement may name a later point.
    let mut last_named = (0, 0);
    for statement in lines(bytes, go_on) {
        let (line, mut words) = statement?;
        let wrong = |problem| Error::Line { line, problem };
        match words.next() {
            Some("v") => {
                let point = coordinates(&mut words).ok_or(wrong(Problem::Coordinates))?;
                mesh.points.try_reserve(1)?;
                mesh.points.push(point);
                // A fourth number alone is a weight, not a colour.
                if let Some(colour) = coordinates(&mut words) {
                    mesh.colours.try_reserve(1)?;
                    let byte = |share: f64| (share.clamp(0.0, 1.0) * 255.0).round() as u8;
                    mesh.colours.push(colour.to_array().map(byte));
                }
            }
            Some(kind @ ("f" | "l")) => {
                corners.clear();
                for word in words.take_while(|word| !word.starts_with('#')) {
                    let index = index(word, mesh.points.len()).ok_or(wrong(Problem::Indices))?;
                    corners.try_reserve(1)?;
                    corners.push(index);
                    last_named = last_named.max((index, line));
                }
                if kind == "l" {
                    mesh.lines.try_reserve(corners.len())?;
                    mesh.lines
                        .extend(corners.windows(2).map(|ends| [ends[0], ends[1]]));
                } else {
                    fan(&corners, &mut mesh.triangles)?;
                }
                if corners.len() < if kind == "l" { 2 } else { 3 } {
                    return Err(wrong(Problem::Indices));
                }
            }
            _ => {}
        }
    }
    if last_named.1 != 0 && last_named.0 as usize >= mesh.points.len() {
        let line = last_named.1;
        let problem = Problem::Indices;
        return Err(Error::Line { line, problem });
    }
    // Either all points have a colour or none.
    if mesh.colours.len() != mesh.points.len() {
        mesh.colours = Vec::new();
    }
    Ok(mesh)
}

/// The point index of a corner such as `7/1/3`: 1-based in the file, negative from the last so far.
fn index(corner: &str, points: usize) -> Option<u32> {
    let number: i64 = corner.split('/').next()?.parse().ok()?;
    let at = match number {
        1.. => number - 1,
        0 => return None,
        _ => number + i64::try_from(points).ok()?,
    };
    u32::try_from(at).ok()
}
