//! What the engine says, in German: the values of each variant of its errors.

use std::fmt;

use vides_document::error::{
    Bound, EngineError, Index, Invalid, List, OutOfRange, Place, Quantity, TooMany,
};
use vides_engine::deform::counts;
use vides_engine::limits;
use vides_engine::scene::{Channel, Interpolation};
use vides_engine::tools::check::FindingKind;

use super::{Language, fill};

/// A text of the library in German.
pub(crate) struct German<'a, T>(pub(crate) &'a T);

/// The values of each variant of an enum, which stand in its text; the compiler sees that no variant
/// is forgotten, a test that each has its text.
macro_rules! german {
    ($list:ident $part:literal:
     $($of:ident {$($variant:ident $(($($at:ident),+))? $({ $($name:ident),+ })?
        $(=> $($value:expr),+)?;)+})+) => {
        /// Part and name of each text, and the number of its values.
        #[cfg(test)]
        pub(super) const $list: &[(&str, &str, usize)] = &[$($((
            $part,
            concat!(stringify!($of), ".", stringify!($variant)),
            <[&str]>::len(&[$($(stringify!($value)),+)?]),
        ),)+)+];

        $(impl std::fmt::Display for German<'_, $of> {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self.0 {$(
                    $of::$variant $(($($at),+))? $({ $($name),+ })? => $crate::texts::german::say(
                        f,
                        $part,
                        concat!(stringify!($of), ".", stringify!($variant)),
                        &[$($(&$value),+)?],
                    ),
                )+}
            }
        })+
    };
}
pub(super) use german;

/// Writes a text of the catalogue.
pub(super) fn say(
    f: &mut fmt::Formatter<'_>,
    part: &str,
    name: &'static str,
    values: &[&dyn fmt::Display],
) -> fmt::Result {
    let [text] = Language::German.catalogue().texts(part, [name]);
    f.write_str(&fill(text, values))
}

pub(super) fn number(number: f64) -> String {
    Language::German.written(Bound(number).to_string())
}

