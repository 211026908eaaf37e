//! An object kept in the picture of a document's path ([`vides_engine::planner::picture`]).

use vides_engine::planner::picture::{What, keep_all_in_picture, orientation_towards};
use vides_engine::planner::{Framed, PictureRequest};
use vides_engine::tools::check::Limits;
use vides_engine::tools::clearance::Clearance;
use vides_engine::tools::fit::Progress;

use super::edit::Edit;
use super::edit::Selection;
use super::editing::Document;
use crate::error::Result;

impl Document {
    /// The path with all of an object in its picture less margin.
    ///
    /// # Errors
    /// As [`vides_engine::planner::keep_in_picture`].
    pub fn framed(
        &self,
        object: &Clearance,
        (margin, what): (f64, What),
        limits: Limits,
        progress: Progress<'_>,
    ) -> Result<Framed> {
        let request = PictureRequest {
            margin,
            what,
            limits,
            fps: self.info().fps,
        };
        Ok(keep_all_in_picture(
            self.path(),
            object,
            &request,
            progress,
        )?)
    }

    /// The edit by which one orientation looks at the middle of an object and shows it as large as
    /// the margin allows.
    ///
    /// # Errors
    /// [`vides_engine::Error::Argument`] where no zoom shows it whole, [`vides_engine::Error::Range`].
    pub fn object_shown(&self, at: Selection, object: &Clearance, margin: f64) -> Result<Edit> {
        let key = (at.point, at.orientation);
        Ok(Edit::SetOrientation {
            point: at.point,
            at: at.orientation,
            orientation: orientation_towards(self.path(), key, object, margin)?,
        })
    }
}
