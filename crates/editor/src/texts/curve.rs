//! Texts of the curve window.

use vides_engine::path::Tcb;

use super::{Language, texts};

texts! {
    Curve {
        title, of, waiting, preset, for_this, for_all, for_all_hint, own, own_hint, smooth, tighter,
        rounder, corner, corner_outwards, late, early, used, used_once, tension, tension_hint,
        continuity, continuity_hint, bias, bias_hint, picture, before, after, position, orientation,
        target, target_hint, offset, offset_hint, roll, roll_hint, show, show_hint, ok, ok_hint,
        given_up, given_up_changed,
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
