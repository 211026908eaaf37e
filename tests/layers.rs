//! The arrows between the crates, as ARCHITECTURE.md draws them: each crate
//! depends on those named here and on no other of this workspace.

use std::process::Command;

use serde_json::Value;

const ARROWS: &[(&str, &[&str])] = &[
    ("vides-engine", &[]),
    ("vides-document", &["vides-engine", "vides-mesh"]),
    ("vides-mesh", &["vides-engine"]),
    (
        "vides-formats",
        &["vides-document", "vides-engine", "vides-mesh"],
    ),
    ("vides-raster", &[]),
    ("vides-x11", &["vides-engine", "vides-raster"]),
    (
        "vides-editor",
        &[
            "vides-document",
            "vides-engine",
            "vides-formats",
            "vides-raster",
        ],
    ),
    (
        "vides-window",
        &[
            "vides-document",
            "vides-editor",
            "vides-engine",
            "vides-raster",
            "vides-x11",
        ],
    ),
    ("vides-archive", &["vides"]),
    (
        "vides",
        &[
            "vides-document",
            "vides-engine",
            "vides-formats",
            "vides-raster",
            "vides-window",
        ],
    ),
];

/// What cargo says of the workspace's packages.
fn packages() -> Vec<Value> {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--locked", "--offline", "--no-deps"])
        .args(["--format-version", "1", "--manifest-path"])
        .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml"))
        .output()
        .expect("cargo");
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("what cargo says");
    metadata["packages"].as_array().expect("packages").clone()
}

#[test]
fn crates_depend_on_what_lies_below_them() {
    let packages = packages();
    assert_eq!(packages.len(), ARROWS.len());
    for package in packages {
        let name = package["name"].as_str().expect("a name");
        let mut uses: Vec<_> = package["dependencies"]
            .as_array()
            .expect("dependencies")
            .iter()
            .filter(|dependency| dependency["kind"].is_null())
            .filter_map(|dependency| dependency["name"].as_str())
            .filter(|name| name.starts_with("vides"))
            .collect();
        uses.sort_unstable();
        let (_, drawn) = ARROWS
            .iter()
            .find(|(from, _)| *from == name)
            .unwrap_or_else(|| panic!("{name}: no layer of ARCHITECTURE.md"));
        assert_eq!(uses, *drawn, "{name}");
    }
}
