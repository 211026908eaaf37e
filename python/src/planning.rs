//! What is planned for a path: each tool one step of its history.

use vides::document::{Document, Edit};
use vides::planner::{Request, retime};
use vides::tools::check::{FindingKind, Limits};

use crate::error::{Failure, Result};

/// Those of the path's check, but for what is given by name.
fn limits(of: Limits, given: &[(String, f64)]) -> Result<Limits> {
    let mut limits = of;
    for (name, limit) in given {
        let kind = FindingKind::all()
            .into_iter()
            .find(|kind| kind.name().replace('-', "_") == *name)
            .ok_or_else(|| Failure::argument(format!("there is no limit {name:?}")))?;
        limits.set(kind, *limit)?;
    }
    Ok(limits)
}

/// Where the pace rests: point, orientation, limit.
pub(crate) type Rests = Vec<(usize, usize, &'static str)>;

/// Computes the pace of points anew: the seconds that they take, and where it rests.
pub(crate) fn retimed(
    document: &mut Document,
    seconds: f64,
    points: [usize; 2],
    given: &[(String, f64)],
) -> Result<(f64, Rests)> {
    let request = Request {
        limits: limits(document.info().limits, given)?,
        fps: document.info().fps,
        points: Some(points),
        seconds,
    };
    let made = retime(document.path(), &request)?;
    document.apply(Edit::ReplacePath(Box::new(made.path)))?;
    let rests = made.rests.iter();
    let rests = rests.map(|rest| (rest.point, rest.orientation, rest.limit.name()));
    Ok((made.seconds, rests.collect()))
}
