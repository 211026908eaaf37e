//! What the space itself offers: how to begin with an empty document, and a space for points that
//! lie outside. A window that belongs to no program begins with nothing else.

mod sign;

use std::path::Path;
use std::time::Duration;

use egui::{Align2, Button, FontId, Rect, Role, Ui, Vec2, WidgetInfo, vec2};
use vides_document::Edit;
use vides_document::tool;
use vides_document::tool::Tool;
use vides_engine::path::Space;

use crate::action::{Action, FileAction, PathAction, ToolAction};
use crate::files::recent::PICTURE;
use crate::setup::Element;
use crate::state::Editor;
use crate::state::files::Picture;
use crate::state::scene_view::NodeAction;
use crate::state::space::Around;
use crate::texts::fill;
use crate::texts::refusals::reason_of;
use crate::theme;

/// Size of a beginning's button, and between two of them.
const BUTTON: Vec2 = vec2(84.0, 54.0);
const GAP: f32 = 4.0;

/// Height of a beginning's name below its sign.
const NAME: f32 = 16.0;

/// Seconds in which a camera flies through a beginning's sign.
const ROUND: f64 = 2.0;
const FRAME: Duration = Duration::from_millis(33);

/// A button with a picture above its name; and how many recent files there are at most.
const PICTURED: Vec2 = vec2(132.0, PICTURE.y + theme::ROW);
const MOST: usize = 4;

/// Above the lower border; what the axes in the corner take, at the left and in height.
const ABOVE: f32 = 10.0;
const AXES: Vec2 = vec2(220.0, 88.0);

/// The moves and tools that are offered.
const TOOLS: [&str; 4] = ["orbit", "flyby", "draw", "tour"];

/// A way to begin.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Begin {
    Tool(Tool),
    /// With the program's camera as the first point.
    View,
    Open,
    /// With a path that is there to be tried.
    Example,
    /// With poses that something has recorded.
    Recording,
}

/// What the first screen offers where files are dropped.
const FILES: [Begin; 3] = [Begin::Open, Begin::Example, Begin::Recording];

/// The room for the words above these, and around them.
const WORDS: f32 = 56.0;
const MARGIN: f32 = 16.0;

impl Begin {
    /// Its place among [`TOOLS`].
    fn index(self) -> Option<usize> {
        let Self::Tool(tool) = self else { return None };
        TOOLS.iter().position(|name| *name == tool.name)
    }
}

/// What is offered now, with its place: ways to begin, and files that were open last, the newest
/// first.
#[derive(Debug, Default)]
struct Offered {
    /// Where the first screen says that files can be dropped.
    drop: Option<Rect>,
    begins: Vec<(Begin, Rect)>,
    /// With their places in the list.
    recent: Vec<(usize, Rect)>,
}

impl Offered {
    fn places(&self) -> impl Iterator<Item = Rect> + '_ {
        let begins = self.begins.iter().map(|(_, place)| *place);
        begins.chain(self.recent.iter().map(|(_, place)| *place))
    }
}

/// What the first screen offers, in the middle: files above, moves below, then files that were open.
fn first_screen(editor: &Editor, viewport: Rect) -> Offered {
    let row = |names: Vec<Begin>, top: f32| {
        let width = names.len() as f32 * (BUTTON.x + GAP) - GAP;
        let left = viewport.center().x - width / 2.0;
        let place = move |at: usize| {
            let left = left + at as f32 * (BUTTON.x + GAP);
            Rect::from_min_size(egui::pos2(left, top), BUTTON)
        };
        let places = (0..names.len()).map(place);
        names.into_iter().zip(places).collect::<Vec<_>>()
    };
    let size = vec2(380.0, WORDS + BUTTON.y + MARGIN);
    let whole = size.y + 2.0 * MARGIN + BUTTON.y + theme::ROW;
    let below = MARGIN + PICTURED.y;
    let has_room = viewport.height() > whole + below + AXES.y;
    let high = whole + below * f32::from(u8::from(has_room && !editor.recent.is_empty()));
    let top = viewport.center().y - high / 2.0;
    let left = viewport.center().x - size.x / 2.0;
    let drop = Rect::from_min_size(egui::pos2(left, top), size);
    let mut begins = row(FILES.to_vec(), top + WORDS);
    let under = drop.bottom() + MARGIN;
    begins.extend(row(moves().collect(), under));
    let room = viewport.shrink(ABOVE).with_max_y(top + high);
    Offered {
        drop: Some(drop),
        begins,
        recent: match has_room {
            true => recent(editor, room),
            false => Vec::new(),
        },
    }
}

