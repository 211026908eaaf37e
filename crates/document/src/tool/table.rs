//! The tools but the moves, which the engine lists, with their parameters.

use vides_engine::deform::LATTICE;
use vides_engine::path::Up;
use vides_engine::planner::{DEFAULT_MARGIN, What};
use vides_engine::tools::{Parameter, Unit};

use super::{Kind, Tool};
use vides_engine::limits::{MAX_COORDINATE, MAX_FRAMES, MAX_POINTS};

const AXES: &[&str] = &["x", "y", "z"];

const fn one(name: &'static str, does: &'static str, default: f64) -> Parameter {
    Parameter {
        name,
        does,
        unit: Unit::One,
        width: 1,
        least: -1e3,
        most: 1e3,
        default,
    }
}

const fn degrees(name: &'static str, does: &'static str, default: f64) -> Parameter {
    Parameter {
        unit: Unit::Degrees,
        least: -360_000.0,
        most: 360_000.0,
        ..one(name, does, default)
    }
}

const fn count(name: &'static str, does: &'static str, most: usize, default: f64) -> Parameter {
    Parameter {
        unit: Unit::Count,
        least: 1.0,
        most: most as f64,
        ..one(name, does, default)
    }
}

pub(super) const FIRST: Parameter = count("first", "the first of the points", MAX_POINTS, 1.0);
pub(super) const LAST: Parameter = count("last", "the last of the points", MAX_POINTS, 2.0);
const RANGE: &[Parameter] = &[FIRST, LAST];
pub(super) const SEEN: Parameter = Parameter {
    unit: Unit::Switch,
    least: 0.0,
    most: 1.0,
    ..one("with-targets", "what the cameras see moves with it", 0.0)
};
const CHANGED: &[Parameter] = &[FIRST, LAST, SEEN];
pub(super) const AXIS: Parameter = Parameter::choice("axis", "the axis", AXES, 1);
pub(super) const ABOUT: Parameter = Parameter::choice(
    "about",
    "the fixed point",
    &["middle", "origin", "point", "target"],
    0,
);
const fn placed(default: usize) -> Parameter {
    let all = &["none", "move", "turn", "scale"];
    Parameter::choice("fit", "how it is placed there", all, default)
}

/// What a tool that makes a path has besides its own.
pub(super) const PUT: &[Parameter] = &[
    Parameter::choice(
        "put",
        "in place of the film, after the current point, or after the last one",
        &["replace", "insert", "append"],
        0,
    ),
    placed(0),
];

const TOLERANCE: Parameter = Parameter {
    unit: Unit::Length,
    least: 1e-9,
    most: MAX_COORDINATE,
    ..one(
        "tolerance",
        "how far a position may be from what was given",
        0.01,
    )
};

/// What a fit takes besides its parameters: the poses may be of any host's world.
pub(super) const OF_FIT: &[Parameter] = &[
    Parameter {
        least: f64::MIN,
        most: f64::MAX,
        ..one("fps", "frame rate of the path", 25.0)
    },
    Parameter::choice("up", "the up axis", Up::NAMES, 0),
    Parameter {
        width: 4,
        least: f64::MIN,
        most: f64::MAX,
        ..one("space", "centre and half size of the path's space", 0.0)
    },
];

/// What deformations take besides their parameters.
pub(super) const OF_DEFORM: &[Parameter] = &[Parameter {
    width: 6,
    least: f64::MIN,
    most: f64::MAX,
    ..one(
        "box",
        "two opposite corners; without: the bounds of the points",
        0.0,
    )
}];

/// What a tour takes besides its parameters.
pub(super) const OF_TOUR: &[Parameter] = &[Parameter {
    width: 3,
    least: f64::MIN,
    most: f64::MAX,
    ..one(
        "start",
        "where the flight begins; without: a closed tour",
        0.0,
    )
}];

