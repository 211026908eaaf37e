//! Cameras and lights that look at something.

use glam::{DQuat, DVec3};

use super::tests::{camera, group, states, track};
use super::*;
use crate::path::Pose;
use crate::scene::Light;

/// A camera at `eye` that aims at a group at `target`.
pub(super) fn looking(eye: DVec3, target: DVec3) -> Scene {
    let mut scene = Scene::new();
    let mut car = group("car", None);
    car.rest.position = target;
    let car = scene.add(car).unwrap();
    let mut camera = camera("camera");
    camera.rest.position = eye;
    camera.aim = Some(car);
    scene.add(camera).unwrap();
    scene
}

#[test]
fn a_camera_looks_at_the_pivot_of_what_it_aims_at() {
    let mut scene = looking(DVec3::new(3.0, 1.0, 2.0), DVec3::new(0.0, 4.0, 1.0));
    let mut car = scene.nodes()[0].clone();
    car.pivot = DVec3::new(0.5, 0.0, 0.0);
    car.rest.rotation = DQuat::from_rotation_y(2.0);
    scene.set_node(0, &car).unwrap();
    let mut eye = scene.nodes()[1].clone();
    eye.rest.roll = 30.0;
    scene.set_node(1, &eye).unwrap();
    let state = &states(&scene, 1.0)[1];
    let view = (DVec3::new(0.5, 4.0, 1.0) - DVec3::new(3.0, 1.0, 2.0)).normalize();
    assert!((DVec3::from_array(state.pose.vpn) - view).length() < 1e-15);
    let roll = crate::math::orientation::roll_from_up(view, state.pose.vup.into());
    assert!((roll.to_degrees() - 30.0).abs() < 1e-12);
    // The matrix says the same: z is the view, y is up.
    assert!((DVec3::from_slice(&state.matrix[8..11]) - view).length() < 1e-14);
    assert!(
        (DVec3::from_slice(&state.matrix[4..7]) - DVec3::from_array(state.pose.vup)).length()
            < 1e-14
    );
    // Half the weight: half the turn.
    scene
        .set_track(1, track("aim_weight", "step", &[1.0, 2.0], &[0.5, 0.0]))
        .unwrap();
    let half = states(&scene, 1.0)[1].pose;
    let own = states(&scene, 2.0)[1].pose;
    let q = |pose: &Pose| {
        crate::math::orientation::quaternion_from_view(pose.vpn.into(), pose.vup.into())
    };
    let whole = crate::math::quaternion::slerp_shortest(q(&own), q(&state.pose), 0.5);
    assert!(q(&half).dot(whole).abs() > 1.0 - 1e-14);
    let roll = DQuat::from_rotation_z(30_f64.to_radians());
    assert!(q(&own).dot(roll).abs() > 1.0 - 1e-14);
}

#[test]
fn where_there_is_no_direction_the_last_one_holds() {
    // The target stands in the camera from frame 10 to 15, comes from +x and
    // goes to +z.
    let mut scene = looking(DVec3::ZERO, DVec3::ZERO);
    let way = [1.0, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2, 1.0];
    scene
        .set_track(
            0,
            track("position", "linear", &[0.0, 10.0, 15.0, 25.0], &way),
        )
        .unwrap();
    let before = DVec3::new(1.0, 0.2, 0.0).normalize();
    for frame in [10.0, 12.0, 15.0] {
        let view = DVec3::from_array(states(&scene, frame)[1].pose.vpn);
        assert!((view - before).length() < 1e-9, "{frame}: {view}");
    }
    let after = DVec3::new(0.0, 0.2, 1.0).normalize();
    let view = DVec3::from_array(states(&scene, 16.0)[1].pose.vpn);
    assert!((view - after).length() < 1e-12);
    // From the start on without a direction: the next one.
    scene
        .set_track(0, track("position", "linear", &[15.0, 25.0], &way[6..]))
        .unwrap();
    let view = DVec3::from_array(states(&scene, 12.0)[1].pose.vpn);
    assert!((view - after).length() < 1e-6, "{view}");
    // Right overhead the yaw is the one before: up points where it came from.
    let over = [1.0, 1.0, 0.5, -1.0, 1.0, -0.5];
    scene
        .set_track(0, track("position", "linear", &[0.0, 20.0], &over))
        .unwrap();
    let pose = states(&scene, 10.0)[1].pose;
    assert!((DVec3::from_array(pose.vpn) - DVec3::Y).length() < 1e-12);
    let level = DVec3::new(-1.0, 0.0, -0.5).normalize();
    assert!(
        (DVec3::from_array(pose.vup) - level).length() < 1e-5,
        "{:?}",
        pose.vup
    );
    // Nothing ever: its own.
    let scene = looking(DVec3::ONE, DVec3::ONE);
    assert_eq!(states(&scene, 3.0)[1].pose.vpn, [0.0, 0.0, 1.0]);
}

#[test]
fn poses_are_the_matrix_made_orthonormal() {
    let mut scene = Scene::new();
    let mut stretched = group("stretched", None);
    stretched.rest.scale = DVec3::new(-2.0, 1.0, 5.0);
    stretched.rest.rotation = DQuat::from_rotation_y(0.3);
    scene.add(stretched).unwrap();
    let mut lamp = Node::new("lamp", Kind::Light(Light::Spot));
    lamp.parent = Some(0);
    lamp.rest.rotation = DQuat::from_rotation_x(0.7) * DQuat::from_rotation_y(0.4);
    scene.add(lamp).unwrap();
    let state = &states(&scene, 1.0)[1];
    let column = |k: usize| DVec3::from_slice(&state.matrix[4 * k..]);
    let (view, up) = (DVec3::from(state.pose.vpn), DVec3::from(state.pose.vup));
    assert!((view - column(2).normalize()).length() < 1e-14);
    let want = (column(1) - view * view.dot(column(1))).normalize();
    assert!((up - want).length() < 1e-14);
    // A scale of 0 still gives finite numbers.
    let mut flat = scene.nodes()[0].clone();
    flat.rest.scale = DVec3::ZERO;
    scene.set_node(0, &flat).unwrap();
    let pose = states(&scene, 1.0)[1].pose;
    assert!(DVec3::from(pose.vpn).is_normalized() && DVec3::from(pose.vup).is_normalized());
}

/// Work for each camera that looks for its last direction does not grow with the scene: eight
/// times as many take as long as eight times few, not eight times longer.
#[test]
fn a_chain_of_cameras_at_one_place_costs_what_it_holds() {
    let time = |count: usize, hanging: bool, times: usize| {
        let mut scene = Scene::new();
        let mut last = None;
        for at in 0..count {
            let mut node = camera(&format!("camera {at}"));
            node.aim = last;
            let mut here = scene.add(node).unwrap();
            if hanging {
                let mut group = Node::new(&format!("group {at}"), Kind::Group);
                group.parent = Some(here);
                here = scene.add(group).unwrap();
            }
            last = Some(here);
        }
        // The processor's time of this thread: others may be busy.
        let used = || {
            let line = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
            line.split(' ').next().unwrap().parse::<u64>().unwrap()
        };
        let start = used();
        for _ in 0..times {
            states(&scene, 1.0);
        }
        (used() - start) as f64
    };
    for (hanging, count) in [(false, 2_000), (true, 250)] {
        let (few, many) = (time(count, hanging, 80), time(8 * count, hanging, 10));
        assert!(many < 3.0 * few, "{hanging}: {few} ns and {many} ns");
    }
}
