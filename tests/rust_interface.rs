//! What a Rust program does with the library: its examples, and other crates' types.

use std::process::Command;

fn example(name: &str, arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--locked", "--offline", "--example", name])
        .args(if cfg!(feature = "window") {
            &["--all-features"][..]
        } else {
            &[]
        })
        .arg("--")
        .args(arguments)
        .output()
        .expect("cargo");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{name}: {told}");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn a_flight_is_written() {
    let text = example("flight", &[]);
    assert_eq!(text.lines().count(), 200);
    // 2·atan(12/35), and the first place in the matrix's last column.
    let first = text.lines().next().expect("a pose");
    assert!(first.starts_with("1 0.661 ["), "{first}");
    assert!(first.ends_with("4.0, 0.0, 1.0, 1.0]"), "{first}");
}

#[test]
fn a_recording_becomes_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("helix.vid");
    let text = example("recording", &[file.to_str().expect("a name")]);
    assert!(text.starts_with("250 poses became "), "{text}");
    let document = vides::document::Document::load(&file).expect("a path");
    assert_eq!(document.sampler().expect("poses").frame_count(), 500);
}

#[cfg(feature = "serde")]
#[test]
fn poses_go_through_serde() {
    let pose = vides::path::Pose {
        vrp: [1.0, 2.0, 3.0],
        vpn: [0.0, 0.0, -1.0],
        vup: [0.0, 1.0, 0.0],
        zoom: 24.0,
    };
    let text = serde_json::to_string(&pose).expect("text");
    assert_eq!(
        text,
        r#"{"vrp":[1.0,2.0,3.0],"vpn":[0.0,0.0,-1.0],"vup":[0.0,1.0,0.0],"zoom":24.0}"#
    );
    assert_eq!(
        serde_json::from_str::<vides::path::Pose>(&text).expect("a pose"),
        pose
    );
}

#[cfg(feature = "mint")]
#[test]
fn vectors_go_into_other_crates() {
    let pose = vides::path::Pose {
        vrp: [1.0, 2.0, 3.0],
        vpn: [0.0, 0.0, 1.0],
        vup: [0.0, 1.0, 0.0],
        zoom: 24.0,
    };
    let point: mint::Point3<f64> = pose.position().into();
    assert_eq!([point.x, point.y, point.z], pose.vrp);
    let turn: mint::Quaternion<f64> = pose.rotation().into();
    assert_eq!((turn.s.abs(), turn.v.x), (1.0, 0.0));
}
