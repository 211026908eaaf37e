//! The engine: from the data of a path to every pose on it, by the rules of `docs/theory/path.md`.
//!
//! [`camera_path`] is the data, [`space`] where it lies. [`curve`] makes cubics of it,
//! [`arc_length`] and [`speed_curve`] give their length and pace, [`timeline`] the sections with
//! their frames; then the curve times are known, and with them `orientation_curve`. [`sampling`]
//! walks through it all: `section_sampler` is one section prepared, `fill` with `tables` and
//! `arcs` gives its poses at any frames, `motion` how the camera moves there. [`plan`] keeps what was computed while a path is edited.
//!
//! [`bezier`], [`hermite`], [`catmull_rom`] and [`cubic_spline`] are the thesis's other curves,
//! [`tessellation`] is for drawing.
//!
//! Nothing here knows of files, editing or C; only [`crate::math`] stands below it.

pub mod ahead;
pub mod alignment;
pub mod ambiguity;
pub mod arc_length;
mod arcs;
pub(crate) mod base_frames;
pub mod bezier;
pub mod builder;
pub mod camera_path;
pub mod catmull_rom;
mod chain;
pub mod change_up;
pub(crate) mod checks;
pub(crate) mod cube;
pub mod cubic_spline;
pub mod curve;
pub(crate) mod dispatch;
pub mod ease;
mod fill;
mod first;
pub mod fit_frames;
mod frenet;
pub mod hermite;
pub mod insertion;
pub mod joint;
pub mod kochanek_bartels;
mod modes;
mod motion;
mod orientation_curve;
pub mod own;
pub(crate) mod own_parts;
pub mod plan;
pub mod pose;
pub mod quaternion_spline;
pub mod rate;
pub mod resample;
mod runs;
pub mod sampling;
mod section;
pub(crate) mod section_sampler;
pub mod space;
pub mod speed_curve;
mod tables;
pub(crate) mod tcb;
pub mod tessellation;
pub mod timeline;
pub mod timing;
mod turning;
mod up;
pub(crate) mod up_path;
pub mod up_vector;
mod ups;
mod whole;

#[cfg(test)]
pub(crate) mod test_support;

pub use ambiguity::{Ambiguity, ambiguity, half_turn};
pub use builder::Builder;
pub use camera_path::{
    BaseFrames, CameraPath, CurveKind, CurveParameters, Orientation, OrientationMode, SupportPoint,
    Target, Tcb, ZoomMode,
};
pub use ease::{Ease, EaseKind};
pub use motion::Motion;
pub use own::{
    OrientationOverrides, Overrides, Pace, PacePart, PaceSource, Tangents, TurningPart, Velocities,
};
pub use plan::Plan;
pub use pose::Pose;
pub use sampling::{Poses, Sampler};
pub use space::{Space, Up};
pub use timeline::{Change, Section, Timeline};
pub use timing::Timing;
pub use up_vector::{UpPath, UpPathPoint, UpVector};
