//! What lies outside a range.

use std::fmt;

use super::counting::{Called, Entry, Index};
use super::text::{List, Text};
use crate::deform::formula;
use crate::limits;

/// Something with a number that can be out of range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // each is named below
pub enum Quantity {
    AimWeight,
    Bias,
    Continuity,
    Coordinate,
    CurveSpeed,
    DistanceAhead,
    Frame,
    Intensity,
    Parameter,
    Rate,
    Roll,
    Tension,
    Times,
    Value,
    Zoom,
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let called = match self {
            Self::AimWeight => Called("the weight of an aim", "aim_weight"),
            Self::Bias => Called("the bias", "bias"),
            Self::Continuity => Called("the continuity", "continuity"),
            Self::Coordinate => Called("a coordinate", "a coordinate"),
            Self::CurveSpeed => Called("each value of a speed curve", "speed"),
            Self::DistanceAhead => Called("the distance ahead", "distance"),
            Self::Frame => Called("a frame", "frame"),
            Self::Intensity => Called("the intensity", "intensity"),
            Self::Parameter => Called(
                "a parameter of a deformation",
                "a parameter of a deformation",
            ),
            Self::Rate => Called("a velocity or slope", "a velocity or slope"),
            Self::Roll => Called("the roll", "roll"),
            Self::Tension => Called("the tension", "tension"),
            Self::Times => Called("the number of times", "count"),
            Self::Value => Called("a value", "a value"),
            Self::Zoom => Called("the zoom", "zoom"),
        };
        called.fmt(f)
    }
}

/// A number of a caller's or a bound, written with an exponent from 1e9 on and below 1e-9.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound(pub f64);

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.abs() {
            1e9.. => write!(f, "{:e}", self.0),
            small if small > 0.0 && small < 1e-9 => write!(f, "{:e}", self.0),
            _ => self.0.fmt(f),
        }
    }
}

