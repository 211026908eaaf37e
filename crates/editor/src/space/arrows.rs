//! Arrows along the axes and squares in their planes at the current point: each drags it along that
//! axis or in that plane. In windows of hosts of 1994 the three buttons alone do so.

use egui::{Color32, Painter, Shape, Stroke};
use glam::DVec2;

use super::picking::REACH;
use super::projection::{Axis, Projection, to_pos};
use super::scene::Look;
use crate::setup::Theme;
use crate::state::Editor;
use crate::state::space::{DragConstraint, Handle};
use crate::theme::rgb;

/// Length of the longest arrow, and where its shaft begins, in points.
const LENGTH: f64 = 72.0;
const BEGIN: f64 = 14.0;

/// An arrow or a square that is seen smaller is left out.
const LEAST: f64 = 22.0;
const LEAST_SEEN: f64 = 0.25;

/// Length and half the width of a head, in points.
const HEAD: [f64; 2] = [9.0, 3.6];

/// Where a square begins and ends, as a part of the arrows.
const SQUARE: [f64; 2] = [0.36, 0.56];

/// What is grasped: along an axis, or in the plane across it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Along(Axis),
    Across(Axis),
}

/// The arrows at a place.
struct Arrows {
    foot: DVec2,
    /// Of each axis, from its foot to its tip.
    ways: [DVec2; 3],
    seen: [f64; 3],
}

impl Arrows {
    /// Those of the current point, where it alone is meant.
    fn of(editor: &Editor, projection: &Projection) -> Option<Self> {
        let other = editor.fixed_speeds
            || editor.means_nodes()
            || editor.windows.tool.is_some()
            || editor.several().is_some()
            || editor.is_first_screen();
        let point = editor.point().filter(|_| !other)?;
        editor.document.edits_path().then(|| {
            let long = LENGTH / projection.scale() * projection.space().half_size;
            Self {
                foot: projection.image(point.position),
                ways: Axis::ALL.map(|axis| projection.image_of_way(axis.unit() * long)),
                seen: Axis::ALL.map(|axis| projection.share_seen(axis)),
            }
        })
    }

    fn has(&self, part: Part) -> bool {
        match part {
            Part::Along(axis) => self.ways[axis.index()].length() >= LEAST,
            Part::Across(axis) => self.seen[axis.index()] >= LEAST_SEEN,
        }
    }

    /// The corners of a square.
    fn square(&self, across: Axis) -> [DVec2; 4] {
        let [a, b] = across.others().map(|axis| self.ways[axis.index()]);
        let [from, to] = SQUARE;
        [[from, from], [to, from], [to, to], [from, to]]
            .map(|[at_a, at_b]| self.foot + a * at_a + b * at_b)
    }

    fn parts() -> impl Iterator<Item = Part> {
        let squares = Axis::ALL.map(Part::Across);
        squares.into_iter().chain(Axis::ALL.map(Part::Along))
    }

    fn at(&self, pointer: DVec2) -> Option<Part> {
        let near = |part: &Part| match *part {
            Part::Across(axis) => {
                let middle = self.square(axis).into_iter().sum::<DVec2>() / 4.0;
                middle.distance(pointer) <= REACH
            }
            Part::Along(axis) => {
                let way = self.ways[axis.index()];
                let far = (pointer - self.foot).dot(way.normalize_or_zero());
                let aside = (pointer - self.foot).perp_dot(way.normalize_or_zero());
                far >= BEGIN && far <= way.length() + 2.0 && aside.abs() <= 0.75 * REACH
            }
        };
        Self::parts().find(|part| self.has(*part) && near(part))
    }
}

impl Part {
    fn freedom(self, projection: &Projection) -> DragConstraint {
        let axis = match self {
            Self::Along(axis) => axis,
            Self::Across(axis) => return DragConstraint::keeping(projection, axis),
        };
        let [a, b] = axis.others();
        let fixed = match projection.share_seen(a) > projection.share_seen(b) {
            true => a,
            false => b,
        };
        DragConstraint {
            fixed,
            along: Some(axis),
            edge_on: None,
        }
    }
}

/// What a press at a place drags, how, and how far the pointer is from it.
pub(super) fn grasped(
    editor: &Editor,
    projection: &Projection,
    pointer: DVec2,
) -> Option<(Handle, DragConstraint, DVec2)> {
    let arrows = Arrows::of(editor, projection)?;
    let part = arrows.at(pointer)?;
    let what = Handle::Point(editor.document.selection().point);
    Some((what, part.freedom(projection), arrows.foot - pointer))
}

