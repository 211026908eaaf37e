//! Sections, frames and poses.

use std::ffi::{c_char, c_int};
use std::io::{self, Write};

use super::border::border;
use super::list;
use super::path::read;
use super::pointers::{ArrayOut, Out, TextOut, check, file_name, index, slice, slice_mut};
use super::status::{Answer, Failure, Name, V_ERR_INTERNAL, V_OK};
use super::types::{V_KAMERAPAR, V_PATH, V_POSE};
use crate::error::EngineError;
use crate::formats;
use crate::path::Pose;

/// ==== Poses: the camera at each frame ====
///
/// Gets the number of sections. A section leads from one orientation to the next, at
/// the same point or at the next one, in the order in which the camera takes them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_section_count(path: *const V_PATH, count: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(count, "count")?;
        let sections = read(path, |document| {
            let sections = document.timeline(|timeline| timeline.section_count())?;
            super::pointers::count(sections)
        })?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(sections) }
    })
}

/// Gets the point and orientation with which a section begins, its first frame, and
/// its number of frames without a hold at its end.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_section_info(
    path: *const V_PATH,
    section: c_int,
    point: *mut c_int,
    orientation: *mut c_int,
    first_frame: *mut usize,
    frames: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (point, orientation) = (
            Out::optional(point, "point")?,
            Out::optional(orientation, "orientation")?,
        );
        let (first_frame, frames) = (
            Out::optional(first_frame, "first_frame")?,
            Out::optional(frames, "frames")?,
        );
        let number = index(section, "section")?;
        let (section, first) = read(path, |document| {
            let found = document.timeline(|timeline| {
                let count = timeline.section_count();
                let missing = Failure::NoSection { at: number, count };
                (number < count)
                    .then(|| timeline.section(number))
                    .ok_or(missing)
            })??;
            Ok((found, document.sampler()?.first_frame(number)))
        })?;
        let from = super::pointers::count(section.point)?;
        let looking = super::pointers::count(section.orientation)?;
        // SAFETY: room for an int and a size_t each, as the header says.
        unsafe {
            point.write(from);
            orientation.write(looking);
            first_frame.write(first);
            frames.write(section.frames);
        }
        Ok(V_OK)
    })
}

/// Gets the number of frames, at least 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_frame_count(path: *const V_PATH, frames: *mut usize) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(frames, "frames")?;
        let frames = read(path, |document| {
            Ok(document.timeline(|timeline| timeline.frame_count())??)
        })?;
        // SAFETY: room for a size_t, as the header says.
        unsafe { out.answer(frames) }
    })
}

/// Writes all poses to your array.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_sample(
    path: *const V_PATH,
    poses: *mut V_POSE,
    capacity: usize,
    count: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = ArrayOut::new(poses.cast::<Pose>(), capacity, count, ["poses", "count"])?;
        read(path, |document| {
            let sampler = document.sampler()?;
            let needed = sampler.frame_count();
            // SAFETY: room for a size_t and `capacity` poses, as the header says; any bits are
            // valid.
            unsafe {
                if out.wants(needed)? {
                    sampler.sample(1, out.room(needed)?)?;
                }
                out.answer(needed)
            }
        })
    })
}

/// Writes count poses of v_path_sample(), from frame first on, to your array.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_sample_range(
    path: *const V_PATH,
    first: usize,
    count: usize,
    poses: *mut V_POSE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        check(poses, "poses")?;
        read(path, |document| {
            let sampler = document.sampler()?;
            let frames = sampler.frame_count();
            let behind = first.checked_add(count);
            if first == 0 || behind.is_none_or(|behind| behind - 1 > frames) {
                return Err(Failure::NoPoses {
                    count,
                    first,
                    frames,
                });
            }
            // SAFETY: room for `count` poses, as the header says; any bits make one.
            sampler.sample(first, unsafe {
                slice_mut(poses.cast::<Pose>(), count, "poses")
            }?)?;
            Ok(V_OK)
        })
    })
}

/// Gets the pose at a frame. At a whole frame it equals that of v_path_sample()
/// exactly.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_pose(path: *const V_PATH, frame: f64, pose: *mut V_POSE) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(pose.cast::<Pose>(), "pose")?;
        let pose = read(path, |document| Ok(document.sampler()?.pose(frame)?))?;
        // SAFETY: room for a pose, as the header says.
        unsafe { out.answer(pose) }
    })
}

/// Gets the poses at count frames, as v_path_pose() does, in any order; ascending ones
/// are fastest. poses must not overlap frames.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_poses_at(
    path: *const V_PATH,
    frames: *const f64,
    count: usize,
    poses: *mut V_POSE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        check(poses, "poses")?;
        // SAFETY: so many doubles, as the header says.
        let frames = unsafe { slice(frames, count, "frames") }?;
        read(path, |document| {
            let sampler = document.sampler()?;
            for (k, &frame) in frames.iter().enumerate() {
                frame_of(frame, sampler.frame_count(), Name::Element("frames", k))?;
            }
            // SAFETY: room for `count` poses beside the frames, as the header says; any bits make one.
            let poses = unsafe { slice_mut(poses.cast::<Pose>(), count, "poses") }?;
            sampler.poses_at(frames, poses)?;
            Ok(V_OK)
        })
    })
}

/// A frame of a path that has so many.
pub(super) fn frame_of(given: f64, frames: usize, name: Name) -> Answer<f64> {
    let failure = Failure::NoFrame {
        name,
        given,
        frames,
    };
    (given >= 1.0 && given <= frames as f64)
        .then_some(given)
        .ok_or(failure)
}

/// Makes a list of all poses, see V_KAMERAPAR. Set the number of first before, to -1
/// if there is no data yet. A list that VIDES made there before is freed when the new
/// one is complete. No other thread may use the list meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_to_list(path: *const V_PATH, first: *mut V_KAMERAPAR) -> c_int {
    border(V_ERR_INTERNAL, || {
        check(first, "first")?;
        read(path, |document| {
            let sampler = document.sampler()?;
            let frames = sampler.frame_count();
            // SAFETY: an element of the host's, as the header says.
            unsafe { list::build(frames, first, |n, poses| sampler.sample(n, poses)) }?;
            Ok(V_OK)
        })
    })
}

/// Writes all poses to a text file, replaced atomically, one line each: VRP, VPN, VUP
/// (x, y and z each) and zoom, as C prints them by "%3.4f", separated by one space.
/// The decimal sign is a point; minus zero is written as zero. Zoom is the path's, 1
/// to 2000: only the list's int ends at 100.
/// V_ERR_IO.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_write_ascii(path: *const V_PATH, file: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a text ended by zero, as the header says.
        let file = unsafe { file_name(file, "file") }?;
        read(path, |document| {
            let sampler = document.sampler()?;
            formats::write_ascii_file(sampler, file)?;
            Ok(V_OK)
        })
    })
}

/// Gets the text that v_path_write_ascii() would write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_write_ascii_to_memory(
    path: *const V_PATH,
    text: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(text, capacity, length, "text")?;
        read(path, |document| {
            let mut lines = Lines(Vec::new());
            formats::write_ascii(document.sampler()?, &mut lines)
                .map_err(|_| EngineError::Memory)?;
            // SAFETY: room as the header says.
            unsafe { out.write(&lines.0) }
        })
    })
}

/// Text in memory; running out of memory is an error.
struct Lines(Vec<u8>);

impl Write for Lines {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.try_reserve(bytes.len())?;
        self.0.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
