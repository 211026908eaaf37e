//! Planned flights as a shell sees them.

use super::*;

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
            &["steady", &shaken, "-o", &file, "--seconds", "1"][..],
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
    let wrong = complaint(&run(&["steady", &shaken, "--seconds", "81"]), 1);
    assert!(wrong.contains("at most 80 s"), "{wrong}");
    complaint(&run(&["steady", &shaken, "--seconds", "nan"]), 1);
    complaint(
        &run(&["steady", &shaken, "--seconds", "1", "--within", "0"]),
        2,
    );
    complaint(&run(&["steady", &shaken]), 2);
}
