//! The causes of errors, one enum for each [`ErrorKind`](super::ErrorKind) of the engine. The
//! sentence above a variant is its documentation, too; the German one is in `texts/german.rs`.

use std::fmt;

use super::counting::{Called, Index};
use super::range::{Bound, Quantity};
use super::text::{List, Text};
use crate::limits;
use crate::scene::channel::Channel;
use crate::scene::interpolation::Interpolation;
use crate::tools::kinds::FindingKind;

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
    #[error(
        "\"{0}\" follows a path, which keeps its way only where both parents rest: let it move by keys first"
    )]
    WayOfPath(Text),
    #[error(
        "\"{0}\" would not fly the same along a path in that parent: let it move by keys first"
    )]
    PathFliesOtherwise(Text),
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
    #[error("\"{node}\" has no keys of \"{channel}\"")]
    NoTrack { node: Text, channel: Text },
    #[error("keys of \"{given}\" do not fit the channel \"{channel}\"")]
    NotThatChannel { channel: Text, given: Text },
    #[error("keys must be named in the order of their frames, each once")]
    KeysOutOfOrder,
    #[error("the keys of \"{channel}\" must go first")]
    HasTrack { channel: Text },
    #[error("\"{0}\" follows no path")]
    NoPathOf(Text),
    #[error("there is already a marker \"{0}\"")]
    MarkerTwice(Text),
    #[error("points are pinned to the marker \"{0}\"")]
    Pinned(Text),
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
    #[error("{} s are too short: the limits allow it in {least:.3} s", Bound(*seconds))]
    PaceSeconds { seconds: f64, least: f64 },
    #[error("the seconds of a pace must be 0 or a positive number")]
    PaceTime,
    #[error("a tour needs an object with a surface: triangles that are not all without area")]
    NoSurface,
    #[error("no view of a tour shows anything from such a distance")]
    TourNothing,
    #[error("the start of a tour must be a place that is not within or beside the object")]
    TourStart,
    #[error("there is no free place inside the object from where a tour could show it")]
    NoRoomInside,
    #[error("no way of a tour keeps clear of the object: ask for another distance")]
    TourWay,
    #[error(
        "the clearance must be greater than 0, the radius 0 or greater, both together at most {0}"
    )]
    AvoidClearance(f64),
    #[error(
        "at frame {frame:.0}, at ({x:.4}, {y:.4}, {z:.4}), there is no way round the object that keeps \
         {need} from it"
    )]
    NoWayRound {
        frame: f64,
        x: f64,
        y: f64,
        z: f64,
        need: f64,
    },
    #[error("the margin of a picture must be at least 0 and less than 0.5")]
    PictureMargin,
    #[error(
        "at frame {frame:.2} not all of the object is before the camera, so that no zoom shows it \
         whole"
    )]
    PictureBehind { frame: f64 },
    #[error(
        "at frame {frame:.2} the object would be whole with a zoom of {zoom:.3} mm, below the least, \
         1 mm"
    )]
    PictureZoom { frame: f64, zoom: f64 },
    #[error(
        "from here the object would be whole with a zoom of {zoom:.3} mm only, below the least, 1 mm"
    )]
    PictureHere { zoom: f64 },
    #[error(
        "at frame {frame:.2} the object is too large for the picture, wherever the camera turns"
    )]
    PictureLarge { frame: f64 },
    #[error("the object is a single place, which is as large from any distance")]
    PicturePlace,
    #[error(
        "around frame {frame:.2} no keys keep the object in the picture: put a point there, or give \
         the section more frames"
    )]
    PictureKeys { frame: f64 },
    #[error("no point is selected")]
    NothingSelected,
    #[error("both paths must have the same up axis")]
    UprightDiffers,
    #[error(
        "up by \"frenet\" needs a curve of kind cubic whose points own no tangents, else its \
         normal would jump; \"minimal\" goes on any curve"
    )]
    NoNormal,
    #[error(
        "the up \"{0}\" of an orientation cannot be kept with another up axis; \
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
    /// The bound.
    #[error("no steady path of whole frames was found within {0} of the flight")]
    SteadyBound(f64),
    #[error("it was cancelled")]
    Cancelled,
    #[error("a fit needs at least two poses")]
    TooFewPoses,
    #[error("each pose needs a time, and times must not run backwards")]
    PoseTimes,
    #[error(
        "{off} of {all} poses are off from what those around them say: too many to leave them out; \
         a larger tolerance, or a fit that follows all poses"
    )]
    Outliers { off: usize, all: usize },
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
    #[error(
        "the path would have more than 100000000 frames: lower its base speeds or the frames of its \
         sections"
    )]
    Frames,
    /// The limit.
    #[error("the scene has more than {0} frames")]
    SceneFrames(usize),
    /// So many there are.
    #[error("at most {most} frames can be fitted, this has {0}", most = limits::MAX_SAMPLED_FRAMES)]
    SampledFrames(usize),
    /// The frames from the first pose to the last.
    #[error(
        "the times of the poses span {0:.0} frames, at most {max} are allowed: check their unit, \
         times are seconds",
        max = limits::MAX_FRAMES
    )]
    PoseSpan(f64),
    #[error("too many poses for a list")]
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
