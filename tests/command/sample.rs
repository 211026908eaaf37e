//! `vides sample` as a shell sees it.

use super::*;

#[test]
fn ascii_has_a_line_for_each_frame() {
    let text = said(&run(&["sample", PYRAMID]));
    let poses = poses_of(PYRAMID);
    assert_eq!(text.lines().count(), poses.len());
    for (line, pose) in text.lines().zip(&poses) {
        let fields: Vec<&str> = line.split(' ').collect();
        assert_eq!(fields.len(), 10, "{line}");
        for (field, number) in fields.iter().zip(numbers(pose)) {
            let (_, decimals) = field.split_once('.').unwrap();
            assert_eq!(decimals.len(), 4, "{line}");
            let written: f64 = field.parse().unwrap();
            assert!(
                (written - number).abs() <= 0.5001e-4,
                "{field} for {number}"
            );
        }
    }
}

#[test]
fn csv_has_every_bit() {
    let text = said(&run(&["sample", "--format", "csv", PYRAMID]));
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some("frame,vrp_x,vrp_y,vrp_z,vpn_x,vpn_y,vpn_z,vup_x,vup_y,vup_z,zoom,seconds")
    );
    let poses = poses_of(PYRAMID);
    assert_eq!(lines.clone().count(), poses.len());
    for (index, (line, pose)) in lines.zip(&poses).enumerate() {
        let row = parsed(line.split(','));
        assert_eq!(row[0], (index + 1) as f64);
        assert_eq!(row[1..11], numbers(pose), "frame {}", index + 1);
        // 25 frames a second, the first at 0.
        assert_eq!(row[11..], [index as f64 / 25.0]);
    }
}

#[test]
fn ascii_has_as_many_digits_as_asked() {
    let usual = said(&run(&["sample", PYRAMID]));
    assert_eq!(said(&run(&["sample", PYRAMID, "--digits", "4"])), usual);
    for digits in [0, 1, 9, 30] {
        let text = said(&run(&["sample", PYRAMID, "--digits", &digits.to_string()]));
        let poses = poses_of(PYRAMID);
        assert_eq!(text.lines().count(), poses.len());
        for (line, pose) in text.lines().zip(&poses) {
            for (field, number) in line.split(' ').zip(numbers(pose)) {
                let decimals = field.split_once('.').map_or(0, |(_, behind)| behind.len());
                assert_eq!(decimals, digits, "{field}");
                let off = (field.parse::<f64>().unwrap() - number).abs();
                assert!(
                    off <= 0.501 * 0.1_f64.powi(digits as i32),
                    "{field} for {number}"
                );
            }
        }
    }
    for wrong in ["31", "-1", "2.5", "many"] {
        complaint(&run(&["sample", PYRAMID, "--digits", wrong]), 2);
    }
    let said = sentence(
        &run(&["sample", PYRAMID, "--digits", "6", "--format", "csv"]),
        2,
    );
    assert_eq!(
        said,
        "vides: --digits goes with the format ascii; csv and json have all digits\n"
    );
}

#[test]
fn json_has_every_bit() {
    let text = said(&run(&["sample", "--format=json", PYRAMID]));
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["title"], "Around the pyramid");
    assert_eq!(json["fps"], 25.0);
    assert_eq!(json["space"]["half_size"], 1.0);
    let poses = poses_of(PYRAMID);
    assert_eq!(json["frame_count"], poses.len());
    let written = json["poses"].as_array().unwrap();
    assert_eq!(written.len(), poses.len());
    for (json, pose) in written.iter().zip(&poses) {
        assert_eq!(json["vrp"], serde_json::json!(pose.vrp));
        assert_eq!(json["vpn"], serde_json::json!(pose.vpn));
        assert_eq!(json["vup"], serde_json::json!(pose.vup));
        assert_eq!(json["zoom"], pose.zoom);
    }
}

