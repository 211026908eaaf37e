//! What planners cost by the points of the path and by the triangles of the object: smooth, equal,
//! degenerate and overlapping ones. `benches/table.py --planners` draws it (`docs/theory/planners.svg`).
//!
//! Each prints `name kind count seconds`, the longest pause between two questions whether to go on,
//! and what came of it. What takes longer than [`LIMIT`] is stopped by its
//! progress, is printed as `inf`, and is not tried with more.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use vides::path::{CameraPath, Orientation, Pose, Sampler, SupportPoint, Target, Timeline};
use vides::planner::{
    AvoidRequest, PictureRequest, Request, SteadyRequest, TourRequest, What, avoid_object,
    keep_all_in_picture, retime, steady, tour,
};
use vides::scene::{Camera, Kind, Mesh, Node, NodeState, Scene, Warnings};
use vides::tools::check::{CheckContext, Limits, check};
use vides::tools::clearance::Clearance;
use vides::tools::fit::{Options, Tolerance, fit};

/// Seconds after which a planner is stopped.
const LIMIT: f64 = 20.0;

const FPS: f64 = 25.0;

/// The same numbers at each run (Steele and others, *SplitMix*, 2014).
struct Random(u64);

impl Random {
    /// Between -1 and 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn place(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }
}

/// A ball of radius 0.4 with about this number of triangles.
fn smooth(count: usize) -> Mesh {
    let rings = ((count as f64 / 4.0).sqrt().round() as u32).max(2);
    let around = ((count as f64 / f64::from(2 * (rings - 1))).round() as u32).max(3);
    let mut mesh = Mesh::default();
    for ring in 0..=rings {
        let (sin, cos) = (PI * f64::from(ring) / f64::from(rings)).sin_cos();
        for k in 0..around {
            let (s, c) = (TAU * f64::from(k) / f64::from(around)).sin_cos();
            mesh.points.push(0.4 * DVec3::new(sin * c, cos, sin * s));
        }
    }
    let at = |ring: u32, k: u32| ring * around + k % around;
    for ring in 0..rings {
        for k in 0..around {
            if ring + 1 < rings {
                mesh.triangles
                    .push([at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)]);
            }
            if ring > 0 {
                mesh.triangles
                    .push([at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)]);
            }
        }
    }
    mesh
}

/// The same triangles again and again.
fn equal(count: usize) -> Mesh {
    let mut mesh = smooth(count.min(100));
    let once = mesh.triangles.clone();
    mesh.triangles = once.iter().copied().cycle().take(count).collect();
    mesh
}

/// Triangles without an area, on the edges of a ball.
fn degenerate(count: usize) -> Mesh {
    let mut mesh = smooth(count);
    // One with an area, which a tour needs.
    for [_, b, c] in mesh.triangles.iter_mut().skip(1) {
        *c = *b;
    }
    mesh
}

/// Triangles at random, each as large as all of it.
fn overlapping(count: usize) -> Mesh {
    let mut random = Random(1);
    Mesh {
        points: (0..3 * count).map(|_| 0.4 * random.place()).collect(),
        triangles: (0..count as u32)
            .map(|k| [3 * k, 3 * k + 1, 3 * k + 2])
            .collect(),
        ..Mesh::default()
    }
}

/// Round the object, whose middle the camera looks at: `step` is the turn from point to point, so
/// wide that the way leads through it or not.
fn path(points: usize, step: f64) -> CameraPath {
    let place = |k: usize| {
        let k = k as f64;
        let far = 1.1 + 0.1 * (0.9 * k).sin();
        far * DVec3::new((step * k).cos(), 0.2 * (0.3 * k).sin(), (step * k).sin())
    };
    let point = |k: usize| SupportPoint {
        orientations: vec![Orientation {
            target: Target::Absolute(DVec3::ZERO),
            zoom: 20.0,
            ..Orientation::default()
        }],
        ..SupportPoint::new(place(k))
    };
    let mut path = CameraPath {
        points: (0..points).map(point).collect(),
        ..CameraPath::default()
    };
    path.base_frames.movement = 10.0;
    path
}

/// The poses of a path, and of a flight outside of the object.
fn poses(path: &CameraPath) -> Vec<Pose> {
    let sampler = Sampler::new(path, &Timeline::new(path).expect("a path")).expect("a path");
    sampler.iter().map(|pose| pose.expect("a pose")).collect()
}

/// Seconds of the processor that this thread has had: others may be busy.
fn used() -> f64 {
    let line = std::fs::read_to_string("/proc/thread-self/schedstat").expect("Linux");
    let first = line.split(' ').next().expect("a number");
    first.parse::<f64>().expect("a number") / 1e9
}

/// One line; whether it was done in time. What is quick is done again, since the clock ticks slowly.
fn time(
    name: &str,
    kind: &str,
    count: usize,
    mut work: impl FnMut(&mut dyn FnMut(usize, usize) -> bool) -> String,
) -> bool {
    let start = used();
    let (mut last, mut pause, mut runs) = (start, 0.0_f64, 0);
    let mut told = String::new();
    while runs == 0 || (runs < 100 && used() - start < 0.04) {
        told = work(&mut |_, _| {
            let now = used();
            pause = pause.max(now - last);
            last = now;
            now - start < LIMIT
        });
        runs += 1;
    }
    let seconds = used() - start;
    pause = pause.max(used() - last);
    let done = seconds < LIMIT;
    let shown = if done {
        seconds / f64::from(runs)
    } else {
        f64::INFINITY
    };
    println!("{name} {kind} {count} {shown:.6} {pause:.3} {told}");
    done
}

