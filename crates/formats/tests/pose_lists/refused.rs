//! What is wrong in lists of poses is told in one sentence with its place.

use vides_formats::{Options, Source, by_name, import};

const TURNS: &str = "a matrix that turns and does not mirror";

/// Reading fails with this sentence and nothing else.
fn refused(name: &str, text: &str, said: &str) {
    refused_bytes(name, text.into(), said);
}

fn refused_bytes(name: &str, bytes: Vec<u8>, said: &str) {
    let source = Source::of_bytes("file", bytes);
    let format = by_name(name).unwrap();
    let error = import(&source, Some(format), &Options::default()).unwrap_err();
    assert_eq!(error.to_string(), format!("file: {said}"), "{name}");
}

#[test]
fn what_is_wrong_in_lines_is_one_sentence_with_its_place() {
    for (name, text, said) in [
        (
            "tum",
            "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0",
            "line 2: expected 8 numbers, found 7",
        ),
        (
            "tum",
            "# a\n0 0 0 0 0 0 0 0",
            "line 2: the rotation is zero",
        ),
        (
            "tum",
            "0 0 0 nan 0 0 0 1",
            "line 1: the number must be finite",
        ),
        (
            "tum",
            "0 0 0 1e999 0 0 0 1",
            "line 1: the number must be finite",
        ),
        (
            "tum",
            "1 0 0 0 0 0 0 1\n0.5 0 0 0 0 0 0 1",
            "line 2: the times must increase",
        ),
        ("tum", "#", "there are no poses in this file"),
        ("osg", "a 0 0 0 0 0 0 1", "line 1: expected a number"),
        (
            "kitti",
            "1 0 0 0 0 1 0 0 0 0 1",
            "line 1: expected 12 numbers, found 11",
        ),
        (
            "kitti",
            "1 0 0 0 0 1 0 0 0 0 -1 0",
            &format!("line 1: expected {TURNS}"),
        ),
        (
            "matrices",
            "1 0 0 0\n0 1 0 0\n\n0 0 1 0",
            "line 4: the file ends too early",
        ),
        (
            "matrices",
            "1 0 0 0\n0 1 0 0\n0 0 1 0 0",
            "line 3: expected 4 numbers, found 5",
        ),
        (
            "matrices",
            "1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1",
            "line 1: expected a matrix whose last row is 0 0 0 1",
        ),
        (
            "matrices",
            "1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1",
            &format!("line 1: expected {TURNS}"),
        ),
        (
            "matrices",
            "2 1 0 0 0 0 1 0 0 0 0 1 0\n2 1 0 0 0 0 1 0 0 0 0 1 0",
            "line 2: the times must increase",
        ),
        ("matrices", "0 0 0", "line 1: expected 16 numbers, found 3"),
        ("matrices", "", "there are no poses in this file"),
        (
            "open3d",
            "0 0 1\n1 0 0 1\n0 1 0 2\n0 0 1 3",
            "line 4: the file ends too early",
        ),
        ("open3d", "0 0 1", "line 1: the file ends too early"),
        ("open3d", "0 0", "line 1: expected 3 numbers, found 2"),
        (
            "open3d",
            "0 0 1\n1 0 0 1\n0 1 0 2\n0 0 -1 3\n0 0 0 1",
            &format!("line 2: expected {TURNS}"),
        ),
        (
            "chan",
            "1 0 0 0 0 0 0 60\n0 0 0 0 0 0 0 60",
            "line 2: the times must increase",
        ),
        ("chan", "1 0 0 0 0 0", "line 1: expected 8 numbers, found 6"),
        (
            "ascii",
            "0 0 0 0 0 -1 0 1 0 24\n0 0 0 0 0 -1 0 1 0 nan",
            "line 2: the number must be finite",
        ),
        (
            "csv",
            "frame\n1,inf,0,0,0,0,-1,0,1,0,24",
            "line 2: the number must be finite",
        ),
        ("colmap", "", "cameras.txt is not there"),
    ] {
        refused(name, text, said);
    }
}

