//! Scenes in `.vid` files: bit by bit there and back, every complaint with its
//! line, and a camera alone as it always was.

use glam::{DQuat, DVec3};
use vides::deform::{Bounds, Deformation};
use vides::document::{Document, SceneDocument};
use vides::formats::{Options, by_name, export_to};
use vides::path::{CameraPath, Pose};
use vides::scene::{
    Camera, Channel, Extrapolation, FollowPath, Interpolation, Kind, Light, Mesh, Node, Object,
    Scene, Shape, Track,
};

fn track(
    channel: &str,
    interpolation: &str,
    frames: &[f64],
    values: &[f64],
    shape: &[f64],
) -> Track {
    Track::new(
        Channel::parse(channel).unwrap(),
        Interpolation::parse(interpolation).unwrap(),
        frames.to_vec(),
        values.to_vec(),
        shape.to_vec(),
    )
    .unwrap()
}

/// A scene with everything in it, and numbers that are hard to write.
#[expect(clippy::too_many_lines)] // told in one piece
fn everything() -> SceneDocument {
    let mut scene = Scene::new();
    let mut world = Node::new("world", Kind::Group);
    world.rest.position = DVec3::new(0.1 + 0.2, -0.0, 1e-300);
    world.rest.rotation = DQuat::from_xyzw(1e-17, 0.3, -0.4, 5.0);
    world.rest.visible = false;
    world.pivot = DVec3::new(-0.0, 1.0, 1.0 / 3.0);
    let world = scene.add(world).unwrap();
    let mut body = Node::new("the \"body\"", Kind::Object(Object::default()));
    body.parent = Some(world);
    let body = scene.add(body).unwrap();
    let points = vec![
        DVec3::ZERO,
        DVec3::X / 3.0,
        DVec3::new(0.0, -0.0, 7e-5),
        DVec3::ONE,
    ];
    let mesh = Mesh {
        points: points.clone(),
        colours: vec![[0, 128, 255]; 4],
        lines: vec![[0, 1], [2, 3]],
        triangles: vec![[0, 1, 2]],
    };
    scene.set_mesh(body, mesh).unwrap();
    for name in ["happy", ""] {
        let shape = Shape {
            name: name.to_owned(),
            points: points.iter().map(|p| *p * 1.1).collect(),
            colours: Vec::new(),
        };
        scene.add_shape(body, shape).unwrap();
    }
    scene.set_weights(body, &[0.25, -0.0]).unwrap();
    let bounds = Bounds::new(DVec3::splat(-0.1), DVec3::new(1.0, 2.0, -0.1)).unwrap();
    let twist = Deformation::new("twist", &[2.0, 33.3]).unwrap();
    scene.add_deformation(body, twist, Some(bounds)).unwrap();
    let taper = Deformation::new("taper", &[0.0, 1.0, 0.5]).unwrap();
    scene.add_deformation(body, taper, None).unwrap();
    for track in [
        track("weights", "linear", &[1.0, 9.5], &[0.0, 0.1, 1.0, 0.2], &[]),
        track(
            "deformation.0.angle",
            "sine",
            &[1.0, 2.0],
            &[0.0, 720.0],
            &[],
        ),
        track(
            "rotation",
            "euler-linear",
            &[0.0, 10.0],
            &[0.0, 0.0, 0.0, 0.0, 720.0, 0.0],
            &[],
        ),
        track(
            "position",
            "hermite",
            &[-5.0, 10.0],
            &[0.1; 6],
            &[1.0 / 3.0; 12],
        ),
        track("scale", "tcb", &[1.0, 2.0, 4.0], &[1.0; 9], &[0.3; 9]),
        track("colour", "host:mine", &[1.0], &[1.0, 0.5, 0.0], &[]),
        track(
            "value:wind:2",
            "cubic",
            &[1.0, 2.0, 4.0],
            &[1.0, 2.0, 5.0, 0.0, 1.0, 2.0],
            &[],
        ),
        track("visible", "step", &[1.0, 2.0], &[1.0, 0.0], &[]),
    ] {
        let track = track
            .with_extrapolation(Extrapolation::Hold, Extrapolation::Repeat)
            .unwrap();
        scene.set_track(body, track).unwrap();
    }
    let mut lamp = Node::new("lamp", Kind::Light(Light::Spot));
    lamp.rest.cone = [10.0, 20.5];
    lamp.rest.intensity = 3.0;
    lamp.rest.colour = [1.0, 0.9, 0.1];
    lamp.aim = Some(body);
    let lamp = scene.add(lamp).unwrap();
    let path = || CameraPath {
        closed: true,
        curve: vides::path::CurveKind::Cubic,
        ..CameraPath::default()
    };
    scene
        .set_path(
            lamp,
            Some(FollowPath::new(path(), 12.5, Extrapolation::PingPong).unwrap()),
        )
        .unwrap();
    let camera = Kind::Camera(Camera {
        near: 0.5,
        far: 70.0,
    });
    let mut camera = Node::new("camera", camera);
    camera.rest.zoom = 35.5;
    camera.rest.roll = -20.0;
    let camera = scene.add(camera).unwrap();
    let mut follow = CameraPath::default();
    follow.presets[3].tension = -0.0;
    scene
        .set_path(
            camera,
            Some(FollowPath::new(follow, 1.0, Extrapolation::Hold).unwrap()),
        )
        .unwrap();
    // A parent further down.
    let mut late = Node::new("late", Kind::Group);
    late.pivot = DVec3::ONE;
    let late = scene.add(late).unwrap();
    let mut moved = scene.nodes()[world].clone();
    moved.parent = Some(late);
    scene.set_node(world, &moved).unwrap();
    scene.set_marker("meet", 40.0).unwrap();
    scene.set_marker("again", 0.1).unwrap();
    scene.pin(lamp, 1, Some("meet")).unwrap();
    scene.pin(camera, 0, Some("again")).unwrap();
    scene.set_camera(Some(camera)).unwrap();
    scene.set_range(Some((-0.0, 40.0 + 1.0 / 3.0))).unwrap();
    let mut document = SceneDocument::try_new().unwrap();
    document.scene = scene;
    document.info.title = "everything".to_owned();
    document.info.fps = 24.0;
    document
}

