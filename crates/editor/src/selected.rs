//! Several points that are selected together, and what is done to all of them.
//!
//! The current point of the thesis is always one of them: the panels show it, and what is changed
//! of it is changed of the others.

use std::borrow::Cow;

use glam::DMat4;
use vides_document::error::Result;
use vides_document::{At, Document, Edit};
use vides_engine::path::{Orientation, OrientationOverrides, SupportPoint};
use vides_engine::property::{SameBits, Value, find};

use crate::state::Editor;
use crate::state::selected::{Selected, SelectionChange, SelectionScope};
use crate::texts::fill;

impl Selected {
    /// Forgets a selection that no longer holds.
    pub(crate) fn follow(&mut self, document: &Document) {
        if !self.points.is_empty() && self.of != SelectionScope::now(document) {
            self.points.clear();
        }
    }
}

impl Editor {
    /// The menu text that removes the selected points.
    pub(crate) fn removal(&self) -> Cow<'static, str> {
        let texts = &self.texts().menu;
        match self.all_selected().len() {
            ..2 => texts.remove_point.into(),
            many => fill(texts.remove_points, &[&many]).into(),
        }
    }

    /// The points selected together, ascending; `None` if the current one is alone, or no path is
    /// edited.
    pub(crate) fn several(&self) -> Option<&[usize]> {
        let selected = &self.selected;
        let several = selected.points.len() > 1
            && selected.of == SelectionScope::now(&self.document)
            && self.document.edits_path();
        several.then_some(&selected.points)
    }

    pub(crate) fn is_selected(&self, at: usize) -> bool {
        match self.several() {
            Some(points) => points.binary_search(&at).is_ok(),
            None => at == self.document.selection().point,
        }
    }

    /// All selected points, at least the current one.
    pub(crate) fn all_selected(&self) -> Vec<usize> {
        let several = self.several().map(<[usize]>::to_vec);
        several.unwrap_or_else(|| vec![self.document.selection().point])
    }

    pub(crate) fn choose(&mut self, choice: SelectionChange) {
        let current = self.document.selection().point;
        let mut points = self.all_selected();
        match choice {
            SelectionChange::Current => points = vec![current],
            SelectionChange::Only(at) => {
                self.select(at.point, at.orientation);
                points = vec![self.document.selection().point];
            }
            SelectionChange::All => points = (0..self.document.path().points.len()).collect(),
            SelectionChange::UpTo(to) => points = (current.min(to)..=current.max(to)).collect(),
            SelectionChange::These(these) => points = these,
            SelectionChange::Switch(at) if self.is_selected(at) => {
                points.retain(|&other| other != at);
            }
            SelectionChange::Switch(at) => {
                points.push(at);
                self.select(at, 0);
            }
        }
        points.sort_unstable();
        points.dedup();
        let current = self.document.selection().point;
        if points.binary_search(&current).is_err() {
            let nearest = points.iter().min_by_key(|at| at.abs_diff(current));
            match nearest {
                Some(&nearest) => self.select(nearest, 0),
                None => points.push(current),
            }
        }
        self.keep_selected(points);
    }

    /// Makes a point current, and keeps the selection if it is part of that.
    pub(crate) fn select_among(&mut self, at: usize) -> Result<()> {
        let points = self.all_selected();
        self.document.select(at, 0)?;
        if points.binary_search(&at).is_ok() {
            self.keep_selected(points);
        }
        Ok(())
    }

    fn keep_selected(&mut self, points: Vec<usize>) {
        self.selected = Selected {
            points,
            of: SelectionScope::now(&self.document),
        };
    }

    /// Removes all selected points in one step.
    pub(crate) fn remove_selected(&mut self) -> bool {
        let points = self.all_selected();
        let points = points.into_iter().rev();
        self.edit_all(points.map(|at| Edit::RemovePoint { at }))
    }

    /// Moves all selected points, in their order, before the one that is number `before` now.
    pub(crate) fn move_selected(&mut self, before: usize) {
        let points = self.all_selected();
        let current = self.document.selection();
        let first_behind = points.partition_point(|&at| at < before);
        let (ahead, behind) = points.split_at(first_behind);
        let ahead = ahead.iter().rev().enumerate();
        let ahead = ahead.map(|(k, &from)| (from, before - 1 - k));
        let behind = behind.iter().enumerate();
        let behind = behind.map(|(k, &from)| (from, before + k));
        let edits = ahead.chain(behind);
        let edits: Vec<Edit> = edits
            .map(|(from, to)| Edit::MovePoint { from, to })
            .collect();
        if self.edit_all(edits) {
            let first = before - first_behind;
            let moved = points.iter().position(|&at| at == current.point);
            let now = first + moved.unwrap_or_default();
            self.select(now, current.orientation);
            self.keep_selected((first..first + points.len()).collect());
        }
    }

    /// Does an edit of the current point to all selected ones: they move by as much, and in their
    /// orientations of the same number the same values change. Within a drag it replaces what the
    /// drag has done so far.
    pub(crate) fn edit_selected(&mut self, edit: Edit) -> bool {
        if self.several().is_some() {
            self.restart_step();
        }
        let points = self.several().unwrap_or_default();
        let edits = of_all(&self.document, points, edit).map(<[Edit; 1]>::try_from);
        match edits {
            Ok(Ok([edit])) => self.edit(edit),
            Ok(Err(edits)) => self.edit_together(edits),
            Err(error) => {
                self.complain_of(&error);
                false
            }
        }
    }

    /// Takes back what was done since a drag began; the drag goes on.
    pub(crate) fn restart_step(&mut self) {
        if self.document.in_step() {
            self.document.cancel_step();
            self.document.begin_step();
        }
    }
}

