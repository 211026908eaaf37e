//! The curve of the sections' speeds, made again only where it changed.

use std::sync::Arc;

use egui::{Color32, Mesh, Painter, Pos2, Shape, Stroke, pos2};
use vides_document::Selection;
use vides_engine::limits::BASE_SPEED;
use vides_raster::{Line, Lines};

use crate::state::playing::graph::{Curve, PIECES, Scale, Stretch};
use crate::theme::Palette;

/// Least step between two sections that is marked as a jump.
const JUMP: f32 = 5.0;

impl Curve {
    pub(super) fn paint(
        &mut self,
        painter: &Painter,
        (revision, stretches): (Option<u64>, &[Stretch]),
        current: Selection,
        scale: &Scale,
        palette: &Palette,
    ) {
        let made_of = Some((revision, current, *scale, palette.accent));
        if self.made_of != made_of {
            self.made_of = made_of;
            self.make(stretches, current, scale, palette);
        }
        let base = scale.y(BASE_SPEED as f32);
        painter.hline(scale.axis.rail, base, Stroke::new(1.0, palette.line));
        painter.add(Shape::Mesh(Arc::clone(&self.shade)));
        painter.add(Lines::shape(&self.lines, painter.clip_rect()));
    }

    fn make(
        &mut self,
        stretches: &[Stretch],
        current: Selection,
        scale: &Scale,
        palette: &Palette,
    ) {
        let (mut shade, mut lines) = (Mesh::default(), Lines::default());
        let mut add = |from: Pos2, to: Pos2, width, color| {
            lines.lines.push(Line {
                from,
                to,
                width,
                color,
            });
        };
        let foot = scale.rows.max;
        let plain = palette.accent.gamma_multiply(0.75);
        let mut before: Option<(&Stretch, Pos2)> = None;
        let mut rest = stretches;
        while let Some(first) = rest.first() {
            // Sections that together are narrower than a point share a column.
            let left = scale.pos(first, 0);
            let narrow = |s: &&Stretch| s.from != current && scale.x(s.end as f32) - left.x < 1.0;
            let column = rest.iter().take_while(narrow).count();
            let (these, behind) = rest.split_at(column.max(1));
            rest = behind;
            let last = &these[these.len() - 1];
            let right = scale.pos(last, PIECES);
            let line = match column {
                0 => along(first, scale),
                _ => {
                    let speeds = these.iter().flat_map(|stretch| stretch.speeds);
                    let (low, high) = speeds.fold((f32::MAX, 0.0_f32), |(low, high), speed| {
                        (low.min(speed), high.max(speed))
                    });
                    let middle = 0.5 * (left.x + right.x);
                    let ends = [high, low].map(|speed| pos2(middle, scale.y(speed)));
                    vec![left, ends[0], ends[1], right]
                }
            };
            let (width, color, part) = match first.from == current {
                true => (2.0, palette.accent, 0.22),
                false => (1.3, plain, 0.09),
            };
            for pair in line.windows(2) {
                trapezoid(&mut shade, pair, foot, palette.accent.gamma_multiply(part));
                add(pair[0], pair[1], width, color);
            }
            if let Some((before, end)) = before {
                let step = (before.speeds[PIECES] - first.speeds[0]).abs();
                if before.end < first.start {
                    // The camera rests there.
                    add(pos2(end.x, foot), pos2(left.x, foot), 1.3, plain);
                } else if step > JUMP {
                    add(end, left, 1.5, palette.error);
                }
            }
            before = Some((last, right));
        }
        self.shade = Arc::new(shade);
        self.lines = Arc::new(lines);
    }
}

/// A section's curve, of as many pieces as are to be seen.
fn along(stretch: &Stretch, scale: &Scale) -> Vec<Pos2> {
    let wide = scale.pos(stretch, PIECES).x - scale.pos(stretch, 0).x;
    let every = [3.0, 8.0, 16.0, 32.0, 64.0, f32::INFINITY]
        .into_iter()
        .zip([PIECES, PIECES / 2, PIECES / 4, PIECES / 6, PIECES / 12, 1])
        .find(|&(least, _)| wide < least)
        .map_or(1, |(_, every)| every);
    let pieces = (0..=PIECES).step_by(every);
    pieces.map(|piece| scale.pos(stretch, piece)).collect()
}

/// What lies between a straight piece and the foot of the graph.
fn trapezoid(mesh: &mut Mesh, piece: &[Pos2], foot: f32, color: Color32) {
    let first = mesh.vertices.len() as u32;
    for &end in piece {
        mesh.colored_vertex(end, color);
        mesh.colored_vertex(pos2(end.x, foot), color);
    }
    mesh.add_triangle(first, first + 1, first + 2);
    mesh.add_triangle(first + 2, first + 1, first + 3);
}

#[cfg(test)]
mod tests {
    use egui::Rangef;

    use super::*;
    use crate::playing::axis::Axis;
    use crate::setup::Theme;

    /// However many sections share a column, none of their speeds is lost, and there are
    /// no more lines than the columns need.
    #[test]
    fn sections_narrower_than_a_point_share_a_column() {
        let wide = 500.0;
        let speeds: Vec<f32> = (0..10_000_u32)
            .map(|k| 20.0 + (k.wrapping_mul(2_654_435_761) >> 24) as f32 / 4.0)
            .collect();
        let stretches: Vec<Stretch> = speeds
            .iter()
            .enumerate()
            .map(|(k, &speed)| Stretch {
                from: Selection::at(k, 0),
                start: 3 * k + 1,
                end: 3 * k + 4,
                speeds: [speed; PIECES + 1],
                scale: 1.0,
            })
            .collect();
        let (rail, rows) = (Rangef::new(0.0, wide), Rangef::new(0.0, 100.0));
        let axis = Axis::new(rail, (1.0, 30_001.0), None);
        let scale = Scale {
            axis,
            rows,
            highest: 100.0,
        };
        let mut curve = Curve::default();
        let current = Selection::at(7_000, 0);
        curve.make(&stretches, current, &scale, Theme::Dark.palette());
        let lines = &curve.lines.lines;
        assert!(lines.len() < 5 * wide as usize, "{} lines", lines.len());
        for (k, &speed) in speeds.iter().enumerate() {
            let (x, y) = (scale.x(3.0 * k as f32 + 2.5), scale.y(speed));
            let near = lines.iter().filter(|line| (line.from.x - x).abs() < 1.5);
            let reach = near.flat_map(|line| [line.from.y, line.to.y]);
            let (low, high) = reach.fold((f32::MAX, f32::MIN), |(a, b), y| (a.min(y), b.max(y)));
            assert!(
                low <= y + 1e-3 && y <= high + 1e-3,
                "section {k}: {low} {y} {high}"
            );
        }
        let own = scale.pos(&stretches[7_000], 0);
        assert!(
            lines
                .iter()
                .any(|line| line.from == own && line.width == 2.0)
        );
    }
}
