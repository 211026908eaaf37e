//! Out and in.

use super::*;
use crate::document::SceneDocument;
use std::path::PathBuf;

fn write_files(name: &str, document: &SceneDocument, options: &Options) {
    let folder = std::env::var_os("GLTF_OUT").map(PathBuf::from).unwrap();
    for ending in ["glb", "gltf"] {
        let file = folder.join(format!("{name}.{ending}"));
        let format = crate::by_name(ending).unwrap();
        let report = crate::export(document, &file, format, options, &mut |_, _| {}).unwrap();
        println!("{name}.{ending}: {:?}", report.losses());
    }
}

#[test]
#[ignore = "by hand"]
fn write_all() {
    for name in ["pyramid", "car"] {
        let file = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples"));
        let document = SceneDocument::load(&file.join(format!("{name}.vid"))).unwrap();
        write_files(name, &document, &Options::default());
        let compact = Options {
            compact: Some(0.001),
            ..Options::default()
        };
        write_files(&format!("{name}-compact"), &document, &compact);
    }
}