/// The moves and tools that are offered.
fn moves() -> impl Iterator<Item = Begin> {
    TOOLS.iter().filter_map(|name| {
        let mut all = tool::tools();
        all.find(|tool| tool.name == *name).map(Begin::Tool)
    })
}

fn offered(editor: &Editor, viewport: Rect) -> Offered {
    let is_open = editor.windows.tool.is_some() || editor.windows.has_modal();
    if is_open || !editor.begins() {
        return Offered::default();
    }
    if editor.is_first_screen() {
        return first_screen(editor, viewport);
    }
    let views = editor.host_view.captures || editor.ghost.is_some();
    let view = views.then_some(Begin::View);
    let mut all: Vec<Begin> = moves().chain(view).chain([Begin::Open]).collect();
    let width = |count: usize, each: f32| count as f32 * (each + GAP) - GAP;
    // Beside the axes, or else above them; what has no room is in the menus.
    let beside = viewport.shrink(ABOVE).with_min_x(viewport.left() + AXES.x);
    let above = viewport.shrink(ABOVE);
    let above = above.with_max_y(above.bottom() - AXES.y);
    let room = match beside.width() >= width(all.len(), BUTTON.x) {
        true => beside,
        false => above,
    };
    // As large as there is room for pictures of an object.
    let each = (room.width() + GAP) / all.len() as f32 - GAP;
    let size = match each.clamp(BUTTON.x, PICTURED.x) {
        wide if editor.has_object() && room.height() >= 4.0 * PICTURED.y => {
            vec2(wide, wide * PICTURE.y / PICTURED.x + NAME + 4.0)
        }
        _ => BUTTON,
    };
    while all.len() > 1 && width(all.len(), size.x) > room.width() {
        all.remove(all.len() - 2);
    }
    if room.height() < 2.0 * size.y {
        return Offered::default();
    }
    let left = room.center().x - width(all.len(), size.x) / 2.0;
    let places = (0..all.len()).map(|at| {
        let left = left + at as f32 * (size.x + GAP);
        Rect::from_min_size(egui::pos2(left, room.bottom() - size.y), size)
    });
    let begins: Vec<(Begin, Rect)> = all.clone().into_iter().zip(places).collect();
    Offered {
        drop: None,
        begins,
        recent: recent(editor, room.with_max_y(room.bottom() - size.y - GAP)),
    }
}

/// The files that were open last, above what else is offered.
fn recent(editor: &Editor, room: Rect) -> Vec<(usize, Rect)> {
    // The object that is loaded is no other.
    let source = editor.document.info().object.source();
    let own = source.map(|source| Path::new(&source.file));
    let others = (0..editor.recent.len()).filter(|&at| own != Some(&*editor.recent[at]));
    let others: Vec<usize> = others.collect();
    let fit = ((room.width() + GAP) / (PICTURED.x + GAP)).max(0.0) as usize;
    let high = room.height() >= 2.0 * BUTTON.y;
    let count = fit.min(MOST).min(others.len() * usize::from(high));
    let step = PICTURED.x + GAP;
    let left = room.center().x - (count as f32 * step - GAP) / 2.0;
    // Where pictures would cover the path there are the names alone.
    let height = match room.height() + BUTTON.y < 5.0 * PICTURED.y {
        true => theme::ROW,
        false => PICTURED.y,
    };
    let places = (0..count).map(|at| {
        let corner = egui::pos2(left + at as f32 * step, room.bottom() - height);
        Rect::from_min_size(corner, vec2(PICTURED.x, height))
    });
    others.into_iter().zip(places).collect()
}

impl Editor {
    /// Whether nothing has been done to the path yet: it can be begun with a tool, or around an
    /// object.
    pub(crate) fn begins(&self) -> bool {
        let document = &self.document;
        let of_none = self.file.is_none() && document.edited_scene().is_none();
        of_none && document.is_new()
    }

    /// Whether there is nothing but ways to begin: a window of our own, and no path or object in it
    /// that the user or a host has made.
    pub(crate) fn is_first_screen(&self) -> bool {
        let busy = self.windows.tool.is_some() || self.windows.front().is_some();
        self.program.offers_all && !busy && self.begins() && !self.has_object()
    }
}

