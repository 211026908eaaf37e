//! Lenses and lights of a file.

use std::f64::consts::PI;

use vides_document::error::vec_with_room;
use vides_engine::limits::MAX_COORDINATE;
use vides_engine::scene::{Camera, Channel, Kind, Light, Node};

use super::curve::{Curve, all_times, clamped};
use super::read::Reader;
use super::stage::Prim;
use crate::convention::zoom_of_focal;
use crate::error::{Error, Result};

/// The lens of a file that does not say (UsdGeomCamera).
const FOCAL: f64 = 50.0;
const APERTURE: f64 = 15.2908;

/// Of light of 555 nm, as exporters of glTF take it for all light.
const LUMENS_PER_WATT: f64 = 683.0;

impl<'a> Reader<'_, 'a> {
    pub(super) fn planes(&self, prim: &Prim<'a>) -> Result<Camera> {
        let planes = self.stage.curve(prim, "clippingRange", 2)?;
        let Some([near, far]) = planes.map(|curve| curve.at(f64::NEG_INFINITY)) else {
            return Ok(Camera::default());
        };
        let far = far.min(MAX_COORDINATE);
        Ok(match 0.0 < near && near < far {
            true => Camera { near, far },
            false => Camera::default(),
        })
    }

    pub(super) fn lens(&mut self, prim: &Prim<'a>, node: &mut Node) -> Result<()> {
        let stage = self.stage;
        for name in ["horizontalApertureOffset", "verticalApertureOffset"] {
            let offset = stage.curve(prim, name, 1)?;
            let off = offset.is_some_and(|curve| curve.values.iter().any(|value| *value != 0.0));
            self.counts.off_centre += usize::from(off);
        }
        let depth = stage.curve(prim, "fStop", 1)?;
        if depth.is_some_and(|curve| curve.values.iter().any(|value| *value != 0.0)) {
            *self.told.entry("fStop").or_default() += 1;
        }
        if stage.token(prim, "projection")? == Some("orthographic") {
            *self.told.entry("orthographic projection").or_default() += 1;
            return Ok(());
        }
        let focal = stage.curve(prim, "focalLength", 1)?;
        let high = stage.curve(prim, "verticalAperture", 1)?;
        if focal.is_none() && high.is_none() {
            // As the schema has it.
            node.rest.zoom = zoom_of_focal(FOCAL, APERTURE).0;
            return Ok(());
        }
        let focal = focal.unwrap_or_else(|| Curve::constant(&[FOCAL]));
        let high = high.unwrap_or_else(|| Curve::constant(&[APERTURE]));
        let mut clamped = 0;
        let zoom = together([&focal, &high], |[focal, high]| {
            let (zoom, inside) = zoom_of_focal(focal, high);
            clamped += usize::from(!inside);
            [zoom]
        })?;
        self.counts.fields += clamped;
        if let Some(curve) = self.moving(node, Channel::Zoom, Some(zoom))? {
            node.rest.zoom = curve.first()[0];
        }
        Ok(())
    }

    pub(super) fn light(&mut self, prim: &Prim<'a>, node: &mut Node) -> Result<()> {
        let stage = self.stage;
        let colour = stage.curve(prim, "inputs:color", 3)?;
        let colour = colour.map(|curve| clamped(curve, MAX_COORDINATE));
        if let Some(curve) = self.moving(node, Channel::Colour, colour)? {
            node.rest.colour = curve.at(0.0);
        }
        let number = |name: &str, rest: f64| -> Result<Curve> {
            let curve = stage.curve(prim, name, 1)?;
            Ok(curve.unwrap_or_else(|| Curve::constant(&[rest])))
        };
        let directional = node.kind == Kind::Light(Light::Directional);
        // The schemas' own: a sun in nits.
        let (brightest, size, wide) = match directional {
            true => (50_000.0, "inputs:angle", 0.53),
            false => (1.0, "inputs:radius", 0.5),
        };
        let intensity = number("inputs:intensity", brightest)?;
        let exposure = number("inputs:exposure", 0.0)?;
        let size = number(size, wide)?;
        let flag = |name: &str| Ok::<_, Error>(number(name, 0.0)?.first()[0] != 0.0);
        let normalised = flag("inputs:normalize")?;
        let metres = stage.metres.unwrap_or(0.01);
        // Blender counts watts, not nits.
        let unit = match stage.doc.starts_with("Blender") {
            true => LUMENS_PER_WATT,
            false => 1.0,
        };
        let bright = together(
            [&intensity, &exposure, &size],
            |[intensity, exposure, size]| {
                // Finite, so that nothing times it is nothing.
                let share = exposure.exp2().min(f64::MAX);
                let area = match (directional, normalised || size == 0.0) {
                    (true, true) => 1.0,
                    (true, false) => PI * (size.to_radians() / 2.0).sin().powi(2),
                    (false, true) if normalised => 0.25,
                    // A point: nothing of a luminance, so what is meant is its intensity.
                    (false, true) => 1.0,
                    (false, false) => PI * (size * metres).powi(2),
                };
                [(intensity * share * area * unit).clamp(0.0, MAX_COORDINATE)]
            },
        )?;
        if let Some(curve) = self.moving(node, Channel::Intensity, Some(bright))? {
            node.rest.intensity = curve.first()[0];
        }
        if node.kind != Kind::Light(Light::Spot) {
            return Ok(());
        }
        let angle = number("inputs:shaping:cone:angle", 90.0)?;
        let softness = number("inputs:shaping:cone:softness", 0.0)?;
        let cone = together([&angle, &softness], |[angle, softness]| {
            let outer = angle.clamp(0.0, 90.0);
            [outer * (1.0 - softness.clamp(0.0, 1.0)), outer]
        })?;
        if let Some(curve) = self.moving(node, Channel::Cone, Some(cone))? {
            node.rest.cone = curve.at(0.0);
        }
        Ok(())
    }
}

/// A curve of one number each as one of `M` numbers, at the times of all.
fn together<const N: usize, const M: usize>(
    curves: [&Curve; N],
    mut make: impl FnMut([f64; N]) -> [f64; M],
) -> Result<Curve> {
    let times = all_times(curves.into_iter())?;
    let mut values = vec_with_room(M * times.len().max(1))?;
    let rest = [0.0];
    let at = if times.is_empty() { &rest[..] } else { &times };
    for &time in at {
        let all = curves.map(|curve| curve.at::<1>(time)[0]);
        values.extend(make(all));
    }
    Ok(Curve {
        times,
        values,
        width: M,
    })
}
