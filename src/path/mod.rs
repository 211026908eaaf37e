//! The engine: from the data of a path to every pose on it (SPEC 2). It knows
//! nothing of files, of editing or of C; only [`crate::math`] stands below it.

pub mod arc_length;
pub mod camera_path;
pub mod hermite;
pub mod kochanek_bartels;
pub mod plan;
pub mod pose;
pub mod sampling;
pub mod timeline;

pub use camera_path::{
    BaseSpeeds, CameraPath, CurveParameters, Orientation, OrientationMode, SupportPoint, Target,
    Tcb, ZoomMode,
};
pub use plan::Plan;
pub use pose::Pose;
pub use sampling::Sampler;
pub use timeline::{Change, Section, Timeline};
