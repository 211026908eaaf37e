//! Says what the path leaves open about the ways to and from the current orientation.

use vides_engine::path::{Ambiguity, ambiguity};

use super::fill;
use crate::state::Editor;

impl Editor {
    /// Says in the output field what is ambiguous, if anything is.
    pub(crate) fn tell_ambiguities(&mut self) {
        if let Some(words) = self.ambiguities() {
            self.say(words);
        }
    }

    fn ambiguities(&self) -> Option<String> {
        let at = self.document.selection();
        let path = self.document.path();
        let (section, ambiguity) = self
            .document
            .timeline(|timeline| {
                let count = timeline.section_count();
                let on = timeline.section_from(at.point, at.orientation);
                let to = match on.unwrap_or(count) {
                    0 => path.closed.then(|| count.saturating_sub(1)),
                    on => Some(on - 1),
                };
                let found = |section: usize| {
                    ambiguity(path, timeline, section)
                        .map(|ambiguity| (timeline.section(section), ambiguity))
                };
                on.and_then(found).or_else(|| to.and_then(found))
            })
            .ok()??;
        let orientations = path.points.get(section.point)?.orientations.len();
        let next = if section.orientation + 1 < orientations {
            (section.point, section.orientation + 1)
        } else {
            ((section.point + 1) % path.points.len(), 0)
        };
        let texts = &self.texts().output;
        let text = match ambiguity {
            Ambiguity::HalfTurn => texts.half_turn,
            Ambiguity::AtTarget => texts.at_target,
            Ambiguity::OverTarget => texts.over_target,
        };
        let from = self.name_of(section.point, section.orientation);
        Some(fill(text, &[&from, &self.name_of(next.0, next.1)]))
    }

    /// An orientation by its point's number, from 1, and its own where the point has several.
    pub(crate) fn name_of(&self, point: usize, orientation: usize) -> String {
        let several = self.document.path().points.get(point);
        if several.is_some_and(|point| point.orientations.len() > 1) {
            format!("{}.{}", point + 1, orientation + 1)
        } else {
            format!("{}", point + 1)
        }
    }
}
