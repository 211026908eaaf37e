//! The picture of the speed window: speed, way or acceleration over time, and its squares.

use egui::{
    Align2, CornerRadius, CursorIcon, EventFilter, Id, Key, Modifiers, Painter, Pos2, Rect,
    Response, Sense, Shape, Stroke, StrokeKind, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use vides_engine::limits::{BASE_SPEED, MAX_SPEED, MIN_SPEED, SPEEDS};
use vides_engine::path::{Pace, Timing};

use crate::action::Action;
use crate::entry::Entry;
use crate::state::Editor;
use crate::state::windows::{Held, Quantity};
use crate::theme::{self, Palette};
use crate::windows::speed::section::{SCALE, Section, goes_by_ten};

/// Room above the highest and below the lowest value.
const MARGIN: f32 = 14.0;
/// Half the side of a square.
const SQUARE: f32 = 4.5;
/// Half the side of the frame around one.
const CHOSEN: f32 = 8.5;
/// Straight pieces of the curve.
const PIECES: usize = 180;
/// How near a jump of the acceleration its values on both sides are taken.
const BEFORE: f64 = 1e-9;

impl Quantity {
    pub(super) const ALL: [Self; 3] = [Self::Speed, Self::Distance, Self::Acceleration];

    /// Its value at the share `u` of the time.
    pub(super) fn at(self, section: &Section, u: f64) -> f64 {
        self.of(&section.timing, section.seconds, u)
    }

    /// The same for a timing that takes this many seconds.
    pub(super) fn of(self, timing: &Timing, seconds: f64, u: f64) -> f64 {
        match self {
            Self::Speed => timing.speed(u),
            Self::Distance => 100.0 * timing.fraction(u),
            Self::Acceleration => timing.acceleration(u) / seconds,
        }
    }

    /// The curve: shares of the time, and values.
    fn curve(self, section: &Section) -> Vec<[f64; 2]> {
        let mut times: Vec<f64> = (0..=PIECES).map(|k| k as f64 / PIECES as f64).collect();
        if self == Self::Acceleration {
            let jumps = match &section.pace {
                Pace::Speeds => (1..SPEEDS - 1)
                    .map(|i| i as f64 / (SPEEDS - 1) as f64)
                    .collect(),
                Pace::Ease(ease) => vec![ease.rise, 1.0 - ease.fall],
                Pace::Distance(keys) => keys.iter().map(|key| key[0]).collect(),
                Pace::Part(_) => Vec::new(),
            };
            let sides = jumps.into_iter().flat_map(|u| [u - BEFORE, u + BEFORE]);
            times.extend(sides.map(|u| u.clamp(0.0, 1.0)));
            times.push(1.0 - BEFORE);
            times.sort_by(f64::total_cmp);
        }
        let value = |u| [u, self.at(section, u)];
        times.into_iter().map(value).collect()
    }
}

/// Places shares of the time, and values, in the picture.
pub(super) struct Axes {
    pub(super) rect: Rect,
    /// The distance between two of ten equally distant places.
    step: f32,
    low: f64,
    high: f64,
    curve: Vec<[f64; 2]>,
    pub(super) quantity: Quantity,
}

impl Axes {
    pub(super) fn new(rect: Rect, step: f32, quantity: Quantity, section: &Section) -> Self {
        let curve = quantity.curve(section);
        let highest = curve.iter().map(|point| point[1].abs()).fold(0.0, f64::max);
        let (low, high) = match quantity {
            Quantity::Speed if goes_by_ten(&section.pace) => (MIN_SPEED, MAX_SPEED),
            Quantity::Speed if highest <= MAX_SPEED => (0.0, MAX_SPEED),
            Quantity::Speed => (0.0, round_above(highest)),
            Quantity::Distance => (0.0, 100.0),
            Quantity::Acceleration => {
                let bound = round_above(highest.max(10.0));
                (-bound, bound)
            }
        };
        Self {
            rect: Rect::from_min_max(pos2(rect.left() + SCALE, rect.top()), rect.max),
            step,
            low,
            high,
            curve,
            quantity,
        }
    }

    pub(super) fn x(&self, u: f64) -> f32 {
        self.rect.left() + self.step * (u as f32 * (SPEEDS - 1) as f32 + 1.5)
    }

    pub(super) fn time(&self, x: f32) -> f64 {
        let steps = (x - self.rect.left()) / self.step - 1.5;
        f64::from(steps / (SPEEDS - 1) as f32).clamp(0.0, 1.0)
    }

    pub(super) fn y(&self, value: f64) -> f32 {
        let share = (value - self.low) / (self.high - self.low);
        let room = self.rect.height() - 2.0 * MARGIN;
        self.rect.bottom() - MARGIN - share as f32 * room
    }

    /// A hundredth of the range of values that it shows.
    pub(super) fn percent(&self) -> f64 {
        (self.high - self.low) / 100.0
    }

    pub(super) fn value(&self, y: f32) -> f64 {
        let room = self.rect.height() - 2.0 * MARGIN;
        let share = f64::from((self.rect.bottom() - MARGIN - y) / room);
        (self.low + share * (self.high - self.low)).clamp(self.low, self.high)
    }

    pub(super) fn paint(&self, editor: &Editor, painter: &Painter, section: &Section) {
        let palette = theme::palette_of(&painter.ctx().global_style().visuals);
        self.paint_ground(painter, palette, editor);
        if self.quantity == Quantity::Speed {
            self.paint_neighbours(painter, palette, section);
        }
        let place = |&[u, value]: &[f64; 2]| pos2(self.x(u), self.y(value));
        let line: Vec<Pos2> = self.curve.iter().map(place).collect();
        painter.line(line, Stroke::new(2.0, palette.accent));
    }

    fn paint_ground(&self, painter: &Painter, palette: &Palette, editor: &Editor) {
        let border = Stroke::new(1.0, palette.line);
        let corner = CornerRadius::same(4);
        painter.rect(self.rect, corner, palette.field, border, StrokeKind::Inside);
        for quarter in 0..=4 {
            let value = match quarter {
                0 => self.low,
                // 25, 50 …, though the lowest speed is 1.
                _ if self.low == MIN_SPEED => self.high * f64::from(quarter) / 4.0,
                _ => self.low + (self.high - self.low) * f64::from(quarter) / 4.0,
            };
            let stands_out = match self.quantity {
                Quantity::Speed => value == BASE_SPEED,
                Quantity::Distance => false,
                Quantity::Acceleration => value == 0.0,
            };
            let stroke = if stands_out {
                Stroke::new(1.0, palette.rim)
            } else {
                border
            };
            let y = self.y(value);
            painter.hline(self.rect.left() + 1.0..=self.rect.right() - 1.0, y, stroke);
            let language = editor.language();
            let words = if value.abs() < 1000.0 {
                language.number(value, 0)
            } else if quarter % 2 == 0 {
                language.power(value, 0)
            } else {
                continue;
            };
            let end = pos2(self.rect.left() - 6.0, y);
            let colour = palette.weak;
            painter.text(end, Align2::RIGHT_CENTER, words, theme::small(), colour);
        }
        // The section lies between these.
        for u in [0.0, 1.0] {
            let ends = self.rect.top() + 1.0..=self.rect.bottom() - 1.0;
            painter.vline(self.x(u), ends, border);
        }
    }

    /// The facing speeds of the sections before and after.
    fn paint_neighbours(&self, painter: &Painter, palette: &Palette, section: &Section) {
        for (facing, away, end) in [
            (section.before, -self.step, 0.0),
            (section.after, self.step, 1.0),
        ] {
            let Some(speed) = facing else { continue };
            let there = pos2(self.x(end) + away, self.y(speed));
            let here = pos2(self.x(end), self.y(section.timing.speed(end)));
            let stroke = Stroke::new(1.0, palette.weak);
            painter.extend(Shape::dashed_line(&[there, here], stroke, 4.0, 4.0));
            painter.rect(
                Rect::from_center_size(there, Vec2::splat(2.0 * SQUARE)),
                CornerRadius::same(1),
                palette.field,
                Stroke::new(1.5, palette.weak),
                StrokeKind::Inside,
            );
        }
    }

    /// A square that cannot be moved.
    pub(super) fn paint_fixed(&self, painter: &Painter, palette: &Palette, at: Pos2) {
        let square = Rect::from_center_size(at, Vec2::splat(2.0 * SQUARE));
        let stroke = Stroke::new(1.5, palette.accent);
        let corner = CornerRadius::same(1);
        painter.rect(square, corner, palette.field, stroke, StrokeKind::Inside);
    }

    /// A frame around the square whose numbers are shown.
    pub(super) fn paint_chosen(&self, painter: &Painter, palette: &Palette, at: Pos2) {
        let around = Rect::from_center_size(at, Vec2::splat(2.0 * CHOSEN));
        let stroke = Stroke::new(1.5, palette.text);
        let corner = CornerRadius::same(2);
        painter.rect_stroke(around, corner, stroke, StrokeKind::Inside);
    }
}

/// 1, 2 or 5 times a power of ten, not below a positive value.
fn round_above(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    let rounds = [1.0, 2.0, 5.0, 10.0].map(|part| part * power);
    let least = value * (1.0 - 1e-9);
    rounds
        .into_iter()
        .find(|&round| round >= least)
        .unwrap_or(value)
}

/// A small square that is dragged by the pointer and moved by the arrow keys.
pub(super) struct Handle<'a> {
    pub(super) id: Id,
    pub(super) middle: Pos2,
    /// Where it can be grabbed.
    pub(super) place: Rect,
    pub(super) name: &'a str,
    pub(super) value: f64,
    /// Shown next to it while it is used.
    pub(super) words: String,
    /// They stand at its left, since it lies on a rising curve.
    pub(super) rises: bool,
    pub(super) cursor: CursorIcon,
}

