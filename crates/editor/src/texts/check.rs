//! Texts of the check window.

use vides_document::Note;
use vides_engine::tools::check::{Finding, FindingKind};

use super::{Language, texts};

texts! {
    Check {
        menu, menu_hint, title, nothing, one, many, before, old, now, now_hint, large, frame,
        frames, go_hint, mend, fixed_way, fixed_views, fixed_pace, fixed_frames, fixed_ahead,
        fixed_speeds, fixed_curve, fixed_key, no_fix, limits, limits_hint, limit_hint, inside,
        moving, all_moving, camera,
    }
}

impl Language {
    /// The sentence of a finding, and its remedy.
    pub(crate) fn finding(self, finding: &Finding) -> (String, &'static str) {
        let kind = finding.kind;
        let sentence = self.word("finding", kind.name(), kind.sentence());
        let remedy = self.word("remedy", kind.name(), kind.remedy());
        let say = |value: f64, decimals: usize| self.number(value, decimals);
        (finding.say(sentence, say), remedy)
    }

    /// What the fix of a finding did, at its point and frame.
    pub(crate) fn mended(self, kind: FindingKind) -> &'static str {
        let texts = &self.texts().check;
        match kind {
            FindingKind::Through | FindingKind::Clearance => texts.fixed_way,
            FindingKind::NothingToSee => texts.fixed_views,
            FindingKind::Turning | FindingKind::Zoom => texts.fixed_frames,
            FindingKind::ViewJump => texts.fixed_ahead,
            FindingKind::SpeedJump => texts.fixed_speeds,
            FindingKind::Corner | FindingKind::Cusp => texts.fixed_curve,
            FindingKind::Redundant => texts.fixed_key,
            _ => texts.fixed_pace,
        }
    }

    /// What a kind's limit limits, and its unit.
    pub(crate) fn limit(self, kind: FindingKind) -> [&'static str; 2] {
        [
            self.word("limit", kind.name(), kind.limit().does),
            self.word("limit_unit", kind.name(), kind.unit()),
        ]
    }

    pub(crate) fn note(self, note: &Note) -> String {
        let texts = &self.texts().check;
        match note {
            Note::Inside => texts.inside.to_owned(),
            Note::Moving { name, others: 0 } => super::fill(texts.moving, &[name]),
            Note::Moving { name, others } => super::fill(texts.all_moving, &[name, others]),
            Note::Camera => texts.camera.to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_has_whole_sentences_with_the_same_numbers() {
        let german = Language::German;
        let names: Vec<&str> = FindingKind::all().map(FindingKind::name).collect();
        for part in ["limit", "limit_unit", "finding", "remedy"] {
            german.has_exactly(part, &names);
        }
        for kind in FindingKind::all() {
            let translated = german.word("finding", kind.name(), "");
            let remedy = german.word("remedy", kind.name(), "");
            for text in [translated, remedy, kind.sentence(), kind.remedy()] {
                assert!(
                    text.starts_with(char::is_uppercase) && text.ends_with('.'),
                    "{text}"
                );
            }
            for place in ["{0}", "{1}", "{2}", "{3}"] {
                let there = [translated, kind.sentence()].map(|text| text.contains(place));
                assert_eq!(there[0], there[1], "{place} {}", kind.name());
            }
        }
    }
}
