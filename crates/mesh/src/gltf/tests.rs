//! glTF: the unit cube in each way in which it can be written, and files that are broken.

use std::fmt::Write;

use super::*;
use crate::tests::{SIDES, corner, is_cube, volume};
use crate::{Format, read, read_with};

/// Corners of the cube as floats, then its triangles as numbers of 16 bits.
fn cube() -> Vec<u8> {
    let corners = (0..8).flat_map(corner).flat_map(f32::to_le_bytes);
    let triangles = SIDES.iter().flat_map(|&[a, b, c, d]| [a, b, c, a, c, d]);
    let numbers = triangles.flat_map(|at| (at as u16).to_le_bytes());
    corners.chain(numbers).collect()
}

/// A file with nodes, and the cube as its only mesh.
fn document(nodes: &str, buffer: &str) -> String {
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
        "nodes": [{nodes}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}],
        "accessors": [
          {{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"}},
          {{"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}}],
        "bufferViews": [
          {{"buffer": 0, "byteLength": 96}},
          {{"buffer": 0, "byteOffset": 96, "byteLength": 72}}],
        "buffers": [{{{buffer}"byteLength": 168}}]}}"#
    )
}

fn glb(json: &str, data: &[u8]) -> Vec<u8> {
    let chunk = |kind: &[u8; 4], bytes: &[u8], fill: u8| {
        let length = bytes.len().next_multiple_of(4);
        let mut chunk = (length as u32).to_le_bytes().to_vec();
        chunk.extend_from_slice(kind);
        chunk.extend_from_slice(bytes);
        chunk.resize(8 + length, fill);
        chunk
    };
    let mut file = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
    file.extend(chunk(b"JSON", json.as_bytes(), b' '));
    file.extend(chunk(b"BIN\0", data, 0));
    file
}

fn mesh(bytes: &[u8]) -> Mesh {
    read(Format::Gltf, bytes, &mut |_| true).unwrap()
}

fn refused(bytes: &[u8]) -> String {
    let read = read(Format::Gltf, bytes, &mut |_| true);
    read.unwrap_err().to_string()
}

/// RFC 4648, bit by bit.
fn in_base64(bytes: &[u8]) -> String {
    let signs: Vec<char> = ('A'..='Z')
        .chain('a'..='z')
        .chain('0'..='9')
        .chain(['+', '/'])
        .collect();
    let bits: String = bytes.iter().fold(String::new(), |mut bits, byte| {
        write!(bits, "{byte:08b}").unwrap();
        bits
    });
    let mut text = String::new();
    for six in bits.as_bytes().chunks(6) {
        let six = format!("{:0<6}", str::from_utf8(six).unwrap());
        text.push(signs[usize::from_str_radix(&six, 2).unwrap()]);
    }
    while !text.len().is_multiple_of(4) {
        text.push('=');
    }
    text
}

#[test]
fn the_cube_is_the_same_in_each_encoding() {
    let plain = r#"{"mesh": 0}"#;
    is_cube(&mesh(&glb(&document(plain, ""), &cube())));
    for extra in 0..3 {
        let mut data = cube();
        data.resize(data.len() + extra, 7);
        let uri = format!(
            r#""uri": "data:application/octet-stream;base64,{}", "#,
            in_base64(&data)
        );
        is_cube(&mesh(document(plain, &uri).as_bytes()));
    }
    let beside = document(plain, r#""uri": "cube.bin", "#);
    let mut given = |name: &str| (name == "cube.bin").then(cube);
    let read = read_with(Format::Gltf, beside.as_bytes(), &mut given, &mut |_| true);
    is_cube(&read.unwrap());
    assert!(refused(beside.as_bytes()).contains("a buffer"));
}

/// Twice as high, mirrored, turned and moved by its parents: the volume tells of the scale,
/// and its sign whether the triangles still look outwards.
#[test]
fn a_mesh_stands_where_its_nodes_are() {
    let half = 0.5f64.sqrt();
    let nodes = format!(
        r#"{{"children": [1], "translation": [10, 0, 0], "rotation": [0, {half}, 0, {half}]}},
        {{"children": [2], "scale": [-1, 2, 3]}},
        {{"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 5,0,0,1]}}"#
    );
    let cube = mesh(&glb(&document(&nodes, ""), &cube()));
    assert!((volume(&cube) - 6.0).abs() < 1e-5, "{}", volume(&cube));
    let low = cube
        .points
        .iter()
        .copied()
        .reduce(glam::DVec3::min)
        .unwrap();
    let high = cube
        .points
        .iter()
        .copied()
        .reduce(glam::DVec3::max)
        .unwrap();
    // x of the mesh is −6 to −5 and then, turned about y, −z; z becomes x.
    assert!(
        low.distance(glam::DVec3::new(10.0, 0.0, 5.0)) < 1e-6,
        "{low}"
    );
    assert!(
        high.distance(glam::DVec3::new(13.0, 2.0, 6.0)) < 1e-6,
        "{high}"
    );
}

/// Each side with corners of its own, as exporters write them: joined again.
#[test]
fn corners_at_one_place_are_one_point() {
    let corners: Vec<u8> = SIDES
        .iter()
        .flat_map(|side| side.map(corner))
        .flatten()
        .flat_map(f32::to_le_bytes)
        .collect();
    let sides = (0..6u16).flat_map(|side| [0, 1, 2, 0, 2, 3].map(|at| 4 * side + at));
    let data: Vec<u8> = corners
        .into_iter()
        .chain(sides.flat_map(u16::to_le_bytes))
        .collect();
    let json = document(r#"{"mesh": 0}"#, "")
        .replace(r#""count": 8"#, r#""count": 24"#)
        .replace("96", "288");
    is_cube(&mesh(&glb(&json, &data)));
}

#[test]
fn names_of_buffers_lose_their_percent_signs() {
    let json = document(r#"{"mesh": 0}"#, r#""uri": "a%20cube%2g.bin", "#);
    let mut given = |name: &str| (name == "a cube%2g.bin").then(cube);
    let read = read_with(Format::Gltf, json.as_bytes(), &mut given, &mut |_| true);
    is_cube(&read.unwrap());
}

/// Points 0 to 4 in each mode.
fn in_mode(mode: usize) -> Mesh {
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "COLOR_0": 1}}, "mode": {mode}}}]}}],
        "accessors": [
          {{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"}},
          {{"bufferView": 0, "byteOffset": 12, "componentType": 5121, "normalized": true,
            "count": 5, "type": "VEC4"}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 80, "byteStride": 16}}],
        "buffers": [{{"byteLength": 80}}]}}"#
    );
    let mut data = Vec::new();
    for at in 0..5u8 {
        let place = [f32::from(at), f32::from(at * at), 0.0];
        data.extend(place.into_iter().flat_map(f32::to_le_bytes));
        data.extend([at, 10, 20, 255]);
    }
    mesh(&glb(&json, &data))
}

