//! The movement window: the path in space and what the user does with it (thesis chapter 6, A.3).
//!
//! Three pieces of arithmetic are tested without a window: [`projection`] (where a point appears),
//! [`picking`] (what lies under the pointer) and [`drag`] (the edit that a drag makes).
//! [`mod@pointer`] and [`keyboard`] turn events into actions, [`gesture`] applies those of a drag;
//! [`scene`], [`solid`], [`cameras`], [`ribbon`] and [`overlay`] draw.

mod arrows;
mod camera_caption;
mod camera_picture;
pub(crate) mod camera_view;
pub(crate) mod cameras;
mod drag;
mod drawing;
mod flying;
mod gesture;
mod gizmo;
mod held_nodes;
mod hold;
mod keyboard;
mod labels;
mod lamps;
mod menu;
mod nodes;
mod of_nodes;
mod overlay;
mod picking;
mod pointer;
pub(crate) mod projection;
pub(crate) mod ribbon;
pub(crate) mod scene;
pub(crate) mod seconds;
mod shown_camera;
mod sliders;
mod solid;
mod start;
mod strokes;
mod surface;
mod tangents;
mod trail;
mod transform;
mod turned;
pub(crate) mod typed;

use std::sync::Arc;

use egui::{Context, EventFilter, Painter, Pos2, Rect, Sense, Ui, Vec2};
use glam::DVec3;
use vides_document::Document;
use vides_document::error::Result;
use vides_raster::{Lines, Surfaces};

pub(super) use self::cameras::Camera;
use self::projection::Projection;
use self::scene::Look;
use self::strokes::Strokes;
pub(super) use self::turned::turned_node;
use crate::action::Action;
use crate::setup::{Element, View};
use crate::space::projection::cube;
use crate::space::surface::{PointerContext, projection_of};
use crate::state::Editor;
use crate::state::space::solid::Eye;
use crate::state::space::{Handle, MovementWindow};
use crate::state::windows::ToolWindow;
use crate::texts::Texts;
use crate::texts::refusals::reason_of;
use crate::{host, points_list, scene_view};

impl MovementWindow {
    /// Whether held keys or a transform keep a step of the document open.
    pub(super) fn keeps_step_open(&self) -> bool {
        self.pointer.nudging || self.pointer.transform.is_some()
    }

    #[cfg(test)]
    pub(super) fn lines_of_nodes(&self) -> *const Lines {
        self.nodes.lines()
    }

    /// The place of the object under the pointer.
    pub(super) fn pointed(&self) -> Option<DVec3> {
        self.pointed
    }

    /// Whether a handle or the view is being dragged.
    pub(super) fn moves(&self) -> bool {
        self.pointer.moves()
    }
}

/// What the space remembers of itself.
fn room(editor: &mut Editor) -> &mut MovementWindow {
    &mut editor.space
}

pub(super) fn show(editor: &mut Editor, ui: &mut Ui) {
    let context = ui.ctx().clone();
    if editor.is_first_screen() {
        let viewport = ui.available_rect_before_wrap();
        ui.advance_cursor_after_rect(viewport);
        editor.host_pane = None;
        return show_in(editor, ui, viewport, None);
    }
    editor.space.pointer.begun = None;
    points_list::show(editor, ui);
    let viewport = match editor.shows_sliders() {
        true => editor.part_of(&context, room, |editor, space, actions| {
            sliders::show(editor, &mut space.view_before, ui, actions)
        }),
        false => {
            let all = ui.available_rect_before_wrap();
            ui.advance_cursor_after_rect(all);
            all
        }
    };
    let whole = viewport;
    let (viewport, docked) = camera_view::divided(editor, whole);
    show_in(editor, ui, viewport, docked);
    editor.host_pane = editor.part_of(&context, room, |editor, space, actions| match docked {
        Some(rect) => {
            let solid = &mut space.seen_solid;
            let pane = camera_view::docked(editor, solid, ui, rect, actions);
            camera_view::dragged_border(editor, ui, (whole, rect), actions);
            pane
        }
        None => camera_view::show(editor, &mut space.seen_solid, &context, viewport, actions),
    });
    editor.part(&context, |editor, actions| {
        scene_view::show(editor, &context, viewport, actions)
    });
}

