//! Speed of the engine: `cargo bench`. `benches/table.py` turns the figures
//! into the tables of `docs/theory/accuracy-and-speed.md`, beside those of other libraries.
//!
//! All benchmarks run on one path, a wobbling curve in the cube with a camera
//! that turns, rolls and zooms steadily. `benches/peers/bench_path.py` and
//! `benches/list.c` make the same one.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec3;
use vides::document::{Document, Info, SceneDocument};
use vides::path::{
    CameraPath, CurveParameters, Orientation, Plan, Pose, Sampler, SupportPoint, Target, Tcb,
    Timeline,
};
use vides::scene::{Camera, Channel, Interpolation, Kind, Node, NodeState, Scene, Track, Warnings};

/// About this number of poses, whatever the number of points.
const POSES: f64 = 1e6;

fn point(i: usize) -> SupportPoint {
    let i = i as f64;
    let wave = |frequency: f64, phase: f64| (frequency * i + phase).sin();
    let yaw = 0.21 * i + 0.3 * wave(0.7, 0.0);
    let position = DVec3::new(
        0.8 * wave(0.37, 0.0),
        0.6 * wave(0.23, 1.0),
        0.8 * (0.31 * i).cos(),
    );
    let view = Orientation {
        target: Target::Relative(DVec3::new(yaw.sin(), 0.4 * wave(0.29, 0.0), yaw.cos())),
        roll: 20.0 * wave(0.41, 0.0),
        zoom: 50.0 + 30.0 * wave(0.17, 0.0),
        turning: Tcb::new(
            0.3 * wave(1.9, 0.0),
            0.3 * wave(2.3, 1.0),
            0.3 * wave(2.9, 2.0),
        ),
        ..Orientation::default()
    };
    SupportPoint {
        curve: CurveParameters::Own(Tcb::new(
            0.4 * wave(1.3, 0.0),
            0.3 * wave(1.7, 1.0),
            0.4 * wave(2.1, 2.0),
        )),
        orientations: vec![view],
        ..SupportPoint::new(position)
    }
}

/// So many points, and the base speed that gives [`POSES`] in all.
fn path(points: usize) -> CameraPath {
    path_of(points, POSES)
}

fn path_of(points: usize, poses: f64) -> CameraPath {
    let mut path = CameraPath {
        points: (0..points).map(point).collect(),
        ..CameraPath::default()
    };
    let length = Timeline::new(&path).expect("lengths").length();
    path.base_frames.movement = poses / length;
    path
}

fn prepare(path: &CameraPath) -> Sampler {
    let timeline = Timeline::new(path).expect("a timeline");
    Sampler::new(path, &timeline).expect("a sampler")
}

/// Poses into memory that has been touched before.
fn sample(c: &mut Criterion) {
    let mut group = c.benchmark_group("sample");
    for points in [100, 10_000] {
        let path = path(points);
        let sampler = prepare(&path);
        // Not the default, which is all zero and might come untouched.
        let mut poses = vec![
            Pose {
                zoom: 1.0,
                ..Pose::default()
            };
            sampler.frame_count()
        ];
        group.throughput(Throughput::Elements(poses.len() as u64));
        group.bench_function(format!("{points}_prepared"), |b| {
            b.iter(|| sampler.sample(1, black_box(&mut poses)).expect("poses"));
        });
        // A half each; table.py divides.
        group.bench_function(format!("{points}_two_threads"), |b| {
            let half = poses.len() / 2;
            b.iter(|| {
                let (first, second) = black_box(&mut poses).split_at_mut(half);
                std::thread::scope(|scope| {
                    scope.spawn(|| sampler.sample(half + 1, second).expect("poses"));
                    sampler.sample(1, first).expect("poses");
                });
            });
        });
        // As many poses between frames, in order and in none; and one alone.
        let count = poses.len();
        let last = count as f64;
        let rising: Vec<f64> = (0..count).map(|k| (k as f64 + 1.5).min(last)).collect();
        group.bench_function(format!("{points}_between_frames"), |b| {
            b.iter(|| {
                sampler
                    .poses_at(&rising, black_box(&mut poses))
                    .expect("poses")
            });
        });
        // 611,953 is a prime.
        let random: Vec<f64> = (0..count).map(|k| rising[k * 611_953 % count]).collect();
        group.bench_function(format!("{points}_anywhere"), |b| {
            b.iter(|| {
                sampler
                    .poses_at(&random, black_box(&mut poses))
                    .expect("poses")
            });
        });
        group.bench_function(format!("{points}_one_by_one"), |b| {
            b.iter(|| {
                for (&frame, pose) in random.iter().zip(black_box(&mut poses)) {
                    *pose = sampler.pose(frame).expect("a pose");
                }
            });
        });
        group.bench_function(format!("{points}_with_preparation"), |b| {
            b.iter(|| {
                let sampler = prepare(black_box(&path));
                sampler.sample(1, black_box(&mut poses)).expect("poses");
            });
        });
    }
    group.finish();
}

/// The physical limit: as many bytes as a million poses have, and nothing else.
fn write(c: &mut Criterion) {
    let mut memory = vec![1.0_f64; 10 * POSES as usize];
    let mut group = c.benchmark_group("write");
    group.throughput(Throughput::Elements(POSES as u64));
    group.bench_function("bare", |b| {
        b.iter(|| black_box(&mut memory).fill(black_box(0.5)));
    });
    group.finish();
}

