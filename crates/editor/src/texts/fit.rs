//! Texts on how well a path follows recorded poses.

use super::texts;

texts! {
    Fit {
        position: "Position: at most {0}, RMS {1}", "Position: höchstens {0}, RMS {1}";
        view: "View: at most {0}°, RMS {1}°", "Blick: höchstens {0}°, RMS {1}°";
        lens: "Field of view: at most {0}°, RMS {1}°", "Bildwinkel: höchstens {0}°, RMS {1}°";
        position_graph: "Deviation of the position over time; the line is the tolerance",
            "Abweichung der Position über der Zeit; die Linie ist die Toleranz";
        view_graph: "Deviation of view and field of view over time; the line is the tolerance",
            "Abweichung von Blick und Bildwinkel über der Zeit; die Linie ist die Toleranz";
        go_there: "Click to go to this frame", "Klicken, um zu diesem Bild zu gehen";
        recording: "{0} poses; noise of about {1}", "{0} Posen; Rauschen von etwa {1}";
        rate: "{0} frames per second", "{0} Bilder je Sekunde";
        found: "Found: {0}", "Gefunden: {0}";
        hold: "{0} hold", "{0} Halt";
        holds: "{0} holds", "{0} Halte";
        gap: "{0} gap", "{0} Lücke";
        gaps: "{0} gaps", "{0} Lücken";
        cut: "{0} cut", "{0} Schnitt";
        cuts: "{0} cuts", "{0} Schnitte";
        outlier: "{0} outlier, left out", "{0} Ausreißer, ausgelassen";
        outliers: "{0} outliers, left out", "{0} Ausreißer, ausgelassen";
        repeated: "{0} repeated time", "{0} wiederholte Zeit";
        repeated_times: "{0} repeated times", "{0} wiederholte Zeiten";
        times_in: "times in {0}", "Zeiten in {0}";
        nanoseconds: "nanoseconds", "Nanosekunden";
        microseconds: "microseconds", "Mikrosekunden";
        better: "{0} gives {1} points", "{0} ergibt {1} Punkte";
        better_hint: "The tolerance is below the noise. Take this one, which needs far fewer points",
            "Die Toleranz liegt unter dem Rauschen. Diese nehmen, die weit weniger Punkte braucht";
        robust: "Robust gives {0} points", "Robust ergibt {0} Punkte";
        robust_hint: "{0} outliers cost the other points. Leave them out",
            "{0} Ausreißer kosten die übrigen Punkte. Sie auslassen";
    }
}
