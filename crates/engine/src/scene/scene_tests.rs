use glam::{DQuat, DVec3};
use proptest::prelude::*;

use super::aim_tests::looking;
use super::*;
use crate::path::{Pose, SupportPoint, Target, Timeline};
use crate::scene::{Camera, Extrapolation, Interpolation, NodeState, Object, Values, Warnings};

pub(super) fn group(name: &str, parent: Option<usize>) -> Node {
    Node {
        parent,
        ..Node::new(name, Kind::Group)
    }
}

pub(super) fn camera(name: &str) -> Node {
    Node::new(name, Kind::Camera(Camera::default()))
}

pub(crate) fn states(scene: &Scene, frame: f64) -> Vec<NodeState> {
    let mut states = vec![NodeState::default(); scene.nodes().len()];
    let mut warnings = Warnings::default();
    scene.evaluate(frame, &mut states, &mut warnings).unwrap();
    assert!(warnings.first().is_none());
    states
}

pub(crate) fn track(channel: &str, interpolation: &str, frames: &[f64], values: &[f64]) -> Track {
    Track::new(
        Channel::parse(channel).unwrap(),
        Interpolation::parse(interpolation).unwrap(),
        frames.to_vec(),
        values.to_vec(),
        Vec::new(),
    )
    .unwrap()
}

fn place(state: &NodeState) -> DVec3 {
    DVec3::from_slice(&state.matrix[12..15])
}

pub(super) fn from_nodes(nodes: Vec<Node>) -> String {
    Scene::from_nodes(nodes).unwrap_err().1.to_string()
}

