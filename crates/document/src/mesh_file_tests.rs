//! Tests of [`super`].

use std::fs;

use super::*;
use crate::references::trusting;
use crate::{Document, Edit};

const PYRAMID: &str = "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 1 0\n\
                       f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 1 4 3\nf 1 3 2\n";

/// A path with the object of a file beside it.
fn with_object(folder: &Path) -> (Document, PathBuf) {
    let mesh = folder.join("pyramid.obj");
    fs::write(&mesh, PYRAMID).unwrap();
    let mut document = Document::new();
    let mut info = document.info().clone();
    info.object = load_object(&mesh).unwrap();
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
    let file = folder.join("flight.vid");
    document.save(&file).unwrap();
    (document, file)
}

#[test]
fn an_object_is_kept_by_the_name_of_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let (document, file) = with_object(folder.path());
    // Eight edges, none through the floor.
    assert_eq!(document.info().object.iter().filter(|p| p.draw).count(), 8);
    let text = fs::read_to_string(&file).unwrap();
    assert!(text.contains("file = \"pyramid.obj\"") && !text.contains("polylines"));
    let (loaded, warnings) = Document::load_scene(&file).unwrap();
    assert!(warnings.is_empty());
    assert_eq!(loaded.info(), document.info());
    assert_eq!(Document::load(&file).unwrap().info(), document.info());
    let of_scene = crate::SceneDocument::load(&file).unwrap();
    assert_eq!(of_scene.info, *document.info());
    // Both moved elsewhere.
    let other = tempfile::tempdir().unwrap();
    for name in ["pyramid.obj", "flight.vid"] {
        fs::copy(folder.path().join(name), other.path().join(name)).unwrap();
    }
    let (moved, warnings) = Document::load_scene(&other.path().join("flight.vid")).unwrap();
    assert!(warnings.is_empty());
    assert_eq!(moved.info().object.len(), document.info().object.len());
    // Saved where it does not lie it is named whole.
    let apart = tempfile::tempdir().unwrap();
    let file = apart.path().join("flight.vid");
    moved.save(&file).unwrap();
    let (loaded, warnings) = trusting(|| Document::load_scene(&file)).unwrap();
    assert!(warnings.is_empty());
    assert_eq!(loaded.info().object, moved.info().object);
    // Read only where that is agreed to; the name is kept.
    let (loaded, warnings) = Document::load_scene(&file).unwrap();
    assert_eq!(warnings.len(), 1);
    let name = other.path().join("pyramid.obj").display().to_string();
    let outside = warnings[0].outside().map(ToString::to_string);
    assert_eq!(outside, Some(name));
    assert!(loaded.info().object.is_empty());
    assert_eq!(loaded.info().object.source(), moved.info().object.source());
}

/// By its folder, whatever the file says: absolute, `..`, a link, a scene's node, a glTF buffer.
#[test]
fn a_file_reads_no_mesh_outside_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("in")).unwrap();
    fs::write(at("out.obj"), PYRAMID).unwrap();
    std::os::unix::fs::symlink("../out.obj", at("in/link.obj")).unwrap();
    let absolute = at("out.obj").display().to_string();
    let scene = at("in/scene.vid");
    for name in ["../out.obj", "link.obj", &absolute] {
        for table in [
            "[object]",
            "[[node]]\nname = \"a\"\nkind = \"object\"\n[node.mesh]",
        ] {
            let points = match table {
                "[object]" => "[[point]]\nposition = [0, 0, 0]\n[[point]]\nposition = [1, 0, 0]\n",
                _ => "",
            };
            let text = format!("version = 1\n{points}{table}\nfile = \"{name}\"\n");
            fs::write(&scene, text).unwrap();
            let (_, warnings) = Document::load_scene(&scene).unwrap();
            assert_eq!(warnings.len(), 1, "{name}");
            assert!(warnings[0].outside().is_some(), "{name}: {warnings:?}");
            let (_, warnings) = trusting(|| Document::load_scene(&scene)).unwrap();
            assert!(warnings.is_empty(), "{name}: {warnings:?}");
        }
    }
}

