//! glTF: the unit cube in each way in which it can be written, and files that are broken.

use std::fmt::Write;

use super::*;
use crate::error::Error;
use crate::tests::{SIDES, corner, is_cube, volume};
use crate::{Format, Opened, read, read_with};

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

/// Three points in each type of number, in steps of 16 bytes.
#[test]
fn quantised_places_are_read() {
    type Row = (u64, bool, fn(f64) -> Vec<u8>, f64);
    let types: [Row; 8] = [
        (5120, false, |v| vec![v as i8 as u8], 1.0),
        (5120, true, |v| vec![v as i8 as u8], 127.0),
        (5121, false, |v| vec![v as u8], 1.0),
        (5121, true, |v| vec![v as u8], 255.0),
        (5122, false, |v| (v as i16).to_le_bytes().to_vec(), 1.0),
        (5122, true, |v| (v as i16).to_le_bytes().to_vec(), 32767.0),
        (5123, true, |v| (v as u16).to_le_bytes().to_vec(), 65535.0),
        (5126, false, |v| (v as f32).to_le_bytes().to_vec(), 1.0),
    ];
    for (component, normalized, bytes, one) in types {
        let signed = matches!(component, 5120 | 5122 | 5126);
        let places = [
            [0.0, 1.0, 2.0],
            [100.0, 5.0, 7.0],
            [if signed { -120.0 } else { 9.0 }, 3.0, 4.0],
        ];
        let mut data = vec![0; 4];
        for place in places {
            let start = data.len();
            data.extend(place.into_iter().flat_map(bytes));
            data.resize(start + 16, 0xee);
        }
        let json = format!(
            r#"{{"asset": {{"version": "2.0"}}, "extensionsRequired": ["KHR_mesh_quantization"],
            "nodes": [{{"mesh": 0, "scale": [2, 2, 2]}}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
            "accessors": [{{"bufferView": 0, "byteOffset": 4, "componentType": {component},
              "normalized": {normalized}, "count": 3, "type": "VEC3"}}],
            "bufferViews": [{{"buffer": 0, "byteLength": 52, "byteStride": 16}}],
            "buffers": [{{"byteLength": 52}}]}}"#
        );
        let mesh = mesh(&glb(&json, &data));
        for (found, place) in mesh.points.iter().zip(places) {
            let wanted = place.map(|v| 2.0 * v / one);
            assert_eq!(found.to_array(), wanted, "{component} {normalized}");
        }
    }
}

/// Two of four points moved, on points of a buffer and on none.
#[test]
fn sparse_accessors_are_read() {
    let file = |view: &str, indices: [u8; 2]| {
        let mut data: Vec<u8> = (0..12).flat_map(|n| (n as f32).to_le_bytes()).collect();
        data.extend(indices);
        data.extend([0; 2]);
        data.extend(
            [50.0_f32, 51.0, 52.0, 60.0, 61.0, 62.0]
                .iter()
                .flat_map(|n| n.to_le_bytes()),
        );
        let json = format!(
            r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "mode": 0}}]}}],
            "accessors": [{{{view} "componentType": 5126, "count": 4, "type": "VEC3",
              "sparse": {{"count": 2, "indices": {{"bufferView": 1, "componentType": 5121}},
                "values": {{"bufferView": 2}}}}}}],
            "bufferViews": [{{"buffer": 0, "byteLength": 48}},
              {{"buffer": 0, "byteOffset": 48, "byteLength": 2}},
              {{"buffer": 0, "byteOffset": 52, "byteLength": 24}}],
            "buffers": [{{"byteLength": 76}}]}}"#
        );
        glb(&json, &data)
    };
    let xs = |file: &[u8]| mesh(file).points.iter().map(|p| p.x).collect::<Vec<_>>();
    let view = r#""bufferView": 0,"#;
    assert_eq!(xs(&file(view, [1, 3])), [0.0, 50.0, 6.0, 60.0]);
    assert_eq!(xs(&file("", [0, 2])), [50.0, 0.0, 60.0, 0.0]);
    // Not in order, beyond the end.
    for wrong in [[3, 1], [1, 1], [1, 4]] {
        assert!(refused(&file(view, wrong)).contains("expected numbers"));
    }
    // A number alone says how many: no memory for what is not there.
    let many = file("", [0, 2]);
    let json = String::from_utf8_lossy(&many[20..]).into_owned();
    let json = json[..json.rfind('}').unwrap() + 1].replace("\"count\": 4", "\"count\": 400000000");
    assert!(refused(&glb(&json, &many[many.len() - 76..])).contains("more than"));
}

/// A square of two triangles whose seam is doubled; one of the doubles moves in the target.
#[test]
fn points_stay_apart_where_targets_differ() {
    let corners = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0_f32],
    ];
    let moved = [0.0, 0.0, 0.0, 0.0, 5.0, 0.0_f32];
    let mut data: Vec<u8> = Vec::new();
    for [x, y] in corners {
        data.extend([x, y, 0.0].iter().flat_map(|n| n.to_le_bytes()));
    }
    for z in moved {
        data.extend([0.0, 0.0, z].iter().flat_map(|n| n.to_le_bytes()));
    }
    let json = r#"{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0, "translation": [9, 9, 9]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "targets": [{"POSITION": 1}, {}]}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3"},
          {"bufferView": 0, "byteOffset": 72, "componentType": 5126, "count": 6, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 144}],
        "buffers": [{"byteLength": 144}]}"#;
    let file = glb(json, &data);
    let mut opened = Opened::new(Format::Gltf, file.clone(), &mut |_| None).unwrap();
    let (mesh, targets) = opened.part(0, &mut |_| true).unwrap();
    // (0, 0) is one, (1, 1) two.
    assert_eq!((mesh.points.len(), targets.len()), (5, 2));
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 3, 4]]);
    assert_eq!(targets[0][3], glam::DVec3::new(1.0, 1.0, 5.0));
    assert_eq!(targets[1], mesh.points);
    // Without targets and in place, where all is one.
    let whole = opened.whole(&mut |_| true).unwrap();
    assert_eq!(whole.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(whole.points[0], glam::DVec3::splat(9.0));
    let none = opened.part(1, &mut |_| true).unwrap_err();
    assert!(none.to_string().contains("expected numbers"));
    // All parts together are bounded: the same again and again ends.
    let again = (0..100_000).find_map(|_| opened.part(0, &mut |_| true).err());
    assert!(again.unwrap().to_string().contains("more than"));
    let mut other = Opened::new(Format::Obj, b"v 1 2 3".to_vec(), &mut |_| None).unwrap();
    let error = other.part(0, &mut |_| true).unwrap_err();
    assert_eq!(error.to_string(), "this file has no such part");
}