/// What an edit of one point means: it, and the same of the other points that are selected.
fn of_all(document: &Document, points: &[usize], edit: Edit) -> Result<Vec<Edit>> {
    let path = document.path();
    let of = |at: usize| path.points.get(at);
    // Those that the edit itself is not about.
    let others = |one: usize| points.iter().copied().filter(move |&at| at != one);
    let mut all = Vec::new();
    match &edit {
        Edit::Set {
            place: At::Point(at),
            value: Value::Place(position),
            ..
        } => {
            let by = of(*at).map(|point| position - point.position);
            let mut points: Vec<_> = others(*at).collect();
            if let Some(by) = by.filter(|_| !points.is_empty()) {
                // All at once, so that tangents which keep a motion stay; then the exact place.
                points.push(*at);
                all.push(Edit::TransformPoints {
                    points,
                    matrix: DMat4::from_translation(by),
                    with_targets: false,
                });
            }
            all.push(edit);
            return Ok(all);
        }
        Edit::Set {
            place: At::Point(at),
            property,
            value,
        } if find(SupportPoint::PROPERTIES, property).is_some_and(|row| row.copied[1]) => {
            for at in [*at].into_iter().chain(others(*at)) {
                let edit = Edit::set(At::Point(at), property, value.clone());
                match *property {
                    "own" | "preset" => all.extend(Edit::shaped(path, at, edit)),
                    _ => all.push(edit),
                }
            }
            return Ok(all);
        }
        &Edit::SetAbsolute {
            point,
            at,
            absolute,
        } => {
            let has_view = |point: &usize| of(*point).is_some_and(|p| p.orientations.len() > at);
            let others = others(point).filter(has_view);
            all.extend(others.map(|point| Edit::SetAbsolute {
                point,
                at,
                absolute,
            }));
        }
        Edit::SetOrientation {
            point: one,
            at,
            orientation: new,
        } => {
            let view = |point: usize| of(point).and_then(|point| point.orientations.get(*at));
            for point in others(*one) {
                let Some((old, there)) = view(*one).zip(view(point)) else {
                    continue;
                };
                let mut orientation = there.clone();
                take_over(&mut orientation, old, new)?;
                all.push(Edit::SetOrientation {
                    point,
                    at: *at,
                    orientation,
                });
            }
        }
        _ => {}
    }
    all.insert(0, edit);
    Ok(all)
}

/// Changes in an orientation what differs between two others.
fn take_over(into: &mut Orientation, old: &Orientation, new: &Orientation) -> Result<()> {
    for row in Orientation::PROPERTIES {
        // What it has of its own is decided field by field.
        if !row.keys.is_empty() && !(row.same)(old, new) {
            (row.take)(into, new);
        }
    }
    if old.own.same_bits(&new.own) && new.target == old.target {
        return Ok(());
    }
    // Aiming at something ends looking along the path.
    let aims = new.target != old.target && new.own.ahead.is_none();
    into.own = into.own.with(|own| {
        for row in OrientationOverrides::PROPERTIES {
            if row.copied[1] && !(row.same)(&old.own, &new.own) {
                (row.take)(own, &new.own);
            }
        }
        if aims {
            own.ahead = None;
        }
    })?;
    Ok(())
}
