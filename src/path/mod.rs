//! The engine: from the data of a path to every pose on it (SPEC 2). It knows
//! nothing of files, of editing or of C; only [`crate::math`] stands below it.

pub mod arc_length;
mod arcs;
pub mod bezier;
pub mod camera_path;
pub mod catmull_rom;
pub mod cubic_spline;
mod fill;
pub mod hermite;
pub mod kochanek_bartels;
mod leg;
mod orientation_curve;
pub mod plan;
pub mod pose;
pub mod quaternion_spline;
pub mod sampling;
pub mod speed_curve;
mod tables;
pub mod tessellation;
pub mod timeline;

#[cfg(test)]
mod test_support;

pub use camera_path::{
    BaseSpeeds, CameraPath, CurveParameters, Orientation, OrientationMode, SupportPoint, Target,
    Tcb, ZoomMode,
};
pub use plan::Plan;
pub use pose::Pose;
pub use sampling::Sampler;
pub use timeline::{Change, Section, Timeline};