#[test]
fn what_is_wrong_in_trees_is_one_sentence_with_its_place() {
    let deep = format!("{{\"frames\": {}", "[".repeat(200_000));
    let frame = |matrix: &str| format!("{{\"frames\": [{{\"transform_matrix\": {matrix}}}]}}");
    let zeros = frame("[[0,0,0,0],[0,0,0,0],[0,0,0,0]]");
    let mirror = frame("[[1,0,0,0],[0,1,0,0],[0,0,-1,0],[0,0,0,1]]");
    for (name, text, said) in [
        ("nerfstudio", "{}", "keyframes is not there"),
        (
            "nerfstudio",
            "{\"camera_path\": 3}",
            "camera_path: expected an array",
        ),
        (
            "nerfstudio",
            "{\"camera_path\": [{\"fov\": 3}]}",
            "camera_path[0]: camera_to_world is not there",
        ),
        (
            "nerfstudio",
            "{\"camera_path\": [{\"camera_to_world\": [1]}]}",
            "camera_path[0].camera_to_world: expected 16 numbers, found 1",
        ),
        (
            "nerfstudio",
            "{\"keyframes\": [{\"matrix\": \"[1, 2\"}]}",
            "keyframes[0].matrix: expected 16 numbers",
        ),
        (
            "nerfstudio",
            "{\"fps\": 0}",
            "fps: expected a number greater than 0",
        ),
        (
            "nerfstudio",
            "[1",
            "line 1: EOF while parsing a list (column 2)",
        ),
        (
            "transforms",
            "{\"frames\": []}",
            "there are no poses in this file",
        ),
        (
            "transforms",
            &zeros,
            &format!("frames[0].transform_matrix: expected {TURNS}"),
        ),
        (
            "transforms",
            &mirror,
            &format!("frames[0].transform_matrix: expected {TURNS}"),
        ),
        (
            "transforms",
            &frame("[1, 2]"),
            "frames[0].transform_matrix: expected a matrix of 4 × 4 numbers",
        ),
        (
            "transforms",
            &deep,
            "line 1: recursion limit exceeded (column 138)",
        ),
        ("cameras", "{}", "expected an array"),
        (
            "cameras",
            "[{\"rotation\": [[1,0,0],[0,1,0],[0,0,1]], \"position\": [1, 2, \"3\"]}]",
            "[0].position[2]: expected a number",
        ),
        (
            "cameras",
            "[{\"rotation\": [[1,0,0],[0,1,0],[0,0,1]], \"position\": [1, 2, 3], \"fy\": -1, \"height\": 2}]",
            "[0].fy: expected a number greater than 0",
        ),
    ] {
        refused(name, text, said);
    }
}

/// Nanoseconds, and a frame far away: a sentence at once, where a fit would go through all frames.
#[test]
fn times_far_apart_are_refused_before_any_work() {
    let most = "at most 100000000 are allowed: check their unit, times are seconds";
    let ends = |last: &str, pose: &str| {
        ["0", "1", "2", last]
            .map(|time| format!("{time} {time}{pose}\n"))
            .concat()
    };
    let tum = ends("99000000000", " 0 0 0 0 0 1");
    let said = format!("the times of the poses span 2475000000000 frames, {most}");
    refused("tum", &tum, &said);
    let chan = ends("1000000000", " 0 0 0 0 0 40");
    refused(
        "chan",
        &chan,
        &format!("the times of the poses span 1000000000 frames, {most}"),
    );
    // As keys, too.
    for (name, text) in [("tum", tum), ("chan", chan)] {
        let source = Source::of_bytes("file", text.into());
        let options = Options::parse("as=keys").unwrap();
        let made = import(&source, by_name(name).ok(), &options);
        let flown = made.map(|made| made.document.scene.frame_count());
        assert!(!matches!(flown, Ok(Ok(_))), "{name}");
    }
}

