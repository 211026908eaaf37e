//! Texts of the display window, and the names of what is seen.

use super::texts;
use crate::setup::Element;

texts! {
    DisplayWindow {
        title: "Display", "Anzeige";
        background: "Background", "Hintergrund";
        cube: "Movement space", "Darstellungswürfel";
        object: "Object", "Objekt";
        curve: "Curve", "Kurvenverlauf";
        segment: "Current segment", "Aktueller Abschnitt";
        crosses: "Support points", "Stützpunkte";
        numbers: "Numbers of the points", "Nummern der Punkte";
        vpn: "View direction (VPN)", "Blickrichtung (VPN)";
        vup: "Up (VUP)", "Oben (VUP)";
        circle: "Circle of VUP", "Kreis des VUP";
        axes: "Axes while dragging", "Achsen beim Ziehen";
        plane: "Plane while dragging", "Ebene beim Ziehen";
        outside: "Curve outside the space", "Kurve außerhalb";
        cameras: "All cameras", "Alle Kameras";
        ribbon: "Ribbon of views", "Band der Blickrichtungen";
        player: "Camera when playing", "Kamera beim Abspielen";
        camera_view: "Picture of the camera", "Bild der Kamera";
        all: "Show all", "Alles zeigen";
        all_hint: "Switch everything on", "Alles einschalten";
        automatic: "Language: automatic", "Sprache: automatisch";
        german_hint: "Show the window in German", "Das Fenster auf Deutsch zeigen";
        english_hint: "Show the window in English", "Das Fenster auf Englisch zeigen";
        german: "Deutsch", "Deutsch";
        english: "English", "English";
        language_hint: "Automatic: the language of the program that opened the window, or of the system",
            "Automatisch: die Sprache des Programms, das dieses Fenster öffnete, oder des Systems";
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