/// What mouse and keys do beside what the thesis names: input and meaning.
pub(super) fn shortcut_help(texts: &Texts) -> [(&'static str, &'static str); 41] {
    let timeline = &texts.timeline;
    let texts = &texts.space;
    [
        (texts.shift_mouse, texts.shift_meaning),
        (texts.click_mouse, texts.click_meaning),
        (texts.box_mouse, texts.box_meaning),
        (texts.one_keys, texts.one_meaning),
        (texts.tool_keys, texts.tool_meaning),
        (texts.axis_keys, texts.axis_meaning),
        (texts.handle_mouse, texts.handle_meaning),
        (texts.node_mouse, texts.node_meaning),
        (texts.pivot_keys_name, texts.pivot_meaning),
        (texts.way_mouse, texts.way_meaning),
        (texts.tangent_mouse, texts.tangent_meaning),
        (texts.list_keys, texts.list_meaning),
        (texts.corner_mouse, texts.corner_meaning),
        (texts.whole_mouse, texts.whole_meaning),
        (texts.facing_mouse, texts.facing_meaning),
        (texts.snap_mouse, texts.snap_meaning),
        (texts.fine_mouse, texts.fine_meaning),
        (texts.escape_keys, texts.escape_meaning),
        (texts.move_keys, texts.move_meaning),
        (texts.target_keys, texts.target_meaning),
        (texts.roll_keys, texts.roll_meaning),
        (texts.turn_keys, texts.turn_meaning),
        (texts.size_keys, texts.size_meaning),
        (texts.frame_keys, texts.frame_meaning),
        (texts.next_keys, texts.next_meaning),
        (texts.play_keys, texts.play_meaning),
        (texts.loop_keys, texts.loop_meaning),
        (texts.speed_graph_keys, texts.speed_graph_meaning),
        (timeline.drag_mouse, timeline.drag_meaning),
        (timeline.move_keys, timeline.move_meaning),
        (timeline.zoom_mouse, timeline.zoom_meaning),
        (timeline.track_mouse, timeline.track_meaning),
        (timeline.graph_mouse, timeline.graph_meaning),
        (timeline.home_keys, timeline.home_meaning),
        (timeline.keys_clipboard, timeline.clipboard_meaning),
        (timeline.beside_keys, timeline.beside_meaning),
        (timeline.marker_mouse, timeline.marker_meaning),
        (texts.camera_keys, texts.camera_meaning),
        (texts.camera_place_keys, texts.camera_place_meaning),
        (texts.fly_mouse, texts.fly_meaning),
        (texts.menu_keys, texts.menu_meaning),
    ]
}

/// Where the path leads, piece by piece.
fn along(document: &Document) -> Vec<DVec3> {
    let found = document.timeline(|timeline| {
        let segments = timeline.segment_count();
        let steps = (THUMBNAIL_PIECES / segments.max(1)).clamp(1, 24);
        let every = segments.div_ceil(THUMBNAIL_PIECES).max(1);
        let some = (0..segments).step_by(every);
        let along = some.flat_map(|segment| {
            let curve = timeline.curve(segment);
            (0..=steps).map(move |step| curve.point(step as f64 / steps as f64))
        });
        along.collect()
    });
    // Out of memory there is merely no curve.
    found.unwrap_or_default()
}

/// The view in which the flight is seen as large as it fits, or the object if there is one.
fn framing(editor: &Editor, viewport: Rect, object: bool) -> Option<View> {
    let document = &editor.document;
    let lines = || scene_view::outline(document).unwrap_or_default();
    let mut places: Vec<DVec3> = match object {
        true => document
            .info()
            .object
            .iter()
            .map(|point| point.position)
            .collect(),
        false if document.edits_path() => along(document),
        false => Vec::new(),
    };
    if places.is_empty() {
        places = lines().into_iter().flatten().collect();
    }
    let space = document.path().space;
    surface::framed(&editor.setup.view, viewport, space, places.into_iter())
}

