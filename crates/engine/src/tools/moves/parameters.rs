//! What moves ask for.

use crate::limits::{MAX_COORDINATE, MAX_ZOOM, MIN_ZOOM};
use crate::tools::parameter::{Parameter, Unit};

pub(super) const fn length(name: &'static str, does: &'static str, default: f64) -> Parameter {
    Parameter {
        name,
        does,
        unit: Unit::Length,
        width: 1,
        least: -MAX_COORDINATE,
        most: MAX_COORDINATE,
        default,
    }
}

/// A length greater than 0.
pub(super) const fn distance(name: &'static str, does: &'static str, default: f64) -> Parameter {
    Parameter {
        least: 1e-6,
        ..length(name, does, default)
    }
}

pub(super) const fn degrees(name: &'static str, does: &'static str, default: f64) -> Parameter {
    Parameter {
        name,
        does,
        unit: Unit::Degrees,
        width: 1,
        least: -360_000.0,
        most: 360_000.0,
        default,
    }
}

pub(super) const AROUND: Parameter = Parameter {
    width: 3,
    ..length("around", "the place in the middle of the view", 0.0)
};

pub(super) const RADIUS: Parameter = distance("radius", "distance from the axis", 1.0);

pub(super) const HEIGHT: Parameter =
    length("height", "how far above the target the camera is", 0.4);

pub(super) const FROM: Parameter = degrees("from", "heading at which the camera begins", 0.0);

pub(super) const TURNS: Parameter = Parameter {
    name: "turns",
    does: "number of turns; negative: clockwise from above",
    unit: Unit::One,
    width: 1,
    least: -1000.0,
    most: 1000.0,
    default: 1.0,
};

pub(super) const ZOOM: Parameter = Parameter {
    name: "zoom",
    does: "focal length",
    unit: Unit::Zoom,
    width: 1,
    least: MIN_ZOOM,
    most: MAX_ZOOM,
    default: 24.0,
};

pub(super) const SECONDS: Parameter = Parameter {
    name: "seconds",
    does: "duration; 0: by its length",
    unit: Unit::Seconds,
    width: 1,
    least: 0.0,
    most: 1e6,
    default: 10.0,
};

pub(super) const RISE: Parameter = Parameter {
    least: -89.0,
    most: 89.0,
    ..degrees("rise", "how steeply the camera is above the target", 15.0)
};
