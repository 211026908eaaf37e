//! Curves of the keys of nodes: which are seen, where their dots stand, what lies under the pointer.

use std::collections::BTreeSet;

use egui::{Pos2, Rect, pos2, vec2};
use vides_engine::scene::{Interpolation, Track};

use crate::action::Action;
use crate::playing::axis::{Axis, REACH};
use crate::playing::track_curve::{Of, is_read_only};
use crate::state::playing::track_graph::{Dot, Memory, Parts, Side};
use crate::state::scene_view::KeyAt;

/// How long a handle is.
pub(crate) const HANDLE: f32 = 40.0;

/// The share of the height that stays free above and below.
pub(crate) const FREE: f64 = 0.1;

/// As many tracks are shown where none is chosen.
pub(crate) const MOST: usize = 16;

/// From numbers to the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fit {
    pub(crate) low: f64,
    pub(crate) bottom: f64,
    pub(crate) per_point: f64,
}

impl Fit {
    pub(crate) fn new((low, high): (f64, f64), rect: Rect) -> Self {
        let (bottom, height) = (f64::from(rect.bottom()), f64::from(rect.height().max(1.0)));
        let per_point = (high - low) / height;
        Self {
            low,
            bottom,
            per_point,
        }
    }

    /// What is far away stays within what can be drawn.
    #[allow(clippy::cast_possible_truncation)]
    pub(crate) fn y(&self, value: f64) -> f32 {
        let y = self.bottom - (value - self.low) / self.per_point;
        y.clamp(-1e5, 1e5) as f32
    }
}

/// The least and the greatest number that are seen, with room around them.
pub(crate) fn range_of(bounds: Option<(f64, f64)>) -> (f64, f64) {
    let (low, high) = bounds.unwrap_or((0.0, 1.0));
    let least = 1e-9 * low.abs().max(high.abs()).max(1e-3);
    let more = match high - low > least {
        true => FREE * (high - low),
        false => 0.5 * high.abs().max(1.0),
    };
    (low - more, high + more)
}

/// What is seen.
pub(crate) struct Shown<'a> {
    pub(crate) axis: Axis,
    pub(crate) fit: Fit,
    pub(crate) ground: Rect,
    pub(crate) tracks: Vec<Of<'a>>,
    pub(crate) selected: Vec<KeyAt>,
}

impl<'a> Shown<'a> {
    pub(crate) fn place(&self, of: &Of<'_>, key: usize, part: usize) -> Pos2 {
        let x = self.axis.place(of.track.frames()[key]);
        pos2(x, self.fit.y(of.of_key(key, part)))
    }