/// A small picture of a path in the default view: its space's edges, and the curve as one line.
pub(super) fn thumbnail(document: &Document, size: Vec2) -> (Vec<[Pos2; 2]>, Vec<Pos2>) {
    let viewport = Rect::from_min_size(Pos2::ZERO, size);
    let edited = document.edited_scene().filter(|_| !document.edits_path());
    let space = edited.map_or(document.path().space, |edited| edited.scene().space());
    let projection = Projection::of(&View::default(), viewport, space);
    let edges = cube(space).map(|(from, to)| [from, to].map(|end| projection.pos(end)));
    let places = match document.edits_path() {
        true => along(document),
        false => Vec::new(),
    };
    let curve = places.into_iter().map(|point| projection.pos(point));
    (edges.collect(), curve.collect())
}

/// The same for a scene in which no path is edited: its lines.
pub(super) fn thumbnail_of_scene(document: &Document, size: Vec2) -> Option<Vec<[Pos2; 2]>> {
    let scene = document
        .edited_scene()
        .filter(|_| !document.edits_path())?
        .scene();
    let viewport = Rect::from_min_size(Pos2::ZERO, size);
    let projection = Projection::of(&View::default(), viewport, scene.space());
    let ends = scene_view::outline(document).unwrap_or_default();
    let every = ends.len().div_ceil(THUMBNAIL_LINES).max(1);
    let seen = ends.iter().step_by(every);
    Some(
        seen.map(|ends| ends.map(|end| projection.pos(end)))
            .collect(),
    )
}

/// The same for the object around a path.
pub(super) fn thumbnail_of_object(document: &Document, size: Vec2) -> Vec<[Pos2; 2]> {
    let viewport = Rect::from_min_size(Pos2::ZERO, size);
    let projection = Projection::of(&View::default(), viewport, document.path().space);
    let points = &document.info().object;
    let every = points.len().div_ceil(THUMBNAIL_LINES).max(1);
    let lines = points.windows(2).step_by(every);
    let drawn = lines.filter_map(|ends| match ends {
        [from, to] if to.draw => Some([from, to].map(|end| projection.pos(end.position))),
        _ => None,
    });
    drawn.collect()
}

/// An object of more points shows its corners at a click only: each motion of the pointer looks at all.
const MOST_LIT: usize = 100_000;

/// Most lines of a scene in a thumbnail.
const THUMBNAIL_LINES: usize = 2_000;

/// About how many pieces the curve of a thumbnail has.
const THUMBNAIL_PIECES: usize = 400;

