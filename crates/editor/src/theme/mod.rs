//! Colours, text sizes, distances: one palette for dark, one for light.
//!
//! Distances are multiples of four points. A test holds all colours against the contrasts of WCAG
//! 2: 4.5:1 for text on all that it may stand on (AA), 3:1 for what shows where a control is
//! (1.4.11). A button's text identifies it, so its background may be calm. Nothing is animated, so
//! that an idle window uses no power.

mod fonts;

use egui::style::{ScrollAnimation, ScrollStyle, Selection, TextCursorStyle, WidgetVisuals};
use egui::text::{CCursor, CCursorRange, LayoutJob, TextFormat, TextWrapping};
use egui::{
    Align2, Color32, CornerRadius, FontFamily, FontId, Id, Margin, Mesh, Painter, Pos2, Rect,
    Response, RichText, Shadow, Shape, Stroke, Style, TextEdit, TextStyle, Ui, Visuals, vec2,
};

use crate::setup::Theme;

#[derive(Debug)]
pub(super) struct Palette {
    /// Behind panels, menu bar and windows.
    pub(super) panel: Color32,
    /// Behind numbers and texts that can be typed into, and behind pictures.
    pub(super) field: Color32,
    pub(super) button: Color32,
    pub(super) hovered: Color32,
    pub(super) pressed: Color32,
    pub(super) line: Color32,
    /// The border of a window.
    pub(super) rim: Color32,
    /// The border of a field, a box or a circle, and rails.
    pub(super) edge: Color32,
    pub(super) text: Color32,
    /// Headings, units, what matters less.
    pub(super) weak: Color32,
    /// What is selected, the handle of the play bar, the curve of a picture.
    pub(super) accent: Color32,
    pub(super) on_accent: Color32,
    /// The text of an error.
    pub(super) error: Color32,
    pub(super) focus: Color32,
}

/// A label as wide as others above and below it.
pub(super) fn label(ui: &mut Ui, width: f32, text: &str) -> Response {
    let row = ui.horizontal(|ui| {
        ui.set_width(width);
        ui.label(text)
    });
    row.inner
}

/// Selects a text that stands at the beginning of a field.
pub(super) fn select(ui: &Ui, field: Id, text: &str) {
    let range = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
    let mut state = TextEdit::load_state(ui.ctx(), field).unwrap_or_default();
    state.cursor.set_char_range(Some(range));
    TextEdit::store_state(ui.ctx(), field, state);
}

/// A colour by its code, `0xrrggbb`.
pub(super) const fn rgb(code: u32) -> Color32 {
    let [_, red, green, blue] = code.to_be_bytes();
    Color32::from_rgb(red, green, blue)
}

static DARK: Palette = Palette {
    panel: rgb(0x1c_2027),
    field: rgb(0x12_151a),
    button: rgb(0x2b_303a),
    hovered: rgb(0x37_3d49),
    pressed: rgb(0x43_4b59),
    line: rgb(0x2f_353f),
    rim: rgb(0x3f_4753),
    edge: rgb(0x69_7382),
    text: rgb(0xe6_e9ee),
    weak: rgb(0xa3_adba),
    accent: rgb(0x58_aeff),
    on_accent: rgb(0x0b_1220),
    error: rgb(0xff_9a92),
    focus: rgb(0x8c_c8ff),
};

static LIGHT: Palette = Palette {
    panel: rgb(0xff_ffff),
    field: rgb(0xf1_f4f8),
    button: rgb(0xe8_ebf0),
    hovered: rgb(0xdd_e2e9),
    pressed: rgb(0xcf_d6df),
    line: rgb(0xd8_dde4),
    rim: rgb(0xbf_c7d1),
    edge: rgb(0x7f_8a98),
    text: rgb(0x18_1d25),
    weak: rgb(0x50_5a67),
    accent: rgb(0x0b_63c4),
    on_accent: rgb(0xff_ffff),
    error: rgb(0xae_1f17),
    focus: rgb(0x0b_63c4),
};

impl Theme {
    pub(super) fn palette(self) -> &'static Palette {
        match self {
            Self::Dark => &DARK,
            Self::Light => &LIGHT,
        }
    }

    pub(super) fn of_system(theme: egui::Theme) -> Self {
        match theme {
            egui::Theme::Dark => Self::Dark,
            egui::Theme::Light => Self::Light,
        }
    }

    pub(super) fn of_egui(self) -> egui::Theme {
        match self {
            Self::Dark => egui::Theme::Dark,
            Self::Light => egui::Theme::Light,
        }
    }
}

