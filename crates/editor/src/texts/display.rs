//! Texts of the display window, and the names of what is seen.

use super::texts;
use crate::setup::Element;

texts! {
    DisplayWindow {
        title, background, cube, object, curve, segment, crosses, numbers, vpn, vup, circle, axes,
        plane, outside, cameras, ribbon, player, camera_view, all, all_hint, automatic, german_hint,
        english_hint, german, english, language_hint,
    }
}

impl DisplayWindow {
    pub(crate) fn name(&self, element: Element) -> &'static str {
        match element {
            Element::Background => self.background,
            Element::Cube => self.cube,
            Element::Object => self.object,
            Element::Curve => self.curve,
            Element::Segment => self.segment,
            Element::Crosses => self.crosses,
            Element::Numbers => self.numbers,
            Element::Vpn => self.vpn,
            Element::Vup => self.vup,
            Element::Circle => self.circle,
            Element::Axes => self.axes,
            Element::Plane => self.plane,
            Element::Outside => self.outside,
            Element::Cameras => self.cameras,
            Element::Ribbon => self.ribbon,
            Element::Player => self.player,
        }
    }
}