/// Shows the space in `viewport`, except where it is `covered`.
fn show_in(editor: &mut Editor, ui: &mut Ui, viewport: Rect, covered: Option<Rect>) {
    let response = ui.interact(
        viewport,
        ui.scope_id().with("movement"),
        Sense::click_and_drag(),
    );
    let name = editor.texts().space.name;
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, name));
    let context = ui.ctx().clone();
    let opened = std::mem::take(&mut editor.space.opened);
    if opened && editor.document.edits_path() && !editor.begins() {
        let projection = projection_of(editor, viewport);
        let places = along(&editor.document).into_iter();
        if !surface::fills(&projection, viewport, places)
            && let Some(view) = framing(editor, viewport, false)
        {
            editor.setup.view = view;
        }
    }
    let layer = ui.layer_id();
    let mut above = gizmo::rooms(editor, viewport);
    above.extend(start::rooms(editor, viewport));
    let mine = |at| {
        viewport.contains(at)
            && !above.iter().any(|room| room.contains(at))
            && covered.is_none_or(|covered| !covered.contains(at))
            && context.layer_id_at(at).is_none_or(|found| found == layer)
            && context.memory(|memory| memory.top_modal_layer().is_none())
    };
    if response.is_pointer_button_down_on()
        || context.memory(|memory| memory.focused().is_none() && memory.top_modal_layer().is_none())
        || is_meant_by_letters(&context, &mine)
    {
        response.request_focus();
    }
    // The arrow keys move points here; Escape takes a drag back.
    let filter = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        escape: editor.space.moves() || editor.several().is_some(),
        ..EventFilter::default()
    };
    context.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let surface = PointerContext {
        context: &context,
        viewport,
        mine: &mine,
        keyboard: response.has_focus() && !egui::Popup::is_any_open(&context),
    };
    // Each sees what the one before has changed.
    for event in editor.space.pointer.events(&context) {
        editor.part_of(&context, room, |editor, space, actions| {
            space.pointer.take(editor, &surface, event, actions)
        });
    }
    editor.part_of(&context, room, |editor, space, actions| {
        space.pointer.settle(editor, &surface, actions)
    });
    editor.part_of(&context, room, |editor, space, actions| {
        space.pointer.point(editor, &surface);
        if response.hovered() || response.dragged() {
            context.set_cursor_icon(space.pointer.cursor());
        }
        if response.double_clicked()
            && space.pointer.hover.is_none()
            && space.pointer.arrow.is_none()
            && !editor.is_first_screen()
            && !space.pointer.clicked_node()
        {
            actions.push(Action::View(View::default()));
        }
    });
    editor.part_of(&context, room, |editor, space, actions| {
        let asked = space.pointer.menu.take();
        let sight = space.solid.sight.as_ref();
        menu::show(&mut space.menu, asked, sight, editor, ui, viewport, actions);
        if let Some(ghost) = editor.ghost.map(Camera::from) {
            let place = projection_of(editor, viewport).pos(ghost.position);
            actions.extend(host::button(editor, &context, viewport, place));
        }
    });
    editor.part_of(&context, room, |editor, space, actions| {
        let at = space.pointing(editor, &surface);
        let projection = projection_of(editor, viewport);
        let few = editor.document.info().object.len() <= MOST_LIT;
        let corner = at.filter(|_| few);
        let corner = corner.and_then(|at| menu::corner_at(editor, &projection, at));
        let drawn = space.draw(editor, &ui.painter_at(viewport), viewport, corner);
        let sight = space.solid.sight.as_ref();
        let face = || sight?.place(at?);
        space.pointed = corner.or_else(face);
        if let Err(error) = drawn {
            actions.push(Action::Complain(reason_of(editor.language(), &error)));
        }
    });
    editor.part_of(&context, room, |editor, space, actions| {
        gizmo::show(editor, &mut space.view_before, ui, viewport, actions);
        start::show(editor, ui, viewport, actions);
    });
}

impl MovementWindow {
    /// Where the pointer may show a place of the object.
    fn pointing(&self, editor: &Editor, surface: &PointerContext<'_>) -> Option<Pos2> {
        let context = surface.context;
        let busy = self.pointer.hover.is_some()
            || editor.windows.tool.is_some()
            || egui::Popup::is_any_open(context)
            || context.input(|input| input.pointer.any_down());
        let at = context.input(|input| input.pointer.latest_pos());
        at.filter(|&at| !busy && (surface.mine)(at))
    }

