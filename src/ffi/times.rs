//! Frames and seconds, and how the camera moves at a frame.

use std::ffi::c_int;

use super::border::border;
use super::path::read;
use super::pointers::{Growing, GrowingOut, Out};
use super::poses::frame_of;
use super::status::{Answer, Failure, V_ERR_INTERNAL};
use super::types::V_PATH;
use crate::document::Document;

/// The motion of a camera at a frame.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_motion {
    pub size: usize,
    /// along the path since the first frame
    pub distance: f64,
    /// length per second
    pub speed: f64,
    /// degrees per second, rolling included
    pub turning: f64,
    /// 1 / radius; 0 where the camera holds or turns on the spot
    pub curvature: f64,
}

pub type V_MOTION = v_motion;

// SAFETY: `repr(C)` with `size` first; numbers only.
unsafe impl Growing for V_MOTION {
    const NAME: &'static str = "V_MOTION";
    const FIRST: usize = size_of::<V_MOTION>();
}

/// The number of frames of a path, and its frame rate.
fn course(document: &Document) -> Answer<(usize, f64)> {
    let frames = document.timeline(|timeline| timeline.frame_count())??;
    Ok((frames, document.info().fps))
}

/// Gets the frame at a time from 0 to (v_path_frame_count() - 1) / fps: 1 + seconds *
/// fps. For the time of a whole frame from v_path_seconds_at_frame(), it is exactly
/// that frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_frame_at_seconds(
    path: *const V_PATH,
    seconds: f64,
    frame: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(frame, "frame")?;
        let (frames, fps) = read(path, course)?;
        let behind_first = (frames - 1) as f64;
        let end = behind_first / fps;
        if !(0.0..=end).contains(&seconds) {
            return Err(Failure::NotBetween {
                name: "seconds",
                given: seconds,
                from: 0.0,
                end,
            });
        }
        let passed = (seconds * fps).min(behind_first);
        // A rounding error must not miss a whole frame, which v_path_sample() has.
        let whole = passed.round();
        let passed = if whole / fps == seconds {
            whole
        } else {
            passed
        };
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer(1.0 + passed) }
    })
}

/// Gets the time of a frame: (frame - 1) / fps seconds.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_seconds_at_frame(
    path: *const V_PATH,
    frame: f64,
    seconds: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(seconds, "seconds")?;
        let (frames, fps) = read(path, course)?;
        let frame = frame_of(frame, frames, "frame".into())?;
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer((frame - 1.0) / fps) }
    })
}

/// Gets the motion of the camera at a frame; at a key, that after the key.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_motion(
    path: *const V_PATH,
    frame: f64,
    motion: *mut V_MOTION,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a struct as its size says, as the header demands.
        let out = unsafe { GrowingOut::new(motion, "motion") }?;
        let (found, fps) = read(path, |document| {
            let sampler = document.sampler()?;
            let frame = frame_of(frame, sampler.frame_count(), "frame".into())?;
            Ok((sampler.motion(frame)?, document.info().fps))
        })?;
        let motion = V_MOTION {
            size: size_of::<V_MOTION>(),
            distance: found.distance,
            speed: found.speed * fps,
            turning: (found.turning * fps).to_degrees(),
            curvature: found.curvature,
        };
        // SAFETY: as above.
        unsafe { out.answer(motion) }
    })
}
