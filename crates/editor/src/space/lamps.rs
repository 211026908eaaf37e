//! The lights of a scene on its shaded faces, so that one sees where they shine. Intensity 1 is
//! full brightness; distance does not weaken a lamp, since its unit is up to the program that
//! renders the scene.

use glam::{DAffine3, DVec3};
use vides_engine::scene::{Kind, Light};

use crate::state::scene_view::Now;

/// What a face has of the viewer's own light where the scene has lights.
const UNLIT: f64 = 0.35;

/// A light that is visible, in the coordinates of the picture.
pub(super) struct Lamp {
    kind: Light,
    position: DVec3,
    view: DVec3,
    /// 0…1.
    brightness: f64,
    /// Cosines of the inner and the outer half angle.
    cone: [f64; 2],
}

/// The lights at the playhead.
pub(super) fn lamps(now: &Now, into: DAffine3) -> Vec<Lamp> {
    let nodes = now.scene.nodes().iter().zip(&now.states);
    let visible = nodes.filter_map(|(node, state)| match node.kind {
        Kind::Light(kind) if state.visible != 0 => Some((kind, state)),
        _ => None,
    });
    let lamps = visible.map(|(kind, state)| Lamp {
        kind,
        position: into.transform_point3(state.pose.position()),
        view: into
            .transform_vector3(state.pose.view())
            .normalize_or_zero(),
        brightness: (state.intensity * DVec3::from(state.colour).max_element()).clamp(0.0, 1.0),
        cone: state.cone.map(|half| half.to_radians().cos()),
    });
    lamps.collect()
}

impl Lamp {
    /// How much of it a face gets, in 0…1.
    fn on(&self, place: DVec3, normal: DVec3) -> f64 {
        let way = match self.kind {
            Light::Directional => -self.view,
            Light::Point | Light::Spot => (self.position - place).normalize_or_zero(),
        };
        let [inner, outer] = self.cone;
        let within = match self.kind {
            Light::Spot => {
                ((-way.dot(self.view) - outer) / (inner - outer).max(1e-9)).clamp(0.0, 1.0)
            }
            Light::Point | Light::Directional => 1.0,
        };
        self.brightness * within * normal.dot(way).max(0.0)
    }
}

/// How much light a face gets, in 0…1, of which `head` is that of the viewer's own.
pub(super) fn lit(lamps: &[Lamp], place: DVec3, normal: DVec3, head: f64) -> f64 {
    if lamps.is_empty() {
        return head;
    }
    let sum: f64 = lamps.iter().map(|lamp| lamp.on(place, normal)).sum();
    UNLIT * head + (1.0 - UNLIT) * sum.min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lamp(kind: Light, brightness: f64) -> [Lamp; 1] {
        [Lamp {
            kind,
            position: 2.0 * DVec3::Y,
            view: -DVec3::Y,
            brightness,
            cone: [10.0_f64, 20.0].map(|half| half.to_radians().cos()),
        }]
    }

    /// A face towards a lamp is brighter than one at its side or back, by its intensity.
    #[test]
    fn a_lamp_lights_what_faces_it() {
        let on = |lamps: &[Lamp], normal: DVec3| lit(lamps, DVec3::ZERO, normal, 0.5);
        assert_eq!(on(&[], DVec3::Y), 0.5);
        for kind in [Light::Point, Light::Directional, Light::Spot] {
            let [full, half, none] = [1.0, 0.5, 0.0].map(|by| on(&lamp(kind, by), DVec3::Y));
            assert!(full > half && half > none, "{full} {half} {none}");
            for normal in [DVec3::X, -DVec3::Y] {
                assert_eq!(on(&lamp(kind, 1.0), normal), none);
            }
        }
        // Outside the cone of a spot there is no light.
        let beside = lit(&lamp(Light::Spot, 1.0), 2.0 * DVec3::X, DVec3::Y, 0.5);
        assert_eq!(beside, on(&lamp(Light::Spot, 0.0), DVec3::Y));
        assert!(lit(&lamp(Light::Point, 1.0), 2.0 * DVec3::X, DVec3::Y, 0.5) > beside);
    }
}
