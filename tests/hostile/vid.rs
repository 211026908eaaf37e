//! What any bytes at all may do as a `.vid` file. Used by the tests and, by
//! path, by the fuzzer in `fuzz/`, so that both ask the same.

use vides::document::{Document, SceneDocument};
use vides::error::{ErrorKind, TooMany};
use vides::path::{Pose, Sampler};
use vides::scene::{Kind, NodeState, Warnings};

/// Frames that are looked at, from each end of the sequence.
const LOOKED_AT: usize = 64;

/// Loads bytes as a file. They are refused with one sentence, or they give a
/// document that is in order, can be saved and loaded without a bit changing,
/// and yields poses.
///
/// # Panics
/// If any of that does not hold.
pub(crate) fn check(bytes: &[u8]) {
    check_scene(bytes);
    let mut reader = bytes;
    let document = match Document::load_from(&mut reader, "a.vid") {
        Ok(document) => document,
        Err(error) => return check_refusal(bytes, &error),
    };
    document.path().check().expect("a path in order");
    document
        .info()
        .check(document.path().space)
        .expect("what a file says besides");
    let text = document.to_toml().expect("a text");
    let again = Document::from_toml(&text)
        .unwrap_or_else(|error| panic!("saved and then refused: {error}\n{text}"));
    assert_eq!(content(&again), content(&document), "{text}");
    assert_eq!(again.to_toml().expect("a text"), text);
    match document.sampler() {
        Ok(sampler) => check_poses(sampler),
        Err(vides::Error::Engine(error)) => assert_eq!(error, TooMany::Frames.into()),
        Err(error) => panic!("a path in order gives no poses: {error}"),
    }
}

/// The same for a scene: refused with one sentence, or saved and loaded without a
/// bit changing, with finite states at any frame.
fn check_scene(bytes: &[u8]) {
    let mut reader = bytes;
    let document = match SceneDocument::load_from(&mut reader, "a.vid") {
        Ok(document) => document,
        // A path that is too long is none for a node.
        Err(error) if error.kind() == ErrorKind::Limit => return,
        Err(error) => return check_refusal(bytes, &error),
    };
    let text = document.to_toml().expect("a text");
    let again = SceneDocument::from_toml(&text)
        .unwrap_or_else(|error| panic!("saved and then refused: {error}\n{text}"));
    assert_eq!(again, document, "{text}");
    assert_eq!(again.to_toml().expect("a text"), text);
    // The window keeps all of it, too.
    let (whole, _) = Document::scene_from_toml(&text, "".as_ref()).expect("a scene to edit");
    assert_eq!(whole.scene().expect("a scene"), document.scene, "{text}");
    assert_eq!(whole.to_toml().expect("a text"), text);
    let scene = &document.scene;
    let mut states = vec![NodeState::default(); scene.nodes().len()];
    let (first, last) = scene.frame_range();
    let middle = first + (last - first) / 2.0;
    for frame in [-1e9, first, middle, last, last + 0.5, 1e9] {
        let mut warnings = Warnings::default();
        scene
            .evaluate(frame, &mut states, &mut warnings)
            .expect("states");
        for state in &states {
            let finite = |numbers: &[f64]| numbers.iter().all(|number| number.is_finite());
            assert!(finite(&state.matrix) && finite(&state.pose.vrp) && finite(&state.colour));
            assert!(finite(&state.pose.vpn) && finite(&state.pose.vup) && finite(&state.cone));
        }
        for node in 0..states.len() {
            if let Kind::Object(object) = &scene.nodes()[node].kind {
                let mut points = vec![Default::default(); object.mesh().points.len()];
                let done = scene.vertices(node, frame, &mut points, &mut warnings);
                done.expect("points");
            }
        }
    }
}

/// Everything of a document; `{:?}` tells 0 from −0 and gives every digit.
fn content(document: &Document) -> String {
    format!("{:?} {:?}", document.path(), document.info())
}

fn check_refusal(bytes: &[u8], error: &vides::Error) {
    let sentence = error.to_string();
    assert!(!sentence.chars().any(char::is_control), "{sentence:?}");
    let said = sentence.strip_prefix("a.vid: ").expect("the file's name");
    let number = said
        .strip_prefix("line ")
        .and_then(|rest| rest.split_once(": "))
        .and_then(|(number, _)| number.parse::<usize>().ok());
    let lines = 1 + bytes.iter().filter(|&&byte| byte == b'\n').count();
    assert!(
        number.is_some_and(|number| (1..=lines).contains(&number)),
        "{sentence} (of {lines} lines)"
    );
}

fn check_poses(sampler: &Sampler) {
    let frames = sampler.frame_count();
    let mut poses = vec![Pose::default(); frames.min(LOOKED_AT)];
    for first in [1, 1 + frames - poses.len()] {
        sampler.sample(first, &mut poses).expect("poses");
        for pose in &poses {
            let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let unit = |a: [f64; 3]| (dot(a, a) - 1.0).abs() < 2e-12;
            assert!(unit(pose.vpn) && unit(pose.vup), "{pose:?}");
            assert!(dot(pose.vpn, pose.vup).abs() < 1e-12, "{pose:?}");
            assert!(pose.vrp.iter().all(|x| x.is_finite()), "{pose:?}");
            assert!((1.0..=100.0).contains(&pose.zoom), "{pose:?}");
        }
    }
}
