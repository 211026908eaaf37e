use std::path::Path;

use proptest::prelude::*;
use vides_engine::scene::Mesh;

use super::*;

fn mesh(format: Format, bytes: &[u8]) -> Mesh {
    read(format, bytes, &mut |_| true).unwrap()
}

fn error(format: Format, bytes: &[u8]) -> String {
    read(format, bytes, &mut |_| true).unwrap_err().to_string()
}

/// The unit cube by its corners, x first, and its sides, seen from outside against
/// the clock.
pub(super) fn corner(at: u32) -> [f32; 3] {
    [at & 1, at >> 1 & 1, at >> 2].map(|bit| bit as f32)
}

pub(super) const SIDES: [[u32; 4]; 6] = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
];

/// What a body holds, by the divergence theorem: a sixth of the sum of the
/// triangles' triple products. It sees missing, doubled and turned triangles.
pub(super) fn volume(mesh: &Mesh) -> f64 {
    let triangles = mesh.triangles.iter().map(|triangle| {
        let [a, b, c] = triangle.map(|at| mesh.points[at as usize]);
        a.dot(b.cross(c))
    });
    triangles.sum::<f64>() / 6.0
}

pub(super) fn is_cube(mesh: &Mesh) {
    assert_eq!((mesh.points.len(), mesh.triangles.len()), (8, 12));
    assert_eq!(volume(mesh), 1.0);
}

fn cube_as_triangles() -> Vec<[[f32; 3]; 3]> {
    let halves = |side: [u32; 4]| [[side[0], side[1], side[2]], [side[0], side[2], side[3]]];
    let triangles = SIDES.into_iter().flat_map(halves);
    triangles.map(|triangle| triangle.map(corner)).collect()
}

