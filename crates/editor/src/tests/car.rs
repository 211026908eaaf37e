//! The scene of `examples/car.vid`, made from a new document by mouse and keyboard.

use std::path::Path;

use vides_engine::scene::{Channel, Kind, NodeState, Scene, Warnings};

use super::hands::Hands;
use super::*;

/// A mesh of the file as an OBJ: as a modeller would have written it.
fn obj(scene: &Scene, name: &str, file: &Path) {
    use std::fmt::Write;

    let node = scene.find(name).unwrap();
    let Kind::Object(object) = &scene.nodes()[node].kind else {
        panic!("{name} is an object")
    };
    let mesh = object.mesh();
    let mut text = String::new();
    for p in &mesh.points {
        writeln!(text, "v {} {} {}", p.x, p.y, p.z).unwrap();
    }
    for &[a, b] in &mesh.lines {
        writeln!(text, "l {} {}", a + 1, b + 1).unwrap();
    }
    for &[a, b, c] in &mesh.triangles {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
    }
    std::fs::write(file, text).unwrap();
}

/// The turn about the vertical of a quaternion (w, 0, y, 0) in degrees, as precise as it is.
fn yaw(w: f64, y: f64) -> String {
    (2.0 * y.atan2(w)).to_degrees().to_string()
}

#[test]
#[expect(clippy::too_many_lines)] // told in one piece
fn the_car_is_made_by_hand() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/car.vid");
    let made = Document::load_scene(&example).unwrap().0.scene().unwrap();
    let folder = tempfile::tempdir().unwrap();
    for name in ["body", "wheel front left", "arm", "forearm", "hand"] {
        obj(&made, name, &folder.path().join(format!("{name}.obj")));
    }
    let texts = Language::English.texts();
    let (menu, node, time) = (&texts.menu, &texts.node, &texts.timeline);
    let mut hands = Hands::new(options(Language::English));
    let turn = node.yaw;

    hands.add(menu.add_group);
    hands.rename("car");
    hands.object(folder.path(), "body.obj");
    hands.choose(node.parent_name, "car");
    hands.place(["0", "0.06", "0"]);
    hands.numbers(node.colour, ["R", "G", "B"], ["0.7", "0.1", "0.1"]);

    hands.object(folder.path(), "wheel front left.obj");
    hands.choose(node.parent_name, "car");
    hands.place(["0.07", "0.03", "0.09"]);
    hands.diamond(node.rotation);
    hands.track(&Channel::Rotation, &[time.euler_linear]);
    hands.frame(26);
    hands.number(node.pitch, "1440");
    hands.track(&Channel::Rotation, &[time.after, time.goes_on]);
    for (name, place) in [
        ("wheel front right", ["-0.07", "0.03", "0.09"]),
        ("wheel rear left", ["0.07", "0.03", "-0.09"]),
        ("wheel rear right", ["-0.07", "0.03", "-0.09"]),
    ] {
        hands.select("wheel front left");
        hands.key(Modifiers::CTRL, Key::D);
        hands.rename(name);
        hands.place(place);
    }

    hands.frame(1);
    hands.add(menu.add_light);
    hands.rename("headlight left");
    hands.choose(node.parent_name, "body");
    hands.place(["0.04", "0.03", "0.141"]);
    hands.click(node.spot);
    hands.number(node.intensity, "2");
    hands.number(&format!("{} {}", node.cone, node.inner), "15");
    hands.number(&format!("{} {}", node.cone, node.outer), "25");
    hands.select("headlight left");
    hands.key(Modifiers::CTRL, Key::D);
    hands.rename("headlight right");
    hands.place(["-0.04", "0.03", "0.141"]);

    hands.object(folder.path(), "arm.obj");
    hands.place(["0.4", "0", "-0.4"]);
    hands.numbers(node.colour, ["R", "G", "B"], ["0.8", "0.7", "0.1"]);
    hands.object(folder.path(), "forearm.obj");
    hands.choose(node.parent_name, "arm");
    hands.place(["0", "0.25", "0"]);
    hands.numbers(node.colour, ["R", "G", "B"], ["0.8", "0.7", "0.1"]);
    hands.frame(1);
    hands.object(folder.path(), "hand.obj");
    hands.choose(node.parent_name, "forearm");
    hands.place(["0", "0.2", "0"]);
    hands.numbers(node.pivot, ["x", "y", "z"], ["0", "0.02", "0"]);
    hands.diamond(node.rotation);
    for (frame, turned) in [
        (38, yaw(0.315322, 0.948985)),
        (76, yaw(0.801144, -0.598472)),
    ] {
        hands.frame(frame);
        hands.number(turn, &turned);
        if frame == 38 {
            hands.key_to(&Channel::Rotation, "1.5"); // seconds: frame 38.5
        }
    }
    hands.track(&Channel::Rotation, &[time.after, time.back_and_forth]);
    hands.frame(1);
    hands.select("forearm");
    hands.diamond(node.rotation);
    hands.track(&Channel::Rotation, &[time.euler_catmull_rom]);
    for (frame, bent) in [(1, "20"), (26, "-30"), (51, "45"), (76, "20")] {
        hands.frame(frame);
        hands.number(node.pitch, bent);
    }
    hands.track(&Channel::Rotation, &[time.after, time.repeats]);

    hands.add(menu.add_light);
    hands.rename("sun");
    hands.place(["0", "0", "0"]);
    hands.click(node.directional);
    hands.number(node.intensity, "0.8");
    hands.number(node.pitch, &yaw(0.9, 0.4));

    hands.select("car");
    let ways = [
        (1, ["-0.8", "0", "-0.3"], yaw(0.92388, 0.382683)),
        (26, ["-0.3", "0", "0.2"], yaw(0.773342, 0.633989)),
        (51, ["0.2", "0", "-0.1"], yaw(0.738423, 0.674338)),
        (76, ["0.8", "0", "0.3"], yaw(0.881675, 0.471858)),
    ];
    for (frame, place, turned) in ways {
        hands.frame(frame);
        if frame == 1 {
            hands.diamond("Position");
            hands.diamond(node.rotation);
        }
        hands.place(place);
        hands.number(turn, &turned);
    }
    hands.track(&Channel::Position, &[time.catmull_rom]);
    hands.track(&Channel::Rotation, &[time.catmull_rom]);

    hands.frame(1);
    hands.select("camera");
    hands.click(node.node_tab);
    hands.click(node.none);
    hands.choose(node.aim_name, "car");
    for channel in ["Position", node.zoom, node.camera_roll] {
        hands.diamond(channel);
    }
    for (frame, place, zoom, roll) in [
        (1, ["-0.4", "0.5", "1.4"], "24", "0"),
        (38, ["0", "0.35", "1.1"], "40", "10"),
        (76, ["0.6", "0.6", "1.5"], "24", "0"),
    ] {
        hands.frame(frame);
        hands.place(place);
        hands.number(node.zoom, zoom);
        hands.number(node.camera_roll, roll);
    }
    hands.track(&Channel::Position, &[time.cubic]);
    hands.track(&Channel::Zoom, &[time.ramp]);
    hands.track(&Channel::Roll, &[time.sine]);
    // As docs/reference/scene.md tells it.
    assert_eq!(hands.actions, 226);

    let scene = hands.scene();
    assert_eq!(scene.nodes().len(), made.nodes().len());
    for step in 0..=150 {
        let frame = 1.0 + 0.5 * f64::from(step);
        for of in made.nodes() {
            let state = |scene: &Scene| -> NodeState {
                let at = scene.find(&of.name).unwrap();
                let mut states = vec![NodeState::default(); scene.nodes().len()];
                let warnings = &mut Warnings::default();
                scene.evaluate(frame, &mut states, warnings).unwrap();
                states[at]
            };
            let numbers = |state: NodeState| {
                let pose = state.pose;
                let looks = [pose.vrp, pose.vpn, pose.vup];
                let light = [state.intensity, pose.zoom, f64::from(state.visible)];
                let all = [&state.matrix[..], looks.as_flattened(), &state.colour];
                [&all.concat()[..], &state.cone, &light].concat()
            };
            let (ours, file) = (numbers(state(&scene)), numbers(state(&made)));
            for (at, (ours, file)) in ours.iter().zip(file).enumerate() {
                let off = (ours - file).abs();
                assert!(off < 1e-9, "{}, number {at}, frame {frame}: {off}", of.name);
            }
        }
    }
}
