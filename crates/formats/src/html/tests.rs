//! What of the page can be seen without a browser; `tests/formats/page.py` looks at the rest.

use std::path::Path;

use serde_json::Value;
use vides_document::SceneDocument;

use super::*;
use crate::all::by_target;
use crate::loss::Loss;
use crate::options::Options;
use crate::{by_name, export_to};

fn page(document: &SceneDocument, options: &str) -> (String, Report) {
    let options = Options::parse(options).unwrap();
    let mut out = Vec::new();
    let format = by_name("html").unwrap();
    let report = export_to(document, &mut out, format, &options, &mut |_, _| {}).unwrap();
    (String::from_utf8(out).unwrap(), report)
}

/// The text of the page's data, and what it says.
fn data(page: &str) -> (String, Value) {
    let start = page.find("id=\"flight\">").unwrap() + "id=\"flight\">".len();
    let text = page[start..].split("</script>").next().unwrap();
    (text.to_owned(), serde_json::from_str(text).unwrap())
}

/// Decoded by the definition, digit by digit.
fn bytes(text: &Value) -> Vec<u8> {
    let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut bits = Vec::new();
    for digit in text.as_str().unwrap().trim_end_matches('=').bytes() {
        let value = digits.iter().position(|known| *known == digit).unwrap();
        bits.extend((0..6).rev().map(|at| value >> at & 1));
    }
    let byte = |bits: &[usize]| bits.iter().fold(0, |byte, bit| byte << 1 | *bit as u8);
    bits.chunks_exact(8).map(byte).collect()
}

fn floats(text: &Value) -> Vec<f32> {
    let bytes = bytes(text);
    let number = |bytes: &[u8]| f32::from_le_bytes(bytes.try_into().unwrap());
    bytes.chunks_exact(4).map(number).collect()
}

fn indices(text: &Value) -> Vec<u32> {
    let bytes = bytes(text);
    let number = |bytes: &[u8]| u32::from_le_bytes(bytes.try_into().unwrap());
    bytes.chunks_exact(4).map(number).collect()
}

fn example(name: &str) -> SceneDocument {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    SceneDocument::load(&examples.join(name)).unwrap()
}

#[test]
fn the_parts_fit() {
    for mark in ["@POLICY@", "@STYLE@", "@SCRIPT@", "@DATA@"] {
        assert_eq!(PAGE.matches(mark).count(), 1, "{mark}");
        assert!(!STYLE.contains(mark) && !SCRIPT.contains(mark));
    }
    assert!(!SCRIPT.contains("</script") && !SCRIPT.contains("<!--") && !STYLE.contains("</"));
    // What could make code of text.
    for word in [
        "innerHTML",
        "outerHTML",
        "insertAdjacentHTML",
        "document.write",
        "eval(",
        "Function(",
    ] {
        assert!(!SCRIPT.contains(word), "{word}");
    }
    let (page, _) = page(&example("pyramid.vid"), "");
    let data = data(&page).0;
    assert!(page.len() - data.len() <= 1_000_000);
    assert!(page.contains(&policy()));
}

#[test]
fn texts_are_data() {
    let mut document = example("pyramid.vid");
    let hostile = "</script><script>alert(\"1\")</script> 'é' @SCRIPT@ <!-- \\u003c";
    document.info.title = hostile.into();
    document.info.comment = format!("{hostile}\n\u{2028}]]>");
    document.info.unit = "<m>".into();
    let (page, _) = page(&document, "");
    let (text, flight) = data(&page);
    assert!(!text.contains('<'));
    assert_eq!(flight["title"], hostile);
    assert_eq!(flight["comment"], document.info.comment.as_str());
    assert_eq!(flight["unit"], "<m>");
    assert_eq!(page.matches("</script>").count(), 2);
}

#[test]
fn poses_are_the_flights() {
    let document = example("pyramid.vid");
    let (page, report) = page(&document, "frames=100..400\nsize=640x480");
    let (_, flight) = data(&page);
    let poses = floats(&flight["poses"]);
    assert_eq!(poses.len(), 301 * 8);
    let path = document.path_alone().unwrap();
    let timeline = vides_engine::path::Timeline::new(path).unwrap();
    let sampler = vides_engine::path::Sampler::new(path, &timeline).unwrap();
    for (numbers, frame) in poses.chunks_exact(8).zip(100..) {
        let pose = sampler.pose(f64::from(frame)).unwrap();
        let q = glam::DQuat::from_xyzw(
            numbers[4].into(),
            numbers[5].into(),
            numbers[6].into(),
            numbers[3].into(),
        );
        for (axis, seen) in [(glam::DVec3::Z, pose.vpn), (glam::DVec3::Y, pose.vup)] {
            assert!((q * axis - glam::DVec3::from(seen)).length() < 1e-6);
        }
        for (number, wanted) in numbers.iter().zip(pose.vrp) {
            assert!((f64::from(*number) - wanted).abs() < 1e-7);
        }
        assert_eq!(f64::from(numbers[7]), pose.zoom);
    }
    assert_eq!(flight["first_frame"], 100.0);
    assert_eq!(flight["size"], serde_json::json!([640.0, 480.0]));
    // The window's list says 155 and 354; point 2, at 77, comes before.
    let points = flight["points"].as_array().unwrap();
    let seen: Vec<_> = points
        .iter()
        .map(|point| (point["number"].as_u64(), point["frame"].as_f64()))
        .collect();
    assert_eq!(seen, [(Some(3), Some(55.0)), (Some(4), Some(254.0))]);
    assert_eq!(points[0]["name"], "left corner");
    assert_eq!(
        points[1]["position"],
        serde_json::json!([0.75, 0.35, -0.65])
    );
    assert_eq!(report.losses(), [Loss::Path]);
}