#[test]
fn what_is_wrong_in_an_array_is_one_sentence_with_its_place() {
    let array = |header: &str, data: &[u8]| {
        let length = u16::try_from(header.len()).unwrap().to_le_bytes();
        let head = b"\x93NUMPY\x01\x00";
        [head, &length[..], header.as_bytes(), data].concat()
    };
    let of = |kind: &str, shape: &str| {
        format!("{{'descr': {kind}, 'fortran_order': False, 'shape': {shape}, }}")
    };
    let (doubles, floats) = (of("'<f8'", "(1, 4, 4)"), of("'<f4'", "(2, 3, 4)"));
    let nan = f64::NAN.to_le_bytes().repeat(16);
    for (bytes, said) in [
        (
            b"\x93NUMPY\x01\x00".to_vec(),
            "byte 8: the file ends too early",
        ),
        (array("", b""), "byte 10: expected \"descr\""),
        (
            array(&of("'>f8'", "(1, 4, 4)"), b""),
            "byte 10: descr '>f8' is not read",
        ),
        (
            array(&of("[('x', '<f8')]", "(1,)"), b""),
            "byte 10: descr [('x' is not read",
        ),
        (
            array(&doubles.replace("False", "True"), b""),
            "byte 10: fortran_order True is not read",
        ),
        (
            array(&of("'<f8'", "(2, 16)"), b""),
            "byte 10: expected an array of N × 4 × 4 or N × 3 × 4 numbers",
        ),
        (
            array(&of("'<f8'", "(9223372036854775807, 4, 4)"), b"1234"),
            "byte 94: the file ends too early",
        ),
        (
            array(&doubles, &[0; 127]),
            "byte 199: the file ends too early",
        ),
        (
            array(&doubles, &[0; 128]),
            "byte 72: expected a matrix whose last row is 0 0 0 1",
        ),
        (array(&doubles, &nan), "byte 72: the number must be finite"),
        (
            array(&floats, &[0; 96]),
            &format!("byte 72: expected {TURNS}"),
        ),
        (
            array(&of("'<f8'", "(0, 4, 4)"), b""),
            "there are no poses in this file",
        ),
    ] {
        refused_bytes("matrices", bytes, said);
    }
}

#[test]
fn what_is_wrong_in_a_trajectory_of_open3d_is_one_sentence_with_its_place() {
    let camera = |extrinsic: &str, width: i32, focal: f64| {
        format!(
            "{{\"parameters\": [{{\"extrinsic\": {extrinsic}, \"intrinsic\": {{\"width\": {width}, \
             \"height\": 480, \"intrinsic_matrix\": [{focal},0,0,0,{focal},0,319.5,239.5,1]}}}}]}}"
        )
    };
    let identity = "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
    for (text, said) in [
        ("{}", "parameters is not there"),
        (
            "{\"parameters\": [{}]}",
            "parameters[0]: extrinsic is not there",
        ),
        (
            &camera("[1]", 640, 525.0),
            "parameters[0].extrinsic: expected 16 numbers, found 1",
        ),
        (
            &camera("[1,0,0,4,0,1,0,5,0,0,1,6,0,0,0,1]", 640, 525.0),
            "parameters[0].extrinsic: expected a matrix whose last row is 0 0 0 1",
        ),
        (
            &camera("[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1]", 640, 525.0),
            &format!("parameters[0].extrinsic: expected {TURNS}"),
        ),
        (
            &camera(identity, -1, 525.0),
            "parameters[0].intrinsic.width: expected a number greater than 0",
        ),
        (
            &camera(identity, 640, 0.0),
            "parameters[0].intrinsic.intrinsic_matrix: expected a number greater than 0",
        ),
    ] {
        refused("open3d", text, said);
    }
}

#[test]
fn what_is_wrong_in_a_path_of_instant_ngp_is_one_sentence_with_its_place() {
    let key = |key: &str| format!("{{\"path\": [{{{key}}}]}}");
    for (text, said) in [
        ("{}", "path is not there"),
        ("{\"path\": []}", "there are no poses in this file"),
        (&key(""), "path[0]: R is not there"),
        (
            &key("\"R\": [0, 0, 1]"),
            "path[0].R: expected 4 numbers, found 3",
        ),
        (&key("\"R\": [1, 0, 0, 0]"), "path[0]: T is not there"),
        (
            &key("\"R\": [0, 0, 0, 0], \"T\": [0, 0, 0]"),
            "path[0].R: the rotation is zero",
        ),
        (
            &key("\"R\": [1, 0, 0, 0], \"T\": [0, 0, 0], \"fov\": 0"),
            "path[0].fov: expected a number greater than 0",
        ),
    ] {
        refused("instant-ngp", text, said);
    }
}

