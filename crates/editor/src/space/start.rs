//! What the space itself offers: how to begin with an empty document, and a space for points that
//! lie outside.

use std::time::Duration;

use egui::{
    Align2, Button, Color32, FontId, Painter, Pos2, Rect, Role, Shape, Stroke, Ui, Vec2,
    WidgetInfo, vec2,
};

use crate::action::Action;
use crate::document::Edit;
use crate::document::tool::{self, Tool};
use crate::files::PICTURE;
use crate::path::Space;
use crate::state::Editor;
use crate::texts::fill;
use crate::texts::refusals::reason_of;
use crate::theme;

/// Size of a beginning's button, and between two of them.
const BUTTON: Vec2 = vec2(84.0, 54.0);
const GAP: f32 = 4.0;

/// Seconds in which a camera flies through a beginning's sign.
const ROUND: f64 = 2.0;
const FRAME: Duration = Duration::from_millis(33);

/// A recent file's button: its picture above its name; and how many there are at most.
const RECENT: f32 = 132.0;
const PICTURED: f32 = PICTURE.y + theme::ROW;
const MOST: usize = 4;

/// Above the lower border; what the axes in the corner take, at the left and in height.
const ABOVE: f32 = 10.0;
const AXES: Vec2 = vec2(220.0, 88.0);

/// Moves and tools that are offered, those that there are.
const TOOLS: [&str; 4] = ["orbit", "flyby", "draw", "tour"];

/// A way to begin.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Begin {
    Tool(Tool),
    /// With the program's camera as the first point.
    View,
    Open,
    /// A file that was open last, the newest first.
    Recent(usize),
}

/// What is offered now, with its place.
fn offered(editor: &Editor, viewport: Rect) -> Vec<(Begin, Rect)> {
    let is_open = editor.windows.tool.is_some() || editor.windows.has_modal();
    if is_open || !editor.begins() {
        return Vec::new();
    }
    let tools = TOOLS.iter().filter_map(|name| {
        let mut all = tool::tools();
        all.find(|tool| tool.name == *name).map(Begin::Tool)
    });
    let views = editor.host_view.captures || editor.ghost.is_some();
    let view = views.then_some(Begin::View);
    let mut all: Vec<Begin> = tools.chain(view).chain([Begin::Open]).collect();
    let width = |count: usize| count as f32 * (BUTTON.x + GAP) - GAP;
    // Beside the axes, or else above them; what has no room is in the menus.
    let beside = viewport.shrink(ABOVE).with_min_x(viewport.left() + AXES.x);
    let room = match beside.width() >= width(all.len()) {
        true => beside,
        false => {
            let above = viewport.shrink(ABOVE);
            above.with_max_y(above.bottom() - AXES.y)
        }
    };
    while all.len() > 1 && width(all.len()) > room.width() {
        all.remove(all.len() - 2);
    }
    if room.height() < 2.0 * BUTTON.y {
        return Vec::new();
    }
    let left = room.center().x - width(all.len()) / 2.0;
    let places = (0..all.len()).map(|at| {
        let left = left + at as f32 * (BUTTON.x + GAP);
        Rect::from_min_size(egui::pos2(left, room.bottom() - BUTTON.y), BUTTON)
    });
    let mut found: Vec<(Begin, Rect)> = all.clone().into_iter().zip(places).collect();
    found.extend(recent(editor, room));
    found
}

/// The files that were open last, above what else is offered.
fn recent(editor: &Editor, room: Rect) -> impl Iterator<Item = (Begin, Rect)> + use<> {
    let fit = ((room.width() + GAP) / (RECENT + GAP)).max(0.0) as usize;
    let high = room.height() >= 3.0 * BUTTON.y;
    let count = fit.min(MOST).min(editor.recent.len() * usize::from(high));
    let step = RECENT + GAP;
    let left = room.center().x - (count as f32 * step - GAP) / 2.0;
    // Where pictures would cover the path there are the names alone.
    let height = match room.height() < 5.0 * PICTURED {
        true => theme::ROW,
        false => PICTURED,
    };
    let top = room.bottom() - BUTTON.y - GAP - height;
    (0..count).map(move |at| {
        let corner = egui::pos2(left + at as f32 * step, top);
        let place = Rect::from_min_size(corner, vec2(RECENT, height));
        (Begin::Recent(at), place)
    })
}

