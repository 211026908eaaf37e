//! What a document holds: a value that shares all it has with its copies.
//!
//! An edit changes a copy, which is put into the document if nothing was wrong; an undo puts back
//! what was there before. What an edit leaves alone is the same in both, pointer by pointer.

use std::sync::Arc;

use super::edit::Selection;
use super::edited_scene::EditedScene;
use super::info::Info;
use super::normalise::{count_orientations, normalise};
use super::vid::Comments;
use crate::error::Result;
use vides_engine::path::fit_frames::Fixed;
use vides_engine::path::{CameraPath, Orientation, OrientationOverrides, SupportPoint};
use vides_engine::property::SameBits;

#[derive(Debug, Clone)]
pub(super) struct Content {
    /// The path that is edited, or a stand-in where none is.
    pub(super) path: Arc<CameraPath>,
    /// The scene of the path; none: the path is all there is.
    pub(super) scene: Option<Arc<EditedScene>>,
    pub(super) info: Arc<Info>,
    pub(super) comments: Arc<Comments>,
    pub(super) selection: Selection,
    /// Number of orientations of all points.
    pub(super) orientations: usize,
    /// New with each edit that a file would show.
    pub(super) number: u64,
    /// Unique to these contents within the process.
    pub(super) revision: u64,
}

impl Content {
    pub(super) fn new(path: CameraPath, info: Info, revision: u64) -> Self {
        Self {
            orientations: count_orientations(&path.points),
            path: Arc::new(path),
            scene: None,
            info: Arc::new(info),
            comments: Arc::default(),
            selection: Selection::default(),
            number: 0,
            revision,
        }
    }

    /// Whether both have the same, because one is a copy of the other that no edit has changed.
    pub(super) fn shares_all(&self, other: &Self) -> bool {
        let scenes = match (&self.scene, &other.scene) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        scenes
            && Arc::ptr_eq(&self.path, &other.path)
            && Arc::ptr_eq(&self.info, &other.info)
            && Arc::ptr_eq(&self.comments, &other.comments)
    }

    /// The node whose path is edited; none: there is no scene, or no path is.
    pub(super) fn node(&self) -> Option<usize> {
        self.scene.as_ref().and_then(|edited| edited.node())
    }

    /// Checks what the file is to have besides the path, where the path lies and where the scene
    /// does: files are read by the second.
    pub(super) fn check_info(&self, info: &Info) -> Result<()> {
        info.check(self.path.space)?;
        if let Some(edited) = &self.scene {
            info.check(edited.scene().space())?;
        }
        Ok(())
    }

    /// Puts a point in the place of another one, unless they are the same bit by bit.
    pub(super) fn set_point(&mut self, at: usize, point: SupportPoint) {
        let old = &self.path.points[at];
        if !old.same_bits(&point) {
            self.orientations -= old.orientations.len();
            self.orientations += point.orientations.len();
            Arc::make_mut(&mut self.path).points.set(at, point);
        }
    }

    /// Puts an orientation in the place of another one, unless they are the same bit by bit.
    pub(super) fn set_view(&mut self, [point, at]: [usize; 2], view: Orientation) {
        if !self.path.points[point].orientations[at].same_bits(&view) {
            self.views_mut(point)[at] = view;
        }
    }

    fn views_mut(&mut self, point: usize) -> &mut Vec<Orientation> {
        &mut Arc::make_mut(&mut self.path).points[point].orientations
    }

    pub(super) fn set_frames(&mut self, fixed: Vec<Fixed>) -> Result<()> {
        for fixed in fixed {
            let view = &self.path.points[fixed.point].orientations[fixed.orientation];
            let own = view.own.with(|own| own.frames = fixed.frames)?;
            let view = Orientation {
                own,
                ..view.clone()
            };
            self.set_view([fixed.point, fixed.orientation], view);
        }
        Ok(())
    }

    /// Inserts points; the first becomes current.
    pub(super) fn insert_points(&mut self, at: usize, points: Vec<Arc<SupportPoint>>) {
        let count = points.len();
        let views = points.iter().map(|point| point.orientations.len());
        self.orientations += views.sum::<usize>();
        Arc::make_mut(&mut self.path).points.insert_all(at, points);
        self.renumber_points(|point| Some(if point < at { point } else { point + count }));
        self.selection = Selection::at(at, 0);
    }

    /// Removes a point; its predecessor, else the new first one, becomes current.
    pub(super) fn remove_point(&mut self, at: usize) {
        let point = Arc::make_mut(&mut self.path).points.remove(at);
        self.orientations -= point.orientations.len();
        self.renumber_points(|point| match point {
            point if point < at => Some(point),
            point => (point > at).then(|| point - 1),
        });
        self.selection = Selection::at(at.saturating_sub(1), 0);
    }