/// What was done to a handle.
pub(super) struct Moved {
    pub(super) response: Response,
    /// Where its middle is dragged to, and whether finely.
    pub(super) to: Option<(Pos2, bool)>,
    /// Steps of the arrow keys to the right and upwards.
    pub(super) steps: [f64; 2],
}

impl Handle<'_> {
    pub(super) fn show(
        self,
        held: &mut Held,
        ui: &Ui,
        within: Rect,
        actions: &mut Vec<Action>,
    ) -> Moved {
        let response = ui.interact(self.place, self.id, Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::slider(true, self.value, self.name));
        if response.clicked() {
            response.request_focus();
        }
        if response.drag_started()
            && let Some(pointer) = ui.input(|input| input.pointer.press_origin())
        {
            actions.push(Action::Enter(Entry::Begin));
            *held = Some((self.id, pointer - self.middle));
            response.request_focus();
        }
        let mine = held.filter(|held| held.0 == self.id);
        let mut to = None;
        if let (Some((_, grip)), Some(pointer)) = (mine, response.interact_pointer_pos())
            && response.dragged()
        {
            to = Some((pointer - grip, ui.input(|input| input.modifiers.shift)));
        }
        if response.drag_stopped() && mine.is_some() {
            actions.push(Action::Enter(Entry::of_end(ui.ctx())));
            *held = None;
        }
        let focused = response.has_focus();
        let steps = if focused {
            steps(ui, self.id)
        } else {
            [0.0; 2]
        };
        let lively = response.hovered() || response.dragged();
        if lively {
            ui.set_cursor_icon(self.cursor);
        }
        self.paint(ui, within, lively || focused);
        Moved {
            response,
            to,
            steps,
        }
    }

    fn paint(self, ui: &Ui, within: Rect, lively: bool) {
        let palette = theme::palette(ui);
        let (size, colour) = if lively {
            (SQUARE + 1.5, palette.focus)
        } else {
            (SQUARE, palette.accent)
        };
        ui.painter().rect(
            Rect::from_center_size(self.middle, Vec2::splat(2.0 * size)),
            CornerRadius::same(1),
            colour,
            Stroke::new(1.0, palette.field),
            StrokeKind::Outside,
        );
        if lively {
            let Pos2 { x, y } = self.middle;
            let (at, align) = if self.rises {
                let at = pos2(x - 8.0, y - 4.0);
                let nearest = within.min + vec2(104.0, 16.0);
                (at.max(nearest), Align2::RIGHT_BOTTOM)
            } else if y - within.top() > 26.0 {
                (pos2(x, y - 10.0), Align2::CENTER_BOTTOM)
            } else {
                (pos2(x, y + 10.0), Align2::CENTER_TOP)
            };
            let text = self.words;
            ui.painter()
                .text(at, align, text, theme::text(), palette.text);
        }
    }
}

/// The steps of the arrow keys: ten with Shift, upwards also by page.
fn steps(ui: &Ui, id: Id) -> [f64; 2] {
    let filter = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, filter));
    ui.input_mut(|input| {
        let mut pressed = |key, modifiers| input.count_and_consume_key(modifiers, key) as f64;
        let mut both = |more, less, modifiers| pressed(more, modifiers) - pressed(less, modifiers);
        let page = both(Key::PageUp, Key::PageDown, Modifiers::NONE);
        let mut arrows = |more, less| {
            let far = both(more, less, Modifiers::SHIFT);
            10.0 * far + both(more, less, Modifiers::NONE)
        };
        let aside = arrows(Key::ArrowRight, Key::ArrowLeft);
        [aside, arrows(Key::ArrowUp, Key::ArrowDown) + 10.0 * page]
    })
}
