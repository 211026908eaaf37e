//! What the marks in `extras.vides` of nodes are for: files of ours read with them and without.

use serde_json::Value;
use vides_document::SceneDocument;
use vides_engine::scene::{Channel, Kind, Node};

use super::tests::{everything, read, taken, written};
use super::tests_far::far;
use crate::{As, Options, Source, import};

fn found<'a>(document: &'a SceneDocument, name: &str) -> &'a Node {
    let scene = &document.scene;
    &scene.nodes()[scene.find(name).unwrap()]
}

fn marked(document: &SceneDocument) -> String {
    String::from_utf8(written(document, "gltf", &Options::default()).0).unwrap()
}

/// As another program would pass it on that keeps no extras.
fn unmarked(document: &SceneDocument) -> String {
    let mut json: Value = serde_json::from_str(&marked(document)).unwrap();
    for node in json["nodes"].as_array_mut().unwrap() {
        node.as_object_mut().unwrap().remove("extras");
    }
    json.to_string()
}

/// A camera that carries a lamp is written as two nodes. Read as two, its keys are no longer those of
/// the camera, so that no path can be made of them.
#[test]
fn a_camera_that_carries_others_needs_its_mark() {
    let text = "version = 1\n[[node]]\nname = \"eye\"\nkind = \"camera\"\n\
                [[node.track]]\nchannel = \"position\"\ninterpolation = \"linear\"\n\
                frames = [1.0, 11.0, 21.0]\nvalues = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\n\
                [[node]]\nname = \"lamp\"\nkind = \"light\"\nlight = \"point\"\nparent = \"eye\"\n";
    let was = SceneDocument::from_toml(text).unwrap();
    let options = Options {
        as_: Some(As::Path),
        ..Options::default()
    };
    let as_path = |text: String| {
        import(&Source::of_bytes("a.gltf", text.into()), None, &options)
            .map(|imported| imported.document)
    };
    let is = taken(&marked(&was)).document;
    let eye = found(&is, "eye");
    assert!(matches!(eye.kind, Kind::Camera(_)));
    assert_eq!(
        eye.keys().track(&Channel::Position).unwrap().frames().len(),
        3
    );
    assert_eq!(is.scene.nodes().len(), 2);
    let path = as_path(marked(&was)).unwrap();
    let path = found(&path, "eye").path().unwrap().path().clone();
    assert!(path.points.len() >= 3);

    let is = taken(&unmarked(&was)).document;
    assert_eq!(found(&is, "eye").kind, Kind::Group);
    let camera = &is.scene.nodes()[is.scene.shown_camera().unwrap()];
    assert!(camera.keys().tracks().is_empty() && camera.name != "eye");
    let path = as_path(unmarked(&was));
    let moves = path.is_ok_and(|made| {
        let camera = &made.scene.nodes()[made.scene.shown_camera().unwrap()];
        let points = camera.path().map(|follow| follow.path().points.clone());
        points.is_some_and(|points| points.len() >= 3)
    });
    assert!(!moves);
}

/// An object with a pivot is written as two nodes. Read as two, the named one has neither mesh nor
/// pivot, nor the keys of its shapes.
#[test]
fn an_object_with_a_pivot_needs_its_mark() {
    let was = everything();
    let [is, split] = [marked(&was), unmarked(&was)].map(|text| taken(&text).document);
    let arm = |document: &SceneDocument| {
        let arm = found(document, "arm").clone();
        let weights = arm.keys().track(&Channel::Weights).is_some();
        (
            matches!(arm.kind, Kind::Object(_)),
            arm.pivot.length() > 0.3,
            weights,
        )
    };
    assert_eq!(arm(&was), (true, true, true));
    assert_eq!(arm(&is), (true, true, true));
    assert_eq!(arm(&split), (false, false, false));
}

/// What moves content far away is a node. Read as one, each further file has one more.
#[test]
fn far_content_needs_its_marks() {
    let was = far("y");
    let counts = |text: fn(&SceneDocument) -> String| {
        let mut document = read(text(&was).into()).unwrap().document;
        let mut counts = vec![document.scene.nodes().len()];
        for _ in 0..2 {
            document = read(text(&document).into()).unwrap().document;
            counts.push(document.scene.nodes().len());
        }
        counts
    };
    assert_eq!(counts(marked), [was.scene.nodes().len(); 3]);
    let grown = counts(unmarked);
    assert!(grown.is_sorted_by(|a, b| a < b), "{grown:?}");
}