    pub(crate) fn track_of(&self, at: &KeyAt) -> Option<Of<'a>> {
        self.tracks.iter().find(|of| of.has(at)).copied()
    }

    /// Where the handle of a tangent stands.
    pub(crate) fn handle(&self, of: &Of<'_>, dot: &Dot, side: Side) -> Option<Pos2> {
        let slope = side.slope(of.track, dot.at.key, dot.part)?;
        let way = vec2(1.0, self.rise(slope)).normalized() * HANDLE * side.sign();
        Some(self.place(of, dot.at.key, dot.part) + way)
    }

    /// The slope in points of a number that changes at this rate per frame.
    #[allow(clippy::cast_possible_truncation)]
    pub(crate) fn rise(&self, slope: f64) -> f32 {
        let rise = -slope * self.axis.frames_per_point() / self.fit.per_point;
        rise.clamp(-1e6, 1e6) as f32
    }

    /// The inverse, of a handle at this offset from its key.
    pub(crate) fn slope(&self, way: egui::Vec2) -> f64 {
        let frames = f64::from(way.x) * self.axis.frames_per_point();
        -f64::from(way.y) * self.fit.per_point / frames
    }

    /// The handles that are seen, of selected numbers.
    pub(crate) fn handles(&self, parts: &Parts) -> Vec<(Dot, Side, Pos2)> {
        let mut all = Vec::new();
        for dot in self.dots(parts) {
            let Some(of) = self.track_of(&dot.at) else {
                continue;
            };
            let sides = [Side::Before, Side::After].into_iter();
            let places = sides.filter_map(|side| Some((side, self.handle(&of, &dot, side)?)));
            all.extend(places.map(|(side, place)| (dot.clone(), side, place)));
        }
        all
    }

    /// The selected numbers of keys that are in sight.
    pub(crate) fn dots(&self, parts: &Parts) -> Vec<Dot> {
        let in_sight = |frame| self.axis.sees(self.axis.place(frame));
        self.all_dots(parts, in_sight)
    }

    /// The selected numbers of keys at such frames.
    pub(crate) fn all_dots(&self, parts: &Parts, such: impl Fn(f64) -> bool) -> Vec<Dot> {
        let mut all = Vec::new();
        for at in &self.selected {
            let Some(of) = self.track_of(at) else {
                continue;
            };
            let frame = of.track.frames()[at.key];
            if such(frame) {
                let chosen = parts_of(parts, &of, frame).into_iter();
                all.extend(chosen.map(|part| dot(&of, at.key, part)));
            }
        }
        all
    }

    pub(crate) fn hit(&self, parts: &Parts, at: Pos2) -> Hit {
        for (dot, side, place) in self.handles(parts) {
            if place.distance(at) <= REACH {
                return Hit::Handle(dot, side);
            }
        }
        let ends = [at.x - REACH, at.x + REACH].map(|x| self.axis.frame(x));
        let mut near: Option<(f32, Dot)> = None;
        for of in &self.tracks {
            for key in keys_between(of.track, ends) {
                for part in 0..of.width() {
                    let away = self.place(of, key, part).distance(at);
                    let nearer = near.as_ref().is_none_or(|(known, _)| away < *known);
                    if away <= REACH && nearer {
                        near = Some((away, dot(of, key, part)));
                    }
                }
            }
        }
        near.map_or(Hit::Nothing, |(_, dot)| Hit::Dot(dot))
    }

    /// The numbers of keys within a box.
    pub(crate) fn within(&self, place: Rect) -> Vec<Dot> {
        let ends = [place.left(), place.right()].map(|x| self.axis.frame(x));
        let mut all = Vec::new();
        for of in &self.tracks {
            for key in keys_between(of.track, ends) {
                let inside = (0..of.width())
                    .filter(|&part| place.y_range().contains(self.place(of, key, part).y));
                all.extend(inside.map(|part| dot(of, key, part)));
            }
        }
        all
    }
}

/// What lies under the pointer.
pub(crate) enum Hit {
    Nothing,
    Dot(Dot),
    Handle(Dot, Side),
}

pub(crate) fn keys_between(track: &Track, [first, last]: [f64; 2]) -> std::ops::Range<usize> {
    let frames = track.frames();
    let low = frames.partition_point(|&key| key < first);
    low..frames.partition_point(|&key| key <= last).max(low)
}

/// Whether the numbers of a track have handles.
pub(crate) fn has_handles(track: &Track) -> bool {
    *track.interpolation() == Interpolation::Hermite && !is_read_only(track)
}

/// Which numbers of the selected key at a frame are.
pub(crate) fn parts_of(parts: &Parts, of: &Of<'_>, frame: f64) -> Vec<usize> {
    let known = parts.range(of.part(frame, 0)..of.part(frame, of.width()));
    let known: Vec<usize> = known.map(|of| of.3).collect();
    match known.is_empty() {
        true => (0..of.width()).collect(),
        false => known,
    }
}

/// Selects these numbers.
pub(crate) fn select(
    memory: &mut Memory,
    shown: &Shown<'_>,
    dots: Vec<Dot>,
    actions: &mut Vec<Action>,
) {
    memory.parts.clear();
    let mut keys: Vec<KeyAt> = Vec::new();
    for Dot { at, part } in dots {
        let Some(of) = shown.track_of(&at) else {
            continue;
        };
        let of_key = of.part(of.track.frames()[at.key], part);
        if memory.parts.insert(of_key) && keys.last() != Some(&at) {
            keys.push(at);
        }
    }
    let mut seen = BTreeSet::new();
    keys.retain(|at| seen.insert((at.node, at.channel.clone(), at.key)));
    if keys != shown.selected {
        actions.push(Action::SelectKeys(keys));
    }
}

pub(crate) fn dot(of: &Of<'_>, key: usize, part: usize) -> Dot {
    let at = of.key(key);
    Dot { at, part }
}