/// How many points lie outside the space, where nothing is dragged.
fn outside(editor: &Editor) -> usize {
    if editor.document.in_step() || !editor.document.edits_path() {
        return 0;
    }
    editor.document.points_outside()
}

/// The words on the button for them, and its place.
fn notice(editor: &Editor, viewport: Rect) -> Option<(String, Rect)> {
    let texts = &editor.texts().space;
    let missing = editor.first_missing_mesh();
    let text = match (missing, outside(editor)) {
        (Some((_, file)), _) => {
            let name = crate::files::short(Path::new(file));
            fill(editor.texts().node.find_mesh, &[&name])
        }
        (None, 0) => return None,
        (None, 1) => texts.one_outside.to_owned(),
        (None, many) => fill(texts.some_outside, &[&many]),
    };
    let size = vec2(
        (viewport.width() - 2.0 * ABOVE).clamp(120.0, 290.0),
        theme::ROW,
    );
    let wide = viewport.width() > AXES.x + size.x + 2.0 * ABOVE;
    let middle = match wide {
        true => (viewport.left() + AXES.x + viewport.right()) / 2.0,
        false => viewport.center().x,
    };
    let above = if wide { ABOVE } else { AXES.y + ABOVE };
    let bottom = viewport.bottom() - above;
    let place = egui::pos2(middle, bottom - size.y / 2.0);
    Some((text, Rect::from_center_size(place, size)))
}

/// What lies above the space: not to be dragged there.
pub(super) fn rooms(editor: &Editor, viewport: Rect) -> impl Iterator<Item = Rect> + use<> {
    let offered = offered(editor, viewport);
    let notice = notice(editor, viewport).map(|(_, place)| place);
    offered
        .places()
        .chain(offered.drop)
        .chain(notice)
        .collect::<Vec<_>>()
        .into_iter()
}

/// Shows both.
pub(super) fn show(editor: &Editor, ui: &mut Ui, viewport: Rect, actions: &mut Vec<Action>) {
    let offered = offered(editor, viewport);
    if let Some(drop) = offered.drop {
        show_drop(editor, ui, drop);
    }
    let around = (!offered.begins.is_empty()).then(|| Around::of(editor));
    for (begin, place) in &offered.begins {
        let around = around.as_ref().and_then(Option::as_ref);
        show_beginning(editor, ui, (*begin, *place, around), actions);
    }
    let names = editor.recent_names();
    for &(at, place) in &offered.recent {
        show_recent(editor, ui, (at, place, &names[at]), actions);
    }
    show_notice(editor, ui, viewport, actions);
}