    /// Gives a point another place; it becomes current.
    pub(super) fn move_point(&mut self, from: usize, to: usize) {
        if from != to {
            let points = &mut Arc::make_mut(&mut self.path).points;
            let point = points.remove(from);
            points.insert(to, point);
            self.renumber_points(|point| {
                Some(match point {
                    point if point == from => to,
                    point if from < point && point <= to => point - 1,
                    point if to <= point && point < from => point + 1,
                    point => point,
                })
            });
            self.selection = Selection::at(to, 0);
        }
    }

    /// Inserts an orientation; it becomes current.
    pub(super) fn insert_view(&mut self, [point, at]: [usize; 2], view: Orientation) {
        self.views_mut(point).insert(at, view);
        self.orientations += 1;
        self.renumber_views(point, |old| Some(if old < at { old } else { old + 1 }));
        self.selection = Selection::at(point, at);
    }

    /// Removes an orientation; its predecessor, else the new first one, becomes current.
    pub(super) fn remove_view(&mut self, [point, at]: [usize; 2]) {
        self.views_mut(point).remove(at);
        self.orientations -= 1;
        self.renumber_views(point, |old| match old {
            old if old < at => Some(old),
            old => (old > at).then(|| old - 1),
        });
        self.selection = Selection::at(point, at.saturating_sub(1));
    }

    /// Lets pins and comments follow points that have other numbers now, or none.
    fn renumber_points(&mut self, number: impl Fn(usize) -> Option<usize>) {
        let id = self.node_id();
        if self.comments.has_points(id) {
            Arc::make_mut(&mut self.comments).renumber_points(id, &number);
        }
        self.renumber_pins(number);
    }

    fn renumber_pins(&mut self, number: impl Fn(usize) -> Option<usize>) {
        if let Some(edited) = &mut self.scene
            && edited.pinned().next().is_some()
        {
            Arc::make_mut(edited).renumber_pins(number);
        }
    }

    fn renumber_views(&mut self, point: usize, number: impl Fn(usize) -> Option<usize>) {
        let id = self.node_id();
        if self.comments.has_points(id) {
            Arc::make_mut(&mut self.comments).renumber_views(id, point, number);
        }
    }

    fn node_id(&self) -> Option<vides_engine::scene::NodeId> {
        let edited = self.scene.as_ref()?;
        Some(edited.scene().ids()[edited.node()?])
    }

    /// Puts another path in the place of the one that is edited; `number` is the one that a point
    /// gets in it. Its first point becomes current.
    pub(super) fn replace_path(
        &mut self,
        mut path: CameraPath,
        number: impl Fn(usize) -> usize,
    ) -> Result<()> {
        normalise(&mut path)?;
        self.info.check(path.space)?;
        let count = path.points.len();
        self.renumber_pins(|point| Some(number(point)).filter(|&point| point < count));
        let id = self.node_id();
        if self.comments.has_points(id) {
            Arc::make_mut(&mut self.comments).renumber_points(id, |_| None);
        }
        self.put_path(path);
        self.selection = Selection::default();
        Ok(())
    }

    pub(super) fn put_path(&mut self, path: CameraPath) {
        self.orientations = count_orientations(&path.points);
        self.path = Arc::new(path);
    }

    /// About how many bytes it takes that another one does not share.
    pub(super) fn heap_size_without(&self, other: &Self) -> usize {
        let mut bytes = size_of::<Self>();
        if !Arc::ptr_eq(&self.path, &other.path) {
            let points = self.path.points.without(&other.path.points);
            bytes +=
                size_of::<CameraPath>() + self.path.points.heap_size_without(&other.path.points);
            bytes += points.map(heap_size).sum::<usize>();
        }
        if let Some(edited) = &self.scene {
            bytes += edited.heap_size_without(other.scene.as_deref());
        }
        if !Arc::ptr_eq(&self.info, &other.info) {
            let info = &self.info;
            bytes += info.title.len() + info.comment.len();
            if !info.object.shares(&other.info.object) {
                bytes += info.object.bytes();
            }
        }
        if !Arc::ptr_eq(&self.comments, &other.comments) {
            bytes += self.comments.heap_size();
        }
        bytes
    }
}

fn heap_size(point: &SupportPoint) -> usize {
    let own = |view: &&Orientation| !view.own.is_empty();
    let owned = point.orientations.iter().filter(own).count();
    size_of::<SupportPoint>()
        + point.name.as_ref().map_or(0, String::len)
        + size_of_val(&point.orientations[..])
        + owned * size_of::<OrientationOverrides>()
}
