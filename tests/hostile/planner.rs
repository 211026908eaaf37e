//! What any bytes at all may do as a path, an object and what is asked for of a planner. Used by the
//! tests and, by path, by the fuzzer in `fuzz/`, so that both ask the same.

use vides::document::Document;
use vides::glam::{DQuat, DVec3, EulerRot};
use vides::path::{CameraPath, CurveKind, Pose, SupportPoint, Target, Up};
use vides::planner::{
    AvoidRequest, PictureRequest, Request, SteadyRequest, TourRequest, What, avoid_object,
    keep_in_picture, retime, steady, tour,
};
use vides::scene::Mesh;
use vides::tools::check::{FindingKind, Limits};
use vides::tools::clearance::Clearance;
use vides::tools::fit::{Options, Tolerance, fit};

/// Times that a planner is let go on.
const PATIENCE: usize = 20_000;

/// Frames that are looked at.
const LOOKED_AT: usize = 2_000;

const UNUSUAL: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    25.0,
    100.0,
    1e-9,
    1e9,
    1e-300,
    1e300,
    f64::MIN_POSITIVE,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
];

/// Numbers of bytes; behind the last there are zeros.
struct Given<'a>(std::slice::Iter<'a, u8>);

impl Given<'_> {
    fn byte(&mut self) -> u8 {
        self.0.next().copied().unwrap_or(0)
    }

    fn below(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count
    }

    /// From −4 to 4, or something unusual.
    fn number(&mut self) -> f64 {
        match self.byte() {
            byte if byte % 64 == 0 => UNUSUAL[self.below(UNUSUAL.len())],
            byte => (f64::from(byte) - 128.0) / 32.0,
        }
    }

    /// From 0 to 4, or something unusual.
    fn size(&mut self) -> f64 {
        let number = self.number();
        if number < -4.0 { number } else { number.abs() }
    }

    fn place(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    fn path(&mut self) -> CameraPath {
        let count = 2 + self.below(5);
        let mut path = CameraPath {
            closed: self.below(2) == 1,
            curve: CurveKind::ALL[self.below(CurveKind::ALL.len())],
            points: (0..count)
                .map(|_| SupportPoint::new(self.place()))
                .collect(),
            ..CameraPath::default()
        };
        for point in &mut path.points {
            let more = self.below(3) / 2;
            let camera = &mut point.orientations[0];
            camera.target = match self.below(3) {
                0 => Target::Absolute(self.place()),
                1 => Target::Relative(self.place()),
                _ => camera.target,
            };
            camera.zoom = [24.0, 50.0, 30.0 * self.size()][self.below(3)];
            camera.roll = [0.0, self.number()][self.below(2)];
            if more == 1 {
                let mut next = camera.clone();
                next.target = Target::Relative(self.place());
                point.orientations.push(next);
            }
        }
        path.base_frames.movement = [100.0, 20.0, 30.0 * self.size()][self.below(3)];
        path
    }

    /// Hardly ever one that is not there.
    fn corner(&mut self, count: usize) -> u32 {
        match self.byte() {
            255 => count as u32,
            byte => u32::from(byte) % count.max(1) as u32,
        }
    }

    fn mesh(&mut self) -> Mesh {
        let count = self.below(13);
        let points = (0..count).map(|_| self.place()).collect();
        let triangles = (0..self.below(17))
            .map(|_| [(); 3].map(|()| self.corner(count)))
            .collect();
        Mesh {
            points,
            triangles,
            ..Mesh::default()
        }
    }

    /// A recording is fitted: with finite poses at times that do not run backwards it never fails,
    /// unless so many poses are outliers that a robust fit leaves nothing.
    fn recording(&mut self) -> bool {
        let count = self.below(80);
        let mut poses = Vec::new();
        let mut times = Vec::new();
        let mut time = 10.0 * self.number();
        let mut place = self.place();
        let mut turn = DQuat::IDENTITY;
        for _ in 0..count {
            match self.below(8) {
                // It rests, goes on, jumps.
                0 | 1 => {}
                2 if self.below(8) == 0 => place = self.place(),
                _ => {
                    let step = [(); 3].map(|()| f64::from(self.byte()) - 128.0);
                    place += DVec3::from(step) / 3200.0;
                }
            }
            if self.below(3) == 0 {
                let [yaw, pitch, roll] = [(); 3].map(|()| f64::from(self.byte()) / 128.0);
                turn *= DQuat::from_euler(EulerRot::YXZ, yaw - 1.0, pitch - 1.0, roll - 1.0);
            }
            let zoom = match self.below(256) {
                0 => 30.0 * self.size(),
                zoom => 24.0 + zoom as f64 / 64.0,
            };
            poses.push(Pose::new(place, turn.normalize(), zoom));
            times.push(time);
            time += match self.below(256) {
                0 => self.number(),
                step => [0.0, 0.04, 1.0 / 30.0, 0.001, 0.05, 0.04, 3.0, 1e-7][step % 8],
            };
        }
        let fps = [25.0, 30.0, 15.0 * self.size()][self.below(3)];
        let tolerance = Tolerance {
            position: [0.01, 0.001, self.size()][self.below(3)],
            angle: [0.5, 10.0 * self.size()][self.below(2)],
        };
        let options = Options {
            robust: self.below(2) == 1,
            ..Options::from(tolerance)
        };
        let seconds = (self.below(4) > 0).then_some(times.as_slice());
        let mut calls = 0;
        let go_on = &mut |_, _| {
            calls += 1;
            calls < PATIENCE
        };
        let made = fit(&poses, seconds, fps, &options, go_on);
        // A robust fit that would leave out too many says so.
        let usual = count >= 2
            && !options.robust
            && tolerance.check().is_ok()
            && (1.0..=1000.0).contains(&fps)
            && place.abs().max_element() < 1e3
            && poses.iter().all(|pose| {
                (1.0..=2000.0).contains(&pose.zoom) && pose.position().abs().max_element() < 1e3
            })
            && times.iter().all(|time| time.abs() < 1e3)
            && times.is_sorted();
        match &made {
            Ok(made) => assert!(made.path.points.len() <= count.max(2), "{made:?}"),
            Err(error) => assert!(!usual || calls >= PATIENCE, "{error}: {poses:?} {times:?}"),
        }
        done(made.map(|made| made.path))
    }

    fn limits(&mut self) -> Limits {
        let mut limits = Limits::default();
        for kind in FindingKind::all() {
            if self.below(8) == 1 {
                // What is refused is left as it was.
                let _ = limits.set(kind, 10.0 * self.size());
            }
        }
        limits
    }
}

