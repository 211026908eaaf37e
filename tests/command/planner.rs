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
    assert!(refused(&[the_box, "--margin", "nan"], 2).contains("margin"));
    assert!(refused(&["--box=0.6,0.3,-3,0.6,0.3,3"], 1).contains("frame"));
    refused(&["--box=1,2,3"], 2);
    refused(&["--box=1,2,3,4,5,nan"], 2);
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
    assert!((poses_of(file).len() as f64 - 25.0 * fastest).abs() < 1e-6);
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
    complaint(&run(&["retime", PYRAMID, "--seconds", "-1"]), 1);
    complaint(&run(&["retime", PYRAMID, "--first", "0"]), 1);
    complaint(&run(&["retime", PYRAMID, "--last", "99"]), 1);
}

/// Poses that shake: it is told how far they went, and a bound holds.
#[test]
fn a_recorded_flight_becomes_steady() {
    let folder = tempfile::tempdir().unwrap();
    let [poses, shaken, file] = ["poses.txt", "shaken.vid", "steady.vid"]
        .map(|name| folder.path().join(name).to_str().unwrap().to_owned());
    let smooth = |k: usize| [0.01 * k as f64, 0.5 * (0.02 * k as f64).sin()];
    let line = |k: usize| {
        let [x, y] = smooth(k);
        let y = y + [0.004, -0.004][k % 2];
        format!("{x} {y} 0 0 0 1 0 1 0 30\n")
    };
    std::fs::write(&poses, (0..200).map(line).collect::<String>()).unwrap();
    let fitted = run(&["fit", &poses, "--tolerance", "0.0001", "-o", &shaken]);
    assert!(fitted.status.success(), "{fitted:?}");
    let made = |options: &[&str]| {
        let done = run(&[
            &["steady", &shaken, "-o", &file, "--period", "1"][..],
            options,
        ]
        .concat());
        assert!(done.status.success(), "{done:?}");
        let said = String::from_utf8(done.stderr).unwrap();
        let far = said.split(" went ").nth(1).unwrap();
        far.split(' ').next().unwrap().parse::<f64>().unwrap()
    };
    let far = made(&[]);
    // Beside an end, which stays shaken, by twice the shaking at most.
    assert!(far > 0.0035 && far < 0.008, "{far}");
    let again = poses_of(&file);
    assert_eq!(again.len(), 200);
    assert!(made(&["--within", "0.003"]) <= 0.003);
    let wrong = complaint(&run(&["steady", &shaken, "--period", "81"]), 1);
    assert!(wrong.contains("at most 80 s"), "{wrong}");
    complaint(&run(&["steady", &shaken, "--period", "nan"]), 2);
    complaint(&run(&["steady", &shaken, "--within=-1"]), 1);
    complaint(&run(&["steady", &shaken, "--seconds", "1"]), 2);
    // The default is a second.
    let whole = std::fs::read(&file).unwrap();
    assert_eq!(made(&[]), far);
    let second = std::fs::read(&file).unwrap();
    let said = run(&["steady", &shaken]);
    assert!(said.status.success() && said.stdout == second && whole != second);
}

/// The sides of a box in OBJ, its corners counted by x, then y, then z.
const SIDES: [&str; 6] = [
    "1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6",
];

