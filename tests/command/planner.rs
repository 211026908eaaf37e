//! Planned flights as a shell sees them.

use super::*;

/// How far the corners of an object reach in the picture at whole frames, as a share of it.
fn taken(file: &str, corners: &[[f64; 3]]) -> f64 {
    let mut most = 0.0_f64;
    for pose in poses_of(file) {
        let [eye, view, up] = [pose.vrp, pose.vpn, pose.vup];
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let turn = |k: usize| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            view[i] * up[j] - view[j] * up[i]
        };
        let right = [turn(0), turn(1), turn(2)];
        for corner in corners {
            let way = [0, 1, 2].map(|k| corner[k] - eye[k]);
            let depth = dot(way, view);
            assert!(depth > 0.0, "{pose:?}");
            let aside = (dot(way, right) / 18.0).abs();
            most = most.max(aside.max((dot(way, up) / 12.0).abs()) * pose.zoom / depth);
        }
    }
    most
}

/// By each of three ways a box is in the picture less margin, and nearly fills it once.
#[test]
fn a_box_is_kept_in_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    let [orbit, made] = ["orbit.vid", "made.vid"].map(|name| folder.path().join(name));
    let [orbit, made] = [orbit, made].map(|file| file.to_str().unwrap().to_owned());
    let moved = run(&[
        "move",
        "orbit",
        "--around",
        "0.6,0.3,0",
        "--zoom",
        "15",
        "-o",
        &orbit,
    ]);
    assert!(moved.status.success(), "{moved:?}");
    let corners: Vec<[f64; 3]> = (0..8)
        .map(|k| [0, 1, 2].map(|bit| if k >> bit & 1 == 0 { -0.2 } else { 0.25 }))
        .collect();
    let the_box = "--box=-0.2,-0.2,-0.2,0.25,0.25,0.25";
    for what in ["zoom", "distance", "view"] {
        let done = run(&[
            "picture", &orbit, the_box, "--margin", "0.05", "--what", what, "-o", &made,
        ]);
        assert!(done.status.success(), "{done:?}");
        let share = taken(&made, &corners) / 0.9;
        assert!((0.98..1.0005).contains(&share), "{what}: {share}");
        assert_eq!(poses_of(&made).len(), poses_of(&orbit).len());
    }
    let refused = |arguments: &[&str], status| {
        complaint(
            &run(&[&["picture", &orbit][..], arguments].concat()),
            status,
        )
    };
    assert!(refused(&[the_box, "--margin", "0.5"], 1).contains("margin"));
    assert!(refused(&[the_box, "--margin", "nan"], 1).contains("margin"));
    assert!(refused(&["--box=0.6,0.3,-3,0.6,0.3,3"], 1).contains("frame"));
    refused(&["--box=1,2,3"], 2);
    refused(&["--box=1,2,3,4,5,nan"], 1);
    refused(&["--node", "nothing"], 1);
    refused(&[], 1);
    refused(&[the_box, "--what", "else"], 2);
    // A single place is as large from anywhere.
    assert!(refused(&["--box=0,0,0,0,0,0", "--what", "distance"], 1).contains("single place"));
}

/// The pyramid as fast as its limits allow: a check finds none of them.
#[test]
fn a_path_is_retimed_within_its_limits() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("paced.vid");
    let file = file.to_str().unwrap();
    let told = |arguments: &[&str]| {
        let mut all = vec!["retime", PYRAMID, "-o", file];
        all.extend(arguments);
        let done = run(&all);
        assert!(done.status.success(), "{done:?}");
        let said = String::from_utf8(done.stderr).unwrap();
        let seconds = said.trim_end().strip_suffix(" s").unwrap();
        seconds.rsplit(' ').next().unwrap().parse::<f64>().unwrap()
    };
    let limits = ["--limit", "speed=0.5", "--limit", "acceleration=1"];
    let fastest = told(&limits);
    assert!((poses_of(file).len() as f64 - 1.0 - 25.0 * fastest).abs() < 1e-6);
    let limits_of_check = ["speed=0.5", "acceleration=1"];
    let checked = run(&[
        "check",
        file,
        "--limit",
        limits_of_check[0],
        "--limit",
        limits_of_check[1],
    ]);
    let found = String::from_utf8(checked.stdout).unwrap();
    for kind in ["  speed  ", "  acceleration  ", "  turning", "  zoom  "] {
        assert!(!found.contains(kind), "{found}");
    }
    // Exactly so long, or refused with the shortest time.
    let longer = format!("{}", (fastest * 2.0).ceil());
    let exact = told(&[&limits[..], &["--seconds", &longer]].concat());
    assert_eq!(exact, longer.parse::<f64>().unwrap());
    let wrong = complaint(
        &run(&[&["retime", PYRAMID, "--seconds", "0.2"][..], &limits].concat()),
        1,
    );
    assert!(
        wrong.contains(&format!("the limits allow it in {fastest:.3} s")),
        "{wrong}"
    );
    complaint(&run(&["retime", PYRAMID, "--limit", "speed=0"]), 1);
    complaint(&run(&["retime", PYRAMID, "--limit", "speed=nan"]), 2);
    complaint(&run(&["retime", PYRAMID, "--seconds", "-1"]), 2);
    complaint(&run(&["retime", PYRAMID, "--from", "0"]), 2);
    complaint(&run(&["retime", PYRAMID, "--to", "99"]), 1);
}