/// Plans what bytes ask for: it is refused with one sentence, or the path is in order and holds what
/// was promised; then it is true.
///
/// # Panics
/// If any of that does not hold.
pub(crate) fn check(bytes: &[u8]) -> bool {
    let mut given = Given(bytes.iter());
    // The last of the first bytes are a recording; the others are as the files of the corpus have them.
    let which = match given.byte() {
        240.. => return given.recording(),
        byte => usize::from(byte) % 5,
    };
    let (path, mesh, limits) = (given.path(), given.mesh(), given.limits());
    let fps = [25.0, 15.0 * given.size()][given.below(2)];
    let mut calls = 0;
    let go_on = &mut |_, _| {
        calls += 1;
        calls < PATIENCE
    };
    if which == 0 {
        let request = TourRequest {
            seconds: 15.0 * given.size(),
            coverage: [0.9, 0.25 * given.size()][given.below(2)],
            distance: [0.0, given.size()][given.below(2)],
            inside: given.below(2) == 1,
            start: (given.below(2) == 1).then(|| given.place()),
            up: [Up::Y, Up::Z][given.below(2)],
            space: None,
            stills: given.below(2) == 1,
            limits,
            fps,
        };
        return done(tour(&mesh, &request, go_on).map(|made| {
            assert!(made.coverage <= 1.0 && made.surface <= 1.0, "{made:?}");
            made.path
        }));
    }
    // What is no path never comes to a planner.
    let Ok(document) = Document::from_parts(path, vides::document::Info::default()) else {
        return false;
    };
    let path = document.path();
    if which == 1 {
        let request = Request {
            limits,
            fps,
            points: (given.below(2) == 1).then(|| [given.below(9), given.below(9)]),
            seconds: [0.0, 15.0 * given.size()][given.below(2)],
        };
        return done(retime(path, &request, go_on).map(|made| made.path));
    }
    if which == 2 {
        let request = SteadyRequest {
            period: given.size(),
            within: [0.0, given.size()][given.below(2)],
            fps,
        };
        return done(steady(path, &request, go_on).map(|made| made.path));
    }
    let Ok(object) = Clearance::new(&mesh) else {
        return false;
    };
    if which == 3 {
        let request = AvoidRequest {
            clearance: given.size() / 4.0,
            radius: [0.0, given.size()][given.below(2)],
        };
        let asked = request.clearance + request.radius;
        return done(avoid_object(path, &object, &request, go_on).map(|made| {
            keeps_clear(&made.path, &object, asked);
            made.path
        }));
    }
    let request = PictureRequest {
        margin: given.size() / 8.0,
        what: [What::Zoom, What::Distance, What::View][given.below(3)],
        limits,
        fps,
    };
    done(keep_in_picture(path, &mesh, &request).map(|made| made.path))
}

/// Ten places a frame; a hundred-thousandth of the distance is what the planner allows itself.
fn keeps_clear(path: &CameraPath, object: &Clearance, asked: f64) {
    let sampler = path.sampler().expect("poses");
    let last = sampler.frame_count().min(LOOKED_AT);
    for tenth in 10..=10 * last {
        let frame = tenth as f64 / 10.0;
        let pose = sampler.pose(frame).expect("a pose");
        let near = object.distance(DVec3::from(pose.vrp), asked * (1.0 - 1e-5));
        assert!(near.is_none(), "{near:?} at frame {frame}, not {asked}");
    }
}

fn done(made: Result<CameraPath, vides::error::EngineError>) -> bool {
    let path = match made {
        Ok(path) => path,
        Err(error) => {
            let sentence = error.to_string();
            assert!(!sentence.is_empty() && !sentence.chars().any(char::is_control));
            return false;
        }
    };
    path.check().expect("a path in order");
    let sampler = path.sampler().expect("poses");
    let mut poses = vec![Pose::default(); sampler.frame_count().min(LOOKED_AT)];
    sampler.sample(1, &mut poses).expect("poses");
    for pose in &poses {
        let [vpn, vup] = [pose.vpn, pose.vup].map(DVec3::from);
        assert!(
            DVec3::from(pose.vrp).is_finite() && pose.zoom.is_finite(),
            "{pose:?}"
        );
        assert!(
            (vpn.length() - 1.0).abs() < 2e-12 && vpn.dot(vup).abs() < 1e-12,
            "{pose:?}"
        );
    }
    true
}
