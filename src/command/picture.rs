//! `vides picture`: an object kept whole in the picture.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;
use vides::document::Edit;
use vides::glam::DVec3;
use vides::planner::{DEFAULT_MARGIN, What};
use vides::scene::Mesh;
use vides::tools::check::FindingKind;

use super::check::limit;
use super::failure::{Failure, complain};
use super::input;
use super::output::Output;
use super::progress::progress;

#[derive(Args)]
pub(super) struct Arguments {
    /// The path, or a scene, for its shown camera; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// Replaces the path's object: a mesh (.obj, .ply, .stl, .gltf, .glb)
    /// or the object of a .vid file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["node", "box"])]
    object: Option<PathBuf>,
    /// Only this object of the scene
    #[arg(long, value_name = "NAME", conflicts_with = "box")]
    node: Option<String>,
    /// A box instead of an object: two opposite corners
    #[arg(
        long,
        value_name = "X,Y,Z,X,Y,Z",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    r#box: Option<Vec<f64>>,
    /// Free margin on each side, as a share of the picture's width and height
    #[arg(long, value_name = "SHARE", default_value_t = DEFAULT_MARGIN)]
    margin: f64,
    /// What to change to keep the object in the picture
    #[arg(long, default_value = "zoom", value_parser = PossibleValuesParser::new(What::NAMES))]
    what: String,
    /// Overrides a limit of the file, as in zoom=10; zoom=off removes it. Used here: zoom; for
    /// --what distance, speed and acceleration
    #[arg(long, value_name = "KIND=LIMIT", value_parser = limit)]
    limit: Vec<(FindingKind, f64)>,
    #[command(flatten)]
    output: Output,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let document = input::load_shown(&arguments.file)?;
    let name = input::name(&arguments.file);
    let at_file = |error: vides::Error| Failure::from(error.at(name.clone()));
    let mut limits = document.info().limits;
    for (kind, limit) in &arguments.limit {
        limits.set(*kind, *limit)?;
    }
    let object = match (&arguments.object, &arguments.node, &arguments.r#box) {
        (Some(file), ..) => Some(input::object(file)?.to_mesh()?),
        (_, Some(node), _) => document.obstacles_of(Some(node)).map_err(at_file)?,
        (.., Some(corners)) => Some(corners_of(corners)?),
        _ => None,
    };
    let object = document.solid(object.as_ref()).map_err(at_file)?;
    let what = What::named(&arguments.what).unwrap_or_default();
    let made = document.framed(
        &object,
        (arguments.margin, what),
        limits,
        &mut progress("places"),
    );
    let made = made.map_err(at_file)?;
    complain(&format!(
        "{name}: {} to {} of the room within the margin, {} points more",
        percent(made.loosest),
        percent(made.tightest),
        made.added
    ));
    let edit = Edit::ReplacePath(Box::new(made.path));
    arguments.output.applied(document, &arguments.file, edit)
}

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// The corners of a box.
fn corners_of(numbers: &[f64]) -> Result<Mesh, Failure> {
    let &[a, b, c, d, e, f] = numbers else {
        return Err(Failure::Usage("--box takes six numbers".to_owned()));
    };
    let corner = |k: usize| {
        let pick = |bit: usize, low: f64, high: f64| if k >> bit & 1 == 0 { low } else { high };
        DVec3::new(pick(0, a, d), pick(1, b, e), pick(2, c, f))
    };
    Ok(Mesh {
        points: (0..8).map(corner).collect(),
        ..Mesh::default()
    })
}
