//! The keys of the path on the scale of its frames.

use vides_document::error::Result;
use vides_document::{Document, Selection};
use vides_engine::path::{Change, Timeline};

use crate::playing::axis::as_frame;
use crate::state::playing::{Mark, Marks};

impl Mark {
    /// The frame in which the key is reached.
    pub(crate) fn first(self) -> f64 {
        as_frame(self.frame)
    }

    /// The last frame that shows it.
    pub(crate) fn last(self) -> f64 {
        as_frame(self.frame + self.hold)
    }
}

impl Marks {
    pub(super) fn update(&mut self, document: &Document) -> Result<()> {
        let revision = document.revision();
        if self.revision == Some(revision) {
            return Ok(());
        }
        self.revision = Some(revision);
        self.keys.clear();
        self.markers.clear();
        self.graph.clear();
        self.frames = 0;
        self.range = (1.0, 1.0);
        if let Some(edited) = document.edited_scene() {
            let markers = edited.scene().markers().iter();
            self.markers
                .extend(markers.map(|marker| (marker.frame, marker.name.clone())));
        }
        let range = document.frame_range()?;
        if !document.edits_path() {
            // No path is edited, so there are no keys to show.
            self.frames = document.timeline(Timeline::frame_count)??;
            self.range = range;
            return Ok(());
        }
        let path = document.path();
        let keys = &mut self.keys;
        self.frames = document.timeline(|timeline| {
            let mut frame = 1;
            for index in 0..timeline.section_count() {
                let section = timeline.section(index);
                let (point, orientation) = (section.point, section.orientation);
                keys.try_reserve(2)?;
                let hold = if section.change == Change::Nothing {
                    0
                } else {
                    path.points[point].orientations[orientation].hold as usize
                };
                keys.push(Mark {
                    point,
                    orientation,
                    frame,
                    hold,
                });
                if section.change != Change::Nothing {
                    frame += hold + section.frames;
                }
            }
            if let Some(point) = path.points.len().checked_sub(1).filter(|_| !path.closed) {
                let orientation = path.points[point].orientations.len().saturating_sub(1);
                let hold = usize::MAX - frame;
                keys.push(Mark {
                    point,
                    orientation,
                    frame,
                    hold,
                });
            }
            timeline.frame_count()
        })??;
        self.range = range;
        self.graph.update(document, &self.keys)
    }

    /// The first key that is reached at a frame.
    pub(super) fn at(&self, frame: usize) -> Option<Selection> {
        let next = self.keys.partition_point(|mark| mark.frame < frame);
        let mark = self.keys.get(next).filter(|mark| mark.frame == frame)?;
        Some(Selection::at(mark.point, mark.orientation))
    }

    /// The markers between the first frame and the last one.
    pub(super) fn markers_there(&self) -> impl Iterator<Item = &(f64, String)> {
        let (first, last) = self.range;
        let within = move |marker: &&(f64, String)| (first..=last).contains(&marker.0);
        self.markers.iter().filter(within)
    }

    pub(super) fn of(&self, selection: Selection) -> Option<Mark> {
        let mut keys = self.keys.iter().copied();
        keys.find(|mark| Selection::at(mark.point, mark.orientation) == selection)
    }
}
