//! Texts of the curve window.

use vides_engine::path::Tcb;

use super::{Language, texts};

texts! {
    Curve {
        title: "Curve parameters", "Kurvenparameter";
        of: "Point {0} · View {1}", "Punkt {0} · Blick {1}";
        waiting: "not applied yet", "noch nicht übernommen";

        preset: "Preset {0}", "Standard {0}";
        for_this: "for this point", "für diesen Punkt";
        for_all: "for all {0}", "für alle {0}";
        for_all_hint: "Other points use preset {0}, too. Apply to which points?",
            "Standard {0} gilt auch für andere Punkte: Für wen sind die neuen Werte?";
        own: "Own values", "Eigendef.";
        own_hint: "Values of this point alone", "Werte nur für diesen Punkt";
        smooth: "smooth", "glatt";
        tighter: "tighter", "straffer";
        rounder: "rounder", "runder";
        corner: "corner", "Ecke";
        corner_outwards: "corner, outwards", "Ecke nach außen";
        late: "turns late", "biegt später";
        early: "turns early", "biegt früher";

        used: "Used by {0} points", "Gilt für {0} Punkte";
        used_once: "Only this point", "Nur dieser Punkt";

        tension: "Tension", "Tension";
        tension_hint: "Tension: above 0 the curve is tighter, below 0 rounder",
            "Tension: über 0 verläuft die Kurve straffer, unter 0 runder";
        continuity: "Continuity", "Continuity";
        continuity_hint: "Continuity: the curve has a corner at the point, except at 0",
            "Continuity: abweichend von 0 hat die Kurve im Punkt eine Ecke";
        bias: "Bias", "Bias";
        bias_hint: "Bias: above 0 the curve turns after the point (overshoot), below 0 before it",
            "Bias: über 0 dreht die Kurve erst hinter dem Punkt (Overshot), unter 0 schon davor";

        picture: "Curve around this point", "Kurve um diesen Punkt";
        before: "as it is", "bisher";
        after: "as it will be", "künftig";

        position: "Pos", "Pos";
        orientation: "Ori", "Ori";
        target: "target", "Ziel";
        target_hint: "Absolute: the place that the camera looks at",
            "Absolut: der Ort, auf den die Kamera blickt";
        offset: "offset", "relativ";
        offset_hint: "Relative: the place that the camera looks at, as seen from the point",
            "Relativ: der Ort, auf den die Kamera blickt, vom Punkt aus";
        roll: "Roll", "Winkel";
        roll_hint: "Turns the camera about its view", "Dreht die Kamera um ihre Blickrichtung";

        show: "Show", "Zeigen";
        show_hint: "Apply what was entered", "Die Eingaben übernehmen";
        ok: "OK", "OK";
        ok_hint: "Apply what was entered and close", "Die Eingaben übernehmen und schließen";
        given_up: "Another point or view is current: what was entered has been discarded",
            "Ein anderer Punkt oder ein anderer Blick ist aktuell: Die Eingaben sind verworfen";
        given_up_changed: "The path has changed: what was entered has been discarded",
            "Die Bahn hat sich geändert: Die Eingaben sind verworfen";
    }
}

impl Curve {
    /// A preset by its effect on the curve: "5 corner".
    pub(crate) fn preset_name(&self, preset: usize, tcb: Tcb) -> String {
        let words: Vec<&str> = self.words(tcb).map(|(word, ..)| word).collect();
        if words.is_empty() {
            return format!("{preset} {}", self.smooth);
        }
        format!("{preset} {}", words.join(", "))
    }

    /// The effect of these parameters on the curve: "tighter  t 0.30".
    pub(crate) fn shape(&self, language: Language, tcb: Tcb) -> String {
        let words = self
            .words(tcb)
            .map(|(word, letter, value)| format!("{word}  {letter} {}", language.number(value, 2)));
        let words: Vec<String> = words.collect();
        if words.is_empty() {
            return self.smooth.to_owned();
        }
        words.join(", ")
    }

    /// A word for each parameter that is not 0, with its letter and value.
    fn words(&self, tcb: Tcb) -> impl Iterator<Item = (&'static str, &'static str, f64)> {
        let parts = [
            (tcb.tension, "t", [self.rounder, self.tighter]),
            (tcb.continuity, "c", [self.corner, self.corner_outwards]),
            (tcb.bias, "b", [self.early, self.late]),
        ];
        let known = parts.into_iter().filter(|(value, ..)| *value != 0.0);
        known.map(|(value, letter, [below, above])| {
            (if value < 0.0 { below } else { above }, letter, value)
        })
    }
}