/// An index or a value outside its range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum OutOfRange {
    #[error("{0} must lie between {low} and {high}", low = Bound(*.1), high = Bound(*.2))]
    Between(Quantity, f64, f64),
    #[error("{0} must not exceed {max}", max = Bound(*.1))]
    Exceeds(Quantity, f64),

    // Paths.
    #[error("a path needs at least two support points")]
    TooFewSupportPoints,
    #[error(
        "there is no point {}: the path has points {} to {}",
        Index(*point), Index(0), Index(*last)
    )]
    NoPoint { point: usize, last: usize },
    #[error("there is no preset {0}: they are numbered 0 to 9")]
    NoPreset(usize),
    #[error("a point has between 1 and 10 orientations")]
    Orientations,
    #[error("{} must lie between 0 and 1000000 frames", Called("the hold", "hold"))]
    Hold,
    #[error("there is no frame {}: they go from {first} to {last}", Bound(*frame))]
    NoFrame { frame: f64, first: f64, last: f64 },
    #[error("a list has at least one pose")]
    NoPose,
    #[error("a section has at most {} frames", limits::MAX_SECTION_FRAMES)]
    SectionFrames,
    #[error(
        "a given distance has between 2 and {} keys",
        limits::MAX_DISTANCE_KEYS
    )]
    DistanceKeys,
    #[error(
        "the keys of a given distance must lead from 0, 0 to 1, 1, with both numbers increasing"
    )]
    DistanceOrder,
    #[error(
        "the shares of time for speeding up and slowing down must not be negative, and together not exceed 1"
    )]
    EaseShares,
    #[error("a part must begin and end between 0 and 1, its end after its start")]
    Part,
    #[error(
        "the first point of a range, {}, must not lie behind its last one, {}",
        Index(*first), Index(*last)
    )]
    PointOrder { first: usize, last: usize },
    #[error(
        "{frames} {} too few: it must have at least {least}",
        if *frames == 1 { "frame is" } else { "frames are" }
    )]
    TooFewFrames { frames: usize, least: usize },
    #[error("{frames} frames are too many: it can have at most {most}")]
    TooManyFrames { frames: usize, most: usize },
    #[error("at frame {0} the camera is at a key already")]
    AtKey(f64),
    #[error("on the way from point {} there are fewer frames than new points", Index(*.0))]
    FewerFrames(usize),
    #[error(
        "at frame {frame} the camera turns at point {}, there is no way to divide",
        Index(*point)
    )]
    Turning { frame: f64, point: usize },
    #[error("the place is too near to a point of the path")]
    NearPoint,

    // The space.
    #[error(
        "{} must lie between 1e-30 and 1e30",
        Called("the half size of the space", "half_size")
    )]
    HalfSize,
    #[error(
        "{} must lie within 1e9 half edges of the world's origin",
        Called("the centre of the space", "centre")
    )]
    Centre,
    #[error("a coordinate must lie within 1e9 half edges of the space's centre")]
    FarFromCentre,
    #[error(
        "{} must lie between 0 and 1e9 half edges of the space",
        Called("the distance ahead", "distance")
    )]
    DistanceAhead,

    // What is shown.
    #[error(
        "{} must be greater than 0 and at most 100000",
        Called("the frames per second", "fps")
    )]
    Fps,
    #[error("the zoom of a view must be positive and finite")]
    ViewZoom,
    #[error("the height of a picture must be positive and finite")]
    PictureHeight,
    #[error("a field of view must lie between 0 and 180 degrees, both left out")]
    FieldOfView,
    #[error("the aspect of a view must be positive and finite")]
    ViewAspect,
    #[error("the front plane must lie before the camera, at a positive distance")]
    FrontPlane,
    #[error("the back plane must lie farther from the camera than the front plane")]
    BackPlane,
    #[error("the window of a view must not be empty")]
    ViewWindow,
    #[error("the back plane of a view must lie behind its front plane")]
    ViewPlanes,
    #[error("the projection reference point must lie before the front plane")]
    ReferenceBehindFront,
    #[error("the projection reference point must not lie in the view plane")]
    ReferenceInViewPlane,
    #[error("the numbers of a view must not be so large or so close together")]
    ViewNumbers,
    #[error("the position of the camera is too large")]
    CameraTooFar,

    // Curves through points.
    #[error("the knots with indices {0} and {next} must not be so close together or far apart", next = .0 + 1)]
    KnotDistance(usize),
    #[error("a quaternion curve needs at least two keys, each with a time")]
    QuaternionKeys,
    #[error("the time asked for must lie between the first and the last key")]
    Time,
    #[error("each key needs its tension, continuity and bias")]
    KeyShapes,

    // Scenes.
    #[error("there is no node {node} among {count}, counted from 0")]
    NoNode { node: usize, count: usize },
    #[error(
        "node \"{node}\": there is no node {number} among {count} for its {link}, counted from 0"
    )]
    NoLink {
        node: Text,
        number: usize,
        count: usize,
        link: &'static str,
    },
    #[error("the path of \"{node}\" has no point {point} among {count}, counted from 0")]
    NoPathPoint {
        node: Text,
        point: usize,
        count: usize,
    },
    #[error("{nodes} nodes need as many states, not {given}")]
    States { nodes: usize, given: usize },
    #[error("a colour's numbers must lie between 0 and 1e9")]
    Colour,
    #[error("the inner angle of a cone must lie between 0 and the outer one, that one below 90")]
    Cone,
    #[error("a camera's near plane must lie behind 0 and before the far one, that one within 1e9")]
    CameraPlanes,

    // Tracks.
    #[error(
        "a channel of the host's own has 1 to {} numbers: value:NAME:3",
        limits::MAX_CHANNEL_WIDTH
    )]
    ChannelWidth,
    #[error("the channel \"{channel}\" has {wanted} numbers a key here, not {given}")]
    TrackWidth {
        channel: Text,
        wanted: usize,
        given: usize,
    },
    #[error("{keys} keys cannot share {numbers} numbers")]
    KeyNumbers { keys: usize, numbers: usize },
    #[error("a key has {wanted} numbers here, not {given}")]
    KeyWidth { wanted: usize, given: usize },
    #[error(
        "the interpolation \"{interpolation}\" needs {wanted} numbers for the shape of {keys} keys, not {given}"
    )]
    KeyShapeNumbers {
        interpolation: Text,
        wanted: usize,
        keys: usize,
        given: usize,
    },
    #[error("the frames of two keys are too close together to be joined smoothly")]
    KeyDistance,
    #[error("a value lies outside the range of its channel")]
    ChannelValue,
    #[error("a tangent must be finite and not exceed {}", limits::MAX_TANGENT)]
    Tangent,

    // Objects, deformations.
    #[error("{corner}there is no point {point} among {count}, counted from 0")]
    NoMeshPoint {
        corner: Entry,
        point: u32,
        count: usize,
    },
    #[error("{points} points need as many colours, not {given}")]
    MeshColours { points: usize, given: usize },
    #[error("{points} points need as much room, not {given}")]
    PointRoom { points: usize, given: usize },
    #[error("the shape \"{shape}\" has {given} points, the mesh {wanted}")]
    ShapePoints {
        shape: Text,
        given: usize,
        wanted: usize,
    },
    #[error("{shapes} shapes need as many weights, not {given}")]
    ShapeWeights { shapes: usize, given: usize },
    #[error("there is no shape {at} among {count}, counted from 0")]
    NoShape { at: usize, count: usize },
    #[error("there is no key {} among {count}, counted from {}", Index(*key), Index(0))]
    NoKeyThere { key: usize, count: usize },
    #[error("there is no deformation {at} among {count}, counted from 0")]
    NoDeformation { at: usize, count: usize },
    #[error(
        "the deformation \"{deformation}\" does not take {given} numbers; it takes {}",
        List(formula::counts(deformation))
    )]
    DeformationNumbers {
        deformation: &'static str,
        given: usize,
    },
    #[error("an axis of a deformation is 0, 1 or 2")]
    DeformationAxis,

    // Tools.
    #[error("{0} must lie between {low} and {high}", low = Bound(*.1), high = Bound(*.2))]
    NumberBetween(&'static str, f64, f64),
    #[error("{given} numbers are given where there are at most {most}")]
    NumbersGiven { given: usize, most: usize },
    #[error("the zoom would be {} at the end; it must lie between 1 and 2000", Bound(*.0))]
    ZoomAtEnd(f64),
    #[error("the camera must turn by more than 0 degrees")]
    NoTurn,
    #[error("the camera would stay where it is: the move must end elsewhere than it begins")]
    NoWay,
    #[error("there is no next point at which the block could end")]
    NoNextPoint,
    #[error("the weights must sum to 1, not to {}", Bound(*.0))]
    WeightSum(f64),
    #[error(
        "{} must be finite and greater than 0",
        Called("the tolerance", "tolerance")
    )]
    Tolerance,
    #[error(
        "{} must be greater than 0 and at most 180 degrees",
        Called("the tolerance of angles", "angle")
    )]
    ToleranceAngle,
    /// No path follows the poses with so few points.
    #[error("no path of so few points follows the poses, even at 1000 times the tolerance")]
    TooFewFittedPoints,
    #[error(
        "{} must be greater than 0 and at most {most} s (2,000 frames)",
        Called("the cut-off period", "period"), most = .0
    )]
    SteadyPeriod(f64),
    #[error(
        "{} must be finite and not less than 0",
        Called("the bound of steadying", "within")
    )]
    SteadyWithin,
    #[error(
        "{} must be greater than 0 and at most 1",
        Called("the share of a tour's surface", "coverage")
    )]
    Coverage,
    #[error(
        "{} must be 0 or between {} and {} times half the object's diagonal",
        Called("the distance of a tour", "distance"),
        Bound(limits::TOUR_DISTANCES[0]),
        Bound(limits::TOUR_DISTANCES[1])
    )]
    TourDistance,
}

#[cfg(test)]
mod tests {
    use super::Bound;

    #[test]
    fn numbers_of_any_size_are_short() {
        for (number, text) in [
            (1e-300, "1e-300"),
            (-5e-324, "-5e-324"),
            (1e-6, "0.000001"),
            (0.0, "0"),
            (999_999_999.5, "999999999.5"),
            (1e300, "1e300"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(Bound(number).to_string(), text);
        }
    }
}