/// Red, green and blue for x, y and z.
fn colour(theme: Theme, axis: Axis) -> Color32 {
    let codes = match theme {
        Theme::Dark => [0xff_5c5c, 0x5c_d65c, 0x6c_9cff],
        Theme::Light => [0xd0_2020, 0x1c_8a2c, 0x20_50d8],
    };
    rgb(codes[axis.index()])
}

/// Draws them; the one under the pointer, or held, stands out.
pub(super) fn show(editor: &Editor, painter: &Painter, look: &Look<'_>, pointer: Option<DVec2>) {
    let Some(arrows) = Arrows::of(editor, look.projection) else {
        return;
    };
    let meant = pointer.and_then(|pointer| arrows.at(pointer));
    let painter = painter.with_clip_rect(look.viewport);
    for part in Arrows::parts().filter(|&part| arrows.has(part)) {
        let (Part::Along(axis) | Part::Across(axis)) = part;
        let strong = meant == Some(part);
        let colour = colour(editor.setup.theme(), axis);
        match part {
            Part::Across(_) => {
                let corners = arrows.square(axis).map(to_pos).to_vec();
                let fill = colour.gamma_multiply(if strong { 0.8 } else { 0.35 });
                painter.add(Shape::convex_polygon(
                    corners,
                    fill,
                    Stroke::new(1.0, colour),
                ));
            }
            Part::Along(_) => {
                let way = arrows.ways[axis.index()].normalize_or_zero();
                let tip = arrows.foot + arrows.ways[axis.index()];
                let [begin, end] = [arrows.foot + way * BEGIN, tip - way * HEAD[0]];
                let stroke = Stroke::new(if strong { 3.0 } else { 1.8 }, colour);
                painter.line_segment([begin, end].map(to_pos), stroke);
                let side = way.perp() * HEAD[1];
                let head = [tip, end + side, end - side].map(to_pos).to_vec();
                painter.add(Shape::convex_polygon(head, colour, Stroke::NONE));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use egui::{Event, Modifiers, PointerButton};

    use super::*;
    use crate::space::surface::projection_of;
    use crate::tests::*;

    fn projection(window: &Window) -> Projection {
        let name = window.state().texts().space.name;
        projection_of(window.state(), window.get_by_label(name).rect())
    }

    fn press_at(window: &mut Window, at: DVec2, pressed: bool) {
        window.event(Event::PointerButton {
            pos: to_pos(at),
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        window.run();
    }

    /// A pull at an arrow changes one coordinate, at a square two, both by as far as the pointer goes;
    /// a host of 1994 has neither.
    #[test]
    fn arrows_and_squares_drag_along_their_axes() {
        for part in Arrows::parts() {
            for of_1994 in [false, true] {
                let options = Options {
                    document: some_points(),
                    fixed_speeds: of_1994,
                    ..options(Language::English)
                };
                let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
                window.state_mut().document.select(4, 0).unwrap();
                window.run();
                let projection = projection(&window);
                let before = window.state().document.path().points[4].position;
                let Some(arrows) = Arrows::of(window.state(), &projection) else {
                    assert!(of_1994);
                    continue;
                };
                assert!(!of_1994);
                if !arrows.has(part) {
                    continue;
                }
                let (from, goal) = match part {
                    Part::Along(axis) => {
                        let way = arrows.ways[axis.index()];
                        (arrows.foot + 0.92 * way, before + axis.unit() * 0.1)
                    }
                    Part::Across(axis) => {
                        let square = arrows.square(axis).into_iter().sum::<DVec2>() / 4.0;
                        let [a, b] = axis.others().map(Axis::unit);
                        (square, before + 0.1 * a - 0.05 * b)
                    }
                };
                let to = from + projection.image(goal) - projection.image(before);
                window.hover_at(to_pos(from));
                window.run();
                press_at(&mut window, from, true);
                window.event(Event::PointerMoved(to_pos(to)));
                window.run();
                press_at(&mut window, to, false);
                let now = window.state().document.path().points[4].position;
                assert!(now.abs_diff_eq(goal, 2e-3), "{part:?}: {now}, not {goal}");
                let kept = |axis: &&Axis| now[axis.index()] == before[axis.index()];
                let kept = Axis::ALL.iter().filter(kept).count();
                assert_eq!(kept, if matches!(part, Part::Along(_)) { 2 } else { 1 });
                press(&mut window, Modifiers::CTRL, Key::Z);
                assert_eq!(window.state().document.path().points[4].position, before);
            }
        }
    }
}
