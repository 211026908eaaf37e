//! The causes of errors, one enum for each [`ErrorKind`](super::ErrorKind) of the engine. The
//! sentence above a variant is its documentation, too; the German one is in `texts/german.rs`.

use std::fmt;

use super::{Called, Entry, Index, List, Text};
use crate::limits;
use crate::scene::{Channel, Interpolation};
use crate::tools::check::FindingKind;

/// Something with a number that can be wrong by itself.
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

/// A bound of a range, written with an exponent from 1e9 on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound(pub f64);

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.abs() {
            1e9.. => write!(f, "{:e}", self.0),
            _ => self.0.fmt(f),
        }
    }
}

/// The name of a kind with the article that goes with it.
struct WithArticle<'a>(&'a str);

impl fmt::Display for WithArticle<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let vowel = self.0.starts_with(['a', 'e', 'i', 'o', 'u']);
        write!(f, "{} {}", if vowel { "an" } else { "a" }, self.0)
    }
}

/// What makes no sense whatever its size.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum Invalid {
    #[error("{0} must be a finite number")]
    NotFinite(Quantity),
    #[error("control characters are not allowed")]
    ControlCharacter,

    // Paths.
    #[error("the target must not lie on the camera's own position")]
    TargetOnCamera,
    #[error("a base speed must be finite and greater than zero")]
    BaseSpeed,
    #[error("the keys of a given distance must be finite numbers")]
    DistanceNotFinite,
    #[error("the control quaternions of a turning must have length 1")]
    ControlNotUnit,
    #[error("in the orientation mode barry-goldman a new key would change the views around it")]
    NoNewKey,

    // The space.
    #[error("{} must be finite", Called("the centre of the space", "centre"))]
    CentreNotFinite,
    #[error("a single place has no size that a space could have")]
    NoSize,

    // Views, rotations.
    #[error("every number of a view must be finite")]
    ViewNotFinite,
    #[error("{} must not be zero", Called("the view plane normal", "vpn"))]
    NormalZero,
    #[error("{} must not be zero", Called("the view up vector", "vup"))]
    ViewUpZero,
    #[error(
        "{} must not be parallel to {}",
        Called("the view up vector", "vup"),
        Called("the view plane normal", "vpn")
    )]
    ViewUpParallel,
    #[error(
        "{} must be finite",
        Called(
            "the position, the view direction and the up vector",
            "vrp, vpn and vup"
        )
    )]
    LookNotFinite,
    #[error(
        "{} must not be zero",
        Called("the view direction and the up vector", "vpn and vup")
    )]
    LookZero,
    #[error(
        "{} must not be parallel to {}",
        Called("the up vector", "vup"),
        Called("the view direction", "vpn")
    )]
    UpParallel,
    #[error("the axis of a rotation must be finite and not zero")]
    RotationAxis,
    #[error("the point and the angle of a rotation must be finite")]
    RotationNotFinite,
    #[error("a rotation must be finite and not zero")]
    RotationZero,
    #[error("a quaternion must be finite and not zero")]
    QuaternionZero,

    // Curves through points.
    #[error("a Bézier curve needs at least one control point")]
    NoControlPoint,
    #[error("the control point with index {0} must be finite")]
    ControlPointNotFinite(usize),
    #[error("a curve needs at least two points")]
    CurveTooShort,
    #[error("a spline needs at least two points")]
    SplineTooShort,
    #[error("{points} points need as many knots, not {knots}")]
    KnotCount { points: usize, knots: usize },
    #[error("the point with index {0} must be finite")]
    PointNotFinite(usize),
    #[error("the knot with index {0} must be finite")]
    KnotNotFinite(usize),
    #[error("the knot with index {0} must be greater than the one before it")]
    KnotOrder(usize),
    #[error("an end slope must be finite")]
    EndSlope,
    #[error("an end tangent must be finite")]
    EndTangent,
    #[error("a periodic spline must end where it starts")]
    PeriodicEnds,
    #[error("the times must be finite and each later than the one before")]
    TimeOrder,
    #[error("the times are too far apart or too unequal to compute with")]
    TimesUnequal,
    #[error("the error bound of a drawn curve must be positive and finite")]
    DrawnBound,
    #[error("a drawn curve must be finite")]
    DrawnNotFinite,

    // Nodes.
    #[error("it needs a name")]
    NoName,
    #[error("there is a node \"{0}\" already")]
    NodeTwice(Text),
    #[error("there is no node \"{0}\"")]
    NoNodeNamed(Text),
    #[error("\"{node}\" is {} and stays one", WithArticle(kind))]
    KindStays { node: Text, kind: &'static str },
    #[error("\"{0}\" is no object")]
    NoObject(Text),
    #[error("\"{0}\" is no camera")]
    NotACamera(Text),
    #[error("lights and cameras have their pivot at 0, 0, 0")]
    Pivot,
    #[error("only lights and cameras aim at something")]
    CannotAim,
    #[error("it cannot aim at itself")]
    AimsAtItself,
    #[error("it cannot be in itself")]
    InItself,
    #[error("node \"{node}\" cannot be in \"{parent}\", which is in it or moves with it")]
    ParentMovesWithIt { node: Text, parent: Text },
    #[error("node \"{node}\" cannot aim at what is in \"{parent}\", which moves with it")]
    AimMovesWithIt { node: Text, parent: Text },
    #[error("\"{0}\" moves in its parent's coordinates, which are not those of the other parent")]
    MovesInParent(Text),
    #[error("\"{0}\" would need a shear to stay where it is in that parent")]
    NeedsShear(Text),
    #[error("\"{0}\" cannot stay where it is: a scale is 0")]
    ScaleZero(Text),
    #[error("its place is too far away or too large to be computed")]
    PlaceTooFar,
    #[error("there is no marker \"{0}\"")]
    NoMarker(Text),
    #[error("its marker must come after that of the pin before")]
    PinsTurnBack,
    #[error("a path holds, repeats or goes back and forth; it has no repeat with offset")]
    PathWithOffset,

    #[error("the last frame must not lie before the first")]
    RangeEnds,

    // Channels, tracks.
    #[error("there is no channel \"{}\"; known: {}", .0, List(Channel::names(None)))]
    NoChannel(Text),
    #[error(
        "{} has no channel \"{channel}\"; it can have: {}",
        WithArticle(kind),
        List(Channel::names(Some(kind)))
    )]
    NoChannelOfKind { kind: &'static str, channel: Text },
    #[error("an object without shapes has no channel \"weights\"")]
    NoShapes,
    #[error("the deformation \"{deformation}\" has no \"{parameter}\"; it has: {}", List(parameters.iter().map(|known| known.0)))]
    NoParameter {
        deformation: &'static str,
        parameter: Text,
        parameters: &'static [(&'static str, usize, usize)],
    },
    #[error("\"{node}\" has no channel \"{channel}\"")]
    NoChannelOfNode { node: Text, channel: Text },
    #[error("a channel of the host's own needs a name: value:NAME")]
    ChannelWithoutName,
    #[error("\"{node}\" has a track of its {channel}; it moves by keys or by a path")]
    KeysMoveIt { node: Text, channel: Text },
    #[error("\"{node}\" follows a path, which moves its {channel}")]
    PathMovesIt { node: Text, channel: Text },
    #[error("this was given further up already")]
    GivenTwice,
    #[error("a track needs a key")]
    NoKey,
    #[error("its frame must lie behind that of the key before")]
    KeyOrder,
    #[error("what is either 0 or 1 cannot repeat with offset")]
    SwitchWithOffset,
    #[error("there is no interpolation \"{}\"; known: {}", .0, List(Interpolation::names(None)))]
    NoInterpolation(Text),
    #[error(
        "it cannot be interpolated by \"{by}\"; it can by: {}",
        List(Interpolation::names(Some(channel)))
    )]
    NotInterpolated { channel: Channel, by: Text },
    #[error("an interpolation of the host's own needs a name")]
    InterpolationWithoutName,
    #[error("channel \"{channel}\": no interpolation \"host:{name}\" is registered")]
    NotRegistered { channel: Text, name: Text },
    #[error("channel \"{channel}\": the interpolation \"host:{name}\" failed")]
    InterpolationFailed { channel: Text, name: Text },
    #[error(
        "channel \"{channel}\": the interpolation \"host:{name}\" gave a number that cannot be used"
    )]
    InterpolationGave { channel: Text, name: Text },

    // Objects, deformations.
    #[error("this mesh has {given} points, the object's shapes have {wanted}")]
    MeshOfShapes { given: usize, wanted: usize },
    #[error("a weight must be a finite number up to 1e9")]
    Weight,
    #[error("there is no deformation \"{0}\"; known: taper, twist, bend, free-form")]
    NoDeformation(Text),
    #[error("a bend needs two different axes")]
    BendAxes,
    #[error("the box must not end before it begins")]
    BoxEnds,

    // Tools.
    #[error("{0} must be a finite number")]
    NumberNotFinite(&'static str),
    #[error("there is no move \"{name}\"; known: {known}")]
    NoMove { name: Text, known: &'static str },
    #[error("the limit \"{0}\" must be greater than 0")]
    PaceLimit(&'static str),
    #[error(
        "a pace needs a limit: speed, acceleration, jerk, turning, turning-acceleration, zoom or \
         crossing"
    )]
    NoPaceLimit,
    #[error(
        "from point {}, view {}, at {share:.3} of the way, the pace would have to rest where curve or \
         view have a kink ({limit}): put a point there or smooth it",
        Index(*.point), Index(*.orientation)
    )]
    PaceRests {
        point: usize,
        orientation: usize,
        share: f64,
        limit: &'static str,
    },
    #[error(
        "from point {}, view {}, no pace of at most {} keys holds the limit \"{limit}\": put a point \
         between",
        Index(*.point), Index(*.orientation), crate::limits::MAX_DISTANCE_KEYS
    )]
    PaceKeys {
        point: usize,
        orientation: usize,
        limit: &'static str,
    },
    #[error("{seconds} s are too short: the limits allow it in {least:.3} s")]
    PaceSeconds { seconds: f64, least: f64 },
    #[error("the seconds of a pace must be 0 or a positive number")]
    PaceTime,
    #[error("no point is selected")]
    NothingSelected,
    #[error("the same axis must stand upright in both paths")]
    UprightDiffers,
    #[error(
        "up by \"frenet\" needs a curve of kind cubic whose points own no tangents, else its \
         normal would jump; \"minimal\" goes on any curve"
    )]
    NoNormal,
    #[error(
        "the up \"{0}\" of an orientation cannot go along where another axis is to stand upright; \
         choose \"axis\" for it before"
    )]
    FixedUp(&'static str),
    #[error("there is no up \"{0}\"; known: axis, point, path, minimal, frenet, y, z")]
    NoUp(Text),
    #[error("each number of a matrix must be finite")]
    MatrixNotFinite,
    #[error("the scale of a matrix must lie between 1e-78 and 1e78, mirrored or not")]
    MatrixScale,
    #[error("the matrix must not press flat: no scale may be less than 1e-12 of another")]
    MatrixFlat,
    #[error("the matrix must move, turn, scale or mirror, without shear")]
    Matrix,
    #[error("path and block need a direction and a length there to be joined")]
    NoDirection,
    #[error("each path needs a weight")]
    PathWeights,
    #[error("closed paths cannot be blended with open ones")]
    ClosedAndOpen,
    #[error("the camera does not move")]
    NoWay,
    #[error("the fit was cancelled")]
    Cancelled,
    #[error("a fit needs at least three poses")]
    TooFewPoses,
    #[error("the times of the poses must increase, one for each")]
    PoseTimes,
    #[error("all poses are the same")]
    SamePoses,
    #[error(
        "the poses do not differ by more than the tolerance: a smaller one makes a path of them"
    )]
    WithinTolerance,
    #[error(
        "{off} of {all} poses are off from what those around them say: too many to leave them out; \
         a larger tolerance, or a fit that follows all poses"
    )]
    Outliers { off: usize, all: usize },
    /// By how many times the tolerance it is missed.
    #[error(
        "no path whose points stand at whole frames passes it within the tolerance (it is \
         missed by {0:.1} times that): a larger tolerance helps, or a robust fit (--robust), \
         which leaves out single poses that are off"
    )]
    PoseMissed(f64),
    #[error(
        "there is no check \"{}\"; known: {}",
        .0, List(FindingKind::all().map(FindingKind::name))
    )]
    NoCheck(Text),
    #[error("the limit of {0} must be a number, or infinite where nothing is to be looked for")]
    LimitNan(&'static str),
    #[error("the object has no geometry")]
    NoGeometry,
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
    #[error("there is no frame {frame}: they go from {first} to {last}")]
    NoFrame { frame: f64, first: f64, last: f64 },
    #[error("a list has at least one pose")]
    NoPose,
    #[error("a section has at most {} frames", limits::MAX_FRAMES)]
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
        "{} must lie within 1e9 half sizes of the world's origin",
        Called("the centre of the space", "centre")
    )]
    Centre,
    #[error("a coordinate must lie within 1e9 half sizes of the space's centre")]
    FarFromCentre,
    #[error(
        "{} must lie between 0 and 1e9 half sizes of the space",
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
    #[error("there is no deformation {at} among {count}, counted from 0")]
    NoDeformation { at: usize, count: usize },
    #[error(
        "the deformation \"{deformation}\" does not take {given} numbers; it takes {}",
        List(crate::deform::counts(deformation))
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
    #[error("the zoom would be {0} at the end; it must lie between 1 and 2000")]
    ZoomAtEnd(f64),
    #[error("the camera must turn by more than 0 degrees")]
    NoTurn,
    #[error("the camera would stay where it is: the move must end elsewhere than it begins")]
    NoWay,
    #[error("there is no next point at which the block could end")]
    NoNextPoint,
    #[error("the weights must sum to 1, not to {0}")]
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
}

