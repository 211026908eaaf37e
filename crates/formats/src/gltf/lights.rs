//! Lights that are written (`KHR_lights_punctual`).

use serde_json::json;
use vides_engine::scene::{Channel, Light, Node, Values};

use super::extensions;
use super::write::Writer;
use crate::error::Result;

/// How much wider the outer cone must be than the inner one, in radians, so that 32 bits tell.
const WIDER: f32 = 1e-3;

/// Colours to 1; what is more goes into the intensity.
fn brightness(values: &Values) -> f64 {
    values.colour.into_iter().fold(1.0, f64::max)
}

fn colour(values: &Values) -> [f32; 3] {
    let most = brightness(values);
    values.colour.map(|part| (part / most) as f32)
}

fn intensity(values: &Values) -> [f32; 1] {
    [(values.intensity * brightness(values)).min(f64::from(f32::MAX)) as f32]
}

/// Inner and outer, in radians; other programs refuse equal ones.
fn cone(values: &Values) -> [f32; 2] {
    let [inner, outer] = values.cone.map(|degrees| degrees.to_radians() as f32);
    let outer = outer.clamp(WIDER, std::f32::consts::FRAC_PI_2);
    [inner.min(outer - WIDER), outer]
}

impl Writer<'_, '_> {
    /// Adds the light of a node and returns its number.
    pub(super) fn light(&mut self, node: &Node, light: Light) -> Result<usize> {
        let at = self.lights.len();
        let moves = |channel| node.keys().track(&channel).is_some();
        let coloured = moves(Channel::Colour);
        let colours = self.channel(node, coloured, colour)?;
        let intensities = self.channel(node, coloured || moves(Channel::Intensity), intensity)?;
        let mut json = json!({
            "name": node.name,
            "type": light.name(),
            "color": colours[0],
            "intensity": intensities[0][0],
        });
        let pointer = |what: &str| {
            let what = what.to_owned();
            move || format!("/extensions/{}/lights/{at}/{what}", extensions::LIGHTS)
        };
        self.pointer(pointer("color"), &colours)?;
        self.pointer(pointer("intensity"), &intensities)?;
        if light == Light::Spot {
            let cones = self.channel(node, moves(Channel::Cone), cone)?;
            let [inner, outer] = cones[0];
            json["spot"] = json!({"innerConeAngle": inner, "outerConeAngle": outer});
            for (which, name) in ["innerConeAngle", "outerConeAngle"].into_iter().enumerate() {
                let one: Vec<[f32; 1]> = cones.iter().map(|cone| [cone[which]]).collect();
                self.pointer(pointer(&format!("spot/{name}")), &one)?;
            }
        }
        self.lights.try_reserve(1)?;
        self.lights.push(json);
        Ok(at)
    }
}