pub(super) const TOOLS: &[Tool] = &[
    Tool {
        name: "draw",
        does: "makes a path of a line drawn in the space with the left button",
        kind: Kind::Draw,
        tables: [&[TOLERANCE], PUT],
    },
    Tool {
        name: "move",
        does: "moves points",
        kind: Kind::Shift,
        tables: [
            &[Parameter {
                width: 3,
                unit: Unit::Length,
                least: -MAX_COORDINATE,
                most: MAX_COORDINATE,
                ..one("by", "by how much", 0.0)
            }],
            CHANGED,
        ],
    },
    Tool {
        name: "turn",
        does: "rotates points about an axis",
        kind: Kind::Turn,
        tables: [
            &[AXIS, degrees("angle", "by which angle", 90.0), ABOUT],
            CHANGED,
        ],
    },
    Tool {
        name: "scale",
        does: "scales points",
        kind: Kind::Scale,
        tables: [&[one("factor", "by which factor", 0.5), ABOUT], CHANGED],
    },
    Tool {
        name: "mirror",
        does: "mirrors points along an axis",
        kind: Kind::Mirror,
        tables: [
            &[
                Parameter {
                    default: 0.0,
                    ..AXIS
                },
                ABOUT,
            ],
            CHANGED,
        ],
    },
    Tool {
        name: "taper",
        does: "makes one end of the points' box narrower",
        kind: Kind::Deform("taper"),
        tables: [
            &[
                AXIS,
                one("r0", "how wide it is at one end", 1.0),
                one("r1", "how wide it is at the other", 0.5),
            ],
            CHANGED,
        ],
    },
    Tool {
        name: "bulge",
        does: "makes the middle of the points' box wider",
        kind: Kind::Deform("taper"),
        tables: [
            &[AXIS, one("a", "how wide it is in the middle", 2.0)],
            CHANGED,
        ],
    },
    Tool {
        name: "twist",
        does: "twists the points' box about an axis",
        kind: Kind::Deform("twist"),
        tables: [&[AXIS, degrees("angle", "by which angle", 90.0)], CHANGED],
    },
    Tool {
        name: "bend",
        does: "bends the points' box along an axis",
        kind: Kind::Deform("bend"),
        tables: [&[AXIS, degrees("angle", "by which angle", 90.0)], CHANGED],
    },
    Tool {
        name: "free-form",
        does: "deforms the points' box by 4 × 4 × 4 control points",
        kind: Kind::Deform("free-form"),
        tables: [
            &[Parameter {
                unit: Unit::Lattice,
                width: 3 * LATTICE,
                ..one(
                    "lattice",
                    "one of 4 × 4 × 4 squares, and where it is in the box",
                    0.0,
                )
            }],
            CHANGED,
        ],
    },
    Tool {
        name: "insert",
        does: "inserts a path from a file after the current point",
        kind: Kind::Insert,
        tables: [
            &[
                placed(1),
                Parameter {
                    default: 1.0,
                    ..SEEN
                },
            ],
            &[],
        ],
    },
    Tool {
        name: "extract",
        does: "writes points as a separate path",
        kind: Kind::Extract,
        tables: [&[], RANGE],
    },
    Tool {
        name: "blend",
        does: "blends the path with another path from a file",
        kind: Kind::Blend,
        tables: [&[one("weight", "how much of the other path", 0.5)], &[]],
    },
    Tool {
        name: "reverse",
        does: "reverses the path",
        kind: Kind::Reverse,
        tables: [&[], &[]],
    },
    Tool {
        name: "repeat",
        does: "repeats the path",
        kind: Kind::Repeat,
        tables: [&[count("times", "how often", 100_000, 2.0)], &[]],
    },
    Tool {
        name: "frames",
        does: "gives points an exact number of frames",
        kind: Kind::Frames,
        tables: [
            &[count(
                "frames",
                "how many, including the first and the last",
                MAX_FRAMES,
                250.0,
            )],
            RANGE,
        ],
    },
    Tool {
        name: "retime",
        does: "sets the speed of points within the limits of a check",
        kind: Kind::Retime,
        tables: [
            &[Parameter {
                unit: Unit::Seconds,
                least: 0.0,
                most: 1e6,
                ..one("seconds", "how long; 0: as short as the limits allow", 0.0)
            }],
            RANGE,
        ],
    },
    Tool {
        name: "steady",
        does: "stabilises a recorded flight",
        kind: Kind::Steady,
        tables: [
            &[
                Parameter {
                    unit: Unit::Seconds,
                    least: 1e-3,
                    most: 600.0,
                    ..one(
                        "period",
                        "cut-off period: motion of this period is halved, faster motion is removed",
                        1.0,
                    )
                },
                Parameter {
                    unit: Unit::Length,
                    least: 0.0,
                    most: MAX_COORDINATE,
                    ..one(
                        "within",
                        "maximum distance any position may move; 0: no limit",
                        0.0,
                    )
                },
            ],
            &[],
        ],
    },
    Tool {
        name: "avoid",
        does: "moves the path away from the object",
        kind: Kind::Avoid,
        tables: [
            &[
                Parameter {
                    unit: Unit::Length,
                    least: 1e-9,
                    most: MAX_COORDINATE,
                    ..one("clearance", "least distance from the object", 0.02)
                },
                Parameter {
                    unit: Unit::Length,
                    least: 0.0,
                    most: MAX_COORDINATE,
                    ..one(
                        "radius",
                        "radius of a sphere around the camera that keeps the clearance",
                        0.0,
                    )
                },
            ],
            &[],
        ],
    },
    Tool {
        name: "picture",
        does: "keeps the object in the picture, as large as a margin allows",
        kind: Kind::Picture,
        tables: [
            &[
                Parameter {
                    least: 0.0,
                    most: 0.49,
                    ..one(
                        "margin",
                        "the share to keep free at each side",
                        DEFAULT_MARGIN,
                    )
                },
                Parameter::choice("what", "what keeps it there", What::NAMES, 0),
            ],
            &[],
        ],
    },
    Tool {
        name: "tour",
        does: "makes a flight that shows the object",
        kind: Kind::Tour,
        tables: [
            &[
                Parameter {
                    unit: Unit::Seconds,
                    least: 1e-3,
                    most: 1e6,
                    ..one("seconds", "how long the flight takes", 60.0)
                },
                Parameter {
                    least: 1e-6,
                    most: 1.0,
                    ..one("coverage", "the share of the visible surface to show", 0.95)
                },
                Parameter {
                    unit: Unit::Length,
                    least: 0.0,
                    most: MAX_COORDINATE,
                    ..one(
                        "distance",
                        "distance of the camera from what it shows; 0: automatic",
                        0.0,
                    )
                },
                Parameter {
                    unit: Unit::Switch,
                    least: 0.0,
                    most: 1.0,
                    ..one("inside", "in the object's free space, not around it", 0.0)
                },
            ],
            PUT,
        ],
    },
    Tool {
        name: "fit",
        does: "fits a path of few points to recorded poses",
        kind: Kind::Fit,
        tables: [
            &[
                TOLERANCE,
                Parameter {
                    least: 1e-6,
                    most: 180.0,
                    ..degrees(
                        "angle",
                        "how far view, up and field of view may be from theirs",
                        0.5,
                    )
                },
                Parameter {
                    unit: Unit::Count,
                    least: 0.0,
                    most: MAX_POINTS as f64,
                    ..one(
                        "points",
                        "maximum number of points; the tolerance follows from it; 0: as many as the tolerance needs",
                        0.0,
                    )
                },
                Parameter {
                    unit: Unit::Switch,
                    least: 0.0,
                    most: 1.0,
                    ..one(
                        "robust",
                        "ignores outliers: poses that differ from their neighbours",
                        0.0,
                    )
                },
            ],
            PUT,
        ],
    },
];