german! {
    ENGINE "engine":
    EngineError {
        Argument(cause) => German(cause);
        Range(cause) => German(cause);
        Limit(cause) => German(cause);
        Memory;
        At(place, cause) => German(place), German::<EngineError>(cause);
    }
    Place {
        Point(at) => Index(*at);
        Orientation(at) => Index(*at);
        ObjectPoint(at) => Index(*at);
        Node(name) => name;
        Channel(name) => name;
        Key(at) => Index(*at);
        Marker;
        Parent;
        Aim;
        Name;
        Title;
        Unit;
        Position;
        Scale;
        Pivot;
        Step;
        Tangents;
        Pose(at) => Index(*at);
    }
    Quantity {
        AimWeight;
        Bias;
        Continuity;
        Coordinate;
        CurveSpeed;
        DistanceAhead;
        Frame;
        Intensity;
        Parameter;
        Rate;
        Roll;
        Tension;
        Times;
        Value;
        Zoom;
    }
    Invalid {
        NotFinite(what) => German(what);
        ControlCharacter;
        TargetOnCamera;
        BaseSpeed;
        DistanceNotFinite;
        ControlNotUnit;
        NoNewKey;
        CentreNotFinite;
        NoSize;
        ViewNotFinite;
        NormalZero;
        ViewUpZero;
        ViewUpParallel;
        LookNotFinite;
        LookZero;
        UpParallel;
        RotationAxis;
        RotationNotFinite;
        RotationZero;
        QuaternionZero;
        NoControlPoint;
        ControlPointNotFinite(at) => at;
        CurveTooShort;
        SplineTooShort;
        KnotCount { points, knots } => points, knots;
        PointNotFinite(at) => at;
        KnotNotFinite(at) => at;
        KnotOrder(at) => at;
        EndSlope;
        EndTangent;
        PeriodicEnds;
        TimeOrder;
        TimesUnequal;
        DrawnBound;
        DrawnNotFinite;
        NoName;
        NodeTwice(name) => name;
        NoNodeNamed(name) => name;
        KindStays { node, kind } => node, kind;
        NoObject(name) => name;
        NotACamera(name) => name;
        Pivot;
        CannotAim;
        AimsAtItself;
        InItself;
        ParentMovesWithIt { node, parent } => node, parent;
        AimMovesWithIt { node, parent } => node, parent;
        MovesInParent(name) => name;
        NeedsShear(name) => name;
        WayOfPath(name) => name;
        PathFliesOtherwise(name) => name;
        ScaleZero(name) => name;
        PlaceTooFar;
        NoMarker(name) => name;
        PinsTurnBack;
        PathWithOffset;
        RangeEnds;
        NoChannel(name) => name, List(Channel::names(None));
        NoChannelOfKind { kind, channel } => kind, channel, List(Channel::names(Some(kind)));
        NoShapes;
        NoParameter { deformation, parameter, parameters } => deformation, parameter, List(parameters.iter().map(|known| known.0));
        NoChannelOfNode { node, channel } => node, channel;
        ChannelWithoutName;
        KeysMoveIt { node, channel } => node, channel;
        PathMovesIt { node, channel } => node, channel;
        GivenTwice;
        NoKey;
        NoTrack { node, channel } => node, channel;
        NotThatChannel { channel, given } => given, channel;
        KeysOutOfOrder;
        HasTrack { channel } => channel;
        NoPathOf(node) => node;
        MarkerTwice(name) => name;
        Pinned(marker) => marker;
        KeyOrder;
        SwitchWithOffset;
        NoInterpolation(name) => name, List(Interpolation::names(None));
        NotInterpolated { channel, by } => by, List(Interpolation::names(Some(channel)));
        InterpolationWithoutName;
        NotRegistered { channel, name } => channel, name;
        InterpolationFailed { channel, name } => channel, name;
        InterpolationGave { channel, name } => channel, name;
        MeshOfShapes { given, wanted } => given, wanted;
        Weight;
        NoDeformation(name) => name;
        BendAxes;
        BoxEnds;
        NumberNotFinite(name) => name;
        NoMove { name, known } => name, known;
        PaceLimit(limit) => limit;
        NoPaceLimit;
        PaceRests { point, orientation, share, limit } => Index(*point), Index(*orientation), number(*share), limit;
        PaceKeys { point, orientation, limit } => Index(*point), Index(*orientation), limit;
        PaceSeconds { seconds, least } => number(*seconds), number(*least);
        PaceTime;
        NoSurface;
        TourNothing;
        TourStart;
        NoRoomInside;
        TourWay;
        AvoidClearance(most) => number(*most);
        NoWayRound { frame, x, y, z, need } => number(*frame), number(*x), number(*y), number(*z), number(*need);
        PictureMargin;
        PictureBehind { frame } => number(*frame);
        PictureZoom { frame, zoom } => number(*frame), number(*zoom);
        PictureHere { zoom } => number(*zoom);
        PictureLarge { frame } => number(*frame);
        PicturePlace;
        PictureKeys { frame } => number(*frame);
        NothingSelected;
        UprightDiffers;
        NoNormal;
        FixedUp(name) => name;
        NoUp(name) => name;
        MatrixNotFinite;
        MatrixScale;
        MatrixFlat;
        Matrix;
        NoDirection;
        PathWeights;
        ClosedAndOpen;
        NoWay;
        SteadyBound(within) => within;
        Cancelled;
        TooFewPoses;
        PoseTimes;
        Outliers { off, all } => off, all;
        NoCheck(name) => name, List(FindingKind::all().map(FindingKind::name));
        LimitNan(name) => name;
        NoGeometry;
    }
    OutOfRange {
        Between(what, low, high) => German(what), number(*low), number(*high);
        Exceeds(what, most) => German(what), number(*most);
        TooFewSupportPoints;
        NoPoint { point, last } => Index(*point), Index(*last);
        NoPreset(preset) => preset;
        Orientations;
        Hold;
        NoFrame { frame, first, last } => number(*frame), number(*first), number(*last);
        NoPose;
        SectionFrames => limits::MAX_SECTION_FRAMES;
        DistanceKeys => limits::MAX_DISTANCE_KEYS;
        DistanceOrder;
        EaseShares;
        Part;
        PointOrder { first, last } => Index(*first), Index(*last);
        TooFewFrames { frames, least } => frames, least;
        TooManyFrames { frames, most } => frames, most;
        AtKey(frame) => number(*frame);
        FewerFrames(point) => Index(*point);
        Turning { frame, point } => number(*frame), Index(*point);
        NearPoint;
        HalfSize;
        Centre;
        FarFromCentre;
        DistanceAhead;
        Fps;
        ViewZoom;
        PictureHeight;
        FieldOfView;
        ViewAspect;
        FrontPlane;
        BackPlane;
        ViewWindow;
        ViewPlanes;
        ReferenceBehindFront;
        ReferenceInViewPlane;
        ViewNumbers;
        CameraTooFar;
        KnotDistance(at) => at, at + 1;
        QuaternionKeys;
        Time;
        KeyShapes;
        NoNode { node, count } => count, node;
        NoLink { node, number, count, link } => node, count, number, link;
        NoPathPoint { node, point, count } => node, count, point;
        States { nodes, given } => nodes, given;
        Colour;
        Cone;
        CameraPlanes;
        ChannelWidth => limits::MAX_CHANNEL_WIDTH;
        TrackWidth { channel, wanted, given } => channel, wanted, given;
        KeyNumbers { keys, numbers } => keys, numbers;
        KeyWidth { wanted, given } => wanted, given;
        KeyShapeNumbers { interpolation, wanted, keys, given } => interpolation, wanted, keys, given;
        KeyDistance;
        ChannelValue;
        Tangent => limits::MAX_TANGENT;
        NoMeshPoint { corner, point, count } => corner, count, point;
        MeshColours { points, given } => points, given;
        PointRoom { points, given } => points, given;
        ShapePoints { shape, given, wanted } => shape, given, wanted;
        ShapeWeights { shapes, given } => shapes, given;
        NoShape { at, count } => count, at;
        NoKeyThere { key, count } => count, Index(0), Index(*key);
        NoDeformation { at, count } => count, at;
        DeformationNumbers { deformation, given } => deformation, given, List(counts(deformation));
        DeformationAxis;
        NumberBetween(name, low, high) => name, number(*low), number(*high);
        NumbersGiven { given, most } => given, most;
        ZoomAtEnd(zoom) => number(*zoom);
        NoTurn;
        NoWay;
        NoNextPoint;
        WeightSum(sum) => number(*sum);
        Tolerance;
        SteadyPeriod(most) => most;
        SteadyWithin;
        TooFewFittedPoints;
        ToleranceAngle;
        Coverage;
        TourDistance => number(limits::TOUR_DISTANCES[0]), number(limits::TOUR_DISTANCES[1]);
    }
    TooMany {
        NameBytes => limits::MAX_NAME_BYTES;
        CommentBytes => limits::MAX_COMMENT_BYTES;
        FittedPoints => limits::MAX_POINTS;
        UpPathPoints => limits::MAX_UP_PATH_POINTS;
        UpPaths => limits::MAX_UP_PATHS;
        SupportPoints => limits::MAX_POINTS;
        Orientations;
        AllOrientations => limits::MAX_ALL_ORIENTATIONS;
        Frames;
        SceneFrames(most) => most;
        SampledFrames(frames) => limits::MAX_SAMPLED_FRAMES, frames;
        PoseSpan(frames) => format!("{frames:.0}"), limits::MAX_FRAMES;
        Poses;
        ControlPoints => limits::MAX_BEZIER_POINTS;
        CurvePoints => limits::MAX_POINTS;
        SplinePoints => limits::MAX_POINTS;
        QuaternionKeys;
        ObjectPoints => limits::MAX_OBJECT_POINTS;
        WireframePoints => limits::MAX_OBJECT_POINTS;
        MeshPoints => limits::MAX_MESH_POINTS;
        MeshCorners => limits::MAX_MESH_CORNERS;
        Shapes => limits::MAX_SHAPES;
        Deformations => limits::MAX_DEFORMATIONS;
        Nodes => limits::MAX_NODES;
        Levels => limits::MAX_LEVELS;
        Markers => limits::MAX_MARKERS;
        Pins => limits::MAX_PINS;
        Tracks => limits::MAX_TRACKS;
        Keys => limits::MAX_KEYS;
        SceneNumbers => limits::MAX_SCENE_NUMBERS;
        Interpolations => limits::MAX_INTERPOLATIONS;
    }
}