/// A buffer beside it, in all spellings, and one through a link that leads out.
#[cfg(feature = "meshes")]
#[test]
fn a_gltf_file_reads_no_buffer_outside_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("in")).unwrap();
    let bytes = [0, 0, 0, 7, 0, 0, 0, 7, 0, 0, 0, 0, 8, 0, 0, 0, 8, 0];
    fs::write(at("out.bin"), bytes).unwrap();
    fs::write(at("in/ok.bin"), bytes).unwrap();
    std::os::unix::fs::symlink("../out.bin", at("in/link.bin")).unwrap();
    let mesh = at("in/two.gltf");
    let uri = "data:;base64,AAAABwAAAAcAAAAACAAAAAgA";
    for (name, read) in [
        ("ok.bin", true),
        ("./ok.bin", true),
        ("link.bin", false),
        ("../out.bin", false),
    ] {
        fs::write(&mesh, TWO.replace(uri, name)).unwrap();
        assert_eq!(load_mesh(&mesh).is_ok(), read, "{name}");
        assert!(trusting(|| load_mesh(&mesh)).is_ok(), "{name}");
    }
}

#[test]
fn an_object_whose_file_is_gone_broken_or_changed_is_told_and_not_lost() {
    let folder = tempfile::tempdir().unwrap();
    let (document, file) = with_object(folder.path());
    let mesh = folder.path().join("pyramid.obj");
    let text = fs::read_to_string(&file).unwrap();
    let said = || {
        let (loaded, warnings) = Document::load_scene(&file).unwrap();
        let words: Vec<String> = warnings.iter().map(ToString::to_string).collect();
        assert_eq!(words.len(), 1, "{words:?}");
        assert!(words[0].contains("pyramid.obj"), "{words:?}");
        (loaded, words[0].clone())
    };
    for broken in [
        None,
        Some("v 1 2 x\n"),
        Some("v 1e300 0 0\nv 0 0 0\nl 1 2\n"),
    ] {
        match broken {
            None => fs::remove_file(&mesh).unwrap(),
            Some(broken) => fs::write(&mesh, broken).unwrap(),
        }
        let (loaded, _) = said();
        assert!(loaded.info().object.is_empty());
        // The name survives saving.
        loaded.save(&file).unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), text);
    }
    fs::write(&mesh, PYRAMID.replace("v 0 1 0", "v 0 2 0")).unwrap();
    let (loaded, words) = said();
    assert!(words.contains("changed"), "{words}");
    assert_eq!(loaded.info().object.len(), document.info().object.len());
}

#[test]
fn what_is_no_name_of_a_file_has_a_line() {
    let folder = tempfile::tempdir().unwrap();
    let (_, file) = with_object(folder.path());
    let text = fs::read_to_string(&file).unwrap();
    for (from, to) in [
        ("bytes = ", "bytes = -"),
        ("bytes = ", "polylines = [[[0, 0, 0], [1, 0, 0]]]\nbytes = "),
        ("checksum = \"", "checksum = \"g"),
        ("[object]\nfile = \"pyramid.obj\"", "[object]"),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text);
        let error = Document::from_toml(&changed).unwrap_err().to_string();
        assert!(error.contains("line"), "{error}");
    }
}

#[test]
fn points_of_a_cloud_are_drawn_with_their_colours() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("cloud.ply");
    let header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n\
                  property float z\nproperty uchar red\nproperty uchar green\n\
                  property uchar blue\nend_header\n";
    fs::write(&file, format!("{header}0 0 0 255 0 0\n1 0 0 0 0 255\n")).unwrap();
    let object = load_object(&file).unwrap();
    let drawn: Vec<_> = object.lines().map(|([a, b], c)| (a == b, a.x, c)).collect();
    let red_and_blue = [
        (true, 0.0, Some([255, 0, 0])),
        (true, 1.0, Some([0, 0, 255])),
    ];
    assert_eq!(drawn, red_and_blue);
}