fn told<T, E: std::fmt::Display>(made: Result<T, E>) -> String {
    made.map_or_else(
        |error| error.to_string().replace(' ', "_"),
        |_| "ok".to_owned(),
    )
}

/// What is measured by the triangles of the object, and by the points of the path.
const OF_TRIANGLES: [&str; 8] = [
    "tree", "check", "avoid", "zoom", "distance", "view", "tour", "inside",
];
const OF_POINTS: [&str; 8] = [
    "check", "avoid", "zoom", "distance", "view", "retime", "steady", "fit",
];

/// All planners for one path and one object.
fn planners(
    names: &mut Vec<&'static str>,
    wanted: &[&String],
    (kind, count): (&str, usize),
    points: usize,
    mesh: &Mesh,
) {
    let tree = Clearance::new(mesh).expect("a tree");
    let [round, through] = [0.5, 2.4].map(|step| path(points, step));
    let path = &round;
    for name in names.clone() {
        if !(wanted.is_empty() || wanted.iter().any(|word| *word == name)) {
            continue;
        }
        let done = time(name, kind, count, |go_on| match name {
            "tree" => told(Clearance::new(mesh)),
            "check" => {
                let against = CheckContext {
                    fps: FPS,
                    space: None,
                    object: Some(&tree),
                    limits: Limits::default(),
                };
                told(check(&through, &against))
            }
            "avoid" => {
                let request = AvoidRequest {
                    clearance: 0.05,
                    radius: 0.0,
                };
                told(avoid_object(&through, &tree, &request, go_on))
            }
            "zoom" | "distance" | "view" => {
                let what = What::named(name).expect("a name");
                let request = PictureRequest {
                    margin: 0.1,
                    what,
                    limits: Limits::default(),
                    fps: FPS,
                };
                told(keep_all_in_picture(path, &tree, &request, go_on))
            }
            "tour" | "inside" => {
                let request = TourRequest {
                    inside: name == "inside",
                    ..TourRequest::default()
                };
                told(tour(mesh, &request, go_on))
            }
            "retime" => {
                let request = Request {
                    limits: Limits::default(),
                    fps: FPS,
                    points: None,
                    seconds: 0.0,
                };
                told(retime(path, &request, go_on))
            }
            "steady" => {
                let request = SteadyRequest {
                    period: 1.0,
                    within: 0.0,
                    fps: FPS,
                };
                told(steady(path, &request, go_on))
            }
            _ => {
                let poses = poses(path);
                let options = Options::from(Tolerance {
                    position: 1e-3,
                    angle: 0.5,
                });
                told(fit(&poses, None, FPS, &options, go_on))
            }
        });
        if !done {
            names.retain(|known| *known != name);
        }
    }
}

/// Cameras at one place, which have no direction and look for the last: plain, that aim at one another
/// in a ring or a chain, or in a chain at what hangs in one another.
fn aims(kind: &str, count: usize) -> Scene {
    let mut nodes = Vec::new();
    for k in 0..count {
        let mut node = Node::new(&format!("n{k}"), Kind::Camera(Camera::default()));
        match kind {
            "ring" => node.aim = Some((k + 1) % count),
            "chain" => node.aim = k.checked_sub(1),
            "hanging" if k % 2 == 1 => {
                node.kind = Kind::Group;
                node.parent = Some(k - 1);
            }
            "hanging" => node.aim = k.checked_sub(1),
            _ => {}
        }
        nodes.push(node);
    }
    Scene::from_nodes(nodes)
        .map_err(|(_, error)| error)
        .expect("a scene")
}

/// The states of all nodes at a frame.
fn scenes() {
    for kind in ["plain", "ring", "chain", "hanging"] {
        for count in [10, 100, 1_000, 10_000, 50_000] {
            let scene = aims(kind, count);
            let mut states = vec![NodeState::default(); count];
            time("evaluate", kind, count, |_| {
                told(scene.evaluate(1.0, &mut states, &mut Warnings::default()))
            });
        }
    }
}

/// Words behind it choose among names and kinds; none: all.
fn main() {
    let words: Vec<String> = std::env::args()
        .skip(1)
        .filter(|word| !word.starts_with("--"))
        .collect();
    type Made = fn(usize) -> Mesh;
    let kinds: [(&str, Made); 4] = [
        ("smooth", smooth),
        ("equal", equal),
        ("degenerate", degenerate),
        ("overlapping", overlapping),
    ];
    let is_kind = |word: &&String| {
        kinds.iter().any(|(kind, _)| kind == word) || *word == "points" || *word == "scene"
    };
    let (chosen, wanted): (Vec<&String>, Vec<&String>) = words.iter().partition(is_kind);
    let takes = |kind: &str| chosen.is_empty() || chosen.iter().any(|word| *word == kind);
    if takes("scene") {
        scenes();
    }
    for (kind, mesh) in kinds {
        let mut names = OF_TRIANGLES.to_vec();
        for count in [10, 100, 1_000, 10_000, 100_000, 1_000_000] {
            if takes(kind) {
                planners(&mut names, &wanted, (kind, count), 20, &mesh(count));
            }
        }
    }
    let mut names = OF_POINTS.to_vec();
    for points in [10, 100, 1_000, 10_000] {
        if takes("points") {
            planners(
                &mut names,
                &wanted,
                ("points", points),
                points,
                &smooth(2_000),
            );
        }
    }
}
