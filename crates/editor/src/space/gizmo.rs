//! The axes in a corner of the space: a click looks along one; a menu has the
//! view's numbers.

use egui::{
    Align2, Button, FontId, Grid, Popup, PopupCloseBehavior, Pos2, Rect, RichText, Role, Sense,
    Stroke, Ui, Vec2, WidgetInfo, vec2,
};
use glam::DVec3;

use super::projection::{Axis, Projection};
use super::{menu, sliders};
use crate::action::Action;
use crate::setup::{Element, View};
use crate::space::surface::projection_of;
use crate::state::Editor;
use crate::texts::fill;
use crate::theme;

/// Its middle from the lower left corner, and how long its axes are, in points.
const MIDDLE: Vec2 = vec2(48.0, -48.0);
const LENGTH: f32 = 29.0;

/// Half the room that an end takes, and what is seen of one towards us and of one behind.
const ROOM: f32 = 12.0;
const NEAR: f32 = 9.0;
const FAR: f32 = 5.0;

/// Position and size of its menu button.
const BUTTON: [Vec2; 2] = [vec2(94.0, -36.0), vec2(118.0, 24.0)];

/// Turned and tilted so, one looks along an axis.
const ALONG: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [180.0, 0.0],
    [-90.0, 0.0],
    [90.0, 0.0],
    [0.0, 90.0],
    [0.0, -90.0],
];

/// An end of an axis: which way it points, where it is seen, and how far towards us.
#[derive(Debug)]
struct End {
    axis: Axis,
    back: bool,
    place: Pos2,
    toward: f64,
}

impl End {
    fn way(&self) -> DVec3 {
        let mut way = DVec3::ZERO;
        way[self.axis.index()] = if self.back { -1.0 } else { 1.0 };
        way
    }

    fn room(&self) -> Rect {
        Rect::from_center_size(self.place, Vec2::splat(2.0 * ROOM))
    }

    /// The view from there, as large as this one and as far aside.
    fn view(&self, editor: &Editor, viewport: Rect) -> View {
        let space = editor.document.path().space;
        let views = ALONG.map(|[rotation, tilt]| View {
            rotation,
            tilt,
            ..editor.setup.view
        });
        let toward = |view: &View| {
            let projection = Projection::of(view, viewport, space);
            projection.toward().dot(self.way())
        };
        let best = views
            .into_iter()
            .max_by(|a, b| toward(a).total_cmp(&toward(b)));
        best.unwrap_or(editor.setup.view)
    }
}

/// The six ends, those towards us last.
fn ends(projection: &Projection, viewport: Rect) -> Vec<End> {
    let middle = viewport.left_bottom() + MIDDLE;
    let scale = f64::from(LENGTH) / projection.scale() * projection.space().half_size;
    let all = Axis::ALL.into_iter().flat_map(|axis| {
        [true, false].map(|back| {
            let mut end = End {
                axis,
                back,
                place: middle,
                toward: 0.0,
            };
            let way = end.way();
            let image = projection.image_of_way(way * scale);
            #[allow(clippy::cast_possible_truncation)]
            let image = vec2(image.x as f32, image.y as f32);
            (end.place, end.toward) = (middle + image, projection.toward().dot(way));
            end
        })
    });
    let mut all: Vec<End> = all.collect();
    all.sort_by(|a, b| a.toward.total_cmp(&b.toward));
    all
}

fn button_place(viewport: Rect) -> Rect {
    let [place, size] = BUTTON;
    Rect::from_min_size(viewport.left_bottom() + place, size)
}

/// What lies above the space: not to be dragged there.
pub(super) fn rooms(editor: &Editor, viewport: Rect) -> Vec<Rect> {
    let ends = ends(&projection_of(editor, viewport), viewport);
    let rooms = ends.iter().map(End::room);
    rooms.chain([button_place(viewport)]).collect()
}

/// Shows it; `before` is the view before one of its numbers was dragged.
pub(super) fn show(
    editor: &Editor,
    before: &mut Option<View>,
    ui: &mut Ui,
    viewport: Rect,
    actions: &mut Vec<Action>,
) {
    let hints = &editor.texts().menu_hints;
    let palette = theme::palette(ui);
    let colours = editor.setup.colours();
    let (colour, ground) = (
        colours.of(Element::Numbers),
        colours.of(Element::Background),
    );
    let painter = ui.painter_at(viewport);
    let middle = viewport.left_bottom() + MIDDLE;
    for end in ends(&projection_of(editor, viewport), viewport) {
        let id = ui.scope_id().with(("axis", end.axis.index(), end.back));
        let response = ui.interact(end.room(), id, Sense::CLICK);
        let sign = if end.back { "−" } else { "" };
        let letter = format!("{sign}{}", end.axis.letter());
        let name = fill(hints.view_along, &[&letter]);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
        let lively = response.hovered();
        let (fill, text) = match (lively, end.back) {
            (true, _) => (palette.accent, palette.on_accent),
            (false, false) => (colour, ground),
            (false, true) => (ground, colour),
        };
        let half = if end.back && !lively { FAR } else { NEAR };
        if !end.back {
            painter.line_segment([middle, end.place], Stroke::new(1.5, colour));
        }
        painter.circle(end.place, half, fill, Stroke::new(1.2, colour));
        if !end.back || lively {
            let font = FontId::proportional(11.0);
            painter.text(end.place, Align2::CENTER_CENTER, letter, font, text);
        }
        if response.on_hover_text(name).clicked() {
            actions.push(Action::View(end.view(editor, viewport)));
        }
    }
    numbers(editor, before, ui, viewport, actions);
}