#[test]
fn a_file_holds_what_standard_output_would() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("out.txt");
    let name = file.to_str().unwrap();
    for format in ["ascii", "csv", "json"] {
        let expected = said(&run(&["sample", PYRAMID, "--format", format]));
        let explicit = said(&run(&["sample", PYRAMID, "--format", format, "-o", "-"]));
        assert_eq!(explicit, expected);
        assert_eq!(
            said(&run(&["sample", PYRAMID, "--format", format, "-o", name])),
            ""
        );
        assert_eq!(fs::read_to_string(&file).unwrap(), expected);
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_dash_is_standard_input() {
    let file = fs::read(PYRAMID).unwrap();
    for command in ["sample", "info"] {
        let from_file = said(&run(&[command, PYRAMID]));
        let from_input = said(&run_with_input(&[command, "-"], &file));
        assert_eq!(from_input, from_file.replace(PYRAMID, "standard input"));
    }
    let broken = run_with_input(&["info", "-"], b"version = 1\nfps = \"fast\"\n");
    assert!(sentence(&broken, 1).starts_with("vides: standard input: line 2: "));
}

#[test]
fn pipes_and_devices_take_the_place_of_files() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe");
    let made = Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    let name = pipe.to_str().unwrap().to_owned();
    let name = name.as_str();
    let expected = said(&run(&["sample", PYRAMID]));

    let writer = {
        let pipe = pipe.clone();
        std::thread::spawn(move || fs::write(pipe, fs::read(PYRAMID).unwrap()).unwrap())
    };
    assert_eq!(said(&run(&["sample", name])), expected);
    writer.join().unwrap();

    let reader = std::thread::spawn(move || fs::read_to_string(pipe).unwrap());
    assert_eq!(said(&run(&["sample", PYRAMID, "--output", name])), "");
    assert_eq!(reader.join().unwrap(), expected);

    said(&run(&["sample", PYRAMID, "-o", "/dev/null"]));
}

#[test]
fn a_way_counts_in_half_sizes() {
    let arguments = ["sample", "-", "--format", "csv"];
    let text = said(&run_with_input(&arguments, IN_A_WORLD.as_bytes()));
    let rows: Vec<_> = text
        .lines()
        .skip(1)
        .map(|line| parsed(line.split(',')))
        .collect();
    assert_eq!(rows.len(), 11);
    assert_eq!(rows[0][..4], [101.0, 90.0, 5.0, -5.0]);
    assert_eq!(rows[10][..4], [111.0, 110.0, 5.0, -5.0]);
    for row in &rows {
        assert_eq!(row[4..10], [-1.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    }
}

#[test]
fn base_speeds_stand_in_for_the_files() {
    let frames = |more: &[&str]| {
        let arguments = [&["sample", "-"], more].concat();
        let output = run_with_input(&arguments, ONE_OF_EACH.as_bytes());
        said(&output).lines().count()
    };
    assert_eq!(frames(&[]), 1 + 7 + 5 + 3 + 2);
    assert_eq!(frames(&["--move-frames", "70"]), 1 + 70 + 5 + 3 + 2);
    assert_eq!(frames(&["--turn-frames", "50"]), 1 + 7 + 50 + 3 + 2);
    assert_eq!(frames(&["--zoom-frames=30"]), 1 + 7 + 5 + 30 + 2);
    assert_eq!(frames(&["--roll-frames", "2e1"]), 1 + 7 + 5 + 3 + 20);
}

#[test]
fn a_reader_that_has_enough_is_no_error() {
    let long = ["sample", PYRAMID, "--move-frames", "1e6"];
    let mut command = vides(&long);
    let mut child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    assert_eq!(lines.next().unwrap().unwrap().split(' ').count(), 10);
    drop(lines);
    let mut complaints = String::new();
    child
        .stderr
        .take()
        .unwrap()
        .read_to_string(&mut complaints)
        .unwrap();
    assert_eq!(complaints, "");
    assert_eq!(child.wait().unwrap().code(), Some(0));
}
