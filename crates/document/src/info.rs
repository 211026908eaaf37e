//! What a file says besides the path itself: who it is for, how fast it is
//! shown, what the world's unit is called, what stands in the world.

use std::ops::Deref;
use std::sync::Arc;

use glam::DVec3;
use vides_engine::scene::MeshSource;
use vides_engine::tools::check::Limits;

use crate::error::{OutOfRange, Place, TooMany};
use crate::limits;
use crate::path::Space;
use vides_engine::Result;

/// Everything of a document that the engine does not read.
#[derive(Debug, Clone, PartialEq)]
pub struct Info {
    /// One line, at most [`limits::MAX_NAME_BYTES`].
    pub title: String,
    /// Any lines, at most [`limits::MAX_COMMENT_BYTES`].
    pub comment: String,
    /// Frames shown in a second; > 0, at most [`limits::MAX_FPS`].
    pub fps: f64,
    /// Number of the first frame in the user's film.
    pub first_frame: i32,
    /// Name of the world's unit ("m"), one line as the title; may be empty.
    pub unit: String,
    /// Wireframe object, shown for orientation.
    pub object: Object,
    /// Beyond which values a check tells.
    pub limits: Limits,
}

/// One point of a wireframe object (thesis B.2.2, `V_OBJEKT_LIST`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ObjectPoint {
    /// In the world.
    pub position: DVec3,
    /// Whether a line leads here from the point before; a document keeps
    /// `false` for the first.
    pub draw: bool,
}

/// The points of a wireframe object, and the file of the mesh whose wireframe it is;
/// shared, since they may be many and hardly ever change. None take no memory, so that a
/// path without an object can be made and copied where memory runs out.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Object {
    points: Option<Arc<Vec<ObjectPoint>>>,
    /// One for each point, or none.
    colours: Option<Arc<Vec<[u8; 3]>>>,
    source: Option<Arc<MeshSource>>,
}

impl From<Vec<ObjectPoint>> for Object {
    fn from(points: Vec<ObjectPoint>) -> Self {
        Self {
            points: (!points.is_empty()).then(|| Arc::new(points)),
            colours: None,
            source: None,
        }
    }
}

impl Object {
    /// The same, of the mesh in a file: a document keeps that one's name in place of the
    /// points.
    pub(super) fn of_source(self, source: MeshSource) -> Self {
        Self {
            source: Some(Arc::new(source)),
            ..self
        }
    }

    /// The same with a colour for each point, or none: red, green, blue. A document without the
    /// file of its mesh does not keep them.
    pub(super) fn coloured(self, colours: Vec<[u8; 3]>) -> Self {
        Self {
            colours: (colours.len() == self.len()).then(|| Arc::new(colours)),
            ..self
        }
    }

    /// What is drawn of it: lines, with the colour of their end if there is one; points
    /// that belong to none are lines without length.
    pub fn lines(&self) -> impl Iterator<Item = ([DVec3; 2], Option<[u8; 3]>)> + '_ {
        let colours = self.colours.as_ref().map(|colours| colours.as_slice());
        self.iter().enumerate().filter_map(move |(at, point)| {
            let colour = colours.and_then(|colours| colours.get(at).copied());
            let alone = !self.get(at + 1).is_some_and(|next| next.draw);
            match point.draw {
                true => Some((
                    [self.get(at.checked_sub(1)?)?.position, point.position],
                    colour,
                )),
                false => alone.then_some(([point.position; 2], colour)),
            }
        })
    }

    /// The file of its mesh; none if the document keeps the points.
    #[must_use]
    pub fn source(&self) -> Option<&MeshSource> {
        self.source.as_deref()
    }
}

impl Deref for Object {
    type Target = [ObjectPoint];

    fn deref(&self) -> &[ObjectPoint] {
        self.points.as_ref().map_or(&[], |points| points)
    }
}

impl Default for Info {
    fn default() -> Self {
        Self {
            title: String::new(),
            comment: String::new(),
            fps: 25.0,
            first_frame: 1,
            unit: String::new(),
            object: Object::default(),
            limits: Limits::default(),
        }
    }
}

impl Info {
    pub(super) fn try_clone(&self) -> Result<Self> {
        Ok(Self {
            title: copy_text(&self.title)?,
            comment: copy_text(&self.comment)?,
            fps: self.fps,
            first_frame: self.first_frame,
            unit: copy_text(&self.unit)?,
            object: self.object.clone(),
            limits: self.limits,
        })
    }

    /// Brings it into the form that documents keep: no line leads to the first
    /// point of an object.
    pub(super) fn normalise(&mut self) {
        if let Some(points) = &mut self.object.points
            && points.first().is_some_and(|first| first.draw)
        {
            Arc::make_mut(points)[0].draw = false;
        }
    }

    /// Whether every field is in its range, beside a path in this space.
    ///
    /// # Errors
    /// The first field that is not, with the reason.
    pub fn check(&self, space: Space) -> Result<()> {
        check_line(&self.title, Place::Title)?;
        check_comment(&self.comment)?;
        check_fps(self.fps)?;
        check_line(&self.unit, Place::Unit)?;
        if self.object.len() > limits::MAX_OBJECT_POINTS {
            return Err(TooMany::ObjectPoints.into());
        }
        for (index, point) in self.object.iter().enumerate() {
            space
                .check_place(point.position)
                .map_err(|error| error.at(Place::ObjectPoint(index + 1)))?;
        }
        Ok(())
    }
}

/// Frames per second that a film can have.
pub(super) fn check_fps(fps: f64) -> Result<()> {
    if !(fps > 0.0 && fps <= limits::MAX_FPS) {
        return Err(OutOfRange::Fps.into());
    }
    Ok(())
}

/// A comment: not too long.
pub(super) fn check_comment(comment: &str) -> Result<()> {
    if comment.len() > limits::MAX_COMMENT_BYTES {
        return Err(TooMany::CommentBytes.into());
    }
    Ok(())
}

/// A text that stands on one line: no control characters, not too long.
pub(super) fn check_line(text: &str, place: Place) -> Result<()> {
    crate::path::camera_path::check_name(text).map_err(|error| error.at(place))
}

/// A copy of a text, or `ErrorKind::Memory`.
pub(super) fn copy_text(text: &str) -> Result<String> {
    let mut copy = String::new();
    copy.try_reserve_exact(text.len())?;
    copy.push_str(text);
    Ok(copy)
}
