//! What a check looks for: one table of names, limits, sentences and remedies.

use super::parameter::{Parameter, Unit};
use crate::limits::MAX_COORDINATE;

/// A kind of fault that is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FindingKind {
    /// The camera is outside the space.
    Space,
    /// The curve or the pace nearly stops within a section.
    Cusp,
    /// The speed jumps at a key.
    SpeedJump,
    /// The camera accelerates too much.
    Acceleration,
    /// The view jumps.
    ViewJump,
    /// The view turns too fast.
    Turning,
    /// The turning accelerates too much.
    TurningAcceleration,
    /// A half turn might go either way.
    HalfTurn,
    /// The view is nearly straight up or down.
    Pole,
    /// The target is too near.
    Target,
    /// The object is too near.
    Clearance,
    /// The path leads through the object.
    Through,
    /// Nothing of the object is in the picture.
    NothingToSee,
    /// The zoom is too fast.
    Zoom,
    /// The poses would be the same without a key.
    Redundant,
    /// The way turns too much at a point.
    Corner,
    /// The acceleration changes too fast.
    Jerk,
    /// The camera moves too fast.
    Speed,
    /// Things cross the picture too fast.
    Crossing,
    /// The path runs back although its points lead on.
    Backwards,
}

/// Number of kinds.
pub const COUNT: usize = 20;

/// A limit that nothing is beyond: disables its kind.
pub const OFF: f64 = f64::INFINITY;

