//! Files that the fuzzer in `fuzz/` begins with, or that it found to do harm:
//! each is refused with a sentence, or is a document in order. Those of setup
//! and recovery are replayed beside their readers (`crates/editor/src/hostile.rs`).

#[path = "hostile/mesh.rs"]
mod mesh;
#[path = "hostile/planner.rs"]
mod planner;
#[path = "hostile/vid.rs"]
mod vid;

#[test]
fn meshes_of_the_corpus_are_refused_or_in_order() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut count = 0;
    for entry in std::fs::read_dir(root.join("tests/corpus/mesh")).unwrap() {
        mesh::check(&std::fs::read(entry.unwrap().path()).unwrap());
        count += 1;
    }
    assert!(count >= 3, "{count} files");
}

#[test]
fn files_of_the_corpus_are_refused_or_in_order() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut count = 0;
    for folder in ["tests/corpus", "tests/corpus/vid", "examples"] {
        for entry in std::fs::read_dir(root.join(folder)).unwrap() {
            let file = entry.unwrap().path();
            if file.extension().is_some_and(|ending| ending == "vid") {
                println!("{}", file.display());
                vid::check(&std::fs::read(&file).unwrap());
                count += 1;
            }
        }
    }
    assert!(count > 50, "{count} files");
}

#[test]
fn what_is_planned_in_the_corpus_is_in_order() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = std::fs::read_dir(root.join("tests/corpus/planner")).unwrap();
    let mut count = 0;
    for file in files.map(|file| file.unwrap().path()) {
        println!("{}", file.display());
        planner::check(&std::fs::read(&file).unwrap());
        count += 1;
    }
    assert!(count >= 5, "{count} files");
}

/// What to plan, by pseudo-random bytes; `VIDES_PATHS` says how many.
#[test]
fn whatever_is_to_be_planned_is_refused_or_in_order() {
    let count = std::env::var("VIDES_PATHS").map_or(120, |count| count.parse().unwrap());
    let (mut random, mut made) = (random(), 0);
    for case in 0..count {
        let bytes: Vec<u8> = random.by_ref().take(160).collect();
        println!("case {case}: {bytes:?}");
        made += usize::from(planner::check(&bytes));
    }
    assert!(made * 5 > count, "{made} of {count} were made");
}

/// Recordings of pseudo-random bytes.
#[test]
fn whatever_is_recorded_is_fitted_or_refused() {
    let count = std::env::var("VIDES_PATHS").map_or(120, |count| count.parse().unwrap());
    let (mut random, mut made) = (random(), 0);
    for case in 0..count {
        let mut bytes: Vec<u8> = random.by_ref().take(800).collect();
        bytes[0] = 255;
        println!("case {case}: {bytes:?}");
        made += usize::from(planner::check(&bytes));
    }
    assert!(made * 5 > count, "{made} of {count} were made");
}

fn random() -> impl Iterator<Item = u8> {
    let next = |state: &u64| {
        let next = state.wrapping_mul(6_364_136_223_846_793_005);
        Some(next.wrapping_add(1_442_695_040_888_963_407))
    };
    std::iter::successors(Some(7_u64), next)
        .skip(1)
        .map(|state| (state >> 56) as u8)
}