/// The colours in force here.
pub(super) fn palette(ui: &egui::Ui) -> &'static Palette {
    palette_of(ui.visuals())
}

/// The colours that go with egui's.
pub(super) fn palette_of(visuals: &Visuals) -> &'static Palette {
    if visuals.dark_mode { &DARK } else { &LIGHT }
}

pub(super) const TEXT: f32 = 13.0;
pub(super) const ROW: f32 = 24.0;
/// Distance between things that belong together.
pub(super) const GAP: f32 = 4.0;

/// Height of the bar with the menus.
pub(crate) const BAR: f32 = 32.0;

/// Anything higher and wider is no control but a part of the window.
pub(crate) const LARGE: f32 = 160.0;

pub(super) fn field(ui: &egui::Ui) -> egui::Frame {
    let palette = palette(ui);
    egui::Frame::new()
        .fill(palette.field)
        .stroke(Stroke::new(1.0, palette.edge))
        .corner_radius(4)
        .inner_margin(Margin::symmetric(6, 0))
}

/// A field for a line of text with a name and a tooltip.
pub(super) fn line_edit(
    ui: &mut Ui,
    text: &mut String,
    id: &'static str,
    width: f32,
    (name, hint): (&'static str, &'static str),
) -> Response {
    let edit = TextEdit::singleline(text)
        .id(Id::unique(id))
        .desired_width(width)
        .frame(field(ui))
        .align(Align2::LEFT_CENTER)
        .margin(Margin::symmetric(6, 0))
        .min_size(vec2(0.0, ROW));
    let response = ui.add(edit).on_hover_text(hint);
    ui.ctx()
        .accesskit_node_builder(response.id, |node| node.set_label(name));
    response
}

pub(super) fn tick(ui: &mut Ui, on: &mut bool, text: &str) -> Response {
    marked(ui, *on, text, |ui, text| ui.checkbox(on, text))
}

/// The circle of one of several choices.
pub(super) fn choice(ui: &mut Ui, chosen: bool, text: &str) -> Response {
    marked(ui, chosen, text, |ui, text| ui.radio(chosen, text))
}

/// Between choices in a row.
const APART: f32 = 12.0;

/// Choices by their numbers and words, two in a row where both have room; the one that is clicked.
pub(super) fn choices(
    ui: &mut Ui,
    chosen: Option<f64>,
    mut words: &[(f64, &'static str)],
    hint: &str,
) -> Option<f64> {
    let mut clicked = None;
    while !words.is_empty() {
        let widths = words.iter().take(2).map(|(_, word)| choice_width(ui, word));
        let together = words.len() > 1 && widths.sum::<f32>() + APART <= ui.available_width();
        let (row, rest) = words.split_at(if together { 2 } else { 1 });
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = APART;
            for &(number, word) in row {
                let choice = choice(ui, chosen == Some(number), word);
                if choice.on_hover_text(hint).clicked() {
                    clicked = Some(number);
                }
            }
        });
        words = rest;
    }
    clicked
}

fn choice_width(ui: &Ui, word: &str) -> f32 {
    let spacing = ui.spacing();
    let font = egui::TextStyle::Button.resolve(ui.style());
    let text = (ui.painter()).layout_no_wrap(word.to_owned(), font, Color32::PLACEHOLDER);
    spacing.icon_width + spacing.icon_spacing + text.size().x
}

/// A box or a circle with its text: empty, or filled with the accent.
fn marked(
    ui: &mut Ui,
    on: bool,
    text: &str,
    add: impl FnOnce(&mut Ui, RichText) -> Response,
) -> Response {
    ui.scope(|ui| {
        let palette = palette(ui);
        let (ground, border) = if on {
            (palette.accent, palette.accent)
        } else {
            (palette.field, palette.edge)
        };
        let widgets = &mut ui.visuals_mut().widgets;
        for widget in [
            &mut widgets.inactive,
            &mut widgets.hovered,
            &mut widgets.active,
        ] {
            widget.bg_fill = ground;
            widget.bg_stroke.color = border;
            // Seen only where it is on.
            widget.fg_stroke = Stroke::new(1.5, palette.on_accent);
        }
        widgets.hovered.bg_stroke.color = palette.accent;
        widgets.active.bg_stroke = focus(palette);
        add(ui, RichText::new(text).color(palette.text))
    })
    .inner
}