/// A kind, its limit under the kind's name, its unit, what a finding says and what helps.
pub(super) type Row = (FindingKind, Parameter, [&'static str; 3]);

const fn row(
    kind: FindingKind,
    [name, does]: [&'static str; 2],
    [most, default]: [f64; 2],
    unit: &'static str,
    sentence: &'static str,
    remedy: &'static str,
) -> Row {
    let limit = Parameter {
        name,
        does,
        unit: Unit::One,
        width: 1,
        least: 0.0,
        most,
        default,
    };
    (kind, limit, [unit, sentence, remedy])
}

/// All that is looked for, in the order of the kinds.
#[rustfmt::skip]
pub(super) static ROWS: [Row; COUNT] = [
    row(FindingKind::Space, ["space", "outside the space"], [MAX_COORDINATE, 0.0], "half sizes",
        "From point {2}, view {3} the camera is up to {0} half sizes outside the space (limit {1}).",
        "Move or scale the points."),
    row(FindingKind::Cusp, ["cusp", "speed within a section"], [1.0, 0.02], "of its mean",
        "From point {2}, view {3} the way nearly stops within the section, at {0} of its mean speed \
         (limit {1}).",
        "Draw the points apart or give them smooth tangents."),
    row(FindingKind::SpeedJump, ["speed-jump", "jump of the speed at a key"], [1000.0, 0.5],
        "mean speeds",
        "At point {2}, view {3} the speed jumps by {0} mean speeds (limit {1}).",
        "Join the speeds of the two sections, or let them end and begin at rest."),
    row(FindingKind::Acceleration, ["acceleration", "acceleration"], [MAX_COORDINATE, 10.0],
        "half sizes/s²",
        "From point {2}, view {3} the camera accelerates by {0} half sizes/s² (limit {1}).",
        "Ease the section or give it more frames."),
    row(FindingKind::ViewJump, ["view-jump", "jump of the view"], [180.0, 1.0], "°",
        "From point {2}, view {3} the view jumps by {0}° (limit {1}°).",
        "Look ahead by a distance, or round off the corner."),
    row(FindingKind::Turning, ["turning", "turning"], [1e6, 60.0], "°/s",
        "From point {2}, view {3} the view turns by {0}°/s (limit {1}°/s).",
        "Give the section more frames."),
    row(FindingKind::TurningAcceleration, ["turning-acceleration", "acceleration of the turning"],
        [1e9, 300.0], "°/s²",
        "From point {2}, view {3} the turning accelerates by {0}°/s² (limit {1}°/s²).",
        "Ease the section."),
    row(FindingKind::HalfTurn, ["half-turn", "distance from a half turn"], [180.0, 0.1], "°",
        "From point {2}, view {3} the view makes half a turn but for {0}°, which might go either way \
         (limit {1}°).",
        "Put a view between the two."),
    row(FindingKind::Pole, ["pole", "distance from straight up or down"], [90.0, 3.0], "°",
        "From point {2}, view {3} the view comes within {0}° of straight up or down, where the \
         picture spins (limit {1}°).",
        "Lead the way aside."),
    row(FindingKind::Target, ["target", "distance from the target"], [MAX_COORDINATE, 0.05],
        "half sizes",
        "From point {2}, view {3} the camera comes within {0} half sizes of its target (limit {1}).",
        "Lead the way aside."),
    row(FindingKind::Clearance, ["clearance", "distance from the object"], [MAX_COORDINATE, 0.02],
        "half sizes",
        "From point {2}, view {3} the camera comes within {0} half sizes of the object (limit {1}).",
        "Lead the way aside."),
    row(FindingKind::Through, ["through", "way through the object"], [1.0, 0.0], "",
        "From point {2}, view {3} the way leads through the object.",
        "Lead the way aside."),
    row(FindingKind::NothingToSee, ["nothing-to-see", "nothing of the object in the picture"],
        [1e6, 1.0], "s",
        "From point {2}, view {3} nothing of the object is in the picture for {0} s (limit {1} s).",
        "Turn the views towards the object."),
    row(FindingKind::Zoom, ["zoom", "speed of the zoom"], [1e6, 30.0], "mm/s",
        "From point {2}, view {3} the zoom changes by {0} mm/s (limit {1} mm/s).",
        "Give the section more frames."),
    row(FindingKind::Redundant, ["redundant", "change of the poses by a key"], [1000.0, 1.0],
        "of 0.001 half sizes, 0.1° and 0.1 mm",
        "Without point {2}, view {3} the poses would be the same.",
        "Remove the view or the point."),
    row(FindingKind::Corner, ["corner", "turn of the way at a point"], [180.0, 60.0], "°",
        "At point {2}, view {3} the way turns by {0}° (limit {1}°).",
        "Give the point smooth tangents."),
    row(FindingKind::Jerk, ["jerk", "change of the acceleration"], [MAX_COORDINATE, OFF],
        "half sizes/s³",
        "From point {2}, view {3} the acceleration changes by {0} half sizes/s³ (limit {1}).",
        "Ease the section or give it more frames."),
    row(FindingKind::Speed, ["speed", "speed"], [MAX_COORDINATE, OFF], "half sizes/s",
        "From point {2}, view {3} the camera moves by {0} half sizes/s (limit {1}).",
        "Give the section more frames."),
    row(FindingKind::Crossing, ["crossing", "time in which a thing crosses the picture"],
        [1e6, OFF], "s",
        "From point {2}, view {3} what the camera looks at crosses the picture in {0} s (limit {1} s).",
        "Give the section more frames."),
    row(FindingKind::Backwards, ["backwards", "way back although the points lead on"],
        [MAX_COORDINATE, 0.001], "half sizes",
        "From point {2}, view {3} the way goes back by {0} half sizes although the points lead on \
         (limit {1}).",
        "Make the curve centripetal, or draw the points apart."),
];

impl FindingKind {
    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> + Clone {
        ROWS.iter().map(|row| row.0)
    }

    /// The limit beyond which it is reported; its name is that of the kind.
    #[must_use]
    pub const fn limit(self) -> &'static Parameter {
        &ROWS[self as usize].1
    }

    /// Its name: small letters, words joined by `-`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.limit().name
    }

    /// What its limit counts, after a number; may be empty.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        ROWS[self as usize].2[0]
    }

    /// What a finding says, with `{0}` for its value, `{1}` for the limit, `{2}` and `{3}` for the
    /// numbers, from 1, of the point and the view with which its section begins.
    #[must_use]
    pub const fn sentence(self) -> &'static str {
        ROWS[self as usize].2[1]
    }

    /// What helps.
    #[must_use]
    pub const fn remedy(self) -> &'static str {
        ROWS[self as usize].2[2]
    }
}
