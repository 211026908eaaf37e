//! What a format cannot hold, or what a file holds that is not taken.

use std::fmt;

use vides_document::error::{Index, Text};
use vides_engine::limits::MAX_FPS;

use super::options::DEFAULT_SIZE;

/// Something that is lost on the way, or worth a word.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs)]
pub enum Loss {
    /// Nodes of which the format knows nothing.
    OtherNodes(usize),
    /// Cameras beside the one that is written or read.
    OtherCameras(usize),
    /// The object that is shown with the path.
    Object,
    /// Points, speeds, holds: a path goes out as its poses.
    Path,
    /// Cameras and lights that aim: they go out turned, frame by frame.
    Aims(usize),
    /// Tracks whose interpolation the format lacks go out as a key a frame.
    Interpolations(usize),
    /// Deformed objects go out at rest.
    Deformations(usize),
    /// Nodes whose motion was resampled, a key a frame, since no track can express it.
    Resampled(usize),
    /// Deformed or morphed objects go out as their points, frame by frame where these move.
    Forms(usize),
    /// Cameras and lights in nodes that scale go out at the top, a pose a frame.
    Scaled(usize),
    /// Channels of the host.
    HostChannels(usize),
    /// The camera's roll; in how many poses.
    Roll(usize),
    /// The field of view, in a format without one.
    FieldOfView,
    /// Fields of view beyond the range, clamped.
    FieldsClamped(usize),
    /// Times, in a format without: a pose a frame.
    Times,
    /// Lens distortion; of how many cameras.
    Distortion(usize),
    /// Principal points off the picture's centre.
    OffCentre(usize),
    /// Skinned meshes, taken at rest.
    Skins(usize),
    /// Places that shear, taken without.
    Sheared(usize),
    /// Animations that are left out, by their names.
    OtherAnimations(Text),
    /// What cannot be read, and why.
    LeftOut(Text),
    /// Models beside the one that is read, by its name and as it has the most images.
    OtherModels {
        read: Text,
        images: u64,
        others: usize,
    },
    /// The program has no frames of these numbers, only 0 to `last`: they are counted from 1.
    FrameNumbers { first: f64, last: f64 },
    /// The viewer joins the keys by its own spline.
    OwnSpline,
    /// A path was fitted: points, the farthest position, the largest angle in degrees.
    Fitted {
        points: usize,
        off: f64,
        turned: f64,
    },
    /// Seconds that are not those of their frames, which count: the pose (from 0) and both.
    Seconds {
        pose: usize,
        seconds: f64,
        by_frame: f64,
    },
    /// The file has this up axis, and the document another one.
    Upright(&'static str),
    /// Poses at the same time as the one before, which counts.
    RepeatedTimes(usize),
    /// The times begin at this second, and count from 0 here.
    Epoch(f64),
    /// Keyframes of a file whose frames are read in their place.
    Keyframes(usize),
    /// Times too great for seconds, by what they count.
    TimeUnit(&'static str),
    /// Rates beyond the range.
    Rates(usize),
    /// Everything is far away: roots are in a node there.
    Origin([f64; 3]),
    /// Markers.
    Markers(usize),
    /// Colours of points.
    PointColours,
    /// Tracks of colours.
    ColourTracks(usize),
    /// Textures.
    Textures(usize),
    /// Cameras without perspective, taken as with it.
    Orthographic(usize),
    /// Pictures of unknown size, taken as square.
    SquarePictures,
    /// Pictures of unknown size, taken as of the size without a word.
    UnknownSize,
    /// The poses are in a world that another one was transformed into.
    AppliedTransform,
    /// The poses are in a world whose lengths are those of the capture by this factor.
    NormalisedWorld(f64),
    /// Pictures whose pixels are not square: the height counts.
    Oblong(usize),
    /// Scenes beside the first.
    OtherScenes(usize),
    /// Tracks of properties that nodes here do not have.
    OtherTracks(usize),
    /// Sizes of nodes whose matrices scale; in how many frames.
    Sizes(usize),
    /// Anything else that is not taken, by its name in the file.
    NotTaken { what: Text, count: usize },
}

impl fmt::Display for Loss {
    #[expect(clippy::too_many_lines)] // a sentence each
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OtherNodes(n) => counted(f, *n, "other node% left out"),
            Self::OtherCameras(n) => counted(f, *n, "other camera% left out"),
            Self::Object => f.write_str("the object is left out"),
            Self::Path => f.write_str("points, speeds and holds become poses, one a frame"),
            Self::Aims(n) => counted(f, *n, "aim% turned into rotations, one a frame"),
            Self::Interpolations(n) => {
                let what =
                    "track% of an interpolation that the format lacks turned into a key a frame";
                counted(f, *n, what)
            }
            Self::Deformations(n) => counted(f, *n, "deformed object% as at rest"),
            Self::Resampled(n) => {
                let s = plural(*n);
                write!(
                    f,
                    "the motion of {n} node{s} is computed anew, a key a frame"
                )
            }
            Self::Forms(n) => {
                let what = "deformed or morphed object% as points, frame by frame where they move";
                counted(f, *n, what)
            }
            Self::Scaled(1) => {
                f.write_str("1 camera or light in scaled nodes stands at the top, a pose a frame")
            }
            Self::Scaled(n) => {
                let what = "camera% or light% in scaled nodes stand at the top, a pose a frame";
                counted(f, *n, what)
            }
            Self::HostChannels(n) => counted(f, *n, "channel% of the host left out"),
            Self::Roll(n) => write!(f, "roll is left out, in {n} pose{}", plural(*n)),
            Self::FieldOfView => f.write_str("the field of view is left out"),
            Self::FieldsClamped(n) => counted(
                f,
                *n,
                "field% of view beyond 0.69 to 170.5 degrees, clamped",
            ),
            Self::Times => f.write_str("there are no times: a pose is a frame"),
            Self::Distortion(n) => {
                write!(f, "the distortion of {n} camera{} is left out", plural(*n))
            }
            Self::OffCentre(n) => counted(
                f,
                *n,
                "picture% whose axis is off the centre: taken as in it",
            ),
            Self::Skins(1) => f.write_str("1 skinned mesh as at rest"),
            Self::Skins(n) => write!(f, "{n} skinned meshes as at rest"),
            Self::Sheared(n) => counted(f, *n, "node% without their shear"),
            Self::LeftOut(what) => write!(f, "left out: {what}"),
            Self::OtherAnimations(all) => write!(f, "animations left out (option clip): {all}"),
            Self::OtherModels {
                read,
                images,
                others,
            } => write!(
                f,
                "{others} other model{} left out: {read} has the most images ({images})",
                plural(*others)
            ),
            Self::FrameNumbers { first, last } => write!(
                f,
                "the first frame is 1 and not {first}: its frames are whole numbers from 0 to {last}"
            ),
            Self::OwnSpline => f.write_str("its viewer joins the keys by a spline of its own"),
            Self::Fitted {
                points,
                off,
                turned,
            } => write!(
                f,
                "a path of {points} points, at most {off:.3e} and {turned:.3} degrees from the poses"
            ),
            Self::Seconds {
                pose,
                seconds,
                by_frame,
            } => write!(
                f,
                "the times are those of the frames; by the seconds pose {} would be at {seconds} s, \
                 by its frame it is at {by_frame} s",
                Index(*pose)
            ),
            Self::Upright(axis) => {
                write!(f, "the file has {axis} upright, and this document has not")
            }
            Self::Epoch(start) => {
                write!(f, "the times begin at {start} s: they count from 0 here")
            }
            Self::TimeUnit(unit) => {
                write!(f, "times beyond 1e11 are no seconds: they count {unit}")
            }
            Self::RepeatedTimes(n) => counted(f, *n, "pose% at the time of another left out"),
            Self::Keyframes(n) => {
                let what = "keyframe% left out, since the frames are fitted: import the file \
                            (\"vides convert\") to make the keyframes points of a path";
                counted(f, *n, what)
            }
            Self::Rates(n) => write!(f, "{n} rate{} beyond 0 to {MAX_FPS} left out", plural(*n)),
            Self::Origin([x, y, z]) => write!(
                f,
                "far from the origin for 32 bits: all nodes are in a node \"origin\" at {x} {y} {z}"
            ),
            Self::Markers(n) => counted(f, *n, "marker% left out"),
            Self::PointColours => f.write_str("the colours of points are left out"),
            Self::ColourTracks(n) => counted(f, *n, "changing colour% as at the first frame"),
            Self::Textures(n) => counted(f, *n, "texture% left out"),
            Self::Orthographic(n) => {
                counted(f, *n, "camera% without perspective, taken as with it")
            }
            Self::SquarePictures => {
                f.write_str("the size of the pictures is unknown: taken as square (option size)")
            }
            Self::UnknownSize => {
                let [width, height] = DEFAULT_SIZE;
                write!(
                    f,
                    "the size of the pictures is unknown: taken as {width}x{height} (option size)"
                )
            }
            Self::AppliedTransform => f.write_str(
                "the poses are in the world after applied_transform: multiply objects from the \
                 world of the capture by this matrix to make them fit",
            ),
            Self::NormalisedWorld(scale) => write!(
                f,
                "the poses are in nerfstudio's world: multiply objects of the capture by \"transform\" \
                 in dataparser_transforms.json, then by {scale}; those of \"ns-export\" fit as they are"
            ),
            Self::Oblong(n) => write!(
                f,
                "the width of {n} picture{} whose pixels are not square: their height counts",
                plural(*n)
            ),
            Self::OtherScenes(n) => counted(f, *n, "other scene% left out"),
            Self::OtherTracks(n) => counted(f, *n, "animation% of other properties left out"),
            Self::Sizes(1) => f.write_str("the scale in 1 matrix left out"),
            Self::Sizes(n) => write!(f, "the scale in {n} matrices left out"),
            Self::NotTaken { what, count } => write!(f, "{what} is not taken, {count} of it"),
        }
    }
}

const fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// A number of things; each % is the s of several.
fn counted(f: &mut fmt::Formatter<'_>, count: usize, what: &str) -> fmt::Result {
    write!(f, "{count} {}", what.replace('%', plural(count)))
}

/// The losses of a file that was written or read.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Report {
    pub(super) losses: Vec<Loss>,
}

/// More are not reported one by one.
const MOST: usize = 100;

impl Report {
    /// Reports a loss, once.
    pub fn add(&mut self, loss: Loss) {
        if self.losses.len() < MOST && !self.losses.contains(&loss) {
            self.losses.push(loss);
        }
    }

    /// Reports a loss of `count` items, if any.
    pub fn count(&mut self, count: usize, loss: impl FnOnce(usize) -> Loss) {
        if count > 0 {
            self.add(loss(count));
        }
    }

    /// Reports `count` items of anything else, if any.
    pub fn not_taken(&mut self, what: &str, count: usize) {
        self.count(count, |count| Loss::NotTaken {
            what: what.into(),
            count,
        });
    }

    /// All, in order.
    #[must_use]
    pub fn losses(&self) -> &[Loss] {
        &self.losses
    }
}