/// One change in a path of 10,000 points, and the frame count asked again.
fn change(c: &mut Criterion) {
    let mut group = c.benchmark_group("change");
    let at = 5_000;
    let mut path = path(10_000);
    let mut plan = Plan::new();
    let ask = |path: &CameraPath, plan: &mut Plan| {
        plan.point_changed(at);
        let count = plan.timeline(path, |timeline| timeline.frame_count());
        count.expect("a timeline").expect("a count")
    };
    ask(&path, &mut plan);

    let step = DVec3::new(0.01, -0.02, 0.015);
    let mut sign = 1.0;
    group.bench_function("point", |b| {
        b.iter(|| {
            path.points[at].position += step * sign;
            sign = -sign;
            ask(black_box(&path), &mut plan)
        });
    });
    group.bench_function("orientation", |b| {
        b.iter(|| {
            let view = &mut path.points[at].orientations[0];
            view.target = Target::Relative(view.target.offset_from(DVec3::ZERO) + step * sign);
            view.zoom += sign;
            sign = -sign;
            ask(black_box(&path), &mut plan)
        });
    });
    group.finish();
}

/// A file of 10,000 points: read, and written with both fsyncs; a scene's text of a million keys.
fn files(c: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a folder");
    let mut group = c.benchmark_group("file");
    for points in [1_000, 10_000] {
        let file = folder.path().join(format!("{points}.vid"));
        let document = Document::from_parts(path(points), Info::default()).expect("a document");
        group.throughput(Throughput::Elements(points as u64));
        group.bench_function(format!("save_{points}"), |b| {
            b.iter(|| document.save(&file).expect("saved"));
        });
        group.bench_function(format!("load_{points}"), |b| {
            b.iter_batched(
                || (),
                |()| Document::load(&file).expect("loaded"),
                BatchSize::PerIteration,
            );
        });
    }
    let text = keys();
    group.bench_function("load_keys", |b| {
        b.iter(|| SceneDocument::from_toml(&text).expect("loaded"))
    });
    group.finish();
}

/// The file of a scene with one track of a million keys.
fn keys() -> String {
    let frames: Vec<f64> = (0..1_000_000).map(f64::from).collect();
    let values = frames.iter().map(|frame| (0.1 * frame).sin()).collect();
    let track = Track::new(Channel::Roll, Interpolation::Linear, frames, values, vec![]);
    let mut camera = Node::new("eye", Kind::Camera(Camera::default()));
    camera
        .set_track(track.expect("a track"))
        .expect("a channel");
    let mut document = SceneDocument::try_new().expect("a scene");
    document.scene.add(camera).expect("a node");
    document.to_toml().expect("a text")
}

/// Nodes of a tree with three tracks of six keys each, as in `benches/scene.c`.
fn nodes(count: usize) -> Scene {
    let mut nodes = Vec::new();
    for n in 0..count {
        let mut node = Node::new(&format!("n{n}"), Kind::Group);
        node.parent = (n > 0).then(|| (n - 1) / 4);
        let frames: Vec<f64> = (0..6).map(|k| f64::from(1 + 20 * k)).collect();
        for (channel, width) in [
            (Channel::Position, 3),
            (Channel::Rotation, 4),
            (Channel::Scale, 3),
        ] {
            let values = (0..6 * width).map(|k| (0.37 * n as f64 + 0.9 * f64::from(k)).sin());
            let track = Track::new(
                channel,
                Interpolation::Linear,
                frames.clone(),
                values.collect(),
                vec![],
            );
            node.set_track(track.expect("a track")).expect("a channel");
        }
        nodes.push(node);
    }
    Scene::from_nodes(nodes)
        .map_err(|(_, error)| error)
        .expect("a scene")
}

/// What a point and a node cost by their number: `table.py` draws it.
fn growth(c: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a folder");
    let mut group = c.benchmark_group("growth");
    group
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    for count in [10, 100, 1_000, 10_000, 100_000] {
        group.throughput(Throughput::Elements(count as u64));
        let path = path_of(count, 10.0 * count as f64);
        let sampler = prepare(&path);
        group.bench_function(format!("prepare_{count}"), |b| {
            b.iter(|| prepare(black_box(&path)))
        });
        let mut poses = vec![
            Pose {
                zoom: 1.0,
                ..Pose::default()
            };
            sampler.frame_count()
        ];
        group.bench_function(format!("fill_{count}"), |b| {
            b.iter(|| sampler.sample(1, black_box(&mut poses)).expect("poses"));
        });
        let file = folder.path().join("growth.vid");
        let document = Document::from_parts(path, Info::default()).expect("a document");
        document.save(&file).expect("saved");
        group.bench_function(format!("load_{count}"), |b| {
            b.iter(|| Document::load(&file).expect("loaded"))
        });
        let scene = nodes(count);
        let mut states = vec![NodeState::default(); count];
        let mut frame = 0.0;
        group.bench_function(format!("evaluate_{count}"), |b| {
            b.iter(|| {
                frame = (frame + 0.37) % 100.0;
                scene
                    .evaluate(
                        1.0 + frame,
                        black_box(&mut states),
                        &mut Warnings::default(),
                    )
                    .expect("states");
            });
        });
    }
    group.finish();
}

criterion_group! {
    name = engine;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_secs(1))
        .measurement_time(Duration::from_secs(4));
    targets = sample, write, change, files, growth
}
criterion_main!(engine);