#[test]
fn the_reading_of_a_mesh_is_watched_and_stopped() {
    use std::rc::Rc;

    let folder = tempfile::tempdir().unwrap();
    let (_, file) = with_object(folder.path());
    let many: String = (0..100_000).map(|k| format!("v {k} 0 0\n")).collect();
    fs::write(folder.path().join("pyramid.obj"), many + PYRAMID).unwrap();
    for until in [2.0, 0.5] {
        let seen = Rc::new(Cell::new((0, 0.0)));
        let told = seen.clone();
        watch_meshes(Some(Box::new(move |share| {
            let (count, before) = told.get();
            assert!(share >= before);
            told.set((count + 1, share));
            share < until
        })));
        let (loaded, warnings) = Document::load_scene(&file).unwrap();
        watch_meshes(None);
        let (count, last) = seen.get();
        assert!(count > 3 && last == 1.0, "{count} {last}");
        let stopped = until < 1.0;
        assert_eq!(loaded.info().object.is_empty(), stopped);
        assert_eq!(warnings.len(), 1, "{warnings:?}");
        assert!(loaded.info().object.source().is_some());
    }
}

/// Two triangles in one file, each a mesh of its own.
const TWO: &str = r#"{"asset": {"version": "2.0"},
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]},
           {"primitives": [{"attributes": {"POSITION": 1}}]}],
"nodes": [{"mesh": 0}, {"mesh": 1, "translation": [9, 0, 0]}],
"accessors": [
  {"bufferView": 0, "componentType": 5121, "count": 3, "type": "VEC3"},
  {"bufferView": 0, "byteOffset": 9, "componentType": 5121, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 18}],
"buffers": [{"byteLength": 18, "uri": "data:;base64,AAAABwAAAAcAAAAACAAAAAgA"}]}"#;

#[cfg(feature = "meshes")]
#[test]
fn objects_have_the_meshes_of_one_file_by_their_numbers() {
    use crate::SceneDocument;
    let folder = tempfile::tempdir().unwrap();
    let mesh = folder.path().join("two.gltf");
    fs::write(&mesh, TWO).unwrap();
    let node = |name: &str, part: &str| {
        format!(
            "[[node]]\nname = \"{name}\"\nkind = \"object\"\n[node.mesh]\nfile = \"two.gltf\"\n{part}\n"
        )
    };
    let file = folder.path().join("scene.vid");
    let text = [
        node("first", "part = 0"),
        node("second", "part = 1"),
        node("second again", "part = 1"),
        node("all", ""),
    ];
    fs::write(&file, format!("version = 1\n{}", text.concat())).unwrap();
    let scene = SceneDocument::load(&file).unwrap();
    assert!(scene.warnings().is_empty(), "{:?}", scene.warnings());
    let object = |scene: &SceneDocument, at: usize| match &scene.scene.nodes()[at].kind {
        Kind::Object(object) => object.clone(),
        _ => unreachable!(),
    };
    let far = |at| object(&scene, at).mesh().points[1].x;
    assert_eq!([far(0), far(1), far(2)], [7.0, 8.0, 8.0]);
    assert_eq!(object(&scene, 3).mesh().points.len(), 6);
    let meshes = [1, 2].map(|at| std::ptr::from_ref(object(&scene, at).mesh()).addr());
    assert_eq!(meshes[0], meshes[1], "two copies of one mesh");
    // Saved, loaded and saved again: the same file, to the byte.
    scene.save(&file).unwrap();
    let text = fs::read_to_string(&file).unwrap();
    assert_eq!(text.matches("\npart = 1\n").count(), 2, "{text}");
    assert!(!text.contains("points"), "{text}");
    let again = SceneDocument::load(&file).unwrap();
    assert_eq!(again, scene);
    again.save(&file).unwrap();
    assert_eq!(fs::read_to_string(&file).unwrap(), text);
    // One that is not there, and none at all.
    for (part, said) in [
        ("part = 2", "numbers of points"),
        ("part = -1", "between 0 and"),
    ] {
        fs::write(&file, format!("version = 1\n{}", node("none", part))).unwrap();
        let words = match SceneDocument::load(&file) {
            Ok(scene) => scene.warnings()[0].to_string(),
            Err(error) => error.to_string(),
        };
        assert!(words.contains(said), "{words}");
    }
}