    fn draw(
        &mut self,
        editor: &Editor,
        painter: &Painter,
        viewport: Rect,
        corner: Option<DVec3>,
    ) -> Result<()> {
        let projection = projection_of(editor, viewport);
        let pixels_per_point = f64::from(painter.pixels_per_point());
        let eye = Eye {
            matrix: projection.matrix(pixels_per_point),
            front: 0.0,
            slack: [1.5, 0.0],
            lights: projection.lights(),
            rect: viewport,
            pixels_per_point,
            of_path: true,
        };
        let sight = self.solid.update(editor, painter.ctx(), eye).cloned();
        let sight = sight.as_ref();
        let look = Look {
            projection: &projection,
            viewport,
            pixels_per_point,
            colours: editor.setup.colours(),
            shown: &editor.setup.shown,
            pane: camera_view::floating(editor, painter.ctx()),
            sight,
        };
        painter.rect_filled(viewport, 0.0, look.colours.of(Element::Background));
        let add_shared = |lines: &Arc<Lines>| add_lines(painter, &look, lines);
        let add = |lines: Lines| add_shared(&Arc::new(lines));
        let document = &editor.document;
        let pointer = &self.pointer;
        let dragged = pointer.dragged();
        let through = dragged.and_then(|(what, freedom)| {
            let place = hold::place_held(editor, what)?;
            Some((place, freedom))
        });
        let transform = pointer.transform.as_ref();
        let through = through.or_else(|| transform?.guides(editor, &projection));
        if let Some((through, freedom)) = through {
            overlay::plane(painter, &look, through, freedom);
        }
        let trouble = self.lines.update(document, &look);
        let [behind, still] = self.lines.still();
        add_shared(behind);
        if let Some(sight) = sight {
            painter.add(Surfaces::shape(&sight.surfaces, viewport));
        }
        add_shared(still);
        if document.edited_scene().is_some() {
            add_shared(self.nodes.update(editor, &look)?);
            nodes::names(editor, painter, &look);
        }
        if editor.is_first_screen() {
            let at = painter.ctx().input(|input| input.pointer.latest_pos());
            if let Some(begun) = pointer.begun {
                let to = at.map_or(begun, |at| drawing::place_in(editor, viewport, at));
                let palette = editor.setup.theme().palette();
                add(overlay::stroke(&look, &[begun, to], palette));
                add(overlay::ring(&look, begun, palette.accent, false));
            }
            self.draw_hint(editor, painter, &look);
            return trouble;
        }
        if !document.edits_path() {
            trail::paint(&self.pointer, editor, painter, &look);
            self.draw_hint(editor, painter, &look);
            return trouble;
        }
        // Below the curve, which matters more, and below what a drag changes: not repainted then.
        add_shared(self.key_cameras.update(document, &look));
        if editor.setup.shown.has(Element::Ribbon) && self.ribbon.update(document).is_ok() {
            self.ribbon.paint(painter, &look);
        }
        self.lines.paint(painter, viewport);
        add_shared(self.seconds.update(document, &look));
        add(cameras::current_key(document, &look));
        if let Some((through, freedom)) = through {
            add(overlay::guides(&look, through, freedom));
        }
        let current = scene::current(document, &look).map(add);
        add(tangents::show(document, &look));
        if let Some(points) = editor.several() {
            add(overlay::selected(document, &look, points));
            let own = !editor.means_nodes();
            if let Some(middle) = transform::handles(editor, &projection).filter(|_| own) {
                add(transform::show_handles(&look, middle, pointer.meant));
            }
        }
        self.draw_handles(editor, painter, &look, corner);
        draw_cameras(editor, painter, &look);
        let pointed = match pointer.hover {
            Some(Handle::Point(at)) => Some(at),
            _ => None,
        };
        let several = editor.several().unwrap_or_default();
        labels::numbers(painter, document, &look, pointed, several);
        if editor.means_nodes() {
            trail::paint(&self.pointer, editor, painter, &look);
        }
        self.draw_hint(editor, painter, &look);
        current.and(trouble)
    }

    /// What is lit, drawn or previewed, and the handles of the current view.
    fn draw_handles(
        &self,
        editor: &Editor,
        painter: &Painter,
        look: &Look<'_>,
        corner: Option<DVec3>,
    ) {
        let (document, pointer) = (&editor.document, &self.pointer);
        let dragged = pointer.dragged();
        let add = |lines: Lines| add_lines(painter, look, &Arc::new(lines));
        let palette = editor.setup.theme().palette();
        if let Some(corner) = corner {
            add(overlay::ring(look, corner, palette.accent, false));
        }
        if let Some(window) = &editor.windows.tool
            && let Some(cage) = window.cage()
        {
            add(overlay::cage(look, cage, window.control(), palette));
        }
        if let Some((poses, left_out)) =
            (editor.windows.tool.as_ref()).and_then(ToolWindow::recorded)
        {
            add(overlay::recorded(look, poses, left_out, palette));
        }
        if let Some(places) = pointer.stroke() {
            add(overlay::stroke(look, places, palette));
        }
        if let Some(window) = &editor.windows.tool
            && !window.drawn().is_empty()
        {
            let places: Vec<_> = window.drawn().iter().map(|(_, place)| *place).collect();
            add(overlay::stroke(look, &places, palette));
        }
        let preview = editor.windows.curve.as_ref();
        if let Some(segments) = preview.and_then(|window| window.preview(editor)) {
            let mut strokes = Strokes::new(look.projection, look.viewport);
            let color = editor.setup.theme().palette().accent;
            for pair in segments.iter().flat_map(|segment| segment.windows(2)) {
                strokes.line(pair[0], pair[1], 1.5, color);
            }
            add(strokes.finish());
        }
        let at = painter.ctx().input(|input| input.pointer.latest_pos());
        let at = at
            .filter(|_| pointer.arrow.is_some())
            .map(projection::from_pos);
        arrows::show(editor, painter, look, at);
        if let Some(tips) = picking::tips(document) {
            add(overlay::circle(look, &tips));
            overlay::arrows(painter, look, &tips);
            let held = dragged.map(|(what, _)| what);
            let place = |handle| match handle {
                Handle::Control(_) => {
                    let place = hold::place_held(editor, handle)?;
                    Some((place, palette.accent))
                }
                handle => overlay::place_of(document, look, &tips, handle),
            };
            if let Some(handle) = held.or(pointer.hover)
                && let Some((at, color)) = place(handle)
            {
                add(overlay::ring(look, at, color, held.is_some()));
            }
        }
    }