#[test]
fn every_bit_comes_back() {
    let document = everything();
    let text = document.to_toml().unwrap();
    let back = SceneDocument::from_toml(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert_eq!(back, document);
    // `==` takes −0 for 0; the text does not.
    assert_eq!(back.to_toml().unwrap(), text);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("scene.vid");
    document.save(&file).unwrap();
    assert_eq!(SceneDocument::load(&file).unwrap(), document);
}

#[test]
fn a_camera_alone_is_todays_file() {
    let document = SceneDocument::try_new().unwrap();
    let plain = Document::new().to_toml().unwrap();
    assert_eq!(document.to_toml().unwrap(), plain);
    assert_eq!(SceneDocument::from_toml(&plain).unwrap(), document);
    // Its comments stay, through a scene too.
    let told = plain.replace("\nclosed", "\n# Open at both ends.\nclosed");
    let of_scene = SceneDocument::from_toml(&told).unwrap();
    assert_eq!(of_scene.try_clone().unwrap().to_toml().unwrap(), told);
    // One number more, and it is a scene.
    let mut zoomed = document.try_clone().unwrap();
    let mut camera = zoomed.scene.nodes()[0].clone();
    camera.rest.roll = -0.0;
    zoomed.scene.set_node(0, &camera).unwrap();
    let text = zoomed.to_toml().unwrap();
    assert!(text.contains("roll_degrees = -0.0\n"));
    let back = SceneDocument::from_toml(&text).unwrap();
    assert_eq!(back.to_toml().unwrap(), text);
    let error = Document::from_toml(&text).unwrap_err().to_string();
    assert!(
        error.contains("this is a scene with 1 nodes, not a path alone"),
        "{error}"
    );
    // Nothing at all is a scene too.
    let mut empty = SceneDocument::try_new().unwrap();
    empty.scene.remove(0).unwrap();
    let text = empty.to_toml().unwrap();
    assert_eq!(SceneDocument::from_toml(&text).unwrap(), empty);
}

/// What is shown stands at the top, and makes a scene of a path.
#[test]
fn a_range_or_a_chosen_camera_is_a_scenes() {
    let plain = Document::new().to_toml().unwrap();
    let of = |keys: &str| plain.replacen("\nclosed", &format!("\n{keys}\nclosed"), 1);
    for (keys, camera, range) in [
        ("range = [-2.5, 7]", None, Some((-2.5, 7.0))),
        ("camera = \"camera\"", Some(0), None),
        (
            "range = [3, 3]\ncamera = 'camera'",
            Some(0),
            Some((3.0, 3.0)),
        ),
    ] {
        let text = of(keys);
        let document = SceneDocument::from_toml(&text).unwrap();
        let scene = &document.scene;
        assert_eq!((scene.camera(), scene.range()), (camera, range));
        assert_eq!(scene.nodes().len(), 1);
        let written = document.to_toml().unwrap();
        assert!(written.contains("[[node]]") && document.path_alone().is_none());
        let back = SceneDocument::from_toml(&written).unwrap();
        assert_eq!(back, document);
        assert_eq!(back.to_toml().unwrap(), written);
        // The window keeps it, what takes a path alone says so, and the path is that of the file.
        let (whole, _) = Document::scene_from_toml(&text, "".as_ref()).unwrap();
        assert_eq!(whole.scene().unwrap(), *scene);
        assert_eq!(whole.to_toml().unwrap(), written);
        let error = Document::from_toml(&text).unwrap_err().to_string();
        assert!(
            error.contains("this is a scene with 1 nodes, not a path alone"),
            "{error}"
        );
        let path = Document::load_shown_from(&mut text.as_bytes(), "it").unwrap();
        assert_eq!(path.path(), Document::new().path());
    }
}

/// Of several cameras on paths the chosen one's path is edited, and loaded as a path.
#[test]
fn the_chosen_cameras_path_is_the_documents() {
    let mut document = SceneDocument::try_new().unwrap();
    let scene = &mut document.scene;
    let second = Node::new("second", Kind::Camera(Camera::default()));
    let second = scene.add(second).unwrap();
    let mut path = CameraPath::default();
    path.points[0].position.x = -0.25;
    let follow = FollowPath::new(path.clone(), 5.0, Extrapolation::Hold).unwrap();
    scene.set_path(second, Some(follow)).unwrap();
    for (chosen, want) in [(None, CameraPath::default()), (Some(second), path)] {
        document.scene.set_camera(chosen).unwrap();
        let text = document.to_toml().unwrap();
        let shown = Document::load_shown_from(&mut text.as_bytes(), "it").unwrap();
        assert_eq!(*shown.path(), want);
        let (whole, _) = Document::scene_from_toml(&text, "".as_ref()).unwrap();
        assert_eq!(whole.shown_path().unwrap().path(), &want);
        assert_eq!(whole.path(), &want);
    }
}

/// One count: a program that takes the poses gets what a file has, frame by frame, and people
/// read the frames as they count them.
#[test]
fn poses_handed_over_are_those_of_a_file() {
    let mut document = SceneDocument::try_new().unwrap();
    document.info.first_frame = -7;
    let scene = &mut document.scene;
    let mut second = Node::new("second", Kind::Camera(Camera::default()));
    second.parent = Some(0);
    second.rest.roll = 20.0;
    let second = scene.add(second).unwrap();
    scene
        .set_track(
            second,
            track("zoom", "linear", &[-9.0, 700.5], &[24.0, 50.0], &[]),
        )
        .unwrap();
    for (camera, range, count) in [
        (None, None, 710),
        (Some(second), None, 710),
        (None, Some((-3.5, 20.0)), 24),
        (Some(second), Some((40.0, 40.25)), 1),
    ] {
        document.scene.set_camera(camera).unwrap();
        document.scene.set_range(range).unwrap();
        let (first, _) = document.scene.frame_range();
        let text = document.to_toml().unwrap();
        let (whole, _) = Document::scene_from_toml(&text, "".as_ref()).unwrap();
        let poses = whole.poses().unwrap();
        let mut all = vec![Pose::default(); poses.frame_count()];
        poses.sample(1, &mut all).unwrap();
        assert_eq!(all.len(), count);
        let (mut lines, csv) = (Vec::new(), by_name("csv").unwrap());
        export_to(
            &document,
            &mut lines,
            csv,
            &Options::default(),
            &mut |_, _| {},
        )
        .unwrap();
        let lines = String::from_utf8(lines).unwrap();
        assert_eq!(lines.lines().count(), 1 + count);
        for (at, (line, pose)) in lines.lines().skip(1).zip(&all).enumerate() {
            let numbers: Vec<f64> = line.split(',').map(|word| word.parse().unwrap()).collect();
            let want = [pose.vrp, pose.vpn, pose.vup];
            assert_eq!(numbers[0], first + at as f64 - 8.0);
            assert_eq!(numbers[1..10], *want.as_flattened());
            assert_eq!(numbers[10], pose.zoom);
        }
    }
}

#[test]
#[expect(clippy::too_many_lines)] // told in one piece
fn complaints_name_line_node_channel_and_key() {
    let cases = [
        (
            "[[node]]\nkind = \"group\"\n",
            "line 2: node: this node has no name",
        ),
        (
            "[[node]]\nname = \"a\"\n",
            "line 2: node: this node has no kind",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"car\"\n",
            "line 4: kind: must be \"group\"",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\nzoom = 3\n",
            "line 5: unknown key \"zoom\"",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\nparent = \"b\"\n",
            "line 5: parent: there is no node \"b\"",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\nparent = \"a\"\n",
            "line 2: node \"a\": it cannot be in itself",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\nparent = \"b\"\n[[node]]\nname = \"b\"\nkind = \"group\"\nparent = \"a\"\n",
            "cannot be in",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\n[[node]]\nname = \"a\"\nkind = \"group\"\n",
            "line 5: there is a node \"a\" already",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\n[[node.track]]\nchannel = \"position\"\ninterpolation = \"linear\"\nframes = [1, 1]\nvalues = [[0,0,0],[0,0,0]]\n",
            "line 5: node \"a\": channel \"position\": key 2: its frame must lie behind",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\n[[node.track]]\nchannel = \"zoom\"\ninterpolation = \"linear\"\nframes = [1]\nvalues = [5]\n",
            "line 5: node \"a\": channel \"zoom\": a group has no channel \"zoom\"",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\n[[node.track]]\nchannel = \"position\"\ninterpolation = \"linear\"\nframes = [1, 2]\nvalues = [[0,0,0],[0,0]]\n",
            "line 9: values: expected 3 numbers, found 2",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\n[[node.track]]\nchannel = \"position\"\ninterpolation = \"linear\"\nframes = [1, 2]\nvalues = [[0,0,nan],[0,0,0]]\n",
            "line 9: values: the number must be finite",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"object\"\n[node.mesh]\npoints = [[0,0,0]]\ntriangles = [[0,0,1]]\n",
            "there is no point 1 among 1",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"camera\"\nnear = 3\nfar = 2\n",
            "line 2: node \"a\": a camera's near plane",
        ),
        (
            "closed = true\n[[node]]\nname = \"a\"\nkind = \"group\"\n",
            "in a scene \"closed\" belongs to the path of a node",
        ),
        (
            "[[marker]]\nname = \"m\"\n",
            "line 2: marker: a marker has a name and a frame",
        ),
        (
            "[[node]]\nname = \"a\"\nkind = \"group\"\n[node.path]\npins = [{ point = 0, marker = \"m\" }]\n[[node.path.point]]\nposition = [0,0,0]\n[[node.path.point]]\nposition = [1,0,0]\n",
            "line 6: node \"a\": there is no marker \"m\"",
        ),
        (
            "camera = \"b\"\n[[node]]\nname = \"a\"\nkind = \"camera\"\n",
            "line 2: camera: there is no node \"b\"",
        ),
        (
            "fps = 24\ncamera = \"a\"\n[[node]]\nname = \"a\"\nkind = \"light\"\n",
            "line 3: camera: \"a\" is no camera",
        ),
        ("camera = 3\nnode = []\n", "line 2: camera: expected a text"),
        (
            "range = [3, 2.5]\nnode = []\n",
            "line 2: range: the last frame must not lie before the first",
        ),
        (
            "range = [3]\nnode = []\n",
            "line 2: range: expected 2 numbers, found 1",
        ),
        (
            "range = 3\nnode = []\n",
            "line 2: range: expected an array, found",
        ),
        (
            "range = [1, inf]\nnode = []\n",
            "line 2: range: the number must be finite",
        ),
        (
            "range = [1, 1e10]\nnode = []\n",
            "line 2: range: a frame must not exceed 1e9",
        ),
        (
            "range = [-5e7, 5e7]\nnode = []\n",
            "line 2: range: the scene has more than 100000000 frames",
        ),
        (
            "range = [1, 2]\nclosed = true\n",
            "line 3: a path needs at least two points",
        ),
    ];
    for (text, want) in cases {
        let text = format!("version = 1\n{text}");
        let error = SceneDocument::from_toml(&text).unwrap_err().to_string();
        assert!(error.contains(want), "{text}\n{error}\nwant {want}");
    }
}

#[test]
fn timed_large_scenes_load_in_time_that_grows_with_them() {
    let make = |count: usize| {
        let mut scene = Scene::new();
        for k in 0..count {
            let mut node = Node::new(&format!("node {k}"), Kind::Group);
            node.parent = (k > 0).then_some(k / 10);
            let node = scene.add(node).unwrap();
            let keys = track("position", "linear", &[1.0, 2.0], &[k as f64; 6], &[]);
            scene.set_track(node, keys).unwrap();
        }
        let mut document = SceneDocument::try_new().unwrap();
        document.scene = scene;
        document
    };
    let time = |count: usize| {
        let document = make(count);
        let text = document.to_toml().unwrap();
        let start = std::time::Instant::now();
        assert_eq!(SceneDocument::from_toml(&text).unwrap(), document);
        start.elapsed().as_secs_f64()
    };
    let best = |count| (0..3).map(|_| time(count)).fold(f64::INFINITY, f64::min);
    let (few, many) = (best(1_000), best(10_000));
    println!(
        "1,000 nodes {:.1} ms, 10,000 nodes {:.1} ms",
        1e3 * few,
        1e3 * many
    );
    assert!(many < 40.0 * few, "{few} {many}");
    let frames: Vec<f64> = (0..1_000_000).map(f64::from).collect();
    let mut document = make(1);
    let keys = track("roll", "linear", &frames, &frames, &[]);
    let camera = document
        .scene
        .add(Node::new("eye", Kind::Camera(Camera::default())))
        .unwrap();
    document.scene.set_track(camera, keys).unwrap();
    let text = document.to_toml().unwrap();
    let start = std::time::Instant::now();
    assert_eq!(SceneDocument::from_toml(&text).unwrap(), document);
    println!(
        "1,000,000 keys {:.0} ms",
        1e3 * start.elapsed().as_secs_f64()
    );
}

/// The car of the examples drives, and the camera looks at it.
#[test]
fn the_example_plays() {
    let document = SceneDocument::load("examples/car.vid".as_ref()).unwrap();
    let scene = &document.scene;
    assert_eq!(scene.frame_range(), (1.0, 76.0));
    let [car, camera] = ["car", "camera"].map(|name| scene.find(name).unwrap());
    let mut states = vec![vides::scene::NodeState::default(); scene.nodes().len()];
    for frame in 1..200 {
        let mut warnings = vides::scene::Warnings::default();
        scene
            .evaluate(f64::from(frame), &mut states, &mut warnings)
            .unwrap();
        assert!(warnings.first().is_none());
        let place = DVec3::from_slice(&states[car].matrix[12..15]);
        let pose = states[camera].pose;
        let view = (place - DVec3::from(pose.vrp)).normalize();
        assert!((view - DVec3::from(pose.vpn)).length() < 1e-12);
    }
    let back = SceneDocument::from_toml(&document.to_toml().unwrap()).unwrap();
    assert_eq!(back, document);
}