impl Editor {
    /// Whether nothing has been done to the path yet: it can be begun with a tool, or around an
    /// object.
    pub(crate) fn begins(&self) -> bool {
        let document = &self.document;
        let of_none = self.file.is_none() && document.edited_scene().is_none();
        of_none && document.path().is_new()
    }
}

/// How many points lie outside the space, where nothing is dragged.
fn outside(editor: &Editor) -> usize {
    if editor.document.in_step() || !editor.document.edits_path() {
        return 0;
    }
    let path = editor.document.path();
    let (low, high) = (path.space.low(), path.space.high());
    let points = path.points.iter();
    points
        .filter(|point| point.position.cmplt(low).any() || point.position.cmpgt(high).any())
        .count()
}

/// The words on the button for them, and its place.
fn notice(editor: &Editor, viewport: Rect) -> Option<(String, Rect)> {
    let texts = &editor.texts().space;
    let text = match outside(editor) {
        0 => return None,
        1 => texts.one_outside.to_owned(),
        many => fill(texts.some_outside, &[&many]),
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
    let offered = offered(editor, viewport).into_iter();
    let notice = notice(editor, viewport).map(|(_, place)| place);
    offered.map(|(_, place)| place).chain(notice)
}

/// Shows both.
pub(super) fn show(editor: &Editor, ui: &mut Ui, viewport: Rect, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let names = editor.recent_names();
    for (begin, place) in offered(editor, viewport) {
        if let Begin::Recent(at) = begin {
            let name = names.get(at).map(String::as_str).unwrap_or_default();
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
            let told = fill(texts.begin_with, &[&name]);
            response.widget_info(|| WidgetInfo::labeled(Role::Button, true, told.as_str()));
            let file = editor.recent.get(at).map(|file| file.display().to_string());
            let hints = &editor.texts().menu_hints;
            let hint = fill(hints.recent, &[&file.unwrap_or_default()]);
            if response.on_hover_text(hint).clicked() {
                actions.push(Action::Recent(at));
            }
            continue;
        }
        let (name, hint, action) = match begin {
            Begin::Tool(tool) => (
                editor.language().tool(tool.name),
                editor.language().tool_hint(&tool),
                Action::Tool(tool),
            ),
            Begin::View => (
                texts.begin_view,
                texts.take_over_here_tip,
                Action::TakeOver { replace: true },
            ),
            Begin::Open | Begin::Recent(_) => {
                (texts.begin_open, texts.begin_open_tip, Action::Load)
            }
        };
        let response = ui.put(place, Button::new("").frame_when_inactive(true));
        let way = response.hovered().then(|| {
            ui.ctx().request_repaint_after(FRAME);
            (ui.input(|input| input.time) / ROUND).fract() as f32
        });
        let told = fill(texts.begin_with, &[&name]);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, told.as_str()));
        let color = ui.style().interact(&response).fg_stroke.color;
        let painter = ui.painter_at(place);
        picture(&painter, begin, place.center() - vec2(0.0, 9.0), color, way);
        let foot = place.center_bottom() - vec2(0.0, 4.0);
        let font = FontId::proportional(11.5);
        painter.text(foot, Align2::CENTER_BOTTOM, name, font, color);
        if response.on_hover_text(hint).clicked() {
            actions.push(action);
        }
    }
    if let Some((text, place)) = notice(editor, viewport) {
        let button = Button::new(egui::RichText::new(text).font(theme::small()));
        let response = ui.put(place, button.truncate());
        if response.on_hover_text(texts.outside_tip).clicked() {
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
}

/// A small sign of a beginning around `at`; a camera is so far on its way.
fn picture(painter: &Painter, begin: Begin, at: Pos2, color: Color32, way: Option<f32>) {
    let stroke = Stroke::new(1.5, color);
    let line = |points: &[[f32; 2]]| {
        let points = points.iter().map(|&[x, y]| at + vec2(x, y)).collect();
        painter.add(Shape::line(points, stroke));
    };
    let flown = |points: &[[f32; 2]]| {
        line(points);
        if let (Some(way), Some(last)) = (way, points.len().checked_sub(1)) {
            let along = way * last as f32;
            let from = points[(along as usize).min(last)];
            let to = points[(along as usize + 1).min(last)];
            let [x, y] = [0, 1].map(|k| from[k] + along.fract() * (to[k] - from[k]));
            painter.circle_filled(at + vec2(x, y), 3.0, color);
        }
    };
    let thing = |x: f32, y: f32| {
        let corners = [vec2(0.0, -4.5), vec2(4.5, 4.0), vec2(-4.5, 4.0)];
        let corners = corners.map(|corner| at + vec2(x, y) + corner).to_vec();
        painter.add(Shape::convex_polygon(corners, color, Stroke::NONE));
    };
    let round = |wide: f32, high: f32, turns: f32| {
        let points: Vec<[f32; 2]> = (0..=32_u8)
            .map(|step| {
                let share = f32::from(step) / 32.0;
                let (sine, cosine) = (std::f32::consts::TAU * turns * share + 0.6).sin_cos();
                [wide * cosine, high * sine]
            })
            .collect();
        flown(&points);
    };
    match begin {
        Begin::Recent(_) => {}
        Begin::Open => {
            line(&[
                [-10.0, 7.0],
                [-10.0, -6.0],
                [-4.0, -6.0],
                [-2.0, -3.0],
                [9.0, -3.0],
            ]);
            line(&[
                [9.0, -3.0],
                [9.0, 7.0],
                [-10.0, 7.0],
                [-6.0, 1.0],
                [13.0, 1.0],
                [9.0, 7.0],
            ]);
        }
        Begin::View => {
            line(&[
                [-9.0, -6.0],
                [4.0, -6.0],
                [4.0, 6.0],
                [-9.0, 6.0],
                [-9.0, -6.0],
            ]);
            line(&[[4.0, 0.0], [11.0, -5.0], [11.0, 5.0], [4.0, 0.0]]);
        }
        Begin::Tool(tool) => match tool.name {
            "flyby" => {
                thing(0.0, 3.0);
                flown(&[[-16.0, -8.0], [14.0, -8.0]]);
                line(&[[10.0, -11.0], [15.0, -8.0], [10.0, -5.0]]);
            }
            "draw" => {
                let wave: Vec<[f32; 2]> = (0..=24_u8)
                    .map(|step| {
                        let x = f32::from(step) * 1.25 - 15.0;
                        [x, 6.0 * (x / 5.0).sin()]
                    })
                    .collect();
                flown(&wave);
            }
            "tour" => {
                thing(-6.0, 1.0);
                thing(7.0, 1.0);
                round(16.0, 9.0, 0.92);
            }
            _ => {
                thing(0.0, 0.0);
                round(15.0, 8.0, 0.92);
            }
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::screenshots::screenshot;
    use crate::tests::*;

    fn begins(window: &Window) -> usize {
        let editor = window.state();
        let space = window.get_by_label(editor.texts().space.name).rect();
        offered(editor, space).len()
    }

    /// One click, and Enter keeps it; with undo the beginning is there again.
    #[test]
    fn an_empty_document_offers_beginnings_until_something_is_done() {
        for language in BOTH {
            let texts = language.texts();
            let mut window = window(language);
            let all = begins(&window);
            let tools = TOOLS
                .iter()
                .filter(|name| tool::tools().any(|tool| tool.name == **name));
            assert_eq!(all, tools.count() + 1);
            screenshot(&mut window, &format!("begin-{language:?}.png"));
            let before = window.state().document.path().clone();
            let orbit = fill(texts.space.begin_with, &[&language.tool("orbit")]);
            click(&mut window, &orbit);
            assert!(window.state().windows.tool.is_some());
            assert_eq!(begins(&window), 0);
            press(&mut window, egui::Modifiers::NONE, Key::Enter);
            assert!(window.state().windows.tool.is_none());
            assert_ne!(*window.state().document.path(), before);
            assert_eq!(begins(&window), 0);
        }
        // Where there is a path there is nothing to begin.
        let window = window_with_points(Language::English, LARGE, 1.0, Theme::Dark);
        assert_eq!(begins(&window), 0);
    }

    /// The files that were open last are offered too, and one click opens one of them.
    #[test]
    fn recent_files_are_offered() {
        for language in BOTH {
            let folder = tempfile::tempdir().unwrap();
            let start = |size| {
                let folders = crate::Folders {
                    state: Some(folder.path().to_owned()),
                    ..crate::Folders::default()
                };
                let options = Options {
                    folders,
                    ..options(language)
                };
                window_of(options, size, 1.0, Theme::Light)
            };
            let tools = begins(&start(LARGE));
            let path = some_points();
            let names = [
                "first.vid",
                "a rather long name of a flight past a house.vid",
            ];
            for name in names {
                let file = folder.path().join(name);
                path.save(&file).unwrap();
                start(LARGE).state_mut().note_file(&file);
            }
            for size in [LARGE, SMALL, [700.0, 450.0]] {
                let mut window = start(size);
                let space = window.get_by_label(language.texts().space.name).rect();
                let all = offered(window.state(), space);
                assert!(size != LARGE || all.len() == tools + 2);
                for (at, (_, place)) in all.iter().enumerate() {
                    assert!(space.contains_rect(*place), "{size:?}: {place:?}");
                    let apart = |(_, other): &(Begin, Rect)| !other.intersects(*place);
                    assert!(all[at + 1..].iter().all(apart), "{size:?}");
                }
                screenshot(&mut window, &format!("recent-{language:?}-{}.png", size[0]));
            }
            let mut window = start(LARGE);
            let first = fill(language.texts().space.begin_with, &[&names[0]]);
            click(&mut window, &first);
            let editor = window.state();
            assert_eq!(editor.file, Some(folder.path().join(names[0])));
            assert_eq!(editor.document.path(), path.path());
            assert_eq!(begins(&window), 0);
        }
    }

    /// They lie within the space, apart from one another, whatever its size.
    #[test]
    fn beginnings_have_room_or_are_left_out() {
        for size in [
            [640.0, 440.0],
            [700.0, 450.0],
            [800.0, 600.0],
            [1200.0, 800.0],
            [3840.0, 2160.0],
        ] {
            for language in BOTH {
                let mut window = window_of(options(language), size, 1.0, Theme::Light);
                let space = window.get_by_label(language.texts().space.name).rect();
                let all = offered(window.state(), space);
                assert!(!all.is_empty(), "{size:?}");
                for (at, (_, place)) in all.iter().enumerate() {
                    assert!(space.contains_rect(*place), "{size:?}: {place:?}");
                    let apart = |(_, other): &(Begin, Rect)| !other.intersects(*place);
                    assert!(all[at + 1..].iter().all(apart), "{size:?}");
                }
                screenshot(&mut window, &format!("begin-{language:?}-{}.png", size[0]));
            }
        }
    }

    #[test]
    fn points_outside_are_told_at_the_space_and_a_click_mends_it() {
        for language in BOTH {
            let texts = &language.texts().space;
            let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
            assert_eq!(outside(window.state()), 0);
            let far = DVec3::new(3.0, 0.2, 0.1);
            let edits =
                [0, 1].map(|at| Edit::set(At::Point(at), "position", far * (1.0 + at as f64)));
            for edit in edits {
                assert!(window.state_mut().document.apply(edit).is_ok());
            }
            window.run();
            let path = window.state().document.path().clone();
            let text = fill(texts.some_outside, &[&2]);
            screenshot(&mut window, &format!("outside-{language:?}.png"));
            click(&mut window, &text);
            assert_eq!(outside(window.state()), 0);
            assert!(window.query_by_label(&text).is_none());
            // The space alone has changed, in one step.
            assert_eq!(window.state().document.path().points, path.points);
            press(&mut window, egui::Modifiers::CTRL, Key::Z);
            assert_eq!(*window.state().document.path(), path);
        }
    }
}
