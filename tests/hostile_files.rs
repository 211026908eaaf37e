//! Files that the fuzzer in `fuzz/` begins with, or that it found to do harm:
//! each is refused with a sentence, or is a document in order. Those of setup
//! and recovery are replayed beside their readers (`crates/editor/src/hostile.rs`).

#[path = "hostile/mesh.rs"]
mod mesh;
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