/// The frame in which an object is dropped; and that a click into the space begins a path there.
fn show_drop(editor: &Editor, ui: &Ui, drop: Rect) {
    let (texts, palette) = (&editor.texts().space, theme::palette(ui));
    let painter = ui.painter();
    painter.rect_filled(drop, 8.0, palette.panel);
    let corners = [
        drop.left_top(),
        drop.right_top(),
        drop.right_bottom(),
        drop.left_bottom(),
        drop.left_top(),
    ];
    let stroke = egui::Stroke::new(1.5, palette.edge);
    painter.extend(egui::Shape::dashed_line(&corners, stroke, 6.0, 5.0));
    let words = |y: f32, text: &str, size: f32, color| {
        let at = egui::pos2(drop.center().x, y);
        let font = FontId::proportional(size);
        let place = painter.text(at, Align2::CENTER_CENTER, text, font, color);
        let response = ui.interact(place, ui.scope_id().with(text), egui::Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    };
    words(drop.top() + 21.0, texts.drop_here, 18.0, palette.text);
    words(drop.top() + 43.0, texts.drop_kinds, 12.0, palette.weak);
    let below = drop.bottom() + 2.0 * MARGIN + BUTTON.y;
    words(below, texts.begin_by_click, theme::TEXT, palette.text);
}

fn show_beginning(
    editor: &Editor,
    ui: &mut Ui,
    (begin, place, around): (Begin, Rect, Option<&Around>),
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().space;
    let (name, hint, action) = match begin {
        Begin::Tool(tool) => (
            editor.language().tool(tool.name),
            editor.language().tool_hint(&tool),
            Action::Tool(ToolAction::Open(tool)),
        ),
        Begin::View => (
            texts.begin_view,
            texts.take_over_here_tip,
            Action::Path(PathAction::TakeOver { replace: true }),
        ),
        Begin::Open => (
            texts.begin_open,
            texts.begin_open_tip,
            Action::File(FileAction::Load),
        ),
        Begin::Example => (
            texts.begin_example,
            texts.begin_example_tip,
            Action::File(FileAction::Example),
        ),
        Begin::Recording => (
            texts.begin_recording,
            texts.begin_recording_tip,
            Action::File(FileAction::Import),
        ),
    };
    let response = ui.put(place, Button::new("").frame_when_inactive(true));
    let moves = response.hovered() && !editor.still;
    let way = moves.then(|| {
        ui.ctx().request_repaint_after(FRAME);
        (ui.input(|input| input.time) / ROUND).fract() as f32
    });
    let told = fill(texts.begin_with, &[&name]);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, told.as_str()));
    let (above, foot) = place.split_top_bottom_at_y(place.bottom() - NAME - 2.0);
    let mut color = ui.style().interact(&response).fg_stroke.color;
    let text_color = color;
    let mut is_drawn = false;
    if let Some((around, at)) = around.zip(begin.index()) {
        let paint = |picture: &Picture| {
            picture.paint(editor, ui, above.shrink(2.0), way);
            is_drawn = picture.has_path();
            // A sign on the object stands out from it as a path does.
            color = editor.setup.colours().of(Element::Curve);
        };
        let known = &editor.begin_pictures;
        known.show((editor, ui.ctx()), around, sign::pictures, (at, paint));
    }
    if !is_drawn {
        sign::paint(&ui.painter_at(place), begin, above.center(), color, way);
    }
    let foot = foot.center_bottom() - vec2(0.0, 4.0);
    let font = FontId::proportional(11.5);
    ui.painter()
        .text(foot, Align2::CENTER_BOTTOM, name, font, text_color);
    if response.on_hover_text(hint).clicked() {
        actions.push(action);
    }
}

fn show_recent(
    editor: &Editor,
    ui: &mut Ui,
    (at, place, name): (usize, Rect, &str),
    actions: &mut Vec<Action>,
) {
    let response = ui.put(place, Button::new("").frame_when_inactive(true));
    let (above, foot) = place.split_top_bottom_at_y(place.bottom() - theme::ROW);
    if above.height() > 0.0 {
        editor.paint_recent(ui, at, Rect::from_center_size(above.center(), PICTURE));
    }
    let text = egui::WidgetText::from(egui::RichText::new(name).font(theme::small()));
    let room = foot.width() - 12.0;
    let wrap = Some(egui::TextWrapMode::Truncate);
    let galley = text.into_galley(ui, wrap, room, egui::TextStyle::Small);
    let color = ui.style().interact(&response).fg_stroke.color;
    let corner = foot.center() - galley.size() / 2.0;
    ui.painter().galley(corner, galley, color);
    let told = fill(editor.texts().space.begin_with, &[&name]);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, told.as_str()));
    let file = editor.recent.get(at).map(|file| file.display().to_string());
    let hint = fill(
        editor.texts().menu_hints.recent,
        &[&file.unwrap_or_default()],
    );
    if response.on_hover_text(hint).clicked() {
        actions.push(Action::File(FileAction::Recent(at)));
    }
}

fn show_notice(editor: &Editor, ui: &mut Ui, viewport: Rect, actions: &mut Vec<Action>) {
    let Some((text, place)) = notice(editor, viewport) else {
        return;
    };
    let button = Button::new(egui::RichText::new(text).font(theme::small()));
    let response = ui.put(place, button.truncate());
    if let Some((purpose, file)) = editor.first_missing_mesh() {
        let hint = format!("{file}\n{}", editor.texts().node.find_hint);
        if response.on_hover_text(hint).clicked() {
            actions.push(Action::Node(NodeAction::AskFile(purpose)));
        }
        return;
    }
    if response
        .on_hover_text(editor.texts().space.outside_tip)
        .clicked()
    {
        let space = editor.document.path().space;
        actions.push(match editor.document.space_around_path() {
            Ok(around) => Action::Edit(Edit::SetSpace {
                space: Space {
                    up: space.up,
                    ..around
                },
                fit: false,
            }),
            Err(error) => Action::Complain(reason_of(editor.language(), &error)),
        });
    }
}

#[cfg(test)]
mod tests;