/// A document far from the origin keeps its digits, and `--up` and `--scale` hold for all of it.
#[test]
fn what_is_far_keeps_its_digits() {
    let text = "version = 1\n[space]\ncentre = [4e8, -5e8, 0.0]\nhalf_size = 1.0\n\
        [object]\npolylines = [[[400000000.25, -500000000.5, 0.125], [400000000.5, -499999999.5, 0.0]]]\n\
        [[point]]\nposition = [400000000.5, -500000000.0, 0.25]\n\
        [[point.orientation]]\ntarget = [400000000.0, -500000000.0, 0.0]\n\
        [[point]]\nposition = [400000000.5, -500000000.0, 0.5]\n\
        [[point.orientation]]\ntarget = [400000000.0, -500000000.0, 0.0]\n";
    let document = SceneDocument::from_toml(text).unwrap();
    let (page, _) = page(&document, "up=z\nscale=2");
    let (_, flight) = data(&page);
    assert_eq!(floats(&flight["poses"])[..3], [1.0, -0.5, 0.0]);
    assert_eq!(flight["up"], "z");
    assert_eq!(
        flight["space"]["centre"],
        serde_json::json!([8e8, -0.0, -1e9])
    );
    assert_eq!(flight["space"]["half"], 2.0);
    let object = &flight["objects"][0];
    let points = floats(&object["points"]);
    let m = floats(&object["matrices"]);
    let at = |k: usize| {
        [0, 1, 2].map(|row| {
            (0..3)
                .map(|axis| m[3 * axis + row] * points[3 * k + axis])
                .sum::<f32>()
                + m[9 + row]
        })
    };
    // (0.25, −0.5, 0.125) and (0.5, 0.5, 0) from the centre, turned to (x, −z, y), twice as long.
    let near = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
    assert!(
        near(at(0), [0.5, -0.25, -1.0]) && near(at(1), [1.0, 0.0, 1.0]),
        "{:?} {:?}",
        at(0),
        at(1)
    );
    assert_eq!(indices(&object["lines"]), [0, 1]);
}

#[test]
fn nodes_move_with_their_parents_and_hide() {
    let text = "version = 1\n\
        [[node]]\nname = \"group\"\nkind = \"group\"\n\
        [[node.track]]\nchannel = \"position\"\ninterpolation = \"linear\"\nframes = [1.0, 5.0]\n\
        values = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]]\n\
        [[node]]\nname = \"part\"\nkind = \"object\"\nparent = \"group\"\nposition = [0.0, 1.0, 0.0]\n\
        colour = [1.0, 0.5, 0.0]\n\
        [[node.track]]\nchannel = \"visible\"\ninterpolation = \"step\"\nframes = [1.0, 4.0]\nvalues = [1.0, 0.0]\n\
        [node.mesh]\npoints = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]\ntriangles = [[0, 1, 2]]\n\
        [[node]]\nname = \"rest\"\nkind = \"object\"\n[node.mesh]\npoints = [[0.0, 0.0, 0.0]]\n\
        [[node]]\nname = \"sun\"\nkind = \"light\"\n\
        [[node]]\nname = \"camera\"\nkind = \"camera\"\n\
        [[node]]\nname = \"other\"\nkind = \"camera\"\n";
    let document = SceneDocument::from_toml(text).unwrap();
    let (page, report) = page(&document, "");
    let (_, flight) = data(&page);
    let [part, rest] = [0, 1].map(|at| floats(&flight["objects"][at]["matrices"]));
    assert_eq!((part.len(), rest.len()), (5 * 12, 12));
    // Its middle lies at (1, 1, 0) of its own axes.
    assert_eq!(
        part[24..36],
        [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 3.0, 2.0, 0.0]
    );
    assert!(!part[35].is_nan() && part[36..].iter().all(|number| number.is_nan()));
    assert_eq!(
        flight["objects"][0]["colour"],
        serde_json::json!([255, 188, 0])
    );
    assert_eq!(flight["objects"][1]["colour"], Value::Null);
    assert_eq!(
        report.losses(),
        [Loss::OtherNodes(1), Loss::OtherCameras(1)]
    );
}

#[test]
fn it_is_for_cameras_and_written_only() {
    let document = example("car.vid");
    let options = Options::parse("node=body").unwrap();
    let format = by_target(Path::new("a/B.HTML")).unwrap();
    let refused = export_to(&document, &mut Vec::new(), format, &options, &mut |_, _| {});
    let refused = refused.unwrap_err().to_string();
    assert_eq!(
        refused,
        "node \"body\" is no camera; of others this format holds nothing"
    );
    assert!(!format.reads() && format.writes());
}