pub(super) fn said<T: std::fmt::Debug>(result: Result<T>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn links_that_lead_nowhere_or_round_are_refused() {
    let mut scene = Scene::new();
    let a = scene.add(group("a", None)).unwrap();
    let b = scene.add(group("b", Some(a))).unwrap();
    assert_eq!(
        said(scene.add(group("a", None))),
        "there is a node \"a\" already"
    );
    assert!(
        said(scene.add(group("c", Some(7)))).contains("node \"c\": parent: there is no node 7")
    );
    assert!(said(scene.add(group("", None))).contains("needs a name"));
    assert!(said(scene.add(group("x\n", None))).contains("control characters"));
    let round = Node {
        parent: Some(b),
        ..Node::default()
    };
    assert!(said(scene.set_node(a, &round)).contains("\"a\" cannot be in \"b\""));
    let own = Node {
        parent: Some(a),
        ..Node::default()
    };
    assert!(said(scene.set_node(a, &own)).contains("cannot be in itself"));
    assert!(from_nodes(vec![group("a", Some(1)), group("b", Some(0))]).contains("cannot be in"));
    let aims = Node {
        aim: Some(a),
        ..Node::default()
    };
    assert!(said(scene.set_node(b, &aims)).contains("only lights and cameras"));
    assert_eq!(scene.nodes()[0].parent, None);
    // A camera cannot look at what it carries.
    let eye = scene.add(camera("eye")).unwrap();
    let lamp = scene.add(group("lamp", Some(eye))).unwrap();
    let look = Node {
        aim: Some(lamp),
        ..camera("")
    };
    assert!(said(scene.set_node(eye, &look)).contains("\"eye\" cannot aim at what is in \"eye\""));
    assert_eq!(scene.nodes()[eye].aim, None);
    let thousand = (0..1000_usize).map(|k| group(&format!("{k:04}"), k.checked_sub(1)));
    assert!(from_nodes(thousand.collect()).contains("at most 256 levels"));
    let deep = (0..256_usize).map(|k| group(&format!("{k:04}"), k.checked_sub(1)));
    let mut deep = Scene::from_nodes(deep.collect()).unwrap();
    assert!(said(deep.add(group("one more", Some(255)))).contains("at most 256 levels"));
}

#[test]
fn a_node_goes_with_its_children() {
    let mut scene = Scene::new();
    let a = scene.add(group("a", None)).unwrap();
    let b = scene.add(group("b", Some(a))).unwrap();
    let c = scene.add(group("c", Some(b))).unwrap();
    let d = scene.add(group("d", None)).unwrap();
    for (name, aim) in [("e", c), ("f", d)] {
        let aims = Node {
            aim: Some(aim),
            ..camera(name)
        };
        scene.add(aims).unwrap();
    }
    scene.remove(b).unwrap();
    let names: Vec<_> = scene.nodes().iter().map(|node| &*node.name).collect();
    assert_eq!(names, ["a", "d", "e", "f"]);
    assert_eq!(
        (scene.nodes()[2].aim, scene.nodes()[3].aim),
        (None, Some(1))
    );
    assert_eq!(scene.find("f"), Some(3));
    assert_eq!(scene.find("b"), None);
    assert!(scene.remove(4).is_err());
    scene.set_name(0, "z").unwrap();
    assert!(scene.set_name(1, "z").is_err());
    assert_eq!(
        (scene.find("z"), scene.find("a"), scene.find("d")),
        (Some(0), None, Some(1))
    );
    states(&scene, 1.0);
}

#[test]
fn the_pivot_stays() {
    let mut scene = Scene::new();
    let mut node = group("arm", None);
    node.pivot = DVec3::new(1.0, 2.0, 3.0);
    node.rest.position = DVec3::new(5.0, 0.0, 0.0);
    node.rest.rotation = DQuat::from_rotation_z(1.0);
    node.rest.scale = DVec3::new(2.0, -3.0, 0.5);
    scene.add(node).unwrap();
    let world = states(&scene, 1.0)[0].world();
    let kept = world.transform_point3(DVec3::new(1.0, 2.0, 3.0));
    assert!((kept - DVec3::new(6.0, 2.0, 3.0)).length() < 1e-14);
}

#[test]
fn path_and_keys_do_not_both_move_a_node() {
    let mut scene = Scene::of_path(CameraPath::default()).unwrap();
    let position = track("position", "linear", &[1.0], &[0.0; 3]);
    assert!(said(scene.set_track(0, position.clone())).contains("follows a path"));
    scene
        .set_track(0, track("aim_weight", "linear", &[1.0], &[0.5]))
        .unwrap();
    scene.set_path(0, None).unwrap();
    scene.set_track(0, position).unwrap();
    let path = || FollowPath::new(CameraPath::default(), 1.0, Extrapolation::Hold).unwrap();
    assert!(said(scene.set_path(0, Some(path()))).contains("has a track of its position"));
    scene.remove_track(0, &Channel::Position).unwrap();
    scene.set_path(0, Some(path())).unwrap();
    let offset = FollowPath::new(CameraPath::default(), 1.0, Extrapolation::Offset);
    assert!(said(offset).contains("no repeat with offset"));
    assert!(FollowPath::new(CameraPath::default(), f64::NAN, Extrapolation::Hold).is_err());
    assert!(
        said(scene.set_track(0, track("intensity", "step", &[1.0], &[1.0])))
            .contains("a camera has no channel \"intensity\"")
    );
}

fn pose_near(got: &Pose, want: &Pose) -> bool {
    let both = [
        (got.vrp, want.vrp),
        (got.vpn, want.vpn),
        (got.vup, want.vup),
    ];
    let far = both
        .iter()
        .flat_map(|(a, b)| a.iter().zip(b))
        .map(|(a, b)| (a - b).abs());
    far.fold((got.zoom - want.zoom).abs(), f64::max) <= 1e-12
}

proptest! {
    #[test]
    fn a_node_on_a_path_has_the_paths_pose(
        points in prop::collection::vec(
            (prop::array::uniform3(-1.0..1.0f64), prop::array::uniform3(-1.0..1.0f64), -180.0..180.0f64, 1.0..100.0f64), 2..6),
        start in -100.0..100.0f64,
        shares in prop::collection::vec(0.0..1.0f64, 8),
        closed: bool,
    ) {
        // A view needs a direction.
        prop_assume!(points.iter().all(|(_, offset, _, _)| *offset != [0.0; 3]));
        let mut path = CameraPath { closed, ..CameraPath::default() };
        path.points = points.into_iter().map(|(position, offset, roll, zoom)| {
            let mut point = SupportPoint::new(position.into());
            point.orientations[0].target = Target::Relative(offset.into());
            point.orientations[0].roll = roll;
            point.orientations[0].zoom = zoom;
            point
        }).collect();
        let timeline = Timeline::new(&path).unwrap();
        let sampler = crate::path::Sampler::new(&path, &timeline).unwrap();
        let last = sampler.frame_count() as f64;
        let mut scene = Scene::of_path(path.clone()).unwrap();
        let follow = FollowPath::new(path, start, Extrapolation::Repeat).unwrap();
        scene.set_path(0, Some(follow)).unwrap();
        let (first, end) = scene.frame_range();
        prop_assert_eq!(first, start);
        // The sum in one order or the other.
        prop_assert!((end - (start + (last - 1.0))).abs() <= 1e-12 * last.max(100.0));
        for share in shares {
            let frame = start + share * (last - 1.0);
            // A frame that the sum of start and share has just passed the end by.
            let frame = frame.min(start + last - 1.0);
            let local = (frame - start + 1.0).clamp(1.0, last);
            let want = sampler.pose(local).unwrap();
            prop_assert!(pose_near(&states(&scene, frame)[0].pose, &want));
        }
        // At the seams of a repeat the last pose counts.
        let round = states(&scene, start + 2.0 * (last - 1.0))[0].pose;
        let end = sampler.pose(last).unwrap();
        // The seam itself may fall between two frames that can be told apart.
        let first = sampler.pose(1.0).unwrap();
        let seam = (0..3).all(|k| (round.vrp[k] - first.vrp[k]).abs() < 1e-6);
        prop_assert!(last < 2.0 || pose_near(&round, &end) || (start.fract() != 0.0 && seam));
    }
}

#[test]
fn another_parent_leaves_a_node_in_its_place() {
    let mut scene = Scene::new();
    let mut a = group("a", None);
    a.rest.position = DVec3::new(1.0, 2.0, 3.0);
    a.rest.rotation = DQuat::from_rotation_y(1.0);
    a.rest.scale = DVec3::splat(-2.0);
    let a = scene.add(a).unwrap();
    let mut b = group("b", None);
    b.rest.rotation = DQuat::from_rotation_x(2.0);
    b.rest.scale = DVec3::new(1.0, 1.0, 3.0);
    let b = scene.add(b).unwrap();
    let mut c = group("c", None);
    c.pivot = DVec3::new(0.1, 0.2, 0.3);
    c.rest.position = DVec3::new(-1.0, 0.0, 0.5);
    c.rest.scale = DVec3::new(1.0, -1.5, 2.0);
    c.rest.rotation = DQuat::from_rotation_z(0.4);
    let c = scene.add(c).unwrap();
    let before = states(&scene, 1.0)[c].matrix;
    let mut moved = scene.nodes()[c].clone();
    moved.parent = Some(a);
    scene.set_node(c, &moved).unwrap();
    let after = states(&scene, 1.0)[c].matrix;
    for (before, after) in before.iter().zip(after) {
        assert!((before - after).abs() < 1e-14);
    }
    let mut sheared = scene.nodes()[c].clone();
    sheared.parent = Some(b);
    assert!(said(scene.set_node(c, &sheared)).contains("would need a shear"));
    assert_eq!(scene.nodes()[c].parent, Some(a));
    scene
        .set_track(c, track("position", "linear", &[1.0], &[0.0; 3]))
        .unwrap();
    let mut away = scene.nodes()[c].clone();
    away.parent = None;
    assert!(said(scene.set_node(c, &away)).contains("moves in its parent's coordinates"));
}

#[test]
fn an_object_changes_by_its_tracks_as_by_single_values() {
    let mut scene = Scene::new();
    let node = scene
        .add(Node::new("flag", Kind::Object(Object::default())))
        .unwrap();
    let points: Vec<_> = (0..50)
        .map(|k| DVec3::new(f64::from(k % 10), f64::from(k / 10), 1.0))
        .collect();
    let mesh = Mesh {
        points: points.clone(),
        colours: vec![[10, 20, 30]; 50],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    scene.set_mesh(node, mesh).unwrap();
    let twist = Deformation::new("twist", &[0.0, 10.0]).unwrap();
    scene.add_deformation(node, twist, None).unwrap();
    let bend = Deformation::new("bend", &[2.0, 0.0]).unwrap();
    let at = scene.add_deformation(node, bend, None).unwrap();
    scene
        .set_track(
            node,
            track("deformation.1.angle", "linear", &[0.0, 10.0], &[0.0, 90.0]),
        )
        .unwrap();
    let vertices = |scene: &Scene, frame| {
        let mut out = vec![DVec3::ZERO; 50];
        scene
            .vertices(node, frame, &mut out, &mut Warnings::default())
            .unwrap();
        out
    };
    let mut want = points.clone();
    let bounds = Bounds::of(&points);
    Deformation::new("twist", &[0.0, 10.0])
        .unwrap()
        .apply(&bounds, &mut want);
    Deformation::new("bend", &[2.0, 45.0])
        .unwrap()
        .apply(&bounds, &mut want);
    assert_eq!(vertices(&scene, 5.0), want);
    assert!(
        said(scene.set_track(node, track("deformation.1.a", "step", &[1.0], &[1.0])))
            .contains("the deformation \"bend\" has no \"a\"; it has: angle")
    );
    assert!(
        said(scene.set_track(node, track("deformation.2.a", "step", &[1.0], &[1.0])))
            .contains("there is no deformation 2 among 2, counted from 0")
    );
    // The second one becomes the first, its track with it.
    scene.remove_deformation(node, 0).unwrap();
    let mut want = points.clone();
    Deformation::new("bend", &[2.0, 45.0])
        .unwrap()
        .apply(&bounds, &mut want);
    assert_eq!(vertices(&scene, 5.0), want);
    scene.remove_deformation(node, at - 1).unwrap();
    assert!(scene.nodes()[node].keys().tracks().is_empty());
    assert_eq!(vertices(&scene, 5.0), points);
    // Shapes: a new one begins with 0, in a track too.
    let shape = |name: &str, z: f64| Shape {
        name: name.to_owned(),
        points: points.iter().map(|p| p.with_z(z)).collect(),
        colours: vec![[110, 20, 30]; 50],
    };
    scene.add_shape(node, shape("high", 3.0)).unwrap();
    scene
        .set_track(node, track("weights", "linear", &[0.0, 10.0], &[0.0, 1.0]))
        .unwrap();
    scene.add_shape(node, shape("low", -3.0)).unwrap();
    assert_eq!(vertices(&scene, 5.0)[7].z, 2.0);
    let mut warnings = Warnings::default();
    let colours = scene.vertex_colours(node, 5.0, &mut warnings).unwrap();
    assert_eq!(colours[3], [60, 20, 30]);
    assert_eq!(
        scene
            .value(node, &Channel::Weights, 5.0, &mut warnings)
            .unwrap(),
        [0.5, 0.0]
    );
    let few = Shape {
        points: points[..49].to_vec(),
        ..shape("few", 0.0)
    };
    assert!(
        said(scene.add_shape(node, few)).contains("the shape \"few\" has 49 points, the mesh 50")
    );
    let wrong = Mesh {
        triangles: vec![[0, 1, 50]],
        points: points.clone(),
        ..Mesh::default()
    };
    assert!(said(scene.set_mesh(node, wrong)).contains("there is no point 50 among 50"));
}

#[test]
fn single_states_are_those_of_the_whole_scene() {
    let mut scene = looking(DVec3::ZERO, DVec3::X);
    let arm = scene.add(group("arm", Some(0))).unwrap();
    scene
        .set_track(
            0,
            track(
                "position",
                "catmull-rom",
                &[1.0, 4.0, 9.0],
                &[1.0, 0.0, 0.0, 0.0, 2.0, 1.0, 3.0, 3.0, 3.0],
            ),
        )
        .unwrap();
    scene
        .set_track(
            arm,
            track("value:heat:2", "linear", &[1.0, 3.0], &[0.0, 1.0, 2.0, 5.0]),
        )
        .unwrap();
    scene
        .set_track(arm, track("visible", "step", &[1.0, 3.0], &[1.0, 0.0]))
        .unwrap();
    for node in 0..3 {
        let mut some = [NodeState::default(); 20];
        scene
            .sample(node, 1.0, 0.5, &mut some, &mut Warnings::default())
            .unwrap();
        for (at, state) in some.iter().enumerate() {
            assert_eq!(*state, states(&scene, 1.0 + 0.5 * at as f64)[node]);
        }
    }
    let value = |name: &str, frame| {
        scene.value(
            arm,
            &Channel::parse(name).unwrap(),
            frame,
            &mut Warnings::default(),
        )
    };
    assert_eq!(value("value:heat", 2.0).unwrap(), [1.0, 3.0]);
    assert!(said(value("value:cold", 2.0)).contains("no channel"));
    assert_eq!(value("visible", 3.0).unwrap(), [0.0]);
    assert_eq!(scene.frame_range(), (1.0, 9.0));
    assert_eq!(
        (
            states(&scene, 2.0)[arm].visible,
            states(&scene, 3.0)[arm].visible
        ),
        (1, 0)
    );
    assert!(place(&states(&scene, 9.0)[arm]).distance(DVec3::splat(3.0)) < 1e-15);
}

#[test]
fn a_host_function_that_is_missing_leaves_the_rest() {
    let mut scene = looking(DVec3::ZERO, DVec3::X);
    scene
        .set_track(
            0,
            track(
                "position",
                "host:nowhere",
                &[1.0, 2.0],
                &[1.0, 0.0, 0.0, 0.0, 0.0, 1.0],
            ),
        )
        .unwrap();
    let mut states = vec![NodeState::default(); 2];
    let mut warnings = Warnings::default();
    scene.evaluate(1.5, &mut states, &mut warnings).unwrap();
    let (node, message) = warnings.first().unwrap();
    assert_eq!(node, 0);
    assert_eq!(
        message.to_string(),
        "channel \"position\": no interpolation \"host:nowhere\" is registered"
    );
    assert_eq!(states[1].pose.vpn, [1.0, 0.0, 0.0]);

    // Of a camera that only aims there it is told, too.
    let mut warnings = Warnings::default();
    let states = &mut states[..1];
    scene.sample(1, 1.5, 1.0, states, &mut warnings).unwrap();
    assert_eq!(warnings.first().map(|(node, _)| node), Some(0));
}

#[test]
fn markers_and_pins_are_kept_together() {
    let mut scene = Scene::of_path(CameraPath::default()).unwrap();
    assert!(said(scene.pin(0, 1, Some("meet"))).contains("no marker \"meet\""));
    scene.set_marker("meet", 50.0).unwrap();
    scene.set_marker("meet", 60.0).unwrap();
    scene.set_marker("late", 90.5).unwrap();
    assert!(scene.set_marker("never", f64::NAN).is_err());
    assert!(said(scene.pin(0, 2, Some("meet"))).contains("no point 2 among 2"));
    scene.pin(0, 1, Some("late")).unwrap();
    scene.pin(0, 1, Some("meet")).unwrap();
    let before = scene.clone();
    assert!(said(scene.pin(0, 0, Some("late"))).contains("must come after"));
    assert_eq!(scene, before);
    scene.pin(0, 1, Some("late")).unwrap();
    scene.pin(0, 0, Some("meet")).unwrap();
    assert_eq!(scene.pins().len(), 2);
    assert_eq!(scene.markers()[1].frame, 60.0);
    scene.remove_marker("late");
    assert_eq!(scene.pins()[0].point, 0);
    scene.pin(0, 0, None).unwrap();
    assert!(scene.pins().is_empty());
}

#[test]
fn numbers_that_nobody_can_compute_with_are_named() {
    let mut nodes = vec![group("0", None)];
    for k in 1..60_usize {
        nodes.push(group(&k.to_string(), Some(k - 1)));
    }
    for node in &mut nodes {
        node.rest.scale = DVec3::splat(1e9);
    }
    let scene = Scene::from_nodes(nodes).unwrap();
    let mut states = vec![NodeState::default(); 60];
    let mut warnings = Warnings::default();
    scene.evaluate(1.0, &mut states, &mut warnings).unwrap();
    assert!(
        warnings
            .first()
            .unwrap()
            .1
            .to_string()
            .contains("too far away or too large")
    );
    assert!(
        states
            .iter()
            .all(|state| state.matrix.iter().all(|x| x.is_finite()))
    );
    let mut wrong = group("x", None);
    wrong.rest = Values {
        rotation: DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0),
        ..Values::default()
    };
    assert!(said(Scene::new().add(wrong)).contains("node \"x\": a rotation"));
}
