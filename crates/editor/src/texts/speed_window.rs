//! Texts of the speed-curve window.

use super::texts;

texts! {
    SpeedWindow {
        title: "Speed curve", "Zeitkurve";
        section: "Section {0} – {1}", "Abschnitt {0} – {1}";
        end_of_path: "{0} · end of the path: no section begins here",
            "{0} · Ende der Bahn: Hier beginnt kein Abschnitt";
        frames: "Frames", "Bilder";
        frames_hint: "The number of frames of this section; 0: by its length",
            "Die Zahl der Bilder dieses Abschnitts; 0: nach seiner Länge";
        seconds: "{0} s", "{0} s";
        locked: "keep", "festhalten";
        locked_hint: "Keeps its frames when the duration of the whole path changes",
            "Behält seine Bilder, wenn sich die Dauer der ganzen Bahn ändert";
        nothing_changes: "Nothing changes: no frames", "Nichts ändert sich: keine Bilder";
        pace: "Pace", "Tempo";
        ten: "Ten speeds", "Zehn Werte";
        ten_hint: "Ten speeds from the start of the section to its end",
            "Zehn Geschwindigkeiten vom Anfang des Abschnitts bis zum Ende";
        sine: "Sine", "Sinus";
        sine_hint: "Speeds up, cruises and slows down like a sine; the duration stays the same, within speed 100",
            "Fährt an, fährt gleichmäßig und bremst ab wie ein Sinus; die Dauer bleibt gleich, bis Geschwindigkeit 100";
        parabolic: "Parabolic", "Parabel";
        parabolic_hint: "Speeds up, cruises and slows down evenly (a parabola); the duration stays the same, within speed 100",
            "Fährt an, fährt gleichmäßig und bremst ab, jeweils gleichförmig, sodass der Weg eine Parabel ist; der Abschnitt dauert so lange wie bisher, soweit Geschwindigkeit 100 dafür reicht";
        distance: "Distance", "Weg";
        distance_hint: "Distance over time by keys, initially the present curve; the section gets its present number of frames",
            "Weg über der Zeit durch Schlüssel, anfangs der jetzige; der Abschnitt bekommt seine jetzige Zahl von Bildern";
        graph: "Graph", "Verlauf";
        graph_speed: "Speed", "Geschwindigkeit";
        graph_speed_hint: "The speed over the time of this section; 50 is that of the base frames",
            "Die Geschwindigkeit über der Zeit dieses Abschnitts; 50 ist die der Grundbilder";
        graph_distance: "Distance", "Weg";
        graph_distance_hint: "The distance covered over the time of this section, in percent",
            "Der zurückgelegte Weg über der Zeit dieses Abschnitts, in Prozent";
        graph_acceleration: "Acceleration", "Beschleunigung";
        graph_acceleration_hint: "By how much the speed changes in a second, over the time of this section",
            "Um wie viel sich die Geschwindigkeit in einer Sekunde ändert, über der Zeit dieses Abschnitts";

        rise: "Speeding up", "Anfahren";
        rise_hint: "Share of the time for speeding up; together with slowing down at most 100 %",
            "Anteil der Zeit zum Anfahren; zusammen mit dem Abbremsen höchstens 100 %";
        fall: "Slowing down", "Abbremsen";
        fall_hint: "Share of the time for slowing down; together with speeding up at most 100 %",
            "Anteil der Zeit zum Abbremsen; zusammen mit dem Anfahren höchstens 100 %";
        cruise: "Cruising speed", "Reisetempo";
        cruise_hint: "The speed between speeding up and slowing down, 1 to 100",
            "Die Geschwindigkeit zwischen Anfahren und Abbremsen, 1 bis 100";
        rise_end: "End of speeding up", "Ende des Anfahrens";
        fall_start: "Start of slowing down", "Beginn des Abbremsens";
        percent: "{0} %", "{0} %";

        way_graph: "Distance over time", "Weg über der Zeit";
        way_graph_hint: "Drag a key; a click on the curve adds one, a right click or Delete removes one; Shift: ten times finer",
            "Schlüssel ziehen; ein Klick auf die Kurve fügt einen ein, ein Rechtsklick oder Entf entfernt einen; Umschalt: zehnmal feiner";
        way_key: "Key {0}", "Schlüssel {0}";
        way_at: "{0} % at {1} %", "{0} % bei {1} %";
        which_key: "Key {0} of {1}", "Schlüssel {0} von {1}";
        key_time: "Time", "Zeit";
        key_time_hint: "When the key is reached: share of the section's time",
            "Wann der Schlüssel erreicht wird: Anteil an der Zeit des Abschnitts";
        key_way: "Distance", "Weg";
        key_way_hint: "How far the camera has come then: share of the section's way",
            "Wie weit die Kamera dann gekommen ist: Anteil am Weg des Abschnitts";
        new_key: "New key", "Neuer";
        new_key_hint: "One more key on the curve, where two are farthest apart in time",
            "Ein weiterer Schlüssel auf der Kurve, wo zwei zeitlich am weitesten auseinanderliegen";
        remove_key: "Remove", "Entfernen";
        remove_key_hint: "Remove this key", "Diesen Schlüssel entfernen";

        speed: "Speed {0}", "Geschwindigkeit {0}";

        constant: "Constant", "Gleichmäßig";
        constant_hint: "The same speed all the way; the section takes as long as before",
            "Überall dieselbe Geschwindigkeit; der Abschnitt dauert so lange wie bisher";
        ease_in: "Slow start", "Langsam los";
        ease_in_hint: "Slow, at the end as fast as the next section begins. Only where the path begins or the camera has held is it slow from the start: after another section it is at first as fast as that one ends. Without a next one, or with fixed frames, it takes as long as before",
            "Langsam, am Ende so schnell, wie der nächste Abschnitt beginnt. Nur wo die Bahn beginnt oder die Kamera gehalten hat, ist sie von Anfang an langsam: Nach einem anderen Abschnitt ist sie zuerst so schnell, wie dieser endet. Ohne einen nächsten oder mit festen Bildern dauert er so lange wie bisher";
        ease_out: "Slow end", "Langsam aus";
        ease_out_hint: "At the start as fast as the section before ends, then slow. Only where the path ends or the camera holds is it slow to the end: before another section it is at last as fast as that one begins. Without one before, or with fixed frames, it takes as long as before",
            "Am Anfang so schnell, wie der vorige Abschnitt endet, dann langsam. Nur wo die Bahn endet oder die Kamera hält, bleibt sie bis zuletzt langsam: Vor einem weiteren Abschnitt ist sie am Ende so schnell, wie dieser beginnt. Ohne einen vorigen oder mit festen Bildern dauert er so lange wie bisher";
        both: "Both", "Beides";
        both_hint: "Slow at both ends; joins the neighbouring sections as the other two do, and takes as long as before",
            "An beiden Enden langsam; schließt an die Nachbarn an wie die beiden anderen und dauert so lange wie bisher";

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
        base_move: "Distance", "Weg";
        base_move_hint: "Frames for a distance of half the space's size", "Bilder für einen Weg von der halben Größe des Raumes";
        base_turn: "Turn", "Drehung";
        base_turn_hint: "Frames for half a turn", "Bilder für eine halbe Drehung";
        base_zoom: "Zoom", "Zoom";
        base_zoom_hint: "Frames for a zoom from 1 to 100", "Bilder für einen Zoom von 1 bis 100";
        base_roll: "Roll", "Winkel";
        base_roll_hint: "Frames for a roll by 90°", "Bilder für ein Rollen um 90°";
        hold: "Hold (frames)", "Halt (Bilder)";
        hold_hint: "Frames that the camera rests before it goes on",
            "Bilder, die die Kamera ruht, bevor es weitergeht";
        fps: "Frames per second", "Bilder pro Sekunde";
        fps_hint: "The film's frame rate. Fixed times stay the same in seconds; otherwise the frames stay, and the film gets faster or slower",
            "Bildrate des Films. Feste Zeiten bleiben in Sekunden gleich; sonst bleiben die Bilder, und der Film wird schneller oder langsamer";
    }
}
