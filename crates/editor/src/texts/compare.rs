//! Texts of the window that shows a rotation by quaternions and by Euler angles.

use super::texts;

texts! {
    Compare {
        menu: "Compare rotations …", "Drehungen vergleichen …";
        menu_hint: "Its keys by quaternions and by Euler angles, side by side",
            "Seine Schlüssel mit Quaternionen und mit Euler-Winkeln, nebeneinander";
        title: "Compare rotations", "Drehungen vergleichen";
        no_keys: "Select a node whose rotation moves by keys",
            "Einen Knoten auswählen, dessen Drehung sich durch Schlüssel bewegt";
        of: "Rotation of {0}", "Drehung von {0}";
        straight_hint: "Both go straight from key to key", "Beide gehen gerade von Schlüssel zu Schlüssel";
        smooth_hint: "Both go smoothly through the keys", "Beide gehen glatt durch die Schlüssel";
        quaternions: "Quaternions", "Quaternionen";
        angles: "Euler angles", "Euler-Winkel";
        use_these: "Use these", "Diese nehmen";
        use_these_of: "Use these: {0}", "Diese nehmen: {0}";
        use_hint: "Give the track these keys. One step to undo",
            "Die Schlüssel der Spur sind dann diese. Ein Schritt, der sich zurücknehmen lässt";
        in_use: "The track is so already", "So ist die Spur schon";
        angle: "Angle between them: {0}°", "Winkel dazwischen: {0}°";
        largest: "Largest: {0}° in frame {1}", "Größter: {0}° in Bild {1}";
        graph: "Angle over time", "Winkel über der Zeit";
    }
}
