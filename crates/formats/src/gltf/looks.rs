//! Cameras, lights and colours that are read.

use vides_engine::limits::MAX_COORDINATE;
use vides_engine::scene::{Camera, Light, Values};

use super::extensions;
use crate::content::DEFAULT_ZOOM;
use crate::convention;
use crate::error::{Cause, Result};
use crate::tree::At;

/// How much farther than the near plane the far one is where the file has none.
const FAR: f64 = 1e5;

/// A camera of the file.
pub(super) struct ReadCamera {
    pub(super) camera: Camera,
    pub(super) zoom: f64,
    /// Whether its field of view was beyond the range.
    pub(super) clamped: bool,
    /// Whether its projection is orthographic.
    pub(super) flat: bool,
}

pub(super) fn camera(root: At<'_>, index: usize) -> Result<ReadCamera> {
    let at = root.need("cameras")?.element(index)?;
    let mut read = ReadCamera {
        camera: Camera::default(),
        zoom: DEFAULT_ZOOM,
        clamped: false,
        flat: false,
    };
    let Some(perspective) = at.get("perspective") else {
        read.flat = true;
        return Ok(read);
    };
    let (zoom, inside) = convention::zoom_of_field(perspective.need("yfov")?.number()?);
    (read.zoom, read.clamped) = (zoom, !inside);
    let near = perspective.get("znear").map_or(Ok(0.01), At::positive)?;
    let far = perspective
        .get("zfar")
        .map_or(Ok(near * FAR), At::positive)?;
    let far = far.min(MAX_COORDINATE);
    if near < far {
        read.camera = Camera { near, far };
    }
    Ok(read)
}

fn bright(number: f64) -> f64 {
    number.clamp(0.0, MAX_COORDINATE)
}

/// Half angles in radians as ours: degrees, the inner one at most the outer one.
pub(super) fn cone(inner: f64, outer: f64) -> [f64; 2] {
    let outer = outer.to_degrees().clamp(0.0, 90.0);
    [inner.to_degrees().clamp(0.0, outer), outer]
}

pub(super) fn light(root: At<'_>, index: usize, values: &mut Values) -> Result<Light> {
    let lights = root.need("extensions")?.need(extensions::LIGHTS)?;
    let at = lights.need("lights")?.element(index)?;
    let kind = at.need("type")?;
    let light = match kind.text()? {
        "directional" => Light::Directional,
        "point" => Light::Point,
        "spot" => Light::Spot,
        other => {
            return Err(kind.wrong(Cause::Unsupported {
                name: other.chars().take(64).collect::<String>().as_str().into(),
                help: "",
            }));
        }
    };
    if let Some(colour) = at.get("color") {
        values.colour = colour.numbers::<3>()?.map(bright);
    }
    if let Some(intensity) = at.get("intensity") {
        values.intensity = bright(intensity.number()?);
    }
    if light == Light::Spot {
        let spot = at.get("spot");
        let angle = |name, none| {
            let angle = spot.and_then(|spot| spot.get(name));
            angle.map_or(Ok(none), At::number)
        };
        values.cone = cone(
            angle("innerConeAngle", 0.0)?,
            angle("outerConeAngle", std::f64::consts::FRAC_PI_4)?,
        );
    }
    Ok(light)
}

/// The material of a mesh all of whose primitives have one.
pub(super) fn material(root: At<'_>, mesh: At<'_>) -> Result<Option<usize>> {
    let mesh = root.need("meshes")?.element(mesh.index()?)?;
    let mut found = None;
    for primitive in mesh.need("primitives")?.list()? {
        let Some(material) = primitive.get("material") else {
            return Ok(None);
        };
        let material = material.index()?;
        if found.is_some_and(|found| found != material) {
            return Ok(None);
        }
        found = Some(material);
    }
    Ok(found)
}

pub(super) fn base_colour(root: At<'_>, material: usize) -> Result<[f64; 3]> {
    let at = root.need("materials")?.element(material)?;
    let factor = at
        .get("pbrMetallicRoughness")
        .and_then(|look| look.get("baseColorFactor"));
    let Some(factor) = factor else {
        return Ok([1.0; 3]);
    };
    let [red, green, blue, _] = factor.numbers::<4>()?;
    Ok([red, green, blue].map(bright))
}