fn binary_stl() -> Vec<u8> {
    // As many programs write it: text, it seems.
    let mut bytes = b"solid cube".to_vec();
    bytes.resize(80, b' ');
    bytes.extend(12u32.to_le_bytes());
    for triangle in cube_as_triangles() {
        bytes.extend([0; 12]);
        let numbers = triangle.into_iter().flatten();
        bytes.extend(numbers.flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}

fn text_stl() -> String {
    let mut text = String::from("solid\n");
    for triangle in cube_as_triangles() {
        text += " facet normal 0 0 0\n  outer loop\n";
        for [x, y, z] in triangle {
            text += &format!("   vertex {x} {y} {z}\r\n");
        }
        text += "  endloop\n endfacet\n";
    }
    text + "endsolid cube\n"
}

fn obj() -> Vec<u8> {
    let mut text = String::from("# a cube\no cube\n");
    for [x, y, z] in (0..8).map(corner) {
        text += &format!("v {x} {y} {z}\n");
    }
    for (at, side) in SIDES.into_iter().enumerate() {
        let forward = side.map(|corner| format!("{}/1/{}", corner + 1, at + 1));
        let backward = side.map(|corner| format!("{}", i64::from(corner) - 8));
        let side = if at % 2 == 0 { forward } else { backward };
        text += &format!("f {}\n", side.join(" "));
    }
    // A name in Latin-1.
    [b"mtllib b\xe9ton.mtl\n", text.as_bytes()].concat()
}

fn ply(encoding: &str) -> Vec<u8> {
    let header = format!(
        "ply\nformat {encoding} 1.0\ncomment a cube\nelement vertex 8\n\
         property float x\nproperty float y\nproperty float z\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\n\
         element material 1\nproperty int shine\n\
         element face 6\nproperty list uchar int vertex_indices\n\
         element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
    );
    let mut bytes = header.into_bytes();
    let big = encoding == "binary_big_endian";
    if encoding == "ascii" {
        for [x, y, z] in (0..8).map(corner) {
            bytes.extend(format!("{x} {y} {z} 255 {} 0\n", 255.0 * x).bytes());
        }
        bytes.extend(b"7\n");
        for [a, b, c, d] in SIDES {
            bytes.extend(format!("4 {a} {b} {c} {d}\n").bytes());
        }
        bytes.extend(b"0 7\n");
        return bytes;
    }
    let float = |value: f32| {
        if big {
            value.to_be_bytes()
        } else {
            value.to_le_bytes()
        }
    };
    let int = |value: u32| {
        if big {
            value.to_be_bytes()
        } else {
            value.to_le_bytes()
        }
    };
    for place in (0..8).map(corner) {
        bytes.extend(place.into_iter().flat_map(float));
        bytes.extend([255, (255.0 * place[0]) as u8, 0]);
    }
    bytes.extend(int(7));
    for side in SIDES {
        bytes.push(4);
        bytes.extend(side.into_iter().flat_map(int));
    }
    bytes.extend([0, 7].into_iter().flat_map(int));
    bytes
}

#[test]
fn a_cube_is_one_in_each_format() {
    is_cube(&mesh(Format::Stl, &binary_stl()));
    is_cube(&mesh(Format::Stl, text_stl().as_bytes()));
    is_cube(&mesh(Format::Obj, &obj()));
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let mesh = mesh(Format::Ply, &ply(encoding));
        is_cube(&mesh);
        assert_eq!(mesh.lines, [[0, 7]]);
        let reddish = |at: u32| [255, 255 * (at & 1) as u8, 0];
        assert!(mesh.colours.iter().copied().eq((0..8).map(reddish)));
    }
}

#[test]
fn clouds_lines_and_colours() {
    let cloud = mesh(
        Format::Obj,
        b"v 1e-300 2 3 1 0 .5\nv 0.1 0.2 0.30000000000000004 0 0 0",
    );
    assert_eq!(cloud.points[1].z, 0.1 + 0.2);
    assert_eq!(cloud.colours, [[255, 0, 128], [0, 0, 0]]);
    // A weight is no colour, and a colour for some points is one for none.
    let some = mesh(
        Format::Obj,
        b"v 1 2 3 1\nv 1 2 3 1 1 1\nv 0 0 0\nl 1 2 -1 # there\np 1\n",
    );
    assert_eq!((some.colours.len(), some.lines), (0, vec![[0, 1], [1, 2]]));
}

#[test]
fn the_place_of_a_fault_is_named() {
    let said = |bytes: &[u8]| error(Format::Obj, bytes);
    assert_eq!(
        said(b"v 0 0 0\n\nv 1 2 NaN"),
        "line 3: expected three finite numbers"
    );
    assert_eq!(said(b"v 1 2"), "line 1: expected three finite numbers");
    let indices = "expected numbers of points that are in the file";
    assert_eq!(
        said(b"v 0 0 0\nf 1 2 3\nv 1 1 1"),
        format!("line 2: {indices}")
    );
    assert_eq!(said(b"v 0 0 0\nf 1 1"), format!("line 2: {indices}"));
    assert_eq!(said(b"v 0 0 0\nf 1 1 -2"), format!("line 2: {indices}"));
    assert_eq!(said(b"v 0 0 0\nl 0 1"), format!("line 2: {indices}"));
    assert_eq!(said(b"# nothing"), "there are no points in this file");
    assert!(said(b"v 0 0 0\nv 1e10 0 0").starts_with("point 2: "));

    let said = |bytes: &[u8]| error(Format::Stl, bytes);
    assert_eq!(
        said(b"solid\nfacet\nvertex 1 2 3\nendfacet"),
        "line 4: expected \"vertex\""
    );
    assert_eq!(said(b"solid\nvertex 1 2 3"), "line 2: expected \"facet\"");
    assert_eq!(said(b"solid\nfacet\n"), "the file ends too early");
    assert_eq!(said(b"PNG"), "this is no file of this format");
    let short = &binary_stl()[..300];
    assert_eq!(
        error(Format::Stl, &[b"x", &short[1..]].concat()),
        "the file ends too early"
    );
}

#[test]
fn a_header_that_claims_much_takes_little() {
    let claims = |header: &str| error(Format::Ply, header.as_bytes());
    let begin = "ply\nformat binary_little_endian 1.0\n";
    let end = "end_header\nabc";
    assert_eq!(
        claims(&format!(
            "{begin}element vertex 999999999999\nproperty float x\n{end}"
        )),
        "the file ends too early"
    );
    assert_eq!(
        claims(&format!(
            "{begin}element nothing 18446744073709551615\n{end}"
        )),
        "there are no points in this file"
    );
    let list = claims(&format!(
        "{begin}element face 1\nproperty list uint int x\n{end}"
    ));
    assert!(
        list.contains("end of file") || list.contains("EOF") || list.contains("fill"),
        "{list}"
    );
    assert!(!list.contains('\n'));
    // Four billion triangles.
    let mut stl = vec![0; 80];
    stl.extend([255; 4]);
    assert_eq!(error(Format::Stl, &stl), "the file ends too early");
}

#[test]
fn reading_can_be_stopped() {
    let mut asked = 0;
    let mut no = |share: f64| {
        assert!((0.0..=1.0).contains(&share));
        asked += 1;
        false
    };
    for (format, bytes) in [
        (Format::Obj, obj()),
        (Format::Stl, binary_stl()),
        (Format::Stl, text_stl().into_bytes()),
        (Format::Ply, ply("ascii")),
    ] {
        assert!(matches!(read(format, &bytes, &mut no), Err(Error::Stopped)));
    }
    assert_eq!(asked, 4);
}

#[test]
fn the_ending_names_the_format() {
    assert_eq!(Format::of(Path::new("a/b.PLY")), Some(Format::Ply));
    assert_eq!(Format::of(Path::new("a/obj")), None);
}

proptest! {
    /// Files with some bytes changed, cut or put in: an error or a mesh that holds
    /// together, never a panic.
    #[test]
    fn broken_files_are_refused_or_whole(
        which in 0..6usize,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..3), 1..12),
    ) {
        let (format, mut bytes) = match which {
            0 => (Format::Stl, binary_stl()),
            1 => (Format::Stl, text_stl().into_bytes()),
            2 => (Format::Obj, obj()),
            3 => (Format::Ply, ply("ascii")),
            4 => (Format::Ply, ply("binary_little_endian")),
            _ => (Format::Ply, ply("binary_big_endian")),
        };
        for (place, byte, how) in changes {
            let at = place.index(bytes.len().max(1)).min(bytes.len());
            match how {
                0 if at < bytes.len() => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                _ => bytes.truncate(at.max(bytes.len() / 2)),
            }
        }
        if let Ok(mesh) = read(format, &bytes, &mut |_| true) {
            prop_assert!(mesh.check().is_ok());
        }
    }
}
