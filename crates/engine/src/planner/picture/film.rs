//! A path as the planner of pictures sees it: dense places along all sections, with their time.

use glam::DVec3;

use super::outline::Camera;
use crate::error::{Result, vec_with_room};
use crate::path::{CameraPath, Change, OrientationMode, Sampler, Timeline};

/// Samples for each frame of a section that has not many.
const PER_FRAME: usize = 20;

/// Samples of one section, about, beyond which there are fewer for each frame.
const MOST: usize = 8000;

/// One sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    pub camera: Camera,
    pub zoom: f64,
    /// Its frame, from 1.
    pub frame: f64,
    /// Curve time and seconds since the beginning, without holds.
    pub tau: f64,
    pub time: f64,
}

/// A section in which something changes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    /// Its first sample, its key; the last one is before the next one's first.
    pub from: usize,
    pub change: Change,
    /// Point and orientation with which it begins.
    pub point: usize,
    pub orientation: usize,
    pub duration: f64,
    pub frames: usize,
    /// Whether a new point may divide it.
    pub divides: bool,
}

#[derive(Debug)]
pub(super) struct Film {
    pub spots: Vec<Spot>,
    pub pieces: Vec<Piece>,
    pub closed: bool,
}

impl Film {
    pub(super) fn new(path: &CameraPath, fps: f64) -> Result<Self> {
        let timeline = Timeline::new(path)?;
        let sampler = Sampler::new(path, &timeline)?;
        let mut film = Self {
            spots: Vec::new(),
            pieces: vec_with_room(timeline.section_count())?,
            closed: path.closed,
        };
        let (mut tau, mut time) = (0.0, 0.0);
        let mut shares = Vec::new();
        for course in sampler.courses() {
            let (number, frames) = course.number_and_frames();
            let section = timeline.section(number);
            let begin = (sampler.first_frame(number) - 1) as f64;
            let last = path.points[section.point].orientations.len() - 1;
            film.pieces.push(Piece {
                from: film.spots.len(),
                change: section.change,
                point: section.point,
                orientation: section.orientation,
                duration: section.duration(),
                frames,
                divides: section.change == Change::Position
                    && section.orientation == last
                    && path.orientation_mode != OrientationMode::BarryGoldman,
            });
            film.key(&sampler, begin, tau, time)?;
            let timing = timeline.timing(path, number)?;
            let per = (MOST / frames).clamp(1, PER_FRAME);
            let step = frames.div_ceil(MOST);
            let count = (per * frames).div_ceil(step);
            let within = |k: usize| ((k * step) as f64 / per as f64).min(frames as f64);
            shares.clear();
            shares.try_reserve(count + 1)?;
            shares.extend((0..=count).map(|k| timing.fraction(within(k) / frames as f64)));
            film.spots.try_reserve(count + 2)?;
            let spots = &mut film.spots;
            let mut k = 0;
            course.along(&shares, &mut |along| {
                spots.push(Spot {
                    camera: Camera {
                        eye: along.place,
                        view: along.view,
                        up: along.turn * DVec3::Y,
                    },
                    zoom: along.zoom,
                    frame: begin + within(k),
                    tau: tau + shares[k] * section.duration(),
                    time: time + within(k) / fps,
                });
                k += 1;
            })?;
            tau += section.duration();
            time += frames as f64 / fps;
        }
        film.key(&sampler, sampler.frame_count() as f64, tau, time)?;
        Ok(film)
    }

    fn key(&mut self, sampler: &Sampler, frame: f64, tau: f64, time: f64) -> Result<()> {
        let pose = sampler.pose(frame)?;
        self.spots.try_reserve(1)?;
        self.spots.push(Spot {
            camera: Camera::from(&pose),
            zoom: pose.zoom,
            frame,
            tau,
            time,
        });
        Ok(())
    }

    /// The samples of a section; the last key stands behind those of the last one.
    pub(super) fn range(&self, piece: usize) -> std::ops::Range<usize> {
        let end = self.pieces.get(piece + 1).map(|next| next.from);
        self.pieces[piece].from..end.unwrap_or(self.spots.len())
    }

    /// The section of a sample.
    pub(super) fn piece_of(&self, spot: usize) -> usize {
        let after = self.pieces.partition_point(|piece| piece.from <= spot);
        after.saturating_sub(1)
    }
}