    /// The box that selects, and what the pointer would do.
    fn draw_hint(&self, editor: &Editor, painter: &Painter, look: &Look<'_>) {
        let pointer = &self.pointer;
        if let Some(drawn) = pointer.drawn_box() {
            overlay::drawn_box(painter, look, drawn);
        }
        let hint = match &pointer.transform {
            Some(transform) => Some(transform.hint(editor, look.projection)),
            None => {
                let draws = drawing::is_wanted(editor);
                let several = editor.several().map_or(0, <[usize]>::len);
                let meant = [draws, editor.means_nodes()];
                pointer.hint(editor.texts(), look.projection, several, meant)
            }
        };
        if let Some(hint) = hint {
            let color = editor.setup.theme().palette().weak;
            labels::hint(painter, look, &hint, color);
        }
    }
}

fn add_lines(painter: &Painter, look: &Look<'_>, lines: &Arc<Lines>) {
    if !lines.lines.is_empty() {
        painter.add(Lines::shape(lines, look.viewport));
    }
}

/// The camera at the playhead, the one that is flown, and the host's.
fn draw_cameras(editor: &Editor, painter: &Painter, look: &Look<'_>) {
    let add_camera = |camera: &Camera, points, width, color| {
        let mut strokes = Strokes::new(look.projection, look.viewport);
        cameras::camera(&mut strokes, look, camera, points, width, color);
        add_lines(painter, look, &Arc::new(strokes.finish()));
    };
    if let Some(color) = look.of(Element::Player)
        && let Some((camera, true)) = editor.camera()
    {
        add_camera(&camera, 44.0, 1.8, color);
    }
    if let Some(color) = look.of(Element::Player)
        && let Some(flown) = editor.flown()
    {
        add_camera(&flown, 44.0, 1.8, color);
    }
    if let Some(ghost) = editor.ghost.map(Camera::from) {
        let color = editor.setup.theme().palette().text.gamma_multiply(0.65);
        add_camera(&ghost, 40.0, 1.4, color);
        labels::name(painter, look, &ghost, editor.host_name(), color);
    }
}

/// Whether a letter was pressed that is meant here although another control has the focus: the
/// pointer is over the movement window and no text field has the focus.
fn is_meant_by_letters(context: &Context, mine: &dyn Fn(Pos2) -> bool) -> bool {
    let (pointer, pressed) = context.input(|input| {
        let plain = !(input.modifiers.command || input.modifiers.ctrl || input.modifiers.alt);
        let pressed = || keyboard::LETTERS.iter().any(|&key| input.key_pressed(key));
        (input.pointer.latest_pos(), plain && pressed())
    });
    pressed
        && pointer.is_some_and(mine)
        && !context.text_edit_focused()
        && !egui::Popup::is_any_open(context)
}

#[cfg(test)]
mod cameras_tests;
#[cfg(test)]
mod manual_tests;
#[cfg(test)]
mod memory_tests;
#[cfg(test)]
mod menu_tests;
#[cfg(test)]
mod node_clicks_tests;
#[cfg(test)]
mod nodes_tests;
#[cfg(test)]
mod planes_tests;
#[cfg(test)]
mod several_tests;
#[cfg(test)]
mod shaping_tests;
#[cfg(test)]
mod tangents_tests;
#[cfg(test)]
pub(super) mod tests;
#[cfg(test)]
mod world_tests;
