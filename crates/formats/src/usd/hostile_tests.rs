//! Broken files: a sentence or a scene, nothing else.

use glam::DQuat;
use proptest::prelude::*;

use super::USDA;
use super::read_tests::ALL;
use super::tests::{KEYS, document, matrix, prim, read, written};
use crate::loss::Loss;
use crate::{Options, Source, import};

fn refused(bytes: &[u8]) -> String {
    let source = Source::of_bytes("a.usda", bytes.to_vec());
    import(&source, None, &Options::default())
        .unwrap_err()
        .to_string()
}

#[test]
fn what_is_wrong_is_named_with_its_line() {
    let cases = [
        (
            prim(
                "Xform",
                "double3 xformOp:translate = (1, 2)\nuniform token[] xformOpOrder = [\"xformOp:translate\"]",
            ),
            "a.usda: line 4: expected 3 numbers",
        ),
        (
            prim(
                "Xform",
                "uniform token[] xformOpOrder = [\"xformOp:wobble\"]",
            ),
            "a.usda: line 4: xformOp:wobble is not there",
        ),
        (
            prim(
                "Xform",
                "quatf xformOp:orient = (0, 0, 0, 0)\nuniform token[] xformOpOrder = [\"xformOp:orient\"]",
            ),
            "a.usda: line 5: the rotation is zero",
        ),
        (
            prim("Camera", "float focalLength.timeSamples = { 2: 1, 1: 2 }"),
            "a.usda: line 4: the times must increase",
        ),
        (
            prim("Camera", "float focalLength = }"),
            "a.usda: line 4: expected a value",
        ),
        (
            "#usda 1.0\n\nhello".to_owned(),
            "a.usda: line 3: expected \"def\"",
        ),
        (
            "#usda 1.0\ndef Xform \"a\" {".to_owned(),
            "a.usda: line 2: the file ends too early",
        ),
        (
            "#usda 1.0\n".to_owned() + &"def \"a\" {".repeat(300),
            "a.usda: line 2: this lies deeper than is taken",
        ),
        (
            "#usda 1.0\n(\nstartTimeCode = 1e300\n)".to_owned(),
            "a.usda: line 1: the number is too large",
        ),
        (
            prim(
                "Xform",
                "float3 xformOp:rotateXYZ.timeSamples = { 0: (0, 0, 0), 1e9: (1, 0, 0) }\nuniform token[] xformOpOrder = [\"xformOp:rotateXYZ\"]",
            ),
            "a.usda: line 2: this has more than is taken",
        ),
    ];
    for (text, said) in cases {
        assert_eq!(refused(text.as_bytes()), said, "{text}");
    }
}

/// A mesh that cannot be read is left out, and the camera comes.
#[test]
fn geometry_that_is_wrong_is_left_out() {
    let cases = [
        (
            prim(
                "Mesh",
                "point3f[] points = [(0, 0, 0)]\nint[] faceVertexIndices = [7]\nint[] faceVertexCounts = [1]",
            ),
            "line 5: there is no number 7: there are 1",
        ),
        (
            prim(
                "Mesh",
                "point3f[] points = [(0, 0, 0)]\nint[] faceVertexIndices = [0]\nint[] faceVertexCounts = [1, 1]",
            ),
            "line 6: expected 2 numbers, found 1",
        ),
        (
            prim("Mesh", "point3f[] points = [(0, nan, 0)]"),
            "line 4: the number must be finite",
        ),
    ];
    for (text, why) in cases {
        let read = read(&text);
        assert!(read.document.scene.shown_camera().is_some());
        let left = Loss::LeftOut(format!("the mesh of it: {why}").as_str().into());
        assert!(read.report.losses().contains(&left), "{:?}", read.report);
    }
    for mesh in [
        "float3[] extent = [(-inf, -inf, -inf), (inf, inf, inf)]",
        "float wide = -inf",
        "color3f[] primvars:displayColor = []",
        "color3f[] primvars:displayColor = [] (interpolation = \"varying\")",
        "color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0)]",
        "token visibility = \"inherited\" bool doubleSided = True",
    ] {
        let read = read(&prim("Mesh", mesh));
        assert!(read.document.scene.shown_camera().is_some(), "{mesh}");
    }
    let off = prim("Mesh", "point3f[] points = [(0, nan, 0)]")
        .replace("\"it\"", "\"it\" ( active = False )");
    assert!(read(&off).report.losses().is_empty());
}