#[test]
fn modes_are_those_of_opengl() {
    let points = in_mode(0);
    let bytes = |linear: f64| (255.0 * (1.055 * (linear / 255.0).powf(1.0 / 2.4) - 0.055)) as u8;
    let colour = points.colours[3];
    for (seen, linear) in colour.into_iter().zip([3.0, 10.0, 20.0]) {
        assert!(seen.abs_diff(bytes(linear)) <= 1, "{colour:?}");
    }
    assert_eq!(points.points.len(), 5);
    assert!(points.lines.is_empty() && points.triangles.is_empty());
    assert_eq!(in_mode(1).lines, [[0, 1], [2, 3]]);
    assert_eq!(in_mode(2).lines, [[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]]);
    assert_eq!(in_mode(3).lines, [[0, 1], [1, 2], [2, 3], [3, 4]]);
    assert_eq!(in_mode(4).triangles, [[0, 1, 2]]);
    assert_eq!(in_mode(5).triangles, [[0, 1, 2], [1, 3, 2], [2, 3, 4]]);
    assert_eq!(in_mode(6).triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
}

#[test]
fn what_is_broken_is_refused() {
    let (json, data) = (document(r#"{"mesh": 0}"#, ""), cube());
    for (old, new, said) in [
        (r#""mesh": 0"#, r#""mesh": 7"#, "expected numbers"),
        (
            r#"{"mesh": 0}"#,
            r#"{"mesh": 0, "children": [0]}"#,
            "below itself",
        ),
        (r#"{"nodes": [0]}"#, r#"{"nodes": [0, 0]}"#, "in two places"),
        (r#""scene": 0"#, r#""scene": 1"#, "expected numbers"),
        (r#""count": 8"#, r#""count": 9"#, "too early"),
        (r#""count": 8"#, r#""count": 7"#, "expected numbers"),
        (r#""count": 36"#, r#""count": 1e18"#, "format"),
        (
            r#""count": 36"#,
            r#""count": 18446744073709551615"#,
            "too early",
        ),
        (
            r#""byteOffset": 96"#,
            r#""byteOffset": 18446744073709551615"#,
            "too early",
        ),
        (r#""byteLength": 96"#, r#""byteLength": 960"#, "too early"),
        (r#"5126"#, r#"5125"#, "format"),
        (
            r#""count": 8"#,
            r#""sparse": {"count": 1}, "count": 8"#,
            "format",
        ),
        (r#""version": "2.0""#, r#""version": "1.0""#, "format"),
    ] {
        assert!(json.contains(old), "{old}");
        let broken = glb(&json.replacen(old, new, 1), &data);
        let sentence = refused(&broken);
        assert!(sentence.contains(said), "{new}: {sentence}");
    }
    // Too much of what is no file's size.
    let objects = format!("[{}]", r#"{"":0},"#.repeat(2_000_000));
    assert!(refused(objects.as_bytes()).contains("more than"));
    let nodes = r#"{"mesh": 0},"#.repeat(20_000);
    let all: Vec<String> = (0..20_000).map(|at| at.to_string()).collect();
    let many = document(nodes.trim_end_matches(','), "");
    let many = many.replace(
        r#""nodes": [0]}"#,
        &format!(r#""nodes": [{}]}}"#, all.join(",")),
    );
    let empty = many
        .replace(r#""count": 8"#, r#""count": 0"#)
        .replace("36", "0");
    assert!(
        !refused(&glb(
            &empty.replace(r#""indices": 1"#, r#""mode": 0"#),
            &data
        ))
        .is_empty()
    );
    let one = vec![r#"{"attributes": {}}"#; 60].join(",");
    let primitives = many.replace(r#"{"attributes": {"POSITION": 0}, "indices": 1}"#, &one);
    assert!(refused(&glb(&primitives, &data)).contains("more than"));
    // A thousand levels.
    let mut nodes: Vec<String> = (1..1000)
        .map(|at| format!(r#"{{"children": [{at}]}}"#))
        .collect();
    nodes.push(r#"{"mesh": 0}"#.to_owned());
    assert!(refused(&glb(&document(&nodes.join(","), ""), &data)).contains("more than"));
}

#[test]
fn any_bytes_do_no_harm() {
    let file = glb(&document(r#"{"mesh": 0}"#, ""), &cube());
    let look = |bytes: &[u8]| {
        if let Ok(mesh) = read(Format::Gltf, bytes, &mut |_| true) {
            mesh.check().unwrap();
            assert!(mesh.points.len() < 100 && mesh.triangles.len() < 100);
        }
    };
    for end in 0..file.len() {
        look(&file[..end]);
    }
    for at in 0..file.len() {
        for flip in [1, 4, 16, 128, 255] {
            let mut broken = file.clone();
            broken[at] ^= flip;
            look(&broken);
        }
    }
    assert!(matches!(
        read(Format::Gltf, &file, &mut |_| false),
        Err(Error::Stopped)
    ));
}

/// What files in the wild have that is not read: the reason, and what helps.
#[test]
fn what_is_not_read_says_what_helps() {
    let json = document(r#"{"mesh": 0}"#, "");
    for (extension, said) in [
        (
            "KHR_draco_mesh_compression",
            "a mesh compressed by Draco (KHR_draco_mesh_compression) is not read; export it uncompressed",
        ),
        (
            "EXT_meshopt_compression",
            "a mesh compressed by meshoptimizer (EXT_meshopt_compression) is not read; export it uncompressed",
        ),
        (
            "EXT_unheard\\u0007of",
            "this file requires the extension EXT_unheardof, which is not read",
        ),
    ] {
        let required = format!(r#"{{"extensionsRequired": ["{extension}"], "#);
        let json = json.replacen('{', &required, 1);
        assert_eq!(refused(&glb(&json, &cube())), said);
    }
    for nodes in [
        // Below itself, below each other, below two.
        r#"{"children": [0], "mesh": 0}"#,
        r#"{"children": [1]}, {"children": [0], "mesh": 0}"#,
        r#"{"children": [1, 2]}, {"children": [2]}, {"mesh": 0}"#,
    ] {
        assert_eq!(
            refused(&glb(&document(nodes, ""), &cube())),
            "a node of this file lies below itself or in two places; each may stand in one"
        );
    }
    // No scene, and no node to begin with.
    let round = r#"{"asset": {"version": "2.0"}, "nodes": [{"children": [1]}, {"children": [0]}]}"#;
    assert!(refused(round.as_bytes()).contains("below itself"));
}