/// A mast in the way of the pyramid's flight: gone round, or told where there is no way.
#[test]
fn a_way_is_led_clear_of_an_object() {
    let folder = tempfile::tempdir().unwrap();
    let [mesh, file, again] = ["mast.obj", "clear.vid", "again.vid"].map(|name| {
        let file = folder.path().join(name);
        file.to_str().unwrap().to_owned()
    });
    let [x, y, z] = poses_of(PYRAMID)[40].vrp;
    std::fs::write(
        &mesh,
        format!("v {x} {} {z}\nv {x} {} {z}\nl 1 2\n", y - 9.0, y + 9.0),
    )
    .unwrap();
    let arguments = ["avoid", PYRAMID, "--object", &mesh, "--clearance", "0.05"];
    let done = run(&[&arguments[..], &["--radius", "0.01", "-o", &file]].concat());
    assert!(done.status.success(), "{done:?}");
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(said.contains("put in") || said.contains("moved"), "{said}");
    assert_eq!(poses_of(&file).len(), poses_of(PYRAMID).len());
    for pose in poses_of(&file) {
        let [a, _, c] = pose.vrp;
        assert!((a - x).hypot(c - z) >= 0.06 - 1e-9);
    }
    // What is clear stays, to the last byte.
    let more = [
        "avoid",
        &file,
        "--object",
        &mesh,
        "--clearance",
        "0.05",
        "-o",
        &again,
    ];
    let done = run(&more);
    assert!(
        String::from_utf8(done.stderr)
            .unwrap()
            .contains("clear as it is")
    );
    let bytes = [&file, &again].map(|file| std::fs::read(file).unwrap());
    assert_eq!(bytes[0], bytes[1]);
    // A closed box around where it begins.
    let [x, y, z] = poses_of(PYRAMID)[0].vrp;
    let mut box_around = String::new();
    for k in 0..8 {
        let [a, b, c] = [k & 1, k >> 1 & 1, k >> 2].map(|far| 0.1 * f64::from(far) - 0.05);
        box_around += &format!("v {} {} {}\n", x + a, y + b, z + c);
    }
    for side in SIDES {
        box_around += &format!("f {side}\n");
    }
    let closed = folder.path().join("box.obj");
    std::fs::write(&closed, box_around).unwrap();
    let closed = closed.to_str().unwrap();
    let wrong = complaint(
        &run(&["avoid", PYRAMID, "--object", closed, "--clearance", "0.01"]),
        1,
    );
    assert!(
        wrong.contains("at frame ") && wrong.contains("no way round"),
        "{wrong}"
    );
    for (bad, status) in [("0", 1), ("-1", 1), ("nan", 2), ("inf", 2), ("1e300", 1)] {
        let arguments = ["avoid", PYRAMID, "--object", &mesh, "--clearance", bad];
        complaint(&run(&arguments), status);
    }
}

/// A cube of twelve triangles: all is shown, a check finds nothing, the same bytes each time.
#[test]
fn an_object_gets_a_tour() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let object = place("cube.obj");
    let mut text = String::new();
    for k in 0..8 {
        text += &format!("v {} {} {}\n", k & 1, k >> 1 & 1, k >> 2);
    }
    for side in SIDES {
        text += &format!("f {side}\n");
    }
    std::fs::write(&object, text).unwrap();
    let (first, second) = (place("first.vid"), place("second.vid"));
    for out in [&first, &second] {
        let done = run(&[
            "tour",
            &object,
            "-o",
            out,
            "--seconds",
            "30",
            "--coverage",
            "1",
        ]);
        assert!(done.status.success(), "{done:?}");
        let told = String::from_utf8(done.stderr).unwrap();
        assert!(
            told.contains("show 100.0 % of the surface") && told.contains("30.000 s"),
            "{told}"
        );
    }
    assert_eq!(
        std::fs::read(&first).unwrap(),
        std::fs::read(&second).unwrap()
    );
    let checked = run(&["check", &first]);
    assert!(checked.status.success(), "{checked:?}");
    let stills = place("stills.vid");
    let done = run(&["tour", &object, "-o", &stills, "--stills"]);
    assert!(
        done.status.success() && (3..9).contains(&poses_of(&stills).len()),
        "{done:?}"
    );
    let inside = run(&[
        "tour",
        &object,
        "--inside",
        "--start",
        "0.5,0.5,0.5",
        "--up",
        "z",
    ]);
    assert!(inside.status.success(), "{inside:?}");
    for (more, status) in [
        (&["--seconds", "0.1"][..], 1),
        (&["--coverage", "0"], 1),
        (&["--distance", "1e300"], 1),
        (&["--distance=-1"], 1),
        (&["--start", "0.5,0.5,0.5"], 1),
        (&["--start", "1,2"], 2),
        (&["--up", "x"], 2),
        (&["--stills", "--seconds", "3"], 2),
    ] {
        let said = complaint(&run(&[&["tour", &object][..], more].concat()), status);
        assert!(!said.is_empty());
    }
    complaint(&run(&["tour", PYRAMID]), 1);
    complaint(&run(&["tour", &place("none.obj")]), 1);
}