/// The border of what has the keyboard, visible on the accent, too.
pub(super) fn focus(palette: &Palette) -> Stroke {
    Stroke::new(2.0, palette.text)
}

/// The font of all text; its digits are of equal width, so that numbers align.
pub(super) fn text() -> FontId {
    FontId::new(TEXT, FontFamily::Proportional)
}

/// A small text at the right of a place, as long as the painter's room; whether it ends early.
pub(super) fn elided(painter: &Painter, place: Pos2, text: &str, colour: Color32) -> bool {
    let mut job = LayoutJob::single_section(text.to_owned(), TextFormat::simple(small(), colour));
    let room = painter.clip_rect().right() - place.x;
    job.wrap = TextWrapping::truncate_at_width(room.max(0.0));
    let galley = painter.layout_job(job);
    let ends_early = galley.elided;
    let rect = Align2::LEFT_CENTER.anchor_size(place, galley.size());
    painter.galley(rect.min, galley, colour);
    ends_early
}

/// The sign before what is folded or unfolded.
pub(super) fn triangle(centre: Pos2, open: bool, color: Color32) -> Shape {
    let ways = match open {
        true => [vec2(-4.0, -2.5), vec2(4.0, -2.5), vec2(0.0, 3.0)],
        false => [vec2(-2.5, -4.0), vec2(-2.5, 4.0), vec2(3.0, 0.0)],
    };
    let corners = ways.map(|way| centre + way).to_vec();
    Shape::convex_polygon(corners, color, Stroke::NONE)
}

pub(super) fn heading() -> FontId {
    FontId::new(14.0, FontFamily::Proportional)
}

/// The font of remarks that must not stand out.
pub(super) fn small() -> FontId {
    FontId::new(11.0, FontFamily::Proportional)
}

/// A plain rectangle. egui's own has soft borders, of forty triangles instead of two: too many
/// beside each of a hundred points.
pub(super) fn block(rect: Rect, color: Color32) -> Shape {
    let mut mesh = Mesh::default();
    mesh.add_colored_rect(rect, color);
    Shape::mesh(mesh)
}

/// Gives a context our looks, with this [`Theme`] shown.
pub(super) fn apply(context: &egui::Context, theme: Theme) {
    context.set_fonts(crate::theme::fonts::definitions());
    for theme in [Theme::Dark, Theme::Light] {
        context.set_style_of(theme.of_egui(), style(theme));
    }
    context.set_theme(theme.of_egui());
}

fn style(theme: Theme) -> Style {
    let palette = theme.palette();
    let mut style = theme.of_egui().default_style();
    let proportional = |size| FontId::new(size, FontFamily::Proportional);
    style.text_styles = [
        (TextStyle::Small, proportional(11.0)),
        (TextStyle::Body, proportional(TEXT)),
        (TextStyle::Button, proportional(TEXT)),
        (TextStyle::Heading, proportional(15.0)),
        (
            TextStyle::Monospace,
            FontId::new(12.0, FontFamily::Monospace),
        ),
    ]
    .into();
    style.animation_time = 0.0;
    style.scroll_animation = ScrollAnimation::none();
    style.visuals = visuals(theme, palette);
    let spacing = &mut style.spacing;
    spacing.item_spacing = vec2(GAP, GAP);
    spacing.button_padding = vec2(8.0, 4.0);
    spacing.interact_size = vec2(ROW, ROW);
    spacing.window_margin = Margin::same(12);
    spacing.menu_margin = Margin::same(4);
    spacing.slider_rail_height = 4.0;
    spacing.icon_width = 16.0;
    spacing.icon_width_inner = 8.0;
    spacing.icon_spacing = 8.0;
    spacing.tooltip_width = 320.0;
    spacing.scroll = ScrollStyle::thin();
    spacing.scroll.fade.strength = 0.0;
    style.interaction.selectable_labels = false;
    style
}

