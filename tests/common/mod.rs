//! What several tests share: random paths, and short ways to make a path and
//! to get its poses.
#![allow(dead_code, missing_docs, unreachable_pub)]

pub mod turning;

use glam::DVec3;
use vides::path::{
    CameraPath, CurveParameters, Orientation, OrientationMode, Pose, Sampler, SupportPoint, Target,
    Tcb, Timeline, ZoomMode,
};

/// A path through these points, with the default orientation at each.
pub fn path_through(positions: &[[f64; 3]]) -> CameraPath {
    let point = |&position| SupportPoint::new(DVec3::from_array(position));
    CameraPath {
        points: positions.iter().map(point).collect(),
        ..CameraPath::default()
    }
}

/// The same shape at every point of a path.
pub fn shaped(mut path: CameraPath, tcb: Tcb) -> CameraPath {
    for point in &mut path.points {
        point.curve = CurveParameters::Own(tcb);
    }
    path
}

pub fn closed(mut path: CameraPath) -> CameraPath {
    path.closed = true;
    path
}

/// All four base speeds of a path.
pub fn set_speeds(path: &mut CameraPath, speed: f64) {
    path.base_frames.movement = speed;
    path.base_frames.turning = speed;
    path.base_frames.rolling = speed;
    path.base_frames.zoom = speed;
}

/// Everything computed of a path that is in order.
pub fn prepared(path: &CameraPath) -> (Timeline, Sampler) {
    path.check().expect("a path in order");
    let timeline = Timeline::new(path).expect("a timeline");
    let sampler = Sampler::new(path, &timeline).expect("a sampler");
    (timeline, sampler)
}

/// All poses, computed many at a time.
pub fn all_poses(sampler: &Sampler) -> Vec<Pose> {
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).expect("all poses");
    poses
}

/// xorshift64*: small, fast, the same everywhere.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
    pub fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n - 1)
    }
    pub fn chance(&mut self, p: f64) -> bool {
        self.unit() < p
    }
    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(
            self.between(-1.0, 1.0),
            self.between(-1.0, 1.0),
            self.between(-1.0, 1.0),
        )
    }
    pub fn tcb(&mut self) -> Tcb {
        let mut value = || match self.below(8) {
            0 => -1.0,
            1 => 1.0,
            2 | 3 => 0.0,
            _ => self.between(-1.0, 1.0),
        };
        Tcb::new(value(), value(), value())
    }
    pub fn orientation(&mut self, position: DVec3) -> Orientation {
        let target = match self.below(10) {
            0 | 1 => Target::Absolute(DVec3::new(0.3, 0.5, -0.2)),
            2 => Target::Absolute(self.vector()),
            3 => Target::Relative(DVec3::new(0.0, 0.0, -0.4)),
            4 => Target::Relative(if self.chance(0.5) {
                DVec3::Y
            } else {
                -DVec3::Y
            }),
            _ => Target::Relative(self.vector()),
        };
        let target = if target.offset_from(position) == DVec3::ZERO {
            Target::Relative(DVec3::X)
        } else {
            target
        };
        Orientation {
            target,
            roll: if self.chance(0.5) {
                0.0
            } else {
                self.between(-179.0, 180.0)
            },
            zoom: if self.chance(0.3) {
                24.0
            } else {
                self.between(1.0, 100.0)
            },
            turning: if self.chance(0.5) {
                Tcb::default()
            } else {
                self.tcb()
            },
            speeds: if self.chance(0.5) {
                [50.0; 10]
            } else {
                let mut speeds = [0.0; 10];
                for speed in &mut speeds {
                    *speed = match self.below(6) {
                        0 => 1.0,
                        1 => 100.0,
                        _ => self.between(1.0, 100.0),
                    };
                }
                speeds
            },
            hold: if self.chance(0.2) {
                self.below(4) as u32
            } else {
                0
            },
            ..Orientation::default()
        }
    }
    pub fn path(&mut self, base_speed: f64) -> CameraPath {
        let mut path = CameraPath::default();
        path.points.clear();
        for i in 0..2 + self.below(6) {
            let position = if i > 0 && self.chance(0.1) {
                path.points[i - 1].position
            } else {
                self.vector()
            };
            let mut point = SupportPoint::new(position);
            if self.chance(0.5) {
                point.curve = CurveParameters::Own(self.tcb());
            }
            point.orientations.clear();
            for k in 0..1 + if self.chance(0.3) { self.below(4) } else { 0 } {
                let orientation = if k > 0 && self.chance(0.2) {
                    point.orientations[k - 1].clone()
                } else {
                    self.orientation(position)
                };
                point.orientations.push(orientation);
            }
            path.points.push(point);
        }
        path.closed = self.chance(0.3);
        path.orientation_mode = match self.below(6) {
            0 => OrientationMode::Slerp,
            1 => OrientationMode::BarryGoldman,
            _ => OrientationMode::Tcb,
        };
        if self.chance(0.2) {
            path.zoom_mode = ZoomMode::Linear;
        }
        set_speeds(&mut path, base_speed);
        path
    }
}
