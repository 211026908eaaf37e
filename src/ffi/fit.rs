//! Paths fitted to recorded poses.

use std::ffi::{c_char, c_int};

use super::border::border;
use super::by_name::named;
use super::path::insert_new;
use super::pointers::{Out, optional, slice, text};
use super::progress::watched;
use super::status::{Failure, V_ERR_INTERNAL, add_last_warning};
use super::toolbox::{clear_last_report, report_number};
use super::types::{V_PATH, V_POSE};
use crate::document::Document;
use crate::document::tool::{Needs, tools};
use crate::path::{Pose, Space, Up};
use crate::tools::fit::{Options, Tolerance, fit, fit_points};

/// Fits a path of few points to recorded poses: each position within tolerance, each
/// view, up and field of view within angle degrees, at its time. Noise below that is
/// removed. Poses that jerk between whole frames may be missed.
///
/// seconds  when each pose was taken, in order; NULL: one per frame. Of equal times
///     the first counts. Times beyond 1e11 count nanoseconds or microseconds
/// count  at least two
/// options  lines of name=value; NULL: none. fps (25); tolerance (a thousandth of the
///     diagonal of the positions); angle (0.5); points, at most that many, from which
///     the tolerance follows; robust=yes leaves out outliers, poses farther than the
///     tolerance from what their neighbours suggest; up (y or z); space, its centre
///     and half its edge (the smallest cube around the positions, enlarged by a
///     tenth)
///
/// v_last_warning() returns points, deviations, holds, gaps, cuts, outliers, and what
/// helps against many points; v_last_number() "tolerance", "left_out" (poses).
/// V_ERR_ARGUMENT (times that run backwards, a view without direction), V_ERR_LIMIT
/// (times that span more than 100,000,000 frames), V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_fit_poses(
    poses: *const V_POSE,
    seconds: *const f64,
    count: usize,
    options: *const c_char,
    path: *mut *mut V_PATH,
) -> c_int {
    clear_last_report();
    border(V_ERR_INTERNAL, || {
        let out = Out::new(path, "path")?;
        // SAFETY: so many poses, as the header says; the layouts are one.
        let poses = unsafe { slice(poses.cast::<Pose>(), count, "poses") }?;
        // SAFETY: so many doubles, as the header says.
        let seconds = optional(seconds, |seconds| unsafe {
            slice(seconds, count, "seconds")
        })?;
        // SAFETY: a zero-terminated text, as the header says.
        let lines = optional(options, |options| unsafe { text(options, "options") })?;
        let tool = tools().find(|tool| tool.needs() == Needs::Poses);
        let tool = tool.ok_or_else(|| Failure::NoTool("fit".into()))?.alone();
        let given = named(tool.options(&Document::try_new()?, lines.unwrap_or("")))?;
        let more = |name: &str| given.more(name).map(|numbers| numbers[0]);
        let usual = Tolerance::usual(poses);
        let up = Up::ALL[usize::from(more("up") == Some(1.0))];
        let space = given.more("space").map(|space| Space {
            centre: glam::DVec3::from_slice(space),
            half_size: space[3],
            up,
        });
        if let Some(space) = space {
            space.check()?;
        }
        let options = Options {
            tolerance: Tolerance {
                position: match given.has("tolerance") {
                    true => given.number("tolerance"),
                    false => usual.position,
                },
                angle: given.number("angle"),
            },
            space,
            up,
            robust: given.number("robust") != 0.0,
        };
        let fps = more("fps").unwrap_or(25.0);
        let (fitted, tolerance) = watched(|go_on| match given.whole("points") {
            0 => {
                let fitted = fit(poses, seconds, fps, &options, go_on)?;
                Ok((fitted, options.tolerance))
            }
            points => Ok(fit_points(poses, seconds, fps, &options, points, go_on)?),
        })?;
        // A sentence for each line.
        for line in fitted.report.to_string().lines() {
            let (first, rest) = line.split_at(1);
            add_last_warning(format_args!("{}{rest}.", first.to_uppercase()));
        }
        let (first, count) = (fitted.left_out.first(), fitted.left_out.len());
        if let Some(first) = first {
            let are = if count == 1 { "pose is" } else { "poses are" };
            add_last_warning(format_args!(
                "{count} {are} left out, first poses[{first}]."
            ));
        }
        report_number("tolerance", tolerance.position);
        report_number("left_out", count as f64);
        let made = insert_new(fitted.path, fps)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}
