//! Writes a scene's flight in the format that the file's name says: `convert flight.vid flight.html`.

use std::error::Error;
use std::path::Path;

use vides_document::SceneDocument;
use vides_formats::{Options, by_target, export};

fn main() -> Result<(), Box<dyn Error>> {
    let mut files = std::env::args().skip(1);
    let (Some(from), Some(to)) = (files.next(), files.next()) else {
        return Err("two files are wanted: flight.vid flight.html".into());
    };
    let (from, to) = (Path::new(&from), Path::new(&to));
    let options = Options::parse(&files.collect::<Vec<_>>().join("\n"))?;
    let document = SceneDocument::load(from)?;
    let report = export(&document, to, by_target(to)?, &options, &mut |_, _| {})?;
    for loss in report.losses() {
        eprintln!("{loss}");
    }
    Ok(())
}
