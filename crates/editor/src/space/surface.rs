//! The space as it is seen in this pass: its projection, and what pointer and keys are meant for.

use egui::{Context, Key, Pos2, Rect};
use glam::{DVec2, DVec3};
use vides_engine::path::Space;

use crate::setup::View;
use crate::space::projection::{Axis, Projection, from_pos, scale, to_pos};
use crate::state::Editor;

/// A press that moves no farther than this, in points, is no drag: hands tremble.
pub(crate) const STILL: f32 = 2.0;

/// A drag with Shift is this many times finer.
pub(crate) const FINE: f64 = 10.0;

/// Factor of the size for a step of the wheel.
pub(crate) const WHEEL: f64 = 1.1;

pub(crate) struct PointerContext<'a> {
    pub(crate) context: &'a Context,
    pub(crate) viewport: Rect,
    /// Whether a place belongs to the movement window and not to what covers it.
    pub(crate) mine: &'a dyn Fn(Pos2) -> bool,
    pub(crate) keyboard: bool,
}

pub(crate) fn axis_of(key: Key) -> Option<Axis> {
    match key {
        Key::X => Some(Axis::X),
        Key::Y => Some(Axis::Y),
        Key::Z => Some(Axis::Z),
        _ => None,
    }
}

/// The view with another size: larger about the pointer, smaller back towards the middle.
pub(crate) fn resized(view: &View, viewport: Rect, pointer: Option<Pos2>, factor: f64) -> View {
    let mut view = *view;
    let size = (view.size * factor).clamp(View::MIN_SIZE, View::MAX_SIZE);
    if let Some(pointer) = pointer.filter(|_| size > view.size) {
        let away = from_pos(pointer) - from_pos(viewport.center());
        let unit = scale(&view, viewport);
        let grown = unit * size / view.size;
        view.shift[0] += away.x / grown - away.x / unit;
        view.shift[1] -= away.y / grown - away.y / unit;
    } else if size < view.size {
        let share = ((size - 1.0) / (view.size - 1.0)).clamp(0.0, 1.0);
        let share = if view.size > 1.0 { share } else { 0.0 };
        view.shift = view.shift.map(|shift| shift * share);
    }
    view.size = size;
    view.in_range()
}

/// The share of the viewport that what is framed fills.
const FRAMED: f64 = 0.8;

/// The view from the same side in which all these places are seen, as large as they fit; none
/// without two places apart.
pub(crate) fn framed(
    view: &View,
    viewport: Rect,
    space: Space,
    places: impl Iterator<Item = DVec3>,
) -> Option<View> {
    let plain = View {
        size: 1.0,
        shift: [0.0; 2],
        ..*view
    };
    let projection = Projection::of(&plain, viewport, space);
    let middle = from_pos(viewport.center());
    let [low, high] = bounds(places.map(|place| projection.image(place) - middle))?;
    let room = from_pos(viewport.size().to_pos2()) * FRAMED;
    let size = (room / (high - low)).min_element();
    let shift = 0.5 * (low + high) / scale(&plain, viewport);
    let found = View {
        size,
        shift: [-shift.x, shift.y],
        ..plain
    };
    size.is_finite().then(|| found.in_range())
}

/// Whether places are seen well: all of them, and not in a small part of the viewport.
pub(crate) fn fills(
    projection: &Projection,
    viewport: Rect,
    places: impl Iterator<Item = DVec3>,
) -> bool {
    let Some([low, high]) = bounds(places.map(|place| projection.image(place))) else {
        return true;
    };
    let share = (high - low) / from_pos(viewport.size().to_pos2());
    let within = [low, high].iter().all(|&at| viewport.contains(to_pos(at)));
    within && share.max_element() > 0.3
}

fn bounds(images: impl Iterator<Item = DVec2>) -> Option<[DVec2; 2]> {
    images
        .map(|image| [image; 2])
        .reduce(|[low, high], [image, _]| [low.min(image), high.max(image)])
}

pub(crate) fn projection_of(editor: &Editor, viewport: Rect) -> Projection {
    let space = editor.document.path().space;
    Projection::of(&editor.setup.view, viewport, space)
}