fn visuals(theme: Theme, palette: &Palette) -> Visuals {
    let mut visuals = theme.of_egui().default_visuals();
    visuals.widgets.noninteractive = widget(palette.panel, palette.line, palette.text);
    visuals.widgets.inactive = WidgetVisuals {
        // Rails, handles, boxes.
        bg_fill: palette.edge,
        ..widget(palette.button, palette.button, palette.text)
    };
    visuals.widgets.hovered = widget(palette.hovered, palette.rim, palette.text);
    visuals.widgets.active = widget(palette.pressed, palette.focus, palette.text);
    visuals.widgets.open = widget(palette.hovered, palette.hovered, palette.text);
    visuals.selection = Selection {
        bg_fill: palette.accent,
        stroke: Stroke::new(1.0, palette.on_accent),
    };
    visuals.weak_text_color = Some(palette.weak);
    visuals.hyperlink_color = palette.accent;
    visuals.faint_bg_color = palette.field;
    visuals.extreme_bg_color = palette.field;
    visuals.text_edit_bg_color = Some(palette.field);
    visuals.warn_fg_color = palette.error;
    visuals.error_fg_color = palette.error;
    visuals.panel_fill = palette.panel;
    visuals.window_fill = palette.panel;
    visuals.window_stroke = Stroke::new(1.0, palette.rim);
    visuals.window_corner_radius = CornerRadius::same(6);
    visuals.menu_corner_radius = CornerRadius::same(6);
    visuals.window_shadow = shadow(theme);
    visuals.popup_shadow = shadow(theme);
    visuals.window_highlight_topmost = false;
    visuals.slider_trailing_fill = true;
    visuals.handle_shape = egui::style::HandleShape::Circle;
    visuals.text_cursor = TextCursorStyle {
        stroke: Stroke::new(1.5, palette.focus),
        blink: false,
        ..TextCursorStyle::default()
    };
    visuals
}

fn widget(fill: Color32, border: Color32, text: Color32) -> WidgetVisuals {
    WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: Stroke::new(1.0, border),
        corner_radius: CornerRadius::same(4),
        fg_stroke: Stroke::new(1.0, text),
        expansion: 0.0,
    }
}

fn shadow(theme: Theme) -> Shadow {
    let alpha = match theme {
        Theme::Dark => 120,
        Theme::Light => 40,
    };
    Shadow {
        offset: [0, 4],
        blur: 12,
        spread: 0,
        color: Color32::from_black_alpha(alpha),
    }
}

/// How far two colours stand apart, from 1 to 21 (WCAG 2.2).
#[cfg(test)]
pub(super) fn contrast(a: Color32, b: Color32) -> f64 {
    let luminance = |colour: Color32| {
        let [red, green, blue, _] = colour.to_array().map(|byte| {
            let part = f64::from(byte) / 255.0;
            if part <= 0.04045 {
                part / 12.92
            } else {
                ((part + 0.055) / 1.055).powf(2.4)
            }
        });
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    };
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::{Colours, Element};

    #[test]
    fn contrast_is_that_of_the_norm() {
        assert!((contrast(Color32::BLACK, Color32::WHITE) - 21.0).abs() < 1e-9);
        // #767676 is the lightest grey that passes on white.
        assert!(contrast(rgb(0x76_7676), Color32::WHITE) >= 4.5);
        assert!(contrast(rgb(0x77_7777), Color32::WHITE) < 4.5);
    }

    #[test]
    fn all_text_can_be_read() {
        for (p, colours) in [(&DARK, Colours::DARK), (&LIGHT, Colours::LIGHT)] {
            let space = colours.of(Element::Background);
            let grounds = [p.panel, space, p.field, p.button, p.hovered, p.pressed];
            for ground in grounds {
                assert!(contrast(p.text, ground) >= 4.5, "{ground:?}");
            }
            for ground in [p.panel, space, p.field, p.button] {
                assert!(contrast(p.weak, ground) >= 4.5, "weak on {ground:?}");
                assert!(contrast(p.error, ground) >= 4.5, "error on {ground:?}");
            }
            assert!(contrast(p.on_accent, p.accent) >= 4.5);
            // What is no text but must be seen: 3:1.
            for ground in [p.panel, space, p.field] {
                assert!(contrast(p.accent, ground) >= 3.0, "accent on {ground:?}");
                assert!(contrast(p.focus, ground) >= 3.0, "focus on {ground:?}");
                // Where controls are, on either side of their border.
                assert!(contrast(p.edge, ground) >= 3.0, "edge on {ground:?}");
            }
            // A tick, the part of a rail up to its handle, the keyboard on a button
            // that is chosen.
            assert!(contrast(p.on_accent, p.accent) >= 3.0);
            for ground in [p.panel, space, p.field, p.button] {
                assert!(contrast(p.text, ground) >= 3.0, "handle on {ground:?}");
            }
        }
    }
}