/// More of something than [`crate::limits`] allows.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum TooMany {
    #[error("at most {} bytes are allowed", limits::MAX_NAME_BYTES)]
    NameBytes,
    #[error("the comment has at most {} bytes", limits::MAX_COMMENT_BYTES)]
    CommentBytes,
    #[error("a path has at most {} support points", limits::MAX_POINTS)]
    SupportPoints,
    #[error(
        "within this tolerance the poses need more than {} points: with a larger one the path \
         does not follow their noise; or fit fewer poses at once",
        limits::MAX_POINTS
    )]
    FittedPoints,
    #[error("an up path has at most {} points", limits::MAX_UP_PATH_POINTS)]
    UpPathPoints,
    #[error("a path has at most {} different up paths", limits::MAX_UP_PATHS)]
    UpPaths,
    #[error("a point has at most 10 orientations")]
    Orientations,
    #[error(
        "the points of a path have at most {} orientations together",
        limits::MAX_ALL_ORIENTATIONS
    )]
    AllOrientations,
    #[error("the path would yield more than 100000000 frames; lower the base speeds")]
    Frames,
    #[error("the scene has more than {} frames", limits::MAX_FRAMES)]
    SceneFrames,
    #[error("a list cannot number so many poses")]
    Poses,
    #[error(
        "a Bézier curve has at most {} control points",
        limits::MAX_BEZIER_POINTS
    )]
    ControlPoints,
    #[error("a curve has at most {} points", limits::MAX_POINTS)]
    CurvePoints,
    #[error("a spline has at most {} points", limits::MAX_POINTS)]
    SplinePoints,
    #[error("a quaternion curve has at most 1000000 keys")]
    QuaternionKeys,
    #[error("an object has at most {} points", limits::MAX_OBJECT_POINTS)]
    ObjectPoints,
    #[error(
        "the wireframe of an object has at most {} points",
        limits::MAX_OBJECT_POINTS
    )]
    WireframePoints,
    #[error("an object has at most {} points", limits::MAX_MESH_POINTS)]
    MeshPoints,
    #[error(
        "an object has at most {} corners of triangles and as many ends of lines",
        limits::MAX_MESH_CORNERS
    )]
    MeshCorners,
    #[error("an object has at most {} shapes", limits::MAX_SHAPES)]
    Shapes,
    #[error("an object has at most {} deformations", limits::MAX_DEFORMATIONS)]
    Deformations,
    #[error("a scene has at most {} nodes", limits::MAX_NODES)]
    Nodes,
    #[error("a scene has at most {} levels", limits::MAX_LEVELS)]
    Levels,
    #[error("a scene has at most {} markers", limits::MAX_MARKERS)]
    Markers,
    #[error("a scene has at most {} pins", limits::MAX_PINS)]
    Pins,
    #[error("a node has at most {} tracks", limits::MAX_TRACKS)]
    Tracks,
    #[error("a track has at most {} keys", limits::MAX_KEYS)]
    Keys,
    #[error(
        "the keys of a scene have at most {} numbers",
        limits::MAX_SCENE_NUMBERS
    )]
    SceneNumbers,
    #[error(
        "at most {} interpolations can be registered",
        limits::MAX_INTERPOLATIONS
    )]
    Interpolations,
}
