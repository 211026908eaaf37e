//! Texts of the speed-curve window.

use super::texts;

texts! {
    /// Texts of the speed-curve window.
    SpeedWindow {
        title: "Speed curve", "Zeitkurve";
        section: "Section {0} – {1}", "Abschnitt {0} – {1}";
        end_of_path: "{0} · end of path: no section begins here",
            "{0} · Ende der Bahn: Hier beginnt kein Abschnitt";
        frames: "Frames", "Bilder";
        frames_hint: "So many for this section, whatever its length; 0: by its length",
            "So viele für diesen Abschnitt, wie lang er auch ist; 0: nach seiner Länge";
        seconds: "{0} s", "{0} s";
        locked: "keep", "festhalten";
        locked_hint: "Keeps its frames where the whole path gets another number of frames or seconds",
            "Behält seine Bilder, wenn die ganze Bahn eine andere Zahl von Bildern oder Sekunden bekommt";
        nothing_changes: "Nothing changes: no frames", "Nichts ändert sich: keine Bilder";
        speed: "Speed {0}", "Geschwindigkeit {0}";

        constant: "Constant", "Gleichmäßig";
        constant_hint: "The same speed all the way; the section takes as long as before",
            "Überall dieselbe Geschwindigkeit; der Abschnitt dauert so lange wie bisher";
        ease_in: "Slow start", "Langsam los";
        ease_in_hint: "Slow at the start, at the end as fast as the next section begins; without one the section takes as long as before",
            "Am Anfang langsam, am Ende so schnell, wie der nächste Abschnitt beginnt; ohne einen dauert er so lange wie bisher";
        ease_out: "Slow end", "Langsam aus";
        ease_out_hint: "At the start as fast as the section before ends, slow at the end; without one the section takes as long as before",
            "Am Anfang so schnell, wie der vorige Abschnitt endet, am Ende langsam; ohne einen dauert er so lange wie bisher";
        both: "Both", "Beides";
        both_hint: "Slow at both ends; the section takes as long as before",
            "An beiden Enden langsam; der Abschnitt dauert so lange wie bisher";

        copy: "Copy", "Kopieren";
        copy_hint: "Keep these ten speeds for pasting", "Diese zehn Geschwindigkeiten zum Einfügen merken";
        copied: "Speed curve copied", "Zeitkurve kopiert";
        paste: "Paste", "Einfügen";
        paste_hint: "Take over the ten speeds that were copied",
            "Die kopierten zehn Geschwindigkeiten übernehmen";
        reset: "Reset", "Zurücksetzen";
        reset_hint: "Speed 50 all the way", "Überall Geschwindigkeit 50";

        base: "Base frames", "Grundbilder";
        base_hint: "Frames that a change takes at speed 50, for the whole path",
            "Bilder, die eine Änderung bei Geschwindigkeit 50 dauert, für die ganze Bahn";
        base_move: "Way", "Weg";
        base_move_hint: "Frames for a way of half the space's size", "Bilder für einen Weg von der halben Größe des Raumes";
        base_turn: "Turn", "Drehung";
        base_turn_hint: "Frames for half a turn", "Bilder für eine halbe Drehung";
        base_zoom: "Zoom", "Zoom";
        base_zoom_hint: "Frames for a zoom from 1 to 100", "Bilder für einen Zoom von 1 bis 100";
        base_roll: "Roll", "Rollen";
        base_roll_hint: "Frames for a roll by 90°", "Bilder für ein Rollen um 90°";
        hold: "Hold (frames)", "Halt (Bilder)";
        hold_hint: "Frames that the camera rests before it goes on",
            "Bilder, die die Kamera ruht, bevor es weitergeht";
        fps: "Frames per second", "Bilder pro Sekunde";
        fps_hint: "The film's frame rate; it tells seconds only", "Bildrate des Films; nur für die Sekunden";
    }
}