/// The button that tells the view's numbers, with its menu.
fn numbers(
    editor: &Editor,
    before: &mut Option<View>,
    ui: &mut Ui,
    viewport: Rect,
    actions: &mut Vec<Action>,
) {
    let (texts, view) = (&editor.texts().space, &editor.setup.view);
    let whole = |value: f64| editor.language().number(value, 0);
    let words = format!(
        "{} %  {}°  {}°",
        whole(100.0 * view.size),
        whole(view.rotation),
        whole(view.tilt)
    );
    let button = Button::new(RichText::new(words.as_str()).font(theme::small()));
    let response = ui.put(button_place(viewport), button);
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(words.clone()),
        ..WidgetInfo::labeled(Role::ComboBox, true, texts.view_menu)
    });
    let menu = Popup::menu(&response).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    menu.show(|ui| {
        let mut shown = editor.shows_sliders();
        if !shown {
            Grid::new("view").num_columns(2).show(ui, |ui| {
                sliders::numbers(editor, before, viewport, ui, actions);
            });
            ui.separator();
        }
        let oblique = View {
            rotation: View::default().rotation,
            tilt: View::default().tilt,
            ..*view
        };
        let hint = texts.view_oblique_tip;
        if ui.button(texts.view_oblique).on_hover_text(hint).clicked() {
            actions.push(Action::View(oblique));
        }
        menu::views(editor, ui, actions);
        ui.separator();
        let tick = theme::tick(ui, &mut shown, texts.sliders);
        if tick.on_hover_text(texts.sliders_tip).clicked() {
            actions.push(Action::SwitchSliders);
        }
        let mut wireframe = editor.setup.wireframe;
        let tick = theme::tick(ui, &mut wireframe, texts.wireframe);
        if tick.on_hover_text(texts.wireframe_tip).clicked() {
            actions.push(Action::SwitchWireframe);
        }
    });
    response.on_hover_text(texts.view_menu_tip);
}

#[cfg(test)]
mod tests {
    use egui::{Modifiers, Role};

    use crate::screenshots::screenshot;
    use crate::setup::View;
    use crate::tests::*;
    use vides_engine::path::{CameraPath, Space, Up};

    /// After a click on an end, its axis points at the viewer, whichever axis is up.
    #[test]
    fn a_click_on_an_end_looks_along_its_axis() {
        for up in [Up::Y, Up::Z] {
            let space = Space {
                up,
                ..Space::default()
            };
            let path = CameraPath {
                space,
                ..CameraPath::default()
            };
            let options = Options {
                document: Document::from_parts(path, vides_document::Info::default()).unwrap(),
                ..options(Language::English)
            };
            let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
            for (number, letter) in ["x", "y", "z", "−x", "−y", "−z"].into_iter().enumerate()
            {
                let turned = View {
                    rotation: 33.0,
                    tilt: 21.0,
                    size: 1.5,
                    shift: [0.1, 0.0],
                };
                window.state_mut().setup.view = turned;
                window.run();
                click(&mut window, &format!("Look along the {letter} axis"));
                let view = window.state().setup.view;
                let viewport = window
                    .get_by_role_and_label(Role::Canvas, "Movement window")
                    .rect();
                let toward = super::Projection::of(&view, viewport, space).toward();
                let mut expected = DVec3::ZERO;
                expected[number % 3] = if number < 3 { 1.0 } else { -1.0 };
                let seen = toward.normalize();
                assert!(seen.abs_diff_eq(expected, 1e-9), "{up:?} {letter}: {seen}");
                assert_eq!((view.size, view.shift), (1.5, [0.1, 0.0]));
            }
            screenshot(&mut window, &format!("gizmo-{up:?}.png"));
        }
    }

    #[test]
    fn the_sliders_are_a_choice_and_their_numbers_in_the_menu() {
        for language in BOTH {
            let texts = &language.texts().space;
            let mut window = window(language);
            let slider = |window: &Window| {
                let mut all = window.query_all_by_role_and_label(Role::Slider, texts.rotate);
                all.next().is_some()
            };
            assert!(!slider(&window));
            click(&mut window, texts.view_menu);
            enter(&mut window, texts.rotate, "45");
            assert_eq!(window.state().setup.view.rotation, 45.0);
            screenshot(&mut window, &format!("gizmo-menu-{language:?}.png"));
            click(&mut window, texts.sliders);
            assert!(slider(&window));
            press(&mut window, Modifiers::NONE, Key::Escape);
            screenshot(&mut window, &format!("gizmo-sliders-{language:?}.png"));
            click(&mut window, texts.view_menu);
            click(&mut window, texts.sliders);
            assert!(!slider(&window));
        }
    }

    /// A host of 1994 finds its window as it was.
    #[test]
    fn where_the_host_fixes_the_speeds_the_sliders_are_there() {
        let options = Options {
            fixed_speeds: true,
            ..options(Language::English)
        };
        let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
        assert!(window.state().shows_sliders());
        let context = window.ctx.clone();
        window
            .state_mut()
            .act(crate::action::Action::SwitchSliders, &context);
        assert!(!window.state().shows_sliders());
    }
}