/// The rate of frames may differ from that of time codes, and a spline is not played by guess.
#[test]
fn seconds_and_splines() {
    let seconds = prim("Camera", "float focalLength.timeSamples = { 0: 10, 2: 20 }").replacen(
        "#usda 1.0\n",
        "#usda 1.0\n(\ntimeCodesPerSecond = 1\nframesPerSecond = 30\nstartTimeCode = 0\nendTimeCode = 2\n)\n",
        1,
    );
    let read = read(&seconds).document;
    assert_eq!((read.info.fps, read.info.first_frame), (30.0, 0));
    assert_eq!(read.scene.frame_range(), (1.0, 61.0));
    let spline =
        "float focalLength.spline = { bezier, 1: 5, 10: 20; pre (2, 0.3); post curve (3, 0.4), }";
    assert_eq!(
        refused(prim("Camera", spline).as_bytes()),
        "a.usda: line 4: the spline of a camera (bake it to time samples) is not read"
    );
}

#[test]
fn binary_files_are_refused_with_what_helps() {
    let mut archive = b"PK\x03\x04".to_vec();
    archive.extend([0; 26]);
    archive.extend(b"stage.usdc");
    for (bytes, name) in [
        (
            b"PXR-USDC\0\0\0\0".to_vec(),
            "a binary file of OpenUSD (.usdc)",
        ),
        (archive, "an archive of OpenUSD (.usdz)"),
    ] {
        let said =
            format!("a.usda: {name} is not read: make text of it by `usdcat in.usdc -o out.usda`");
        assert_eq!(refused(&bytes), said);
    }
}

/// Broken files give a sentence or a scene, nothing else.
fn tried(bytes: Vec<u8>) {
    let source = Source::of_bytes("a.usda", bytes);
    if let Err(error) = import(&source, Some(&USDA), &Options::default()) {
        let said = error.to_string();
        assert!(!said.is_empty() && !said.contains('\n'), "{said}");
    }
}

#[test]
fn files_may_end_anywhere() {
    for text in [ALL.to_owned(), written(&document(KEYS))] {
        for end in 0..text.len() {
            tried(text.as_bytes()[..end].to_vec());
        }
    }
}

#[test]
fn any_byte_may_be_another() {
    for text in [ALL.to_owned(), written(&document(KEYS))] {
        for at in 0..text.len() {
            for byte in [b'(', b']', b'}', b'"', b'9', b'-', b'\n', 0xff] {
                let mut bytes = text.clone().into_bytes();
                bytes[at] = byte;
                tried(bytes);
            }
        }
    }
}

proptest! {
    #[test]
    fn any_words_in_any_order(words in prop::collection::vec(prop::sample::select(vec![
        "def", "over", "Xform", "Camera", "Mesh", "\"a\"", "{", "}", "(", ")", "[", "]", "=", ",", ":", ".", "1", "-1e308",
        "float", "xformOp:translate", "xformOp:rotateX", "xformOpOrder", "\"xformOp:rotateX\"", "timeSamples", "points",
        "faceVertexCounts", "faceVertexIndices", "curveVertexCounts", "token[]", "uniform", "None", "@a@", "<b>", ";",
        "customData", "string", "vides", "\"part\"", "\"looks\"", "\"wireframe\"", "variantSet", "rel", "visibility",
        "def Xform \"a\" {", "def Camera \"b\" {", "def Mesh \"c\" {", "point3f[] points = [(0, 0, 0), (1, 1, 1)]",
        "float xformOp:rotateX.timeSamples = { 1: 2, 3: 4 }", "uniform token[] xformOpOrder = [\"xformOp:rotateX\"]",
    ]), 0..60)) {
        tried(format!("#usda 1.0\n{}", words.join(" ")).into_bytes());
    }

    #[test]
    fn pieces_may_stand_elsewhere(pieces in prop::collection::vec((0.0..1.0, 0.0..1.0, 0_usize..60), 1..6)) {
        let all = ALL.to_owned() + &written(&document(KEYS))["#usda 1.0".len()..];
        let mut bytes = all.into_bytes();
        for (from, to, length) in pieces {
            let at = |share: f64| (share * bytes.len() as f64) as usize;
            let (from, to) = (at(from), at(to));
            let piece = bytes[from..(from + length).min(bytes.len())].to_vec();
            let end = (to + piece.len()).min(bytes.len());
            bytes.splice(to..end, piece);
        }
        tried(bytes);
    }

    #[test]
    fn any_place_comes_back(
        place in prop::array::uniform3(-1e6..1e6), pivot in prop::array::uniform3(-1e3..1e3),
        turn in prop::array::uniform4(-1.0..1.0), scale in prop::array::uniform3(-4.0..4.0),
    ) {
        prop_assume!(DQuat::from_array(turn).length() > 0.1);
        let text = format!(
            "version = 1\n[[node]]\nname = \"camera\"\nkind = \"camera\"\n[[node]]\nname = \"it\"\nkind = \"group\"\n\
             position = {place:?}\npivot = {pivot:?}\nrotation = {turn:?}\nscale = {scale:?}\n",
        );
        let was = document(&text);
        let is = read(&written(&was)).document;
        let (was, is) = (matrix(&was, "it", 1.0), matrix(&is, "it", 1.0));
        prop_assert!(was.abs_diff_eq(is, 1e-8), "{was}\n{is}");
    }
}
