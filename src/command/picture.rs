//! `vides picture`: an object kept whole in the picture.

use clap::Args;
use vides::glam::DVec3;
use vides::planner::What;
use vides::scene::Mesh;

use super::call::Call;
use super::check::LimitOption;
use super::failure::Failure;
use super::given::{Numbers, exactly};
use super::input::{self, ObjectOption};
use super::progress::progress;

#[derive(Args)]
pub(super) struct Options {
    #[command(flatten)]
    object: ObjectOption,
    /// Only this object of the scene
    #[arg(long, value_name = "NAME", conflicts_with_all = ["object", "box"])]
    node: Option<String>,
    /// A box instead of an object: two opposite corners
    #[arg(long = "box", id = "box", value_name = "X,Y,Z,X,Y,Z", value_parser = exactly::<6>,
          allow_hyphen_values = true, conflicts_with = "object")]
    corners: Option<[f64; 6]>,
    #[command(flatten)]
    limits: LimitOption,
}

pub(super) fn run(call: &Call) -> Result<(), Failure> {
    let options: Options = call.more()?;
    let document = input::load_shown(call.file())?;
    let at_file = |error: vides::Error| call.at_file(error);
    let object = match (&options.node, options.corners) {
        (Some(node), _) => document.obstacles_of(Some(node)).map_err(at_file)?,
        (_, Some(corners)) => Some(corners_of(corners)),
        _ => options.object.mesh()?,
    };
    let object = document.solid(object.as_ref()).map_err(at_file)?;
    let numbers = Numbers::new(&call.tool, &call.given, &document)?;
    let how = (
        numbers.one("margin"),
        What::ALL[numbers.one("what") as usize],
    );
    let limits = options.limits.over(&document)?;
    let made = document.framed(&object, how, limits, &mut progress("places"));
    let made = made.map_err(at_file)?;
    let report = format!(
        "{} to {} of the room within the margin, {} points more",
        percent(made.loosest),
        percent(made.tightest),
        made.added
    );
    call.replace(document, made.path, [report])
}

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// The corners of a box.
fn corners_of([a, b, c, d, e, f]: [f64; 6]) -> Mesh {
    let corner = |k: usize| {
        let pick = |bit: usize, low: f64, high: f64| if k >> bit & 1 == 0 { low } else { high };
        DVec3::new(pick(0, a, d), pick(1, b, e), pick(2, c, f))
    };
    Mesh {
        points: (0..8).map(corner).collect(),
        ..Mesh::default()
    }
}