#[test]
fn what_is_wrong_in_a_track_of_supersplat_is_one_sentence_with_its_place() {
    let track = |times: &str, targets: &str| {
        format!(
            "{{\"animTracks\": [{{\"frameRate\": 30, \"keyframes\": {{\"times\": {times}, \
             \"values\": {{\"position\": [0,0,0,0,0,0], \"target\": {targets}}}}}}}]}}"
        )
    };
    let document = |pose: &str| format!("{{\"poseSets\": [{{\"poses\": [{pose}, {pose}]}}]}}");
    let pose = "{\"frame\": 1, \"position\": [0,0,0], \"target\": [0,0,1]}";
    for (text, said) in [
        ("{}", "poseSets is not there"),
        ("{\"animTracks\": []}", "there are no poses in this file"),
        ("{\"poseSets\": []}", "there are no poses in this file"),
        (
            "{\"animTracks\": [{}]}",
            "animTracks[0]: keyframes is not there",
        ),
        (
            &track("[0, 1]", "[0,0,1]"),
            "animTracks[0].keyframes.values.target: expected 6 numbers, found 3",
        ),
        (
            &track("[1, 0]", "[0,0,1,0,0,1]"),
            "animTracks[0].keyframes.times[1]: the times must increase",
        ),
        (
            &track("[0, 1]", "[0,0,1,0,0,0]"),
            "animTracks[0].keyframes.values.target[3]: the rotation is zero",
        ),
        (
            &document(pose),
            "poseSets[0].poses[1].target: the times must increase",
        ),
        (
            &document("{\"frame\": 1}"),
            "poseSets[0].poses[0]: target is not there",
        ),
    ] {
        refused("supersplat", text, said);
    }
}

#[test]
fn what_is_wrong_in_metadata_of_record3d_is_one_sentence_with_its_place() {
    let pose = "\"poses\": [[0,0,0,1,0,0,0], [0,0,0,1,1,0,0]]";
    for (text, said) in [
        ("{}", "poses is not there"),
        (
            "{\"poses\": [[0,0,0,1,0,0]]}",
            "poses[0]: expected 7 numbers, found 6",
        ),
        (
            "{\"poses\": [[0,0,0,0,0,0,0]]}",
            "poses[0]: the rotation is zero",
        ),
        (
            &format!("{{{pose}, \"frameTimestamps\": [0]}}"),
            "frameTimestamps: expected one for each of 2 poses, found 1",
        ),
        (
            &format!("{{{pose}, \"frameTimestamps\": [1, 1]}}"),
            "frameTimestamps[1]: the times must increase",
        ),
        (
            &format!("{{{pose}, \"perFrameIntrinsicCoeffs\": [[1, 1, 1, 1]]}}"),
            "perFrameIntrinsicCoeffs: expected one for each of 2 poses, found 1",
        ),
        (
            &format!("{{{pose}, \"K\": [0, 0, 0, 0, 0, 0, 0, 0, 1]}}"),
            "K: expected a number greater than 0",
        ),
    ] {
        refused("record3d", text, said);
    }
}

/// The file of a folder is named, too.
#[test]
fn what_is_wrong_in_a_file_of_a_folder_is_one_sentence_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let mirror = include_str!("../../../../tests/corpus/formats/polycam/mirror.json");
    let focal = include_str!("../../../../tests/corpus/formats/polycam/no_focal.json");
    for (name, files, said) in [
        (
            "matrices",
            [("0.txt", "1 0 0 0"), ("1.txt", "")],
            "0.txt: line 1: the file ends too early",
        ),
        (
            "polycam",
            [("1.json", mirror), ("2.json", "")],
            &format!("1.json: expected {TURNS}"),
        ),
        (
            "polycam",
            [("1.json", focal), ("2.json", "")],
            "1.json: fx is not there",
        ),
        (
            "polycam",
            [("a.json", ""), ("0.txt", "")],
            "there are no poses in this file",
        ),
    ] {
        let place = folder.path().join(name);
        let _ = std::fs::remove_dir_all(&place);
        std::fs::create_dir(&place).unwrap();
        for (file, text) in files {
            std::fs::write(place.join(file), text).unwrap();
        }
        let source = Source::open(&place).unwrap();
        let error = import(&source, by_name(name).ok(), &Options::default()).unwrap_err();
        let place = place.display();
        let between = if said.starts_with("there") { ": " } else { "/" };
        assert_eq!(error.to_string(), format!("{place}{between}{said}"));
    }
}
